//! Paths in the forms that other programs read, in the coordinates of the map that the scenario was read from.

mod columns;
mod geojson;
mod poses;
mod route_graph;
mod svg;
mod table;

use crate::error::{Code, FormatError, Place, quoted};
use crate::npy;
use crate::path::MAX_WAYPOINTS;
use columns::Table;
use planarium::scenario::{Robot, Scenario};
use serde::Deserialize;

pub use route_graph::{RouteWriteOptions, write_route_graph};

/// The form of a path that is written, as a stable kebab-case word.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Deserialize, strum::IntoStaticStr, strum::EnumString, strum::VariantArray,
)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum PathForm {
    /// A row a line; the first line has the names of the columns with their units.
    Csv,
    /// An object of columns, each with its unit.
    Json,
    /// A NumPy array of two dimensions, 64-bit numbers: the time if there is one, and the configuration.
    Npy,
    /// A line with its start and goal; of robots that turn and of timed paths, a point for each row, with its heading and time.
    #[serde(rename = "geojson")]
    #[strum(serialize = "geojson")]
    GeoJson,
    /// A drawing: the obstacles, the path, and the robot along it, in the coordinates of the scenario.
    Svg,
    /// `nav_msgs/Path` of ROS as YAML.
    NavPath,
    /// A list of poses as YAML, each with its frame.
    NavWaypoints,
}

impl PathForm {
    /// All forms.
    pub const ALL: &[PathForm] = <Self as strum::VariantArray>::VARIANTS;

    /// The word for the form.
    pub fn as_str(self) -> &'static str {
        self.into()
    }
}

/// A path in rows. Metres and radians, in the coordinates of the scenario; angles need not be wrapped.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PathRows {
    /// The name of the query.
    pub query: String,
    /// The configurations of the robot, from the start to the goal. All of a disc may have its heading after x and y.
    pub configurations: Vec<Vec<f64>>,
    /// Of a timed path, when and how fast.
    pub timing: Option<RowTiming>,
}

impl PathRows {
    /// Those of a timed path: of each row the time, the configuration and the velocity.
    pub fn timed(query: String, rows: impl IntoIterator<Item = (f64, Vec<f64>, Vec<f64>)>) -> Self {
        let (mut configurations, mut timing) = (Vec::new(), RowTiming::default());
        for (time, configuration, velocity) in rows {
            timing.times.push(time);
            configurations.push(configuration);
            timing.velocities.push(velocity);
        }
        Self { query, configurations, timing: Some(timing) }
    }
}

/// When the robot is at each row of a path, and how fast it is there.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RowTiming {
    /// The times since the start, in seconds.
    pub times: Vec<f64>,
    /// The rates of the coordinates, per second.
    pub velocities: Vec<Vec<f64>>,
}

/// How a path is written.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct WriteOptions {
    /// Of poses of ROS, the name of the frame that they are in; `map` by default.
    pub frame_id: Option<String>,
}

/// Writes a path in the coordinates of the map that the scenario was read from: see [`Scenario::frame`]. Tables, arrays and poses
/// have metres; tables also have longitude and latitude, if the map has. GeoJSON has the units of the map. A drawing has the
/// coordinates of the scenario, with y up.
///
/// [`read_path`](crate::read_path) reads every form but drawings and, of a disc, arrays with a time.
///
/// # Errors
/// `truncated` if there is no row; `wrong-columns` for a row, a time or a velocity with other numbers than the robot has
/// coordinates, of a disc with its heading as the first row has it; `invalid-number` for one that is not finite, and for a time
/// that a stamp of ROS cannot hold; `world-too-large` for more than [`MAX_WAYPOINTS`] rows;
/// `invalid-option` for a form that an arm has not, and for a name of a frame that is empty or has no use.
///
/// # Complexity
/// Linear in the rows; of a drawing, also in the vertices of the obstacles.
///
/// ```
/// use planarium::geometry::{Aabb, Point};
/// use planarium::robot::DiscRobot;
/// use planarium::scenario::{Scenario, World};
/// use planarium_formats::{PathForm, PathRows, WriteOptions, write_path};
///
/// let bounds = Aabb::of(Point::origin(), Point::new(4.0, 2.0));
/// let scenario = Scenario::new("floor", World::new(Some(bounds), []), DiscRobot::new(0.2)?, [])?;
/// let configurations = vec![vec![1.0, 0.5], vec![3.0, 0.25]];
/// let rows = PathRows { query: "across".to_owned(), configurations, timing: None };
/// let bytes = write_path(&scenario, &rows, PathForm::Csv, &WriteOptions::default()).expect("two rows");
/// assert_eq!(bytes, b"x_m,y_m\n1.0,0.5\n3.0,0.25\n");
/// # Ok::<(), planarium::Error>(())
/// ```
pub fn write_path(
    scenario: &Scenario,
    rows: &PathRows,
    form: PathForm,
    options: &WriteOptions,
) -> Result<Vec<u8>, FormatError> {
    check_rows(scenario, rows)?;
    let is_of_ros = matches!(form, PathForm::NavPath | PathForm::NavWaypoints);
    let invalid = |sentence: String| Err(FormatError::new(Code::InvalidOption, sentence));
    if matches!(scenario.robot(), Robot::Arm(_)) && (is_of_ros || form == PathForm::GeoJson) {
        return invalid(format!(
            "an arm has joints and no place, which {} needs: csv, json, npy and svg are for arms",
            form.as_str()
        ));
    }
    let frame_id = match options.frame_id.as_deref() {
        Some(id) if !is_of_ros => {
            return invalid(format!("{} has no frame that could be called {}", form.as_str(), quoted(id.as_bytes())));
        }
        Some("") => return invalid("the name of the frame is empty".to_owned()),
        id => id.unwrap_or("map"),
    };
    Ok(match form {
        PathForm::Csv => table::csv(&Table::of(scenario, rows)).into_bytes(),
        PathForm::Json => table::json(scenario, rows, &Table::of(scenario, rows)).into_bytes(),
        PathForm::Npy => {
            let (width, numbers) = Table::of(scenario, rows).numbers();
            npy::write(width, &numbers)
        }
        PathForm::GeoJson => geojson::write(scenario, rows).into_bytes(),
        PathForm::Svg => svg::write(scenario, rows).into_bytes(),
        PathForm::NavPath => poses::path(scenario, rows, frame_id)?.into_bytes(),
        PathForm::NavWaypoints => poses::waypoints(scenario, rows, frame_id).into_bytes(),
    })
}

/// Refuses rows that do not fit the robot.
fn check_rows(scenario: &Scenario, rows: &PathRows) -> Result<(), FormatError> {
    let PathRows { configurations, timing, .. } = rows;
    let count = configurations.len();
    if count == 0 {
        return Err(FormatError::new(Code::Truncated, "the path has no row"));
    }
    if count > MAX_WAYPOINTS {
        let sentence = format!("the path has {count} rows; at most {MAX_WAYPOINTS} are written and read");
        return Err(FormatError::new(Code::WorldTooLarge, sentence));
    }
    if let Some(RowTiming { times, velocities }) = timing
        && (times.len() != count || velocities.len() != count)
    {
        let sentence = format!("{count} rows have {} times and {} velocities", times.len(), velocities.len());
        return Err(FormatError::new(Code::WrongColumns, sentence));
    }
    let has_heading = matches!(scenario.robot(), Robot::Disc(_)) && configurations[0].len() == 3;
    let (dimension, kind) = (scenario.robot().dimension() + usize::from(has_heading), scenario.robot().kind());
    for (i, configuration) in configurations.iter().enumerate() {
        let at = |code: Code, sentence: String| FormatError::new(code, sentence).at(Place::Element(format!("row {i}")));
        let timed = timing.iter().flat_map(|timing| [(&timing.velocities[i], "velocities")]);
        for (numbers, what) in [(configuration, "coordinates")].into_iter().chain(timed) {
            if numbers.len() != dimension {
                let sentence = format!("the robot {kind} has {dimension} {what}, not {}", numbers.len());
                return Err(at(Code::WrongColumns, sentence));
            }
            if let Some(number) = numbers.iter().find(|number| !number.is_finite()) {
                return Err(at(Code::InvalidNumber, format!("one of the {what} is {number}, which is not finite")));
            }
        }
        if let Some(time) = timing.as_ref().map(|timing| timing.times[i]).filter(|time| !time.is_finite()) {
            return Err(at(Code::InvalidNumber, format!("the time is {time}, which is not finite")));
        }
    }
    Ok(())
}

/// A number as text with the fewest digits that read back to the same bits, a point among them and no exponent: what YAML 1.1
/// takes for a number as well.
fn decimal(number: f64) -> String {
    let text = number.to_string();
    if text.contains('.') { text } else { text + ".0" }
}
