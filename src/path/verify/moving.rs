//! A robot of segments: looks along every edge, and the swept hull of every segment between two looks.
//!
//! Over a stretch of an edge a point whose acceleration is bounded by a (per whole edge squared) leaves the chord between its
//! two places by at most a h^2 / 8, h the stretch as a fraction of the edge; a point of a segment, a fixed mix of its ends, leaves
//! the hull of both its places by no more than the ends leave their chords.

use super::near::{Near, Shape, near};
use super::swept::Swept;
use super::{Scale, Seen};
use crate::geometry::{Aabb, Point, Segment};
use crate::scenario::World;

/// Looks that are taken together, so that what is near is asked for once.
const BLOCK: u64 = 64;

/// How many looks in between may be taken for one path.
const MOST_REFINEMENTS: u64 = 10_000_000;

/// A robot on its way along one edge of the path: a chain of points, every two neighbours the ends of a segment with a radius.
pub(super) trait Moving {
    /// Which edge of the path.
    fn edge(&self) -> usize;

    /// The points of the chain at fraction `t` of the edge, at least two, always as many.
    fn points(&self, t: f64) -> Vec<Point>;

    /// How far point `k` travels along the whole edge, at most, in metres.
    fn travel(&self, k: usize) -> f64;

    /// How far point `k` can leave its chord over the whole edge, in metres: an eighth of its greatest acceleration.
    fn bulge(&self, k: usize) -> f64;

    /// Half the width of the segments.
    fn radius(&self) -> f64;

    /// What to call the segment from point `i` on.
    fn name(&self, i: usize) -> String;

    /// Whether the robot at the start of the edge has the point inside, away from all segments.
    fn encloses(&self, p: Point) -> bool;
}

/// The segment from point `i` on.
fn segment(points: &[Point], i: usize) -> Segment {
    Segment::new(points[i], points[i + 1])
}

pub(super) struct Judge<'a> {
    world: &'a World,
    scale: &'a Scale,
    pub seen: Seen,
    refinements: u64,
}

impl<'a> Judge<'a> {
    pub fn new(world: &'a World, scale: &'a Scale) -> Self {
        Self { world, scale, seen: Seen { looks: 0, clearance: f64::INFINITY }, refinements: 0 }
    }

    /// Looks at the robot where the edge starts, all obstacles in view.
    pub fn look_at_start(&mut self, robot: &dyn Moving) -> Result<(), String> {
        let points = robot.points(0.0);
        self.seen.looks += 1;
        for i in 0..points.len() - 1 {
            let here = segment(&points, i);
            for thing in near(&self.world.obstacles, &here.aabb(), f64::INFINITY) {
                self.look(robot, i, &thing, &here, 0.0)?;
                let inside = match &thing.shape {
                    Shape::Disc(disc) => disc.center,
                    Shape::Polygon(polygon, _) => polygon.vertices()[0],
                };
                if i == 0 && robot.encloses(inside) {
                    return Err(format!("edge {}, {} holds obstacle {}", robot.edge(), robot.name(i), thing.index));
                }
            }
        }
        self.check_inside(robot, &points, 0.0)
    }

    /// Follows the robot along an edge whose start has been looked at.
    pub fn follow(&mut self, robot: &dyn Moving) -> Result<(), String> {
        let points = robot.points(0.0).len();
        let travel = (0..points).map(|k| robot.travel(k)).fold(0.0, f64::max);
        let stretches = (travel / self.scale.spacing).ceil().max(1.0) as u64;
        let at = |k: u64| k as f64 / stretches as f64;
        let mut first = 0;
        while first < stretches {
            let last = (first + BLOCK).min(stretches);
            let looks: Vec<(f64, Vec<Point>)> = (first..=last).map(|k| (at(k), robot.points(at(k)))).collect();
            self.seen.looks += last - first;
            self.follow_block(robot, &looks)?;
            first = last;
        }
        Ok(())
    }

    /// Judges a block of looks, and the stretches between them.
    fn follow_block(&mut self, robot: &dyn Moving, looks: &[(f64, Vec<Point>)]) -> Result<(), String> {
        let stretch = looks[1].0 - looks[0].0;
        for i in 0..looks[0].1.len() - 1 {
            let around = Aabb::around(looks.iter().flat_map(|(_, points)| [points[i], points[i + 1]]));
            let around = around.expect("a block has two looks");
            let reach = self.touching(robot, i, 2.0 * stretch).max(self.seen.clearance + robot.radius());
            let things = near(&self.world.obstacles, &around, reach);
            for (t, points) in &looks[1..] {
                for thing in &things {
                    self.look(robot, i, thing, &segment(points, i), *t)?;
                }
            }
            for pair in looks.windows(2) {
                let ((t, before), (u, after)) = (&pair[0], &pair[1]);
                for thing in &things {
                    self.sweep(robot, i, thing, (*t, &segment(before, i)), (*u, &segment(after, i)))?;
                }
            }
        }
        for pair in looks.windows(2) {
            let ((t, before), (u, after)) = (&pair[0], &pair[1]);
            self.check_inside(robot, after, *u)?;
            self.keep_inside(robot, (*t, before), (*u, after))?;
        }
        Ok(())
    }

    /// At this distance from an obstacle or less, the hull of segment `i` over a stretch of this length is too near.
    fn touching(&self, robot: &dyn Moving, i: usize, stretch: f64) -> f64 {
        robot.radius() + robot.bulge(i).max(robot.bulge(i + 1)) * stretch * stretch + self.scale.slack
    }

    /// Refuses segment `i` where it touches the thing at `t`.
    fn look(&mut self, robot: &dyn Moving, i: usize, thing: &Near, here: &Segment, t: f64) -> Result<(), String> {
        let clearance = thing.distance(here) - robot.radius();
        if clearance <= self.scale.slack {
            let (edge, name, obstacle) = (robot.edge(), robot.name(i), thing.index);
            return Err(format!("edge {edge}, {name} touches obstacle {obstacle} at {t} of the way"));
        }
        self.seen.clearance = self.seen.clearance.min(clearance);
        Ok(())
    }

    /// Refuses segment `i` where it may touch the thing between two looks, both of which were clear.
    fn sweep(
        &mut self,
        robot: &dyn Moving,
        i: usize,
        thing: &Near,
        (t, before): (f64, &Segment),
        (u, after): (f64, &Segment),
    ) -> Result<(), String> {
        if !Swept::new(before, after).comes_within(self.touching(robot, i, u - t), thing) {
            return Ok(());
        }
        let middle = 0.5 * (t + u);
        let travel = robot.travel(i).max(robot.travel(i + 1));
        if travel * (u - t) <= self.scale.slack || middle <= t || middle >= u {
            let (edge, name, obstacle) = (robot.edge(), robot.name(i), thing.index);
            return Err(format!("edge {edge}, {name} grazes obstacle {obstacle} between {t} and {u} of the way"));
        }
        let here = segment(&self.look_between(robot, middle)?, i);
        self.look(robot, i, thing, &here, middle)?;
        self.sweep(robot, i, thing, (t, before), (middle, &here))?;
        self.sweep(robot, i, thing, (middle, &here), (u, after))
    }

    /// Refuses a robot that is not wholly within the bounds at `t`.
    fn check_inside(&self, robot: &dyn Moving, points: &[Point], t: f64) -> Result<(), String> {
        match (0..points.len()).find(|&k| self.depth(robot, points[k]) < -self.scale.overstep) {
            Some(k) => {
                let (edge, name) = (robot.edge(), robot.name(k.saturating_sub(1)));
                Err(format!("edge {edge}, {name} leaves the bounds at {t} of the way"))
            }
            None => Ok(()),
        }
    }

    /// Refuses a robot that may leave the bounds between two looks, at both of which it was inside.
    fn keep_inside(
        &mut self,
        robot: &dyn Moving,
        (t, before): (f64, &[Point]),
        (u, after): (f64, &[Point]),
    ) -> Result<(), String> {
        let stretch = u - t;
        let stays = |k: usize| {
            let depth = self.depth(robot, before[k]).min(self.depth(robot, after[k]));
            depth - robot.bulge(k) * stretch * stretch >= -self.scale.overstep
        };
        let Some(k) = (0..before.len()).find(|&k| !stays(k)) else { return Ok(()) };
        let middle = 0.5 * (t + u);
        if middle <= t || middle >= u {
            let (edge, name) = (robot.edge(), robot.name(k.saturating_sub(1)));
            return Err(format!("edge {edge}, {name} leaves the bounds at {t} of the way"));
        }
        let points = self.look_between(robot, middle)?;
        self.check_inside(robot, &points, middle)?;
        self.keep_inside(robot, (t, before), (middle, &points))?;
        self.keep_inside(robot, (middle, &points), (u, after))
    }

    /// How far the point, with the radius around it, is within the bounds; negative outside.
    fn depth(&self, robot: &dyn Moving, p: Point) -> f64 {
        self.world.bounds.as_ref().map_or(f64::INFINITY, |bounds| bounds.depth(p) - robot.radius())
    }

    /// The points at one more look, as long as looks are left.
    fn look_between(&mut self, robot: &dyn Moving, t: f64) -> Result<Vec<Point>, String> {
        if self.refinements == MOST_REFINEMENTS {
            let (edge, looks) = (robot.edge(), self.seen.looks);
            return Err(format!("edge {edge} cannot be told from contact at {t} of the way after {looks} looks"));
        }
        self.refinements += 1;
        self.seen.looks += 1;
        Ok(robot.points(t))
    }
}
