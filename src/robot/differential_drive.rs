//! A differential drive: two driven wheels on one axle, which turns on the spot if they turn against each other. q' = (v cos
//! theta, v sin theta, w) under the control (v, w). LaValle 2006, "Planning Algorithms", section 13.1.2.2.

use super::Part;
use super::range::{LARGEST, check_limits, check_positive};
use crate::error::{Error, within};
use crate::geometry::{Point, Polygon, arc_pose};
use serde::Serialize;
use std::ops::RangeInclusive;

/// The fastest turn, in radians per second.
const FASTEST_TURN: f64 = 100.0;

/// The time steps, in seconds: a shorter one would not come far in the greatest number of steps of a drive.
pub(super) const STEPS: RangeInclusive<f64> = 0.001..=1.0;

/// The shape of a robot on wheels, in its own frame; x is forward.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
#[non_exhaustive]
pub enum Footprint {
    /// A disc about the middle of the axle.
    Disc(Round),
    /// A simple polygon.
    Polygon(Polygon),
}

/// A disc about the origin of a robot's frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(tag = "type", rename = "disc")]
pub struct Round {
    /// The radius in metres, greater than 0.
    pub radius: f64,
}

impl Footprint {
    /// The radius of the smallest disc about the middle of the axle that contains the shape, in metres: within it the robot turns
    /// on the spot.
    pub fn reach(&self) -> f64 {
        match self {
            Footprint::Disc(Round { radius }) => *radius,
            Footprint::Polygon(polygon) => polygon.reach(),
        }
    }
}

/// A differential drive. A configuration is (x, y, theta), in metres and radians: the middle of the axle and the heading. A
/// control is (v, w), in metres and radians per second, constant during a time step.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DifferentialDrive {
    shape: Footprint,
    speed: [f64; 2],
    turn_rate: [f64; 2],
    time_step: f64,
}

impl DifferentialDrive {
    /// A drive with the least and the greatest speed in metres per second, the least and the greatest turn rate in radians per
    /// second, and the time step in seconds.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range`, with a pointer into the `robot` object of a document: a radius or a greatest speed that is
    /// not positive, speeds beyond 1e6, turn rates beyond 100, a time step outside [0.001, 1], limits of which the lower is not
    /// less than the upper.
    pub fn new(shape: Footprint, speed: [f64; 2], turn_rate: [f64; 2], time_step: f64) -> Result<Self, Error> {
        if let Footprint::Disc(Round { radius }) = shape {
            check_positive("/shape/radius", "the radius of the robot", radius, LARGEST)?;
        }
        check_limits("/speed", "a speed", speed, LARGEST)?;
        check_positive("/speed/1", "the greatest speed", speed[1], LARGEST)?;
        check_limits("/turn_rate", "a turn rate", turn_rate, FASTEST_TURN)?;
        within("/time_step", "the time step", time_step, STEPS)?;
        Ok(Self { shape, speed, turn_rate, time_step })
    }

    /// The shape in its own frame.
    pub fn shape(&self) -> &Footprint {
        &self.shape
    }

    /// The least and the greatest speed, in metres per second; backward if negative.
    pub fn speed(&self) -> [f64; 2] {
        self.speed
    }

    /// The least and the greatest turn rate, in radians per second; to the left if positive.
    pub fn turn_rate(&self) -> [f64; 2] {
        self.turn_rate
    }

    /// How long a control is constant, in seconds.
    pub fn time_step(&self) -> f64 {
        self.time_step
    }

    /// The nearest control within the limits.
    pub fn clamped(&self, [speed, turn_rate]: [f64; 2]) -> [f64; 2] {
        [speed.clamp(self.speed[0], self.speed[1]), turn_rate.clamp(self.turn_rate[0], self.turn_rate[1])]
    }

    /// The configuration after one time step under a control: the exact end of an arc. The heading is not wrapped.
    pub fn drive(&self, from: [f64; 3], [speed, turn_rate]: [f64; 2]) -> [f64; 3] {
        arc_pose(from, speed, turn_rate, self.time_step)
    }

    /// The part of the robot at a configuration.
    pub fn footprint(&self, [x, y, theta]: [f64; 3]) -> Part {
        match &self.shape {
            Footprint::Disc(Round { radius }) => Part::Disc { center: Point::new(x, y), radius: *radius },
            Footprint::Polygon(polygon) => {
                Part::Polygon { vertices: polygon.placed([x, y, theta]).vertices().to_vec() }
            }
        }
    }
}
