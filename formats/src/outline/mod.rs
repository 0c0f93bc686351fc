//! Lines, curves and strokes of drawings, on their way to polygons and walls.

mod affine;
mod curve;
mod emit;
mod grow;
mod joints;

pub use affine::{Affine, P3};
pub use curve::{Curve, arc, bulge};
pub use emit::{Shape, add_shapes};

/// How a path is drawn as a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// From side to side, in the units of the path.
    pub width: f64,
    /// The width is at least this, in metres.
    pub least: f64,
    pub cap: Cap,
    /// How far a mitre may reach, in halves of the width; `None` if corners are round or cut off.
    pub miter: Option<f64>,
}

/// The ends of a line. Walls have round ones, which contain those that are cut off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cap {
    ButtOrRound,
    Square,
}

/// A line or a curve that goes on from where the last one ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Piece {
    Line(P3),
    Curve(Curve),
}

impl Piece {
    /// Where it ends.
    pub fn end(&self) -> P3 {
        match self {
            Self::Line(to) => *to,
            Self::Curve(curve) => curve.end(),
        }
    }
}

/// Pieces in a row.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    pub start: P3,
    pub pieces: Vec<Piece>,
    pub closed: bool,
}

impl Path {
    pub fn new(start: P3) -> Self {
        Self { start, pieces: Vec::new(), closed: false }
    }

    /// A path along points.
    pub fn along(points: impl IntoIterator<Item = P3>, closed: bool) -> Option<Self> {
        let mut points = points.into_iter();
        let start = points.next()?;
        Some(Self { start, pieces: points.map(Piece::Line).collect(), closed })
    }

    /// Where the path is so far.
    pub fn end(&self) -> P3 {
        self.pieces.last().map_or(self.start, Piece::end)
    }
}
