//! Blends of a path: their motion as a polynomial of the fraction t, and their length.
//!
//! With u = before (a - b) and v = after (c - b), the blend of the corner b between a and c is b + (1 - t)^2 u + t^2 v. It starts
//! at b + u with the rate -2 u and has the bend u + v. Its length in any norm lies between those of its chord and of its control
//! polygon; halved until these agree, it is two thirds of the chord and a third of the polygon but for terms of fourth order:
//! Gravesen 1997, "Adaptive subdivision and the length and energy of Bezier curves".

use super::difference;
use crate::error::{Code, Error};
use crate::path::ResultDocument;

/// How closely the lengths of chord and polygon agree where a blend is halved no more, relative to its polygon.
const AGREED: f64 = 1e-11;

/// The length of a step.
pub(super) type Norm<'a> = &'a dyn Fn(&[f64]) -> f64;

/// Coordinates that change as polynomials of t in [0, 1]: q(t) = from + t rate + t^2 bend.
#[derive(Debug, Clone)]
pub(super) struct Quadratic {
    pub from: Vec<f64>,
    pub rate: Vec<f64>,
    pub bend: Vec<f64>,
}

impl Quadratic {
    /// At a constant rate.
    pub fn straight(from: Vec<f64>, rate: Vec<f64>) -> Self {
        let bend = vec![0.0; from.len()];
        Self { from, rate, bend }
    }

    /// Along the blends of a path, each with the index of its waypoint; `shares` are those of its inner waypoints.
    pub fn blends(circles: &[bool], path: &[Vec<f64>], shares: &[[f64; 2]]) -> Vec<(usize, Self)> {
        let blend = |(i, (at, &[before, after])): (usize, (&[Vec<f64>], &[f64; 2]))| {
            let [a, b, c] = [0, 1, 2].map(|k| &at[k]);
            let leg = |share: f64, to: &[f64]| difference(circles, b, to).into_iter().map(move |d| share * d);
            let (u, v): (Vec<f64>, Vec<f64>) = leg(before, a).zip(leg(after, c)).unzip();
            let origin = difference(circles, &vec![0.0; b.len()], b);
            let sums = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + b).collect();
            let rate = u.iter().map(|u| -2.0 * u).collect();
            (i + 1, Self { from: sums(&origin, &u), rate, bend: sums(&u, &v) })
        };
        path.windows(3).zip(shares).enumerate().filter(|(_, (_, shares))| **shares != [0.0; 2]).map(blend).collect()
    }

    /// By how much the blend is shorter than its control polygon.
    pub fn saving(&self, norm: Norm) -> f64 {
        let first: Vec<f64> = self.rate.iter().map(|rate| 0.5 * rate).collect();
        let second: Vec<f64> = first.iter().zip(&self.bend).map(|(first, bend)| first + bend).collect();
        let polygon = norm(&first) + norm(&second);
        polygon - length(&first, &second, norm, AGREED * polygon)
    }
}

/// The length of the blend whose control polygon has these two legs.
fn length(first: &[f64], second: &[f64], norm: Norm, tolerance: f64) -> f64 {
    let chord: Vec<f64> = first.iter().zip(second).map(|(a, b)| a + b).collect();
    let [polygon, straight] = [norm(first) + norm(second), norm(&chord)];
    if polygon - straight <= tolerance {
        return (2.0 * straight + polygon) / 3.0;
    }
    let scaled = |by: f64, leg: &[f64]| leg.iter().map(|x| by * x).collect::<Vec<_>>();
    let middle = scaled(0.25, &chord);
    length(&scaled(0.5, first), &middle, norm, tolerance) + length(&middle, &scaled(0.5, second), norm, tolerance)
}

/// Returns an error unless there is a pair of shares for every inner waypoint, each at most half an edge.
pub(super) fn check(result: &ResultDocument, is_straight: bool) -> Result<&[[f64; 2]], Error> {
    let Some(blends) = &result.blends else { return Ok(&[]) };
    let invalid = |pointer: String, sentence| Err(Error::new(Code::InvalidResult, pointer, sentence));
    let (waypoints, count) = (result.path.len(), blends.len());
    if !is_straight {
        return invalid("/blends".into(), "a car's path has no corners to round".into());
    }
    if waypoints != count + 2 {
        return invalid(
            "/blends".into(),
            format!("{waypoints} waypoints need {} blends, not {count}", waypoints.max(2) - 2),
        );
    }
    for (i, shares) in blends.iter().enumerate() {
        if let Some(k) = shares.iter().position(|share| !(0.0..=0.5).contains(share)) {
            let sentence = format!("a blend begins and ends within half an edge, 0 to 0.5, not at {}", shares[k]);
            return invalid(format!("/blends/{i}/{k}"), sentence);
        }
    }
    Ok(blends)
}
