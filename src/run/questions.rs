//! Configurations in the requests of callers, converted to states of a run's space.

use crate::error::{Code, Error, Number};
use crate::scenario::LARGEST;
use crate::space::Space;

/// The states of the start and the goal of a query.
///
/// # Errors
/// `wrong-dimension`, `not-finite` or `out-of-range`, with the pointer `/start` or `/goal`, or of the number.
pub(super) fn ends<S: Space>(space: &S, start: &[f64], goal: &[f64]) -> Result<[S::State; 2], Error> {
    Ok([configuration(space, start, "start", "/start")?, configuration(space, goal, "goal", "/goal")?])
}

/// The state of a configuration within the limits.
///
/// # Errors
/// `wrong-dimension`, `not-finite` or `out-of-range`, with the pointer, or that of the number.
pub(super) fn configuration<S: Space>(space: &S, q: &[f64], what: &str, pointer: &str) -> Result<S::State, Error> {
    if q.len() != space.dimension() {
        let sentence = format!("the {what} must have {} numbers, not {}", space.dimension(), q.len());
        return Err(Error::new(Code::WrongDimension, pointer, sentence));
    }
    check_numbers(q, &format!("the {what}"), |i| format!("{pointer}/{i}"))?;
    state(space, q, what, pointer)
}

/// The states of rows of two configurations.
///
/// # Errors
/// `wrong-dimension`, `not-finite` or `out-of-range`, with the pointer `/ends`.
pub(super) fn motions<S: Space>(space: &S, ends: &[f64]) -> Result<Vec<[S::State; 2]>, Error> {
    let width = 2 * space.dimension();
    if !ends.len().is_multiple_of(width) {
        let sentence = format!("a row of ends must have {width} numbers; {} numbers are not whole rows", ends.len());
        return Err(Error::new(Code::WrongDimension, "/ends", sentence));
    }
    check_numbers(ends, "an end", |_| "/ends".to_owned())?;
    let end = |q| state(space, q, "end", "/ends");
    ends.chunks_exact(width).map(|row| row.split_at(width / 2)).map(|(a, b)| Ok([end(a)?, end(b)?])).collect()
}

/// Refuses numbers that cannot be coordinates.
fn check_numbers(numbers: &[f64], what: &str, pointer: impl Fn(usize) -> String) -> Result<(), Error> {
    let Some(i) = numbers.iter().position(|x| !(-LARGEST..=LARGEST).contains(x)) else { return Ok(()) };
    let code = if numbers[i].is_finite() { Code::OutOfRange } else { Code::NotFinite };
    Err(Error::new(code, pointer(i), format!("{what} has {} for a coordinate", Number(numbers[i]))))
}

/// The state, if it lies within the limits.
fn state<S: Space>(space: &S, q: &[f64], what: &str, pointer: &str) -> Result<S::State, Error> {
    let state = space.state(q);
    if space.contains(&state) {
        return Ok(state);
    }
    let sentence = format!("the {what} {:?} lies outside the limits", space.coordinates(&state));
    Err(Error::new(Code::OutOfRange, pointer, sentence))
}
