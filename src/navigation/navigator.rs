//! The robots that navigate: a differential drive, and a carrier with a load on a rope. Each has a range sensor and noise.

use super::sensor::Sensor;
use crate::error::{Code, Error, within};
use crate::geometry::Point;
use crate::json::{by_type, objects};
use crate::robot::{Cargo, CargoLimits, CargoState, DifferentialDrive, Footprint, Part, Round};
use crate::scenario::MAX_VERTICES;
use crate::scenario::document;
use crate::scenario::number::{Coordinate, NonNegative, Positive, Speed};
use crate::scenario::obstacle::checked_polygon;
#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The default time step, in seconds.
pub(super) const TIME_STEP: f64 = 0.2;

/// The default arrival speed of a carrier of cargo, as a part of its greatest speed, and of its arrival swing.
pub(super) const ARRIVAL: f64 = 0.5;

objects! {
    /// A differential drive with a range sensor. A configuration is [x, y, theta]; a control is a speed and a turn rate, both
    /// constant during a time step.
    #[cfg_attr(target_arch = "wasm32", tsify(rename = "DifferentialDriveDocument"))]
    pub(super) struct DriveDocument {
        /// The shape about the middle of the axle; x is forward.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "FootprintDocument"))]
        shape: Shape,
        /// The least and the greatest speed in metres per second, the first less than the second.
        speed: [Speed; 2],
        /// The least and the greatest turn rate in radians per second, the first less than the second.
        turn_rate: [Coordinate; 2],
        /// How long a control is constant, in seconds, 0.001 to 1; 0.2 by default.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        time_step: Option<Positive>,
        /// The range sensor.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        sensor: Option<Sensor>,
        /// The noise of sensing and of driving.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        noise: Option<Noise>,
    }

    /// A carrier with a load on a rope, seen from above. It accelerates in any direction and does not turn; its range
    /// sensor turns to the goal. A load that is displaced beyond the limit of swing ends a drive.
    #[cfg_attr(target_arch = "wasm32", tsify(rename = "CargoDocument"))]
    pub(super) struct CargoDocument {
        /// The radius of the carrier in metres.
        radius: Positive,
        /// The radius of the load in metres.
        load_radius: NonNegative,
        /// The length of the rope, from the carrier to the middle of the load, in metres, at least 0.1.
        rope: Positive,
        /// The greatest horizontal displacement of the load from the carrier, in metres.
        swing_limit: Positive,
        /// The damping of the swing, per second, 0 to 10; 0 by default.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        damping: Option<NonNegative>,
        /// The greatest speed in metres per second.
        speed: Positive,
        /// The greatest acceleration in metres per second squared.
        acceleration: Positive,
        /// How long a control is constant, in seconds, 0.001 to 1; 0.2 by default.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        time_step: Option<Positive>,
        /// A goal is reached at no more than this speed, in metres per second; half of the greatest by default.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        arrival_speed: Option<Positive>,
        /// A goal is reached while the load swings with no more than this amplitude, in metres; half of the limit by default.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        arrival_swing: Option<Positive>,
        /// The range sensor; by default 20 rays, evenly spread over the full circle.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        sensor: Option<Sensor>,
        /// The noise of sensing and of driving.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        noise: Option<CargoNoise>,
    }

    /// A disc about the middle of the axle.
    #[cfg_attr(feature = "schema", schemars(rename = "RoundFootprint"))]
    #[cfg_attr(target_arch = "wasm32", tsify(rename = "RoundFootprintDocument"))]
    pub(super) struct Circle {
        /// The radius in metres.
        radius: Positive,
    }
}

/// The robot.
#[cfg_attr(feature = "schema", derive(JsonSchema), schemars(tag = "type", rename_all = "snake_case"))]
pub(super) enum RobotDocument {
    /// A differential drive.
    DifferentialDrive(DriveDocument),
    /// A carrier with a load on a rope.
    Cargo(CargoDocument),
}

by_type!(RobotDocument { "differential_drive" => DifferentialDrive, "cargo" => Cargo });

/// The shape of the robot in its own frame.
#[cfg_attr(
    feature = "schema",
    derive(JsonSchema),
    schemars(tag = "type", rename_all = "snake_case", rename = "Footprint")
)]
pub(super) enum Shape {
    /// A disc.
    Disc(Circle),
    /// A simple polygon, convex or concave, in either direction, open or closed.
    Polygon(document::Polygon),
}

by_type!(Shape { "disc" => Disc, "polygon" => Polygon });

/// Standard deviations of normally distributed noise, drawn again in every time step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct Noise {
    /// Of each measured distance, in metres.
    #[cfg_attr(feature = "schema", schemars(range(min = 0, max = 1000)))]
    pub range: f64,
    /// Of each coordinate of the robot's estimate of its position, in metres.
    #[cfg_attr(feature = "schema", schemars(range(min = 0, max = 1000)))]
    pub position: f64,
    /// Of the robot's estimate of its heading, in radians.
    #[cfg_attr(feature = "schema", schemars(range(min = 0, max = 1000)))]
    pub heading: f64,
    /// Of the speed that is driven, in metres per second.
    #[cfg_attr(feature = "schema", schemars(range(min = 0, max = 1000)))]
    pub speed: f64,
    /// Of the turn rate that is driven, in radians per second.
    #[cfg_attr(feature = "schema", schemars(range(min = 0, max = 1000)))]
    pub turn_rate: f64,
}

impl Default for Noise {
    fn default() -> Self {
        Self { range: 0.05, position: 0.08, heading: 0.05, speed: 0.08, turn_rate: 0.15 }
    }
}

impl Noise {
    /// No noise at all.
    pub fn none() -> Self {
        Self { range: 0.0, position: 0.0, heading: 0.0, speed: 0.0, turn_rate: 0.0 }
    }

    fn check(&self) -> Result<(), Error> {
        let Self { range, position, heading, speed, turn_rate } = *self;
        check_deviations([
            ("range", range),
            ("position", position),
            ("heading", heading),
            ("speed", speed),
            ("turn_rate", turn_rate),
        ])
    }
}

/// Standard deviations of the normally distributed noise of a carrier of cargo, drawn again in every time step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct CargoNoise {
    /// Of each measured distance, in metres.
    #[cfg_attr(feature = "schema", schemars(range(min = 0, max = 1000)))]
    pub range: f64,
    /// Of each coordinate of the carrier's estimate of its position, in metres.
    #[cfg_attr(feature = "schema", schemars(range(min = 0, max = 1000)))]
    pub position: f64,
    /// Of each coordinate of the estimates of the velocity and of the rate of the load, in metres per second.
    #[cfg_attr(feature = "schema", schemars(range(min = 0, max = 1000)))]
    pub velocity: f64,
    /// Of each coordinate of the estimate of the displacement of the load, in metres.
    #[cfg_attr(feature = "schema", schemars(range(min = 0, max = 1000)))]
    pub swing: f64,
    /// Of each coordinate of the acceleration that is driven, in metres per second squared.
    #[cfg_attr(feature = "schema", schemars(range(min = 0, max = 1000)))]
    pub acceleration: f64,
}

impl Default for CargoNoise {
    fn default() -> Self {
        Self { range: 0.05, position: 0.08, velocity: 0.05, swing: 0.02, acceleration: 0.15 }
    }
}

impl CargoNoise {
    /// No noise at all.
    pub fn none() -> Self {
        Self { range: 0.0, position: 0.0, velocity: 0.0, swing: 0.0, acceleration: 0.0 }
    }

    fn check(&self) -> Result<(), Error> {
        let Self { range, position, velocity, swing, acceleration } = *self;
        check_deviations([
            ("range", range),
            ("position", position),
            ("velocity", velocity),
            ("swing", swing),
            ("acceleration", acceleration),
        ])
    }
}

fn check_deviations(deviations: [(&str, f64); 5]) -> Result<(), Error> {
    for (name, value) in deviations {
        within(format!("/noise/{name}"), "a standard deviation", value, 0.0..=1e3)?;
    }
    Ok(())
}

/// A robot that navigates.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Navigator {
    /// A differential drive.
    DifferentialDrive(DriveNavigator),
    /// A carrier with a load on a rope.
    Cargo(CargoNavigator),
}

/// A differential drive, what it senses, and noise.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DriveNavigator {
    /// The drive.
    #[serde(flatten)]
    pub drive: DifferentialDrive,
    /// The range sensor.
    pub sensor: Sensor,
    /// The noise.
    pub noise: Noise,
}

/// A carrier with a load on a rope, what it senses, and noise.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CargoNavigator {
    /// Carrier and load.
    #[serde(flatten)]
    pub cargo: Cargo,
    /// A goal is reached at no more than this speed, in metres per second.
    pub arrival_speed: f64,
    /// A goal is reached while the load swings with no more than this amplitude, in metres.
    pub arrival_swing: f64,
    /// The range sensor.
    pub sensor: Sensor,
    /// The noise.
    pub noise: CargoNoise,
}

impl CargoNavigator {
    /// Whether carrier and load are slow enough to have reached a goal.
    pub(super) fn has_arrived(&self, state: &CargoState) -> bool {
        let [u, w] = state.velocity;
        u * u + w * w <= self.arrival_speed * self.arrival_speed && self.cargo.amplitude(state) <= self.arrival_swing
    }
}

impl Navigator {
    /// The range sensor.
    pub fn sensor(&self) -> &Sensor {
        match self {
            Navigator::DifferentialDrive(robot) => &robot.sensor,
            Navigator::Cargo(robot) => &robot.sensor,
        }
    }

    /// The radius of the disc that contains the robot while it turns on the spot, or hangs still, in metres.
    pub fn reach(&self) -> f64 {
        match self {
            Navigator::DifferentialDrive(robot) => robot.drive.shape().reach(),
            Navigator::Cargo(robot) => robot.cargo.limits().radius.max(robot.cargo.limits().load_radius),
        }
    }

    /// How long a control is constant, in seconds.
    pub fn time_step(&self) -> f64 {
        match self {
            Navigator::DifferentialDrive(robot) => robot.drive.time_step(),
            Navigator::Cargo(robot) => robot.cargo.limits().time_step,
        }
    }

    /// The greatest speed, forward or backward, in metres per second.
    pub fn top_speed(&self) -> f64 {
        match self {
            Navigator::DifferentialDrive(robot) => {
                let [slowest, fastest] = robot.drive.speed();
                fastest.max(-slowest)
            }
            Navigator::Cargo(robot) => robot.cargo.limits().speed,
        }
    }

    /// The part of the robot at a configuration; of a carrier of cargo without its load.
    pub fn footprint(&self, q: [f64; 3]) -> Part {
        match self {
            Navigator::DifferentialDrive(robot) => robot.drive.footprint(q),
            Navigator::Cargo(robot) => {
                Part::Disc { center: Point::new(q[0], q[1]), radius: robot.cargo.limits().radius }
            }
        }
    }
}

impl RobotDocument {
    /// A checked robot; pointers are into the robot.
    pub(super) fn checked(self) -> Result<Navigator, Error> {
        match self {
            RobotDocument::DifferentialDrive(robot) => robot.checked().map(Navigator::DifferentialDrive),
            RobotDocument::Cargo(robot) => robot.checked().map(Navigator::Cargo),
        }
    }
}

impl DriveDocument {
    fn checked(self) -> Result<DriveNavigator, Error> {
        let shape = match self.shape {
            Shape::Disc(Circle { radius }) => Footprint::Disc(Round { radius: radius.0 }),
            Shape::Polygon(polygon) => {
                let mut vertices_left = MAX_VERTICES;
                let polygon = checked_polygon(&polygon, &mut vertices_left).map_err(|error| error.under("/shape"))?;
                if !polygon.contains(Point::origin()) {
                    let sentence = "the middle of the axle, the origin, must lie within the shape";
                    return Err(Error::new(Code::OutOfRange, "/shape/vertices", sentence));
                }
                Footprint::Polygon(polygon)
            }
        };
        let time_step = self.time_step.map_or(TIME_STEP, |step| step.0);
        let drive = DifferentialDrive::new(shape, self.speed.map(|x| x.0), self.turn_rate.map(|x| x.0), time_step)?;
        let (sensor, noise) = (self.sensor.unwrap_or_default(), self.noise.unwrap_or_default());
        sensor.check("/sensor")?;
        noise.check()?;
        Ok(DriveNavigator { drive, sensor, noise })
    }
}

impl CargoDocument {
    fn checked(self) -> Result<CargoNavigator, Error> {
        let speed = self.speed.0;
        let cargo = Cargo::new(CargoLimits {
            radius: self.radius.0,
            load_radius: self.load_radius.0,
            rope: self.rope.0,
            swing_limit: self.swing_limit.0,
            damping: self.damping.map_or(0.0, |damping| damping.0),
            speed,
            acceleration: self.acceleration.0,
            time_step: self.time_step.map_or(TIME_STEP, |step| step.0),
        })?;
        let arrival_speed = self.arrival_speed.map_or(ARRIVAL * speed, |speed| speed.0);
        let arrival_swing = self.arrival_swing.map_or(ARRIVAL * self.swing_limit.0, |swing| swing.0);
        let (sensor, noise) = (self.sensor.unwrap_or(Sensor::around()), self.noise.unwrap_or_default());
        sensor.check("/sensor")?;
        noise.check()?;
        Ok(CargoNavigator { cargo, arrival_speed, arrival_swing, sensor, noise })
    }
}
