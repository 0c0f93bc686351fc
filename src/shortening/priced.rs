//! A path with the lengths and costs of its motions: an attempt changes a few of them, and those of a car, which are curves,
//! take long to measure.

use crate::problem::Problem;
use crate::space::Space;
use std::iter::once;
use std::ops::Range;

/// A path whose motions are measured once.
#[derive(Debug, Clone)]
pub(super) struct Priced<S: Space> {
    states: Vec<S::State>,
    /// Of each motion from state to state; empty before [`price`](Self::price).
    lengths: Vec<f64>,
    costs: Vec<f64>,
}

impl<S: Space> Priced<S> {
    /// The path, not measured yet.
    pub fn new(states: Vec<S::State>) -> Self {
        Self { states, lengths: Vec::new(), costs: Vec::new() }
    }

    /// Measures the motions, unless they are.
    pub fn price(&mut self, problem: &Problem<S>) {
        if self.lengths.len() + 1 < self.states.len() {
            let states = std::mem::take(&mut self.states);
            *self = self.changed(problem, states);
        }
    }

    /// Another path, of which motions at its beginning and its end are as here: only the others are measured.
    pub fn changed(&self, problem: &Problem<S>, states: Vec<S::State>) -> Self {
        let all = states.len().min(self.states.len());
        let same = |pair: (&S::State, &S::State)| pair.0 == pair.1;
        let before = self.states.iter().zip(&states).take_while(|&pair| same(pair)).count();
        let after = self.states.iter().rev().zip(states.iter().rev()).take_while(|&pair| same(pair)).count();
        let [front, back] = [before, after.min(all - before)].map(|count| count.saturating_sub(1));
        let new = || states[front..states.len() - back].windows(2);
        let length = |pair: &[S::State]| problem.space().distance(&pair[0], &pair[1]);
        let added = |pair: &[S::State]| problem.validity().nearness_cost(&pair[0], &pair[1]);
        let lengths: Vec<f64> = new().map(length).collect();
        let costs: Vec<f64> = lengths.iter().zip(new()).map(|(length, pair)| length + added(pair)).collect();
        let joined = |old: &[f64], new: &[f64]| [&old[..front], new, &old[old.len() - back..]].concat();
        let (lengths, costs) = (joined(&self.lengths, &lengths), joined(&self.costs, &costs));
        Self { states, lengths, costs }
    }

    pub fn states(&self) -> &[S::State] {
        &self.states
    }

    /// The length of each motion.
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// The length of the path.
    pub fn length(&self) -> f64 {
        self.lengths.iter().sum::<f64>() + 0.0
    }

    /// The cost of the path.
    pub fn cost(&self) -> f64 {
        self.costs.iter().sum::<f64>() + 0.0
    }

    /// The cost of some of its motions, between a first and a last one that cost so much.
    pub fn cost_between(&self, [first, last]: [f64; 2], motions: Range<usize>) -> f64 {
        once(first).chain(self.costs[motions].iter().copied()).chain(once(last)).sum()
    }

    /// The cost of the path with one motion in place of some, which costs so much.
    pub fn cost_with(&self, motion: f64, Range { start, end }: Range<usize>) -> f64 {
        let [before, after] = [&self.costs[..start], &self.costs[end..]].map(|costs| costs.iter().copied());
        before.chain(once(motion)).chain(after).sum()
    }
}
