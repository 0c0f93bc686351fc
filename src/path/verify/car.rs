//! A car: its motions, recomputed from their controls, and their arcs.

use super::body::{self, Leg};
use super::moving::Stretch;
use super::{Examined, LENGTH, PLACEMENT, Scale, difference};
use crate::path::ResultDocument;
use crate::problem::Motion;
use crate::robot::Car;
use crate::scenario::World;

/// How near to the next waypoint a motion must end, in metres and radians, relative to the coordinates of both if these are
/// larger than a metre.
const LED: f64 = 1e-9;

/// How far the length of a curve may differ from that of its motions, relative to its radius and the coordinates.
const CURVED: f64 = 1e-12;

/// How far a control may lie outside the car's limits, relative to them: the rounding of a document.
const WITHIN: f64 = 1e-12;

/// The largest turn of one motion, in radians, as for planners: after more turns, rounding changes the heading at the end by
/// more than the slack covers.
const LARGEST_TURN: f64 = 1e3;

/// Examines the motions of a car and their arcs.
pub(super) fn check(world: &World, car: &Car, result: &ResultDocument, scale: &Scale) -> Result<Examined, String> {
    if let Some(word) = &result.integration {
        return Err(format!(
            "the motions are integrated by {word}: such a path is an illustration, the car would drive elsewhere"
        ));
    }
    let Some(motions) = &result.motions else {
        return Err("a car's path cannot be verified without its motions".into());
    };
    let path = &result.path;
    if motions.len() + 1 != path.len() {
        return Err(format!("{} waypoints need {} motions, not {}", path.len(), path.len() - 1, motions.len()));
    }
    let (mut legs, mut length, mut chords) = (Vec::with_capacity(motions.len()), 0.0, 0.0);
    for (i, (motion, ends)) in motions.iter().zip(path.windows(2)).enumerate() {
        check_control(car, i, motion)?;
        let (distance, turn) = extent(car, motion);
        if turn.is_nan() || turn.abs() > LARGEST_TURN * (1.0 + WITHIN) {
            return Err(format!("motion {i} turns by {turn:e} rad; at most {LARGEST_TURN} can be verified"));
        }
        let leg = Leg::arc(&ends[0], distance, turn);
        let size = ends.iter().flat_map(|q| &q[..2]).fold(1.0, |most: f64, x| most.max(x.abs()));
        let off = difference(&PLACEMENT, &leg.at(1.0), &ends[1]);
        let most = LED * size + scale.overstep;
        if let Some(k) = off.iter().position(|gap| gap.is_nan() || gap.abs() > most) {
            return Err(format!(
                "motion {i} leads to {:?}, not to waypoint {} {:?} (coordinate {k})",
                leg.at(1.0),
                i + 1,
                ends[1]
            ));
        }
        length += distance.abs();
        legs.push((Stretch::Edge(i), leg));
        let chord = difference(&PLACEMENT, &ends[0], &ends[1]);
        chords += car.weights().translation * libm::hypot(chord[0], chord[1]) + car.weights().rotation * chord[2].abs();
        // The rest of the path to the waypoint, if it matters, is examined as well.
        if off[0].abs() + off[1].abs() + off[2].abs() * car.shape().reach() > scale.slack {
            legs.push((Stretch::Edge(i), Leg::straight(&leg.at(1.0), &ends[1])));
        }
    }
    let off = (result.length - length).abs();
    if off.is_nan() || off > LENGTH * length + rounding(car, path) {
        return Err(format!("the length is given as {} m, but the motions are {length} m long", result.length));
    }
    if let Some(given) = result.chord_length
        && (given - chords).abs() > LENGTH * chords + 1e-12
    {
        return Err(format!("the chord length is given as {given}, but the waypoints are {chords} apart"));
    }
    if legs.is_empty() {
        legs.push((Stretch::Edge(0), Leg::straight(&path[0], &path[0])));
    }
    body::check(world, (car.shape(), car.margin()), legs, scale)
}

/// How far the lengths of the motions may differ from those of the curves that they follow, in metres: a curve ends beside its
/// goal by the rounding of its radius and of the coordinates.
fn rounding(car: &Car, path: &[Vec<f64>]) -> f64 {
    let radius = car.turning_radius().map_or(0.0, |(radius, _)| radius);
    let largest = path.iter().flat_map(|q| &q[..2]).fold(1.0, |most: f64, x| most.max(x.abs()));
    CURVED * (radius + largest) * path.len() as f64
}

/// The distance of a motion along the car's own axis, in metres, and its turn, in radians.
fn extent(car: &Car, motion: &Motion) -> (f64, f64) {
    let Motion { control, duration } = *motion;
    (control.speed * duration, control.speed * libm::tan(control.steering) / car.wheelbase() * duration)
}

/// Returns an error if the control is outside the car's limits, or the duration is not a finite number of at least 0.
fn check_control(car: &Car, i: usize, Motion { control, duration }: &Motion) -> Result<(), String> {
    for (what, value, [low, high]) in
        [("speed", control.speed, car.speed()), ("steering angle", control.steering, car.steering())]
    {
        let slack = WITHIN * low.abs().max(high.abs());
        if !(low - slack..=high + slack).contains(&value) {
            return Err(format!("motion {i} has the {what} {value}, outside [{low}, {high}]"));
        }
    }
    if !(0.0..f64::INFINITY).contains(duration) {
        return Err(format!("motion {i} lasts {duration} s"));
    }
    Ok(())
}
