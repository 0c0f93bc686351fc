//! A car driven by keys: keys change its control, time advances in fixed steps, and each step is an exact arc that is proven free
//! before it is made. The caller advances the steps, so the same keys at the same steps give the same bits at any frame rate.

mod key;
mod road;

pub use crate::collision::Integration;
pub use key::{Key, SPEED_PRESS, STEERING_PRESS};
pub use road::{MAX_STEPS, Rollout, RolloutOptions, rollout};

use crate::error::{Code, Error, Number};
use crate::problem::{Control, Touched, naming_nearest};
use crate::space::{ProductSpace, Space};
use crate::world::{PlanningWorld, SMALL};
use key::Levels;
use road::Road;
use serde::{Deserialize, Serialize};

/// A key pressed while driving.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "KeyPress"))]
pub struct Press {
    /// The number of steps before it.
    pub step: u64,
    /// The key.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "DriveKey"))]
    pub key: Key,
}

/// A car that starts at rest and is driven by keys. It stops if the next step cannot be proven free, and reports the obstruction;
/// from there it can be driven on by any control that is free.
pub struct Drive {
    road: Road,
    levels: Levels,
    steps: u64,
    blocked: Option<Option<Touched>>,
    trace: Vec<[f64; 3]>,
    record: Vec<Press>,
}

impl Drive {
    /// A drive from `start`, a configuration (x, y, theta), or from the start of the scenario's first query.
    ///
    /// # Errors
    /// `unsupported` if the robot is not a car; `unknown-query` if there is neither a start nor a query;
    /// `wrong-dimension`, `not-finite`, `out-of-range` of the configuration, with pointers below `/q`; `start-in-collision`.
    pub fn new(scenario: impl Into<PlanningWorld>, start: Option<&[f64]>) -> Result<Self, Error> {
        let world = scenario.into();
        let road = Road::new(&world)?;
        let query = world.scenario().queries().first().map(|query| query.start.as_slice());
        let Some(start) = start.or(query) else {
            return Err(Error::new(Code::UnknownQuery, "/q", "without a query the car needs a start"));
        };
        let start = road.pose(start, "/q")?;
        if let Some(contact) = road.collision.contacts(&start).first() {
            let sentence = format!("the car cannot start there: it {}", contact.with);
            let error = Error::new(Code::StartInCollision, "/q", sentence);
            let space: ProductSpace<SMALL> = world.default_space();
            let is_free = |q: &[f64; SMALL]| road.collision.is_free(&[q[0], q[1], q[2]]);
            return Err(naming_nearest(error, &space, &is_free, &space.state(&start)));
        }
        let road = road.fitted(&start);
        let levels = Levels::new(&road.car);
        Ok(Self { road, levels, steps: 0, blocked: None, trace: vec![start], record: Vec::new() })
    }

    /// The pose of the car: x, y in metres, theta in radians.
    pub fn pose(&self) -> [f64; 3] {
        self.trace[self.trace.len() - 1]
    }

    /// The current control.
    pub fn control(&self) -> Control {
        self.levels.control()
    }

    /// The number of steps so far, standing or driving.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The length of a step, in seconds.
    pub fn step(&self) -> f64 {
        self.road.car.integration_step()
    }

    /// The obstruction, if the car was stopped and has not moved since: what it would have touched, or `Some(None)` if it would
    /// only have come too near to something to be proven free.
    pub fn blocked(&self) -> Option<Option<Touched>> {
        self.blocked
    }

    /// The start, and the pose after each step that moved the car.
    pub fn trace(&self) -> &[[f64; 3]] {
        &self.trace
    }

    /// The keys pressed so far, in order.
    pub fn record(&self) -> &[Press] {
        &self.record
    }

    /// Presses a key, and records it.
    ///
    /// # Errors
    /// `too-large` once [`MAX_STEPS`] keys are recorded.
    pub fn press(&mut self, key: Key) -> Result<(), Error> {
        if self.record.len() as u64 >= MAX_STEPS {
            return Err(too_long("keys"));
        }
        self.record.push(Press { step: self.steps, key });
        self.levels.press(key);
        Ok(())
    }

    /// Advances by `n` steps. A step that cannot be proven free is not made: the car stops, its steering angle unchanged. O(n)
    /// while it drives, O(1) while it stands.
    ///
    /// # Errors
    /// `out-of-range` for more than [`MAX_STEPS`] steps at once; `too-large` if the drive would have more than that many steps in
    /// motion: the car does not move any more, and a new drive must begin.
    pub fn tick(&mut self, n: u64) -> Result<(), Error> {
        if n > MAX_STEPS {
            let sentence = format!("at most {MAX_STEPS} steps are made at once, not {}", Number(n as f64));
            return Err(Error::new(Code::OutOfRange, "/n", sentence));
        }
        for done in 0..n {
            let control = self.control();
            if control.speed == 0.0 {
                self.steps += n - done;
                break;
            }
            if self.trace.len() as u64 > MAX_STEPS {
                return Err(too_long("steps in motion"));
            }
            self.steps += 1;
            match self.road.ahead(&self.pose(), control, self.step()) {
                Ok(next) => {
                    self.trace.push(next);
                    self.blocked = None;
                }
                Err(touched) => {
                    self.blocked = Some(touched);
                    self.levels.stop();
                }
            }
        }
        Ok(())
    }

    /// Restarts, and drives as recorded until `steps` have passed: presses at the same steps give the same bits. Presses after
    /// `steps` are ignored.
    ///
    /// # Errors
    /// `out-of-range` if the presses are not in the order of their steps; those of [`Drive::press`] and [`Drive::tick`].
    pub fn replay(&mut self, record: &[Press], steps: u64) -> Result<(), Error> {
        if let Some(i) = (1..record.len()).find(|&i| record[i].step < record[i - 1].step) {
            let sentence = format!("press {i} comes at step {}, before the one that it follows", record[i].step);
            return Err(Error::new(Code::OutOfRange, format!("/record/{i}/step"), sentence));
        }
        self.levels = Levels::new(&self.road.car);
        (self.steps, self.blocked) = (0, None);
        self.trace.truncate(1);
        self.record.clear();
        for press in record.iter().filter(|press| press.step <= steps) {
            self.tick(press.step - self.steps)?;
            self.press(press.key)?;
        }
        self.tick(steps - self.steps)
    }
}

fn too_long(what: &str) -> Error {
    Error::new(Code::TooLarge, "", format!("a drive has at most {MAX_STEPS} {what}; begin another one"))
}
