//! A path as rows: its corners, a car's arcs as chords, and a trajectory at its knots, so that straight lines between rows are
//! the path, or no farther from it than is allowed.

use super::curve::{Curve, norm};
use super::route::{corners, turned};
use super::trajectory::{State, Trajectory};
use crate::error::{Code, Error, within};
use crate::path::ResultDocument;
use crate::scenario::Scenario;

/// The most rows of a path.
pub const MAX_ROWS: usize = crate::path::MAX_WAYPOINTS;

/// The deviation where none is given, in metres and radians.
pub const DEVIATION: f64 = 1e-3;

/// Two times that differ by no more than this share are one.
const TOGETHER: f64 = 1e-12;

/// The least and the greatest deviation, in metres and radians.
const DEVIATIONS: [f64; 2] = [1e-9, 1e6];

/// The path of a result as rows, one configuration each, in metres and radians: its waypoints, without those that repeat the one
/// before, and between those of a car as many places of its arcs as bring straight chords within `deviation` of them, in metres.
/// Blends are left out: the corners are free as well. Angles are continuous, not wrapped.
///
/// # Errors
/// `out-of-range` or `not-finite` (pointer `/deviation`) unless the deviation lies within 1e-9 and 1e6, and there are at most
/// [`MAX_ROWS`] rows; `unknown-query` and `invalid-result` as of [`time`](super::time).
///
/// # Complexity
/// O(rows)
pub fn rows(scenario: &Scenario, result: &ResultDocument, deviation: f64) -> Result<Vec<Vec<f64>>, Error> {
    check_deviation(deviation)?;
    let route = corners(scenario, result)?;
    let mut rows = Vec::with_capacity(route.pieces.len() + 1);
    for piece in &route.pieces {
        let parts = parts(&piece.curve, 1.0, deviation, rows.len())?;
        rows.extend((0..parts).map(|k| piece.curve.jet(k as f64 / parts as f64)[0].clone()));
    }
    // The last waypoint itself, not where rounding leads.
    let last = route.pieces.last().zip(result.path.last()).map(|(piece, last)| {
        let ([end, ..], circles) = (piece.curve.jet(1.0), scenario.robot().circles());
        let at = |k: usize| if circles[k] { turned(last[k], end[k]) } else { last[k] };
        (0..last.len()).map(at).collect()
    });
    rows.push(last.unwrap_or(route.start));
    Ok(rows)
}

impl Trajectory {
    /// The states at all knots, and between them at as many times as bring straight chords within `deviation` of the path, in
    /// metres and radians: so every corner is there. Between two of them the second derivative of the fraction of the piece is
    /// constant.
    ///
    /// # Errors
    /// `out-of-range` or `not-finite` (pointer `/deviation`) unless the deviation lies within 1e-9 and 1e6, and there are at most
    /// [`MAX_ROWS`] states.
    ///
    /// # Complexity
    /// O(states)
    pub fn rows(&self, deviation: f64) -> Result<Vec<State>, Error> {
        check_deviation(deviation)?;
        let mut states: Vec<State> = Vec::new();
        for (begin, piece, knots) in self.spans() {
            let [from, to] = knots;
            let width = to[0] - from[0];
            let parts = parts(piece.curve(), width, deviation, states.len())?;
            for k in 0..parts {
                let u = from[0] + width * (k as f64 / parts as f64);
                let rate = (from[1] * from[1] + 2.0 * from[2] * (u - from[0])).max(0.0).sqrt();
                // The first is at the knot itself: there the rate may be 0.
                let time = if k == 0 { begin } else { begin + 2.0 * (u - from[0]) / (from[1] + rate) };
                add(&mut states, State::along(piece.curve(), u, rate, from[2], time));
            }
        }
        add(&mut states, self.state(self.duration()));
        Ok(states)
    }
}

/// Adds a state, in place of one at the same time, to the digits of tables: two knots can be nearer than these can tell apart.
/// The first stays.
fn add(states: &mut Vec<State>, state: State) {
    if states.last().is_some_and(|last| state.time - last.time <= TOGETHER * state.time) {
        if states.len() == 1 {
            return;
        }
        states.pop();
    }
    states.push(state);
}

fn check_deviation(deviation: f64) -> Result<(), Error> {
    let [least, most] = DEVIATIONS;
    within("/deviation", "the deviation in metres", deviation, least..=most).map(drop)
}

/// Into how many equal parts a part of a curve is cut, `width` wide in u. A curve whose second derivative is at most b is within
/// b/8 of its chord on an interval of 1, and within b / (8 n^2) of the chords of n parts.
fn parts(curve: &Curve, width: f64, deviation: f64, before: usize) -> Result<usize, Error> {
    let second = match curve {
        Curve::Straight { .. } => 0.0,
        Curve::Parabola { bend, .. } => 2.0 * norm(bend),
        Curve::Arc { length, turn, .. } => (length * turn).abs(),
    };
    let wanted = (width * (second / (8.0 * deviation)).sqrt()).ceil().max(1.0);
    if before as f64 + wanted < MAX_ROWS as f64 {
        return Ok(wanted as usize);
    }
    if wanted > 1.0 {
        let sentence = format!("chords within {deviation} m of the path are more than {MAX_ROWS} rows");
        return Err(Error::new(Code::OutOfRange, "/deviation", sentence));
    }
    Err(Error::new(Code::InvalidResult, "/path", format!("the path has more than {MAX_ROWS} rows")))
}
