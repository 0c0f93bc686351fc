//! First all samples, then all edges.

use super::connect::Connect;
use crate::graph::VertexId;
use crate::planner::Phase;
use crate::planner::roadmap::{Build, Roadmap, RoadmapPlanner};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;

/// Draws samples until the roadmap has enough vertices, then connects one vertex after another to its neighbours. An iteration
/// tries one sample or connects one vertex.
pub(super) struct Batch<S: Space> {
    /// The number of vertices to have before any is connected, and what draws them; `None` for a roadmap that has them.
    samples: Option<(usize, Box<dyn Sampler<S>>)>,
    /// The vertices to connect.
    left: Box<dyn ExactSizeIterator<Item = VertexId>>,
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
        let left = Box::new((0..vertices as u32).map(VertexId));
        let builder = Self { samples: Some((vertices, sampler)), left, connect: Connect::default() };
        RoadmapPlanner::new(problem, roadmap, builder, false)
    }

    /// A planner whose roadmap has its samples: only these vertices are left to connect.
    pub fn resumed(problem: &Problem<S>, roadmap: Roadmap<S>, left: Vec<VertexId>) -> RoadmapPlanner<S, Self> {
        let is_complete = left.is_empty();
        let builder = Self { samples: None, left: Box::new(left.into_iter()), connect: Connect::default() };
        RoadmapPlanner::new(problem, roadmap, builder, is_complete)
    }
}

impl<S: Space> Build<S> for Batch<S> {
    fn build(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> bool {
        if let Some((vertices, sampler)) = &mut self.samples
            && roadmap.len() < *vertices
        {
            if let Some(state) = roadmap.growth.draw_free(problem, iteration, &mut **sampler) {
                roadmap.add_vertex(problem.space(), iteration, state);
            }
            return false;
        }
        if let Some(vertex) = self.left.next() {
            self.connect.join(roadmap, problem, iteration, vertex);
        }
        self.left.len() == 0
    }

    fn phase(&self, roadmap: &Roadmap<S>) -> Phase {
        let is_sampling = self.samples.as_ref().is_some_and(|(vertices, _)| roadmap.len() < *vertices);
        if is_sampling { Phase::Sampling } else { Phase::Connecting }
    }
}
