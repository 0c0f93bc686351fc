//! Whether a trajectory follows the path of its result: the parts of the path are found again, one after the other.

use super::span::driven;
use super::{LED, PLACED, largest};
use crate::path::ResultDocument;
use crate::problem::Motion;
use crate::robot::Car;
use crate::scenario::Robot;
use crate::timing::{Curve, Limits, Trajectory};
use std::f64::consts::{PI, TAU};

/// A part of the path of the result, at the fractions 0, 1/2 and 1 of it: two parts of the second degree that agree there agree
/// everywhere.
type Stretch = [Vec<f64>; 3];

/// Returns an error unless the pieces follow the parts of the path, one after the other, and all of it.
pub(super) fn follows(robot: &Robot, result: &ResultDocument, trajectory: &Trajectory) -> Result<(), String> {
    let is_circle = robot.circles();
    let gap = |i: usize, a: f64, b: f64| if is_circle[i] { libm::remainder(b - a, TAU) } else { b - a };
    // The path has no heading of a robot that drives along it.
    let own = is_circle.len();
    let apart = |a: &[f64], b: &[f64]| {
        let size = largest(&a[..own]).max(largest(&b[..own])).max(1.0);
        (0..own).map(|i| gap(i, a[i], b[i]).abs()).fold(0.0, f64::max) / size
    };
    if let Some(waypoint) = result.path.iter().find(|waypoint| waypoint.len() != is_circle.len()) {
        return Err(format!("the path has the waypoint {waypoint:?}"));
    }
    let is_differential = matches!(trajectory.limits(), Limits::Differential(_));
    let stretches = match robot {
        Robot::Car(car) => motions(car, result)?,
        _ if is_differential => edges(&result.path, &[], &gap),
        _ => edges(&result.path, result.blends.as_deref().unwrap_or_default(), &gap),
    };
    let mut left = stretches.iter();
    let is_short = |stretch: &Stretch| apart(&stretch[0], &stretch[2]).max(apart(&stretch[0], &stretch[1])) <= PLACED;
    // Whether a turn on the spot would be one at a corner.
    let mut is_corner = false;
    for (i, piece) in trajectory.pieces().iter().enumerate() {
        if is_differential {
            let is_turn = turns(piece.curve()).map_err(|why| format!("piece {i}: {why}"))?;
            if is_turn && !is_corner {
                return Err(format!("piece {i} turns where there is no corner"));
            }
            is_corner = !is_turn;
            if is_turn {
                continue;
            }
        }
        let at = [0.0, 0.5, 1.0].map(|u| curve_at(piece.curve(), u));
        let fits = |stretch: &Stretch| at.iter().zip(stretch).all(|(a, b)| apart(a, b) <= PLACED);
        loop {
            let Some(stretch) = left.next() else { return Err(format!("piece {i} is beyond the path")) };
            if fits(stretch) {
                break;
            }
            if !is_short(stretch) {
                return Err(format!("piece {i} leaves the path: it begins at {:?}", at[0]));
            }
        }
    }
    if left.any(|stretch| !is_short(stretch)) {
        return Err("it does not follow the path to its end".into());
    }
    if is_differential && !is_corner && !trajectory.pieces().is_empty() {
        return Err("it turns at the end of the path".into());
    }
    let ends = [(0.0, result.path.first()), (trajectory.duration(), result.path.last())];
    for (time, waypoint) in ends {
        let at = trajectory.configuration(time);
        if waypoint.is_none_or(|waypoint| apart(&at, waypoint) > PLACED) {
            return Err(format!("at {time} s it is at {at:?}"));
        }
    }
    Ok(())
}

/// Whether a robot that drives along its heading turns on the spot: the short way, and otherwise it drives forward.
fn turns(curve: &Curve) -> Result<bool, String> {
    let Curve::Straight { from, rate } = curve else { return Err("it is not straight".into()) };
    let [x, y, turn] = [rate[0], rate[1], rate[2]];
    let is_turn = x == 0.0 && y == 0.0;
    if is_turn && turn.abs() > PI + PLACED {
        return Err(format!("it turns by {turn}, more than half a turn"));
    }
    let off = libm::remainder(libm::atan2(y, x) - from[2], TAU);
    if is_turn || (turn == 0.0 && off.abs() <= LED) {
        return Ok(is_turn);
    }
    Err(format!("the robot moves sideways, {off} rad from its heading"))
}

fn curve_at(curve: &Curve, u: f64) -> Vec<f64> {
    match curve {
        Curve::Straight { from, rate } => from.iter().zip(rate).map(|(from, rate)| from + u * rate).collect(),
        Curve::Parabola { from, rate, bend } => {
            (0..from.len()).map(|i| from[i] + u * rate[i] + u * u * bend[i]).collect()
        }
        Curve::Arc { from, length, turn } => driven(*from, u * length, u * turn),
    }
}

/// Edges without what their blends replace, and blends by their control points.
fn edges(path: &[Vec<f64>], blends: &[[f64; 2]], gap: &dyn Fn(usize, f64, f64) -> f64) -> Vec<Stretch> {
    let toward = |a: &[f64], b: &[f64], share: f64| -> Vec<f64> {
        (0..a.len()).map(|i| a[i] + share * gap(i, a[i], b[i])).collect()
    };
    let shares = |i: usize| {
        let [before, after] = i.checked_sub(1).and_then(|i| blends.get(i)).copied().unwrap_or_default();
        if before > 0.0 && after > 0.0 { [before, after] } else { [0.0; 2] }
    };
    let mut stretches = Vec::new();
    for i in 0..path.len().saturating_sub(1) {
        let [begin, end] = [shares(i)[1], 1.0 - shares(i + 1)[0]];
        stretches.push([begin, 0.5 * (begin + end), end].map(|share| toward(&path[i], &path[i + 1], share)));
        let [before, after] = shares(i + 1);
        if before > 0.0 && i + 2 < path.len() {
            let corner = &path[i + 1];
            let [a, c] = [toward(corner, &path[i], before), toward(corner, &path[i + 2], after)];
            // Half-way along a parabola: a quarter of each end and half of the corner.
            let middle = (0..corner.len()).map(|k| corner[k] + 0.25 * ((a[k] - corner[k]) + (c[k] - corner[k])));
            stretches.push([a.clone(), middle.collect(), c.clone()]);
        }
    }
    stretches
}

/// The motions of a car.
fn motions(car: &Car, result: &ResultDocument) -> Result<Vec<Stretch>, String> {
    let motions = result.motions.as_deref().unwrap_or_default();
    if motions.len() + 1 != result.path.len() {
        return Err(format!("{} waypoints have {} motions", result.path.len(), motions.len()));
    }
    let stretch = |(motion, at): (&Motion, &Vec<f64>)| {
        let length = motion.control.speed * motion.duration;
        let turn = length * libm::tan(motion.control.steering) / car.wheelbase();
        [0.0, 0.5, 1.0].map(|u| driven([at[0], at[1], at[2]], u * length, u * turn))
    };
    Ok(motions.iter().zip(&result.path).map(stretch).collect())
}
