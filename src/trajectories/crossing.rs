//! Whether two trajectories share a point: closed forms for points, segments and arcs, halving for the rest.
//!
//! **Closed forms.** Two closed curves of constant curvature are nearest to each other at an end of one of them, or on their line
//! of centres (for a segment: on the normal through the centre), or at an intersection of their circles. So few candidates
//! decide: those on the smaller circle that the arc contains, each tested against the other curve, and the ends of both. The
//! curves cross if a candidate comes within the slack of the other curve.
//!
//! **Why rounding cannot hide a crossing.** An intersection is found along the smaller circle, of radius r, from its angle
//! to the line of centres, whose cosine is ((d - R)(d + R) + r^2) / (2 d r). The factor d - R has an error of some units in the
//! last place of S; so the error of the cosine is (d + R) / (2 d r) times that, and the found point is off the larger circle by
//! that times d r / R: at most three times the error of d - R, however small r is. Along the smaller circle the distance from
//! the larger one is monotone between the line of centres and its other side. So if a crossing and the point found for it lie
//! on different sides of an end, that end is as near to the other circle; and if the cosine is just beyond 1, the point on
//! the line of centres is. Ends are tested against the other curve, hence a rounded decision at the end of an arc changes
//! distances by rounding only. Concentric arcs, equal or not, are nearest at an end as well. Radii are at most 64 S here, so
//! a centre has an error of about 65 S times 2^-52, 1.5e-14 S, and each distance about three times that: far below the slack
//! of 1e-12 S.

use super::halving::{halve, nearest_point};
use super::particle::Particle;
use super::track::{Arc, Shape, Track};
use crate::geometry::{Point, Segment, Vector, distance_point_segment, distance_segment_segment};
use serde::Serialize;

/// The slack, as a fraction of the scale.
const SLACK: f64 = 1e-12;

/// The least slack, in metres: squares of longer lengths do not underflow.
const SMALLEST: f64 = 1e-150;

/// The most pairs of intervals that are examined before a pair of trajectories counts as crossing.
const BUDGET: u64 = 20_000;

/// Counts of work, the same on every platform. All but the first depend on the index.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Tally {
    /// Trajectories tried.
    pub iterations: u64,
    /// Pairs of boxes around whole trajectories that were compared.
    pub boxes: u64,
    /// Pairs of trajectories that were tested themselves.
    pub pairs: u64,
    /// Pairs of intervals examined by halving.
    pub stretches: u64,
}

/// The slack in a world of that scale, in metres.
pub(super) fn slack(scale: f64) -> f64 {
    (SLACK * scale).max(SMALLEST)
}

/// A point in which two trajectories cross or touch: a point of the first within the slack of the second, in the closed form one
/// of the smaller circle; `None` if they are proven apart. Trajectories within a few slacks, and spirals that would take too long
/// to prove apart, count as crossing.
///
/// # Errors
/// Those of [`Particle::check`], below `/0` or `/1`.
pub fn crossing(first: &Particle, second: &Particle) -> Result<Option<Point>, crate::Error> {
    first.check().map_err(|error| error.under("/0"))?;
    second.check().map_err(|error| error.under("/1"))?;
    let scale = first.scale().max(second.scale());
    let [first, second] = [first, second].map(|particle| Track::new(*particle, scale));
    Ok(meeting(&first, &second, slack(scale), &mut Tally::default()))
}

/// The same for trajectories prepared in one world with that slack; counts the work.
#[inline(never)]
pub(super) fn meeting(a: &Track, b: &Track, eta: f64, tally: &mut Tally) -> Option<Point> {
    tally.boxes += 1;
    if !a.around.grown(2.0 * eta).intersects(&b.around) {
        return None;
    }
    tally.pairs += 1;
    match (&a.shape, &b.shape) {
        (Shape::Straight(s, _), Shape::Straight(t, _)) => segments(s, t, eta),
        (Shape::Straight(s, along), Shape::Arc(arc)) | (Shape::Arc(arc), Shape::Straight(s, along)) => {
            segment_arc(s, *along, arc, eta)
        }
        (Shape::Arc(a), Shape::Arc(b)) if a.radius <= b.radius => arcs(a, b, eta),
        (Shape::Arc(a), Shape::Arc(b)) => arcs(b, a, eta),
        _ => {
            let halving = halve(&a.particle, &b.particle, eta, BUDGET);
            tally.stretches += halving.pairs;
            halving.meeting
        }
    }
}

/// A common point of two segments.
fn segments(s: &Segment, t: &Segment, eta: f64) -> Option<Point> {
    (distance_segment_segment(s, t) <= eta).then(|| nearest_point(s, t))
}

/// A common point of a segment and an arc.
fn segment_arc(s: &Segment, along: Vector, arc: &Arc, eta: f64) -> Option<Point> {
    let normal = Vector::new(-along.y, along.x);
    let away = normal.dot(&(s.a - arc.center));
    if away.abs() > arc.radius + eta {
        return None;
    }
    let to_segment = |p: Point| distance_point_segment(p, s);
    on_circle(arc, normal, away / arc.radius, eta, &to_segment)
        .or_else(|| [arc.start, arc.end].into_iter().find(|&p| to_segment(p) <= eta))
        .or_else(|| [s.a, s.b].into_iter().find(|&p| arc.distance(p) <= eta))
}

/// A common point of two arcs, the smaller one first.
fn arcs(small: &Arc, large: &Arc, eta: f64) -> Option<Point> {
    let between = large.center - small.center;
    let apart = between.norm();
    if apart > small.radius + large.radius + eta || apart < large.radius - small.radius - eta {
        return None;
    }
    let towards = if apart == 0.0 { Vector::x() } else { between / apart };
    let cosine =
        ((apart - large.radius) * (apart + large.radius) + small.radius * small.radius) / (2.0 * apart * small.radius);
    let to_large = |p: Point| large.distance(p);
    on_circle(small, towards, cosine, eta, &to_large)
        .or_else(|| [small.start, small.end].into_iter().find(|&p| to_large(p) <= eta))
        .or_else(|| [large.start, large.end].into_iter().find(|&p| small.distance(p) <= eta))
}

/// The first candidate on the arc within the slack of the other curve: the intersections, `cosine` away from the direction
/// `towards` the other curve, then the two points on the line of centres.
fn on_circle(arc: &Arc, towards: Vector, cosine: f64, eta: f64, distance: &dyn Fn(Point) -> f64) -> Option<Point> {
    let across = Vector::new(-towards.y, towards.x);
    // Not a number if the circles are concentric; then they do not intersect.
    let is_there = cosine.abs() <= 1.0;
    let sine = if is_there { ((1.0 - cosine) * (1.0 + cosine)).sqrt() } else { 0.0 };
    let intersections = [towards * cosine + across * sine, towards * cosine - across * sine];
    let candidates = [(is_there, intersections[0]), (is_there, intersections[1]), (true, towards), (true, -towards)];
    candidates.into_iter().find_map(|(is_there, direction)| {
        let p = arc.center + direction * arc.radius;
        (is_there && arc.contains(direction) && distance(p) <= eta).then_some(p)
    })
}
