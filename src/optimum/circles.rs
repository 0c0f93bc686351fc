//! Circles that a shortest path turns around, the lines tangent to two of them, and where one enters other shapes.

use crate::geometry::{Disc, Point, Segment, Vector};
use std::f64::consts::{PI, TAU};

/// How far outside its normals a tangent point of a corner may be, as a sine: a first filter, decided later by distances.
const SIDE: f64 = 1e-9;

/// The direction in which a circle is passed, seen from above.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Turn {
    Left,
    Right,
}

impl Turn {
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    pub fn reversed(self) -> Self {
        if self == Self::Left { Self::Right } else { Self::Left }
    }

    /// On which side of the path the centre of the circle is: 1 on the left, -1 on the right.
    pub fn sign(self) -> f64 {
        if self == Self::Left { 1.0 } else { -1.0 }
    }
}

/// A circle of the free space's border, or with radius 0 a start or a goal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Circle {
    pub disc: Disc,
    /// Of a convex corner the outward unit normals of the edges before and after it: only the arc between them is border.
    pub normals: Option<[Vector; 2]>,
}

impl Circle {
    /// A start or a goal.
    pub fn point(center: Point) -> Self {
        Self { disc: Disc { center, radius: 0.0 }, normals: None }
    }

    /// The point at an angle.
    pub fn at(&self, angle: f64) -> Point {
        at(&self.disc, angle)
    }

    /// Whether the arc of the border, if it is that of a corner alone, contains the direction, or nearly so.
    pub fn has_side(&self, side: &Vector) -> bool {
        self.normals.is_none_or(|[before, after]| {
            before.perp(side) >= -SIDE
                && side.perp(&after) >= -SIDE
                && (before.dot(side) >= -SIDE || after.dot(side) >= -SIDE)
        })
    }
}

/// The point of a circle at an angle.
pub(super) fn at(disc: &Disc, angle: f64) -> Point {
    let (sin, cos) = libm::sincos(angle);
    disc.center + disc.radius * Vector::new(cos, sin)
}

/// A shortest path: its length, and its points, where arcs are replaced by chords.
pub(super) type Path = (f64, Vec<Point>);

/// The part of a line between the points where it touches two circles.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tangent {
    pub segment: Segment,
    /// The angles of its ends on their circles, in [0, 2 pi).
    pub angles: [f64; 2],
}

/// The tangent on which one leaves a circle after a turn around it and begins a turn around another; `None` if there is none, or
/// if it touches a corner from within its polygon. O(1).
///
/// With the unit normal n to the left of the tangent, a circle passed with a left turn is touched at its centre - radius n. So
/// n (centre_b - centre_a) is the difference of the signed radii; an error of n changes the length in second order only.
pub(super) fn tangent([a, b]: [&Circle; 2], turns: [Turn; 2]) -> Option<Tangent> {
    let between = b.disc.center - a.disc.center;
    let distance = between.norm();
    let signed = [turns[0].sign() * a.disc.radius, turns[1].sign() * b.disc.radius];
    let along = signed[1] - signed[0];
    if along.abs() >= distance {
        return None;
    }
    let (cos, unit) = (along / distance, between / distance);
    let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
    let left = cos * unit + sin * Vector::new(-unit.y, unit.x);
    let sides = turns.map(|turn| -turn.sign() * left);
    if !a.has_side(&sides[0]) || !b.has_side(&sides[1]) {
        return None;
    }
    let ends = [a.disc.center - signed[0] * left, b.disc.center - signed[1] * left];
    Some(Tangent { segment: Segment::new(ends[0], ends[1]), angles: sides.map(|side| angle_of(&side)) })
}

/// The angles at which the circle crosses the border of a disc.
pub(super) fn crossings_disc(circle: &Disc, other: &Disc, found: &mut Vec<f64>) {
    let between = other.center - circle.center;
    let squared = between.norm_squared();
    let (r, s) = (circle.radius, other.radius);
    let cos = ((r - s) * (r + s) + squared) / (2.0 * r * squared.sqrt());
    crossings(&between, cos, found);
}

/// The angles at which the circle crosses the line of all points x with `normal` (x - centre) = `height`; the normal has
/// length 1.
pub(super) fn crossings_line(circle: &Disc, normal: &Vector, height: f64, found: &mut Vec<f64>) {
    crossings(normal, height / circle.radius, found);
}

/// The two angles whose directions have the given cosine with an axis.
fn crossings(axis: &Vector, cos: f64, found: &mut Vec<f64>) {
    // Without a crossing it is outside, and with coincident centres NaN or infinite.
    if cos.abs() <= 1.0 {
        let (middle, half) = (angle_of(axis), libm::acos(cos));
        found.extend([middle - half, middle + half].map(turned));
    }
}

/// The angle of a direction, in [0, 2 pi).
pub(super) fn angle_of(direction: &Vector) -> f64 {
    turned(libm::atan2(direction.y, direction.x))
}

/// An angle of at most a turn to either side in [0, 2 pi).
pub(super) fn turned(angle: f64) -> f64 {
    if angle < 0.0 {
        (angle + TAU).min(TAU.next_down())
    } else if angle >= TAU {
        angle - TAU
    } else {
        angle + 0.0
    }
}

/// The angle from one direction to another to the left, in [0, 2 pi).
pub(super) fn turn_left(from: f64, to: f64) -> f64 {
    turned(to - from)
}

/// Angles from one to another, both included, at most `most` apart, to draw an arc.
pub(super) fn along_arc(from: f64, to: f64, turn: Turn, most: f64) -> impl Iterator<Item = f64> {
    let whole = if turn == Turn::Left { turn_left(from, to) } else { -turn_left(to, from) };
    let pieces = libm::ceil(whole.abs() / most).clamp(1.0, 2.0 * PI / most + 1.0) as u32;
    (0..=pieces).map(move |i| from + whole * (f64::from(i) / f64::from(pieces)))
}
