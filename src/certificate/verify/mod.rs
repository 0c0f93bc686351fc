//! The independent verifier of certificates.
//!
//! It shares no code with the subdivision but cells, shapes, exact convex pieces and union-find. It computes places and distances by itself, and
//! where a cell of the document is not confirmed as it is, it halves it. [`separation`] decides without a quadtree whether the wall
//! separates start and goal. An obstacle within 2e-12 times the largest coordinate plus the reach is touched.

mod separation;

use super::cell::{Cell, DEEPEST, SIDE};
use super::document::{Blocked, Certificate, Verdict};
use crate::error::{Code, Error};
use crate::geometry::{Aabb, Placed, Point, Polygon, Segment, Vector, convex_pieces};
use crate::problem::Touched;
use crate::scenario::{Obstacle, Robot, Scenario};
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// The most parts of cells of one certificate that are examined.
const MOST_EXAMINED: u64 = 10_000_000;

/// How often a cell is halved: its parts are then as small as what rounding moves.
const MOST_HALVINGS: u32 = 32;

/// How far a point may be from a cell that contains it, in sides of the smallest cells: more than rounding moves it.
const ROUNDED: f64 = 1e-6;

/// The ranges of both coordinates over a part of a cell.
type Ranges = [[f64; 2]; 2];

/// Verifies a certificate against its scenario. Returns the reason why it does not hold; `None` if it does. One whose verdict is
/// `unknown` holds if its `clearance_at_most` does.
///
/// # Errors
/// `invalid-result` (pointer `/scenario`) if the certificate belongs to another scenario, `unknown-query` (pointer `/query`),
/// `unsupported` for a robot or a query that has no certificates.
///
/// # Complexity
/// O(cells x obstacles) for a channel; O(cells log cells) for a wall, and as much again for each line that meets many of its cells.
pub fn verify(scenario: &Scenario, certificate: &Certificate) -> Result<Option<String>, Error> {
    if certificate.scenario != scenario.name() {
        let (given, name) = (&certificate.scenario, scenario.name());
        let sentence = format!("the certificate belongs to scenario {given:?}, not to {name:?}");
        return Err(Error::new(Code::InvalidResult, "/scenario", sentence));
    }
    let (_, query) = scenario.find_query(Some(&certificate.query))?;
    let Some(goal) = query.configuration() else {
        return Err(Error::new(Code::Unsupported, "/query", "a query with a target has no certificates"));
    };
    let mut verifier = Verifier::new(scenario)?;
    let ends = [&query.start[..], goal].map(|q| verifier.units(q));
    Ok(verifier.check(certificate, ends).err())
}

struct Verifier<'a> {
    scenario: &'a Scenario,
    /// The base and the lengths of the links of an arm; `None` for a disc.
    arm: Option<(Point, [f64; 2])>,
    radius: f64,
    ranges: Ranges,
    wraps: bool,
    slack: f64,
    examined: u64,
}

impl<'a> Verifier<'a> {
    fn new(scenario: &'a Scenario) -> Result<Self, Error> {
        let bounds = scenario.world().bounds;
        let (arm, radius, ranges, wraps) = match (scenario.robot(), bounds) {
            (Robot::Arm(arm), _) if arm.links().len() == 2 => {
                let limits = arm.joint_limits().map_or([[-PI, PI]; 2], |limits| [limits[0], limits[1]]);
                let links = [arm.links()[0], arm.links()[1]];
                (Some((arm.base(), links)), arm.radius(), limits, arm.joint_limits().is_none())
            }
            (Robot::Disc(disc), Some(Aabb { min, max })) => {
                let r = disc.radius();
                (None, r, [[min.x + r, max.x - r], [min.y + r, max.y - r]], false)
            }
            _ => return Err(Error::new(Code::Unsupported, "/robot", "this robot has no certificates")),
        };
        let base = arm.map(|(base, _)| Aabb::of(base, base));
        let boxes = scenario.world().obstacles.iter().map(Obstacle::aabb).chain(bounds).chain(base);
        let largest =
            boxes.flat_map(|b| [b.min.x, b.min.y, b.max.x, b.max.y]).fold(0.0, |most: f64, x| most.max(x.abs()));
        let slack = 1e-12 * (largest + radius + arm.map_or(0.0, |(_, links)| links[0] + links[1]));
        Ok(Self { scenario, arm, radius, ranges, wraps, slack, examined: 0 })
    }

    /// A configuration in sides of the smallest cells.
    fn units(&self, q: &[f64]) -> [f64; 2] {
        [0, 1].map(|axis| {
            let [low, high] = self.ranges[axis];
            let angle = if self.wraps { libm::remainder(q[axis], TAU) } else { q[axis] };
            f64::from(SIDE) * ((angle - low) / (high - low))
        })
    }

    /// Checks that the parts of the document agree, then what it proves.
    fn check(&mut self, certificate: &Certificate, ends: [[f64; 2]; 2]) -> Result<(), String> {
        let Certificate { clearance, verdict, clearance_at_most, wall, channel, .. } = certificate;
        match (verdict, clearance_at_most) {
            (Verdict::Connected, _) => return self.check_channel(channel, *clearance, ends),
            (Verdict::Unknown, None) => return Ok(()),
            (Verdict::Infeasible, None) => return Err("the verdict is infeasible, without a clearance".into()),
            (Verdict::Infeasible, Some(most)) if most > clearance => {
                return Err(format!("the verdict is infeasible for {clearance} m, but the wall is for {most} m"));
            }
            (Verdict::Infeasible | Verdict::Unknown, Some(most)) => self.check_wall(wall, *most)?,
        }
        let cells: Vec<Cell> = wall.iter().map(|blocked| blocked.cell).collect();
        if separation::separates(&cells, [self.wraps; 2], ends) {
            return Ok(());
        }
        Err("the wall does not separate start and goal".into())
    }

    /// Checks every cell of a wall.
    fn check_wall(&mut self, wall: &[Blocked], most: f64) -> Result<(), String> {
        // Of every obstacle that has been named, its convex pieces and then the obstacle itself.
        let mut known: BTreeMap<usize, Vec<Obstacle>> = BTreeMap::new();
        for (i, blocked) in wall.iter().enumerate() {
            let name = format!("cell {i} of the wall");
            let ranges = self.ranges_of(&blocked.cell, &name)?;
            if blocked.part > usize::from(self.arm.is_some()) || !(0.0..=1.0).contains(&blocked.along) {
                return Err(format!("{name} names a point that the robot does not have"));
            }
            let shapes: &[Obstacle] = match blocked.with {
                Touched::Bounds => &[],
                Touched::Obstacle(i) => match self.scenario.world().obstacles.get(i) {
                    Some(obstacle) => known.entry(i).or_insert_with(|| pieces_and_whole(obstacle)),
                    None => return Err(format!("{name} names obstacle {i}, which does not exist")),
                },
            };
            if !self.stays_near(blocked, shapes, ranges, most, MOST_HALVINGS) {
                return Err(format!("{name}: link {} is not proven to stay near {:?}", blocked.part, blocked.with));
            }
        }
        Ok(())
    }

    /// Whether the point stays within `most` of the last shape, or of one of the convex ones before it that are contained in it; without
    /// shapes, whether it stays outside the bounds. The ranges are halved at most so often.
    fn stays_near(&mut self, blocked: &Blocked, shapes: &[Obstacle], ranges: Ranges, most: f64, halvings: u32) -> bool {
        self.examined += 1;
        let [[a, b], [c, d]] = ranges;
        let middle = [0.5 * (a + b), 0.5 * (c + d)];
        let place = |q: [f64; 2]| self.place(q, blocked.part, blocked.along);
        let (center, corners) = (place(middle), [[a, c], [b, c], [a, d], [b, d]].map(place));
        // A function differs from its bilinear interpolation by the squares of the sides times its second derivatives, over 8.
        let bulge = self.arm.map_or(0.0, |(_, [inner, outer])| {
            let (first, second) =
                if blocked.part == 0 { (inner * blocked.along, 0.0) } else { (inner, outer * blocked.along) };
            ((b - a) * (b - a) * (first + second) + (d - c) * (d - c) * second) / 8.0
        });
        let room = most + self.radius + 2.0 * self.slack - bulge;
        // The box first: most pieces of an obstacle are far away.
        let reach = room.max(0.0) + self.slack;
        let is_near = |shape: &Obstacle| {
            let around = shape.aabb().grown(reach);
            corners.iter().all(|&p| around.contains(p)) && corners.iter().all(|&p| signed_distance(p, shape) <= room)
        };
        let (is_proven, is_hopeless) = match shapes {
            [convex @ .., whole] => {
                let spread = corners.iter().map(|p| (p - center).norm()).fold(0.0, f64::max);
                let distance = signed_distance(center, whole);
                (convex.iter().any(is_near) || distance + spread + bulge <= room, distance > room + bulge)
            }
            [] => {
                let Some(Aabb { min, max }) = self.scenario.world().bounds else { return false };
                let beyond =
                    |p: Point| [min.x - p.x, p.x - max.x, min.y - p.y, p.y - max.y].map(|far| far + self.radius);
                let is_beyond = |side: usize| corners.iter().all(|&p| beyond(p)[side] > bulge);
                ((0..4).any(is_beyond), beyond(center).iter().all(|&far| far <= 0.0))
            }
        };
        is_proven
            || (!is_hopeless
                && halvings > 0
                && self.examined < MOST_EXAMINED
                && quarters(ranges).into_iter().all(|part| self.stays_near(blocked, shapes, part, most, halvings - 1)))
    }

    /// Checks that the cells lead from the start to the goal, and that the clearance is greater all over them.
    fn check_channel(&mut self, channel: &[Cell], clearance: f64, ends: [[f64; 2]; 2]) -> Result<(), String> {
        let [Some(first), Some(last)] = [channel.first(), channel.last()] else {
            return Err("the channel is empty".into());
        };
        for (i, cell) in channel.iter().enumerate() {
            let name = format!("cell {i} of the channel");
            let ranges = self.ranges_of(cell, &name)?;
            if !self.is_clear(ranges, clearance, MOST_HALVINGS) {
                return Err(format!("{name} is not proven to keep more than {clearance} m"));
            }
        }
        for (what, cell, [x, y]) in [("start", first, ends[0]), ("goal", last, ends[1])] {
            let [column, row] = cell.spans().map(|span| span.map(f64::from));
            let is_in = |[low, high]: [f64; 2], x: f64| low - ROUNDED <= x && x <= high + ROUNDED;
            if !is_in(column, x) || !is_in(row, y) {
                return Err(format!("the channel does not contain the {what}"));
            }
        }
        let apart = |low: u32, high: u32| u64::from(low.saturating_sub(high));
        let do_touch = |pair: &[Cell]| {
            let (here, there) = (pair[0].spans(), pair[1].spans());
            (0..2).all(|axis| {
                let ([a, b], [c, d]) = (here[axis], there[axis]);
                let gap = apart(c, b).max(apart(a, d));
                gap == 0 || (self.wraps && gap + u64::from(b - a) + u64::from(d - c) == u64::from(SIDE))
            })
        };
        match channel.windows(2).position(|pair| !do_touch(pair)) {
            Some(i) => Err(format!("cells {i} and {} of the channel do not touch", i + 1)),
            None => Ok(()),
        }
    }

    /// Whether the robot keeps more than the clearance over the ranges, which are halved at most so often, and stays within the bounds.
    fn is_clear(&mut self, ranges: Ranges, clearance: f64, halvings: u32) -> bool {
        self.examined += 1;
        let [[a, b], [c, d]] = ranges;
        let middle = [0.5 * (a + b), 0.5 * (c + d)];
        let half = [0.5 * (b - a), 0.5 * (d - c)];
        let (mut is_proven, mut is_hopeless) = (true, false);
        for part in 0..=usize::from(self.arm.is_some()) {
            let axis = Segment::new(self.place(middle, part, 0.0), self.place(middle, part, 1.0));
            let travel = match (self.arm, part) {
                (Some((_, [inner, _])), 0) => inner * half[0],
                (Some((_, [inner, outer])), _) => (inner + outer) * half[0] + outer * half[1],
                (None, _) => Vector::from(half).norm(),
            };
            let mut keeps = |room: f64| {
                is_proven &= room > travel;
                is_hopeless |= room <= 0.0;
            };
            for obstacle in self.scenario.world().obstacles.iter() {
                let least = self.radius + clearance + 0.5 * self.slack;
                // Beyond that it keeps away, however far it is.
                let most = (least + travel).max(0.0) + self.slack;
                keeps(obstacle.distance_to_segment_within(&axis, most) - least);
            }
            if let (Some(bounds), true) = (self.scenario.world().bounds, self.arm.is_some()) {
                keeps(bounds.depth(axis.b) - self.radius + self.slack);
            }
        }
        is_proven
            || (!is_hopeless
                && halvings > 0
                && self.examined < MOST_EXAMINED
                && quarters(ranges).into_iter().all(|part| self.is_clear(part, clearance, halvings - 1)))
    }

    /// The point at a fraction of the axis of a part.
    fn place(&self, q: [f64; 2], part: usize, along: f64) -> Point {
        let Some((base, lengths)) = self.arm else { return Point::new(q[0], q[1]) };
        let link = |angle: f64, length: f64| Vector::new(length * libm::cos(angle), length * libm::sin(angle));
        match part {
            0 => base + link(q[0], along * lengths[0]),
            _ => base + link(q[0], lengths[0]) + link(q[0] + q[1], along * lengths[1]),
        }
    }

    /// The ranges over a cell.
    fn ranges_of(&self, cell: &Cell, name: &str) -> Result<Ranges, String> {
        if cell.depth > DEEPEST || cell.column >> cell.depth != 0 || cell.row >> cell.depth != 0 {
            return Err(format!("{name} is not within the square: {cell:?}"));
        }
        let side = f64::from(SIDE);
        let [columns, rows] = cell.spans();
        Ok([(columns, self.ranges[0]), (rows, self.ranges[1])]
            .map(|(span, [low, high])| span.map(|at| low + f64::from(at) / side * (high - low))))
    }
}

/// The convex pieces of an obstacle, and then the obstacle itself.
fn pieces_and_whole(obstacle: &Obstacle) -> Vec<Obstacle> {
    let mut shapes = match obstacle {
        Obstacle::Polygon(polygon) => convex_pieces(polygon).into_iter().map(Obstacle::Polygon).collect(),
        Obstacle::Disc(_) => vec![obstacle.clone()],
    };
    shapes.push(obstacle.clone());
    shapes
}

/// The quarters of the ranges.
fn quarters([[a, b], [c, d]]: Ranges) -> [Ranges; 4] {
    let (x, y) = (0.5 * (a + b), 0.5 * (c + d));
    [[[a, x], [c, y]], [[x, b], [c, y]], [[a, x], [y, d]], [[x, b], [y, d]]]
}

/// The distance of a point from an obstacle; inside, the depth below its border as a negative number. By the crossings of a ray.
fn signed_distance(p: Point, obstacle: &Obstacle) -> f64 {
    match obstacle {
        Obstacle::Disc(disc) => (p - disc.center).norm() - disc.radius,
        Obstacle::Polygon(polygon) => signed_distance_polygon(p, polygon),
    }
}

fn signed_distance_polygon(p: Point, polygon: &Polygon) -> f64 {
    let nearest = Placed::resting(polygon).distance_to_border(p, f64::INFINITY, &mut 0);
    let mut is_inside = false;
    let ray = Aabb { min: p, max: Point::new(f64::INFINITY, p.y) };
    polygon.any_edge_near(&ray, |_, &Segment { a, b }| {
        if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) {
            is_inside = !is_inside;
        }
        false
    });
    if is_inside { -nearest } else { nearest }
}
