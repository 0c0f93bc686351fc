//! A translating disc or point: the swept region of an edge is exact.

use super::near::distance_segment_obstacle;
use super::{Scale, Seen};
use crate::geometry::{Point, Segment, distance_point_segment, intersects_segment_polygon};
use crate::robot::DiscRobot;
use crate::scenario::{Obstacle, World};

/// Examines every edge as the segment that the centre moves along.
pub(super) fn judge(world: &World, disc: &DiscRobot, path: &[Vec<f64>], scale: &Scale) -> Result<Seen, String> {
    let radius = disc.radius();
    let centers: Vec<Point> = path.iter().map(|q| Point::new(q[0], q[1])).collect();
    if let Some(bounds) = &world.bounds {
        let overstep = if radius == 0.0 { 0.0 } else { scale.overstep };
        // The bounds are convex: with every waypoint, every edge is inside.
        if let Some(i) = centers.iter().position(|&p| bounds.depth(p) - radius < -overstep) {
            return Err(format!("waypoint {i} leaves the bounds"));
        }
    }
    let mut seen = Seen { looks: 0, clearance: f64::INFINITY };
    for edge in 0..(centers.len() - 1).max(1) {
        let swept = Segment::new(centers[edge], centers[(edge + 1).min(centers.len() - 1)]);
        seen.looks += 1;
        for (i, obstacle) in world.obstacles.iter().enumerate() {
            let apart = super::near::gap(&swept.aabb(), &obstacle.aabb()) - radius;
            if apart > scale.slack && apart >= seen.clearance {
                continue;
            }
            let clearance = distance_segment_obstacle(&swept, obstacle) - radius;
            let touches = match obstacle {
                Obstacle::Polygon(polygon) if radius == 0.0 => intersects_segment_polygon(&swept, polygon),
                _ => clearance <= scale.slack,
            };
            if touches {
                return Err(format!("edge {edge} touches obstacle {i}{}", ends_inside(&swept, obstacle)));
            }
            seen.clearance = seen.clearance.min(clearance.max(0.0));
        }
    }
    Ok(seen)
}

/// Which ends of the edge are in contact.
fn ends_inside(swept: &Segment, obstacle: &Obstacle) -> &'static str {
    let inside = |p: Point| match obstacle {
        Obstacle::Polygon(polygon) => polygon.contains(p),
        Obstacle::Disc(disc) => distance_point_segment(disc.center, &Segment::new(p, p)) <= disc.radius,
    };
    match (inside(swept.a), inside(swept.b)) {
        (true, true) => ", which holds both its ends",
        (true, false) => ", which holds its first end",
        (false, true) => ", which holds its last end",
        (false, false) => "",
    }
}
