//! A policy: a perceptron of two layers that maps what the robot senses to a control, and its document.
//!
//! It sees, for each ray, how near the obstacle is, and in the robot's frame the direction of the goal and how far it is. Its
//! hidden layer and its outputs have the activation tanh; the outputs are scaled to the limits of speed and turn rate. As floors
//! have no left and right, the policy has none either: it is evaluated for the view and for its mirror image, whose turn rate has
//! the other sign, and the two are averaged. That halves what is to be learned.

use super::document::Navigator;
use super::sensor::Sensor;
use crate::error::{Code, Error, within};
use crate::json;
use crate::random::Random;
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::cell::RefCell;
use std::sync::Arc;

/// The `format` of a policy.
pub const POLICY_FORMAT: &str = "planarium-policy-1";

/// Inputs beside the rays: the cosine and the sine of the direction of the goal, and its nearness.
const GOAL_INPUTS: usize = 3;

/// The outputs: speed and turn rate.
const OUTPUTS: usize = 2;

/// The most hidden units.
pub const MAX_HIDDEN: usize = 128;

/// A goal at this distance, in metres, is half way between near and far.
const NEAR: f64 = 1.0;

/// The sizes of a perceptron.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Sizes {
    rays: usize,
    hidden: usize,
}

impl Sizes {
    pub(super) fn new(sensor: &Sensor, hidden: usize) -> Self {
        Self { rays: sensor.rays, hidden }
    }

    fn inputs(self) -> usize {
        self.rays + GOAL_INPUTS
    }

    /// The number of weights, thresholds included.
    pub(super) fn weights(self) -> usize {
        (self.inputs() + 1) * self.hidden + (self.hidden + 1) * OUTPUTS
    }

    /// Small random weights to begin with: of a standard deviation such that the sum of all inputs of a unit has about 1 (LeCun
    /// et al. 1998, "Efficient backprop"); the outputs begin at a tenth of that.
    pub(super) fn random(self, random: &mut Random) -> Vec<f64> {
        let first = (self.inputs() + 1) * self.hidden;
        let deviation = |i: usize| {
            if i < first { 1.0 / (self.inputs() as f64).sqrt() } else { 0.1 / (self.hidden as f64).sqrt() }
        };
        (0..self.weights()).map(|i| deviation(i) * random.normal()).collect()
    }
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
        let (inputs, hidden) = (sizes.inputs() + 1, sizes.hidden);
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

    /// The control for what is sensed: the measured distances, and the position of the goal in the robot's frame.
    pub(super) fn control(&self, robot: &Navigator, distances: &[f64], goal: [f64; 2]) -> [f64; 2] {
        let Navigator { drive, sensor, .. } = robot;
        let distance = (goal[0] * goal[0] + goal[1] * goal[1]).sqrt();
        let [cos, sin] = if distance > 0.0 { goal.map(|x| x / distance) } else { [1.0, 0.0] };
        let near = NEAR / (NEAR + distance);
        let proximity = |distance: f64| {
            let free = (distance / sensor.range).clamp(0.0, 1.0);
            (1.0 - free) * (1.0 - free)
        };
        let count = distances.len();
        let view = |is_mirrored: bool| {
            self.evaluate(|inputs| {
                for (i, input) in inputs[..count].iter_mut().enumerate() {
                    *input = proximity(distances[if is_mirrored { count - 1 - i } else { i }]);
                }
                inputs[count..].copy_from_slice(&[cos, if is_mirrored { -sin } else { sin }, near]);
            })
        };
        let ([forward, left], [again, right]) = (view(false), view(true));
        let ([slowest, fastest], [rightmost, leftmost]) = (drive.speed(), drive.turn_rate());
        let scaled = |x: f64, low: f64, high: f64| low + (high - low) * (0.5 + 0.5 * x);
        let turn = 0.5 * (left - right);
        // Zero is straight on, whatever the limits.
        let turn_rate = if turn < 0.0 { -turn * rightmost.min(0.0) } else { turn * leftmost.max(0.0) };
        drive.clamped([scaled(0.5 * (forward + again), slowest, fastest), turn_rate])
    }
}

/// The weights of a perceptron, and the robot that it was trained for. Clones share the weights.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Policy {
    format: &'static str,
    /// The name, used in results.
    name: String,
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
    /// The policy of these weights.
    pub(super) fn new(
        name: String,
        sensor: Sensor,
        hidden: usize,
        seed: u64,
        generations: u64,
        weights: &[f64],
    ) -> Self {
        Self { format: POLICY_FORMAT, name, sensor, hidden, seed, generations, weights: weights.into() }
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
        let Document { format: Format::One, name, sensor, hidden, seed, generations, weights } =
            json::read_document(tree, POLICY_FORMAT)?;
        sensor.check("/sensor")?;
        within("/hidden", "the number of hidden units", hidden as f64, 1.0..=MAX_HIDDEN as f64)?;
        crate::random::check_seed(seed)?;
        let count = Sizes::new(&sensor, hidden).weights();
        if weights.len() != count {
            let sentence =
                format!("{} rays and {hidden} hidden units need {count} weights, not {}", sensor.rays, weights.len());
            return Err(Error::new(Code::WrongDimension, "/weights", sentence));
        }
        for (i, &weight) in weights.iter().enumerate() {
            within(format!("/weights/{i}"), "a weight", weight, -1e6..=1e6)?;
        }
        Ok(Self::new(name, sensor, hidden, seed, generations, &weights))
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
    /// `unsupported` (pointer `/policy/sensor`) if the robot senses in another way.
    pub(super) fn perceptron(&self, robot: &Navigator) -> Result<Perceptron, Error> {
        if self.sensor != robot.sensor {
            let [own, other] = [&self.sensor, &robot.sensor].map(json::to_string);
            let sentence = format!("the policy was trained with the sensor {own}, but the robot has {other}");
            return Err(Error::new(Code::Unsupported, "/policy/sensor", sentence));
        }
        Ok(Perceptron::new(Sizes::new(&self.sensor, self.hidden), &self.weights))
    }

    /// The document as text, on one line.
    pub fn to_json_string(&self) -> String {
        json::to_string(self)
    }
}
