//! A rollout: the robot drives to a goal under a controller, with the noise of one seed.

use super::document::{Navigation, Navigator};
use super::floor::Floor;
use super::policy::{Perceptron, Policy};
use super::sensor::Fan;
use crate::error::Error;
use crate::geometry::wrap;
use crate::random::{Random, Stream};
use serde::Serialize;
use std::cell::RefCell;

/// The time limit is the time of the straight way at full speed, times this, plus [`EXTRA`] seconds.
const PATIENCE: f64 = 3.0;

/// Seconds beyond.
const EXTRA: f64 = 5.0;

/// A heading beyond this is wrapped, in radians.
const MOST_TURNED: f64 = 1000.0;

/// How a rollout ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Outcome {
    /// The goal is reached.
    Reached,
    /// The next arc is not proven free: the robot would touch something.
    Collision,
    /// The time limit was reached.
    Timeout,
}

/// What drives the robot, given a noisy pose and the distances that its rays measure.
pub(super) enum Controller {
    /// A learned policy.
    Policy(Perceptron),
    /// Turns towards the goal and drives, the slower the more it has to turn. It does not look at the rays.
    Straight,
}

/// The gain of the straight controller, in radians per second and radian.
const GAIN: f64 = 2.0;

impl Controller {
    /// The policy, or the straight controller if there is none.
    ///
    /// # Errors
    /// `unsupported` if the robot senses in another way.
    pub(super) fn new(policy: Option<&Policy>, robot: &Navigator) -> Result<Self, Error> {
        Ok(match policy {
            Some(policy) => Controller::Policy(policy.perceptron(robot)?),
            None => Controller::Straight,
        })
    }

    fn control(&self, robot: &Navigator, distances: &[f64], goal: [f64; 2]) -> [f64; 2] {
        match self {
            Controller::Policy(perceptron) => perceptron.control(robot, distances, goal),
            Controller::Straight => {
                let bearing = libm::atan2(goal[1], goal[0]);
                let [_, fastest] = robot.drive.speed();
                robot.drive.clamped([fastest * libm::cos(bearing).max(0.0), GAIN * bearing])
            }
        }
    }
}

/// A floor and a robot that drives on it.
pub(super) struct Simulation {
    pub(super) floor: Floor,
    task: Navigation,
    fan: Fan,
    distances: RefCell<Vec<f64>>,
}

/// Where a robot has been, and how it ended.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// How it ended.
    pub outcome: Outcome,
    /// The configurations after each time step, from the start on: x, y, theta; the heading is wrapped only where it
    /// exceeds 1000 radians.
    pub trace: Vec<[f64; 3]>,
}

/// How far a rollout got.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Progress {
    pub outcome: Outcome,
    pub steps: u32,
    /// The distance from the goal at the end, in metres.
    pub left: f64,
    /// Where the robot is at the end.
    pub pose: [f64; 3],
}

impl Simulation {
    pub(super) fn new(task: &Navigation) -> Self {
        let sensor = &task.robot().sensor;
        let distances = RefCell::new(vec![0.0; sensor.rays]);
        Self { floor: task.floor(), task: task.clone(), fan: Fan::new(sensor), distances }
    }

    pub(super) fn task(&self) -> &Navigation {
        &self.task
    }

    /// The time steps after which a goal at this distance is given up.
    pub(super) fn patience(&self, distance: f64) -> u32 {
        let [slowest, fastest] = self.task.robot().drive.speed();
        let speed = fastest.max(-slowest);
        (libm::ceil((PATIENCE * distance / speed + EXTRA) / self.task.robot().drive.time_step()) as u32).min(100_000)
    }

    /// Drives from a configuration to within the tolerance of a position; `visit` sees every configuration after the first.
    pub(super) fn drive(
        &self,
        controller: &Controller,
        from: [f64; 3],
        goal: [f64; 2],
        steps: u32,
        random: &mut Random,
        mut visit: impl FnMut([f64; 3]),
    ) -> Progress {
        let robot = self.task.robot();
        let Navigator { drive, noise, sensor } = robot;
        let tolerance = self.task.goal_tolerance();
        let distances = &mut *self.distances.borrow_mut();
        let mut pose = bounded(from);
        let left = |pose: [f64; 3]| {
            let (x, y) = (goal[0] - pose[0], goal[1] - pose[1]);
            (x * x + y * y).sqrt()
        };
        let end = |outcome, steps, pose| Progress { outcome, steps, left: left(pose), pose };
        for step in 0..steps {
            if left(pose) <= tolerance {
                return end(Outcome::Reached, step, pose);
            }
            let mut noisy = |deviation: f64| if deviation == 0.0 { 0.0 } else { deviation * random.normal() };
            if let Controller::Policy(_) = controller {
                self.floor.sense(pose, sensor, &self.fan, distances);
                distances.iter_mut().for_each(|distance| *distance += noisy(noise.range));
            }
            let (x, y) = (goal[0] - pose[0] + noisy(noise.position), goal[1] - pose[1] + noisy(noise.position));
            let (sin, cos) = libm::sincos(pose[2] + noisy(noise.heading));
            let [speed, turn_rate] = controller.control(robot, distances, [cos * x + sin * y, cos * y - sin * x]);
            let control = [speed + noisy(noise.speed), turn_rate + noisy(noise.turn_rate)];
            if !self.floor.is_arc_free(pose, control, drive.time_step()) {
                return end(Outcome::Collision, step + 1, pose);
            }
            pose = bounded(drive.drive(pose, control));
            visit(pose);
        }
        let outcome = if left(pose) <= tolerance { Outcome::Reached } else { Outcome::Timeout };
        end(outcome, steps, pose)
    }
}

/// A configuration whose heading is wrapped once it has turned many times: proofs cover no larger angles.
fn bounded([x, y, theta]: [f64; 3]) -> [f64; 3] {
    [x, y, if theta.abs() > MOST_TURNED { wrap(theta) } else { theta }]
}

/// A generator that depends on a seed and some bits alone, whatever was drawn before.
pub(super) fn generator(seed: u64, stream: Stream, parts: &[u64]) -> Random {
    // A hash of 64 bits (FNV-1a over the words), mixed into the seed.
    let mut hash = 0xcbf2_9ce4_8422_2325_u64 ^ seed;
    for &part in parts {
        for byte in part.to_le_bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    Random::new(hash, stream)
}
