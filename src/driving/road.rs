//! The arcs of a car in its world: whether they are proven free, and the obstacles that they would touch.

use crate::collision::{BodyCollision, BodyMotion, Integration, LONGEST_DRIVE};
use crate::error::{Code, Error, Number};
use crate::geometry::{arc_pose, euler_pose};
use crate::problem::{Control, Motion, Touched};
use crate::robot::Car;
use crate::scenario::Robot;
use crate::space::wrap;
use crate::world::{Configurations, PlanningWorld};

/// The most steps in motion of a drive or a rollout, and the most keys of a drive.
pub const MAX_STEPS: u64 = 1_000_000;

/// How near to an obstacle the car may be driven, as a fraction of the world's longer side: finer than for planners, since only a
/// few millimetres are proven at a time.
const TOLERANCE: f64 = 1e-7;

/// The steps that a rollout may be made of, in seconds.
const STEPS: [f64; 2] = [1e-6, 1e6];

/// Poses checked along a refused step, to find the obstacle, and as many beyond it.
const POSES: u32 = 8;

/// A car and everything that it can touch.
pub(super) struct Road {
    pub car: Car,
    configurations: Configurations,
    pub collision: BodyCollision,
}

impl Road {
    /// The error is `unsupported` if the robot is not a car.
    pub(super) fn new(world: &PlanningWorld) -> Result<Self, Error> {
        let Robot::Car(car) = world.robot() else {
            let sentence = format!("only a car can be driven, not the robot {}", world.robot().kind());
            return Err(Error::new(Code::Unsupported, "", sentence));
        };
        let collision = world.body(car.shape(), TOLERANCE);
        Ok(Self { car: car.clone(), configurations: Configurations::of(world), collision })
    }

    /// The same with proofs fine enough to leave a tight start.
    pub(super) fn fitted(mut self, start: &[f64; 3]) -> Self {
        self.collision = self.collision.fitted(start, start);
        self
    }

    /// A configuration of the car, theta in (-pi, pi]. Errors have a pointer below the given one.
    pub(super) fn pose(&self, q: &[f64], pointer: &str) -> Result<[f64; 3], Error> {
        self.configurations.refuse(q, pointer)?;
        Ok([q[0] + 0.0, q[1] + 0.0, wrap(q[2])])
    }

    /// The pose after this duration under the control.
    fn after(&self, from: &[f64; 3], control: Control, seconds: f64) -> [f64; 3] {
        let turn_rate = self.car.turn_rate(control.speed, control.steering);
        let [x, y, theta] = arc_pose(*from, control.speed, turn_rate, seconds);
        [x + 0.0, y + 0.0, wrap(theta)]
    }

    /// The pose after this duration under the control, if all of the arc to it is proven free; else the obstacle that it touches,
    /// `None` if it only comes too near to one to be proven.
    pub(super) fn ahead(&self, from: &[f64; 3], control: Control, seconds: f64) -> Result<[f64; 3], Option<Touched>> {
        let turn_rate = self.car.turn_rate(control.speed, control.steering);
        let arc = BodyMotion::Arc { from: *from, speed: control.speed, turn_rate, duration: seconds };
        match self.collision.first_hit(&arc) {
            None if (turn_rate * seconds).abs() <= LONGEST_DRIVE => Ok(self.after(from, control, seconds)),
            _ => Err(self.touched(from, control, seconds)),
        }
    }

    /// The pose after one step of Euler's method, if it is free; else what it touches.
    fn by_euler(&self, from: &[f64; 3], control: Control, seconds: f64) -> Result<[f64; 3], Option<Touched>> {
        let turn_rate = self.car.turn_rate(control.speed, control.steering);
        let [x, y, theta] = euler_pose(*from, control.speed, turn_rate, seconds);
        let pose = [x + 0.0, y + 0.0, wrap(theta)];
        self.collision.contacts(&pose).first().map_or(Ok(pose), |contact| Err(Some(contact.with)))
    }

    /// The first obstacle that a refused arc touches, among poses along it and beyond.
    fn touched(&self, from: &[f64; 3], control: Control, seconds: f64) -> Option<Touched> {
        (0..=2 * POSES).find_map(|i| {
            let at = self.after(from, control, seconds * f64::from(i) / f64::from(POSES));
            self.collision.contacts(&at).first().map(|contact| contact.with)
        })
    }
}

/// How a control is rolled out.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RolloutOptions {
    /// Along the exact arc, or by Euler's steps.
    pub integration: Integration,
    /// The length of a step, in seconds, from 1e-6 to 1e6; by default `integration_step` of the scenario's car, 0.01 where it
    /// names none.
    pub step: Option<f64>,
}

/// The poses of a control held for a duration.
#[derive(Debug, Clone, PartialEq)]
pub struct Rollout {
    /// The start, the pose after each whole step that is free, and after the rest of a step at the end: (x, y, theta)
    /// in metres and radians.
    pub poses: Vec<[f64; 3]>,
    /// The duration that is free, in seconds: the requested one, unless it was blocked.
    pub seconds: f64,
    /// The obstruction: see [`super::Drive::blocked`].
    pub blocked: Option<Option<Touched>>,
}

/// The motion from `q`, step by step: O(duration / step). Along the arc, each pose is computed from the start, so that rounding
/// does not accumulate, and all of the arc is proven free. By Euler's steps each pose follows from the one before, and only the
/// poses are checked: it shows what the method makes of the arc, and proves nothing.
///
/// # Errors
/// `unsupported` if the robot is not a car; `wrong-dimension`, `not-finite` or `out-of-range` with the pointers `/q`, `/v`,
/// `/phi`, `/dt` and `/duration`: a control beyond the limits of the car (which may always stand still), a step outside [1e-6,
/// 1e6] s, a duration that is negative or longer than [`MAX_STEPS`] steps.
pub fn rollout(
    scenario: impl Into<PlanningWorld>,
    q: &[f64],
    motion: Motion,
    options: RolloutOptions,
) -> Result<Rollout, Error> {
    let road = Road::new(&scenario.into())?;
    let start = road.pose(q, "/q")?;
    let Motion { control, duration } = motion;
    let step = options.step.unwrap_or(road.car.integration_step());
    let ranges = [
        ("/v", "v", control.speed, road.car.speed()),
        ("/phi", "phi", control.steering, road.car.steering()),
        ("/dt", "dt in seconds", options.step.unwrap_or(1.0), STEPS),
        ("/duration", "the duration in seconds", duration, [0.0, step * MAX_STEPS as f64]),
    ];
    for (pointer, name, value, [low, high]) in ranges {
        if !value.is_finite() {
            let sentence = format!("the number at {pointer} must be finite, not {}", Number(value));
            return Err(Error::new(Code::NotFinite, pointer, sentence));
        }
        if !(low..=high).contains(&value) && (pointer, value) != ("/v", 0.0) {
            let [low, high, value] = [low, high, value].map(Number);
            let sentence = format!("{name} must lie within [{low}, {high}], not {value}");
            return Err(Error::new(Code::OutOfRange, pointer, sentence));
        }
    }
    let mut rollout = Rollout { poses: vec![start], seconds: 0.0, blocked: None };
    if let Some(contact) = road.collision.contacts(&start).first() {
        rollout.blocked = Some(Some(contact.with));
        return Ok(rollout);
    }
    let road = road.fitted(&start);
    let mut from = start;
    for i in 1u32.. {
        if rollout.seconds >= duration {
            break;
        }
        let until = duration.min(step * f64::from(i));
        let held = until - rollout.seconds;
        let next = match options.integration {
            Integration::Exact => road.ahead(&from, control, held).map(|_| road.after(&start, control, until)),
            Integration::Euler => road.by_euler(&from, control, held),
        };
        match next {
            Ok(pose) => from = pose,
            Err(touched) => {
                rollout.blocked = Some(touched);
                break;
            }
        }
        rollout.poses.push(from);
        rollout.seconds = until;
    }
    Ok(rollout)
}
