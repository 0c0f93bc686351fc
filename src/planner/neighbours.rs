//! Neighbours of a roadmap by an index and a metric of one's choice: those of the planner, or those of the course reports.

use crate::error::Error;
use crate::graph::VertexId;
use crate::nearest::{Forest, ForestParameters, Index, KdTree, Nearest, Neighbour, Neighbourhood, Query};
use crate::options::out_of_range;
use crate::random::{Random, Stream};
use crate::space::{Coordinate, MAX_DIMENSION, Metric, ProductSpace, Space};

crate::choice! {
    /// How neighbours are found.
    pub enum NeighbourIndex {
        /// By an exact index.
        Exact,
        /// By a kd-tree that takes angles as plain numbers, which misses those across -pi and pi.
        KdTreeUnwrapped,
        /// By a forest of random-projection trees, which misses some.
        Forest,
    }
}

crate::choice! {
    /// How far apart neighbours are.
    pub enum NeighbourMetric {
        /// As far as an edge is long.
        Edges,
        /// By the Euclidean norm of coordinates, every circle cut open at 0, while edges still go the short way round.
        Naive,
    }
}

crate::options! {
    /// How the neighbours of a roadmap are found.
    pub struct Neighbouring for crate::options::ALL;
    /// Finds all nearest (exact), all but those across pi (kd-tree-unwrapped, faulty), or most by ten trees (forest).
    neighbour_index: NeighbourIndex = NeighbourIndex::Exact, "Neighbour index";
    /// Distance between neighbours: that of edges, or without wrap-around (naive), which misses some across 0.
    neighbour_metric: NeighbourMetric = NeighbourMetric::Edges, "Neighbour metric";
}

/// The trees of a forest; a query examines as many vertices for each neighbour.
const TREES: usize = 10;

/// The vertices of a roadmap, in an index.
#[derive(Debug, Clone)]
pub(super) struct Neighbours {
    index: Chosen,
    naive: Option<Naive>,
}

#[derive(Debug, Clone)]
enum Chosen {
    Exact(Box<Index>),
    Unwrapped(Box<KdTree>),
    Forest(Box<Forest>),
}

/// The vertices in the naive space.
#[derive(Debug, Clone)]
struct Naive {
    space: ProductSpace<MAX_DIMENSION>,
    states: Vec<[f64; MAX_DIMENSION]>,
}

impl Default for Neighbours {
    /// The exact index and the metric of the space.
    fn default() -> Self {
        Self { index: Chosen::Exact(Box::default()), naive: None }
    }
}

impl Neighbours {
    /// No vertices; `k` is the number of neighbours that are asked for.
    ///
    /// # Errors
    /// `out-of-range`, pointer `/neighbour_index`, for a forest, or a kd-tree without wrap-around, in a space whose
    /// distances are lengths of curves.
    pub fn new<S: Space>(options: Neighbouring, space: &S, k: usize, seed: u64) -> Result<Self, Error> {
        let naive = (options.neighbour_metric == NeighbourMetric::Naive).then(|| Naive::new(space));
        let index = match options.neighbour_index {
            NeighbourIndex::Exact => Chosen::Exact(Box::default()),
            _ if naive.is_none() && !space.is_norm_exact() => {
                let sentence = "only an exact index measures curves; use neighbour_metric = naive or \
                    neighbour_index = exact";
                return Err(out_of_range("neighbour_index", sentence));
            }
            NeighbourIndex::KdTreeUnwrapped => Chosen::Unwrapped(Box::new(KdTree::unwrapped())),
            NeighbourIndex::Forest => {
                let parameters =
                    ForestParameters { trees: TREES, candidates: TREES.saturating_mul(k), ..Default::default() };
                Chosen::Forest(Box::new(Forest::new(parameters, Random::new(seed, Stream::Projections).bits())))
            }
        };
        Ok(Self { index, naive })
    }

    /// Whether no neighbour by the distance of the index, which is symmetric, is missed.
    pub fn is_exact(&self) -> bool {
        !matches!(self.index, Chosen::Forest(_))
    }

    /// Adds a vertex; numbers must increase.
    pub fn insert<S: Space>(&mut self, space: &S, vertex: VertexId, state: &S::State) {
        match &mut self.naive {
            None => self.index.insert(space, vertex, state),
            Some(naive) => {
                let state = naive.space.state(space.coordinates(state));
                naive.states.push(state);
                self.index.insert(&naive.space, vertex, &state);
            }
        }
    }

    /// The vertices of a neighbourhood, nearest first, into `found`. Returns how many vertices were visited.
    pub fn find<S: Space>(&self, query: Query<S>, wanted: Neighbourhood, found: &mut Vec<Neighbour>) -> usize {
        match &self.naive {
            None => self.index.find(query, wanted, found),
            Some(Naive { space, states }) => {
                let from = &space.state(query.space.coordinates(query.from));
                self.index.find(Query { space, states, direction: query.direction, from }, wanted, found)
            }
        }
    }
}

impl Naive {
    fn new<S: Space>(space: &S) -> Self {
        let coordinate = |i| match space.period(i).is_finite() {
            true => Coordinate::CutCircle,
            // Distances do not depend on the limits.
            false => Coordinate::Interval { low: -1.0, high: 1.0 },
        };
        let coordinates: Vec<Coordinate> = (0..space.dimension()).map(coordinate).collect();
        Self { space: ProductSpace::new(&coordinates, Metric::Euclidean), states: Vec::new() }
    }
}

impl Chosen {
    fn insert<S: Space>(&mut self, space: &S, vertex: VertexId, state: &S::State) {
        match self {
            Chosen::Exact(index) => index.insert(space, vertex, state),
            Chosen::Unwrapped(tree) => tree.insert(space, vertex, state),
            Chosen::Forest(forest) => forest.insert(space, vertex, state),
        }
    }

    /// Returns how many vertices were visited.
    fn find<S: Space>(&self, query: Query<S>, wanted: Neighbourhood, found: &mut Vec<Neighbour>) -> usize {
        match self {
            Chosen::Exact(index) => index.find(query, wanted, found),
            Chosen::Unwrapped(tree) => tree.find(query, wanted, found),
            Chosen::Forest(forest) => forest.find(query, wanted, found),
        }
    }
}
