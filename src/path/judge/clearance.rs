//! The smallest clearance of a path that is free.
//!
//! No clearance changes faster than the farthest point of the robot travels. So a clearance d at one place shows that the path
//! has more than d less that travel on either side of it: branch and bound by this bound (Piyavskii 1972, "An algorithm for
//! finding the absolute extremum of a function"; of distances between moving bodies: Mirtich 1996, "Impulse-based dynamic
//! simulation", conservative advancement). What is known at the end of one motion holds at the beginning of the next.
//!
//! ```text
//! best = the clearance of the first waypoint
//! for each motion, without its beginning that is known to be far enough:
//!     while an interval is open:
//!         d = the clearance in its middle; best = min(best, d)
//!         drop what lies within (d - best + tolerance) / travel of the middle; the rest is open
//! ```
//!
//! The tolerance is a thousandth of the best, and a micrometre at least. After [`MOST`] clearances and four a motion it is
//! doubled whenever as many have been taken again.

use super::PathPlace;
use super::moves::Moves;
use crate::collision::Obstacles;
use crate::geometry::Point;
use serde::Serialize;

/// The tolerance relative to the clearance, and the least, in metres.
const TOLERANCE: f64 = 1e-3;
const LEAST: f64 = 1e-6;

/// The number of clearances after which the tolerance is doubled.
const MOST: u64 = 1 << 19;

/// The smallest clearance of a path, in metres.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathClearance {
    /// The smallest that was found: that at this place.
    pub distance: f64,
    /// No clearance of the path is smaller.
    pub at_least: f64,
    /// The place on the path.
    #[serde(flatten)]
    pub at: PathPlace,
    /// The part of the robot: the link of an arm, from 0.
    pub part: usize,
    /// The obstacle, by its index.
    pub obstacle: usize,
    /// The point of the obstacle that is nearest to the robot.
    pub point: Point,
}

/// The smallest clearance of a free path; `None` without obstacles.
pub(super) fn smallest(moves: &Moves, obstacles: &Obstacles) -> Option<PathClearance> {
    let rest = moves.rest(0);
    let first = moves.placed(&rest.at(0.0)).nearest(obstacles, f64::INFINITY)?;
    let (mut best, mut at, mut known) = (first.distance, (rest, 0.0), first.distance);
    let (mut found, mut at_least) = (first, best);
    let (mut left, mut tolerance) = (MOST + 4 * moves.edges() as u64, 1.0);
    let mut open: Vec<[f64; 2]> = Vec::new();
    for leg in (0..moves.edges()).flat_map(|edge| moves.of_edge(edge)) {
        let travel = moves.travel(&leg);
        let enough = |best: f64, tolerance: f64| best - tolerance * (TOLERANCE * best).max(LEAST);
        let reached = (known - enough(best, tolerance)) / travel;
        at_least = at_least.min(enough(best, tolerance));
        known -= travel;
        if travel > 0.0 && reached < 1.0 {
            open.push([reached.max(0.0), 1.0]);
        }
        while let Some([low, high]) = open.pop() {
            let [middle, half] = [0.5 * (low + high), 0.5 * (high - low)];
            let q = leg.at(middle);
            let wanted = enough(best, tolerance) + half * travel;
            let most = wanted.max(2.0 * best).min(8.0 * best);
            let near = moves.placed(&q).nearest(obstacles, most);
            let distance = near.as_ref().map_or(most, |near| near.distance);
            known = known.max(distance - travel * (1.0 - middle));
            if let Some(near) = near.filter(|near| near.distance < best) {
                (best, at, found) = (near.distance, (leg, middle), near);
            }
            left -= 1;
            if left == 0 {
                (left, tolerance) = (MOST, 2.0 * tolerance);
            }
            let bound = enough(best, tolerance);
            at_least = at_least.min(bound);
            let covered = (distance - bound) / travel;
            if covered < half {
                open.extend([[middle + covered, high], [low, middle - covered]]);
            }
        }
    }
    let (leg, t) = at;
    let point = moves.placed(&leg.at(t)).nearest_point(found.part, obstacles.shape(found.obstacle));
    Some(PathClearance {
        distance: best,
        at_least: at_least.max(0.0),
        at: leg.place(t, moves.dimension()),
        part: found.part,
        obstacle: found.obstacle,
        point,
    })
}
