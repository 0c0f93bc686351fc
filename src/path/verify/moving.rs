//! A robot of segments: samples along every edge and blend, and the swept hull of every segment between two samples.
//!
//! Over an interval of an edge a point whose acceleration is bounded by a (per whole edge squared) leaves the chord
//! between its two positions by at most a h^2 / 8, h the interval as a fraction of the edge; a point of a segment, a
//! fixed convex combination of its ends, leaves the hull of its two positions by no more than the ends leave their
//! chords.

use super::near::{Near, near};
use super::{Examined, Scale};
use crate::geometry::{Aabb, Point, Polygon, Segment};
use crate::scenario::{Obstacle, World};

/// Samples that are taken together, so that the obstacles nearby are found once.
const BLOCK: u64 = 64;

/// A part of the path, in words.
#[derive(Debug, Clone, Copy)]
pub(super) enum Stretch {
    /// The edge with this index.
    Edge(usize),
    /// The blend of the waypoint with this index.
    Blend(usize),
}

impl std::fmt::Display for Stretch {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Edge(i) => write!(f, "edge {i}"),
            Self::Blend(i) => write!(f, "the blend of waypoint {i}"),
        }
    }
}

/// A robot along one stretch of the path: a chain of points, every two neighbours the ends of a segment with a radius.
pub(super) struct Moving<'a> {
    /// Which part of the path this is.
    pub stretch: Stretch,
    /// The points of the chain at a fraction of the edge, at least two, always as many.
    pub points: &'a dyn Fn(f64) -> Vec<Point>,
    /// An upper bound on how far each point travels along the whole edge, in metres.
    pub travel: &'a [f64],
    /// How far each point can leave its chord over the whole edge, in metres: an eighth of its greatest acceleration.
    pub bulge: &'a [f64],
    /// Half the width of the segments.
    pub radius: f64,
    /// If the chain is the outline of a body, the body at the start of the edge.
    pub body: Option<Polygon>,
    /// What sentences call the segment from a point on.
    pub part_name: fn(usize) -> String,
}

impl Moving<'_> {
    /// The name of the segment from point `i` on, and of the edge.
    fn name(&self, i: usize) -> String {
        format!("{}, {}", self.stretch, (self.part_name)(i))
    }
}

/// The segment from point `i` on.
fn segment(points: &[Point], i: usize) -> Segment {
    Segment::new(points[i], points[i + 1])
}

pub(super) struct Checker<'a> {
    world: &'a World,
    scale: &'a Scale,
    pub examined: Examined,
    refinements: u64,
}

impl<'a> Checker<'a> {
    pub fn new(world: &'a World, scale: &'a Scale) -> Self {
        Self { world, scale, examined: Examined { samples: 0, clearance: f64::INFINITY }, refinements: 0 }
    }

    /// Examines the robot at the start of the edge, against all obstacles.
    pub fn check_start(&mut self, robot: &Moving) -> Result<(), String> {
        let points = (robot.points)(0.0);
        self.examined.samples += 1;
        for i in 0..points.len() - 1 {
            let here = segment(&points, i);
            // All obstacles once, since one may be inside the body; then those that may be nearer than the nearest so
            // far.
            let nearest = self.touching(robot, i, 0.0).max(self.examined.clearance + robot.radius);
            let reach = if i == 0 { f64::INFINITY } else { nearest };
            for obstacle in near(&self.world.obstacles, &here.aabb(), reach) {
                self.check_segment(robot, i, &obstacle, &here, 0.0)?;
                // A point of each connected part of the border.
                let is_around = |body: &Polygon| match obstacle.obstacle {
                    Obstacle::Disc(disc) => body.contains(disc.center),
                    Obstacle::Polygon(polygon) => body.contains(polygon.vertices()[0]),
                    Obstacle::PolygonWithHoles(polygon) => {
                        polygon.rings().any(|ring| body.contains(ring.vertices()[0]))
                    }
                    Obstacle::Wall(wall) => body.contains(wall.points()[0]),
                };
                if i == 0 && robot.body.as_ref().is_some_and(is_around) {
                    return Err(format!("{} contains obstacle {}", robot.name(i), obstacle.index));
                }
            }
        }
        self.check_inside(robot, &points, 0.0)
    }

    /// Examines the robot along an edge whose start has been examined.
    pub fn check_edge(&mut self, robot: &Moving) -> Result<(), String> {
        let travel = robot.travel.iter().copied().fold(0.0, f64::max);
        let intervals = (travel / self.scale.spacing).ceil().max(1.0) as u64;
        let at = |k: u64| k as f64 / intervals as f64;
        let mut first = 0;
        while first < intervals {
            let last = (first + BLOCK).min(intervals);
            let samples: Vec<(f64, Vec<Point>)> = (first..=last).map(|k| (at(k), (robot.points)(at(k)))).collect();
            self.examined.samples += last - first;
            self.check_block(robot, &samples)?;
            first = last;
        }
        Ok(())
    }

    /// Examines a block of samples, and the intervals between them.
    fn check_block(&mut self, robot: &Moving, samples: &[(f64, Vec<Point>)]) -> Result<(), String> {
        let interval = samples[1].0 - samples[0].0;
        for i in 0..samples[0].1.len() - 1 {
            let around = Aabb::around(samples.iter().flat_map(|(_, points)| [points[i], points[i + 1]]));
            let around = around.expect("a block has two samples");
            let reach = self.touching(robot, i, 2.0 * interval).max(self.examined.clearance + robot.radius);
            let obstacles = near(&self.world.obstacles, &around, reach);
            for (t, points) in &samples[1..] {
                for obstacle in &obstacles {
                    self.check_segment(robot, i, obstacle, &segment(points, i), *t)?;
                }
            }
            for pair in samples.windows(2) {
                let ((t, before), (u, after)) = (&pair[0], &pair[1]);
                for obstacle in &obstacles {
                    self.check_hull(robot, i, obstacle, (*t, &segment(before, i)), (*u, &segment(after, i)))?;
                }
            }
        }
        for pair in samples.windows(2) {
            let ((t, before), (u, after)) = (&pair[0], &pair[1]);
            self.check_inside(robot, after, *u)?;
            self.check_inside_between(robot, (*t, before), (*u, after))?;
        }
        Ok(())
    }

    /// The distance from an obstacle at or below which the hull of segment `i` over an interval of this length is too near.
    fn touching(&self, robot: &Moving, i: usize, interval: f64) -> f64 {
        robot.radius + robot.bulge[i].max(robot.bulge[i + 1]) * interval * interval + self.scale.slack
    }

    /// Returns an error if segment `i` touches the obstacle at `t`.
    fn check_segment(
        &mut self,
        robot: &Moving,
        i: usize,
        obstacle: &Near,
        here: &Segment,
        t: f64,
    ) -> Result<(), String> {
        let clearance = obstacle.distance(here) - robot.radius;
        if clearance <= self.scale.slack {
            return Err(format!("{} touches obstacle {} at t = {t}", robot.name(i), obstacle.index));
        }
        self.examined.clearance = self.examined.clearance.min(clearance);
        Ok(())
    }

    /// Returns an error if segment `i` may touch the obstacle between two samples, both of which were clear.
    fn check_hull(
        &mut self,
        robot: &Moving,
        i: usize,
        obstacle: &Near,
        (t, before): (f64, &Segment),
        (u, after): (f64, &Segment),
    ) -> Result<(), String> {
        if !obstacle.is_near_hull(before, after, self.touching(robot, i, u - t)) {
            return Ok(());
        }
        let middle = 0.5 * (t + u);
        let travel = robot.travel[i].max(robot.travel[i + 1]);
        if travel * (u - t) <= self.scale.slack || middle <= t || middle >= u {
            let (name, index) = (robot.name(i), obstacle.index);
            return Err(format!("{name} comes too near to obstacle {index} between t = {t} and {u}"));
        }
        let here = segment(&self.sample_between(robot, middle)?, i);
        self.check_segment(robot, i, obstacle, &here, middle)?;
        self.check_hull(robot, i, obstacle, (t, before), (middle, &here))?;
        self.check_hull(robot, i, obstacle, (middle, &here), (u, after))
    }

    /// Returns an error if the robot is not wholly within the bounds at `t`.
    fn check_inside(&self, robot: &Moving, points: &[Point], t: f64) -> Result<(), String> {
        match (0..points.len()).find(|&k| self.depth(robot, points[k]) < -self.scale.overstep) {
            Some(k) => Err(format!("{} leaves the bounds at t = {t}", robot.name(k.saturating_sub(1)))),
            None => Ok(()),
        }
    }

    /// Returns an error if the robot may leave the bounds between two samples, at both of which it was inside.
    fn check_inside_between(
        &mut self,
        robot: &Moving,
        (t, before): (f64, &[Point]),
        (u, after): (f64, &[Point]),
    ) -> Result<(), String> {
        let interval = u - t;
        let stays = |k: usize| {
            let depth = self.depth(robot, before[k]).min(self.depth(robot, after[k]));
            depth - robot.bulge[k] * interval * interval >= -self.scale.overstep
        };
        let Some(k) = (0..before.len()).find(|&k| !stays(k)) else { return Ok(()) };
        let middle = 0.5 * (t + u);
        if middle <= t || middle >= u {
            return Err(format!("{} leaves the bounds at t = {t}", robot.name(k.saturating_sub(1))));
        }
        let points = self.sample_between(robot, middle)?;
        self.check_inside(robot, &points, middle)?;
        self.check_inside_between(robot, (t, before), (middle, &points))?;
        self.check_inside_between(robot, (middle, &points), (u, after))
    }

    /// The depth of the point, with the radius around it, within the bounds; negative outside.
    fn depth(&self, robot: &Moving, p: Point) -> f64 {
        self.world.bounds.as_ref().map_or(f64::INFINITY, |bounds| bounds.depth(p) - robot.radius)
    }

    /// The points at one more sample; an error if there have been too many.
    fn sample_between(&mut self, robot: &Moving, t: f64) -> Result<Vec<Point>, String> {
        if self.refinements == self.scale.refinements {
            let (stretch, samples) = (robot.stretch, self.examined.samples);
            return Err(format!("{stretch} cannot be distinguished from contact at t = {t} after {samples} samples"));
        }
        self.refinements += 1;
        self.examined.samples += 1;
        Ok((robot.points)(t))
    }
}
