//! Time-optimal timing of finished paths, proven.
//!
//! A path says where a robot goes; a [`Trajectory`] says when. [`time`] follows the path of a result, its blends included, from
//! rest to rest as fast as [`Limits`] allow, and rests in between only at corners without a blend, and where a car changes its
//! direction. A disc with [`DifferentialLimits`] drives the corners without their blends, and turns on the spot at each. On
//! straight edges and arcs the timing is optimal to 1.3e-7 of its duration; along a blend it is that of a grid of 139 intervals
//! or more, and within 0.5 % of that of a much finer one.
//!
//! **Promise.** No limit is exceeded at any time: that is proven in closed form, interval by interval, and not at samples (see
//! `proof`). [`verify()`] examines a trajectory by other code. Whether a path is free is decided by
//! [`path::verify`](crate::path::verify()), not here.
//!
//! [`rows()`] makes a table of a path, [`Trajectory::rows`] and [`Trajectory::sampled`] make one of a trajectory.

mod curve;
mod differential;
mod document;
mod interval;
mod limits;
mod options;
mod profile;
mod proof;
mod route;
mod rows;
mod trajectory;
mod verify;

pub use curve::Curve;
pub use document::FORMAT;
pub use limits::{CarLimits, CoordinateLimits, DifferentialLimits, Limits, PlaneLimits};
pub use options::LimitOptions;
pub use rows::{DEVIATION, MAX_ROWS, rows};
pub use trajectory::{Piece, State, Trajectory};
pub use verify::{Verdict, verify, verify_document};

use crate::error::Error;
use crate::path::ResultDocument;
use crate::scenario::{Robot, Scenario};
use limits::dot;
use profile::{Limit, Span};
use route::{RoutePiece, corners, route};

/// How much more time than needed is taken where rounding has exceeded a limit.
const ROUNDED: f64 = 1.0 + 4.0 * f64::EPSILON;

/// The fastest trajectory along the path of a result within limits, from rest to rest.
///
/// # Errors
/// Those of [`Limits::check`]; `unknown-query` (pointer `/query`); `invalid-result` with a pointer into the result if it belongs
/// to another scenario, is not solved, or has a path, blends or motions that cannot be followed: those of a car as they are
/// driven, not integrated by Euler's steps.
///
/// # Complexity
/// O(waypoints), about a tenth of a millisecond for a blend and less than a microsecond for an edge.
pub fn time(scenario: &Scenario, result: &ResultDocument, limits: &Limits) -> Result<Trajectory, Error> {
    limits.check(scenario.robot())?;
    let route = match limits {
        Limits::Differential(_) => differential::driven(corners(scenario, result)?),
        _ => route(scenario, result)?,
    };
    let spans: Vec<Span> = route.pieces.iter().map(|piece| span(piece, scenario.robot(), limits)).collect();
    let curves = route.pieces.into_iter().map(|piece| piece.curve);
    let timed = curves.zip(profile::profile(&spans)).map(|(curve, knots)| Piece { curve, knots });
    let mut pieces: Vec<Piece> = timed.collect();
    // What rounding exceeds is taken away everywhere alike.
    let stretch = proof::shares(limits, &pieces).stretch();
    if stretch > 1.0 {
        let [first, second] = [1.0 / (stretch * ROUNDED), 1.0 / (stretch * stretch * ROUNDED * ROUNDED)];
        for knot in pieces.iter_mut().flat_map(|piece| &mut piece.knots) {
            *knot = [knot[0], knot[1] * first, knot[2] * second];
        }
    }
    let trajectory = Trajectory::new([&result.scenario, &result.query], limits.clone(), route.start, pieces);
    proof::check(&trajectory).map_err(|error| error.at("/path"))?;
    Ok(trajectory)
}

/// A piece with what limits it.
fn span(piece: &RoutePiece, robot: &Robot, limits: &Limits) -> Span {
    let limit = match &piece.curve {
        &Curve::Arc { length, turn, .. } => {
            let car = if let Robot::Car(car) = robot { Some(car) } else { None };
            Limit::Constant(limits.along(length, turn, car))
        }
        curve @ Curve::Straight { .. } => {
            Limit::Constant(limits.bounds(curve).iter().fold([f64::INFINITY; 2], |[speed, acceleration], bound| {
                let size = dot(bound.slope, bound.slope).sqrt();
                [speed.min(bound.speed / size), acceleration.min(bound.acceleration / size)]
            }))
        }
        curve @ Curve::Parabola { .. } => Limit::Blend(limits.bounds(curve)),
    };
    Span { limit, ends: piece.ends, is_stop: piece.is_stop }
}
