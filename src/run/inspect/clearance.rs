//! The clearance of a robot, for viewers: by parry's closest points. Planners and proofs use their own
//! distances.

use super::Inspector;
use crate::error::Error;
use crate::geometry::{Aabb, Point, Segment};
use crate::robot::Part;
use crate::scenario::Obstacle;
use parry2d_f64::math::{Pose, Vector};
use parry2d_f64::query::ClosestPoints;
use parry2d_f64::query::details::closest_points_segment_segment;
use parry2d_f64::shape;
use serde::Serialize;

/// The part of a robot and the obstacle that are nearest to each other, lengths in metres. The robot is as large as it is planned
/// for: its margin counts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Clearance {
    /// The distance between them less the margin of the robot, 0 or more.
    pub distance: f64,
    /// The part, by its index in the footprint.
    pub part: usize,
    /// The obstacle, by its index in the document.
    pub obstacle: usize,
    /// The point of the part, grown by the margin, and the point of the obstacle: they are `distance` apart.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[Point, Point]"))]
    pub points: [Point; 2],
}

/// The number of segments that share a box.
const RUN: usize = 8;

/// The boundary of a shape: all points at a distance from segments.
pub(super) struct Boundary {
    segments: Vec<shape::Segment>,
    /// Around every [`RUN`] segments in sequence.
    boxes: Vec<Aabb>,
    radius: f64,
}

impl Boundary {
    fn new(segments: impl IntoIterator<Item = Segment>, radius: f64) -> Self {
        let vector = |point: Point| Vector::new(point.x, point.y);
        let segments: Vec<Segment> = segments.into_iter().collect();
        let around = |run: &[Segment]| Aabb::around(run.iter().flat_map(|s| [s.a, s.b])).expect("a run has a segment");
        let boxes = segments.chunks(RUN).map(around).collect();
        let segment = |segment: &Segment| shape::Segment::new(vector(segment.a), vector(segment.b));
        Self { segments: segments.iter().map(segment).collect(), boxes, radius }
    }

    pub(super) fn of_obstacle(obstacle: &Obstacle) -> Self {
        match obstacle {
            Obstacle::Disc(disc) => Self::new([Segment::new(disc.center, disc.center)], disc.radius),
            Obstacle::Polygon(polygon) => Self::new(polygon.edges(), 0.0),
            Obstacle::PolygonWithHoles(polygon) => Self::new(polygon.edges(), 0.0),
            Obstacle::Wall(wall) => Self::new(wall.segments(), wall.radius()),
        }
    }

    /// Of a part that is larger by a margin on all sides.
    fn of_part(part: &Part, margin: f64) -> Self {
        match part {
            Part::Capsule { a, b, radius } => Self::new([Segment::new(*a, *b)], radius + margin),
            Part::Disc { center, radius } => Self::new([Segment::new(*center, *center)], radius + margin),
            Part::Polygon { vertices } => {
                let ends = vertices.iter().zip(vertices.iter().cycle().skip(1));
                Self::new(ends.map(|(&a, &b)| Segment::new(a, b)), margin)
            }
        }
    }

    /// The distance to another boundary that this one does not cross, and the nearest points.
    fn distance(&self, other: &Self) -> (f64, [Point; 2]) {
        let mut nearest = (f64::INFINITY, [Vector::ZERO; 2]);
        let pairs = self
            .boxes
            .iter()
            .zip(self.segments.chunks(RUN))
            .flat_map(|own| other.boxes.iter().zip(other.segments.chunks(RUN)).map(move |theirs| (own, theirs)));
        for ((around, run), (other_around, other_run)) in pairs {
            // A little less, since distances are rounded.
            if around.gap_squared(other_around).sqrt() * (1.0 - 1e-9) > nearest.0 {
                continue;
            }
            for (s, t) in run.iter().flat_map(|s| other_run.iter().map(move |t| (s, t))) {
                if let ClosestPoints::WithinMargin(a, b) =
                    closest_points_segment_segment(&Pose::identity(), s, t, f64::MAX)
                    && (b - a).length() < nearest.0
                {
                    nearest = ((b - a).length(), [a, b]);
                }
            }
        }
        let (distance, [a, b]) = nearest;
        let across = (b - a).normalize_or_zero();
        let points = [a + across * self.radius, b - across * other.radius];
        ((distance - self.radius - other.radius).max(0.0), points.map(|point| Point::new(point.x, point.y)))
    }
}

impl Inspector {
    /// The distance from the robot at `q`, with its margin, to the nearest obstacle; `None` if it touches something by
    /// [`check`](Self::check), or if there are no obstacles. The bounds do not count. The same measure as that of a [verified
    /// path](crate::path::Verdict::Valid). O(edges of the robot times edges of the obstacles).
    ///
    /// # Errors
    /// Of the configuration: see [`Inspector`].
    pub fn clearance(&self, q: &[f64]) -> Result<Option<Clearance>, Error> {
        if !self.check(q)?.is_empty() {
            return Ok(None);
        }
        let mut least: Option<Clearance> = None;
        let robot = self.world.robot();
        for (part, placed) in robot.footprint(q).iter().map(|part| Boundary::of_part(part, robot.margin())).enumerate()
        {
            for (obstacle, boundary) in self.obstacles.iter().enumerate() {
                let (distance, points) = placed.distance(boundary);
                if least.is_none_or(|least| distance < least.distance) {
                    least = Some(Clearance { distance, part, obstacle, points });
                }
            }
        }
        Ok(least)
    }
}
