//! A curve of arcs and straight lines.

use super::{Pose, Segment, Turn, advance};

/// No shortest curve has more segments.
pub const MAX_SEGMENTS: usize = 5;

/// Up to five segments in sequence; all arcs have the same radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve {
    segments: [Segment; MAX_SEGMENTS],
    count: usize,
    radius: f64,
    length: f64,
}

impl Curve {
    /// The curve of the given segments, without those of length 0; `radius` in metres, greater than 0.
    ///
    /// # Panics
    /// If there are more than [`MAX_SEGMENTS`].
    pub fn new(radius: f64, segments: &[(Turn, f64)]) -> Self {
        let nothing = Segment { turn: Turn::Straight, length: 0.0 };
        let mut curve = Self { segments: [nothing; MAX_SEGMENTS], count: 0, radius, length: 0.0 };
        for &(turn, length) in segments {
            if length != 0.0 {
                curve.segments[curve.count] = Segment { turn, length };
                curve.count += 1;
                curve.length += length.abs();
            }
        }
        curve
    }

    /// The segments in the order in which they are driven.
    pub fn segments(&self) -> &[Segment] {
        &self.segments[..self.count]
    }

    /// The length in metres, in either direction.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The same curve driven back from its end. Its segments are those of the curve in reverse, to the bit.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let mut reversed = *self;
        for (new, old) in reversed.segments.iter_mut().zip(self.segments().iter().rev()) {
            *new = Segment { turn: old.turn, length: -old.length };
        }
        reversed
    }

    /// The same curve in a mirror.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mut mirrored = *self;
        mirrored.segments.iter_mut().for_each(|segment| segment.turn = segment.turn.mirrored());
        mirrored
    }

    /// The same curve at another scale, `radius` in metres.
    pub(super) fn scaled(&self, radius: f64) -> Self {
        let mut scaled = *self;
        (scaled.radius, scaled.length) = (radius, 0.0);
        for segment in &mut scaled.segments[..scaled.count] {
            segment.length *= radius;
            scaled.length += segment.length.abs();
        }
        scaled
    }

    /// The curvature of a segment in 1/m, positive to the left.
    pub fn curvature(&self, turn: Turn) -> f64 {
        match turn {
            Turn::Left => 1.0 / self.radius,
            Turn::Straight => 0.0,
            Turn::Right => -1.0 / self.radius,
        }
    }

    /// The pose after `along` metres of the curve driven from `from`, at most its length. O(segments).
    pub fn at(&self, from: Pose, along: f64) -> Pose {
        if along >= self.length {
            return self.end(from);
        }
        let (mut pose, mut left) = (from, along);
        for segment in self.segments() {
            let whole = segment.length.abs();
            let length = if left < whole { libm::copysign(left, segment.length) } else { segment.length };
            pose = advance(pose, self.curvature(segment.turn), length);
            if left <= whole {
                break;
            }
            left -= whole;
        }
        pose
    }

    /// The pose at the end of the curve driven from `from`. O(segments).
    pub fn end(&self, from: Pose) -> Pose {
        self.segments().iter().fold(from, |pose, segment| advance(pose, self.curvature(segment.turn), segment.length))
    }
}
