//! A path with the lengths and costs of its motions. An attempt changes only a few motions, and the curves of a car are slow to
//! measure.

use crate::problem::Problem;
use crate::space::Space;
use std::iter::once;
use std::ops::Range;

/// A path whose motions are measured once.
#[derive(Debug, Clone)]
pub(super) struct Priced<S: Space> {
    states: Vec<S::State>,
    /// Those from state to state; none before [`price`](Self::price).
    motions: Motions,
}

/// What motions measure, in sequence.
#[derive(Debug, Clone, Default)]
pub(super) struct Motions {
    lengths: Vec<f64>,
    costs: Vec<f64>,
}

impl<S: Space> Priced<S> {
    /// The path, not measured yet.
    pub fn new(states: Vec<S::State>) -> Self {
        Self { states, motions: Motions::default() }
    }

    /// Measures the motions, unless they are.
    pub fn price(&mut self, problem: &Problem<S>) {
        if self.motions.lengths.len() + 1 < self.states.len() {
            let states = std::mem::take(&mut self.states);
            *self = self.changed(problem, states);
        }
    }

    /// Another path, of which motions at its beginning and its end are as here: only the others are measured.
    pub fn changed(&self, problem: &Problem<S>, states: Vec<S::State>) -> Self {
        let (here, there) = (self.states.iter(), states.iter());
        let same = here.clone().zip(there.clone()).take_while(|(a, b)| a == b).count();
        let same_at_end = here.rev().zip(there.rev()).take_while(|(a, b)| a == b).count();
        let others = states.len().min(self.states.len()) - same;
        let [front, back] = [same, same_at_end.min(others)].map(|count| count.saturating_sub(1));
        let mut motions = Motions::default();
        motions.extend(&self.motions, 0..front);
        for pair in states[front..states.len() - back].windows(2) {
            let length = problem.space().distance(&pair[0], &pair[1]);
            motions.lengths.push(length);
            motions.costs.push(length + problem.validity().nearness_cost(&pair[0], &pair[1]));
        }
        let count = self.motions.lengths.len();
        motions.extend(&self.motions, count - back..count);
        Self { states, motions }
    }

    pub fn states(&self) -> &[S::State] {
        &self.states
    }

    pub fn motions(&self) -> &Motions {
        &self.motions
    }
}

impl Motions {
    fn extend(&mut self, other: &Self, range: Range<usize>) {
        self.lengths.extend_from_slice(&other.lengths[range.clone()]);
        self.costs.extend_from_slice(&other.costs[range]);
    }

    /// The length of each motion.
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// The length of all.
    pub fn length(&self) -> f64 {
        // The sum of nothing is -0.
        self.lengths.iter().sum::<f64>() + 0.0
    }

    /// The cost of all.
    pub fn cost(&self) -> f64 {
        self.costs.iter().sum::<f64>() + 0.0
    }

    /// The cost of some, between a first and a last one that cost so much.
    pub fn cost_between(&self, [first, last]: [f64; 2], range: Range<usize>) -> f64 {
        once(first).chain(self.costs[range].iter().copied()).chain(once(last)).sum()
    }

    /// The cost of all with one motion in place of some, which costs so much.
    pub fn cost_with(&self, motion: f64, Range { start, end }: Range<usize>) -> f64 {
        let [before, after] = [&self.costs[..start], &self.costs[end..]].map(|costs| costs.iter().copied());
        before.chain(once(motion)).chain(after).sum()
    }

    /// The motion at the given distance along the path, and the share of it up to there.
    pub fn at(&self, along: f64) -> Option<(usize, f64)> {
        let mut left = along;
        for (motion, &length) in self.lengths.iter().enumerate() {
            if left <= length && length > 0.0 {
                return Some((motion, left / length));
            }
            left -= length;
        }
        None
    }
}
