//! Timing of paths for JavaScript.

use super::arguments::{Fields, document_tree, fields, fields_named, finite};
use super::records::{object, record};
use super::scenario::Scenario;
use super::types::{
    JsNumber, JsTrajectoryDocument, ResultInput, RowOptions, TimeOptions, TimingLimits, TrajectoryInput,
};
use super::verification::{self, PathVerification};
use crate::Error;
use crate::error::within;
use crate::ik::tip_speed;
use crate::path::{self, ResultDocument, Verdict};
use crate::scenario::{self, Robot};
use crate::timing::{self, LimitOptions};
use js_sys::Float64Array;
use serde::Serialize;
use serde_json::Value;
use serde_wasm_bindgen::preserve;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

/// The most numbers of a sampled trajectory.
const MOST_NUMBERS: f64 = 1e7;

/// A path with its timing: where the robot is at every time, from rest to rest and within limits, which is proven.
/// `scenario.time` makes it, `scenario.trajectory` reads a stored one. It outlives the scenario. Angles are not wrapped.
#[wasm_bindgen]
pub struct Trajectory {
    timed: timing::Trajectory,
    scenario: scenario::Scenario,
}

/// The robot at a time. Coordinates in metres and radians.
#[derive(Serialize, Tsify)]
pub struct TrajectoryState {
    /// The time since the start, in seconds, within the duration.
    time: f64,
    /// The configuration; angles are not wrapped.
    #[serde(with = "preserve")]
    #[tsify(type = "Float64Array")]
    configuration: Float64Array,
    /// The rates of the coordinates, per second.
    #[serde(with = "preserve")]
    #[tsify(type = "Float64Array")]
    velocity: Float64Array,
    /// Their second derivatives, per second squared. Where they jump, those after the jump.
    #[serde(with = "preserve")]
    #[tsify(type = "Float64Array")]
    acceleration: Float64Array,
}

impl From<timing::State> for TrajectoryState {
    fn from(timing::State { time, configuration, velocity, acceleration }: timing::State) -> Self {
        let [configuration, velocity, acceleration] =
            [configuration, velocity, acceleration].map(|numbers| Float64Array::from(&numbers[..]));
        Self { time, configuration, velocity, acceleration }
    }
}

/// What is known of a valid trajectory.
#[derive(Serialize, Tsify)]
pub struct TimingVerification {
    /// The duration, in seconds.
    duration: f64,
    /// The number of times that were examined.
    looks: u64,
    /// The largest share of its limit that a speed has.
    speed: f64,
    /// The largest share of its limit that an acceleration has.
    acceleration: f64,
}

/// The verdict on a result and a trajectory along its path.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct TrajectoryVerification {
    /// Whether the path is valid and the trajectory follows it within its limits.
    valid: bool,
    /// The reason if it is not.
    why: Option<String>,
    /// The verdict on the path.
    path: PathVerification,
    /// What was found of a valid trajectory; null of others. It is not examined if the path is not valid.
    trajectory: Option<TimingVerification>,
}

#[wasm_bindgen]
impl Scenario {
    /// The fastest trajectory along the path of a solved result within limits of speed and acceleration, from rest to rest. It
    /// rests on the way at corners without a blend (`blend` of the planners rounds them), and where a car changes its direction.
    /// A disc with the limit `differential` drives the corners without their blends.
    /// No limit is exceeded at any time. The path is verified first, unless the option `verify` is `false`.
    /// @throws {PlanariumError} below `/limits`: `missing-field`, `unknown-field`, `wrong-type`, `out-of-range`, `not-finite`,
    /// `wrong-dimension`, `unsupported`; below `/result`: `invalid-result` if it belongs to another scenario, is not solved or
    /// not valid, or cannot be followed; `unknown-query`, and those of `scenario.verify`
    pub fn time(
        &self,
        result: &ResultInput,
        limits: &TimingLimits,
        options: Option<TimeOptions>,
    ) -> Result<Trajectory, Error> {
        let result = read_result(result)?;
        let limits = limits_of(limits, self.scenario().robot())?;
        let mut fields = fields(options)?;
        let is_verified = fields.take("verify")?.unwrap_or(true);
        fields.finish("verify")?;
        let about_result = |error: Error| error.under("/result");
        if is_verified {
            path::verify(self.scenario(), &result).and_then(|verdict| verdict.required()).map_err(about_result)?;
        }
        let timed = timing::time(self.scenario(), &result, &limits).map_err(about_result)?;
        Ok(Trajectory { timed, scenario: self.scenario().clone() })
    }

    /// The path of a solved result as rows of `dimension` numbers, without those of blends: its waypoints, and between those of a
    /// car as many places of its arcs as bring straight chords within `deviation` of them. Angles are not wrapped. `writePath` of
    /// `planarium/import` writes them in the forms of other programs.
    /// @throws {PlanariumError} `out-of-range` or `not-finite` at `/deviation`; `unknown-field`, `wrong-type`; below `/result`:
    /// `invalid-result` if it belongs to another scenario or is not solved, `unknown-query`, and those of `scenario.verify`
    #[wasm_bindgen(js_name = pathRows)]
    pub fn path_rows(&self, result: &ResultInput, options: Option<RowOptions>) -> Result<Vec<f64>, Error> {
        let result = read_result(result)?;
        let rows = timing::rows(self.scenario(), &result, deviation(options)?)
            .map_err(|error| if error.pointer() == "/deviation" { error } else { error.under("/result") })?;
        Ok(rows.concat())
    }

    /// Reads a stored trajectory, `JSON.stringify` of one, of a robot of this scenario, and proves again that it is one, from
    /// rest to rest and within its limits.
    /// @throws {PlanariumError} with a JSON pointer: `invalid-json`, `unknown-format`, `unknown-field`, `missing-field`,
    /// `wrong-type`, `unknown-type`, `wrong-dimension`, `unknown-query`; `invalid-result` if it belongs to another scenario or is
    /// no such trajectory
    pub fn trajectory(&self, document: &TrajectoryInput) -> Result<Trajectory, Error> {
        let timed = timing::Trajectory::read(&document_tree(document, "a trajectory")?, self.scenario())?;
        Ok(Trajectory { timed, scenario: self.scenario().clone() })
    }

    /// Verifies a result and a trajectory along its path by other code than that which made them: whether the path is valid, and
    /// whether the trajectory follows it from rest to rest, without a jump and within its limits.
    /// @throws {PlanariumError} below `/result` those of `scenario.verify`, below `/trajectory` those of `scenario.trajectory`;
    /// what is wrong with its pieces is a verdict
    #[wasm_bindgen(js_name = verifyTrajectory)]
    pub fn verify_trajectory(
        &self,
        result: &ResultInput,
        trajectory: &TrajectoryInput,
    ) -> Result<Ts<TrajectoryVerification>, Error> {
        let result = read_result(result)?;
        let about_trajectory = |error: Error| error.under("/trajectory");
        let tree = document_tree(trajectory, "a trajectory").map_err(about_trajectory)?;
        let verdict = path::verify(self.scenario(), &result).map_err(|error| error.under("/result"))?;
        let (why, found) = match &verdict {
            Verdict::Invalid { why } => (Some(why.clone()), None),
            Verdict::Valid { .. } => {
                match timing::verify_document(self.scenario(), &result, &tree).map_err(about_trajectory)? {
                    timing::Verdict::Invalid { why } => (Some(format!("the trajectory: {why}")), None),
                    timing::Verdict::Valid { duration, samples, speed, acceleration } => {
                        (None, Some(TimingVerification { duration, looks: samples, speed, acceleration }))
                    }
                }
            }
        };
        let path = PathVerification::from(verdict);
        Ok(record(&TrajectoryVerification { valid: why.is_none(), why, path, trajectory: found }))
    }
}

/// A result among other arguments.
fn read_result(result: &ResultInput) -> Result<ResultDocument, Error> {
    verification::read_result(result).map_err(|error| error.under("/result"))
}

/// The deviation of chords that is allowed.
fn deviation(options: Option<RowOptions>) -> Result<f64, Error> {
    let mut fields = fields(options)?;
    let deviation = fields.take("deviation")?.unwrap_or(timing::DEVIATION);
    fields.finish("deviation")?;
    Ok(deviation)
}

/// The limits for a robot, by their names in documents.
fn limits_of(limits: &TimingLimits, robot: &Robot) -> Result<timing::Limits, Error> {
    let read = || {
        let mut fields = fields_named(Some(limits), "limits")?;
        let options = LimitOptions {
            speed: each(&mut fields, "speed")?,
            acceleration: each(&mut fields, "acceleration")?,
            turn_rate: fields.take("turn_rate")?,
            turn_acceleration: fields.take("turn_acceleration")?,
            lateral_acceleration: fields.take("lateral_acceleration")?,
            differential: fields.take("differential")?.unwrap_or_default(),
        };
        fields.finish("speed, acceleration, turnRate, turnAcceleration, lateralAcceleration, differential")?;
        Ok(options)
    };
    read().map_err(|error: Error| error.under("/limits"))?.limits(robot).map_err(spelled)
}

/// One number, or one for each coordinate.
fn each(fields: &mut Fields, name: &str) -> Result<Vec<f64>, Error> {
    let given: Value = fields.required(name, "a number, or a list with one for each coordinate")?;
    let list = if given.is_array() { given } else { vec![given].into() };
    let is_one = list.as_array().is_some_and(|list| list.len() == 1);
    crate::json::read(&list).map_err(|error| {
        // One number has no place in a list.
        let place = if is_one { "" } else { error.pointer() };
        Error::new(error.code(), format!("/{name}{place}"), error.message())
    })
}

/// An error about limits, which have other names in JavaScript.
fn spelled(error: Error) -> Error {
    let names = ["turn_rate", "turn_acceleration", "lateral_acceleration"];
    let in_javascript = |text: &str| {
        names.iter().fold(text.to_owned(), |text, name| text.replace(name, &crate::options::in_camel_case(name)))
    };
    Error::new(error.code(), in_javascript(error.pointer()), in_javascript(error.message()))
}

/// The numbers of states, rows of this width.
fn flat(states: impl IntoIterator<Item = timing::State, IntoIter: ExactSizeIterator>, width: usize) -> Vec<f64> {
    let states = states.into_iter();
    let mut rows = Vec::with_capacity(states.len() * width);
    for timing::State { time, configuration, velocity, acceleration } in states {
        rows.push(time);
        rows.extend(configuration.into_iter().chain(velocity).chain(acceleration));
    }
    rows
}

impl Trajectory {
    /// The speed of the point that represents a configuration.
    fn speed_of(&self, state: &timing::State) -> f64 {
        match self.scenario.robot() {
            Robot::Arm(arm) => tip_speed(arm, &state.configuration, &state.velocity),
            Robot::Disc(_) | Robot::RigidBody(_) | Robot::Car(_) => libm::hypot(state.velocity[0], state.velocity[1]),
        }
    }
}

#[wasm_bindgen]
impl Trajectory {
    /// The robot at a time in seconds: before 0 as at 0, after the duration as at the end.
    /// @throws {PlanariumError} `wrong-type`, `not-finite`
    pub fn state(&self, t: &JsNumber) -> Result<Ts<TrajectoryState>, Error> {
        Ok(record(&TrajectoryState::from(self.timed.state(finite(t, "t")?))))
    }

    /// The speed at a time, in metres per second, 0 or more: of the tip of an arm, the centre of a disc, and (x, y) of a body or
    /// a car, as `scenario.endEffector` has them.
    /// @throws {PlanariumError} `wrong-type`, `not-finite`
    pub fn speed(&self, t: &JsNumber) -> Result<f64, Error> {
        Ok(self.speed_of(&self.timed.state(finite(t, "t")?)))
    }

    /// The states at 0, `dt`, 2 `dt` and so on, in seconds, and at last at the duration exactly: rows of the time, the
    /// configuration, the velocity and the acceleration, 1 + 3 `dimension` numbers each, 10,000,000 numbers at most.
    /// @throws {PlanariumError} `wrong-type`, `not-finite`; `out-of-range` unless `dt` is greater than 0, and so large that there
    /// are no more numbers
    pub fn sample(&self, dt: &JsNumber) -> Result<Vec<f64>, Error> {
        let width = 1 + 3 * self.timed.dimension();
        // Two rows more than whole steps: both ends.
        let least = self.timed.duration() / (MOST_NUMBERS / width as f64 - 2.0).floor();
        let dt = within("/dt", "the step in seconds", finite(dt, "dt")?, least.max(f64::MIN_POSITIVE)..=f64::MAX)?;
        let states = self.timed.sampled(dt).map_err(|error| error.at("/dt"))?;
        Ok(flat(states, width))
    }

    /// The states at the knots of the trajectory, corners among them, and between them at as many times as bring straight chords
    /// within `deviation` of the path: rows as `sample` has them.
    /// @throws {PlanariumError} `out-of-range` or `not-finite` at `/deviation`; `unknown-field`, `wrong-type`
    pub fn rows(&self, options: Option<RowOptions>) -> Result<Vec<f64>, Error> {
        Ok(flat(self.timed.rows(deviation(options)?)?, 1 + 3 * self.timed.dimension()))
    }
}

members! { Trajectory(self): wasm_bindgen(getter);
    /// The duration, in seconds.
    duration: f64 = self.timed.duration();
    /// The number of coordinates of a configuration: `scenario.dimension`, of a disc that drives along its heading 3.
    dimension: usize = self.timed.dimension();
    /// The number of rests on the way, the start and the end not counted.
    restCount: usize = self.timed.rests();
}

members! { Trajectory(self): wasm_bindgen;
    /// The document, the one that the command line prints; `JSON.stringify(trajectory)` writes it.
    toJSON: JsTrajectoryDocument = object(&self.timed).unchecked_into();
}
