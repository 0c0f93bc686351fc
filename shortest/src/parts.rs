//! The parts of a map, and the obstacles that they are.

use crate::fault::{Fault, Subject};
use planarium::error::{Code, Error};
use planarium::geometry::Point;
use planarium::scenario::Obstacle;

/// The most positions that a map may have.
pub const MAX_POSITIONS: usize = 1_000_000;

/// What the positions of a part are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// Points, each by itself.
    Points,
    /// A line that is not crossed, from each position to the next.
    Line,
    /// The border of an area, in either direction, closed or open.
    Outline,
    /// A hole in the area whose outline is the last one before it: its inside is free.
    Hole,
}

/// A part of a map.
#[derive(Debug, Clone, Copy)]
pub struct Part<'a> {
    /// What it is.
    pub kind: Kind,
    /// Its positions: longitude and latitude, or x and y.
    pub positions: &'a [[f64; 2]],
}

/// The obstacles that parts are, in the plane.
///
/// # Errors
/// `degenerate-polygon`, `degenerate-wall`, `out-of-range` for a part without positions, `unsupported` for a hole without outline.
pub(crate) fn obstacles(parts: &[Part<'_>], to_plane: impl Fn([f64; 2]) -> Point) -> Result<Vec<Obstacle>, Fault> {
    let points = |part: &Part<'_>| part.positions.iter().map(|&at| to_plane(at)).collect::<Vec<_>>();
    let mut found = Vec::with_capacity(parts.len());
    let mut rest = parts.iter().enumerate().peekable();
    while let Some((number, part)) = rest.next() {
        let refused = |error: Error| {
            let hole = error.pointer().strip_prefix("/holes/").and_then(|hole| hole.parse().ok());
            let at = hole.map_or(number, |hole: usize| number + 1 + hole);
            Fault::new(error.code(), Subject::Part(at), error.message())
        };
        match part.kind {
            Kind::Points => found.extend(points(part).into_iter().map(|at| Obstacle::disc(at, 0.0))),
            Kind::Line => found.push(Obstacle::wall(&points(part), 0.0, false).map_err(refused)?),
            Kind::Outline => {
                let mut holes = Vec::new();
                while let Some((_, hole)) = rest.next_if(|(_, part)| part.kind == Kind::Hole) {
                    holes.push(points(hole));
                }
                found.push(Obstacle::polygon_with_holes(&points(part), &holes).map_err(refused)?);
            }
            Kind::Hole => {
                let sentence = "a hole follows the outline of its area, or another hole of it";
                return Err(Fault::new(Code::Unsupported, Subject::Part(number), sentence));
            }
        }
    }
    Ok(found)
}
