//! `planarium convert`: the path of a result in the forms that other programs read.

use crate::arguments::{Answer, Failure};
use crate::files;
use crate::kind::Kind;
use crate::output::Destination;
use crate::world::{self, WorldOptions};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use planarium::Error;
use planarium::error::Code;
use planarium::path::{self, ResultDocument};
use planarium::scenario::{MapFrame, MapPlane, Robot, Scenario};
use planarium::timing::{self, MAX_ROWS, State, Trajectory};
use planarium_formats::{PathForm, PathRows, WriteOptions, write_path};

#[derive(Args)]
#[command(after_help = "\
Forms:
  csv            a row a line, after names with units: x_m, theta_rad, joint_0_rad; with a trajectory also t_s and speeds
  json           the same as an object of columns, each with its unit
  geojson        a line with its start and goal; of robots that turn, a point with its heading for each row
  svg            a drawing of the obstacles, the path, and the robot along it, at most at 100 places
  nav-path       nav_msgs/Path of ROS as YAML: ros2 topic pub --once /plan nav_msgs/msg/Path --yaml-file path.yaml
  nav-waypoints  a list of poses as YAML: frame_id, position, orientation
  npy            rows of 64-bit numbers: the time if there is one, and the configuration
Rows are the waypoints, the corners of blends among them. The arcs of a car are cut into chords that stay within --deviation of
them. With a trajectory, rows are its knots, corners among them, with as many between them as that takes; or with --dt, equal
times and the end: then chords may cut corners. Angles are continuous, not wrapped. Rows of a trajectory made with --differential
have the heading of the disc, theta.
Coordinates are the metres of the imported file, without the shift of the import; geojson has the unit of a GeoJSON or WKT map, and
csv and json have its longitude and latitude as well. Those of svg are the scenario's, y up. A disc has the heading of its way in
poses. An arm has csv, json, svg and npy.
Exit codes: 0 written; 2 the input is wrong, or the path is not valid.

Examples:
  planarium convert map.json result.json --to csv --out path.csv
  planarium convert map.yaml result.json --radius 0.2 --start 1,1 --goal 8,5 --to nav-path --out path.yaml
  planarium convert arm.json result.json --trajectory trajectory.json --dt 0.01 --to npy --out path.npy
  planarium convert house.json result.json --to geojson | planarium verify house.json -")]
pub struct Arguments {
    /// The scenario, a JSON file, or a map with the options that it was planned with; - reads it from standard input
    file: String,

    /// The result document; - reads it from standard input
    result: String,

    /// The form
    #[arg(long, value_name = "FORM", value_parser = form())]
    to: PathForm,

    /// A trajectory along the path of the result (see `planarium time`), whose times and speeds are written
    #[arg(long, value_name = "FILE")]
    trajectory: Option<String>,

    /// The time from row to row of a trajectory, in seconds
    #[arg(
        long,
        value_name = "S",
        allow_negative_numbers = true,
        requires = "trajectory",
        conflicts_with = "deviation"
    )]
    dt: Option<f64>,

    /// The most that straight chords between rows are from arcs and blends, in metres; of blends of angles, also in radians
    #[arg(long, value_name = "M", allow_negative_numbers = true, default_value_t = timing::DEVIATION)]
    deviation: f64,

    /// Of nav-path and nav-waypoints, the frame that the poses are in [default: map]
    #[arg(long, value_name = "NAME")]
    frame_id: Option<String>,

    #[command(flatten)]
    destination: Destination,

    #[command(flatten)]
    world: WorldOptions,
}

/// The least gap between coordinates of which the message speaks, in metres.
const VISIBLE: f64 = 1e-6;

/// The words for forms.
fn form() -> impl TypedValueParser<Value = PathForm> {
    PossibleValuesParser::new(PathForm::ALL.iter().map(|form| form.as_str()))
        .try_map(|word| word.parse::<PathForm>().map_err(|_| "it is no form"))
}

/// Writes the path; always true.
pub fn convert(arguments: &Arguments) -> Answer {
    let Arguments { file, result, to, trajectory, .. } = arguments;
    let inputs = [Some(file), Some(result), trajectory.as_ref()].into_iter().flatten().map(String::as_str);
    let (outputs, out) = arguments.destination.beside(inputs, kind(*to))?;
    if let Some(trajectory) = trajectory {
        files::refuse_both(result, Some(("trajectory", trajectory)))?;
        files::refuse_both(file, Some(("trajectory", trajectory)))?;
    }
    let scenario = world::scenario(file, Some(("result", result)), &arguments.world, &outputs)?;
    let result = ResultDocument::parse(&files::read(result)?)?;
    path::verify(&scenario, &result)?.required()?;
    let rows = match trajectory {
        Some(name) => timed(arguments, &scenario, &result, &files::read(name)?)?,
        None => PathRows {
            query: result.query.clone(),
            configurations: timing::rows(&scenario, &result, arguments.deviation)?,
            timing: None,
        },
    };
    let options = WriteOptions { frame_id: arguments.frame_id.clone() };
    out.write_bytes(&write_path(&scenario, &rows, *to, &options)?)?;
    files::say(&said(arguments, &scenario, &result, &rows));
    Ok(true)
}

/// The rows of a trajectory along the path.
fn timed(arguments: &Arguments, scenario: &Scenario, result: &ResultDocument, text: &str) -> Result<PathRows, Failure> {
    let trajectory = Trajectory::parse(text, scenario)?;
    if let timing::Verdict::Invalid { why } = timing::verify(scenario, result, &trajectory)? {
        let sentence = format!("the trajectory is not valid: {why}");
        return Err(Error::new(Code::InvalidResult, "/pieces", sentence).into());
    }
    let states: Vec<State> = match arguments.dt {
        Some(step) => {
            let states = trajectory.sampled(step)?;
            if states.len() > MAX_ROWS {
                let sentence = format!("{} rows are {step} s apart; at most {MAX_ROWS} are written", states.len());
                return Err(Error::new(Code::OutOfRange, "/step", sentence).into());
            }
            states.collect()
        }
        None => trajectory.rows(arguments.deviation)?,
    };
    let row = |State { time, configuration, velocity, .. }| (time, configuration, velocity);
    Ok(PathRows::timed(result.query.clone(), states.into_iter().map(row)))
}

/// What was written, in a sentence.
fn said(arguments: &Arguments, scenario: &Scenario, result: &ResultDocument, rows: &PathRows) -> String {
    let Arguments { to, trajectory, dt, deviation, .. } = arguments;
    let chords = format!("chords are within {deviation} m of the path");
    let sampling = match (trajectory, dt) {
        (Some(_), Some(dt)) => format!("every {dt} s, and the end"),
        (Some(_), None) => format!("knots of the trajectory; {chords}"),
        (None, _) if matches!(scenario.robot(), Robot::Car(_)) => format!("waypoints and places of arcs; {chords}"),
        (None, _) if result.blends.is_some() => "waypoints, whose corners are not rounded".to_owned(),
        (None, _) => "waypoints".to_owned(),
    };
    let frame = scenario.frame();
    let [x, y] = frame.offset();
    let moved = match (to, frame.plane()) {
        (PathForm::Svg, _) => String::new(),
        _ if matches!(scenario.robot(), Robot::Arm(_)) => String::new(),
        (PathForm::GeoJson, Some(plane)) if plane.degrees => "; in longitude and latitude of the map".to_owned(),
        (PathForm::GeoJson, Some(MapPlane { scale: [x, y], .. })) => {
            format!("; in the coordinates of the map, whose units are [{x}, {y}] m")
        }
        _ if [x, y] != [0.0; 2] => format!("; in the coordinates of the map: [{x}, {y}] was added{}", coarse(frame)),
        _ => String::new(),
    };
    format!("{}: {} rows, {sampling}{moved}", to.as_str(), rows.configurations.len())
}

/// What so large an offset costs, if that can be seen.
fn coarse(frame: &MapFrame) -> String {
    let resolution = frame.resolution();
    if resolution > VISIBLE { format!(", where numbers are {resolution} m apart") } else { String::new() }
}

/// What an earlier run has written.
fn kind(form: PathForm) -> Kind {
    match form {
        PathForm::Json => Kind::PATH_JSON,
        PathForm::GeoJson => Kind::PATH_GEOJSON,
        PathForm::Svg => Kind::PATH_SVG,
        PathForm::NavPath => Kind::PATH_POSES,
        PathForm::NavWaypoints => Kind::PATH_WAYPOINTS,
        // Tables and arrays do not say which program made them.
        _ => Kind::PATH_ROWS,
    }
}
