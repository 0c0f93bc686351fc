//! Samplers of the configuration space: any planner works with any of them.
//!
//! Some samplers check for collisions: they return what they learned about the sample.

mod obstacles;
mod random;
mod sequences;

pub use obstacles::{BridgeTest, Gaussian, ObstacleBased};
pub use random::{GoalBiased, Uniform};
pub use sequences::{Halton, Lattice, radical_inverse};

use crate::problem::Problem;
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
pub trait Sampler<S: Space> {
    /// The next sample. `checks` grows by the configurations that were checked.
    fn draw(&mut self, problem: &Problem<S>, checks: &mut u64) -> Sample<S::State>;
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
