//! A body as convex pieces.

use crate::collision::obstacles::faces_of;
use crate::geometry::{Polygon, Vector, convex_pieces};

/// A corner of a convex piece in the body's own frame, and the face that starts from it: its outward unit normal, and the
/// piece's support in that direction.
#[derive(Debug, Clone, Copy)]
pub(in crate::collision) struct Corner {
    pub at: Vector,
    pub normal: Vector,
    pub support: f64,
}

/// The convex pieces of a body, one where it is convex.
pub(in crate::collision) struct BodyShape {
    /// The corners of all pieces, piece by piece, each counter-clockwise.
    corners: Vec<Corner>,
    ranges: Vec<(u32, u32)>,
    reach: f64,
}

impl BodyShape {
    /// Cuts the body into pieces. O(n log n).
    pub fn new(body: &Polygon) -> Self {
        let mut corners = Vec::new();
        let mut ranges = Vec::new();
        for piece in convex_pieces(body) {
            let first = corners.len() as u32;
            corners.extend(faces_of(&piece).map(|face| Corner {
                at: face.corner.coords,
                normal: face.normal,
                support: face.support,
            }));
            ranges.push((first, corners.len() as u32));
        }
        Self { corners, ranges, reach: body.reach() }
    }

    /// How many pieces there are.
    #[inline(always)]
    pub fn pieces(&self) -> usize {
        self.ranges.len()
    }

    /// The corners of all pieces.
    pub fn corners(&self) -> &[Corner] {
        &self.corners
    }

    /// The range of a piece's corners among those of all.
    #[inline(always)]
    pub fn range(&self, piece: usize) -> std::ops::Range<usize> {
        let (first, end) = self.ranges[piece];
        first as usize..end as usize
    }

    /// The distance from the origin of the frame to the farthest corner, in metres.
    pub fn reach(&self) -> f64 {
        self.reach
    }
}
