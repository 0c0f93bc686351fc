//! The goal configurations of a query.

use crate::error::{Code, Error, Number};
use crate::ik::{
    ClosedFormOptions, Finding, IterativeOptions, MethodOptions, Solver, SolverOptions, Stopping, Verdict, arm_of,
    nearest_reachable,
};
use crate::problem::{Contact, Stepped};
use crate::robot::{Target, link_name};
use crate::scenario::{Goal, Query, Robot, Scenario};
use crate::world::PlanningWorld;

/// The most configurations that reach a target and are goals: more than an arm of few joints has distinct paths to.
const MOST: u64 = 8;

/// The largest final distance of the end effector from the target: a billionth of a metre, or less for an arm of less than a
/// millimetre, a millionth of its reach, but nothing finer than the first number.
const TOLERANCE: [f64; 3] = [1e-12, 1e-9, 1e-6];

/// The most iterations of inverse kinematics for them: some milliseconds.
const ITERATIONS: u64 = 4000;

/// The goal of the query; of a query with a target distinct free configurations that reach it, at least one: all there are
/// if the arm has a closed form, else those that damped least squares finds from the start and from starts that the seed decides;
/// if it finds none, and no joint is prismatic, the one of the exact search for the nearest point.
///
/// # Errors
/// `target-unreachable` if none was found, naming the nearest point; `goal-in-collision` if all that were found
/// touch something, naming what touches what at the first; `unsupported` for an orientation of an arm of one link. The pointer
/// leads to the target of the query, whose index is `index`.
pub(super) fn goals(world: &PlanningWorld, query: &Query, index: usize, seed: u64) -> Result<Vec<Vec<f64>>, Error> {
    let scenario = world.scenario();
    let target = match &query.goal {
        Goal::Configuration(goal) => return Ok(vec![goal.clone()]),
        Goal::Target(target) => *target,
    };
    let pointer = format!("/queries/{index}/target");
    let at_target = |error: Error| Error::new(error.code(), pointer.as_str(), error.message());
    let mut wanted = options(scenario, query, target, seed);
    let mut reach = Solver::new(world, &wanted).map_err(at_target)?;
    reach.step(u64::MAX);
    let arm = arm_of(scenario)?;
    if reach.explain() == Verdict::NotFound && !arm.has_prismatic_joint() {
        // Joints that can hardly move are hard to search, but the exact search knows a configuration.
        let nearest = nearest_reachable(arm, target).map_err(at_target)?;
        wanted.start = Some(nearest.configuration[..reach.dimension()].to_vec());
        reach = Solver::new(world, &wanted).map_err(at_target)?;
        reach.step(u64::MAX);
    }
    let dimension = reach.dimension();
    if !reach.solutions().is_empty() {
        return Ok(reach.solutions().iter().map(|q| q[..dimension].to_vec()).collect());
    }
    let (code, sentence) = match reach.explain() {
        Verdict::InCollision { contacts } => {
            let contacts = Contact::sentence(&contacts, &link_name);
            let all = "every configuration found that reaches the target is in collision";
            (Code::GoalInCollision, format!("{all}: {contacts}"))
        }
        Verdict::OutOfReach { nearest, .. } => {
            let [x, y] = [target.point.x, target.point.y].map(readable);
            let [nx, ny] = [nearest.point.x, nearest.point.y].map(readable);
            let [distance, turn] = [nearest.distance, nearest.turn].map(readable);
            let away = if nearest.turn > 0.0 {
                format!("{distance} m and {turn} rad away")
            } else {
                format!("{distance} m away")
            };
            let sentence = format!(
                "the end effector cannot reach ({x}, {y}): the nearest point that it can is ({nx}, {ny}), {away}"
            );
            (Code::TargetUnreachable, sentence)
        }
        _ => {
            let none = "no configuration that reaches the target was found";
            (Code::TargetUnreachable, format!("{none} from {} starts", reach.stats().restarts + 1))
        }
    };
    Err(Error::new(code, pointer, sentence))
}

/// A length or an angle to a millionth, for a sentence.
fn readable(value: f64) -> Number {
    Number(libm::rint(value * 1e6) / 1e6 + 0.0)
}

/// The request to inverse kinematics.
fn options(scenario: &Scenario, query: &Query, target: Target, seed: u64) -> SolverOptions {
    let (has_closed_form, reach) = if let Robot::Arm(arm) = scenario.robot() {
        let few = 2 + usize::from(target.orientation.is_some());
        (arm.links().len() <= few && !arm.has_prismatic_joint(), arm.reach())
    } else {
        (false, 1.0)
    };
    let [finest, tolerance, part] = TOLERANCE;
    let stopping = Stopping { tolerance: tolerance.min(part * reach).max(finest), max_iterations: ITERATIONS };
    let finding = Finding { solutions: MOST, free_only: true, ..Finding::default() };
    let method = if has_closed_form {
        MethodOptions::ClosedForm(ClosedFormOptions { stopping, finding })
    } else {
        MethodOptions::DampedLeastSquares(IterativeOptions { stopping, finding, ..IterativeOptions::default() })
    };
    SolverOptions { target, method, start: Some(query.start.clone()), seed }
}
