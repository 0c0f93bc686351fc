//! Configurations that callers ask a run about, made states of its space.

use crate::error::{Code, Error, Number};
use crate::scenario::LARGEST;
use crate::space::Space;

/// The states of a question's start and goal.
///
/// # Errors
/// `wrong-dimension`, `not-finite` or `out-of-range`, with the pointer `/start` or `/goal`, or of the number.
pub(super) fn ends<S: Space>(space: &S, start: &[f64], goal: &[f64]) -> Result<[S::State; 2], Error> {
    for (q, what) in [(start, "start"), (goal, "goal")] {
        if q.len() != space.dimension() {
            let sentence = format!("the {what} must have {} numbers, not {}", space.dimension(), q.len());
            return Err(Error::new(Code::WrongDimension, format!("/{what}"), sentence));
        }
        if let Some(i) = q.iter().position(|&x| !is_fit(x)) {
            let sentence = format!("the {what} has {} for coordinate {i}", Number(q[i]));
            return Err(Error::new(code(q[i]), format!("/{what}/{i}"), sentence));
        }
    }
    let ends = [start, goal].map(|q| space.state(q));
    for (end, what) in ends.iter().zip(["start", "goal"]) {
        if !space.contains(end) {
            let sentence = format!("the {what} {:?} lies outside the limits", space.coordinates(end));
            return Err(Error::new(Code::OutOfRange, format!("/{what}"), sentence));
        }
    }
    Ok(ends)
}

/// The states of rows of two configurations.
///
/// # Errors
/// `wrong-dimension`, `not-finite` or `out-of-range`, with the pointer `/ends`.
pub(super) fn motions<S: Space>(space: &S, ends: &[f64]) -> Result<Vec<[S::State; 2]>, Error> {
    let dimension = space.dimension();
    if !ends.len().is_multiple_of(2 * dimension) {
        let sentence =
            format!("a row of ends must have {} numbers; {} numbers are not whole rows", 2 * dimension, ends.len());
        return Err(Error::new(Code::WrongDimension, "/ends", sentence));
    }
    if let Some(i) = ends.iter().position(|&x| !is_fit(x)) {
        return Err(Error::new(code(ends[i]), "/ends", format!("an end has {} for a coordinate", Number(ends[i]))));
    }
    let state = |row: usize| {
        let state = space.state(&ends[row * dimension..][..dimension]);
        if space.contains(&state) {
            return Ok(state);
        }
        let sentence = format!("the end {:?} lies outside the limits", space.coordinates(&state));
        Err(Error::new(Code::OutOfRange, "/ends", sentence))
    };
    (0..ends.len() / dimension / 2).map(|row| Ok([state(2 * row)?, state(2 * row + 1)?])).collect()
}

/// Whether a number can be a coordinate.
fn is_fit(x: f64) -> bool {
    x.abs() <= LARGEST
}

/// What is wrong with a number that cannot.
fn code(x: f64) -> Code {
    if x.is_finite() { Code::OutOfRange } else { Code::NotFinite }
}
