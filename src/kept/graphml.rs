//! The roadmap for other programs: GraphML (Brandes, Eiglsperger, Lerner and Pich 2013, "Graph markup language"), which
//! networkx, igraph, Gephi and yEd read. It is written only: it holds no checksum and proves nothing.

use super::RoadmapDocument;
use crate::decimal::exact;
use std::fmt::Write;

impl RoadmapDocument {
    /// The roadmap as GraphML: a graph, directed where its edges are, of nodes `n0`, `n1`, ... with their coordinates `q0`, `q1`, ..., and edges
    /// whose `weight` is their length in the metric. Numbers have the fewest digits that parse back to the same bits.
    pub fn to_graphml(&self) -> String {
        let mut xml = String::with_capacity(1024 + 64 * (self.vertices.len() + self.edges.len()));
        let keys = [("scenario", "graph", "string"), ("planner", "graph", "string"), ("metric", "graph", "string")];
        let coordinates: Vec<String> = (0..self.dimension()).map(|i| format!("q{i}")).collect();
        let numbers = coordinates.iter().map(|name| (name.as_str(), "node", "double"));
        xml.push_str("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        xml.push_str("<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n");
        // Writing to a string cannot fail.
        for (name, of, kind) in keys.into_iter().chain(numbers).chain([("weight", "edge", "double")]) {
            let _ = writeln!(xml, "<key id=\"{name}\" for=\"{of}\" attr.name=\"{name}\" attr.type=\"{kind}\"/>");
        }
        let edges = if self.is_directed() { "directed" } else { "undirected" };
        let _ = writeln!(xml, "<graph id=\"roadmap\" edgedefault=\"{edges}\">");
        for (name, text) in [("scenario", &self.scenario), ("planner", &self.planner), ("metric", &self.metric)] {
            let _ = writeln!(xml, "<data key=\"{name}\">{}</data>", escaped(text));
        }
        for (vertex, row) in self.rows().enumerate() {
            let _ = write!(xml, "<node id=\"n{vertex}\">");
            for (name, number) in coordinates.iter().zip(row) {
                let _ = write!(xml, "<data key=\"{name}\">{}</data>", exact(*number, -3));
            }
            xml.push_str("</node>\n");
        }
        for (i, &[from, to]) in self.edges.iter().enumerate() {
            let weight = self.length([from, to]);
            let _ = write!(xml, "<edge id=\"e{i}\" source=\"n{from}\" target=\"n{to}\">");
            let _ = writeln!(xml, "<data key=\"weight\">{}</data></edge>", exact(weight, -3));
        }
        xml.push_str("</graph>\n</graphml>\n");
        xml
    }
}

/// Text as XML 1.0 may hold it: its marks escaped, characters that it cannot hold replaced.
fn escaped(text: &str) -> String {
    let mut xml = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => xml.push_str("&amp;"),
            '<' => xml.push_str("&lt;"),
            '>' => xml.push_str("&gt;"),
            // A reader would make a line feed of it.
            '\r' => xml.push_str("&#13;"),
            '\t' | '\n' => xml.push(character),
            '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => xml.push('\u{fffd}'),
            _ => xml.push(character),
        }
    }
    xml
}
