//! What can be chosen about many trajectories: the one table that help texts, documents and controls are made from.

use super::particle::{MOST_TURNING, Model};
use crate::decimal::Decimal;
use crate::error::{Code, Error};
use crate::json::Node;
use crate::parameters::{Fallback, Kind, ParameterInfo, Parameters, Value};
use crate::random::MAX_SEED;
use std::f64::consts::PI;

pub(super) const fn row(
    name: &'static str,
    title: &'static str,
    kind: Kind,
    unit: &'static str,
    default: Fallback,
    meaning: &'static str,
) -> ParameterInfo {
    ParameterInfo { name, title, kind, unit, default, meaning, robots: &[] }
}

pub(super) const fn number(
    name: &'static str,
    title: &'static str,
    [min, max, default]: [f64; 3],
    unit: &'static str,
    meaning: &'static str,
) -> ParameterInfo {
    row(name, title, Kind::Number { min, max }, unit, Fallback::Number(default), meaning)
}

/// The parameters of many trajectories; the seed goes without saying.
pub const PARAMETERS: &[ParameterInfo] = &[
    row(
        "model",
        "Motion",
        Kind::Choice(&["arc", "spiral"]),
        "",
        Fallback::Text("arc"),
        "How a particle moves: on a circular arc, or on the spiral whose points are v t away from the start in direction theta + w t.",
    ),
    row(
        "count",
        "Trajectories",
        Kind::Integer { min: 1.0, max: 100_000.0 },
        "",
        Fallback::Number(1000.0),
        "How many trajectories are accepted, none of which crosses another.",
    ),
    number("half_side", "Half side", [0.01, 10_000.0, 3.0], "m", "Starts lie in a square from minus this to this."),
    number("spread", "Spread", [0.0, PI, PI], "rad", "First headings lie between minus this and this."),
    number("slowest", "Slowest", [0.0, 1000.0, 0.0], "m/s", "The least speed, at most the greatest."),
    number("fastest", "Fastest", [0.0, 1000.0, 1.0], "m/s", "The greatest speed."),
    number(
        "least_turn_rate",
        "Least turn rate",
        [-1000.0, 1000.0, -PI],
        "rad/s",
        "The least turn rate, at most the greatest; negative turns right.",
    ),
    number("greatest_turn_rate", "Greatest turn rate", [-1000.0, 1000.0, PI], "rad/s", "The greatest turn rate."),
    number(
        "duration",
        "Duration",
        [0.001, 1000.0, 1.0],
        "s",
        "How long every particle moves; no turn is longer than 100 radians.",
    ),
    row(
        "index",
        "Index",
        Kind::Choice(&["grid", "none"]),
        "",
        Fallback::Text("grid"),
        "Which earlier trajectories a new one is tested against: those that share a cell of a grid, or all. The result is the same.",
    ),
    row(
        "max_iterations",
        "Iterations at most",
        Kind::Integer { min: 1.0, max: 1_000_000.0 },
        "",
        Fallback::Number(100_000.0),
        "After how many trajectories tried the search for more gives up.",
    ),
];

/// The table of parameters, to be written.
pub fn catalogue() -> Node {
    Node::Array(PARAMETERS.iter().map(ParameterInfo::node).collect())
}

/// Values for all of [`PARAMETERS`], and the seed.
#[derive(Debug, Clone, PartialEq)]
pub struct TrajectoryOptions {
    /// How particles move.
    pub model: Model,
    /// How many are accepted.
    pub count: usize,
    /// Half the side of the square of starts, in metres.
    pub half_side: f64,
    /// Headings lie between minus this and this, in radians.
    pub spread: f64,
    /// The least and the greatest speed, in metres a second.
    pub speeds: [f64; 2],
    /// The least and the greatest turn rate, in radians a second.
    pub turn_rates: [f64; 2],
    /// How long every particle moves, in seconds.
    pub duration: f64,
    /// Whether a grid is asked which earlier trajectories may be near.
    pub is_indexed: bool,
    /// After how many tries the search gives up.
    pub max_iterations: u64,
    /// The seed: 0 to 2^53 - 1.
    pub seed: u64,
}

impl TrajectoryOptions {
    /// The options given by name, checked, and defaults for the rest.
    ///
    /// # Errors
    /// `unknown-parameter`, `duplicate-field`, `wrong-type`, `not-finite` or `out-of-range`, with the pointer `/name`.
    pub fn new(given: &[(String, Value)], seed: u64) -> Result<Self, Error> {
        let parameters = Parameters::resolve(PARAMETERS, given)?;
        let number = |name: &str| parameters.number(name).expect("every default is a number") + 0.0;
        let is = |name: &str, word: &str| parameters.text(name) == Some(word);
        let options = Self {
            model: if is("model", "spiral") { Model::Spiral } else { Model::Arc },
            count: parameters.integer("count") as usize,
            half_side: number("half_side"),
            spread: number("spread"),
            speeds: ["slowest", "fastest"].map(number),
            turn_rates: ["least_turn_rate", "greatest_turn_rate"].map(number),
            duration: number("duration"),
            is_indexed: is("index", "grid"),
            max_iterations: parameters.integer("max_iterations"),
            seed,
        };
        options.check().map(|()| options)
    }

    /// Refuses values that do not go together.
    fn check(&self) -> Result<(), Error> {
        let refuse = |name: &str, sentence: String| Err(Error::new(Code::OutOfRange, format!("/{name}"), sentence));
        let Self { speeds, turn_rates, duration, seed, .. } = *self;
        let pairs = [("slowest", "fastest", speeds), ("least_turn_rate", "greatest_turn_rate", turn_rates)];
        for (least, greatest, [low, high]) in pairs {
            if low > high {
                let [low, high] = [low, high].map(Decimal);
                return refuse(least, format!("{least} must be at most {greatest}, {high}, not {low}"));
            }
        }
        let turn = turn_rates[0].abs().max(turn_rates[1].abs()) * duration;
        if turn > MOST_TURNING {
            let [most, turn] = [MOST_TURNING, turn].map(Decimal);
            return refuse("duration", format!("the longest turn must be at most {most} radians, not {turn}"));
        }
        if seed > MAX_SEED {
            return refuse("seed", format!("seed must lie within [0, {MAX_SEED}], not {seed}"));
        }
        Ok(())
    }
}
