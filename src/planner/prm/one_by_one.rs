//! Each sample is connected as it arrives, to its neighbours among the earlier vertices.

use super::batch::Growing;
use crate::graph::{EventKind, VertexId};
use crate::nearest::Direction;
use crate::planner::Phase;
use crate::planner::growth::{GOAL, START};
use crate::planner::roadmap::{Build, Roadmap, RoadmapPlanner};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;

/// Draws samples until the roadmap has enough vertices. An iteration tries one sample and connects it.
pub(super) struct OneByOne<S: Space> {
    vertices: usize,
    /// As many samples are added again while start and goal are not connected; `None` if their number was given.
    growing: Option<Growing>,
    /// Whether samples that connect to nothing are discarded.
    discard: bool,
    sampler: Box<dyn Sampler<S>>,
}

impl<S: Space> OneByOne<S> {
    /// A planner at its beginning: the goals come right after the start, their neighbour.
    pub fn planner(
        problem: &Problem<S>,
        mut roadmap: Roadmap<S>,
        samples: usize,
        growing: Option<Growing>,
        discard: bool,
        sampler: Box<dyn Sampler<S>>,
    ) -> RoadmapPlanner<S, Self> {
        for (i, goal) in problem.goals().iter().enumerate() {
            for direction in Direction::all(problem.space()) {
                if direction.distance(problem.space(), goal, problem.start()) <= roadmap.connection.radius() {
                    let [from, to] = direction.ends(VertexId(GOAL.0 + i as u32), START);
                    roadmap.try_edge(problem, 0, from, to);
                }
            }
        }
        let builder = Self { vertices: samples + roadmap.len(), growing, discard, sampler };
        RoadmapPlanner::new(problem, roadmap, builder, samples == 0)
    }
}

/// The neighbours that a state is to be connected to, and the direction of the motion to or from each.
pub(super) fn neighbours<S: Space>(
    roadmap: &mut Roadmap<S>,
    problem: &Problem<S>,
    state: &S::State,
) -> Vec<(Direction, VertexId)> {
    let (mut all, mut found) = (Vec::new(), Vec::new());
    for &direction in Direction::all(problem.space()) {
        roadmap.neighbours(problem.space(), direction, state, false, &mut found);
        all.extend(found.iter().map(|neighbour| (direction, neighbour.vertex)));
    }
    all
}

impl<S: Space> Build<S> for OneByOne<S> {
    fn build(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> bool {
        let Some(state) = roadmap.growth.draw_free(problem, iteration, &mut *self.sampler) else { return false };
        let mut neighbours = neighbours(roadmap, problem, &state);
        if self.discard {
            // Whether there will be a vertex is known only after its edges are.
            neighbours.retain(|&(direction, other)| {
                let other = roadmap.growth.state(other);
                let [from, to] = direction.ends(&state, &other);
                roadmap.growth.is_motion_free(problem, from, to)
            });
            if neighbours.is_empty() {
                roadmap.growth.reject(EventKind::SampleDiscarded, iteration, state);
                return false;
            }
        }
        let vertex = roadmap.add_vertex(problem.space(), iteration, state);
        for (direction, other) in neighbours {
            let [from, to] = direction.ends(vertex, other);
            if self.discard {
                roadmap.growth.graph.add_edge(iteration, from, to);
            } else {
                roadmap.try_edge(problem, iteration, from, to);
            }
        }
        roadmap.len() == self.vertices
    }

    fn grow(&mut self, roadmap: &mut Roadmap<S>, dimension: usize) -> bool {
        let more = self.growing.and_then(|growing| growing.more(roadmap, dimension));
        self.vertices = more.unwrap_or(self.vertices);
        more.is_some()
    }

    fn phase(&self, _: &Roadmap<S>) -> Phase {
        Phase::Sampling
    }
}
