//! A wall: a chain of segments with a width.

use super::chain::Chain;
use super::polygon::is_exact;
use super::{Aabb, Placed, Point, Segment};
use serde::Serialize;

/// The reason why a list of points is not a wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum WallFault {
    /// A coordinate of this point is neither 0 nor of a magnitude in [[`MIN_MAGNITUDE`](super::MIN_MAGNITUDE),
    /// [`MAX_MAGNITUDE`](super::MAX_MAGNITUDE)]; NaN and infinity included.
    Magnitude(usize),
    /// All points are the same, or there is none.
    TooFewPoints,
}

/// All points within half the width of a chain of segments, which may cross itself: ends and joints are round. What a
/// closed wall encloses does not belong to it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "type", rename = "wall")]
pub struct Wall {
    points: Chain,
    width: f64,
    closed: bool,
}

impl Wall {
    /// The wall along the points, of a width of at least 0; of a closed one the last point is joined to the first. Points that
    /// repeat their predecessor are dropped.
    ///
    /// # Errors
    /// The [`WallFault`].
    pub fn new(points: &[Point], width: f64, closed: bool) -> Result<Self, WallFault> {
        if let Some(i) = points.iter().position(|&p| !is_exact(p)) {
            return Err(WallFault::Magnitude(i));
        }
        // Adding zero turns -0 into +0, so that equal coordinates are equal bits.
        let mut distinct: Vec<Point> = points.iter().map(|p| Point::new(p.x + 0.0, p.y + 0.0)).collect();
        distinct.dedup();
        while closed && distinct.len() > 1 && distinct[0] == distinct[distinct.len() - 1] {
            distinct.pop();
        }
        if distinct.len() < 2 {
            return Err(WallFault::TooFewPoints);
        }
        Ok(Self::of(distinct, width, closed))
    }

    /// The wall without width along a segment, whose ends differ.
    pub(super) fn line(s: &Segment) -> Self {
        Self::of(vec![s.a, s.b], 0.0, false)
    }

    /// The wall along distinct points.
    fn of(points: Vec<Point>, width: f64, closed: bool) -> Self {
        Self { points: Chain::new(points, closed), width, closed }
    }

    /// The points that the segments join, without repetition.
    pub fn points(&self) -> &[Point] {
        self.points.points()
    }

    /// The width in metres.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Half the width, in metres.
    pub fn radius(&self) -> f64 {
        0.5 * self.width
    }

    /// Whether the last point is joined to the first.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The segments in order, without their width.
    pub fn segments(&self) -> impl Iterator<Item = Segment> + '_ {
        self.points.edges()
    }

    /// The smallest box around the wall.
    pub fn aabb(&self) -> Aabb {
        self.points.aabb().grown(self.radius())
    }

    /// The walls of one segment each that it consists of.
    pub fn pieces(&self) -> impl Iterator<Item = Self> + '_ {
        self.segments().map(|s| Self::of(vec![s.a, s.b], self.width, false))
    }

    /// Whether the closed segment shares a point with the line of the wall, as if this had no width; exact.
    pub fn line_meets_segment(&self, s: &Segment) -> bool {
        self.points.aabb().intersects(&s.aabb()) && Placed::of_chain(&self.points).border_meets_segment(s)
    }

    /// The distance from the segment, in metres, 0 or less if they share a point; if it is `most` or more, that distance
    /// or infinity.
    pub fn distance_to_segment(&self, s: &Segment, most: f64) -> f64 {
        let radius = self.radius();
        Placed::of_chain(&self.points).border_to_segment(s, most + radius, &mut 0) - radius
    }

    /// The distance from the polygon, in metres, 0 or less if they share a point; if it is `most` or more, that distance
    /// or infinity.
    pub fn distance_to_polygon(&self, other: &Placed, most: f64) -> f64 {
        let (line, radius) = (Placed::of_chain(&self.points), self.radius());
        if other.contains(line.corner(0)) {
            return -radius;
        }
        line.border_to_border(other, most + radius, &mut 0) - radius
    }

    /// Calls `visit` with every segment whose box meets the given one, in order, until it returns true; returns whether it
    /// did.
    pub fn any_segment_near(&self, near: &Aabb, mut visit: impl FnMut(&Segment) -> bool) -> bool {
        let visit = |_, edge: &Segment| edge.aabb().intersects(near) && visit(edge);
        Placed::of_chain(&self.points).any_edge(|aabb| aabb.intersects(near), visit)
    }
}
