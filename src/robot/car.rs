//! A first-order car: q' = (v cos theta, v sin theta, v tan(phi) / L) under the control (v, phi).
//!
//! (x, y) is the middle of the rear axle. It is the origin of the shape's frame, so a shape whose centre is its origin has its
//! rear axle in its middle, as in the course reports. LaValle 2006, "Planning Algorithms", section 13.1.2.

use super::Weights;
use super::range::{LARGEST, check_limits, check_positive, checked_margin, is_zero};
use crate::error::Error;
use crate::geometry::Polygon;
use serde::Serialize;

/// The largest steering angle, in radians: short of the quarter turn at which the car would turn on the spot.
const STEEPEST: f64 = 1.55;

/// The longest step of integration, in seconds.
const LONGEST_STEP: f64 = 10.0;

/// A car. A configuration is (x, y, theta), in metres and radians; a control is (v, phi), in metres per second and radians.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Car {
    shape: Polygon,
    wheelbase: f64,
    speed: [f64; 2],
    steering: [f64; 2],
    integration_step: f64,
    #[serde(rename = "metric")]
    weights: Weights,
    #[serde(skip_serializing_if = "is_zero")]
    margin: f64,
}

impl Car {
    /// A car: wheelbase L in metres, the least and the greatest speed in metres per second and steering angle in radians, the
    /// step in which durations are counted, in seconds.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range`, with a pointer into the `robot` object of a scenario: a wheelbase or a step that is not
    /// positive, speeds beyond 1e6, angles beyond 1.55, limits of which the lower is not less than the upper.
    pub fn new(
        shape: Polygon,
        wheelbase: f64,
        speed: [f64; 2],
        steering: [f64; 2],
        integration_step: f64,
        weights: Weights,
    ) -> Result<Self, Error> {
        check_positive("/wheelbase", "the wheelbase", wheelbase, LARGEST)?;
        check_limits("/speed", "a speed", speed, LARGEST)?;
        check_limits("/steering", "a steering angle", steering, STEEPEST)?;
        check_positive("/integration_step", "the step of integration", integration_step, LONGEST_STEP)?;
        Ok(Self { shape, wheelbase, speed, steering, integration_step, weights, margin: 0.0 })
    }

    /// The same, to be planned for as if it were larger by this margin on all sides, in metres.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range` (pointer `/margin`) if the margin is not a finite number from 0 to 1e6.
    pub fn with_margin(self, margin: f64) -> Result<Self, Error> {
        Ok(Self { margin: checked_margin(margin)?, ..self })
    }

    /// The shape in its own frame, in metres; x is forward.
    pub fn shape(&self) -> &Polygon {
        &self.shape
    }

    /// The distance between the axles, in metres.
    pub fn wheelbase(&self) -> f64 {
        self.wheelbase
    }

    /// The least and the greatest speed, in metres per second; backward if negative.
    pub fn speed(&self) -> [f64; 2] {
        self.speed
    }

    /// The least and the greatest steering angle, in radians; to the left if positive.
    pub fn steering(&self) -> [f64; 2] {
        self.steering
    }

    /// The step in which durations are counted, in seconds.
    pub fn integration_step(&self) -> f64 {
        self.integration_step
    }

    /// The weights of the metric.
    pub fn weights(&self) -> Weights {
        self.weights
    }

    /// By how much it is planned for as larger, in metres.
    pub fn margin(&self) -> f64 {
        self.margin
    }

    /// The turn rate of the car under the control, in radians per second: v tan(phi) / L.
    pub fn turn_rate(&self, speed: f64, steering: f64) -> f64 {
        speed * libm::tan(steering) / self.wheelbase
    }

    /// The least radius, in metres, of a circle that the car can drive in both directions, and its steering angle in radians:
    /// L / tan(phi) for the lesser of the two largest angles. `None` if the car cannot steer to both sides.
    pub fn turning_radius(&self) -> Option<(f64, f64)> {
        let [right, left] = self.steering;
        let angle = left.min(-right);
        (angle > 0.0).then(|| (self.wheelbase / libm::tan(angle), angle))
    }
}
