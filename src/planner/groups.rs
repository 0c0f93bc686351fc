//! Options that planners share, and what they make of them.

use super::growth::Growth;
use super::query::{Algorithm, Cost, Heuristic};
use crate::error::Error;
use crate::options::{CAR, Choice, out_of_range};
use crate::problem::Problem;
use crate::random::{Random, Stream};
use crate::sampling::{BridgeTest, Gaussian, GoalBiased, Halton, Lattice, ObstacleBased, Sampler, Uniform};
use crate::space::steering::Steering;
use crate::space::{MetricKind, Space};

/// The tolerance taken where none is given, as a fraction of the world's longer side.
pub const DEFAULT_TOLERANCE: f64 = 1e-4;
/// Of the space's extent, the step taken where none is given.
const DEFAULT_STEP: f64 = 0.2;
/// Of the space's extent, the smallest step: it bounds the motions of one greedy connection.
const SMALLEST_STEP: f64 = 1e-4;
/// Of the space's extent per dimension, the deviation of samplers where none is given.
const DEFAULT_SPREAD: f64 = 0.05;

crate::choice! {
    /// Where samples fall.
    pub enum SamplerKind {
        /// Anywhere.
        Uniform,
        /// Evenly, by Halton's sequence.
        Halton,
        /// Evenly, on a lattice.
        Lattice,
        /// Near obstacles.
        Gaussian,
        /// Between obstacles.
        Bridge,
        /// On obstacles.
        ObstacleBased,
        /// About the goal.
        GoalBiased,
    }
}

crate::options! {
    /// Where samples come from.
    pub struct Sampling for crate::options::ALL;
    /// Where samples fall: anywhere, evenly (halton, lattice), near obstacles, between or on them, or about the goal.
    sampler: SamplerKind = SamplerKind::Uniform, "Sampler";
    /// How widely gaussian, bridge and goal-biased samples scatter: less keeps them nearer to obstacles or the goal.
    spread: Option<f64>, in 1e-6..=1e6, "Spread", unit "rad or m",
        else "a twentieth of the largest distance in the space, divided by its dimension";
}

impl Sampling {
    /// The sampler of a run.
    pub(super) fn sampler<S: Space>(&self, space: &S, seed: u64) -> Box<dyn Sampler<S>> {
        let random = Random::new(seed, Stream::Samples);
        let spread = self.spread.unwrap_or(DEFAULT_SPREAD * space.extent() / space.dimension() as f64);
        match self.sampler {
            SamplerKind::Uniform => Box::new(Uniform(random)),
            SamplerKind::Halton => Box::new(Halton::new(random)),
            SamplerKind::Lattice => Box::new(Lattice::new(space.dimension(), random)),
            SamplerKind::Gaussian => Box::new(Gaussian { random, deviation: spread }),
            SamplerKind::Bridge => Box::new(BridgeTest { random, deviation: spread }),
            SamplerKind::ObstacleBased => Box::new(ObstacleBased(random)),
            SamplerKind::GoalBiased => Box::new(GoalBiased::new(random, spread)),
        }
    }
}

crate::options! {
    /// How a roadmap is searched.
    pub struct Searching for crate::options::ALL;
    /// How the roadmap is searched: A* heads for the goal, bidirectional starts at both ends, the others spread out.
    search: Algorithm = Algorithm::AStar, "Search";
    /// What A* and Dijkstra make least: the length of the path, or its hops; breadth-first always counts hops.
    cost: Cost = Cost::Metric, "Cost of an edge";
    /// How A* guesses the rest of the way: close guesses expand fewer vertices; metric-as-hops may miss the best.
    heuristic: Heuristic = Heuristic::Metric, "Heuristic";
}

crate::choice! {
    /// How edges are looked at.
    pub enum EdgeCheck {
        /// They are proven free all along.
        Proven,
        /// They are looked at in a few places.
        Sampled,
    }
}

crate::options! {
    /// What is done with the finished path.
    pub struct Improving for crate::options::ALL;
    /// Leaves out vertices of the finished path wherever the straight motion past them is free.
    reduce: bool = false, "Reduce vertices";
    /// How many shortcuts between random places are tried on the finished path: more make it shorter.
    shortcut: u64 = 0, in 0.0..=1e6, "Shortcuts";
    /// How many shortcuts of one joint or coordinate alone are tried after that: more take out needless turns.
    partial_shortcut: u64 = 0, in 0.0..=1e6, "Partial shortcuts";
}

impl Choice for MetricKind {}

crate::options! {
    /// In which metric joints are measured.
    pub struct Measuring for &["arm", "disc"];
    /// How joints' turns make a distance: their sum, the root of their squares, or that as if no joint went round.
    metric: Option<MetricKind>, "Metric", else "sum for arms, euclidean for discs";
}

crate::options! {
    /// When a run ends, and how closely motions are looked at.
    pub struct Limits for crate::options::ALL;
    /// How near an obstacle a motion may be refused unproven: less fits finer gaps and takes longer; none may touch.
    tolerance: f64 = DEFAULT_TOLERANCE, in 1e-9..=0.1, "Tolerance", unit "of the world's longer side";
    /// After how many iterations without a path the planner gives up: more let it find harder ones.
    max_iterations: u32 = 100_000, in 1.0..=4e9, "Iterations at most";
}

impl Choice for Steering {}

crate::options! {
    /// Options of all planners whose edges are motions of the space.
    pub struct Joined for crate::options::ALL;
    /// Proven free all along, or sampled: looked at in a few places only, so that a path may go through a thin wall.
    edge_check: EdgeCheck = EdgeCheck::Proven, "Edges are";
    /// In how many evenly spaced places a sampled edge is looked at: fewer are quicker and miss more.
    edge_samples: u32 = 20, in 1.0..=10_000.0, "Places on an edge";
    /// What is done with the finished path.
    improving: Improving;
    /// The metric.
    measuring: Measuring;
    /// Along which curves a car goes between places: the shortest forwards (dubins), or with shunts (reeds-shepp).
    steering: Option<Steering>, "Steering", else "reeds-shepp for a car with a reverse gear, else dubins", for CAR;
    /// When a run ends.
    limits: Limits;
}

crate::options! {
    /// When a tree grows towards the goal and not towards a sample.
    pub struct Reaching for crate::options::ALL;
    /// How often the tree grows towards the goal: 0 is never, 1 always; too often, and it is stuck at obstacles.
    goal_bias: f64 = 0.05, in 0.0..=1.0, "Goal bias";
    /// Grows towards the goal every so many iterations, in place of the goal bias: a small number is often.
    goal_every: Option<u32>, in 1.0..=1e6, "Goal every n-th time", else "never: the goal bias decides";
}

/// What a tree grows towards: samples, and now and then a goal, each of several in turn.
pub(super) struct Aim<S: Space> {
    pub reaching: Reaching,
    sampler: Box<dyn Sampler<S>>,
    /// Decides when a goal is due.
    random: Random,
    /// How many goals were drawn.
    goals: usize,
}

impl<S: Space> Aim<S> {
    pub fn new(reaching: Reaching, sampling: &Sampling, space: &S, seed: u64) -> Self {
        let random = Random::new(seed, Stream::Bias);
        Self { reaching, sampler: sampling.sampler(space, seed), random, goals: 0 }
    }

    /// The next target; `None`, with an event, if the sampler found none.
    pub fn next(&mut self, problem: &Problem<S>, iteration: u32, growth: &mut Growth<S>) -> Option<S::State> {
        let Reaching { goal_bias, goal_every } = self.reaching;
        let is_due = match goal_every {
            Some(n) => iteration.is_multiple_of(n),
            None => goal_bias > 0.0 && self.random.uniform() < goal_bias,
        };
        if !is_due {
            return Some(growth.draw(problem, iteration, &mut *self.sampler)?.state);
        }
        self.goals = self.goals.wrapping_add(1);
        Some(*problem.goal_in_turn(self.goals - 1))
    }
}

/// The step given, or the default for a space of this extent.
///
/// # Errors
/// `out-of-range`, pointer `/step`, below a 10,000th of the extent.
pub(super) fn step_in(step: Option<f64>, extent: f64) -> Result<f64, Error> {
    let smallest = SMALLEST_STEP * extent;
    match step {
        None => Ok(DEFAULT_STEP * extent),
        Some(step) if step >= smallest => Ok(step),
        Some(step) => Err(out_of_range(
            "step",
            format!("step must be at least {smallest}, a 10,000th of the space's extent, not {step}"),
        )),
    }
}
