//! Paths of any origin: waypoints as tables, arrays, GeoJSON and messages of ROS.

mod columns;
mod object;
mod poses;
mod positions;
mod table;

pub use columns::Robot as RobotColumns;

use crate::error::{Code, FormatError, Place, quoted};
use crate::npy;
use crate::report::Dropped;
use crate::text;
use crate::{File, MAX_BYTES};
use columns::Robot;
use planarium::scenario::MapFrame;
use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};
use std::fmt;

/// The most waypoints that are read: as many as are judged.
pub const MAX_WAYPOINTS: usize = planarium::path::MAX_WAYPOINTS;

/// The unit of angles for which a file names none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
#[serde(rename_all = "snake_case")]
pub enum Angles {
    /// Degrees.
    Degrees,
    /// Radians.
    Radians,
}

/// How a path is read.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PathOptions {
    /// The unit of angles for which the file names none. By default they are radians, and refused if they look like degrees: if
    /// one is larger than two turns, and none larger than 360.
    pub angles: Option<Angles>,
}

/// The form of a path, as a stable kebab-case word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, strum::IntoStaticStr)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum PathFormat {
    /// Rows of numbers as text, with names of columns or without.
    Table,
    /// A NumPy array, a row for each waypoint.
    Npy,
    /// A line or points of GeoJSON.
    #[serde(rename = "geojson")]
    #[strum(serialize = "geojson")]
    GeoJson,
    /// Poses of ROS as YAML or JSON: `nav_msgs/Path`, or a list of `PoseStamped` or `Pose`.
    Poses,
    /// A list of lists of numbers as JSON.
    Rows,
    /// An object of columns as JSON, each with its unit.
    Columns,
}

/// A path that was read.
#[derive(Debug, Clone, PartialEq)]
pub struct PathRead {
    /// The waypoints: configurations of the robot, in the coordinates of the scenario, in metres and radians.
    pub waypoints: Vec<Vec<f64>>,
    /// What was read and left out.
    pub report: PathReport,
}

/// The report about a path that was read.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
pub struct PathReport {
    /// The form.
    pub format: PathFormat,
    /// The number of waypoints.
    pub waypoints: usize,
    /// The columns, in the order of the file.
    pub columns: Vec<ColumnRead>,
    /// What was left out beside columns.
    pub dropped: Vec<Dropped>,
    /// What was subtracted from every coordinate, in metres, to come from the map to the scenario.
    pub offset: [f64; 2],
    /// What else should be known, a sentence each.
    pub notes: Vec<String>,
}

/// A column of a path.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify), tsify(missing_as_null))]
pub struct ColumnRead {
    /// Its name in the file, or its number from 1.
    pub name: String,
    /// What it is: `x`, `theta`, `joint 0`; `None` if it was left out.
    pub meaning: Option<String>,
    /// Its unit: `m`, `rad`, `deg`, ...; empty for what has none.
    pub unit: &'static str,
}

impl fmt::Display for PathReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let format: &str = self.format.into();
        write!(f, "read {format}: {} waypoints of", self.waypoints)?;
        for (i, column) in self.columns.iter().filter(|column| column.meaning.is_some()).enumerate() {
            let ColumnRead { name, meaning, unit } = column;
            let meaning = meaning.as_deref().unwrap_or_default();
            write!(f, "{} {meaning} [{unit}]", if i == 0 { "" } else { "," })?;
            if name != meaning {
                write!(f, " ({})", quoted(name.as_bytes()))?;
            }
        }
        let left: Vec<String> =
            self.columns.iter().filter(|column| column.meaning.is_none()).map(|c| quoted(c.name.as_bytes())).collect();
        if !left.is_empty() {
            write!(f, "\nleft out: the columns {}", left.join(", "))?;
        }
        for Dropped { what, count, .. } in &self.dropped {
            write!(f, "\ndropped: {count} {what}")?;
        }
        if self.offset != [0.0; 2] {
            write!(f, "\nmoved: {:?} was subtracted from every position, as from the map", self.offset)?;
        }
        self.notes.iter().try_for_each(|note| write!(f, "\nnote: {note}"))
    }
}

/// What a reader has found: rows of numbers.
struct Rows {
    format: PathFormat,
    /// The names of the columns, if the file has some.
    names: Option<Vec<String>>,
    width: usize,
    /// Row by row.
    numbers: Vec<f64>,
    places: Places,
    dropped: Vec<Dropped>,
    notes: Vec<String>,
}

/// Where rows are in their file.
enum Places {
    /// Each on a line, from 1.
    Lines(Vec<usize>),
    /// Each an element with this name.
    Elements(&'static str),
}

impl Rows {
    /// Rows without anything left out.
    fn plain(format: PathFormat, names: Option<Vec<String>>, width: usize, numbers: Vec<f64>, places: Places) -> Self {
        Self { format, names, width, numbers, places, dropped: Vec::new(), notes: Vec::new() }
    }
}

impl Places {
    fn of(&self, row: usize) -> Place {
        match self {
            Self::Lines(lines) => Place::Line(lines.get(row).copied().unwrap_or_default()),
            Self::Elements(name) => Place::Element(format!("{name} {row}")),
        }
    }
}

/// Reads a path for a robot, in the coordinates of the map of its scenario: see [`MapFrame`]. The content decides which
/// form it is.
///
/// Tables have a row for each waypoint, its numbers between tabs, commas, semicolons or blanks. Columns are known by their names:
/// `x`, `y` and `theta` (or `yaw`, `heading`), `lon` and `lat`, `qz` and `qw` of a quaternion, `joint_0` or `q0` and so on;
/// with a unit as in `theta_deg`, `theta [deg]` or `x (mm)`. Without names they are a configuration, with a time before it if
/// there is one more and it grows.
///
/// # Errors
/// `unknown-world` if it is no path; `truncated`, `invalid-file` and `invalid-number` with the line or the element;
/// `wrong-columns` if the robot needs other columns; `invalid-option` if angles look like degrees and nothing says what
/// they are; `world-too-large` for more than [`MAX_WAYPOINTS`].
///
/// # Complexity
/// Linear in the size of the file.
///
/// ```
/// use planarium::robot::DiscRobot;
/// use planarium_formats::{File, MapFrame, PathOptions, read_path};
///
/// let robot = DiscRobot::new(0.2).expect("a radius").into();
/// let file = File { name: "path.csv", bytes: b"t,x [cm],y [cm]\n0,100,50\n1,200,50\n" };
/// let path = read_path(file, &robot, &MapFrame::default(), &PathOptions::default())?;
/// assert_eq!(path.waypoints, [[1.0, 0.5], [2.0, 0.5]]);
/// # Ok::<(), planarium_formats::FormatError>(())
/// ```
pub fn read_path(
    file: File<'_>,
    robot: &planarium::scenario::Robot,
    frame: &MapFrame,
    options: &PathOptions,
) -> Result<PathRead, FormatError> {
    rows(file.bytes, frame)
        .and_then(|rows| columns::assembled(rows, &Robot::of(robot), frame, options))
        .map_err(|error| error.in_file(file.name))
}

/// Whether bytes are a path of another program rather than a document of Planarium: anything but a JSON object, and an
/// object that is GeoJSON or has `poses` or `columns`, or a `path` and no `scenario`.
pub fn is_path(bytes: &[u8]) -> bool {
    #[derive(serde::Deserialize)]
    struct Head {
        poses: Option<IgnoredAny>,
        columns: Option<IgnoredAny>,
        path: Option<IgnoredAny>,
        scenario: Option<IgnoredAny>,
        format: Option<IgnoredAny>,
    }
    let bytes = text::without_mark(bytes);
    if !bytes.trim_ascii_start().starts_with(b"{") || crate::geojson::is_geojson(bytes) {
        return true;
    }
    match serde_json::from_slice::<Head>(bytes) {
        Ok(head) => {
            let has_rows = head.poses.is_some() || head.columns.is_some();
            head.format.is_none() && (has_rows || (head.path.is_some() && head.scenario.is_none()))
        }
        Err(_) => bytes[..bytes.len().min(4096)].windows(7).any(|window| window == b"\"poses\""),
    }
}

fn rows(bytes: &[u8], frame: &MapFrame) -> Result<Rows, FormatError> {
    let bytes = text::without_mark(bytes);
    if bytes.trim_ascii().is_empty() {
        return Err(FormatError::new(Code::Truncated, "the file is empty"));
    }
    if bytes.len() > MAX_BYTES {
        let sentence = format!("the file has more than {MAX_BYTES} bytes, which are the most that are read");
        return Err(FormatError::new(Code::WorldTooLarge, sentence));
    }
    if bytes.starts_with(npy::MAGIC) {
        let table = npy::read(bytes).map_err(|message| FormatError::new(Code::InvalidFile, message))?;
        return Ok(Rows::plain(PathFormat::Npy, None, table.width, table.numbers, Places::Elements("row")));
    }
    let Ok(text) = std::str::from_utf8(bytes) else {
        return Err(FormatError::new(Code::UnknownWorld, "this is neither text nor a NumPy array"));
    };
    match text.trim_start().as_bytes().first() {
        Some(b'{' | b'[') if crate::geojson::is_geojson(bytes) => positions::rows(bytes, frame),
        Some(b'{') if object::is_object(text) => object::rows(text),
        Some(b'{' | b'[') => poses::of_json(text),
        _ if poses::is_yaml(text) => poses::of_yaml(text),
        _ => table::rows(bytes),
    }
}
