//! The JSON form: one line, numbers with the fewest digits that parse back to the same bits.

use super::{MAX_DIMENSION, RoadmapDocument, RoadmapMetric, damaged};
use crate::error::{Code, Error};
use crate::json;
use crate::planner::EdgeCheck;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// The `format` of the document.
pub const FORMAT: &str = "planarium-roadmap-2";

/// The document, field by field.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    format: String,
    scenario: String,
    #[serde(with = "json::hex")]
    fingerprint: u64,
    dimension: u64,
    circles: Vec<bool>,
    planner: String,
    metric: Value,
    k: u32,
    /// A number; `null` if it is infinite.
    radius: Value,
    edge_check: EdgeCheck,
    /// Present if edges are sampled by number.
    #[serde(skip_serializing_if = "Option::is_none")]
    edge_samples: Option<u32>,
    tolerance: f64,
    vertices: Vec<Vec<f64>>,
    edges: Vec<[u32; 2]>,
    #[serde(with = "json::hex")]
    checksum: u64,
}

impl RoadmapDocument {
    /// The document as one line of JSON. Text beyond [`MAX_TEXT`](crate::json::MAX_TEXT), some million vertices, cannot be
    /// read again: then bytes serve better.
    pub fn to_json(&self) -> String {
        json::to_string(&Document {
            format: FORMAT.to_owned(),
            scenario: self.scenario.clone(),
            fingerprint: self.fingerprint,
            dimension: self.dimension() as u64,
            circles: self.circles.clone(),
            planner: self.planner.clone(),
            metric: self.metric.to_tree(),
            k: self.k,
            radius: self.radius.into(),
            edge_check: self.edge_check,
            edge_samples: self.edge_samples,
            tolerance: self.tolerance,
            vertices: self.rows().map(<[f64]>::to_vec).collect(),
            edges: self.edges.clone(),
            checksum: self.checksum(),
        })
    }

    /// Reads the JSON form.
    ///
    /// # Errors
    /// With the pointer of the offending value: the codes of [`json::parse`], `unknown-field`, `missing-field`,
    /// `wrong-type`, `wrong-dimension`, `out-of-range`, and `invalid-roadmap` for another format, rows of another length than the
    /// dimension, digits that are none, what [`RoadmapDocument::check`] refuses, and a checksum that differs.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let tree = json::parse(text)?;
        let document: Document = json::read_document(&tree, FORMAT).map_err(|error| match error.pointer() {
            "/format" if error.code() == Code::UnknownFormat => damaged(error.pointer(), error.message()),
            "/fingerprint" | "/checksum" | "/edge_check" if error.code() == Code::OutOfRange => {
                damaged(error.pointer(), error.message())
            }
            _ => error,
        })?;
        document.checked()
    }
}

impl Document {
    /// The roadmap, if the document does not contradict itself.
    fn checked(self) -> Result<RoadmapDocument, Error> {
        let dimension = self.dimension as usize;
        if !(1..=MAX_DIMENSION).contains(&dimension) {
            let sentence = format!("a dimension must be from 1 to {MAX_DIMENSION}, not {dimension}");
            return Err(Error::new(Code::OutOfRange, "/dimension", sentence));
        }
        if self.circles.len() != dimension {
            let sentence = format!("there must be {dimension}, one per coordinate, not {}", self.circles.len());
            return Err(damaged("/circles", sentence));
        }
        let radius = match &self.radius {
            Value::Null => f64::INFINITY,
            radius => json::read(radius).map_err(|error| error.under("/radius"))?,
        };
        if let Some(i) = self.vertices.iter().position(|row| row.len() != dimension) {
            let sentence = format!("a vertex has {dimension} numbers here, not {}", self.vertices[i].len());
            return Err(damaged(format!("/vertices/{i}"), sentence));
        }
        let metric = RoadmapMetric::read(&self.metric)?;
        let document = RoadmapDocument {
            scenario: self.scenario,
            fingerprint: self.fingerprint,
            circles: self.circles,
            planner: self.planner,
            metric,
            k: self.k,
            radius,
            edge_check: self.edge_check,
            edge_samples: self.edge_samples,
            tolerance: self.tolerance,
            vertices: self.vertices.concat(),
            edges: self.edges,
        };
        document.check()?;
        if self.checksum != document.checksum() {
            return Err(damaged("/checksum", "the checksum differs: the document is damaged or was changed"));
        }
        Ok(document)
    }
}
