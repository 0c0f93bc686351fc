//! A policy: a perceptron of two layers that maps what the robot senses to a control, and its document.
//!
//! It sees, for each ray, how near the obstacle is, and in the robot's frame the direction of the goal and how far it is. Its
//! hidden layer and its outputs have the activation tanh; the outputs are scaled to the limits of speed and turn rate. As floors
//! have no left and right, the policy has none either: it is evaluated for the view and for its mirror image, whose turn rate has
//! the other sign, and the two are averaged. That halves what is to be learned.
//!
//! A carrier of cargo turns its sensor to the goal. Its policy sees how far the goal is, and in that frame the velocity of the
//! carrier, the displacement of the load, and its rate; the outputs are accelerations along and across.

use super::navigator::{CargoNavigator, DriveNavigator, Navigator};
use super::sensor::Sensor;
use crate::error::{Code, Error, within};
use crate::json;
use crate::random::Random;
use crate::robot::GRAVITY;
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::cell::RefCell;
use std::sync::Arc;

/// The `format` of a policy.
pub const POLICY_FORMAT: &str = "planarium-policy-1";

/// Inputs beside the rays: the cosine and the sine of the direction of the goal, and its nearness.
const GOAL_INPUTS: usize = 3;

/// Inputs of a carrier of cargo beside the rays: the nearness of the goal, and two coordinates of its velocity, of the
/// displacement of the load, and of its rate.
const CARGO_INPUTS: usize = 7;

/// The outputs: speed and turn rate, or two coordinates of an acceleration.
const OUTPUTS: usize = 2;

/// The most hidden units.
pub const MAX_HIDDEN: usize = 128;

/// A goal at this distance, in metres, is half way between near and far.
const NEAR: f64 = 1.0;

/// The kind of robot that a policy drives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "PolicyRobot"))]
#[serde(rename_all = "snake_case")]
enum Kind {
    /// A differential drive.
    #[default]
    DifferentialDrive,
    /// A carrier with a load on a rope.
    Cargo,
}

impl Kind {
    fn of(robot: &Navigator) -> Self {
        match robot {
            Navigator::DifferentialDrive(_) => Kind::DifferentialDrive,
            Navigator::Cargo(_) => Kind::Cargo,
        }
    }

    fn is_default(&self) -> bool {
        *self == Kind::default()
    }
}

/// The sizes of a perceptron.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Sizes {
    inputs: usize,
    hidden: usize,
}

impl Sizes {
    /// Of a perceptron that drives a robot.
    pub(super) fn new(robot: &Navigator, hidden: usize) -> Self {
        Self::of(Kind::of(robot), robot.sensor(), hidden)
    }

    fn of(kind: Kind, sensor: &Sensor, hidden: usize) -> Self {
        let others = match kind {
            Kind::DifferentialDrive => GOAL_INPUTS,
            Kind::Cargo => CARGO_INPUTS,
        };
        Self { inputs: sensor.rays + others, hidden }
    }

    /// The number of weights, thresholds included.
    pub(super) fn weights(self) -> usize {
        (self.inputs + 1) * self.hidden + (self.hidden + 1) * OUTPUTS
    }

    /// Small random weights to begin with: of a standard deviation such that the sum of all inputs of a unit has about 1 (LeCun
    /// et al. 1998, "Efficient backprop"); the outputs begin at a tenth of that.
    pub(super) fn random(self, random: &mut Random) -> Vec<f64> {
        let first = (self.inputs + 1) * self.hidden;
        let deviation = |i: usize| {
            if i < first { 1.0 / (self.inputs as f64).sqrt() } else { 0.1 / (self.hidden as f64).sqrt() }
        };
        (0..self.weights()).map(|i| deviation(i) * random.normal()).collect()
    }
}

/// What a carrier of cargo knows, in the frame whose first axis points to the goal.
pub(super) struct Carried {
    /// The distance of the goal, in metres.
    pub distance: f64,
    /// The velocity of the carrier, the displacement of the load, and its rate.
    pub motion: [[f64; 2]; 3],
}

/// A perceptron of two layers.
#[derive(Debug, Clone)]
pub(super) struct Perceptron {
    /// One row per unit; the last column has the thresholds.
    hidden: DMatrix<f64>,
    output: DMatrix<f64>,
    /// The inputs and the units, each with a 1 at its end for the thresholds.
    buffers: RefCell<(DVector<f64>, DVector<f64>, DVector<f64>)>,
}

impl Perceptron {
    /// Of weights in the order of the hidden layer, row by row, and the output layer.
    pub(super) fn new(sizes: Sizes, weights: &[f64]) -> Self {
        let (inputs, hidden) = (sizes.inputs + 1, sizes.hidden);
        let (first, second) = weights.split_at(inputs * hidden);
        let buffers =
            (DVector::from_element(inputs, 1.0), DVector::from_element(hidden + 1, 1.0), DVector::zeros(OUTPUTS));
        Self {
            hidden: DMatrix::from_row_slice(hidden, inputs, first),
            output: DMatrix::from_row_slice(OUTPUTS, hidden + 1, second),
            buffers: RefCell::new(buffers),
        }
    }

    /// The outputs, each in (-1, 1), for inputs that `write` writes.
    fn evaluate(&self, write: impl FnOnce(&mut [f64])) -> [f64; OUTPUTS] {
        let (inputs, units, outputs) = &mut *self.buffers.borrow_mut();
        let last = inputs.len() - 1;
        write(&mut inputs.as_mut_slice()[..last]);
        let count = self.hidden.nrows();
        {
            let mut hidden = units.rows_mut(0, count);
            hidden.gemv(1.0, &self.hidden, inputs, 0.0);
            hidden.iter_mut().for_each(|unit| *unit = libm::tanh(*unit));
        }
        outputs.gemv(1.0, &self.output, units, 0.0);
        [libm::tanh(outputs[0]), libm::tanh(outputs[1])]
    }

    /// The outputs for the view and for its mirror image. `write` writes the inputs beside the rays; its second
    /// argument is the sign of what points to the left, -1 for the mirror image.
    fn views(&self, sensor: &Sensor, distances: &[f64], write: impl Fn(&mut [f64], f64)) -> [[f64; OUTPUTS]; 2] {
        let proximity = |distance: f64| {
            let free = (distance / sensor.range).clamp(0.0, 1.0);
            (1.0 - free) * (1.0 - free)
        };
        let count = distances.len();
        [false, true].map(|is_mirrored| {
            self.evaluate(|inputs| {
                for (i, input) in inputs[..count].iter_mut().enumerate() {
                    *input = proximity(distances[if is_mirrored { count - 1 - i } else { i }]);
                }
                write(&mut inputs[count..], if is_mirrored { -1.0 } else { 1.0 });
            })
        })
    }

    /// The control for what is sensed: the measured distances, and the position of the goal in the robot's frame.
    pub(super) fn control(&self, robot: &DriveNavigator, distances: &[f64], goal: [f64; 2]) -> [f64; 2] {
        let DriveNavigator { drive, sensor, .. } = robot;
        let distance = (goal[0] * goal[0] + goal[1] * goal[1]).sqrt();
        let [cos, sin] = if distance > 0.0 { goal.map(|x| x / distance) } else { [1.0, 0.0] };
        let [[forward, left], [again, right]] = self.views(sensor, distances, |inputs, sign| {
            inputs.copy_from_slice(&[cos, sign * sin, nearness(distance)]);
        });
        let ([slowest, fastest], [rightmost, leftmost]) = (drive.speed(), drive.turn_rate());
        let scaled = |x: f64, low: f64, high: f64| low + (high - low) * (0.5 + 0.5 * x);
        let turn = 0.5 * (left - right);
        // Zero is straight on, whatever the limits.
        let turn_rate = if turn < 0.0 { -turn * rightmost.min(0.0) } else { turn * leftmost.max(0.0) };
        drive.clamped([scaled(0.5 * (forward + again), slowest, fastest), turn_rate])
    }

    /// The acceleration of a carrier of cargo for what is sensed, along and across the direction of the goal.
    pub(super) fn acceleration(&self, robot: &CargoNavigator, distances: &[f64], carried: &Carried) -> [f64; 2] {
        let limits = robot.cargo.limits();
        let swing_rate = limits.swing_limit * (GRAVITY / limits.rope).sqrt();
        let scales = [limits.speed, limits.swing_limit, swing_rate];
        let [[forward, left], [again, right]] = self.views(&robot.sensor, distances, |inputs, sign| {
            inputs[0] = nearness(carried.distance);
            for (i, [along, across]) in carried.motion.into_iter().enumerate() {
                inputs[1 + 2 * i] = along / scales[i];
                inputs[2 + 2 * i] = sign * across / scales[i];
            }
        });
        [0.5 * (forward + again), 0.5 * (left - right)].map(|x| limits.acceleration * x)
    }
}

/// How near a goal is: 1 at no distance, a half at [`NEAR`].
fn nearness(distance: f64) -> f64 {
    NEAR / (NEAR + distance)
}

/// The weights of a perceptron, and the robot that it was trained for. Clones share the weights.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Policy {
    format: &'static str,
    /// The name, used in results.
    name: String,
    /// The kind of robot that it drives.
    #[serde(skip_serializing_if = "Kind::is_default")]
    robot: Kind,
    /// What the robot senses.
    sensor: Sensor,
    /// The number of hidden units.
    hidden: usize,
    /// The seed of the training.
    seed: u64,
    /// The generations of the training.
    generations: u64,
    weights: Arc<[f64]>,
}

/// The document of a policy.
#[derive(Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "PolicyDocument"))]
#[serde(deny_unknown_fields)]
struct Document {
    /// The format of the document.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"planarium-policy-1\""))]
    format: Format,
    /// The name, used in results.
    name: String,
    /// The kind of robot that it drives; a differential drive by default.
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "PolicyRobot"))]
    #[serde(default)]
    robot: Kind,
    /// What the robot senses.
    sensor: Sensor,
    /// The number of hidden units, 1 to 128.
    hidden: usize,
    /// The seed of the training.
    seed: u64,
    /// The generations of the training.
    generations: u64,
    /// For each hidden unit the weights of its inputs and its threshold, then the same for the two outputs.
    weights: Vec<f64>,
}

json::one_format!(enum Format = "planarium-policy-1");

impl Policy {
    /// The policy of these weights, for a robot.
    pub(super) fn new(
        name: String,
        robot: &Navigator,
        hidden: usize,
        seed: u64,
        generations: u64,
        weights: &[f64],
    ) -> Self {
        let (kind, sensor) = (Kind::of(robot), *robot.sensor());
        Self { format: POLICY_FORMAT, name, robot: kind, sensor, hidden, seed, generations, weights: weights.into() }
    }

    /// Reads a policy from JSON text.
    ///
    /// # Errors
    /// With the JSON pointer of the offending value: the codes of [`json::parse`], `unknown-format`, `unknown-field`,
    /// `missing-field`, `wrong-type`, `out-of-range`; `wrong-dimension` for another number of weights than the sizes require.
    pub fn parse(text: &str) -> Result<Self, Error> {
        Self::read(&json::parse(text)?)
    }

    /// Reads a policy from a tree of JSON values.
    ///
    /// # Errors
    /// Those of [`Policy::parse`], except about the text.
    pub fn read(tree: &Value) -> Result<Self, Error> {
        let Document { format: Format::One, name, robot, sensor, hidden, seed, generations, weights } =
            json::read_document(tree, POLICY_FORMAT)?;
        sensor.check("/sensor")?;
        within("/hidden", "the number of hidden units", hidden as f64, 1.0..=MAX_HIDDEN as f64)?;
        crate::random::check_seed(seed)?;
        let count = Sizes::of(robot, &sensor, hidden).weights();
        if weights.len() != count {
            let sentence =
                format!("{} rays and {hidden} hidden units need {count} weights, not {}", sensor.rays, weights.len());
            return Err(Error::new(Code::WrongDimension, "/weights", sentence));
        }
        for (i, &weight) in weights.iter().enumerate() {
            within(format!("/weights/{i}"), "a weight", weight, -1e6..=1e6)?;
        }
        let weights = weights.into();
        Ok(Self { format: POLICY_FORMAT, name, robot, sensor, hidden, seed, generations, weights })
    }

    /// The name, used in results.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the robot senses.
    pub fn sensor(&self) -> &Sensor {
        &self.sensor
    }

    /// The weights, thresholds included.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The perceptron, for a robot.
    ///
    /// # Errors
    /// `unsupported` if the robot is of another kind (pointer `/policy/robot`) or senses in another way (`/policy/sensor`).
    pub(super) fn perceptron(&self, robot: &Navigator) -> Result<Perceptron, Error> {
        let kind = Kind::of(robot);
        if self.robot != kind {
            let [own, other] = [self.robot, kind].map(|kind| json::to_string(&kind));
            let sentence = format!("the policy was trained for the robot {own}, but the robot is {other}");
            return Err(Error::new(Code::Unsupported, "/policy/robot", sentence));
        }
        if self.sensor != *robot.sensor() {
            let [own, other] = [&self.sensor, robot.sensor()].map(json::to_string);
            let sentence = format!("the policy was trained with the sensor {own}, but the robot has {other}");
            return Err(Error::new(Code::Unsupported, "/policy/sensor", sentence));
        }
        Ok(Perceptron::new(Sizes::new(robot, self.hidden), &self.weights))
    }

    /// The document as text, on one line.
    pub fn to_json_string(&self) -> String {
        json::to_string(self)
    }
}
