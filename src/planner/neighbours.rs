//! Neighbours of a roadmap by an index and a metric of one's choice: those of the planner, or those of the course reports.

use crate::error::Error;
use crate::graph::VertexId;
use crate::nearest::{Direction, Forest, ForestParameters, Index, Nearest, Neighbour};
use crate::options::out_of_range;
use crate::random::{Random, Stream};
use crate::space::{Coordinate, MAX_DIMENSION, Metric, ProductSpace, Space};

crate::choice! {
    /// How neighbours are found.
    pub enum NeighbourIndex {
        /// By an exact index.
        Exact,
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
    /// Finds all nearest neighbours (exact), or most of them by ten random-projection trees (forest).
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
    /// `out-of-range`, pointer `/neighbour_index`, for a forest in a space whose distances are lengths of curves.
    pub fn new<S: Space>(options: Neighbouring, space: &S, k: usize, seed: u64) -> Result<Self, Error> {
        let naive = (options.neighbour_metric == NeighbourMetric::Naive).then(|| Naive::new(space));
        let index = match options.neighbour_index {
            NeighbourIndex::Exact => Chosen::Exact(Box::default()),
            NeighbourIndex::Forest if naive.is_none() && !space.is_norm_exact() => {
                let sentence =
                    "a forest cannot measure curves; use neighbour_metric = naive or neighbour_index = exact";
                return Err(out_of_range("neighbour_index", sentence));
            }
            NeighbourIndex::Forest => {
                let parameters =
                    ForestParameters { trees: TREES, candidates: TREES.saturating_mul(k), ..Default::default() };
                Chosen::Forest(Box::new(Forest::new(parameters, Random::new(seed, Stream::Projections).bits())))
            }
        };
        Ok(Self { index, naive })
    }

    /// Whether no neighbour is missed.
    pub fn is_exact(&self) -> bool {
        matches!(self.index, Chosen::Exact(_))
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

    /// The `k` nearest to a state within the radius by motions in the given direction, nearest first, into `found`; all within the
    /// radius if there are no more vertices than `k`. Returns how many vertices were visited.
    pub fn find<S: Space>(
        &self,
        space: &S,
        states: &[S::State],
        direction: Direction,
        state: &S::State,
        (k, radius): (usize, f64),
        found: &mut Vec<Neighbour>,
    ) -> usize {
        match &self.naive {
            None => self.index.find(space, states, direction, state, (k, radius), found),
            Some(Naive { space: naive, states }) => {
                let state = naive.state(space.coordinates(state));
                self.index.find(naive, states, direction, &state, (k, radius), found)
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
            Chosen::Forest(forest) => forest.insert(space, vertex, state),
        }
    }

    /// Returns how many vertices were visited.
    fn find<S: Space>(
        &self,
        space: &S,
        states: &[S::State],
        direction: Direction,
        state: &S::State,
        (k, radius): (usize, f64),
        found: &mut Vec<Neighbour>,
    ) -> usize {
        if k >= states.len() && radius < f64::INFINITY {
            return match self {
                Chosen::Exact(index) => index.within_by(space, states, direction, state, radius, found),
                Chosen::Forest(forest) => forest.within(space, states, state, radius, found),
            };
        }
        let visited = match self {
            Chosen::Exact(index) => index.k_nearest_by(space, states, direction, state, k, found),
            Chosen::Forest(forest) => forest.k_nearest(space, states, state, k, found),
        };
        found.truncate(found.partition_point(|neighbour| neighbour.distance <= radius));
        visited
    }
}
