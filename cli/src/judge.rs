//! The verdict on a path of any origin, for `planarium verify`.

use crate::arguments::Answer;
use crate::files;
use clap::Args;
use planarium::Error;
use planarium::error::Code;
use planarium::geometry::Point;
use planarium::path::{Blocked, FirstContact, JudgeOptions, Judgement, PathClearance, TurnFault, judge};
use planarium::scenario::Scenario;
use planarium_formats::{Angles, File, MapFrame, PathOptions, PathReport, read_path};
use serde_json::{Value, json};

/// How a path of any origin is read and judged.
#[derive(Args)]
#[command(next_help_heading = "Options of paths of any origin")]
pub struct Judging {
    /// The robot moves from waypoint to waypoint along an arc of constant curvature, not straight
    #[arg(long)]
    arcs: bool,

    /// Angles without a unit are in degrees
    #[arg(long, conflicts_with = "radians")]
    degrees: bool,

    /// Angles without a unit are in radians, though they look like degrees
    #[arg(long)]
    radians: bool,

    /// By how much, as a fraction, a turn may exceed what a car can drive [default: 0.01]
    #[arg(long, value_name = "FRACTION", allow_negative_numbers = true)]
    drive_tolerance: Option<f64>,
}

impl Judging {
    /// Refuses options that other documents have no use for.
    pub fn refuse(&self) -> Result<(), Error> {
        if !self.arcs && !self.degrees && !self.radians && self.drive_tolerance.is_none() {
            return Ok(());
        }
        let sentence = "--arcs, --degrees, --radians and --drive-tolerance are for paths of any other origin than ours";
        Err(Error::new(Code::Usage, "", sentence))
    }

    /// Reads a path in the coordinates of a map, judges it and prints the verdict; true if it is valid.
    pub fn judge(&self, scenario: &Scenario, file: File) -> Answer {
        let frame = scenario.frame();
        let angles = match (self.degrees, self.radians) {
            (true, _) => Some(Angles::Degrees),
            (_, true) => Some(Angles::Radians),
            _ => None,
        };
        let read = read_path(file, scenario.robot(), frame, &PathOptions { angles })?;
        files::say(&read.report.to_string());
        let default = JudgeOptions::default();
        let drive_tolerance = self.drive_tolerance.unwrap_or(default.drive_tolerance);
        let options = JudgeOptions { arcs: self.arcs, drive_tolerance };
        let judgement = judge(scenario, &read.waypoints, &options)?;
        files::say(&sentence(&judgement, frame));
        files::print(&document(&judgement, frame, &read.report).to_string())?;
        Ok(judgement.is_valid())
    }
}

/// The verdict as JSON. Where the map has other coordinates than the scenario, points are there in both.
fn document(judgement: &Judgement, frame: &MapFrame, report: &PathReport) -> Value {
    let mut document = json!(judgement);
    let points = [
        ("contact", judgement.contact.as_ref().and_then(|contact| contact.point)),
        ("clearance", judgement.clearance.as_ref().map(|clearance| clearance.point)),
    ];
    for (part, point) in points.into_iter().filter_map(|(part, point)| Some((part, point?))) {
        if !frame.is_identity() {
            document[part]["map_point"] = json!(frame.to_units([point.x, point.y]));
        }
    }
    document["read"] = json!(report);
    document
}

/// The verdict in a sentence.
fn sentence(judgement: &Judgement, frame: &MapFrame) -> String {
    let place = |point: Point| {
        let [x, y] = frame.to_units([point.x, point.y]);
        format!(" at ({x}, {y})")
    };
    let mut sentence = match &judgement.contact {
        Some(FirstContact { at, with, part, point }) => {
            let what = match with {
                Blocked::Obstacle(i) => format!("part {part} touches obstacle {i}"),
                Blocked::Bounds => format!("part {part} leaves the bounds"),
                Blocked::JointLimit(joint) => format!("joint {joint} leaves its limits"),
                Blocked::HalfTurn(i) => format!("coordinate {i} turns by half a turn, in either direction"),
                Blocked::Unproven => "it is too near to obstacles for too long to be proven".to_owned(),
                _ => "it is blocked".to_owned(),
            };
            let place = point.map(place).unwrap_or_default();
            format!("not free: edge {} at fraction {:.9}, {what}{place}", at.edge, at.fraction)
        }
        None => format!("free: {} waypoints", judgement.waypoints),
    };
    match &judgement.clearance {
        Some(PathClearance { distance, at, obstacle, point, .. }) => {
            let place = place(*point);
            sentence += &format!(
                "; least clearance {distance:.6} m, edge {} at fraction {:.3}, from obstacle {obstacle}{place}",
                at.edge, at.fraction
            );
        }
        None if judgement.is_free() => sentence += "; no obstacle",
        None => {}
    }
    if let Some(turns) = &judgement.turns {
        sentence += &match turns.first.first() {
            None => "; the car can drive every turn".to_owned(),
            Some(turn) => {
                let why = match (turn.fault, turn.radius) {
                    (TurnFault::TooTight, Some(radius)) => format!("needs a radius of {radius:.4} m"),
                    (TurnFault::Sideways, _) => format!("slips by {:.4} rad", turn.slip),
                    (TurnFault::NoSpeed, _) => "goes where the car has no speed".to_owned(),
                    _ => "is too tight".to_owned(),
                };
                format!("; the car cannot drive {} turns, the first is edge {}, which {why}", turns.count, turn.edge)
            }
        };
    }
    sentence
}
