//! First all samples, then all edges, each pair of vertices once.

use super::MOST_MOTIONS;
#[cfg(feature = "parallel")]
use super::ahead::Ahead;
use super::connect::Connect;
use crate::graph::VertexId;
use crate::graph::search::{Edge, EdgeState};
use crate::nearest::Neighbourhood;
use crate::planner::lazy::LazyPlanner;
use crate::planner::query::Searching;
use crate::planner::roadmap::{Build, Roadmap, RoadmapPlanner};
use crate::planner::{Phase, Planner};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;

/// Draws samples until the roadmap has enough vertices, then connects one vertex after another to its neighbours. An iteration
/// tries one sample or connects one vertex. `ahead.rs` does the same on several threads.
pub(super) struct Batch<S: Space> {
    /// The number of vertices to have before any is connected, and the sampler; `None` for a roadmap that has them.
    samples: Option<(usize, Box<dyn Sampler<S>>)>,
    /// As many samples are added again while start and goal are not connected; `None` if their number was given.
    growing: Option<Growing>,
    /// The vertices to connect.
    left: Box<dyn ExactSizeIterator<Item = VertexId> + Send>,
    connect: Connect,
    #[cfg(feature = "parallel")]
    ahead: Ahead<S>,
}

impl<S: Space> Batch<S> {
    /// A planner at its beginning.
    pub fn planner(
        problem: &Problem<S>,
        roadmap: Roadmap<S>,
        samples: usize,
        growing: Option<Growing>,
        sampler: Box<dyn Sampler<S>>,
    ) -> RoadmapPlanner<S, Self> {
        let builder = Self::new(&roadmap, samples, growing, sampler);
        RoadmapPlanner::new(problem, roadmap, builder, false)
    }

    /// A builder that adds this number of samples to a roadmap of start and goals.
    pub fn new(roadmap: &Roadmap<S>, samples: usize, growing: Option<Growing>, sampler: Box<dyn Sampler<S>>) -> Self {
        let vertices = samples + roadmap.len();
        let left = (0..vertices as u32).map(VertexId);
        Self { growing, ..Self::with(Some((vertices, sampler)), Box::new(left)) }
    }

    /// A builder that adds no samples and connects these vertices.
    fn connecting(vertices: Vec<VertexId>) -> Self {
        Self::with(None, Box::new(vertices.into_iter()))
    }

    fn with(
        samples: Option<(usize, Box<dyn Sampler<S>>)>,
        left: Box<dyn ExactSizeIterator<Item = VertexId> + Send>,
    ) -> Self {
        Self {
            samples,
            growing: None,
            left,
            connect: Connect::default(),
            #[cfg(feature = "parallel")]
            ahead: Ahead::default(),
        }
    }
}

impl<S: Space> Build<S> for Batch<S> {
    fn build(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> bool {
        if let Some((vertices, sampler)) = &mut self.samples
            && roadmap.len() < *vertices
        {
            #[cfg(feature = "parallel")]
            if self.ahead.sample(roadmap, problem, iteration, &mut **sampler, *vertices - roadmap.len()) {
                return false;
            }
            if let Some(state) = roadmap.growth.draw_free(problem, iteration, &mut **sampler) {
                roadmap.add_vertex(problem.space(), iteration, state);
            }
            return false;
        }
        #[cfg(feature = "parallel")]
        if roadmap.candidates.is_none()
            && self.ahead.connect(roadmap, problem, iteration, &mut *self.left, &mut self.connect)
        {
            return self.left.len() == 0 && self.ahead.is_empty();
        }
        if let Some(vertex) = self.left.next() {
            self.connect.connect(roadmap, problem, iteration, vertex);
        }
        self.left.len() == 0
    }

    /// The new vertices are connected to their nearest among all, the old ones only to the new that want it.
    fn grow(&mut self, roadmap: &mut Roadmap<S>, dimension: usize) -> bool {
        let (Some(growing), Some((vertices, _))) = (self.growing, &mut self.samples) else { return false };
        let Some(more) = growing.more(roadmap, dimension) else { return false };
        self.connect.first = VertexId(roadmap.len() as u32);
        self.left = Box::new((roadmap.len() as u32..more as u32).map(VertexId));
        *vertices = more;
        true
    }

    fn phase(&self, roadmap: &Roadmap<S>) -> Phase {
        let is_sampling = self.samples.as_ref().is_some_and(|(vertices, _)| roadmap.len() < *vertices);
        if is_sampling { Phase::Sampling } else { Phase::Connecting }
    }
}

/// How a roadmap grows while its number of samples is not given: the number of neighbours for a number of vertices and of
/// dimensions, or `None` if it stays.
#[derive(Debug, Clone, Copy)]
pub(super) struct Growing(pub Option<fn(usize, usize) -> usize>);

impl Growing {
    /// The vertices of the roadmap that comes after this one, which is given the number of neighbours for it: twice as many.
    /// `None` if it would try too many motions.
    pub fn more<S: Space>(self, roadmap: &mut Roadmap<S>, dimension: usize) -> Option<usize> {
        let vertices = 2 * roadmap.len();
        let k = self.0.map_or(roadmap.connection.k(), |k| k(vertices, dimension));
        if vertices as u64 * k as u64 > MOST_MOTIONS {
            return None;
        }
        roadmap.connection = roadmap.connection.with_k(k);
        Some(vertices)
    }
}

/// A planner whose roadmap exists and is proven: it draws no samples, connects start and goals to their neighbours and searches.
/// A vertex of the roadmap that is the start or a goal becomes that end and keeps its edges; all others come after these ends, in
/// their order. If the roadmap `is_lazy`, all vertices have candidate edges to their neighbours. O(states + edges), and the index
/// of neighbours.
///
/// # Panics
/// If an edge names a vertex that does not exist.
pub fn resume<S: Space + 'static>(
    problem: &Problem<S>,
    connection: Neighbourhood,
    rules: Searching,
    states: &[S::State],
    edges: &[[u32; 2]],
    is_lazy: bool,
) -> Box<dyn Planner<S>> {
    let mut roadmap = Roadmap::new(problem, connection, rules);
    if is_lazy {
        roadmap = roadmap.lazily(problem.space());
    }
    let (vertices, left) = add_vertices(&mut roadmap, problem.space(), states.iter().map(Some));
    for edge in edges {
        let ends @ [from, to] = edge.map(|vertex| vertices[vertex as usize].expect("every state is a vertex"));
        if is_lazy {
            let cost = roadmap.cost(problem, ends);
            roadmap.add_edge(Edge { ends, cost, state: EdgeState::Proven });
        } else {
            roadmap.growth.graph.add_edge(0, from, to);
        }
    }
    if is_lazy {
        let all: Vec<VertexId> = (0..roadmap.len() as u32).map(VertexId).collect();
        return Box::new(LazyPlanner::new(roadmap, Box::new(Batch::connecting(all)), false, false));
    }
    let is_complete = left.is_empty();
    let builder = Batch::connecting(left);
    Box::new(RoadmapPlanner::new(problem, roadmap, builder, is_complete))
}

/// A planner that searches a roadmap lazily after obstacles have moved: `added` and `removed` tell of the motion between two
/// states whether it may touch an obstacle that is only in the new world, or only in the old one. Edges that may touch the former
/// are to be proven again, motions that were refused and may touch the latter are candidates again, and all others stay as they
/// are; [surcharges](crate::problem::Validity::surcharge) are known of those alone that are proven again. Former ends that are
/// ends no longer are no vertices any more. O(states + edges), a cost of each edge, and the index of neighbours.
pub fn reopen<S: Space + 'static>(
    problem: &Problem<S>,
    kept: &Roadmap<S>,
    added: &dyn Fn(&S::State, &S::State) -> bool,
    removed: &dyn Fn(&S::State, &S::State) -> bool,
) -> Box<dyn Planner<S>> {
    let space = problem.space();
    let mut roadmap = Roadmap::new(problem, kept.connection, kept.rules).lazily(space);
    let ends = kept.goals.end.index();
    let goals: Vec<&S::State> = std::iter::once(problem.start()).chain(problem.goals()).collect();
    let is_kept = |&(i, state): &(usize, &S::State)| i >= ends || goals.contains(&state);
    let states = kept.graph().states().iter().enumerate();
    let (vertices, left) = add_vertices(&mut roadmap, space, states.map(|kept| is_kept(&kept).then_some(kept.1)));
    for (i, vertex) in vertices.iter().enumerate() {
        let Some(vertex) = vertex else { continue };
        let state = kept.graph().state(VertexId(i as u32));
        let was_unchecked = kept.candidates.as_ref().is_some_and(|candidates| candidates.unchecked[i]);
        let candidates = roadmap.candidates.as_mut().expect("the roadmap is lazy");
        candidates.unchecked[vertex.index()] = was_unchecked || added(state, state);
    }
    let edges: Vec<([VertexId; 2], EdgeState)> = match &kept.candidates {
        Some(candidates) => candidates.search.edges().iter().map(|edge| (edge.ends, edge.state)).collect(),
        None => {
            let proven = kept.graph().edges().iter().map(|ends| (*ends, EdgeState::Proven));
            proven.chain(kept.refused.iter().map(|ends| (*ends, EdgeState::Refused))).collect()
        }
    };
    for (ends, state) in edges {
        let [from, to] = ends.map(|end| kept.graph().state(end));
        let is_open = match state {
            EdgeState::Assumed => true,
            EdgeState::Proven => added(from, to),
            EdgeState::Refused => removed(from, to),
        };
        if let [Some(from), Some(to)] = ends.map(|end| vertices[end.index()]) {
            // What is near may have changed.
            let cost = kept.cost(problem, ends);
            roadmap.add_edge(Edge { ends: [from, to], cost, state: if is_open { EdgeState::Assumed } else { state } });
        }
    }
    let is_complete = left.is_empty();
    let builder = Batch::connecting(left);
    Box::new(LazyPlanner::new(roadmap, Box::new(builder), is_complete, false))
}

/// Adds vertices to a roadmap of start and goals alone; one that is an end becomes that end. Returns the vertex of each state,
/// and the ends that are none of them.
fn add_vertices<'a, S: Space + 'a>(
    roadmap: &mut Roadmap<S>,
    space: &S,
    states: impl Iterator<Item = Option<&'a S::State>>,
) -> (Vec<Option<VertexId>>, Vec<VertexId>) {
    let mut left: Vec<VertexId> = (0..roadmap.len() as u32).map(VertexId).collect();
    let mut add = |state: &S::State| match left.iter().position(|&end| roadmap.graph().state(end) == state) {
        Some(i) => left.remove(i),
        None => roadmap.add_vertex(space, 0, *state),
    };
    let vertices = states.map(|state| state.map(&mut add)).collect();
    (vertices, left)
}
