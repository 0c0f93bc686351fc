//! A piece of a trajectory between two knots: its coordinates as polynomials of the time, an arc integrated numerically.

use crate::timing::{Curve, Piece};

/// The times of a span that are examined, beside its ends.
const SAMPLES: u32 = 16;

/// The longest part of an arc that is integrated at once, in radians, with the nodes and weights of Gauss and Legendre.
const PART: f64 = 0.25;
const GAUSS: [[f64; 2]; 5] = [
    [0.046910077030668004, 0.11846344252809454],
    [0.23076534494715845, 0.23931433524968324],
    [0.5, 0.28444444444444444],
    [0.7692346550528415, 0.23931433524968324],
    [0.953089922969332, 0.11846344252809454],
];

/// A piece between two knots, as a function of the time.
pub(super) struct KnotSpan<'a> {
    piece: &'a Piece,
    /// u as a polynomial of the time.
    u: [f64; 3],
    /// The coordinates as polynomials of the time; none of a car.
    coordinates: Vec<[f64; 5]>,
    pub duration: f64,
}

impl<'a> KnotSpan<'a> {
    pub fn new(piece: &'a Piece, from: &[f64; 3], to: &[f64; 3]) -> Self {
        let [begin, rate, second] = *from;
        let u = [begin, rate, 0.5 * second];
        Self { piece, u, coordinates: polynomials(piece.curve(), u), duration: 2.0 * (to[0] - begin) / (rate + to[1]) }
    }

    /// The times to examine: evenly spaced ones, and where a coordinate is fastest or accelerates most.
    pub fn times(&self) -> Vec<f64> {
        let mut times: Vec<f64> = (0..=SAMPLES).map(|k| self.duration * f64::from(k) / f64::from(SAMPLES)).collect();
        for &[_, _, second, third, fourth] in &self.coordinates {
            // The jerk is 6 c3 + 24 c4 t, the acceleration 2 c2 + 6 c3 t + 12 c4 t^2.
            let root = (9.0 * third * third - 24.0 * second * fourth).sqrt();
            let roots = [
                -third / (4.0 * fourth),
                (root - 3.0 * third) / (12.0 * fourth),
                (-root - 3.0 * third) / (12.0 * fourth),
            ];
            times.extend(roots.into_iter().filter(|time| *time > 0.0 && *time < self.duration));
        }
        times.sort_by(f64::total_cmp);
        times
    }

    /// Position, velocity and acceleration; of a car the last two along and across its heading in place of x and y.
    pub fn at(&self, t: f64) -> [Vec<f64>; 3] {
        if let Curve::Arc { from, length, turn } = *self.piece.curve() {
            let [u, rate, second] =
                [self.u[0] + t * (self.u[1] + t * self.u[2]), self.u[1] + 2.0 * t * self.u[2], 2.0 * self.u[2]];
            let speed = length * rate;
            let velocity = vec![speed, 0.0, turn * rate];
            return [
                driven(from, u * length, u * turn),
                velocity,
                vec![length * second, speed * turn * rate, turn * second],
            ];
        }
        let place = |[a, b, c, d, e]: &[f64; 5]| a + t * (b + t * (c + t * (d + t * e)));
        let velocity = |[_, b, c, d, e]: &[f64; 5]| b + t * (2.0 * c + t * (3.0 * d + t * 4.0 * e));
        let acceleration = |[_, _, c, d, e]: &[f64; 5]| 2.0 * c + t * (6.0 * d + t * 12.0 * e);
        [
            self.coordinates.iter().map(place).collect(),
            self.coordinates.iter().map(velocity).collect(),
            self.coordinates.iter().map(acceleration).collect(),
        ]
    }
}

/// The coordinates as polynomials of the time; none of a car.
fn polynomials(curve: &Curve, u: [f64; 3]) -> Vec<[f64; 5]> {
    let [a, b, c] = u;
    let square = [a * a, 2.0 * a * b, b * b + 2.0 * a * c, 2.0 * b * c, c * c];
    let polynomial = |from: f64, rate: f64, bend: f64| {
        let mut sum = square.map(|term| bend * term);
        for (sum, term) in sum.iter_mut().zip(u) {
            *sum += rate * term;
        }
        sum[0] += from;
        sum
    };
    match curve {
        Curve::Straight { from, rate } => (0..from.len()).map(|i| polynomial(from[i], rate[i], 0.0)).collect(),
        Curve::Parabola { from, rate, bend } => {
            (0..from.len()).map(|i| polynomial(from[i], rate[i], bend[i])).collect()
        }
        Curve::Arc { .. } => Vec::new(),
    }
}

/// Where a car is after an arc, integrated numerically.
pub(super) fn driven([mut x, mut y, theta]: [f64; 3], length: f64, turn: f64) -> Vec<f64> {
    let parts = libm::ceil(turn.abs() / PART).max(1.0) as u32;
    let [step, bend] = [length / f64::from(parts), turn / f64::from(parts)];
    for part in 0..parts {
        for [node, weight] in GAUSS {
            let (sin, cos) = libm::sincos(theta + bend * (f64::from(part) + node));
            (x, y) = (x + weight * step * cos, y + weight * step * sin);
        }
    }
    vec![x, y, theta + turn]
}
