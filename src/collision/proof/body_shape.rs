//! A body as convex pieces.

use crate::collision::obstacles::{Face, faces_of};
use crate::geometry::{Polygon, convex_pieces};

/// The convex pieces of a body, one if it is convex.
pub(in crate::collision) struct BodyShape {
    /// The faces of all pieces in the body's own frame, piece by piece, each counter-clockwise.
    pub faces: Vec<Face>,
    ranges: Vec<(u32, u32)>,
    /// The distance from the origin of the frame to the farthest corner, in metres.
    pub reach: f64,
}

impl BodyShape {
    /// Cuts the body into pieces. O(n log n).
    pub fn new(body: &Polygon) -> Self {
        let mut faces = Vec::new();
        let mut ranges = Vec::new();
        for piece in convex_pieces(body) {
            let first = faces.len() as u32;
            faces.extend(faces_of(&piece));
            ranges.push((first, faces.len() as u32));
        }
        Self { faces, ranges, reach: body.reach() }
    }

    /// The number of pieces.
    #[inline(always)]
    pub fn pieces(&self) -> usize {
        self.ranges.len()
    }

    /// The range of a piece's faces among those of all.
    #[inline(always)]
    pub fn range(&self, piece: usize) -> std::ops::Range<usize> {
        let (first, end) = self.ranges[piece];
        first as usize..end as usize
    }
}
