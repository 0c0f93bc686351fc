//! Curves as rational Bézier curves: Bézier curves of any degree, arcs of circles and ellipses, and pieces of B-splines
//! are such curves, affine maps of their control points map the curve, and the hull of the control points contains it
//! (Farin 2002, Curves and Surfaces for CAGD).

use super::affine::{Affine, P3, norm};
use planarium::geometry::{Point, orientation};
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// The most halvings of a curve. An arc of 90° and 10 km has an error below 1 µm then.
const MAX_DEPTH: u32 = 16;

/// A rational Bézier curve: control points and weights, which are positive.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve(pub Vec<(P3, f64)>);

impl Curve {
    /// A Bézier curve.
    pub fn bezier(points: &[P3]) -> Self {
        Self(points.iter().map(|&p| (p, 1.0)).collect())
    }

    pub fn end(&self) -> P3 {
        self.0.last().map_or([0.0; 3], |control| control.0)
    }

    /// The curve after a map, as seen along z.
    pub fn seen(&self, map: &Affine) -> Vec<[f64; 3]> {
        let seen = |&(p, weight): &(P3, f64)| {
            let [x, y, _] = map.apply(p);
            [x, y, weight]
        };
        self.0.iter().map(seen).collect()
    }
}

/// A curve of the plane as a chain of chords. Control points are x, y and weight.
///
/// Halves it until no control point is farther than the tolerance from the chord, and calls `add` with the end of each
/// chord and with the control points between the ends; the hull of them and the chord contains the piece. Returns the
/// farthest that a point of the curve may be from its chord.
pub fn flatten(
    controls: &[[f64; 3]],
    tolerance: f64,
    mut add: impl FnMut(Point, &[Point]) -> Result<(), crate::FormatError>,
) -> Result<f64, crate::FormatError> {
    let mut error: f64 = 0.0;
    let mut stack = vec![(controls.iter().map(|&[x, y, w]| [x * w, y * w, w]).collect::<Vec<_>>(), 0)];
    while let Some((mut curve, depth)) = stack.pop() {
        let points: Vec<Point> = curve.iter().map(|&[x, y, w]| Point::new(x / w, y / w)).collect();
        let (first, last) = (points[0], points[points.len() - 1]);
        let inner = &points[1..points.len() - 1];
        let far = inner.iter().map(|&p| from_chord(p, first, last)).fold(0.0, f64::max);
        if far <= tolerance || depth == MAX_DEPTH {
            error = error.max(far);
            add(last, inner)?;
            continue;
        }
        let mut left = Vec::with_capacity(curve.len());
        let mut right = curve.clone();
        for i in 0..curve.len() {
            left.push(curve[0]);
            let end = curve.len() - 1 - i;
            right[end] = curve[end];
            for j in 0..end {
                let next = curve[j + 1];
                curve[j] = std::array::from_fn(|k| (curve[j][k] + next[k]) / 2.0);
            }
        }
        stack.push((right, depth + 1));
        stack.push((left, depth + 1));
    }
    Ok(error)
}

/// How far a point is from a chord.
fn from_chord(p: Point, a: Point, b: Point) -> f64 {
    let (chord, offset) = ([b.x - a.x, b.y - a.y], [p.x - a.x, p.y - a.y]);
    let square = chord[0] * chord[0] + chord[1] * chord[1];
    let along = if square > 0.0 { (offset[0] * chord[0] + offset[1] * chord[1]) / square } else { 0.0 };
    let along = along.clamp(0.0, 1.0);
    norm([offset[0] - along * chord[0], offset[1] - along * chord[1]])
}

/// The convex hull of points, counter-clockwise; empty if they lie on a line (Andrew 1979).
pub fn hull(points: &mut Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let half = |points: &mut dyn Iterator<Item = Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for p in points {
            while chain.len() > 1 && orientation(chain[chain.len() - 2], chain[chain.len() - 1], p) <= 0.0 {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut all = half(&mut points.iter().copied());
    all.extend(half(&mut points.iter().rev().copied()));
    if all.len() < 3 { Vec::new() } else { all }
}

/// An arc of an ellipse: center + cos t u + sin t v for t from `from`, over `sweep` radians, as curves of at most 90°.
pub fn arc(center: P3, u: P3, v: P3, from: f64, sweep: f64) -> Vec<Curve> {
    let count = (sweep.abs() / FRAC_PI_2 - 1e-9).ceil().max(1.0);
    let step = sweep / count;
    let weight = libm::cos(step / 2.0);
    let at = |t: f64, reach: f64| -> P3 {
        // Exact at the quarters of a turn.
        let quarters = t / FRAC_PI_2;
        let (sin, cos) = if quarters == quarters.round() {
            super::affine::sin_cos(90.0 * (quarters % 4.0))
        } else {
            libm::sincos(t)
        };
        std::array::from_fn(|i| center[i] + reach * (cos * u[i] + sin * v[i]))
    };
    let piece = |i: f64| {
        let start = from + i * step;
        let middle = at(start + step / 2.0, 1.0 / weight);
        Curve(vec![(at(start, 1.0), 1.0), (middle, weight), (at(start + step, 1.0), 1.0)])
    };
    (0..count as u32).map(|i| piece(f64::from(i))).collect()
}

/// The arc of a bulge between two points of one height, as curves of at most 90°: the bulge is the tangent of a quarter
/// of the angle, positive if the arc goes counter-clockwise.
pub fn bulge(from: P3, to: P3, bulge: f64) -> Vec<Curve> {
    let mut curves = Vec::new();
    let mut stack = vec![(from, to, bulge)];
    while let Some((a, b, bulge)) = stack.pop() {
        let beside = |by: f64| -> P3 {
            let [x, y] = [b[0] - a[0], b[1] - a[1]];
            [(a[0] + b[0]) / 2.0 + by * y / 2.0, (a[1] + b[1]) / 2.0 - by * x / 2.0, a[2]]
        };
        if bulge.abs() > SQRT_2 - 1.0 {
            let apex = beside(bulge);
            let half = bulge / (1.0 + norm([1.0, bulge]));
            stack.push((apex, b, half));
            stack.push((a, apex, half));
            continue;
        }
        let square = bulge * bulge;
        let weight = (1.0 - square) / (1.0 + square);
        curves.push(Curve(vec![(a, 1.0), (beside(2.0 * bulge / (1.0 - square)), weight), (b, 1.0)]));
    }
    curves
}
