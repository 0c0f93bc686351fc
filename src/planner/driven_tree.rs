//! A tree whose edges are driven: what the planners by controls have in common.

use super::Counters;
use crate::control::{Control, Dynamics, Motion};
use crate::graph::{Event, EventKind, Graph, VertexId};
use crate::problem::Problem;
use crate::random::Random;
use crate::space::Space;

/// The vertex that the tree grows from.
pub(super) const ROOT: VertexId = VertexId(0);

/// Where the goal is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GoalTest {
    /// At the ends of edges.
    Ends,
    /// After each step along an edge; the edge ends where the goal is met.
    Along,
}

/// What becomes of a motion that cannot be proven free to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Blocked {
    /// It ends with the last step that is proven free.
    Cut,
    /// It is refused.
    Refused,
}

/// For how many steps a control is held: drawn uniformly from `shortest` to `longest`, both at least 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Durations {
    /// At least so many steps.
    pub shortest: u32,
    /// At most so many steps, no fewer than `shortest`.
    pub longest: u32,
}

impl Durations {
    /// Draws a duration; nothing is drawn where there is no choice.
    pub(super) fn sample(self, random: &mut Random) -> u32 {
        match u64::from(self.longest - self.shortest) {
            0 => self.longest,
            more => self.shortest + random.below(more + 1) as u32,
        }
    }
}

/// A control held for some steps, and where that leads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Drive<S> {
    pub control: Control,
    pub steps: u32,
    pub end: S,
}

/// A tree of driven edges. Vertex v > 0 hangs on edge v - 1.
pub(super) struct DrivenTree<S: Space> {
    pub graph: Graph<S>,
    pub counters: Counters,
    /// How far each vertex is from the goal.
    left: Vec<f64>,
}

impl<S: Space> DrivenTree<S> {
    /// The tree of the start alone.
    pub fn new(problem: &Problem<S>) -> Self {
        let mut graph = Graph::default();
        graph.add_vertex(0, *problem.start());
        let left = vec![problem.space().distance(problem.start(), problem.goal())];
        Self { graph, counters: Counters::default(), left }
    }

    /// The vertex that this one hangs on; `None` of the root.
    pub fn parent(&self, vertex: VertexId) -> Option<VertexId> {
        vertex.index().checked_sub(1).map(|edge| self.graph.edges()[edge][0])
    }

    /// The vertices from the root to this one.
    pub fn way(&self, to: VertexId) -> Vec<VertexId> {
        let mut way: Vec<_> = std::iter::successors(Some(to), |&vertex| self.parent(vertex)).collect();
        way.reverse();
        way
    }

    /// The drive as far as it is to be kept; `None` where it is refused.
    pub fn prove(
        &mut self,
        problem: &Problem<S>,
        from: &S::State,
        drive: Drive<S::State>,
        blocked: Blocked,
    ) -> Option<Drive<S::State>> {
        let dynamics = dynamics(problem);
        self.counters.motion_checks += 1;
        let steps = dynamics.free_steps(from, drive.control, drive.steps);
        match blocked {
            _ if steps == drive.steps => Some(drive),
            Blocked::Cut if steps > 0 => {
                Some(Drive { steps, end: dynamics.drive(from, drive.control, steps), ..drive })
            }
            Blocked::Cut | Blocked::Refused => None,
        }
    }

    /// Adds the vertex at the end of a drive.
    pub fn grow(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        from: VertexId,
        Drive { control, steps, end }: Drive<S::State>,
    ) -> VertexId {
        let vertex = self.graph.add_vertex(iteration, end);
        let motion = Motion { control, duration: f64::from(steps) * dynamics(problem).step() };
        self.graph.add_driven_edge(iteration, from, vertex, motion);
        self.left.push(problem.space().distance(&end, problem.goal()));
        vertex
    }

    /// Tells of what an iteration led to.
    pub fn tell(&mut self, kind: EventKind, iteration: u32, vertex: Option<VertexId>, state: S::State) {
        self.graph.add_event(Event { kind, iteration, vertex, other: None, state });
    }

    /// Of the vertices that are counted, the one nearest to the goal, the first of them. O(vertices).
    pub fn closest(&self, is_counted: impl Fn(VertexId) -> bool) -> VertexId {
        let mut closest = (ROOT, f64::INFINITY);
        for (i, &left) in self.left.iter().enumerate() {
            if left < closest.1 && is_counted(VertexId(i as u32)) {
                closest = (VertexId(i as u32), left);
            }
        }
        closest.0
    }
}

/// How the problem's system is driven.
pub(super) fn dynamics<S: Space>(problem: &Problem<S>) -> &dyn Dynamics<S::State> {
    problem.dynamics().expect("what is planned by controls is driven")
}

/// The drive up to where it first meets the goal, and whether it does.
pub(super) fn up_to_goal<S: Space>(
    problem: &Problem<S>,
    from: &S::State,
    drive: Drive<S::State>,
    test: GoalTest,
) -> (Drive<S::State>, bool) {
    let (space, dynamics) = (problem.space(), dynamics(problem));
    if test == GoalTest::Along {
        // The distance to the goal falls by no more than this a step, so steps that cannot reach it are passed over.
        let motion = Motion { control: drive.control, duration: dynamics.step() };
        let (pace, mut steps) = (dynamics.length(motion), 0);
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
