//! The certificate as a document.

use super::cell::Cell;
use crate::error::Error;
use crate::json;
use crate::problem::Touched;
use serde::{Deserialize, Serialize};
use strum::IntoStaticStr;

/// What a certificate says about the paths of a query.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "CertificateVerdict"))]
pub enum Verdict {
    /// No path keeps more than the clearance of the question.
    Infeasible,
    /// A path keeps more than it.
    Connected,
    /// Neither is proven.
    Unknown,
}

/// The format of the document.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Format {
    /// The one there is.
    #[serde(rename = "planarium-certificate-1")]
    One,
}

/// A certificate, in the order and under the names of its JSON form. Lengths are metres.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Certificate {
    /// The format of the document.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"planarium-certificate-1\""))]
    pub format: Format,
    /// The name of the scenario.
    pub scenario: String,
    /// The name of the query.
    pub query: String,
    /// The clearance of the question: whether a path keeps more than this.
    #[serde(deserialize_with = "json::not_negative")]
    pub clearance: f64,
    /// The answer.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "CertificateVerdict"))]
    pub verdict: Verdict,
    /// No path keeps more than this: `clearance` if the verdict is `infeasible`, something greater if it is `unknown`. Absent if
    /// nothing is proven, or that a path exists.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "json::some_not_negative")]
    pub clearance_at_most: Option<f64>,
    /// What clearances are known to: an obstacle nearer than this may count as touched, and a path that keeps more than
    /// `clearance` or `clearance_at_most` by less than this may exist. 2e-12 times the largest coordinate plus the reach.
    #[serde(deserialize_with = "json::not_negative")]
    pub slack: f64,
    /// The number of cells of the subdivision, divided ones too.
    pub cells: u64,
    /// The cells that separate start and goal, if no path keeps more than `clearance_at_most`.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "BlockedCell[]"))]
    pub wall: Vec<Blocked>,
    /// The cells from the start to the goal, each touching the next, in which the clearance is greater everywhere; empty
    /// unless the verdict is `connected`.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[depth: number, column: number, row: number][]"))]
    pub channel: Vec<Cell>,
}

/// A cell of a wall, and a point of the robot that is, at every configuration of the cell, no farther than `clearance_at_most`
/// from an obstacle, or so near to the bounds that the robot is not within them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "BlockedCell"))]
pub struct Blocked {
    /// The cell.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[depth: number, column: number, row: number]"))]
    pub cell: Cell,
    /// The link, from 0; 0 for a disc.
    pub part: usize,
    /// The point on the axis of the link, as a fraction of it from its inner end; the part within the radius about it is meant.
    pub along: f64,
    /// The obstacle, or the bounds.
    #[serde(rename = "obstacle")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "number | \"bounds\""))]
    pub with: Touched,
}

impl Certificate {
    /// Reads a certificate.
    ///
    /// # Errors
    /// With the pointer of the offending value: the codes of [`json::parse`], `unknown-field`, `missing-field`, `wrong-type`,
    /// `not-finite`, `out-of-range`. Whether it holds is decided by [`verify`](super::verify()).
    pub fn parse(text: &str) -> Result<Self, Error> {
        json::read(&json::parse(text)?)
    }

    /// The document as one line of JSON.
    pub fn to_json(&self) -> String {
        json::to_string(self)
    }
}
