//! Maps, pictures and other files that are no scenarios: what the command line says about them, and how they become
//! scenarios.

use crate::arguments::{Failure, coordinate, trimmed};
use crate::files;
use crate::output::Outputs;
use clap::{Args, ValueEnum};
use planarium::error::Code;
use planarium::fleet;
use planarium::scenario::Scenario;
use planarium::{Error, json};
use planarium_formats::{
    Coordinates, File, Filter, FormatError, MAX_BYTES, Options, Report, RobotChoice, Unknown, World, is_world, read,
};
use serde_json::Value;
use std::path::Path;

/// What a map does not say.
#[derive(Args)]
#[command(next_help_heading = "Options of maps, pictures and drawings")]
pub struct WorldOptions {
    /// The robot is a disc of this radius, in metres [default: the robot of the format, or a point]
    #[arg(long, value_name = "M", allow_negative_numbers = true, group = "robot", value_parser = metres)]
    radius: Option<f64>,

    /// The robot is a rectangle that turns, in metres, such as 0.9x0.62; or a polygon, such as
    /// [[0.5,0],[-0.4,0.3],[-0.4,-0.3]]
    #[arg(long, value_name = "LxW", group = "robot", value_parser = footprint)]
    footprint: Option<RobotChoice>,

    /// The robot is a car of this length and width, in metres, such as 4.5x1.8
    #[arg(long, value_name = "LxW", group = "robot", value_parser = rectangle)]
    car: Option<[f64; 2]>,

    /// The distance between the axles of the car, in metres [default: 0.6 of its length]
    #[arg(long, value_name = "M", requires = "car", value_parser = metres)]
    wheelbase: Option<f64>,

    /// The largest steering angle of the car, in radians [default: 0.6]
    #[arg(long, value_name = "RAD", requires = "car", value_parser = metres)]
    steering: Option<f64>,

    /// Plan as if the robot were larger by this on all sides, in metres; of a scenario document, in place of its own margin
    /// [default: 0]
    #[arg(long, value_name = "M", allow_negative_numbers = true, value_parser = metres)]
    margin: Option<f64>,

    /// The start of a query, in metres (or degrees, if the file has these) and radians in the coordinates of the file;
    /// the angle is 0 if it is left out
    #[arg(long, value_name = "X,Y[,THETA]", value_delimiter = ',', allow_hyphen_values = true, value_parser = coordinate,
          requires = "goal")]
    start: Option<Vec<f64>>,

    /// The goal of that query
    #[arg(long, value_name = "X,Y[,THETA]", value_delimiter = ',', allow_hyphen_values = true, value_parser = coordinate,
          requires = "start")]
    goal: Option<Vec<f64>>,

    /// What unknown cells are: occupied or free [default: occupied]
    #[arg(long, value_name = "WHAT", value_parser = ["occupied", "free"])]
    unknown: Option<String>,

    /// The brightness from 0 to 1 from which a pixel of a picture is free [default: 0.5], or the number from which a
    /// cell of a grid is occupied
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    threshold: Option<f64>,

    /// Metres per cell, where the file does not say it [default: 1]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    scale: Option<f64>,

    /// Drop islands of fewer occupied cells
    #[arg(long, value_name = "CELLS")]
    min_island: Option<usize>,

    /// Let obstacles grow by at most this, in metres, so that there are fewer [default: 0]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    simplify: Option<f64>,

    /// Of drawings and plans, the layers that are read [default: what the file shows, without doors and floors]
    #[arg(long, value_name = "NAME,...", value_delimiter = ',', value_parser = trimmed)]
    layers: Option<Vec<String>>,

    /// Of drawings and plans, the thickness of lines that have none, in metres [default: 0.1 in buildings, else 0]
    #[arg(long, value_name = "M", value_parser = metres)]
    wall_thickness: Option<f64>,

    /// How much larger polygons may be than curves, in metres [default: 0.001, less in small drawings]
    #[arg(long, value_name = "M", value_parser = metres)]
    tolerance: Option<f64>,

    /// Of DXF, the layers whose closed lines are filled; * is every one [default: closed lines are walls]
    #[arg(long, value_name = "LAYER,...", value_delimiter = ',', value_parser = trimmed)]
    fill: Vec<String>,

    /// Areas are where the robot may be, or they are not [default: they are if the file is one polygon with holes]
    #[arg(long, value_name = "YES|NO", value_parser = ["yes", "no"], num_args = 0..=1, require_equals = true,
          default_missing_value = "yes")]
    walkable: Option<String>,

    /// Of GeoJSON, read features with this property only, or with != without it; may be given again
    #[arg(long, value_name = "KEY=VALUE")]
    filter: Vec<Filter>,

    /// Of buildings, the level [default: the first]
    #[arg(long, value_name = "NAME")]
    level: Option<String>,

    /// Of GeoJSON and WKT, what coordinates are: degrees or metres [default: as the file says, or as is likely]
    #[arg(long, value_name = "WHAT", value_parser = ["degrees", "metres"])]
    coordinates: Option<String>,

    /// The form of the report about a map, on standard error [default: text]
    #[arg(long, value_name = "FORM")]
    report: Option<ReportForm>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ReportForm {
    Text,
    Json,
}

impl WorldOptions {
    fn options(&self) -> Options {
        let robot = if let Some(radius) = self.radius {
            RobotChoice::Disc { radius }
        } else if let Some(size) = self.car {
            RobotChoice::car(size, self.wheelbase, self.steering)
        } else {
            self.footprint.clone().unwrap_or_default()
        };
        Options {
            robot,
            margin: self.margin.unwrap_or(0.0),
            start: self.start.clone(),
            goal: self.goal.clone(),
            unknown: if self.unknown.as_deref() == Some("free") { Unknown::Free } else { Unknown::Occupied },
            threshold: self.threshold,
            scale: self.scale,
            min_island: self.min_island.unwrap_or(0),
            simplify: self.simplify.unwrap_or(0.0),
            layers: self.layers.clone(),
            wall_thickness: self.wall_thickness,
            tolerance: self.tolerance,
            fill: self.fill.clone(),
            walkable: self.walkable.as_deref().map(|word| word == "yes"),
            filters: self.filter.clone(),
            level: self.level.clone(),
            coordinates: match self.coordinates.as_deref() {
                Some("degrees") => Coordinates::Degrees,
                Some(_) => Coordinates::Metres,
                None => Coordinates::Auto,
            },
        }
    }

    /// Refuses options that a scenario has no use for.
    fn refuse(&self) -> Result<(), Failure> {
        let options = Options { margin: 0.0, ..self.options() };
        if options == Options::default() && self.unknown.is_none() && self.min_island.is_none() && self.report.is_none()
        {
            return Ok(());
        }
        let sentence =
            "a scenario has its own robot and queries: --radius, --start and the like are for maps and pictures";
        Err(Error::new(Code::Usage, "", sentence).into())
    }

    /// Gives the robot of a scenario document the margin, if there is one. What is no robot is left to the document's reader.
    fn add_margin(&self, document: &mut Value) -> Result<(), Failure> {
        let Some(margin) = self.margin else { return Ok(()) };
        if document["format"] == fleet::FORMAT {
            let sentence = "a robot of a fleet has no margin: --margin is for scenarios and maps";
            return Err(Error::new(Code::Usage, "", sentence).into());
        }
        if let Some(robot) = document.get_mut("robot").and_then(Value::as_object_mut) {
            robot.insert("margin".to_owned(), margin.into());
        }
        Ok(())
    }

    /// Says what was read of a map.
    pub fn say(&self, report: &Report) {
        files::say(&match self.report {
            None | Some(ReportForm::Text) => report.to_string(),
            Some(ReportForm::Json) => report.to_json_string(),
        });
    }
}

/// The scenario of a file that is one, or of a map; what was read of a map goes to standard error. `other` is the name
/// of a second input and its file, which cannot both be standard input.
pub fn scenario(
    name: &str,
    other: Option<(&str, &str)>,
    options: &WorldOptions,
    outputs: &Outputs,
) -> Result<Scenario, Failure> {
    document_or_map(name, other, options, outputs)?.with_query()
}

/// What a file is.
pub enum Source {
    /// A document, whatever its format.
    Document(Value),
    /// A map, as a scenario and a report.
    Map(Box<World>),
}

impl Source {
    /// The scenario.
    pub fn scenario(self) -> Result<Scenario, Failure> {
        match self {
            Self::Document(document) => Ok(Scenario::read(&document)?),
            Self::Map(world) => Ok(world.scenario),
        }
    }

    /// The scenario; of a map, with a query.
    pub fn with_query(self) -> Result<Scenario, Failure> {
        let is_map = matches!(self, Self::Map(_));
        let scenario = self.scenario()?;
        if is_map && scenario.queries().is_empty() {
            return Err(Error::new(Code::Usage, "", "the file has no query: --start and --goal make one").into());
        }
        Ok(scenario)
    }
}

/// Reads a document or a map, as [`scenario`] does.
pub fn document_or_map(
    name: &str,
    other: Option<(&str, &str)>,
    options: &WorldOptions,
    outputs: &Outputs,
) -> Result<Source, Failure> {
    files::refuse_both(name, other)?;
    let bytes = files::read_bytes(name)?;
    if !is_world(&bytes) {
        options.refuse()?;
        let mut document = json::parse(&files::text(name, bytes)?)?;
        options.add_margin(&mut document)?;
        return Ok(Source::Document(document));
    }
    let world = world(vec![(name.to_owned(), bytes)], options, outputs)?;
    options.say(&world.report);
    Ok(Source::Map(Box::new(world)))
}

/// The world of files; those that they name are read as well.
pub fn world(mut given: Vec<(String, Vec<u8>)>, options: &WorldOptions, outputs: &Outputs) -> Result<World, Failure> {
    let options = options.options();
    loop {
        let all: Vec<File> = given.iter().map(|(name, bytes)| File { name, bytes }).collect();
        let error = match read(&all, &options) {
            Ok(world) => return Ok(world),
            Err(error) => error,
        };
        let Some(name) = beside(&error)?.filter(|name| given.iter().all(|(known, _)| known != name)) else {
            return Err(error.into());
        };
        outputs.check_input(&name)?;
        let bytes = read_file(&name)?;
        given.push((name, bytes));
    }
}

/// The content of a file; of one that is too long, as much as shows it.
pub fn read_file(name: &str) -> Result<Vec<u8>, Error> {
    files::read_at_most(name, MAX_BYTES as u64 + 1)
}

/// The missing file that an error names, if it lies where the file says that names it, or in the same folder.
///
/// # Errors
/// `file` if a folder, a pipe or a device is there instead.
fn beside(error: &FormatError) -> Result<Option<String>, Failure> {
    let (Some(wanted), Some(from)) = (error.wanted().map(Path::new), error.file().map(Path::new)) else {
        return Ok(None);
    };
    let folder = from.parent().unwrap_or(Path::new(""));
    let mut places = vec![folder.join(wanted)];
    places.extend(wanted.file_name().map(|name| folder.join(name)));
    if let Some(found) = places.iter().find(|path| path.is_file()) {
        return Ok(found.to_str().map(str::to_owned));
    }
    match places.iter().find(|path| path.exists()) {
        Some(other) => {
            let what = if other.is_dir() { "a folder" } else { "a pipe or a device" };
            let sentence = format!("it is {what}, not a file that {:?} could name", from.display().to_string());
            Err(files::failed("read", &other.display().to_string(), &sentence).into())
        }
        None => Ok(None),
    }
}

fn metres(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(number) if number.is_finite() && number >= 0.0 => Ok(number),
        _ => Err("it is a number, 0 or more".to_owned()),
    }
}

fn rectangle(text: &str) -> Result<[f64; 2], String> {
    let number = |text: &str| text.trim().parse().ok();
    let sides = text.split_once('x').and_then(|(length, width)| Some([number(length)?, number(width)?]));
    let sides = sides.filter(|sides: &[f64; 2]| sides.iter().all(|side| side.is_finite() && *side > 0.0));
    sides.ok_or_else(|| "it is a length and a width in metres, such as 0.9x0.62".to_owned())
}

fn footprint(text: &str) -> Result<RobotChoice, String> {
    if text.trim_start().starts_with('[') {
        let corners = serde_json::from_str(text).map_err(|error| format!("corners are [[x, y], ...]: {error}"))?;
        return Ok(RobotChoice::Footprint { corners });
    }
    rectangle(text).map(|[length, width]| RobotChoice::rectangle(length, width))
}
