//! Trajectories as JSON.

use super::curve::Curve;
use super::limits::Limits;
use super::profile::Knot;
use super::proof;
use super::trajectory::{Piece, Trajectory};
use crate::error::{Code, Error};
use crate::json::{self, by_type, one_format};
use crate::scenario::Scenario;
use serde::ser::SerializeStruct;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::Value;

/// The format of the document of a trajectory.
pub const FORMAT: &str = "planarium-trajectory-1";

one_format!(enum Format = "planarium-trajectory-1");

/// How far the duration may differ from that of the pieces, relative to it.
const ROUNDED: f64 = 1e-9;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    #[serde(rename = "format")]
    _format: Format,
    scenario: String,
    query: String,
    limits: Limits,
    duration: f64,
    start: Vec<f64>,
    pieces: Vec<PieceDocument>,
}

enum PieceDocument {
    Straight(Straight),
    Parabola(Parabola),
    Arc(Arc),
}

by_type!(PieceDocument { "straight" => Straight, "parabola" => Parabola, "arc" => Arc });

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Straight {
    from: Vec<f64>,
    rate: Vec<f64>,
    knots: Vec<Knot>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Parabola {
    from: Vec<f64>,
    rate: Vec<f64>,
    bend: Vec<f64>,
    knots: Vec<Knot>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Arc {
    from: [f64; 3],
    length: f64,
    turn: f64,
    knots: Vec<Knot>,
}

impl From<PieceDocument> for Piece {
    fn from(document: PieceDocument) -> Self {
        match document {
            PieceDocument::Straight(Straight { from, rate, knots }) => {
                Self { curve: Curve::Straight { from, rate }, knots }
            }
            PieceDocument::Parabola(Parabola { from, rate, bend, knots }) => {
                Self { curve: Curve::Parabola { from, rate, bend }, knots }
            }
            PieceDocument::Arc(Arc { from, length, turn, knots }) => {
                Self { curve: Curve::Arc { from, length, turn }, knots }
            }
        }
    }
}

impl Serialize for Trajectory {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_struct("Trajectory", 7)?;
        object.serialize_field("format", FORMAT)?;
        object.serialize_field("scenario", &self.scenario)?;
        object.serialize_field("query", &self.query)?;
        object.serialize_field("limits", &self.limits)?;
        object.serialize_field("duration", &self.duration())?;
        object.serialize_field("start", &self.start)?;
        object.serialize_field("pieces", &self.pieces)?;
        object.end()
    }
}

impl Trajectory {
    /// Reads the document of a trajectory of a robot of the scenario, and proves that it is one: from rest to rest, without jumps
    /// of position or velocity, and within its limits at every time. Whether it follows a path is decided by
    /// [`verify`](super::verify()).
    ///
    /// # Errors
    /// With the pointer of the offending value: the codes of [`json::parse`], `unknown-format`, `unknown-field`, `missing-field`,
    /// `wrong-type`, `unknown-type`; those of [`Limits::check`]; `wrong-dimension` for a vector with another number of entries
    /// than the robot has coordinates, with its heading if the limits are differential; `unsupported` for a piece that it cannot
    /// follow; `invalid-result` if it belongs to another scenario, or is no such trajectory.
    pub fn parse(text: &str, scenario: &Scenario) -> Result<Self, Error> {
        Self::read(&json::parse(text)?, scenario)
    }

    /// The same from a tree.
    pub fn read(tree: &Value, scenario: &Scenario) -> Result<Self, Error> {
        let Document { scenario: name, query, limits, duration, start, pieces, .. } =
            json::read_document(tree, FORMAT)?;
        if name != scenario.name() {
            let sentence = format!("the trajectory belongs to scenario {name:?}, not to {:?}", scenario.name());
            return Err(Self::invalid("/scenario", sentence));
        }
        scenario.find_query(Some(&query))?;
        limits.check(scenario.robot())?;
        let dimension = limits.dimension(scenario.robot());
        let pieces: Vec<Piece> = pieces.into_iter().map(Piece::from).collect();
        check_length("/start", &start, dimension)?;
        for (i, piece) in pieces.iter().enumerate() {
            check_piece(&format!("/pieces/{i}"), &piece.curve, &limits, dimension)?;
        }
        let trajectory = Self::new([&name, &query], limits, start, pieces);
        proof::check(&trajectory)?;
        let own = trajectory.duration();
        if (duration - own).abs() <= ROUNDED * own {
            return Ok(trajectory);
        }
        Err(Self::invalid("/duration", format!("the duration is given as {duration} s, but the pieces take {own} s")))
    }
}

fn check_piece(place: &str, curve: &Curve, limits: &Limits, dimension: usize) -> Result<(), Error> {
    let [is_car, is_differential] = [matches!(limits, Limits::Car(_)), matches!(limits, Limits::Differential(_))];
    match curve {
        Curve::Straight { from, rate } if !is_car => {
            check_length(&format!("{place}/from"), from, dimension)?;
            check_length(&format!("{place}/rate"), rate, dimension)
        }
        Curve::Parabola { from, rate, bend } if !is_car && !is_differential => {
            check_length(&format!("{place}/from"), from, dimension)?;
            check_length(&format!("{place}/rate"), rate, dimension)?;
            check_length(&format!("{place}/bend"), bend, dimension)
        }
        Curve::Arc { .. } if is_car => Ok(()),
        _ => {
            let sentence = match limits {
                Limits::Differential(_) => "a robot that drives along its heading has straight pieces alone",
                _ => "a car drives along arcs, and no other robot does",
            };
            Err(Error::new(Code::Unsupported, format!("{place}/type"), sentence))
        }
    }
}

fn check_length(pointer: &str, vector: &[f64], dimension: usize) -> Result<(), Error> {
    if vector.len() == dimension {
        return Ok(());
    }
    let sentence = format!("this must have {dimension} entries, not {}", vector.len());
    Err(Error::new(Code::WrongDimension, pointer, sentence))
}
