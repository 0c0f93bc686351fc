//! First all samples, then all edges.

use super::connect::Connect;
use crate::graph::VertexId;
use crate::planner::Phase;
use crate::planner::roadmap::{Build, Roadmap, RoadmapPlanner, START};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;

/// Draws samples until the roadmap has enough vertices, then connects one vertex after another to its neighbours. An
/// iteration tries one sample or connects one vertex.
pub(super) struct Batch<S: Space> {
    /// How many vertices the roadmap gets, start and goals included.
    vertices: usize,
    sampler: Box<dyn Sampler<S>>,
    /// The next vertex to connect, once all samples are drawn.
    next: VertexId,
    connect: Connect,
}

impl<S: Space> Batch<S> {
    /// A planner at its beginning.
    pub fn planner(
        problem: &Problem<S>,
        roadmap: Roadmap<S>,
        samples: usize,
        sampler: Box<dyn Sampler<S>>,
    ) -> RoadmapPlanner<S, Self> {
        let vertices = samples + roadmap.len();
        let builder = Self { vertices, sampler, next: START, connect: Connect::default() };
        RoadmapPlanner::new(problem, roadmap, builder, false)
    }
}

impl<S: Space> Build<S> for Batch<S> {
    fn build(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> bool {
        if roadmap.len() < self.vertices {
            if let Some(state) = roadmap.growth.draw_free(problem, iteration, &mut *self.sampler) {
                roadmap.add_vertex(problem.space(), iteration, state);
            }
            return false;
        }
        self.connect.join(roadmap, problem, iteration, self.next);
        self.next = VertexId(self.next.0 + 1);
        self.next.index() == self.vertices
    }

    fn phase(&self, roadmap: &Roadmap<S>) -> Phase {
        if roadmap.len() < self.vertices { Phase::Sampling } else { Phase::Connecting }
    }
}
