//! Random samples: uniform ones, and some about the goal.

use super::{Known, Sample, Sampler, near};
use crate::problem::Problem;
use crate::random::Random;
use crate::space::Space;

/// The uniform distribution over the space.
#[derive(Debug, Clone)]
pub struct Uniform(pub Random);

impl<S: Space> Sampler<S> for Uniform {
    fn draw(&mut self, problem: &Problem<S>, _: &mut u64) -> Sample<S::State> {
        Sample { state: problem.space().sample(&mut self.0), known: Known::Nothing }
    }
}

/// One in this many samples is drawn near the goal.
const ONE_IN: u64 = 5;

/// Uniform samples, but every fifth on average normally distributed about the goal, or about each of the goals in turn (LaValle
/// 2006, "Planning Algorithms", section 5.5.1, on biasing).
#[derive(Debug, Clone)]
pub struct GoalBiased {
    random: Random,
    deviation: f64,
    /// How many were drawn near a goal.
    count: usize,
}

impl GoalBiased {
    /// Near the goal every coordinate has the standard deviation `deviation` (radians or metres).
    pub fn new(random: Random, deviation: f64) -> Self {
        Self { random, deviation, count: 0 }
    }
}

impl<S: Space> Sampler<S> for GoalBiased {
    fn draw(&mut self, problem: &Problem<S>, _: &mut u64) -> Sample<S::State> {
        let space = problem.space();
        let nearby = if self.random.below(ONE_IN) == 0 {
            let goal = problem.goal_in_turn(self.count);
            self.count = self.count.wrapping_add(1);
            near(space, goal, self.deviation, &mut self.random)
        } else {
            None
        };
        let state = nearby.unwrap_or_else(|| space.sample(&mut self.random));
        Sample { state, known: Known::Nothing }
    }
}
