//! The kinds of documents that commands write, and how an earlier one is recognised.

use serde::de::{Deserialize, Deserializer, Error as _, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::fmt;
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::Path;

/// A kind of document: its name in a sentence, and how an earlier one is recognised.
#[derive(Clone, Copy)]
pub struct Kind {
    pub name: &'static str,
    mark: Mark,
}

/// What every document of a kind has.
#[derive(Clone, Copy)]
enum Mark {
    /// JSON with this `format`.
    Format(&'static str),
    /// JSON with all these fields, of an object or of every object of a list.
    Fields(&'static [&'static str]),
    /// These bytes at its beginning.
    Start(&'static [u8]),
    /// Nothing that others would not have.
    Nothing,
    Roadmap,
}

impl Kind {
    pub const PLAN: Self = Self::fields("a result of this command", &["scenario", "query", "planner", "path", "stats"]);
    pub const FLEET_PLAN: Self =
        Self::fields("a plan of a fleet", &["fleet", "planner", "robots", "makespan", "stats"]);
    pub const NAVIGATION_PLAN: Self =
        Self::fields("a result of this command", &["scenario", "query", "path", "policy", "rollouts", "reached"]);
    pub const COMPARISON: Self = Self::fields("a comparison", &["comparisons", "methods"]);
    pub const REACH: Self = Self::fields("a result of this command", &["scenario", "method", "target", "solutions"]);
    pub const OPTIMUM: Self = Self::fields("a shortest path", &["length", "path", "method", "exact"]);
    pub const WIDEST: Self = Self::fields("a widest disc", &["radius", "limit", "bottleneck", "between"]);
    pub const ROUTE_GRAPH: Self = Self::fields("a route graph of this command", &["type", "route_graph", "features"]);
    pub const CERTIFICATE: Self = Self::format("a certificate", "planarium-certificate-1");
    pub const TRAJECTORY: Self = Self::format("a trajectory", planarium::timing::FORMAT);
    pub const POLICY: Self = Self::format("a policy", "planarium-policy-1");
    pub const SCENARIO: Self = Self::format("a scenario", planarium::scenario::FORMAT);
    pub const FLEET: Self = Self::format("a fleet", planarium::fleet::FORMAT);
    pub const NAVIGATION: Self = Self::format("a navigation task", planarium::navigation::FORMAT);
    pub const PATH_JSON: Self = Self::fields("a path of this command", &["scenario", "query", "rows", "columns"]);
    pub const PATH_GEOJSON: Self = Self::fields("a path of this command", &["type", "scenario", "query", "features"]);
    pub const PATH_SVG: Self = Self { name: "a drawing of a path", mark: Mark::Start(b"<!-- A path of Planarium -->") };
    pub const PATH_POSES: Self =
        Self { name: "a path of this command", mark: Mark::Start(b"# A path of Planarium: nav_msgs/Path") };
    pub const PATH_WAYPOINTS: Self =
        Self { name: "waypoints of this command", mark: Mark::Start(b"# A path of Planarium: waypoints") };
    pub const PATH_ROWS: Self = Self { name: "what only this command writes", mark: Mark::Nothing };
    pub const ROADMAP: Self = Self { name: "a roadmap", mark: Mark::Roadmap };
    pub const OMPL_LOG: Self = Self { name: "a log of a sweep", mark: Mark::Start(b"Planarium version ") };

    /// Text whose first line has the names of columns.
    pub const fn table(header: &'static str) -> Self {
        Self { name: "a table of this command", mark: Mark::Start(header.as_bytes()) }
    }

    const fn fields(name: &'static str, fields: &'static [&'static str]) -> Self {
        Self { name, mark: Mark::Fields(fields) }
    }

    const fn format(name: &'static str, format: &'static str) -> Self {
        Self { name, mark: Mark::Format(format) }
    }

    /// Whether a file contains a document of this kind.
    pub fn is_in(self, path: &Path) -> io::Result<bool> {
        let starts_with = |start: &[u8]| -> io::Result<bool> {
            let mut begin = Vec::new();
            File::open(path)?.take(start.len() as u64).read_to_end(&mut begin)?;
            Ok(begin == start)
        };
        let outline = || -> io::Result<Outline> {
            // What is not JSON has no outline.
            Ok(serde_json::from_reader(BufReader::new(File::open(path)?)).unwrap_or_default())
        };
        match self.mark {
            Mark::Start(start) => starts_with(start),
            Mark::Nothing => Ok(false),
            Mark::Format(format) => Ok(outline()?.format.as_deref() == Some(format)),
            Mark::Fields(fields) => {
                let known = outline()?.fields;
                Ok(fields.iter().all(|field| known.iter().any(|name| name == field)))
            }
            Mark::Roadmap => Ok(starts_with(&planarium::run::storage::MAGIC)?
                || starts_with(GRAPHML)?
                || outline()?.format.is_some_and(|format| format.starts_with("planarium-roadmap-"))),
        }
    }
}

/// The beginning of a roadmap as GraphML.
const GRAPHML: &[u8] =
    b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n\
    <key id=\"scenario\" for=\"graph\"";

/// The fields of a JSON object and its `format`; of a list, those of its first object.
#[derive(Default)]
struct Outline {
    fields: Vec<String>,
    format: Option<String>,
}

impl<'de> Deserialize<'de> for Outline {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        struct Fields;
        impl<'de> Visitor<'de> for Fields {
            type Value = Outline;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("an object, or a list of objects")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Outline, A::Error> {
                let mut outline = Outline::default();
                while let Some(name) = map.next_key::<String>()? {
                    if name == "format" {
                        outline.format = map.next_value::<serde_json::Value>()?.as_str().map(str::to_owned);
                    } else {
                        map.next_value::<IgnoredAny>()?;
                    }
                    outline.fields.push(name);
                }
                Ok(outline)
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Outline, A::Error> {
                let first = list.next_element::<Outline>()?.ok_or_else(|| A::Error::custom("an empty list"))?;
                while list.next_element::<Outline>()?.is_some() {}
                Ok(first)
            }
        }
        source.deserialize_any(Fields)
    }
}
