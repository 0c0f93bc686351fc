//! The pieces of a path as functions of a fraction u, with their derivatives.

use crate::geometry::arc_pose;
use serde::Serialize;

/// A piece of a path, as a function of the fraction u in [0, 1] of it. Metres and radians; angles are not wrapped.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Curve {
    /// q(u) = from + u rate.
    Straight {
        /// The configuration at u = 0.
        from: Vec<f64>,
        /// What leads to that at u = 1.
        rate: Vec<f64>,
    },
    /// q(u) = from + u rate + u^2 bend: the blend of a corner.
    Parabola {
        /// The configuration at u = 0.
        from: Vec<f64>,
        /// The derivative at u = 0.
        rate: Vec<f64>,
        /// Half the second derivative.
        bend: Vec<f64>,
    },
    /// The arc of a car: straight if it does not turn.
    Arc {
        /// The placement (x, y, heading) at u = 0.
        from: [f64; 3],
        /// The distance along the car's own axis, in metres, negative backward; not 0.
        length: f64,
        /// The turn, in radians, counter-clockwise.
        turn: f64,
    },
}

/// A configuration with the first and the second derivative by u there.
pub(super) type Jet = [Vec<f64>; 3];

impl Curve {
    /// The configuration at u, and the first and the second derivative. O(dimension).
    pub(super) fn jet(&self, u: f64) -> Jet {
        match self {
            Self::Straight { from, rate } => {
                let at = from.iter().zip(rate).map(|(from, rate)| from + u * rate).collect();
                [at, rate.clone(), vec![0.0; from.len()]]
            }
            Self::Parabola { from, rate, bend } => {
                let at = |i: usize| from[i] + u * (rate[i] + u * bend[i]);
                let slope = |i: usize| rate[i] + 2.0 * u * bend[i];
                let all = 0..from.len();
                [all.clone().map(at).collect(), all.map(slope).collect(), bend.iter().map(|bend| 2.0 * bend).collect()]
            }
            Self::Arc { from, length, turn } => {
                let at = arc_pose(*from, *length, *turn, u);
                let (sin, cos) = libm::sincos(at[2]);
                let across = length * turn;
                [at.to_vec(), vec![length * cos, length * sin, *turn], vec![-across * sin, across * cos, 0.0]]
            }
        }
    }

    /// A bound on the length of the derivative anywhere on it.
    pub(super) fn fastest(&self) -> f64 {
        match self {
            Self::Straight { rate, .. } => norm(rate),
            Self::Parabola { rate, bend, .. } => norm(rate) + 2.0 * norm(bend),
            Self::Arc { length, turn, .. } => length.abs() + turn.abs(),
        }
    }
}

/// The Euclidean length of a vector.
pub(super) fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}
