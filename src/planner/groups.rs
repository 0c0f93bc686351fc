//! Groups of options that planners share.

use super::growth::Growth;
use crate::error::Error;
use crate::options::{CAR, Choice, out_of_range};
use crate::problem::{Problem, Status};
use crate::random::{Random, Stream};
use crate::sampling::{BridgeTest, Gaussian, GoalBiased, ObstacleBased, Sampler, Uniform, halton, lattice};
use crate::space::steering::Steering;
use crate::space::{MetricKind, Space};
use serde::{Deserialize, Serialize};

/// The default tolerance, as a fraction of the world's longer side.
pub const DEFAULT_TOLERANCE: f64 = 1e-4;
/// The default step, as a fraction of the space's extent.
const DEFAULT_STEP: f64 = 0.2;
/// The smallest step, as a fraction of the space's extent: it bounds the motions of one greedy connection.
const SMALLEST_STEP: f64 = 1e-4;
/// The default deviation of samplers, as a fraction of the space's extent per dimension.
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
        /// Around the goal.
        GoalBiased,
    }
}

crate::options! {
    /// Where samples come from.
    pub struct Sampling for crate::options::ALL;
    /// Where samples fall: anywhere, evenly (halton, lattice), near, between or on obstacles, or around the goal.
    sampler: SamplerKind = SamplerKind::Uniform, "Sampler";
    /// Standard deviation of gaussian, bridge and goal-biased samples: less keeps them nearer to obstacles or goal.
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
            SamplerKind::Halton => Box::new(halton(random)),
            SamplerKind::Lattice => Box::new(lattice(space.dimension(), random)),
            SamplerKind::Gaussian => Box::new(Gaussian { random, deviation: spread }),
            SamplerKind::Bridge => Box::new(BridgeTest { random, deviation: spread }),
            SamplerKind::ObstacleBased => Box::new(ObstacleBased(random)),
            SamplerKind::GoalBiased => Box::new(GoalBiased::new(random, spread)),
        }
    }
}

crate::choice! {
    /// How edges are checked.
    #[derive(Default, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum EdgeCheck {
        /// They are proven free along all of their length.
        #[default]
        Proven,
        /// They are checked at a few points.
        Sampled,
        /// Only the configuration at their far end is checked, as in a course report: a path may cross anything.
        None,
        /// An arm's joints are checked along the straight lines between their places at both ends, as in a course report.
        JointLines,
    }
}

crate::options! {
    /// How the final path is improved.
    pub struct Improving for crate::options::ALL;
    /// Removes vertices of the final path if the straight motion past them is free.
    reduce: bool = false, "Reduce vertices";
    /// Number of shortcuts tried between random points of the final path: more make it shorter.
    shortcut: u64 = 0, in 0.0..=1e6, "Shortcuts";
    /// Number of shortcuts in a single joint or coordinate tried after that: more remove needless turns.
    partial_shortcut: u64 = 0, in 0.0..=1e6, "Partial shortcuts";
    /// Rounds corners of the path by parabolas that are proven free: how far from a corner they begin; 0 for none.
    blend: f64 = 0.0, in 0.0..=0.5, "Rounded corners", unit "of the shorter edge", for crate::options::STRAIGHT;
}

impl Choice for MetricKind {}

crate::options! {
    /// The metric of joint differences.
    pub struct MetricOptions for &["arm", "disc"];
    /// How joint differences combine: L1 (sum), L2 (euclidean), or L2 without wrap-around (naive).
    metric: Option<MetricKind>, "Metric", else "sum for arms, euclidean for discs";
}

crate::options! {
    /// What nearness to obstacles costs: each metre at clearance c costs an extra weight * max(0, 1 - c / within). The clearance
    /// is that of [`Clearance`](crate::run::inspect::Clearance).
    pub struct KeepingAway for &["disc"];
    /// Extra cost per metre at contact: larger values keep paths farther from obstacles, 0 minimises length alone.
    clearance_weight: f64 = 0.0, in 0.0..=1e6, "Keep away", unit "m per m";
    /// Clearance above which nothing is added to the length.
    clearance_within: Option<f64>, in 1e-6..=1e7, "Keep away within", unit "m",
        else "a twentieth of the world's longer side";
}

crate::options! {
    /// When a run ends, and how closely motions are checked.
    pub struct Limits for crate::options::ALL;
    /// Clearance below which a free motion may be rejected: less fits narrower gaps but takes longer.
    tolerance: f64 = DEFAULT_TOLERANCE, in 1e-9..=0.1, "Tolerance", unit "of the world's longer side";
    /// Number of iterations without a path after which the planner gives up: more solve harder problems.
    max_iterations: Option<u32>, in 1.0..=4e9, "Most iterations", else "any number: max_work is the limit";
    /// Work without a path after which the planner gives up: a weighted sum of its counts, about a microsecond each.
    max_work: Option<u64>, in 1.0..=1e15, "Most work", else "5,000,000; any amount if max_iterations is given";
    /// Moves a start or goal in collision to the nearest free configuration found, at most this far.
    free_ends: Option<f64>, in 0.0..=1e7, "Free ends within", unit "distance in the metric", else "they are refused";
}

impl Limits {
    /// The work without a path after which a planner gives up, if no limit is given: about five seconds.
    const DEFAULT_WORK: u64 = 5_000_000;

    /// Whether none is given.
    pub fn are_default(&self) -> bool {
        self.max_iterations.is_none() && self.max_work.is_none()
    }

    /// The work without a path after which the planner gives up; `u64::MAX` if iterations are limited instead.
    pub fn work(&self) -> u64 {
        self.max_work.unwrap_or(if self.max_iterations.is_some() { u64::MAX } else { Self::DEFAULT_WORK })
    }
}

impl Choice for Steering {}

crate::options! {
    /// Options of all planners whose edges are motions of the space.
    pub struct EdgeOptions for crate::options::ALL;
    /// Proven along the whole edge; sampled: at points; none: vertices only; joint-lines: joints of an arm, straight.
    edge_check: EdgeCheck = EdgeCheck::Proven, "Collision checking";
    /// Number of evenly spaced checks on a sampled edge: fewer are faster and miss more.
    edge_samples: u32 = 20, in 1.0..=10_000.0, "Checks per edge";
    /// Tries the straight motion from start to goal first; false shows growth even where the goal is in sight.
    direct: bool = true, "Direct motion first";
    /// How the final path is improved.
    improving: Improving;
    /// The metric.
    measuring: MetricOptions;
    /// What the nearness of obstacles costs.
    keeping_away: KeepingAway;
    /// Curves between placements of a car: the shortest forward (dubins), or with reversals (reeds-shepp).
    steering: Option<Steering>, "Steering", else "reeds-shepp for a car with a reverse gear, else dubins", for CAR;
    /// When a run ends.
    limits: Limits;
}

impl EdgeOptions {
    /// The number of checks per edge, if edges are sampled.
    pub fn samples(&self) -> Option<u32> {
        (self.edge_check == EdgeCheck::Sampled).then_some(self.edge_samples)
    }
}

crate::options! {
    /// When a tree grows towards the goal and not towards a sample.
    pub struct GoalBias for crate::options::ALL;
    /// Probability of growing towards the goal instead of a sample: high values get stuck at obstacles.
    goal_bias: f64 = 0.05, in 0.0..=1.0, "Goal bias";
    /// Grows towards the goal every n-th iteration, replacing the goal bias; a smaller n means more often.
    goal_every: Option<u32>, in 1.0..=1e6, "Goal every n-th", else "never: the goal bias decides";
}

crate::options! {
    /// Growth past the goal.
    pub struct Overgrowth for crate::options::ALL;
    /// Grows on past the goal until the tree has this number of vertices; its first path stays.
    vertices: Option<u32>, in 1.0..=1e6, "Vertices", else "none: it ends at the goal";
}

impl Overgrowth {
    /// The status of a tree of this number of vertices, after an iteration.
    pub(super) fn status(self, has_path: bool, vertices: usize) -> Status {
        let is_grown = self.vertices.is_none_or(|most| vertices >= most as usize);
        match (is_grown, has_path) {
            (true, true) => Status::Solved,
            (true, false) if self.vertices.is_some() => Status::Exhausted,
            _ => Status::Running,
        }
    }
}

crate::choice! {
    /// How many of the conditions given end the improvement of a path.
    pub enum StopWhen {
        /// One.
        Any,
        /// Every one.
        All,
    }
}

crate::options! {
    /// When a planner that goes on to shorter paths stops. It stops in any case at a path of the length of the straight motion.
    pub struct Termination for crate::options::ALL;
    /// Number of further iterations once there is a path, to find shorter ones.
    improve_iterations: u32 = 5000, in 0.0..=1e9, "Improve for";
    /// Number of clearance evaluations after which to stop, with or without a path.
    stop_evaluations: Option<u64>, in 1.0..=1e15, "Evaluations", else "any number";
    /// Length, or with clearance_weight cost, at or below which the path is good enough, as results report it.
    stop_cost: Option<f64>, in 0.0..=1e9, "Length at most", unit "length of the path", else "none is";
    /// Number of iterations without a shorter path after which to stop.
    stop_stale: Option<u32>, in 1.0..=1e9, "No shorter for", else "any number";
    /// Stops when the last half of the iterations since the first path, 500 or more, gained no more than this.
    stop_converged: Option<f64>, in 0.0..=1.0, "Converged to", unit "of the length", else "never";
    /// Whether one of the conditions given is enough, or all must hold: iterations, evaluations, length and the rest.
    stop_when: StopWhen = StopWhen::Any, "Stop when";
}

/// Selects targets: samples, occasionally a goal; several goals take turns.
pub(super) struct Aim<S: Space> {
    pub reaching: GoalBias,
    sampler: Box<dyn Sampler<S>>,
    /// Whether a sample in collision is no target.
    is_free: bool,
    /// Draws whether the next target is a goal.
    random: Random,
    /// How many goals were drawn.
    goals: usize,
}

impl<S: Space> Aim<S> {
    pub fn new(reaching: GoalBias, sampling: &Sampling, space: &S, seed: u64) -> Self {
        let random = Random::new(seed, Stream::Bias);
        Self { reaching, sampler: sampling.sampler(space, seed), is_free: false, random, goals: 0 }
    }

    /// The same, whose targets are free.
    pub fn with_free(self, is_free: bool) -> Self {
        Self { is_free, ..self }
    }

    /// The next target; `None`, with an event, if the sampler found none.
    pub fn next(&mut self, problem: &Problem<S>, iteration: u32, growth: &mut Growth<S>) -> Option<S::State> {
        let GoalBias { goal_bias, goal_every } = self.reaching;
        let is_due = match goal_every {
            Some(n) => iteration.is_multiple_of(n),
            None => goal_bias > 0.0 && self.random.uniform() < goal_bias,
        };
        if !is_due {
            let sampler = &mut *self.sampler;
            return if self.is_free {
                growth.draw_free(problem, iteration, sampler)
            } else {
                Some(growth.draw(problem, iteration, sampler)?.state)
            };
        }
        let goal = *problem.goal_in_turn(self.goals);
        self.goals = self.goals.wrapping_add(1);
        growth.counters.goal_samples += 1;
        Some(goal)
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
