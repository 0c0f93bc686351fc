//! The roadmap for other programs: GraphML (Brandes, Eiglsperger, Lerner and Pich 2013, "Graph markup language"), which
//! networkx, igraph, Gephi and yEd read. It is only written: it has no checksum and proves nothing.

use super::RoadmapDocument;
use quick_xml::escape::partial_escape;

impl RoadmapDocument {
    /// The roadmap as GraphML: a graph, directed if its edges are, of nodes `n0`, `n1`, ... with their coordinates `q0`, `q1`,
    /// ..., and edges whose `weight` is their length in the metric. Numbers have the fewest digits that parse back to the same
    /// bits. O(vertices + edges).
    pub fn to_graphml(&self) -> String {
        let mut xml = String::with_capacity(1024 + 64 * self.edges.len());
        xml +=
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
        let coordinates: Vec<String> = (0..self.dimension()).map(|i| format!("q{i}")).collect();
        let texts = [("scenario", &self.scenario), ("planner", &self.planner), ("metric", &self.metric.to_string())];
        let keys = texts.iter().map(|(name, _)| (*name, "graph", "string"));
        let keys = keys.chain(coordinates.iter().map(|name| (name.as_str(), "node", "double")));
        for (name, of, kind) in keys.chain([("weight", "edge", "double")]) {
            xml += &format!("<key id=\"{name}\" for=\"{of}\" attr.name=\"{name}\" attr.type=\"{kind}\"/>\n");
        }
        let kind = if self.is_directed() { "directed" } else { "undirected" };
        xml += &format!("<graph id=\"roadmap\" edgedefault=\"{kind}\">\n");
        for (name, text) in texts {
            xml += &format!("{}\n", data(name, &escaped(text)));
        }
        for (i, row) in self.rows().enumerate() {
            let numbers = coordinates.iter().zip(row).map(|(name, number)| data(name, &format!("{number:?}")));
            xml += &format!("<node id=\"n{i}\">{}</node>\n", numbers.collect::<String>());
        }
        for (i, &[from, to]) in self.edges.iter().enumerate() {
            let weight = data("weight", &format!("{:?}", self.length([from, to])));
            xml += &format!("<edge id=\"e{i}\" source=\"n{from}\" target=\"n{to}\">{weight}</edge>\n");
        }
        xml + "</graph>\n</graphml>\n"
    }
}

/// The value of an attribute.
fn data(name: &str, value: &str) -> String {
    format!("<data key=\"{name}\">{value}</data>")
}

/// Text for XML 1.0. Characters that it cannot hold become U+FFFD.
fn escaped(text: &str) -> String {
    let is_foreign =
        |c: char| matches!(c, '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}') && !matches!(c, '\t' | '\n' | '\r');
    let text = text.replace(is_foreign, "\u{fffd}");
    // A reader would turn a carriage return into a line feed.
    partial_escape(text).replace('\r', "&#13;")
}
