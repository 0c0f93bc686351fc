//! What the nearness of obstacles adds to the cost of a disc's motion.
//!
//! Each metre at a clearance of c metres costs an extra weight * max(0, 1 - c / within): nothing from `within` on, `weight` at
//! contact. A motion is halved into pieces of at most a sixteenth of `within`, each of which costs what its middle
//! does. Clearances change by at most one metre per metre, so the sum differs from the integral by at most `weight` / 64 of the
//! length, and by far less as a rule; a piece whose middle has `within` and half the piece of clearance costs nothing, exactly.

use crate::geometry::{Point, Segment};

/// The largest piece of a motion, as a part of `within`.
const PIECE: f64 = 1.0 / 16.0;

/// How a disc keeps away from obstacles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct KeepAway {
    /// The extra cost per metre at contact, in metres; 0 or more.
    pub weight: f64,
    /// The clearance from which nothing is added, in metres; above 0.
    pub within: f64,
}

impl KeepAway {
    /// The least `within`, as a fraction of the world's longer side: a motion is halved 16 times at most.
    pub const LEAST: f64 = 1.0 / 2048.0;

    /// What is added to the length of a motion of the centre: the same in both directions, to the bit. `clearance` returns that
    /// at a point, or any number of at least the one given if it is no smaller. O(length / within) clearances.
    pub fn added(&self, swept: &Segment, mut clearance: impl FnMut(Point, f64) -> f64) -> f64 {
        let Segment { a, b } = *swept;
        let along = if (a.x, a.y) <= (b.x, b.y) { Segment::new(a, b) } else { Segment::new(b, a) };
        self.weight * self.nearness(&along, &mut clearance)
    }

    /// The sum of max(0, 1 - c / within) over the length of a piece.
    fn nearness(&self, piece: &Segment, clearance: &mut impl FnMut(Point, f64) -> f64) -> f64 {
        let Segment { a, b } = *piece;
        let (middle, length) = (Point::from((a.coords + b.coords) * 0.5), (b - a).norm());
        let clear = self.within + 0.5 * length;
        let found = clearance(middle, clear);
        if found >= clear {
            return 0.0;
        }
        if length <= PIECE * self.within {
            return length * (1.0 - found / self.within).clamp(0.0, 1.0);
        }
        let [first, last] = [Segment::new(a, middle), Segment::new(middle, b)];
        self.nearness(&first, clearance) + self.nearness(&last, clearance)
    }
}
