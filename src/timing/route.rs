//! The pieces of a result's path, and where the robot has to rest between them.

use super::curve::{Curve, norm};
use super::limits::own_speed;
use crate::error::{Code, Error};
use crate::geometry::wrap;
use crate::path::ResultDocument;
use crate::problem::{Motion, Status};
use crate::robot::{Car, LARGEST};
use crate::scenario::{Robot, Scenario};
use std::f64::consts::TAU;

/// Two edges are one straight line if they turn by less than this, in radians.
const STRAIGHT: f64 = 1e-9;

/// Pieces shorter than this are left out: as a share of their edge, or in metres.
const SHORTEST: f64 = 1e-12;

/// A path in pieces.
#[derive(Debug)]
pub(super) struct Route {
    /// Where it begins.
    pub start: Vec<f64>,
    pub pieces: Vec<RoutePiece>,
}

/// A piece with the lengths of its derivative at both ends.
#[derive(Debug)]
pub(super) struct RoutePiece {
    pub curve: Curve,
    pub ends: [f64; 2],
    /// Whether the robot rests where it begins.
    pub is_stop: bool,
}

/// The pieces of the path of a result, its blends included. O(path).
///
/// # Errors
/// `invalid-result`, `unknown-query`
pub(super) fn route(scenario: &Scenario, result: &ResultDocument) -> Result<Route, Error> {
    along(scenario, result, blends)
}

/// The same with the corners that its blends round.
pub(super) fn corners(scenario: &Scenario, result: &ResultDocument) -> Result<Route, Error> {
    along(scenario, result, |_| Ok(&[]))
}

/// The shares of blends of a result.
type Blends = fn(&ResultDocument) -> Result<&[[f64; 2]], Error>;

fn along(scenario: &Scenario, result: &ResultDocument, blends: Blends) -> Result<Route, Error> {
    let invalid = |pointer: &str, sentence: String| Error::new(Code::InvalidResult, pointer, sentence);
    result.check_scenario(scenario)?;
    scenario.find_query(Some(&result.query))?;
    if result.status != Status::Solved {
        return Err(invalid("/status", format!("the status is {}: there is no path", result.status.as_str())));
    }
    let (robot, path) = (scenario.robot(), &result.path);
    if path.is_empty() {
        return Err(invalid("/path", "the path is empty".into()));
    }
    for (i, waypoint) in path.iter().enumerate() {
        let is_good = |x: &f64| x.abs() <= LARGEST;
        if waypoint.len() != robot.dimension() || !waypoint.iter().all(is_good) {
            let sentence = format!("waypoint {i} is no configuration of the robot {}", robot.kind());
            return Err(invalid(&format!("/path/{i}"), sentence));
        }
    }
    let pieces = match robot {
        Robot::Car(car) => driven(car, result)?,
        _ => straight(&robot.circles(), path, blends(result)?),
    };
    Ok(Route { start: path[0].clone(), pieces })
}

/// The shares of the blends of a path, checked; none for a path without.
fn blends(result: &ResultDocument) -> Result<&[[f64; 2]], Error> {
    let Some(blends) = &result.blends else { return Ok(&[]) };
    let wanted = result.path.len().saturating_sub(2);
    if blends.len() != wanted || !blends.iter().flatten().all(|share| (0.0..=0.5).contains(share)) {
        let sentence = format!("the path needs {wanted} pairs of shares from 0 to 0.5");
        return Err(Error::new(Code::InvalidResult, "/blends", sentence));
    }
    Ok(blends)
}

/// Straight edges with blends. A blend whose one share is 0 goes along the other edge: there the corner stays.
fn straight(circles: &[bool], path: &[Vec<f64>], blends: &[[f64; 2]]) -> Vec<RoutePiece> {
    let mut at = path[0].clone();
    // Of the edge before: its step, where its straight part begins, and whether the robot rests there.
    let mut before: Option<Vec<f64>> = None;
    let mut shares = [0.0; 2];
    let mut pieces = Vec::new();
    for i in 1..path.len() {
        let step: Vec<f64> = (0..at.len()).map(|k| difference(circles[k], path[i - 1][k], path[i][k])).collect();
        if norm(&step) == 0.0 {
            continue;
        }
        let (from, mut is_stop) = (at.clone(), true);
        for (k, at) in at.iter_mut().enumerate() {
            *at = if circles[k] { turned(path[i][k], *at + step[k]) } else { path[i][k] };
        }
        let length = norm(&step);
        if let Some(previous) = &before {
            let legs: [Vec<f64>; 2] =
                [previous.iter().map(|d| -shares[0] * d).collect(), step.iter().map(|d| shares[1] * d).collect()];
            if shares[0] > 0.0 {
                pieces.push(blend(&from, &legs));
            }
            let ends = [norm(previous), length];
            let turn: Vec<f64> = previous.iter().zip(&step).map(|(a, b)| a / ends[0] - b / ends[1]).collect();
            is_stop = shares[0] == 0.0 && norm(&turn) > STRAIGHT;
        }
        let begin = shares[1];
        shares = corner(path, blends, circles, i);
        let part = 1.0 - begin - shares[0];
        if part > SHORTEST {
            let start = from.iter().zip(&step).map(|(from, step)| from + begin * step).collect();
            let rate = step.iter().map(|step| part * step).collect();
            let curve = Curve::Straight { from: start, rate };
            pieces.push(RoutePiece { curve, ends: [part * length; 2], is_stop });
        }
        before = Some(step);
    }
    pieces
}

/// The shares of the blend of waypoint `i`: both 0 if its corner stays.
fn corner(path: &[Vec<f64>], blends: &[[f64; 2]], circles: &[bool], i: usize) -> [f64; 2] {
    let Some(&[before, after]) = blends.get(i - 1) else { return [0.0; 2] };
    let is_edge = |to: usize| (0..circles.len()).any(|k| difference(circles[k], path[i][k], path[to][k]) != 0.0);
    if before > 0.0 && after > 0.0 && is_edge(i + 1) { [before, after] } else { [0.0; 2] }
}

/// The blend of a corner with these legs to its ends.
fn blend(corner: &[f64], [u, v]: &[Vec<f64>; 2]) -> RoutePiece {
    let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + b).collect::<Vec<_>>();
    let (from, rate, bend) = (sum(corner, u), u.iter().map(|u| -2.0 * u).collect(), sum(u, v));
    RoutePiece { curve: Curve::Parabola { from, rate, bend }, ends: [2.0 * norm(u), 2.0 * norm(v)], is_stop: false }
}

/// The step of a coordinate, the short way round on a circle.
fn difference(is_circle: bool, a: f64, b: f64) -> f64 {
    if is_circle { wrap(wrap(b) - wrap(a)) } else { b - a }
}

/// The angle plus the whole turns that bring it nearest to another one.
pub(super) fn turned(angle: f64, near: f64) -> f64 {
    angle + TAU * libm::rint((near - angle) / TAU)
}

/// The arcs of a car, which rests where it changes its direction.
fn driven(car: &Car, result: &ResultDocument) -> Result<Vec<RoutePiece>, Error> {
    if let Some(word) = &result.integration {
        let sentence = format!("the motions are integrated by {word}: the car would drive elsewhere");
        return Err(Error::new(Code::InvalidResult, "/integration", sentence));
    }
    let motions = result.motions.as_deref().unwrap_or_default();
    if motions.len() + 1 != result.path.len() {
        let sentence = format!("{} waypoints need as many motions less one, not {}", result.path.len(), motions.len());
        return Err(Error::new(Code::InvalidResult, "/motions", sentence));
    }
    let mut heading = result.path[0][2];
    let mut pieces: Vec<RoutePiece> = Vec::new();
    let mut is_forward = None;
    for (i, (&Motion { control, duration }, at)) in motions.iter().zip(&result.path).enumerate() {
        let length = control.speed * duration;
        let turn = car.turn_rate(control.speed, control.steering) * duration;
        if !(length.is_finite() && turn.is_finite() && own_speed(car, length) > 0.0) && length != 0.0 {
            let sentence = format!("motion {i} is not within the speeds of the car");
            return Err(Error::new(Code::InvalidResult, format!("/motions/{i}"), sentence));
        }
        if length.abs() > SHORTEST {
            let is_stop = is_forward != Some(length > 0.0);
            is_forward = Some(length > 0.0);
            let begin = turned(at[2], heading);
            let curve = Curve::Arc { from: [at[0], at[1], begin], length, turn };
            pieces.push(RoutePiece { curve, ends: [length.abs(); 2], is_stop });
            heading = begin + turn;
        }
    }
    Ok(pieces)
}
