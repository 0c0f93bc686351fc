//! The keys that drive a car, and the control that results.

use crate::problem::Control;
use crate::robot::Car;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use strum::{FromRepr, IntoStaticStr, VariantArray};

/// The change of the speed by one press, in metres per second.
pub const SPEED_PRESS: f64 = 0.1;

/// The change of the steering angle by one press, in radians.
pub const STEERING_PRESS: f64 = PI / 12.0;

/// A key; its number is that of the declaration, from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, FromRepr, IntoStaticStr, VariantArray, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "DriveKey"))]
#[repr(u8)]
pub enum Key {
    /// v grows by 0.1.
    Faster,
    /// v falls by 0.1.
    Slower,
    /// phi grows by pi / 12: the wheels turn to the left.
    Left,
    /// phi falls by pi / 12: the wheels turn to the right.
    Right,
    /// The control stays as it is.
    Keep,
}

/// Speed and steering angle, counted in presses: three times a tenth is three tenths, and zero is reached again after a limit
/// that is no multiple of a press.
#[derive(Debug, Clone, Copy)]
pub(super) struct Levels {
    speed: i64,
    steering: i64,
    speeds: [f64; 2],
    angles: [f64; 2],
}

impl Levels {
    /// At rest, wheels straight.
    pub(super) fn new(car: &Car) -> Self {
        Self { speed: 0, steering: 0, speeds: car.speed(), angles: car.steering() }
    }

    /// The control within the limits of the car. A car may always stand still.
    pub(super) fn control(&self) -> Control {
        let [low, high] = self.speeds;
        let speed = if self.speed == 0 { 0.0 } else { (self.speed as f64 / 10.0).max(low).min(high) };
        let [right, left] = self.angles;
        let steering = (self.steering as f64 * PI / 12.0).max(right).min(left);
        Control { speed, steering: steering + 0.0 }
    }

    pub(super) fn press(&mut self, key: Key) {
        match key {
            Key::Faster => self.speed += 1,
            Key::Slower => self.speed -= 1,
            Key::Left => self.steering += 1,
            Key::Right => self.steering -= 1,
            Key::Keep => {}
        }
        self.speed = within(self.speed, self.speeds, SPEED_PRESS);
        self.steering = within(self.steering, self.angles, STEERING_PRESS);
    }

    /// Stops the car; the steering angle stays.
    pub(super) fn stop(&mut self) {
        self.speed = 0;
    }
}

/// The number of presses, limited to the first that reaches a limit: further presses are not counted. 0 is always within.
fn within(presses: i64, [low, high]: [f64; 2], press: f64) -> i64 {
    // A limit that is a multiple except for rounding is reached by that many presses.
    let most = libm::ceil(high.max(0.0) / press - 1e-9) as i64;
    let least = libm::floor(low.min(0.0) / press + 1e-9) as i64;
    presses.clamp(least, most)
}
