//! From a scenario and options to an index.

use super::table::{ForestOptions, IndexOptions};
use super::{MAX_CONFIGURATIONS, MAX_ENTRIES, NearestResult, Neighbours};
use crate::error::{Code, Error, Number};
use crate::graph::VertexId;
use crate::nearest::{Forest, ForestParameters, KdTree, LinearScan, Nearest, Neighbourhood, Query};
use crate::random::{Random, Stream};
use crate::space::{MAX_DIMENSION, MotionSpace, Space};
use crate::world::{Configurations, PlanningWorld, SMALL};

/// An empty index of configurations of the scenario's robot. The same planes follow from the same seed.
///
/// # Errors
/// `not-finite` and `out-of-range` of the options, with their pointers: the metric of a body or a car is its scenario's, that of
/// a disc is euclidean.
pub fn index(scenario: impl Into<PlanningWorld>, options: &IndexOptions) -> Result<Box<dyn Neighbours>, Error> {
    let world = scenario.into();
    options.check()?;
    if world.robot().dimension() <= SMALL {
        index_of::<SMALL>(&world, options)
    } else {
        index_of::<MAX_DIMENSION>(&world, options)
    }
}

/// The index over states of `N` numbers.
fn index_of<const N: usize>(world: &PlanningWorld, options: &IndexOptions) -> Result<Box<dyn Neighbours>, Error> {
    // The space of planners, so that its tree is compiled once.
    let space = MotionSpace::new(world.space::<N>(options.measuring().metric)?);
    let configurations = Configurations::of(world);
    let most = MAX_CONFIGURATIONS;
    Ok(match *options {
        IndexOptions::Linear(_) => {
            Box::new(TypedIndex { space, states: Vec::new(), index: LinearScan::default(), configurations, most })
        }
        IndexOptions::KdTree(_) => {
            Box::new(TypedIndex { space, states: Vec::new(), index: KdTree::default(), configurations, most })
        }
        IndexOptions::KdTreeUnwrapped(_) => {
            Box::new(TypedIndex { space, states: Vec::new(), index: KdTree::unwrapped(), configurations, most })
        }
        IndexOptions::Forest(ForestOptions { trees, leaf, candidates, seed, .. }) => {
            let key = Random::new(seed, Stream::Projections).bits();
            let index = Forest::new(ForestParameters { trees, leaf, candidates }, key);
            let most = most.min(MAX_ENTRIES / trees);
            Box::new(TypedIndex { space, states: Vec::new(), index, configurations, most })
        }
    })
}

/// An index with its space and the configurations that it may hold.
struct TypedIndex<S: Space, I> {
    space: S,
    states: Vec<S::State>,
    index: I,
    configurations: Configurations,
    /// The most configurations that it may hold.
    most: usize,
}

impl<S: Space, I: Nearest<S>> TypedIndex<S, I> {
    /// The neighbours of `q`.
    fn query(&self, q: &[f64], neighbourhood: Neighbourhood) -> Result<NearestResult, Error> {
        self.configurations.refuse_outside(q, "/q")?;
        let (state, mut neighbours) = (self.space.state(q), Vec::new());
        let query = Query::to(&self.space, &self.states, &state);
        let visited = self.index.find(query, neighbourhood, &mut neighbours);
        Ok(NearestResult { neighbours, visited })
    }
}

impl<S: Space, I: Nearest<S>> Neighbours for TypedIndex<S, I> {
    fn dimension(&self) -> usize {
        self.configurations.dimension()
    }

    fn len(&self) -> usize {
        self.states.len()
    }

    fn add(&mut self, rows: &[f64]) -> Result<(), Error> {
        let dimension = self.dimension();
        if !rows.len().is_multiple_of(dimension) {
            let sentence = format!("rows have {dimension} numbers each; {} numbers are not whole rows", rows.len());
            return Err(Error::new(Code::WrongDimension, "/rows", sentence));
        }
        let (wanted, most) = (self.len() + rows.len() / dimension, self.most);
        if wanted > most {
            let kind = if most < MAX_CONFIGURATIONS { " with this number of trees" } else { "" };
            let sentence = format!("an index{kind} holds at most {most} configurations, not {wanted}");
            return Err(Error::new(Code::TooLarge, "/rows", sentence));
        }
        for (row, q) in rows.chunks_exact(dimension).enumerate() {
            self.configurations.refuse_outside(q, &format!("/rows/{row}"))?;
        }
        for q in rows.chunks_exact(dimension) {
            let vertex = VertexId(self.len() as u32);
            let state = self.space.state(q);
            self.index.insert(&self.space, vertex, &state);
            self.states.push(state);
        }
        Ok(())
    }

    fn k_nearest(&self, q: &[f64], k: usize) -> Result<NearestResult, Error> {
        self.query(q, Neighbourhood::Nearest(k.min(self.len())))
    }

    fn within(&self, q: &[f64], radius: f64) -> Result<NearestResult, Error> {
        // Not a number, too.
        if !(radius >= 0.0 && radius.is_finite()) {
            let code = if radius.is_finite() { Code::OutOfRange } else { Code::NotFinite };
            let sentence = format!("a radius must be a finite number of at least 0, not {}", Number(radius));
            return Err(Error::new(code, "/radius", sentence));
        }
        self.query(q, Neighbourhood::Within(radius))
    }
}
