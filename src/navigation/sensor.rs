//! The range sensor of a robot that navigates.

use crate::error::{Error, within};
#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The most rays of a sensor.
pub const MAX_RAYS: usize = 64;

/// The widest field of view, in radians: a full circle would have its first ray twice.
const LARGEST_VIEW: f64 = 6.2;

/// A range sensor: rays that are spread evenly over a field of view about the heading, from right to left, each of which measures
/// the distance to what it meets first.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct Sensor {
    /// The number of rays, 2 to 64.
    #[cfg_attr(feature = "schema", schemars(range(min = 2, max = 64)))]
    pub rays: usize,
    /// The angle between the first ray and the last, in radians, at most 6.2.
    #[cfg_attr(feature = "schema", schemars(range(min = 0.001, max = 6.2)))]
    pub field_of_view: f64,
    /// The farthest distance that is measured, in metres.
    #[cfg_attr(feature = "schema", schemars(range(min = 0.001, max = 1e6)))]
    pub range: f64,
}

impl Sensor {
    /// 20 rays, evenly spread over the full circle.
    pub(super) fn around() -> Self {
        Self { rays: 20, field_of_view: 5.97, range: 3.0 }
    }

    /// Refuses numbers outside their ranges.
    pub(super) fn check(&self, pointer: &str) -> Result<(), Error> {
        let Self { rays, field_of_view, range } = *self;
        within(format!("{pointer}/rays"), "the number of rays", rays as f64, 2.0..=MAX_RAYS as f64)?;
        within(format!("{pointer}/field_of_view"), "a field of view", field_of_view, 1e-3..=LARGEST_VIEW)?;
        within(format!("{pointer}/range"), "a range", range, 1e-3..=1e6).map(drop)
    }
}

impl Default for Sensor {
    fn default() -> Self {
        Self { rays: 16, field_of_view: 4.2, range: 3.0 }
    }
}

/// The directions of the rays of a sensor in the robot's frame, as cosine and sine.
pub(super) struct Fan(pub(super) Vec<[f64; 2]>);

impl Fan {
    /// The directions of a sensor, evenly spread from right to left.
    pub(super) fn new(sensor: &Sensor) -> Self {
        let Sensor { rays, field_of_view, .. } = *sensor;
        let direction = |i: usize| {
            let (sin, cos) = libm::sincos(field_of_view * (i as f64 / (rays - 1) as f64 - 0.5));
            [cos, sin]
        };
        Self((0..rays).map(direction).collect())
    }
}
