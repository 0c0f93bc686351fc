//! The JSON form: one line, numbers with the fewest digits that parse back to the same bits.

use super::{MAX_DIMENSION, RoadmapDocument, damaged};
use crate::error::{Code, Error, quoted};
use crate::json::Node;
use crate::scenario::reader::Reader;

/// The `format` of the document.
pub const FORMAT: &str = "planarium-roadmap-1";

/// The fields in their order.
const FIELDS: &[&str] = &[
    "format",
    "scenario",
    "fingerprint",
    "dimension",
    "circles",
    "planner",
    "metric",
    "k",
    "radius",
    "edge_check",
    "edge_samples",
    "tolerance",
    "vertices",
    "edges",
    "checksum",
];

impl RoadmapDocument {
    /// The document as one line of JSON. Text beyond [`MAX_TEXT`](crate::scenario::MAX_TEXT), some million vertices, cannot be
    /// read again: then bytes serve better.
    pub fn to_json(&self) -> String {
        let hash = |value: u64| Node::String(format!("{value:016x}"));
        let edge = |edge: &[u32; 2]| Node::numbers(&edge.map(f64::from));
        let radius = if self.radius == f64::INFINITY { Node::Null } else { Node::Number(self.radius) };
        let edge_check = if self.edge_samples.is_some() { "sampled" } else { "proven" };
        let document = Node::object(vec![
            ("format", Some(Node::text(FORMAT))),
            ("scenario", Some(Node::text(&self.scenario))),
            ("fingerprint", Some(hash(self.fingerprint))),
            ("dimension", Some(Node::Number(self.dimension() as f64))),
            ("circles", Some(Node::Array(self.circles.iter().copied().map(Node::Bool).collect()))),
            ("planner", Some(Node::text(&self.planner))),
            ("metric", Some(Node::text(&self.metric))),
            ("k", Some(Node::Number(f64::from(self.k)))),
            ("radius", Some(radius)),
            ("edge_check", Some(Node::text(edge_check))),
            ("edge_samples", self.edge_samples.map(|places| Node::Number(f64::from(places)))),
            ("tolerance", Some(Node::Number(self.tolerance))),
            ("vertices", Some(Node::Array(self.rows().map(Node::numbers).collect()))),
            ("edges", Some(Node::Array(self.edges.iter().map(edge).collect()))),
            ("checksum", Some(hash(self.checksum()))),
        ]);
        document.to_json()
    }

    /// Reads the JSON form.
    ///
    /// # Errors
    /// With the pointer of the offending value: the codes of [`Node::parse`], `unknown-field`, `missing-field`,
    /// `wrong-type`, `not-finite`, `out-of-range`, and `invalid-roadmap` for another format, rows of another length than the
    /// dimension, digits that are none, what [`RoadmapDocument::check`] refuses, and a checksum that differs.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let node = Node::parse(text)?;
        let root = Reader::root(&node);
        let fields = root.object()?;
        // First of all, so that another kind of document is called just that.
        let format = fields.required("format")?;
        if format.string()? != FORMAT {
            let sentence = format!("the format is {}; \"{FORMAT}\" is understood", quoted(format.string()?));
            return Err(damaged("/format", sentence));
        }
        fields.only(FIELDS)?;
        let text = |name| fields.required(name)?.string().map(str::to_owned);
        let dimension = fields.required("dimension")?.integer("a dimension", 1, MAX_DIMENSION as u64)? as usize;
        let circles = fields.required("circles")?;
        let circles: Vec<bool> = circles.items()?.map(|item| item.boolean()).collect::<Result<_, _>>()?;
        if circles.len() != dimension {
            let sentence = format!("there must be {dimension}, one a coordinate, not {}", circles.len());
            return Err(damaged("/circles", sentence));
        }
        let radius = fields.required("radius")?;
        let document = Self {
            scenario: text("scenario")?,
            fingerprint: fields.required("fingerprint")?.digits(Code::InvalidRoadmap)?,
            circles,
            planner: text("planner")?,
            metric: text("metric")?,
            k: whole(&fields.required("k")?)?,
            radius: if radius.is_null() { f64::INFINITY } else { radius.number()? },
            edge_samples: edge_samples(&fields.required("edge_check")?, fields.optional("edge_samples"))?,
            tolerance: fields.required("tolerance")?.number()?,
            vertices: vertices(&fields.required("vertices")?, dimension)?,
            edges: fields.required("edges")?.items()?.map(|item| edge(&item)).collect::<Result<_, _>>()?,
        };
        document.check()?;
        if fields.required("checksum")?.digits(Code::InvalidRoadmap)? != document.checksum() {
            return Err(damaged("/checksum", "the checksum differs: the document is damaged or was changed"));
        }
        Ok(document)
    }
}

fn vertices(value: &Reader, dimension: usize) -> Result<Vec<f64>, Error> {
    let mut vertices = Vec::new();
    for row in value.items()? {
        let numbers = row.numbers()?;
        if numbers.len() != dimension {
            let sentence = format!("a vertex has {dimension} numbers here, not {}", numbers.len());
            return Err(damaged(row.pointer(), sentence));
        }
        vertices.extend(numbers);
    }
    Ok(vertices)
}

fn edge(value: &Reader) -> Result<[u32; 2], Error> {
    let [from, to] = value.tuple("an edge")?;
    Ok([whole(&from)?, whole(&to)?])
}

fn whole(value: &Reader) -> Result<u32, Error> {
    value.integer("this", 0, u64::from(u32::MAX)).map(|number| number as u32)
}

/// In how many places edges are looked at; told where they are sampled, and only there.
fn edge_samples(check: &Reader, places: Option<Reader>) -> Result<Option<u32>, Error> {
    match (check.string()?, places) {
        ("proven", None) => Ok(None),
        ("sampled", Some(places)) => match whole(&places)? {
            0 => Err(damaged("/edge_samples", "an edge is looked at in one place at least, not 0")),
            count => Ok(Some(count)),
        },
        (word @ ("proven" | "sampled"), _) => {
            Err(damaged("/edge_samples", format!("edges are {word}: edge_samples belongs to sampled ones alone")))
        }
        (other, _) => Err(damaged("/edge_check", format!("edges are proven or sampled, not {}", quoted(other)))),
    }
}
