//! A building of Open-RMF's `traffic_editor` (`*.building.yaml`): the walls of one level.
//!
//! Walls join two vertices of the level each. In the coordinate system `reference_image`, which is the default, vertices
//! are pixels with y down, and `measurements` give metres: the scale is the mean of theirs, as in
//! `rmf_building_map_tools`; there walls are 0.1 m thick, too. Doors are open, unless their layer is chosen. Vertices with
//! names make queries.
//! <https://osrf.github.io/ros2multirobotbook/traffic-editor.html>

use crate::draft::{Draft, DraftQuery};
use crate::error::{Code, FormatError, quoted};
use crate::options::Options;
use crate::report::Format;
use crate::text;
use crate::vector::{Drawing, FillRule, Form, Frame};
use crate::yaml::{self, Node, Value};
use planarium::geometry::Point;
use std::collections::HashSet;

/// The thickness of walls in the worlds that the tools of Open-RMF make, in metres.
const THICKNESS: f64 = 0.1;

/// The most named places that become queries.
const MAX_PLACES: usize = 100;

/// Lists of a level that are no walls and no measurements.
const OTHERS: [(&str, &str); 4] = [
    ("models", "models, whose sizes are in other files"),
    ("fiducials", "fiducials"),
    ("features", "features"),
    ("holes", "holes of floors"),
];

/// Whether text is a building: it has levels, and walls, measurements or floors in them.
pub fn is_building(text: &str) -> bool {
    let has = |key: &str| text.lines().any(|line| line.trim_start().starts_with(key));
    let is_leveled = text.lines().any(|line| line.starts_with("levels:"));
    is_leveled && (has("walls:") || has("measurements:") || has("floors:"))
}

/// A vertex of a level.
struct Vertex<'a> {
    point: Point,
    name: &'a str,
}

/// Reads a building.
pub fn draft(name: &str, text: &str, options: &Options) -> Result<Draft, FormatError> {
    let root = yaml::read(text)?;
    let levels = root.get("levels").map_or(&[][..], Node::pairs);
    let (level_name, level) = choose_level(levels, options)?;
    let vertices = vertices(level)?;
    let mut notes = vec![format!("level {} of {}", quoted(level_name.as_bytes()), levels.len())];
    let frame = frame(&root, level, &vertices, options, &mut notes)?;
    let mut drawing = drawing(level, &vertices, &mut notes)?;
    let queries = queries(&vertices, frame);
    drawing.ends = queries.iter().flat_map(|query| [query.start, query.goal]).map(|[x, y]| Point::new(x, y)).collect();
    let mut draft = drawing.into_draft(Format::RmfBuilding, name, frame, options)?;
    draft.name = root.get("name").or(root.get("building_name")).and_then(Node::text).map_or(draft.name, |building| {
        let level = if levels.len() > 1 { format!(", {level_name}") } else { String::new() };
        format!("{building}{level}")
    });
    draft.queries = queries;
    draft.report.levels = levels.iter().map(|(name, _)| name.clone()).collect();
    draft.report.notes.append(&mut notes);
    Ok(draft)
}

/// The level of the options, or the first.
fn choose_level<'a>(levels: &'a [(String, Node)], options: &Options) -> Result<&'a (String, Node), FormatError> {
    match &options.level {
        None => levels.first().ok_or_else(|| FormatError::new(Code::InvalidFile, "the building has no level")),
        Some(wanted) => levels
            .iter()
            .find(|(name, _)| name == wanted)
            .ok_or_else(|| FormatError::none_of("level", wanted, levels.iter().map(|(name, _)| &**name))),
    }
}

fn invalid(node: &Node, message: impl Into<String>) -> FormatError {
    FormatError::at_line(Code::InvalidFile, node.line, message)
}

/// A finite number.
fn number(node: &Node) -> Result<f64, FormatError> {
    let text = node.text().ok_or_else(|| invalid(node, "a list or a mapping stands where a number is expected"))?;
    text::number(text.as_bytes()).ok_or_else(|| {
        let sentence = format!("{} is not a finite number", quoted(text.as_bytes()));
        FormatError::at_line(Code::InvalidNumber, node.line, sentence)
    })
}

/// The vertices: x, y, z and a name, with parameters.
fn vertices(level: &Node) -> Result<Vec<Vertex<'_>>, FormatError> {
    let vertex = |node: &'_ Node| -> Result<Point, FormatError> {
        let [x, y, ..] = node.items() else { return Err(invalid(node, "a vertex is a list [x, y, z, name]")) };
        Ok(Point::new(number(x)?, number(y)?))
    };
    level
        .list("vertices")
        .iter()
        .map(|node| {
            let name = node.items().get(3).and_then(Node::text).unwrap_or_default();
            Ok(Vertex { point: vertex(node)?, name })
        })
        .collect()
}

/// The vertices that an item names by their numbers, its first two.
fn edge<'a>(node: &Node, vertices: &'a [Vertex<'a>]) -> Result<[&'a Vertex<'a>; 2], FormatError> {
    let [from, to, ..] = node.items() else {
        return Err(invalid(node, "this is a list that begins with the numbers of two vertices"));
    };
    Ok([find(from, vertices)?, find(to, vertices)?])
}

fn find<'a>(node: &Node, vertices: &'a [Vertex<'a>]) -> Result<&'a Vertex<'a>, FormatError> {
    let text = node.text().unwrap_or_default();
    text::count(text.as_bytes()).and_then(|number| vertices.get(number)).ok_or_else(|| {
        let sentence = format!("{} is not the number of one of {} vertices", quoted(text.as_bytes()), vertices.len());
        FormatError::at_line(Code::InvalidNumber, node.line, sentence)
    })
}

/// The way to metres.
fn frame(
    root: &Node,
    level: &Node,
    vertices: &[Vertex],
    options: &Options,
    notes: &mut Vec<String>,
) -> Result<Frame, FormatError> {
    let system = root.get("coordinate_system").and_then(Node::text).unwrap_or("reference_image");
    let up = match system {
        "reference_image" => -1.0,
        "cartesian_meters" => 1.0,
        _ => {
            let sentence = format!("the coordinate system {} is not read", quoted(system.as_bytes()));
            return Err(FormatError::new(Code::UnsupportedFeature, sentence));
        }
    };
    let mut scales = Vec::new();
    for node in level.list("measurements") {
        let [from, to] = edge(node, vertices)?.map(|vertex| vertex.point);
        let metres = node.items().get(2).and_then(|parameters| parameters.get("distance"));
        let Some(metres) = metres.and_then(|distance| distance.items().get(1)) else {
            return Err(invalid(node, "a measurement has a distance"));
        };
        let scale = number(metres)? / (to.x - from.x).hypot(to.y - from.y);
        if !(scale.is_finite() && scale > 0.0) {
            return Err(FormatError::at_line(
                Code::InvalidNumber,
                node.line,
                "the measurement is between places that do not differ, or its distance is not positive",
            ));
        }
        scales.push(scale);
    }
    let mean = scales.iter().sum::<f64>() / scales.len() as f64;
    let scale = match (options.scale, up > 0.0, scales.is_empty()) {
        (Some(scale), ..) => {
            notes.push(format!("{scale} m per unit, as chosen"));
            scale
        }
        (None, true, _) => 1.0,
        (None, false, true) => {
            notes.push("the level has no measurement: a pixel is 1 m, unless a scale is chosen".to_owned());
            1.0
        }
        (None, false, false) => {
            let [low, high] = [f64::min, f64::max].map(|of: fn(f64, f64) -> f64| scales.iter().copied().fold(mean, of));
            let count = scales.len();
            notes.push(format!("{mean} m per pixel, the mean of {count} measurements from {low} to {high}"));
            mean
        }
    };
    Ok(Frame { origin: Point::origin(), scale: [scale, up * scale] })
}

/// Walls, doors and floors, each on a layer.
fn drawing(level: &Node, vertices: &[Vertex], notes: &mut Vec<String>) -> Result<Drawing, FormatError> {
    let mut drawing = Drawing::new();
    drawing.wall_thickness = THICKNESS;
    for (key, omitted) in [("walls", None), ("doors", Some("doors are open"))] {
        let layer = drawing.layer(key);
        drawing.layer_mut(layer).omitted = omitted;
        for node in level.list(key) {
            let points = edge(node, vertices)?.map(|vertex| vertex.point).to_vec();
            drawing.push(layer, Form::Line { points, closed: false, width: None });
        }
    }
    let layer = drawing.layer("floors");
    drawing.layer_mut(layer).omitted = Some("floors are no obstacles");
    for node in level.list("floors") {
        let numbers = node.list("vertices");
        let ring = numbers.iter().map(|number| Ok(find(number, vertices)?.point)).collect::<Result<Vec<_>, _>>()?;
        drawing.push(layer, Form::Area { rings: vec![ring], rule: FillRule::NonZero });
    }
    for (key, what) in OTHERS {
        drawing.drop(what, level.list(key).len());
    }
    notes.push(format!("walls are {THICKNESS} m thick unless chosen otherwise, with round ends"));
    let lanes = level.list("lanes").len();
    if lanes > 0 {
        notes.push(format!("{lanes} lanes of robots are not read; named vertices make queries"));
    }
    if let Some(picture) = level.get("drawing").and_then(|drawing| drawing.get("filename")?.text()) {
        notes.push(format!("the picture {} is not needed", quoted(picture.as_bytes())));
    }
    if level.get("vertices").is_some_and(|node| !matches!(node.value, Value::List(_))) {
        notes.push("the vertices are no list".to_owned());
    }
    Ok(drawing)
}

/// From each named vertex to the next.
fn queries(vertices: &[Vertex], frame: Frame) -> Vec<DraftQuery> {
    let mut seen = HashSet::new();
    let named = vertices.iter().filter(|vertex| !vertex.name.is_empty() && seen.insert(vertex.name));
    let places: Vec<&Vertex> = named.take(MAX_PLACES).collect();
    let metres = |vertex: &Vertex| {
        let p = frame.to_metres(vertex.point);
        [p.x, p.y]
    };
    let query = |pair: &[&Vertex]| {
        let name = format!("{} to {}", pair[0].name, pair[1].name);
        DraftQuery::new(name, metres(pair[0]), metres(pair[1]))
    };
    places.windows(2).map(query).collect()
}
