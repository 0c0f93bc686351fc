//! What lies before a car: is the next arc proven free, and what would it touch.

use crate::collision::{BodyCollision, BodyMotion, LONGEST_DRIVE};
use crate::error::{Code, Error, Number};
use crate::geometry::arc_pose;
use crate::problem::{Contact, Control, Touched};
use crate::robot::Car;
use crate::scenario::Robot;
use crate::space::wrap;
use crate::world::{Configurations, PlanningWorld};

/// The most steps in motion of a drive or a rollout, and the most keys of a drive.
pub const MAX_STEPS: u64 = 1_000_000;

/// How near to an obstacle the car may be driven: as a fraction of the world's longer side. Finer than planners go, since a
/// driver who scrapes past something is proven a few millimetres at a time.
const TOLERANCE: f64 = 1e-7;

/// Places looked at along a step that is refused, to see what it touches, and steps beyond it.
const LOOKS: u32 = 8;

/// A car and all that it can touch.
pub(super) struct Road {
    car: Car,
    configurations: Configurations,
    collision: BodyCollision,
}

impl Road {
    /// # Errors
    /// `unsupported` where the robot is no car.
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

    pub(super) fn car(&self) -> &Car {
        &self.car
    }

    /// A configuration of the car, theta in (-pi, pi].
    ///
    /// # Errors
    /// `wrong-dimension`, `not-finite` or `out-of-range`, with a pointer below the given one.
    pub(super) fn pose(&self, q: &[f64], pointer: &str) -> Result<[f64; 3], Error> {
        self.configurations.refuse(q, pointer)?;
        Ok([q[0] + 0.0, q[1] + 0.0, wrap(q[2])])
    }

    /// What the car touches at a pose; empty where it is free.
    pub(super) fn contacts(&self, pose: &[f64; 3]) -> Vec<Contact> {
        self.collision.contacts(pose)
    }

    /// The pose after so many seconds under the control.
    pub(super) fn after(&self, from: &[f64; 3], control: Control, seconds: f64) -> [f64; 3] {
        let turn_rate = self.car.turn_rate(control.speed, control.steering);
        let [x, y, theta] = arc_pose(*from, control.speed, turn_rate, seconds);
        [x + 0.0, y + 0.0, wrap(theta)]
    }

    /// The pose after so many seconds under the control, where all of the arc to it is proven free; else what it touches,
    /// `None` where it only comes too near to something to be proven.
    pub(super) fn ahead(&self, from: &[f64; 3], control: Control, seconds: f64) -> Result<[f64; 3], Option<Touched>> {
        let turn_rate = self.car.turn_rate(control.speed, control.steering);
        let arc = BodyMotion::Arc { from: *from, speed: control.speed, turn_rate, duration: seconds };
        match self.collision.first_hit(&arc) {
            None if (turn_rate * seconds).abs() <= LONGEST_DRIVE => Ok(self.after(from, control, seconds)),
            _ => Err(self.touched(from, control, seconds)),
        }
    }

    /// What an arc that is refused touches first: looked for in places along it, and a little beyond.
    fn touched(&self, from: &[f64; 3], control: Control, seconds: f64) -> Option<Touched> {
        (0..=2 * LOOKS).find_map(|i| {
            let at = self.after(from, control, seconds * f64::from(i) / f64::from(LOOKS));
            self.contacts(&at).first().map(|contact| contact.with)
        })
    }
}

/// Refuses a number that is not finite.
pub(super) fn check_finite(value: f64, pointer: &str) -> Result<(), Error> {
    if value.is_finite() {
        return Ok(());
    }
    let sentence = format!("the number at {pointer} must be finite, not {}", Number(value));
    Err(Error::new(Code::NotFinite, pointer, sentence))
}
