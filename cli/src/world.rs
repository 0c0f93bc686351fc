//! Maps, pictures and other files that are no scenarios: what the command line says about them, and how they become
//! scenarios.

use crate::arguments::Failure;
use crate::files;
use crate::output::Outputs;
use clap::Args;
use planarium::error::Code;
use planarium::scenario::Scenario;
use planarium::{Error, json};
use planarium_formats::{File, FormatError, MAX_BYTES, Options, RobotChoice, Unknown, World, is_world, read};
use serde_json::Value;
use std::path::Path;

/// What a map does not say.
#[derive(Args)]
#[command(next_help_heading = "Options of maps and pictures")]
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

    /// The start of a query, in metres and radians in the coordinates of the file; the angle is 0 if it is left out
    #[arg(long, value_name = "X,Y[,THETA]", value_delimiter = ',', allow_hyphen_values = true, requires = "goal")]
    start: Option<Vec<f64>>,

    /// The goal of that query
    #[arg(long, value_name = "X,Y[,THETA]", value_delimiter = ',', allow_hyphen_values = true, requires = "start")]
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
}

impl WorldOptions {
    fn options(&self) -> Options {
        let robot = if let Some(radius) = self.radius {
            RobotChoice::Disc { radius }
        } else if let Some([length, width]) = self.car {
            let wheelbase = self.wheelbase.unwrap_or(0.6 * length);
            RobotChoice::Car { length, width, wheelbase, steering: self.steering.unwrap_or(0.6) }
        } else {
            self.footprint.clone().unwrap_or_default()
        };
        Options {
            robot,
            start: self.start.clone(),
            goal: self.goal.clone(),
            unknown: if self.unknown.as_deref() == Some("free") { Unknown::Free } else { Unknown::Occupied },
            threshold: self.threshold,
            scale: self.scale,
            min_island: self.min_island.unwrap_or(0),
            simplify: self.simplify.unwrap_or(0.0),
        }
    }

    /// Refuses options that a scenario has no use for.
    fn refuse(&self) -> Result<(), Failure> {
        if self.options() == Options::default() && self.unknown.is_none() && self.min_island.is_none() {
            return Ok(());
        }
        let sentence =
            "a scenario has its own robot and queries: --radius, --start and the like are for maps and pictures";
        Err(Error::new(Code::Usage, "", sentence).into())
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
    match document_or_map(name, other, options, outputs)? {
        Source::Document(document) => Ok(Scenario::read(&document)?),
        Source::Map(scenario) => Ok(scenario),
    }
}

/// What a file is.
pub enum Source {
    /// A document, whatever its format.
    Document(Value),
    /// A map, as a scenario.
    Map(Scenario),
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
        return Ok(Source::Document(json::parse(&files::text(name, bytes)?)?));
    }
    let world = world(vec![(name.to_owned(), bytes)], options, outputs)?;
    files::say(&world.report.to_string());
    if world.scenario.queries().is_empty() {
        return Err(Error::new(Code::Usage, "", "the file has no query: --start and --goal make one").into());
    }
    Ok(Source::Map(world.scenario))
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
        let Some(name) = beside(&error).filter(|name| given.iter().all(|(known, _)| known != name)) else {
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
fn beside(error: &FormatError) -> Option<String> {
    let (wanted, from) = (Path::new(error.wanted()?), Path::new(error.file()?));
    let folder = from.parent().unwrap_or(Path::new(""));
    let places = [folder.join(wanted), folder.join(wanted.file_name()?)];
    let found = places.into_iter().find(|path| path.is_file())?;
    found.into_os_string().into_string().ok()
}

fn metres(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() && number >= 0.0 => Ok(number),
        _ => Err("it is a number, 0 or more".to_owned()),
    }
}

fn rectangle(text: &str) -> Result<[f64; 2], String> {
    let sides = text.split_once('x').and_then(|(length, width)| Some([length.parse().ok()?, width.parse().ok()?]));
    let sides = sides.filter(|sides: &[f64; 2]| sides.iter().all(|side| side.is_finite() && *side > 0.0));
    sides.ok_or_else(|| "it is a length and a width in metres, such as 0.9x0.62".to_owned())
}

fn footprint(text: &str) -> Result<RobotChoice, String> {
    if text.starts_with('[') {
        let corners = serde_json::from_str(text).map_err(|error| format!("corners are [[x, y], ...]: {error}"))?;
        return Ok(RobotChoice::Footprint { corners });
    }
    rectangle(text).map(|[length, width]| RobotChoice::rectangle(length, width))
}
