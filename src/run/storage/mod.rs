//! Saved roadmaps: the document of one that was built, as JSON, as bytes, and as GraphML for other programs.
//!
//! It holds a fingerprint of the world and the robot, how it was built, its vertices and its edges, and ends with a checksum. Of
//! a custom robot it holds the space; what is free there is known to a function alone. Reading refuses damaged documents;
//! whether edges are free is proven again by [`run::resume`](crate::run::resume) and
//! [`run::resume_problem`](crate::run::resume_problem), since a file proves nothing.

mod binary;
mod fingerprint;
mod graphml;
mod json;
mod metric;
mod states;

pub use binary::MAGIC;
pub use fingerprint::fingerprint;
pub(crate) use fingerprint::fingerprint_of_space;
pub use json::FORMAT;
pub use metric::RoadmapMetric;
pub(crate) use states::checked_states;

use crate::error::{Code, Error, Number};
use crate::planner::EdgeCheck;
use crate::space::steering::Steering;
use crate::space::{Coordinate, MAX_DIMENSION, Metric, MotionSpace, ProductSpace, Space};

/// The most neighbours of a vertex: with a radius, as many as a roadmap may try.
const MOST_NEIGHBOURS: u32 = 20_000_000;

/// The most checks per edge, as in the option `edge_samples`.
const MOST_SAMPLES: u32 = 10_000;

/// A roadmap with everything needed to query it again.
#[derive(Debug, Clone, PartialEq)]
pub struct RoadmapDocument {
    /// The name of the scenario, for people; empty for a custom robot.
    pub scenario: String,
    /// What the roadmap depends on: the [`fingerprint`] of world and robot; for a custom robot, that of its space.
    pub fingerprint: u64,
    /// For every coordinate of a configuration whether it is a circle, an angle that wraps at a full turn; 1 to 8 of them.
    pub circles: Vec<bool>,
    /// The id of the planner that built it.
    pub planner: String,
    /// The metric.
    pub metric: RoadmapMetric,
    /// The number of neighbours that a vertex is connected to, 1 to 20 million.
    pub k: u32,
    /// The largest distance to a neighbour, in the metric; infinite if only the number is limited.
    pub radius: f64,
    /// How its edges were checked.
    pub edge_check: EdgeCheck,
    /// The number of checks per edge: given if, and only if, edges are sampled; but not if a custom robot is sampled at the
    /// resolution of its problem.
    pub edge_samples: Option<u32>,
    /// The parameter `tolerance` of the proofs, a fraction of the world's longer side.
    pub tolerance: f64,
    /// The vertices: rows of as many numbers as there are `circles`.
    pub vertices: Vec<f64>,
    /// The edges: two vertex numbers each, from 0.
    pub edges: Vec<[u32; 2]>,
}

impl RoadmapDocument {
    /// Reads a document in either form: bytes that begin with [`MAGIC`] are binary, those that begin with `{` JSON.
    ///
    /// # Errors
    /// `invalid-roadmap` for what is neither; else as [`RoadmapDocument::from_bytes`] and [`RoadmapDocument::parse`].
    pub fn read(bytes: &[u8]) -> Result<Self, Error> {
        if bytes.starts_with(&MAGIC) {
            return Self::from_bytes(bytes);
        }
        match std::str::from_utf8(bytes) {
            Ok(text) if text.trim_start().starts_with('{') => Self::parse(text),
            _ => Err(damaged("", "this is neither the JSON nor the binary form of a roadmap")),
        }
    }

    /// The same with these vertices and edges: rows, and pairs of vertex numbers; without the vertices that are not kept.
    /// Compiled once for all spaces.
    #[inline(never)]
    pub(crate) fn filled(&self, vertices: Vec<f64>, edges: &[u32], kept: &[bool]) -> Self {
        let mut count = 0;
        let number = |&is_kept: &bool| {
            count += u32::from(is_kept);
            is_kept.then(|| count - 1)
        };
        let numbers: Vec<Option<u32>> = kept.iter().map(number).collect();
        let rows = vertices.chunks_exact(self.dimension()).zip(kept).filter(|(_, is_kept)| **is_kept);
        let vertices = rows.flat_map(|(row, _)| row).copied().collect();
        let (edges, _) = edges.as_chunks();
        let kept = |[from, to]: &[u32; 2]| Some([numbers[*from as usize]?, numbers[*to as usize]?]);
        Self { vertices, edges: edges.iter().filter_map(kept).collect(), ..self.clone() }
    }

    /// How many numbers a vertex has.
    pub fn dimension(&self) -> usize {
        self.circles.len()
    }

    /// The vertices, a row each.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        // A document without a dimension is refused before its rows are read.
        self.vertices.chunks_exact(self.dimension().max(1))
    }

    /// How many vertices there are.
    pub fn vertex_count(&self) -> usize {
        self.rows().len()
    }

    /// Whether edges lead from their first vertex to their second only.
    pub fn is_directed(&self) -> bool {
        self.metric.curves().is_some_and(|(steering, _)| !steering.is_symmetric())
    }

    /// The length of an edge in the metric, to the bit that of the space it was built in.
    ///
    /// # Panics
    /// If a vertex does not exist, or [`RoadmapDocument::check`] refuses the metric.
    pub fn length(&self, edge: [u32; 2]) -> f64 {
        let dimension = self.dimension();
        let [a, b] = edge.map(|vertex| {
            let mut state = [0.0; MAX_DIMENSION];
            state[..dimension].copy_from_slice(&self.vertices[vertex as usize * dimension..][..dimension]);
            state
        });
        self.space().distance(&a, &b)
    }

    /// The space that it was built in, without its limits, which distances do not depend on.
    fn space(&self) -> MotionSpace<MAX_DIMENSION> {
        let coordinate = |&is_circle: &bool| match is_circle {
            true => Coordinate::Circle,
            false => Coordinate::Interval { low: -1.0, high: 1.0 },
        };
        let coordinates: Vec<Coordinate> = self.circles.iter().map(coordinate).collect();
        let product = |metric| MotionSpace::new(ProductSpace::new(&coordinates, metric));
        let placements = |translation, rotation| ProductSpace::of_placements([0.0; 2], [1.0; 2], translation, rotation);
        match self.metric {
            RoadmapMetric::Space(ref space) => space.read().expect("a checked document"),
            RoadmapMetric::Sum => product(Metric::Sum),
            RoadmapMetric::Euclidean | RoadmapMetric::Naive => product(Metric::Euclidean),
            RoadmapMetric::Placement { translation, rotation } => MotionSpace::new(placements(translation, rotation)),
            RoadmapMetric::Dubins { radius } => MotionSpace::steered(placements(1.0, 1.0), Steering::Dubins, radius),
            RoadmapMetric::ReedsShepp { radius } => {
                MotionSpace::steered(placements(1.0, 1.0), Steering::ReedsShepp, radius)
            }
        }
    }

    /// Refuses a document that contradicts itself.
    ///
    /// # Errors
    /// `invalid-roadmap`, with the pointer into the JSON form.
    pub fn check(&self) -> Result<(), Error> {
        let dimension = self.dimension();
        if !(1..=MAX_DIMENSION).contains(&dimension) {
            return Err(damaged("/dimension", format!("a vertex has 1 to {MAX_DIMENSION} numbers, not {dimension}")));
        }
        if !(1..=MOST_NEIGHBOURS).contains(&self.k) {
            return Err(damaged("/k", format!("k must lie within [1, {MOST_NEIGHBOURS}], not {}", self.k)));
        }
        self.metric.check(&self.circles)?;
        let is_sampled = self.edge_check == EdgeCheck::Sampled;
        let is_sound = match self.edge_samples {
            Some(samples) => is_sampled && (1..=MOST_SAMPLES).contains(&samples),
            None => !is_sampled || matches!(self.metric, RoadmapMetric::Space(_)),
        };
        if !is_sound {
            let sentence =
                format!("edges that are sampled, and only they, have edge_samples within [1, {MOST_SAMPLES}]");
            return Err(damaged("/edge_samples", sentence));
        }
        let is_positive = |x: f64| x > 0.0;
        if !is_positive(self.radius) {
            return Err(damaged("/radius", format!("a radius must be positive, not {}", Number(self.radius))));
        }
        if !is_positive(self.tolerance) || self.tolerance == f64::INFINITY {
            return Err(damaged("/tolerance", format!("a tolerance must be positive, not {}", Number(self.tolerance))));
        }
        if !self.vertices.len().is_multiple_of(dimension) || self.vertex_count() >= u32::MAX as usize - 2 {
            return Err(damaged("/vertices", format!("{} numbers are no rows of {dimension}", self.vertices.len())));
        }
        if let Some(i) = self.vertices.iter().position(|x| !x.is_finite()) {
            let pointer = format!("/vertices/{}/{}", i / dimension, i % dimension);
            let sentence = format!("a coordinate must be finite, not {}", Number(self.vertices[i]));
            return Err(damaged(pointer, sentence));
        }
        let count = self.vertex_count();
        for (i, edge) in self.edges.iter().enumerate() {
            if let Some(end) = edge.iter().position(|&vertex| vertex as usize >= count) {
                let sentence = format!("edge {i} names vertex {}, and there are {count}", edge[end]);
                return Err(damaged(format!("/edges/{i}/{end}"), sentence));
            }
        }
        Ok(())
    }
}

/// The error for a document that is damaged.
pub(crate) fn damaged(pointer: impl Into<String>, sentence: impl Into<String>) -> Error {
    Error::new(Code::InvalidRoadmap, pointer, sentence)
}
