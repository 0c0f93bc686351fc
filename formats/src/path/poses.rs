//! Poses as ROS prints and reads them: `nav_msgs/Path`, or a list of `geometry_msgs/PoseStamped` or `Pose`, as YAML or JSON; and
//! lists of lists of numbers.

use super::{MAX_WAYPOINTS, PathFormat, Places, Rows};
use crate::error::{Code, FormatError, Place, quoted};
use crate::report::Dropped;
use crate::yaml::{self, Node, Value};

/// The longest text that becomes a tree, in bytes: a tree takes some ten times its memory.
const MAX_TEXT: usize = 16 << 20;

/// Whether text is YAML of poses: a line at its beginning is one of theirs.
pub fn is_yaml(text: &str) -> bool {
    let begin = text.char_indices().nth(4096).map_or(text, |(end, _)| &text[..end]);
    begin.lines().any(|line| {
        let line = line.trim_start_matches(['-', ' ']);
        ["poses:", "header:", "pose:", "position:"].iter().any(|key| line.starts_with(key))
    })
}

/// Reads YAML.
///
/// # Errors
/// `world-too-large`, `truncated`, `invalid-file`, `invalid-number`, with the line
pub fn of_yaml(text: &str) -> Result<Rows, FormatError> {
    let mut rows = rows(&yaml::tree(text, MAX_TEXT)?)?;
    if text.lines().skip(1).any(|line| line.trim_end() == "---")
        && text.split("\n---").nth(1).is_some_and(|rest| !rest.trim().is_empty())
    {
        rows.notes.push("more documents follow in the file; the first is read".to_owned());
    }
    Ok(rows)
}

/// Reads JSON.
///
/// # Errors
/// `world-too-large`, `truncated`, `invalid-file`, `invalid-number`, with the line or the element
pub fn of_json(text: &str) -> Result<Rows, FormatError> {
    if text.len() > MAX_TEXT {
        let sentence = format!("the JSON file has {} bytes; at most {MAX_TEXT} are read", text.len());
        return Err(FormatError::new(Code::WorldTooLarge, sentence));
    }
    let value = serde_json::from_str(text).map_err(|error| FormatError::of_json(&error, "JSON"))?;
    rows(&node(value))
}

/// JSON as the tree of YAML, without lines.
fn node(value: serde_json::Value) -> Node {
    let value = match value {
        serde_json::Value::Array(items) => Value::List(items.into_iter().map(node).collect()),
        serde_json::Value::Object(pairs) => {
            Value::Mapping(pairs.into_iter().map(|(key, value)| (key, node(value))).collect())
        }
        serde_json::Value::String(text) => Value::Scalar(text),
        other => Value::Scalar(other.to_string()),
    };
    Node { line: 0, value }
}

/// The poses of a tree, or its rows.
fn rows(root: &Node) -> Result<Rows, FormatError> {
    let list = match root.get("poses") {
        Some(poses) => poses,
        None if root.get("path").is_some_and(|path| !path.items().is_empty()) => return numbers(root.list("path")),
        None => root,
    };
    let items = match &list.value {
        Value::List(items) => items,
        _ => {
            let sentence = "there are no poses: a path has \"poses\", or is a list of poses or of configurations";
            return Err(FormatError::new(Code::UnknownWorld, sentence));
        }
    };
    if items.first().is_some_and(|item| matches!(item.value, Value::List(_))) {
        return numbers(items);
    }
    let mut poses = Poses::default();
    for (i, item) in items.iter().enumerate() {
        poses.add(item).map_err(|error| {
            // A line says more than a number.
            if item.line > 0 {
                error.at_or(|| Place::Line(item.line))
            } else {
                error.at(Place::Element(format!("pose {i}")))
            }
        })?;
        if i == MAX_WAYPOINTS {
            let sentence = format!("there are more than {MAX_WAYPOINTS} poses, the most that are read");
            return Err(FormatError::new(Code::WorldTooLarge, sentence));
        }
    }
    Ok(poses.rows(frame_id(root).or_else(|| frame_id(items.first()?)), items))
}

/// The frame that a header names, or a pose itself.
fn frame_id(node: &Node) -> Option<String> {
    node.get("header").unwrap_or(node).get("frame_id")?.text().filter(|id| !id.is_empty()).map(str::to_owned)
}

#[derive(Default)]
struct Poses {
    numbers: Vec<f64>,
    heights: usize,
    tilted: usize,
    /// How many have no orientation: then none is read.
    without: usize,
}

impl Poses {
    fn add(&mut self, item: &Node) -> Result<(), FormatError> {
        if item.text() == Some("...") {
            let sentence = "the list is cut short by \"...\": ros2 topic echo prints all of it with --full-length";
            return Err(FormatError::new(Code::Truncated, sentence));
        }
        let mut pose = item;
        while let Some(inner) = pose.get("pose") {
            pose = inner;
        }
        let Some(position) = pose.get("position") else {
            return Err(FormatError::new(Code::InvalidFile, "a pose has a position"));
        };
        let [x, y, z] = ["x", "y", "z"].map(|key| number(position, key));
        let (Some(x), Some(y)) = (x?, y?) else {
            return Err(FormatError::new(Code::InvalidFile, "a position has x and y"));
        };
        self.heights += usize::from(z?.is_some_and(|z| z != 0.0));
        let mut theta = f64::NAN;
        match pose.get("orientation") {
            None => self.without += 1,
            Some(orientation) => {
                let part = |key: &str| number(orientation, key).map(|part| part.unwrap_or(0.0));
                let [x, y, z, w] = [part("x")?, part("y")?, part("z")?, part("w")?];
                if x == 0.0 && y == 0.0 && z == 0.0 && w == 0.0 {
                    self.without += 1;
                } else {
                    self.tilted += usize::from(x != 0.0 || y != 0.0);
                    theta = libm::atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z);
                }
            }
        }
        self.numbers.extend([x, y, theta]);
        Ok(())
    }

    fn rows(self, frame: Option<String>, items: &[Node]) -> Rows {
        let dropped = [
            ("heights", self.heights),
            ("tilts of orientations", self.tilted),
            ("orientations that are absent or zero", self.without),
        ];
        let mut names = vec!["x".to_owned(), "y".to_owned(), "theta [rad]".to_owned()];
        let mut numbers = self.numbers;
        if self.without == items.len() {
            names.pop();
            numbers = numbers.chunks_exact(3).flat_map(|pose| [pose[0], pose[1]]).collect();
        }
        Rows {
            format: PathFormat::Poses,
            width: names.len(),
            names: Some(names),
            numbers,
            places: places(items, "pose"),
            dropped: Dropped::counted(dropped),
            notes: frame
                .map(|id| format!("the poses are in the frame {}", quoted(id.as_bytes())))
                .into_iter()
                .collect(),
        }
    }
}

/// Where items are: on lines, if these are known.
fn places(items: &[Node], name: &'static str) -> Places {
    match items.first() {
        Some(first) if first.line > 0 => Places::Lines(items.iter().map(|item| item.line).collect()),
        _ => Places::Elements(name),
    }
}

/// The number of a key; `None` if it is not there.
fn number(node: &Node, key: &str) -> Result<Option<f64>, FormatError> {
    let Some(own) = node.get(key) else { return Ok(None) };
    parsed(own).map(Some)
}

fn parsed(node: &Node) -> Result<f64, FormatError> {
    let at = |error: FormatError| if node.line > 0 { error.at(Place::Line(node.line)) } else { error };
    let text = node.text().unwrap_or("a list or a mapping");
    let plain = text.strip_prefix('.').filter(|word| !word.starts_with(|c: char| c.is_ascii_digit())).unwrap_or(text);
    match plain.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err(at(FormatError::new(Code::InvalidNumber, format!("{text} is not finite")))),
        Err(_) => Err(at(FormatError::new(Code::InvalidFile, format!("{} is no number", quoted(text.as_bytes()))))),
    }
}

/// Lists of numbers, all as long as the first.
fn numbers(items: &[Node]) -> Result<Rows, FormatError> {
    let width = items.first().map_or(0, |row| row.items().len());
    let mut numbers = Vec::with_capacity(width * items.len());
    for (i, row) in items.iter().enumerate() {
        let at = |error: FormatError| error.at_or(|| Place::Element(format!("row {i}")));
        if row.items().len() != width || width == 0 {
            let sentence = format!("the row has {} numbers, but the first has {width}", row.items().len());
            return Err(at(FormatError::new(Code::InvalidFile, sentence)));
        }
        for cell in row.items() {
            numbers.push(parsed(cell).map_err(at)?);
        }
    }
    Ok(Rows::plain(PathFormat::Rows, None, width, numbers, Places::Elements("row")))
}
