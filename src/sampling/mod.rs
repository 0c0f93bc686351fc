//! Samplers of the configuration space: any planner works with any of them.
//!
//! Some samplers check for collisions: they also return what they learned about the sample.

mod obstacles;
mod sequences;

pub use obstacles::{BridgeTest, Gaussian, ObstacleBased};
pub use sequences::{Sequence, halton, lattice, radical_inverse};

use crate::problem::{MaybeSend, Problem};
use crate::random::Random;
use crate::space::{MAX_DIMENSION, Space};

/// What is known about a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Known {
    /// Nothing yet.
    Nothing,
    /// It is free.
    Free,
    /// Not to be used: in collision, or rejected by the sampler's own rule.
    Useless,
}

/// A sample of the space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample<S> {
    /// The state.
    pub state: S,
    /// What the sampler learned about it.
    pub known: Known,
}

/// A source of samples. It owns its generator; each draw does a bounded number of checks.
pub trait Sampler<S: Space>: MaybeSend {
    /// The next sample. `checks` grows by the configurations that were checked.
    fn draw(&mut self, problem: &Problem<S>, checks: &mut u64) -> Sample<S::State>;

    /// Whether draws check nothing, so that samples can be drawn long before they are used. The default is false.
    fn is_blind(&self) -> bool {
        false
    }
}

/// Whether the state is free, counted.
fn is_free<S: Space>(problem: &Problem<S>, state: &S::State, checks: &mut u64) -> bool {
    *checks += 1;
    problem.validity().is_free(state)
}

/// A state normally distributed about another, every coordinate by `deviation` (in its own unit); `None` if it falls out
/// of the limits of the space.
fn near<S: Space>(space: &S, state: &S::State, deviation: f64, random: &mut Random) -> Option<S::State> {
    let mut coordinates = [0.0; MAX_DIMENSION];
    let coordinates = &mut coordinates[..space.dimension()];
    for (moved, &at) in coordinates.iter_mut().zip(space.coordinates(state)) {
        *moved = at + deviation * random.normal();
    }
    let moved = space.state(coordinates);
    space.contains(&moved).then_some(moved)
}

/// The uniform distribution over the space.
#[derive(Debug, Clone)]
pub struct Uniform(pub Random);

impl<S: Space> Sampler<S> for Uniform {
    fn draw(&mut self, problem: &Problem<S>, _: &mut u64) -> Sample<S::State> {
        Sample { state: problem.space().sample(&mut self.0), known: Known::Nothing }
    }

    fn is_blind(&self) -> bool {
        true
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

    fn is_blind(&self) -> bool {
        true
    }
}
