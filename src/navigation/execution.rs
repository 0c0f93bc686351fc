//! A path of positions executed: the robot drives to one after the other, with noise.

use super::document::Navigation;
use super::outcome::Outcome;
use super::policy::Policy;
use super::rollout::{Controller, Drive, Simulation, State, generator};
use crate::error::{Code, Error};
use crate::random::{Stream, check_seed};

/// Executes paths on a floor, under a policy or a controller that does not use its rays.
pub struct Executor {
    simulation: Simulation,
    controller: Controller,
}

impl Executor {
    /// The executor of a task's robot: under the policy or, without one, under a controller that drives straight towards the next
    /// position, and turns to it if it has to.
    ///
    /// # Errors
    /// `unsupported` if the policy is of another robot (pointer `/policy/robot`) or senses in another way (`/policy/sensor`).
    pub fn new(task: &Navigation, policy: Option<&Policy>) -> Result<Self, Error> {
        Ok(Self { simulation: Simulation::new(task), controller: Controller::new(policy, task.robot())? })
    }

    /// Drives from a configuration to each position of a path in turn; its first position is the start's and is not driven to.
    /// Each position is reached as a goal is. A trial number stands for one draw of all noise.
    ///
    /// # Errors
    /// `out-of-range` for a seed beyond 2^53 - 1 or an empty path (pointer `/path`); `not-finite`; `start-in-collision`.
    pub fn drive(&self, from: [f64; 3], path: &[[f64; 2]], seed: u64, trial: u64) -> Result<Drive, Error> {
        check_seed(seed)?;
        if path.is_empty() {
            return Err(Error::new(Code::OutOfRange, "/path", "a path that is executed has at least one position"));
        }
        check_finite(&from, "/start")?;
        for (i, position) in path.iter().enumerate() {
            check_finite(position, &format!("/path/{i}"))?;
        }
        if !self.simulation.floor.is_free(from) {
            return Err(self.simulation.floor.start_in_collision(from));
        }
        let mut random = generator(seed, Stream::Rollouts, &[trial]);
        let robot = self.simulation.task().robot();
        let mut state = State::at_rest(from);
        let mut states = vec![state];
        let mut outcome = Outcome::Reached;
        for &[x, y] in &path[1..] {
            let (dx, dy) = (x - state.pose[0], y - state.pose[1]);
            let patience = self.simulation.patience((dx * dx + dy * dy).sqrt());
            let visit = |state| states.push(state);
            let progress = self.simulation.drive(&self.controller, state, [x, y], patience, &mut random, visit);
            outcome = progress.outcome;
            if outcome != Outcome::Reached {
                break;
            }
            state = progress.state;
        }
        Ok(Drive::new(robot, outcome, &states))
    }
}

/// Refuses coordinates that are not finite.
pub(super) fn check_finite(coordinates: &[f64], pointer: &str) -> Result<(), Error> {
    if coordinates.iter().all(|x| x.is_finite()) {
        return Ok(());
    }
    Err(Error::new(Code::NotFinite, pointer, format!("a coordinate must be a finite number, not {coordinates:?}")))
}

impl Drive {
    /// The length of the trace, in metres.
    pub fn length(&self) -> f64 {
        let step = |pair: &[[f64; 3]]| {
            let (x, y) = (pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]);
            (x * x + y * y).sqrt()
        };
        self.trace.windows(2).map(step).sum()
    }
}
