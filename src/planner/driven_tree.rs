//! A tree whose edges are controlled motions: the common part of the planners by controls.

use super::groups::{Limits, Sampling};
use super::growth::Growth;
use crate::error::Error;
use crate::graph::{Tree, VertexId};
use crate::options::{CAR, out_of_range};
use crate::problem::{Control, Dynamics, Motion, Problem};
use crate::random::Random;
use crate::space::Space;

/// The vertex that the tree grows from.
pub(super) const ROOT: VertexId = VertexId(0);

/// The longest duration of a control, in steps of integration.
pub const MOST_STEPS: f64 = 10_000.0;

/// The default longest duration: the fastest straight motion covers this fraction of the space's extent. For the cars of the
/// course reports that is their 2.5 s.
const DEFAULT_DRIVE: f64 = 0.3;

crate::choice! {
    /// The states at which the goal is tested for.
    pub enum GoalTest {
        /// After each step along an edge; the edge ends as soon as the goal is met.
        Along,
        /// At the ends of edges.
        Ends,
    }
}

crate::choice! {
    /// The treatment of a motion that cannot be proven free to its end.
    pub enum Blocked {
        /// It ends with the last step that is proven free.
        Cut,
        /// It is refused.
        Refused,
    }
}

crate::choice! {
    /// How controlled motions are integrated.
    pub enum IntegrationKind {
        /// Exact arcs, proven free.
        Exact,
        /// Explicit Euler steps.
        Euler,
    }
}

crate::options! {
    /// Options of all planners by controls.
    pub struct ByControls for CAR;
    /// Tests every step of an edge, which then ends in the goal region, or only the ends of edges.
    goal_test: GoalTest = GoalTest::Along, "Goal test";
    /// Exact arcs, proven free, or explicit Euler steps, checked one by one: neither exact nor proven, to compare.
    integration: IntegrationKind = IntegrationKind::Exact, "Integration";
    /// Where samples come from.
    sampling: Sampling;
    /// When a run ends.
    limits: Limits;
}

/// The number of steps that a control is held: drawn uniformly from `shortest` to `longest`, both at least 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Durations {
    /// The fewest steps.
    pub shortest: u32,
    /// The most steps, no fewer than `shortest`.
    pub longest: u32,
}

impl Durations {
    /// The durations that are given in steps; by default all as long as the fastest straight motion takes for a part of
    /// the extent.
    ///
    /// # Errors
    /// `out-of-range`, pointer `/shortest_steps`, if the shortest is longer than the longest.
    pub(super) fn new<S: Space>(
        problem: &Problem<S>,
        longest: Option<u32>,
        shortest: Option<u32>,
    ) -> Result<Self, Error> {
        let longest = longest.unwrap_or_else(|| {
            let reach = straight_reach(problem, dynamics(problem).step());
            ((DEFAULT_DRIVE * problem.space().extent() / reach).min(MOST_STEPS) as u32).max(1)
        });
        Self { shortest: longest, longest }.with_shortest(shortest)
    }

    /// The same with another shortest duration, if one is given.
    pub(super) fn with_shortest(self, shortest: Option<u32>) -> Result<Self, Error> {
        match shortest {
            Some(steps) if steps > self.longest => {
                let most = self.longest;
                let sentence = format!("shortest_steps must be at most the longest duration, {most}, not {steps}");
                Err(out_of_range("shortest_steps", sentence))
            }
            shortest => Ok(Self { shortest: shortest.unwrap_or(self.shortest), ..self }),
        }
    }

    /// Draws a duration; draws nothing if there is no choice.
    pub(super) fn sample(self, random: &mut Random) -> u32 {
        match u64::from(self.longest - self.shortest) {
            0 => self.longest,
            more => self.shortest + random.below(more + 1) as u32,
        }
    }
}

/// A control held for some steps, and the state at its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Drive<S> {
    pub control: Control,
    pub steps: u32,
    pub end: S,
}

/// A tree of controlled motions. Edge v - 1 leads to vertex v.
pub(super) struct DrivenTree<S: Space> {
    pub growth: Growth<S>,
    pub tree: Tree,
    /// The distance from each vertex to the goal.
    left: Vec<f64>,
}

impl<S: Space> DrivenTree<S> {
    /// The tree that consists of the start.
    pub fn new(problem: &Problem<S>) -> Self {
        let (mut growth, mut tree) = (Growth::new(problem), Tree::default());
        tree.add_root(growth.graph.add_vertex(0, *problem.start()));
        let left = vec![problem.space().distance(problem.start(), problem.goal())];
        Self { growth, tree, left }
    }

    /// The part of the motion to be added; `None` if it is refused.
    pub fn free_part(
        &mut self,
        problem: &Problem<S>,
        from: &S::State,
        drive: Drive<S::State>,
        blocked: Blocked,
    ) -> Option<Drive<S::State>> {
        let dynamics = dynamics(problem);
        self.growth.counters.motion_checks += 1;
        let steps = dynamics.free_steps(from, drive.control, drive.steps);
        match blocked {
            _ if steps == drive.steps => Some(drive),
            Blocked::Cut if steps > 0 => {
                Some(Drive { steps, end: dynamics.drive(from, drive.control, steps), ..drive })
            }
            Blocked::Cut | Blocked::Refused => None,
        }
    }

    /// Adds the vertex at the end of a motion.
    pub fn grow(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        from: VertexId,
        Drive { control, steps, end }: Drive<S::State>,
    ) -> VertexId {
        let vertex = self.growth.graph.add_vertex(iteration, end);
        self.tree.add(vertex, from);
        let motion = Motion { control, duration: f64::from(steps) * dynamics(problem).step() };
        self.growth.graph.add_driven_edge(iteration, from, vertex, motion);
        self.left.push(problem.space().distance(&end, problem.goal()));
        vertex
    }

    /// The first of the counted vertices that are nearest to the goal. O(vertices).
    pub fn closest(&self, is_counted: impl Fn(VertexId) -> bool) -> VertexId {
        let counted = (0..).map(VertexId).zip(&self.left).filter(|&(vertex, _)| is_counted(vertex));
        counted.min_by(|(_, a), (_, b)| a.total_cmp(b)).map_or(ROOT, |(vertex, _)| vertex)
    }
}

/// The dynamics of the problem.
pub(super) fn dynamics<S: Space>(problem: &Problem<S>) -> &dyn Dynamics<S::State> {
    problem.dynamics.as_deref().expect("planners by controls require a problem with dynamics")
}

/// How far the fastest straight motion of this duration leads, in the metric of the space.
pub(super) fn straight_reach<S: Space>(problem: &Problem<S>, duration: f64) -> f64 {
    let dynamics = dynamics(problem);
    let straight = |control| Motion { control: Control { steering: 0.0, ..control }, duration };
    dynamics.extremes().into_iter().map(|control| dynamics.reach(straight(control))).fold(0.0, f64::max)
}

/// The motion until it first meets the goal, and whether it does.
pub(super) fn up_to_goal<S: Space>(
    problem: &Problem<S>,
    from: &S::State,
    drive: Drive<S::State>,
    test: GoalTest,
) -> (Drive<S::State>, bool) {
    let (space, dynamics) = (problem.space(), dynamics(problem));
    if test == GoalTest::Along {
        // The distance to the goal falls by at most this per step, so steps that cannot reach it are skipped.
        let motion = Motion { control: drive.control, duration: dynamics.step() };
        let (pace, mut steps) = (dynamics.reach(motion), 0);
        let (mut state, mut left) = (*from, drive.steps);
        while left > 0 {
            let far = space.distance(&state, problem.goal()) - problem.goal_reach();
            let passed = if pace > 0.0 { far / pace } else { f64::INFINITY };
            if passed >= f64::from(left) {
                break;
            }
            let ahead = if passed > 1.0 { passed as u32 } else { 1 };
            (steps, left) = (steps + ahead, left - ahead);
            state = dynamics.drive(from, drive.control, steps);
            if problem.is_goal(&state) {
                return (Drive { steps, end: state, ..drive }, true);
            }
        }
    }
    (drive, problem.is_goal(&drive.end))
}
