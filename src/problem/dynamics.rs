//! Controls, motions, and the dynamics of a system that is moved by them.

use super::MaybeSend;
use crate::json::not_negative;
use crate::random::Random;
use serde::{Deserialize, Serialize};

/// A control: a speed v and a steering angle phi.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(from = "[f64; 2]", into = "[f64; 2]")]
pub struct Control {
    /// The speed, in metres per second; backward if negative.
    pub speed: f64,
    /// The angle of the front wheels, in radians; to the left if positive.
    pub steering: f64,
}

impl From<[f64; 2]> for Control {
    fn from([speed, steering]: [f64; 2]) -> Self {
        Self { speed, steering }
    }
}

impl From<Control> for [f64; 2] {
    fn from(control: Control) -> Self {
        [control.speed, control.steering]
    }
}

/// A control that is held for a duration.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Motion {
    /// The control.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number]"))]
    pub control: Control,
    /// The duration in seconds, at least 0.
    #[serde(deserialize_with = "not_negative")]
    pub duration: f64,
}

/// A system that is moved by controls: the one trait between planning and driving. Durations are whole numbers of steps.
pub trait Dynamics<S>: MaybeSend {
    /// The step in which durations are counted, in seconds.
    fn step(&self) -> f64;

    /// A control drawn uniformly from all controls.
    fn sample(&self, random: &mut Random) -> Control;

    /// The six controls of Reeds and Shepp, at the full speed of the system: forward and backward, each straight, full left and
    /// full right; only the forward ones if the system has no reverse.
    fn extremes(&self) -> Vec<Control>;

    /// The state after this many steps of the control.
    fn drive(&self, from: &S, control: Control, steps: u32) -> S;

    /// How many of the first `steps` steps are proven free, each with all before it: `steps` if the whole motion is.
    fn free_steps(&self, from: &S, control: Control, steps: u32) -> u32;

    /// The length of the motion, in metres for a car: what planners by controls minimise, and what results report. At least 0,
    /// and proportional to its duration.
    fn length(&self, motion: Motion) -> f64;

    /// An upper bound on the distance between the ends of the motion, in the metric of the space; proportional to its duration.
    fn reach(&self, motion: Motion) -> f64;

    /// The motions from one state to another along the curve of the space, each with the state it leads to, the last with
    /// `to`; none in a space without curves.
    fn steer(&self, from: &S, to: &S) -> Vec<(Motion, S)>;
}
