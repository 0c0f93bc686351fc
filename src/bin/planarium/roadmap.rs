//! Roadmaps in files.

use crate::arguments::RoadmapFormat;
use crate::files;
use planarium::Error;
use planarium::run::storage::RoadmapDocument;
use std::path::Path;

/// Reads a roadmap in either form that can be read.
pub fn read(name: &str) -> Result<RoadmapDocument, Error> {
    RoadmapDocument::read(&files::read_bytes(name)?)
}

/// Writes a roadmap in the given form, or in the one that the name's ending stands for.
pub fn write(document: &RoadmapDocument, name: &str, format: Option<RoadmapFormat>) -> Result<(), Error> {
    match format.unwrap_or_else(|| by_ending(name)) {
        RoadmapFormat::Json => files::write_bytes(format!("{}\n", document.to_json()).as_bytes(), name),
        RoadmapFormat::Binary => files::write_bytes(&document.to_bytes(), name),
        RoadmapFormat::Graphml => files::write_bytes(document.to_graphml().as_bytes(), name),
    }
}

fn by_ending(name: &str) -> RoadmapFormat {
    let ending = Path::new(name).extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    match ending.to_ascii_lowercase().as_str() {
        "json" => RoadmapFormat::Json,
        "graphml" => RoadmapFormat::Graphml,
        _ => RoadmapFormat::Binary,
    }
}
