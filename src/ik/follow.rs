//! An arm that follows a moving target: smoothly from its configuration to one whose tip is at the target, or as near as
//! possible.

use super::gradient_descent::GradientDescent;
use super::iterative::{DampedLeastSquares, Method};
use super::kinematics::manipulability;
use super::task::{Task, configuration};
use crate::error::Error;
use crate::geometry::Point;
use crate::robot::{Arm, MAX_LINKS, Target};
use serde::Serialize;

/// The most updates of one descent.
const UPDATES: usize = 80;

/// An error that falls by less than this fraction has settled.
const SETTLED: f64 = 1e-7;

/// A target counts as reached within this fraction of the reach, and no nearer than rounding allows.
const NEAR: f64 = 1e-9;

/// Bending an arm helps if the squared error falls below this fraction.
const HELPS: f64 = 0.99;

/// The angle by which a straight arm is bent before it can be drawn in, relative to the angle that the target requires.
const BEND: f64 = 0.3;

/// An arm that has followed a target.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Followed {
    /// The configuration: radians, or metres of prismatic joints.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Float64Array"))]
    pub configuration: Vec<f64>,
    /// The position of the tip, in metres.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Point"))]
    pub point: Point,
    /// Its distance from the target, in metres.
    pub distance: f64,
    /// The rotation from the last link to the wanted orientation, in radians.
    pub turn: f64,
    /// Whether both are within 1e-9 of the reach, or of a radian.
    #[serde(rename = "reached")]
    pub is_reached: bool,
    /// Yoshikawa's manipulability, in square metres: 0 if the arm is singular.
    pub manipulability: f64,
}

/// Moves the arm from `q` towards the target by damped least squares, within its limits. Small changes of the target make small
/// changes of the joints, wherever that is possible; beyond the arm's reach it stretches towards the target. If the limits keep
/// it away, it does not jump to another configuration that would be nearer. At most 320 updates, each O(links).
///
/// # Errors
/// `wrong-dimension`, `not-finite`, `out-of-range` of the configuration, pointers below `/q`; of the target as in
/// [`nearest_reachable`](super::nearest_reachable).
pub fn follow(arm: &Arm, q: &[f64], target: Target) -> Result<Followed, Error> {
    let q = configuration(arm, q, "/q")?;
    let wanted = Task::new(arm, &target.checked(arm)?);
    let task = drawn_in(&wanted);
    let enough = task.finest.max(1e-3 * NEAR * task.reach);
    let mut at = approached(&task, q, enough);
    if task.deviation(&at).error() > enough {
        // The linear model of a straight arm has no direction that draws it in: it has to be bent first, if that helps.
        let other = approached(&task, bent(&task, &at), enough);
        if task.deviation(&other).square() < HELPS * task.deviation(&at).square() {
            at = other;
        }
    }
    let end = wanted.deviation(&at);
    let near = wanted.finest.max(NEAR * wanted.reach);
    Ok(Followed {
        configuration: at[..task.joints.count].to_vec(),
        point: arm.end_effector(&at),
        distance: end.distance,
        turn: end.turn,
        is_reached: end.distance <= near && end.turn <= NEAR,
        manipulability: manipulability(arm, &at[..task.joints.count]),
    })
}

/// Damped least squares from `q` until the error has settled, then gradient descent: to a target that the limits keep out of
/// reach damped least squares converge slowly.
fn approached(task: &Task, q: [f64; MAX_LINKS], enough: f64) -> [f64; MAX_LINKS] {
    let near = best(task, &mut DampedLeastSquares::new(), q, enough, SETTLED);
    best(task, &mut GradientDescent::default(), near, enough, f64::NEG_INFINITY)
}

/// The best configuration of a descent from `q`, which ends once the error is `enough` or an update decreases the squared error
/// by less than the fraction `settled`.
fn best(task: &Task, method: &mut dyn Method, q: [f64; MAX_LINKS], enough: f64, settled: f64) -> [f64; MAX_LINKS] {
    let (mut best, mut least, mut at) = (q, task.deviation(&q).square(), q);
    for _ in 0..UPDATES {
        let before = task.deviation(&at);
        if before.error() <= enough {
            break;
        }
        let Some(next) = method.update(task, &at) else {
            break;
        };
        at = next;
        let square = task.deviation(&at).square();
        if square < least {
            (best, least) = (at, square);
        }
        if square > before.square() * (1.0 - settled) {
            break;
        }
    }
    best
}

/// The task with its target moved to the ring that the arm could reach without limits.
fn drawn_in(task: &Task) -> Task {
    let mut task = task.clone();
    let ([x, y], count) = task.wrist();
    let [inner, outer] = task.ring(count);
    let r = (x * x + y * y).sqrt();
    if r > 0.0 && !(inner..=outer).contains(&r) {
        let move_by = r.max(inner).min(outer) / r - 1.0;
        task.point = [task.point[0] + x * move_by, task.point[1] + y * move_by];
    }
    task
}

/// The configuration with every joint but the first bent a little to the side with the larger remaining range, the less the
/// nearer the target is.
fn bent(task: &Task, q: &[f64; MAX_LINKS]) -> [f64; MAX_LINKS] {
    let joints = &task.joints;
    let angle = BEND * (task.deviation(q).distance / task.reach).min(1.0).sqrt();
    let mut bent = *q;
    for i in 1..joints.count {
        let [low, high] = joints.ranges[i];
        let side = if !joints.is_circle(i) && high - q[i] < q[i] - low { -angle } else { angle };
        bent[i] = joints.hold(i, q[i] + side * joints.unit(i));
    }
    bent
}
