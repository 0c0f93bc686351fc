//! A rollout: the robot drives to a goal under a controller, with the noise of one seed.

use super::document::Navigation;
use super::floor::Floor;
use super::navigator::{CargoNavigator, DriveNavigator, Navigator};
use super::outcome::Outcome;
use super::policy::{Carried, Perceptron, Policy};
use super::sensor::Fan;
use crate::error::Error;
use crate::geometry::wrap;
use crate::random::{Random, Stream};
use crate::robot::{CargoState, GRAVITY};
use std::cell::RefCell;
use std::f64::consts::TAU;

/// The time limit is the time of the straight way at full speed, times this, plus [`EXTRA`] seconds.
const PATIENCE: f64 = 3.0;

/// Seconds beyond.
const EXTRA: f64 = 5.0;

/// The most draws of a state whose load is free.
const DRAWS: u32 = 100;

/// A heading beyond this is wrapped, in radians.
const MOST_TURNED: f64 = 1000.0;

/// Where a robot is, and how it moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct State {
    /// x, y, theta; theta is the direction of the sensor.
    pub pose: [f64; 3],
    /// Of a carrier of cargo; all 0 for a drive, whose speed has no inertia.
    pub velocity: [f64; 2],
    /// The displacement of the load.
    pub swing: [f64; 2],
    /// Its rate.
    pub swing_rate: [f64; 2],
}

impl State {
    /// At rest, with the load straight below.
    pub(super) fn at_rest(pose: [f64; 3]) -> Self {
        Self { pose, velocity: [0.0; 2], swing: [0.0; 2], swing_rate: [0.0; 2] }
    }

    /// A state in which the robot may be at a configuration that it has reached: a carrier of cargo with any velocity up to the
    /// arrival speed, and its load in any swing up to the arrival swing.
    fn arriving(pose: [f64; 3], robot: &Navigator, random: &mut Random) -> Self {
        let Navigator::Cargo(CargoNavigator { cargo, arrival_speed, arrival_swing, .. }) = robot else {
            return Self::at_rest(pose);
        };
        let limits = cargo.limits();
        let widest = arrival_swing.min(limits.swing_limit);
        // The phase of the swing.
        let (sin, cos) = libm::sincos(TAU * random.uniform());
        let most = [arrival_speed.min(limits.speed), cos * widest, sin * widest * (GRAVITY / limits.rope).sqrt()];
        let [velocity, swing, swing_rate] = most.map(|most| in_disc(random).map(|x| most * x));
        Self { pose, velocity, swing, swing_rate }
    }

    fn cargo(&self) -> CargoState {
        let Self { pose: [x, y, _], velocity, swing, swing_rate } = *self;
        CargoState { position: [x, y], velocity, swing, swing_rate }
    }

    fn left(&self, goal: [f64; 2]) -> f64 {
        hypotenuse([goal[0] - self.pose[0], goal[1] - self.pose[1]])
    }
}

/// A point in the unit disc, drawn uniformly.
fn in_disc(random: &mut Random) -> [f64; 2] {
    let radius = random.uniform().sqrt();
    let (sin, cos) = libm::sincos(TAU * random.uniform());
    [radius * cos, radius * sin]
}

fn hypotenuse([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// A vector in a frame that is turned by an angle, given by its sine and cosine.
fn into_frame([sin, cos]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    [cos * x + sin * y, cos * y - sin * x]
}

/// What drives the robot, given a noisy pose and the distances that its rays measure.
pub(super) enum Controller {
    /// A learned policy.
    Policy(Perceptron),
    /// Turns towards the goal and drives, the slower the more it has to turn; a carrier of cargo heads for the goal, and slows
    /// down before it. It does not look at the rays.
    Straight,
}

/// The gain of the straight controller, in radians per second and radian.
const GAIN: f64 = 2.0;

/// The gains of the straight controller of cargo, per second: of the wanted speed by the distance, and of the acceleration by the
/// velocity that is missing.
const CARRIER_GAINS: [f64; 2] = [0.5, 1.0];

impl Controller {
    /// The policy, or the straight controller if there is none.
    ///
    /// # Errors
    /// `unsupported` if the policy is of another robot, or the robot senses in another way.
    pub(super) fn new(policy: Option<&Policy>, robot: &Navigator) -> Result<Self, Error> {
        Ok(match policy {
            Some(policy) => Controller::Policy(policy.perceptron(robot)?),
            None => Controller::Straight,
        })
    }

    fn control(&self, robot: &DriveNavigator, distances: &[f64], goal: [f64; 2]) -> [f64; 2] {
        match self {
            Controller::Policy(perceptron) => perceptron.control(robot, distances, goal),
            Controller::Straight => {
                let bearing = libm::atan2(goal[1], goal[0]);
                let [_, fastest] = robot.drive.speed();
                robot.drive.clamped([fastest * libm::cos(bearing).max(0.0), GAIN * bearing])
            }
        }
    }

    /// The acceleration of a carrier, along and across the direction of the goal.
    fn acceleration(&self, robot: &CargoNavigator, distances: &[f64], carried: &Carried) -> [f64; 2] {
        match self {
            Controller::Policy(perceptron) => perceptron.acceleration(robot, distances, carried),
            Controller::Straight => {
                let [by_distance, by_velocity] = CARRIER_GAINS;
                let wanted = robot.cargo.limits().speed.min(by_distance * carried.distance);
                let [along, across] = carried.motion[0];
                [by_velocity * (wanted - along), -by_velocity * across]
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
    /// exceeds 1000 radians. Of a carrier of cargo, theta is the direction of its sensor.
    pub trace: Vec<[f64; 3]>,
    /// The displacement of the load at each of them, x and y in metres; empty for a robot without a load.
    pub swing: Vec<[f64; 2]>,
}

impl Drive {
    /// The drive of a robot in these states.
    pub(super) fn new(robot: &Navigator, outcome: Outcome, states: &[State]) -> Self {
        let swing = if let Navigator::Cargo(_) = robot { states } else { &[] };
        Self {
            outcome,
            trace: states.iter().map(|state| state.pose).collect(),
            swing: swing.iter().map(|state| state.swing).collect(),
        }
    }
}

/// How far a rollout got.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Progress {
    pub outcome: Outcome,
    pub steps: u32,
    /// The distance from the goal at the end, in metres.
    pub left: f64,
    /// Where the robot is at the end.
    pub state: State,
}

impl Simulation {
    pub(super) fn new(task: &Navigation) -> Self {
        let sensor = task.robot().sensor();
        let distances = RefCell::new(vec![0.0; sensor.rays]);
        Self { floor: task.floor(), task: task.clone(), fan: Fan::new(sensor), distances }
    }

    pub(super) fn task(&self) -> &Navigation {
        &self.task
    }

    /// The time steps after which a goal at this distance is given up.
    pub(super) fn patience(&self, distance: f64) -> u32 {
        let robot = self.task.robot();
        let straight = PATIENCE * distance / robot.top_speed();
        let seconds = match robot {
            Navigator::DifferentialDrive(_) => straight,
            // From rest to rest it takes at least twice the root.
            Navigator::Cargo(robot) => straight.max(PATIENCE * (distance / robot.cargo.limits().acceleration).sqrt()),
        };
        (libm::ceil((seconds + EXTRA) / robot.time_step()) as u32).min(100_000)
    }

    /// Draws a state in which the robot may be at a configuration that it has reached; `None` if its load touches something.
    pub(super) fn draw_state(&self, pose: [f64; 3], random: &mut Random) -> Option<State> {
        let robot = self.task.robot();
        let state = State::arriving(pose, robot, random);
        match robot {
            Navigator::DifferentialDrive(_) => Some(state),
            Navigator::Cargo(robot) => self.floor.is_load_free(&robot.cargo, &state.cargo()).then_some(state),
        }
    }

    /// The first such state of some draws; at rest if there is none.
    pub(super) fn arriving(&self, pose: [f64; 3], random: &mut Random) -> State {
        (0..DRAWS).find_map(|_| self.draw_state(pose, random)).unwrap_or_else(|| State::at_rest(pose))
    }

    /// Drives from a state to within the tolerance of a position; `visit` sees every state after the first.
    pub(super) fn drive(
        &self,
        controller: &Controller,
        from: State,
        goal: [f64; 2],
        steps: u32,
        random: &mut Random,
        mut visit: impl FnMut(State),
    ) -> Progress {
        let robot = self.task.robot();
        let tolerance = self.task.goal_tolerance();
        let mut state = State { pose: bounded(from.pose), ..from };
        let is_reached = |state: &State| {
            let has_arrived = match robot {
                Navigator::DifferentialDrive(_) => true,
                Navigator::Cargo(robot) => robot.has_arrived(&state.cargo()),
            };
            has_arrived && state.left(goal) <= tolerance
        };
        let end = |outcome, steps, state: State| Progress { outcome, steps, left: state.left(goal), state };
        for step in 0..steps {
            if is_reached(&state) {
                return end(Outcome::Reached, step, state);
            }
            let next = match robot {
                Navigator::DifferentialDrive(robot) => self.roll(robot, controller, &state, goal, random),
                Navigator::Cargo(robot) => self.carry(robot, controller, &state, goal, random),
            };
            state = match next {
                Ok(next) => next,
                Err(outcome) => return end(outcome, step + 1, state),
            };
            visit(state);
        }
        let outcome = if is_reached(&state) { Outcome::Reached } else { Outcome::Timeout };
        end(outcome, steps, state)
    }

    /// A differential drive after one time step.
    fn roll(
        &self,
        robot: &DriveNavigator,
        controller: &Controller,
        state: &State,
        goal: [f64; 2],
        random: &mut Random,
    ) -> Result<State, Outcome> {
        let DriveNavigator { drive, noise, sensor } = robot;
        let pose = state.pose;
        let distances = &mut *self.distances.borrow_mut();
        let mut noisy = |deviation: f64| if deviation == 0.0 { 0.0 } else { deviation * random.normal() };
        if let Controller::Policy(_) = controller {
            self.floor.sense(pose, sensor, &self.fan, distances);
            distances.iter_mut().for_each(|distance| *distance += noisy(noise.range));
        }
        let to_goal = [goal[0] - pose[0] + noisy(noise.position), goal[1] - pose[1] + noisy(noise.position)];
        let (sin, cos) = libm::sincos(pose[2] + noisy(noise.heading));
        let [speed, turn_rate] = controller.control(robot, distances, into_frame([sin, cos], to_goal));
        let control = [speed + noisy(noise.speed), turn_rate + noisy(noise.turn_rate)];
        if !self.floor.is_arc_free(pose, control, drive.time_step()) {
            return Err(Outcome::Collision);
        }
        Ok(State::at_rest(bounded(drive.drive(pose, control))))
    }

    /// A carrier of cargo after one time step.
    fn carry(
        &self,
        robot: &CargoNavigator,
        controller: &Controller,
        state: &State,
        goal: [f64; 2],
        random: &mut Random,
    ) -> Result<State, Outcome> {
        let CargoNavigator { cargo, noise, sensor, .. } = robot;
        let State { pose: [x, y, _], velocity, swing, swing_rate } = *state;
        let distances = &mut *self.distances.borrow_mut();
        let mut noisy = |deviation: f64| if deviation == 0.0 { 0.0 } else { deviation * random.normal() };
        let to_goal = [goal[0] - x + noisy(noise.position), goal[1] - y + noisy(noise.position)];
        let direction = libm::atan2(to_goal[1], to_goal[0]);
        if let Controller::Policy(_) = controller {
            self.floor.sense([x, y, direction], sensor, &self.fan, distances);
            distances.iter_mut().for_each(|distance| *distance += noisy(noise.range));
        }
        let deviations = [noise.velocity, noise.swing, noise.velocity];
        let (sin, cos) = libm::sincos(direction);
        let motion = [velocity, swing, swing_rate];
        let motion = std::array::from_fn(|i| into_frame([sin, cos], motion[i].map(|x| x + noisy(deviations[i]))));
        let carried = Carried { distance: hypotenuse(to_goal), motion };
        let wanted = controller.acceleration(robot, distances, &carried);
        let acceleration = into_frame([-sin, cos], wanted).map(|x| x + noisy(noise.acceleration));
        let next = self.floor.carry(cargo, &state.cargo(), acceleration)?;
        let CargoState { position: [x, y], velocity, swing, swing_rate } = next;
        Ok(State { pose: [x, y, direction], velocity, swing, swing_rate })
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
