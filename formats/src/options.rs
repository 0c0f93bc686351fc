//! What a file does not say: the robot, a query, and how doubtful cells are read.

use planarium::json::by_type;
use serde::Deserialize;

/// How files are read. The default leaves everything to the files. As JSON it is an object with these names; what is
/// absent has its default.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify), tsify(rename = "WorldOptions"))]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// The robot; by default that of the format, or a point.
    #[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), tsify(type = "WorldRobot"))]
    pub robot: RobotChoice,
    /// By how much the robot is planned for as larger on all sides, in metres, from 0 to 1e6: the `margin` of its document.
    pub margin: f64,
    /// The start of a further query, the first of the scenario: x and y, and for robots that turn theta (0 if it is
    /// absent), in metres and radians, in the coordinates of the file. Together with `goal`.
    #[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), tsify(type = "readonly number[]"))]
    pub start: Option<Vec<f64>>,
    /// The goal of that query.
    #[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), tsify(type = "readonly number[]"))]
    pub goal: Option<Vec<f64>>,
    /// What unknown cells are.
    pub unknown: Unknown,
    /// Of pictures without metadata, the brightness from 0 to 1 from which a cell is free (0.5 by default); of grids of
    /// numbers, the number from which a cell is occupied (by default they may contain 0 and 1 only, and -1 for
    /// unknown).
    pub threshold: Option<f64>,
    /// Metres per cell, for grids and pictures that do not say it; 1 by default.
    pub scale: Option<f64>,
    /// Islands of fewer occupied cells than this are dropped. Cells that touch at a side or a corner are one island.
    pub min_island: usize,
    /// How far in metres obstacles of grids may grow so that there are fewer of them: blocks of cells become occupied
    /// if any of theirs is. 0, the default, keeps every cell.
    pub simplify: f64,
    /// Of drawings, the names of the layers that are read; by default those that the file shows, without doors and
    /// floors where a format tells them apart.
    pub layers: Option<Vec<String>>,
    /// Of drawings, the thickness in metres of lines without a width; by default that of the format, mostly 0.
    pub wall_thickness: Option<f64>,
    /// Of drawings, the farthest in metres that curves may grow when they become polygons; by default [`TOLERANCE`], and
    /// a thousandth of the drawing if that is less, or if there would be too many vertices else.
    pub tolerance: Option<f64>,
    /// Of drawings whose closed lines are no areas (DXF), the names of the layers where they are filled; `*` is every
    /// layer. Else they are walls around what is free.
    pub fill: Vec<String>,
    /// Of drawings, whether areas are where the robot may be, and all else is an obstacle; by default they are if the
    /// file is one polygon with holes.
    pub walkable: Option<bool>,
    /// Of GeoJSON, which features are read, by their properties.
    pub filters: Vec<Filter>,
    /// Of buildings, the name of the level; by default the first.
    pub level: Option<String>,
    /// Of GeoJSON, whether coordinates are degrees.
    pub coordinates: Coordinates,
}

/// How far curves may grow by default, in metres.
pub const TOLERANCE: f64 = 1e-3;

/// A condition on a property of features. Of those that keep the same key, one must hold.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct Filter {
    /// The name of the property.
    pub key: String,
    /// Its value, as text.
    pub value: String,
    /// Whether features with the value are kept; else they are left out.
    #[serde(default = "kept")]
    pub keep: bool,
}

fn kept() -> bool {
    true
}

impl std::str::FromStr for Filter {
    type Err = String;

    /// Reads `KEY=VALUE` or `KEY!=VALUE`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (key, value) = text.split_once('=').ok_or("a filter is KEY=VALUE or KEY!=VALUE")?;
        let (key, keep) = key.strip_suffix('!').map_or((key, true), |key| (key, false));
        Ok(Self { key: key.to_owned(), value: value.to_owned(), keep })
    }
}

/// What the coordinates of a file are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
#[serde(rename_all = "snake_case")]
pub enum Coordinates {
    /// Degrees if the file says so, or if they are possible and at most one degree apart.
    #[default]
    Auto,
    /// Longitude and latitude, in degrees.
    Degrees,
    /// x and y, in metres unless a scale is given.
    Metres,
}

/// What unknown cells are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
#[serde(rename_all = "snake_case")]
pub enum Unknown {
    /// Obstacles.
    #[default]
    Occupied,
    /// Free.
    Free,
}

/// The robot of the scenario. Lengths in metres, angles in radians.
///
/// As JSON `{"type": "point"}`, `{"type": "disc", "radius": r}`, `{"type": "footprint", "corners": [[x, y], ...]}` or
/// `{"type": "car", "length": l, "width": w}`, with `wheelbase` (0.6 of the length) and `steering` (0.6).
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(from = "Document")]
#[non_exhaustive]
pub enum RobotChoice {
    /// The robot that the format defines, such as the car of parking cases; else a point.
    #[default]
    Format,
    /// A disc; a point if the radius is 0.
    Disc {
        /// The radius.
        radius: f64,
    },
    /// A polygon that moves and turns about the origin.
    Footprint {
        /// Its corners in order.
        corners: Vec<[f64; 2]>,
    },
    /// A rectangular car; its place is the middle of the rear axle.
    Car {
        /// From bumper to bumper.
        length: f64,
        /// From side to side.
        width: f64,
        /// Between the axles, which are as far from the bumpers as each other.
        wheelbase: f64,
        /// The largest steering angle to either side.
        steering: f64,
    },
}

impl RobotChoice {
    /// A car of a length and a width. The wheelbase is 0.6 of the length by default, the steering 0.6 rad.
    pub fn car([length, width]: [f64; 2], wheelbase: Option<f64>, steering: Option<f64>) -> Self {
        let [wheelbase, steering] = [wheelbase.unwrap_or(0.6 * length), steering.unwrap_or(0.6)];
        Self::Car { length, width, wheelbase, steering }
    }

    /// A rectangle about the origin: its extent along the heading, and across.
    pub fn rectangle(length: f64, width: f64) -> Self {
        let [x, y] = [length / 2.0, width / 2.0];
        Self::Footprint { corners: vec![[-x, -y], [x, -y], [x, y], [-x, y]] }
    }
}

/// A robot as JSON.
enum Document {
    Point(Point),
    Disc(Disc),
    Footprint(Footprint),
    Car(Car),
}

by_type!(Document { "point" => Point, "disc" => Disc, "footprint" => Footprint, "car" => Car });

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Point {}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Disc {
    radius: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Footprint {
    corners: Vec<[f64; 2]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Car {
    length: f64,
    width: f64,
    wheelbase: Option<f64>,
    steering: Option<f64>,
}

impl From<Document> for RobotChoice {
    fn from(robot: Document) -> Self {
        match robot {
            Document::Point(Point {}) => Self::Disc { radius: 0.0 },
            Document::Disc(Disc { radius }) => Self::Disc { radius },
            Document::Footprint(Footprint { corners }) => Self::Footprint { corners },
            Document::Car(Car { length, width, wheelbase, steering }) => {
                Self::car([length, width], wheelbase, steering)
            }
        }
    }
}
