//! The roadmap for other programs: GraphML (Brandes, Eiglsperger, Lerner and Pich 2013, "Graph markup language"), which
//! networkx, igraph, Gephi and yEd read. It is written only: it holds no checksum and proves nothing.

use super::RoadmapDocument;
use quick_xml::Writer;
use quick_xml::escape::partial_escape;
use quick_xml::events::{BytesDecl, BytesText, Event};
use std::io;

/// A writer into memory.
type Xml = Writer<Vec<u8>>;

impl RoadmapDocument {
    /// The roadmap as GraphML: a graph, directed if its edges are, of nodes `n0`, `n1`, ... with their coordinates `q0`, `q1`,
    /// ..., and edges whose `weight` is their length in the metric. Numbers have the fewest digits that parse back to the same
    /// bits. O(vertices + edges).
    pub fn to_graphml(&self) -> String {
        let mut xml = Writer::new(Vec::with_capacity(1024 + 64 * self.edges.len()));
        self.write_graphml(&mut xml).expect("writing to memory does not fail");
        String::from_utf8(xml.into_inner()).expect("only text was written") + "\n"
    }

    fn write_graphml(&self, xml: &mut Xml) -> io::Result<()> {
        xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
        line(xml);
        let graphml = xml.create_element("graphml").with_attribute(("xmlns", "http://graphml.graphdrawing.org/xmlns"));
        graphml.write_inner_content(|xml| {
            line(xml);
            let coordinates: Vec<String> = (0..self.dimension()).map(|i| format!("q{i}")).collect();
            for name in ["scenario", "planner", "metric"] {
                key(xml, name, "graph", "string")?;
            }
            for name in &coordinates {
                key(xml, name, "node", "double")?;
            }
            key(xml, "weight", "edge", "double")?;
            let kind = if self.is_directed() { "directed" } else { "undirected" };
            let graph = xml.create_element("graph").with_attributes([("id", "roadmap"), ("edgedefault", kind)]);
            graph.write_inner_content(|xml| self.write_graph(xml, &coordinates))?;
            line(xml);
            Ok(())
        })?;
        Ok(())
    }

    fn write_graph(&self, xml: &mut Xml, coordinates: &[String]) -> io::Result<()> {
        line(xml);
        let metric = self.metric.to_string();
        for (name, text) in [("scenario", &self.scenario), ("planner", &self.planner), ("metric", &metric)] {
            data(xml, name, text)?;
            line(xml);
        }
        for (i, row) in self.rows().enumerate() {
            let node = xml.create_element("node").with_attribute(("id", format!("n{i}").as_str()));
            node.write_inner_content(|xml| {
                coordinates.iter().zip(row).try_for_each(|(name, number)| data(xml, name, &format!("{number:?}")))
            })?;
            line(xml);
        }
        for (i, &edge) in self.edges.iter().enumerate() {
            let [id, from, to] = [format!("e{i}"), format!("n{}", edge[0]), format!("n{}", edge[1])];
            let ends = [("id", id.as_str()), ("source", from.as_str()), ("target", to.as_str())];
            let element = xml.create_element("edge").with_attributes(ends);
            element.write_inner_content(|xml| data(xml, "weight", &format!("{:?}", self.length(edge))))?;
            line(xml);
        }
        Ok(())
    }
}

/// Declares an attribute of nodes, edges or the graph.
fn key(xml: &mut Xml, name: &str, of: &str, kind: &str) -> io::Result<()> {
    let attributes = [("id", name), ("for", of), ("attr.name", name), ("attr.type", kind)];
    xml.create_element("key").with_attributes(attributes).write_empty()?;
    line(xml);
    Ok(())
}

/// Ends a line of the file.
fn line(xml: &mut Xml) {
    xml.get_mut().push(b'\n');
}

/// Writes the value of an attribute. Characters that XML 1.0 cannot hold become U+FFFD.
fn data(xml: &mut Xml, name: &str, text: &str) -> io::Result<()> {
    let is_foreign =
        |c: char| matches!(c, '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}') && !matches!(c, '\t' | '\n' | '\r');
    let text = text.replace(is_foreign, "\u{fffd}");
    // A reader would turn a carriage return into a line feed.
    let text = partial_escape(text).replace('\r', "&#13;");
    xml.create_element("data")
        .with_attribute(("key", name))
        .write_text_content(BytesText::from_escaped(text))
        .map(|_| ())
}
