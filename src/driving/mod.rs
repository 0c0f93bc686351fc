//! A car in its world under a driver's hand: keys change its control, time goes by in fixed steps, and each step is an exact arc
//! that is proven free before it is taken. No clock is read: whoever drives says how many steps have gone by, so the same keys at
//! the same steps give the same bits however fast pictures are drawn.

mod key;
mod road;
mod rollout;

pub use key::{Key, SPEED_PRESS, STEERING_PRESS};
pub use road::MAX_STEPS;
pub use rollout::{Rollout, rollout};

use crate::error::{Code, Error, Number};
use crate::problem::{Control, Touched};
use crate::world::PlanningWorld;
use key::Levels;
use road::Road;

/// A key pressed while driving.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Press {
    /// How many steps had gone by.
    pub step: u64,
    /// Which key.
    pub key: Key,
}

/// A drive: a car that starts at rest, and is steered by keys. It stops where the next step cannot be proven free, and says at
/// what; it can be driven on from there by any control that is free.
pub struct Drive {
    road: Road,
    levels: Levels,
    start: [f64; 3],
    pose: [f64; 3],
    steps: u64,
    blocked: Option<Option<Touched>>,
    trace: Vec<[f64; 3]>,
    record: Vec<Press>,
}

impl Drive {
    /// A drive from `start`, a configuration (x, y, theta), or from the start of the scenario's first query.
    ///
    /// # Errors
    /// `unsupported` where the robot is no car; `unknown-query` where there is neither a start nor a query;
    /// `wrong-dimension`, `not-finite`, `out-of-range` of the configuration, with pointers below `/q`; `start-in-collision`.
    pub fn new(scenario: impl Into<PlanningWorld>, start: Option<&[f64]>) -> Result<Self, Error> {
        let world = scenario.into();
        let road = Road::new(&world)?;
        let query = world.scenario().queries().first().map(|query| query.start.as_slice());
        let Some(start) = start.or(query) else {
            return Err(Error::new(Code::UnknownQuery, "/q", "without a query it must be said where the car starts"));
        };
        let start = road.pose(start, "/q")?;
        if let Some(contact) = road.contacts(&start).first() {
            let sentence = format!("the car cannot start there: {contact}");
            return Err(Error::new(Code::StartInCollision, "/q", sentence));
        }
        let road = road.fitted(&start);
        let levels = Levels::new(road.car());
        let trace = vec![start];
        Ok(Self { road, levels, start, pose: start, steps: 0, blocked: None, trace, record: Vec::new() })
    }

    /// Where the car is: x, y in metres, theta in radians.
    pub fn pose(&self) -> [f64; 3] {
        self.pose
    }

    /// The control that is held.
    pub fn control(&self) -> Control {
        self.levels.control()
    }

    /// Steps that have gone by, standing or driving.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The length of a step, in seconds.
    pub fn step(&self) -> f64 {
        self.road.car().integration_step()
    }

    /// Was the car stopped, and not moved since? What it would have touched, `Some(None)` where it would have come too near
    /// to something to be proven free without touching it.
    pub fn blocked(&self) -> Option<Option<Touched>> {
        self.blocked
    }

    /// Where the car has been: the start, and the pose after each step that moved it.
    pub fn trace(&self) -> &[[f64; 3]] {
        &self.trace
    }

    /// The keys pressed so far, in their order.
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

    /// Lets `n` steps go by. A step that cannot be proven free is not taken: the car stands still where it is, its wheels
    /// turned as they were. O(n) where it drives, O(1) where it stands.
    ///
    /// # Errors
    /// `out-of-range` for more than [`MAX_STEPS`] steps at once; `too-large` where the drive would become longer than that
    /// many steps in motion: nothing moves any more, and a new drive must begin.
    pub fn tick(&mut self, n: u64) -> Result<(), Error> {
        if n > MAX_STEPS {
            let sentence = format!("at most {MAX_STEPS} steps go by at once, not {}", Number(n as f64));
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
            let step = self.step();
            match self.road.ahead(&self.pose, control, step) {
                Ok(next) => {
                    self.pose = next;
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

    /// Begins anew at the start, and drives as recorded until `steps` have gone by: presses at the same steps give the same
    /// bits. Presses after `steps` are not made.
    ///
    /// # Errors
    /// `out-of-range` where the presses are not in the order of their steps; those of [`Drive::press`] and [`Drive::tick`].
    pub fn replay(&mut self, record: &[Press], steps: u64) -> Result<(), Error> {
        if let Some(i) = (1..record.len()).find(|&i| record[i].step < record[i - 1].step) {
            let sentence = format!("press {i} comes at step {}, before the one that it follows", record[i].step);
            return Err(Error::new(Code::OutOfRange, format!("/record/{i}/step"), sentence));
        }
        self.levels = Levels::new(self.road.car());
        (self.pose, self.steps, self.blocked) = (self.start, 0, None);
        self.trace = vec![self.start];
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
