//! The independent verifier of certificates.
//!
//! It shares no code with the subdivision but cells, shapes, exact convex pieces and union-find. It computes places and distances
//! by itself, and where a cell of the document is not confirmed as it is, it halves it. [`separation`] decides without a quadtree
//! whether the wall separates start and goal. An obstacle within 2e-12 times the largest coordinate plus the reach is touched.

mod separation;

use super::cell::{Cell, DEEPEST, SIDE};
use super::document::{Blocked, Certificate, Verdict};
use crate::error::{Code, Error};
use crate::geometry::{Aabb, Placed, Point, Polygon, Segment, Vector, convex_pieces, distance_point_segment};
use crate::problem::Touched;
use crate::robot::{Joint, link_name};
use crate::scenario::{Obstacle, Robot, Scenario};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};

/// The most parts of cells of one certificate that are examined.
const MOST_EXAMINED: u64 = 10_000_000;

/// How often a cell is halved: its parts are then as small as what rounding moves.
const MOST_HALVINGS: u32 = 32;

/// How far a configuration may be from a cell that contains it, in slacks: more than rounding moves it.
const ROUNDED: f64 = 0.25;

/// The least slack, in metres.
const SMALLEST_SLACK: f64 = 1e-150;

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
/// O(cells x obstacles) for a channel; O(cells log cells) for a wall, and as much again for each line that meets many of its
/// cells.
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
    Ok(verifier.check(certificate, [&query.start, goal]).err())
}

/// Returns an error if the document has what its verdict excludes, or fewer cells than those that it names take: every
/// one that contains such a cell is divided into quarters.
fn check_claims(certificate: &Certificate) -> Result<(), String> {
    let Certificate { verdict, clearance_at_most, cells, wall, channel, .. } = certificate;
    if *verdict == Verdict::Connected && (clearance_at_most.is_some() || !wall.is_empty()) {
        return Err("the verdict is connected: its wall is empty, and it excludes no clearance".into());
    }
    if *verdict != Verdict::Connected && !channel.is_empty() {
        return Err("there is a channel, but the verdict is not connected".into());
    }
    if clearance_at_most.is_none() && !wall.is_empty() {
        return Err("there is a wall without a clearance that it is for".into());
    }
    let mut divided = BTreeSet::new();
    for cell in wall.iter().map(|blocked| &blocked.cell).chain(channel) {
        // Cells beyond the square are refused by name.
        if cell.depth > DEEPEST || (cell.column | cell.row) >> cell.depth > 0 {
            continue;
        }
        // The larger ones of a cell that was met before are there as well.
        let larger = (0..cell.depth).rev().map(|depth| {
            let halvings = cell.depth - depth;
            (depth, cell.column >> halvings, cell.row >> halvings)
        });
        for cell in larger {
            if !divided.insert(cell) {
                break;
            }
        }
    }
    let fewest = 1 + 4 * divided.len() as u64;
    if *cells < fewest {
        return Err(format!("there are said to be {cells} cells, but those of the document take at least {fewest}"));
    }
    Ok(())
}

/// A link of an arm.
#[derive(Clone, Copy)]
struct Link {
    /// Its length, if it is prismatic at the coordinate 0, and the greatest.
    length: f64,
    longest: f64,
    /// Its fixed angle, if it is prismatic.
    fixed: Option<f64>,
}

impl Link {
    fn turns(&self) -> bool {
        self.fixed.is_none()
    }
}

struct Verifier<'a> {
    scenario: &'a Scenario,
    /// The base, and of both links the length, the greatest length, and the joint, of an arm; `None` for a disc.
    arm: Option<(Point, [Link; 2])>,
    radius: f64,
    ranges: Ranges,
    wraps: [bool; 2],
    slack: f64,
    /// How far rounding may move each coordinate.
    rounded: [f64; 2],
    examined: u64,
}

impl<'a> Verifier<'a> {
    fn new(scenario: &'a Scenario) -> Result<Self, Error> {
        let bounds = scenario.world().bounds;
        let (arm, radius, ranges, wraps) = match (scenario.robot(), bounds) {
            (Robot::Arm(arm), _) if arm.links().len() == 2 => {
                let ranges = [0, 1].map(|i: usize| arm.joint_types()[i].range());
                let link = |i: usize| {
                    let length = arm.links()[i];
                    match arm.joint_types()[i] {
                        Joint::Revolute { .. } => Link { length, longest: length, fixed: None },
                        Joint::Prismatic { range, angle } => {
                            Link { length, longest: length + range[1], fixed: Some(angle) }
                        }
                    }
                };
                let limits = ranges.map(|range| range.unwrap_or([-PI, PI]));
                let wraps = ranges.map(|range| range.is_none());
                (Some((arm.base(), [link(0), link(1)])), arm.kept_radius(), limits, wraps)
            }
            (Robot::Disc(disc), Some(Aabb { min, max })) => {
                let r = disc.kept_radius();
                (None, r, [[min.x + r, max.x - r], [min.y + r, max.y - r]], [false; 2])
            }
            _ => return Err(Error::new(Code::Unsupported, "/robot", "this robot has no certificates")),
        };
        let base = arm.map(|(base, _)| Aabb::of(base, base));
        let boxes = scenario.world().obstacles.iter().map(Obstacle::aabb).chain(bounds).chain(base);
        let largest =
            boxes.flat_map(|b| [b.min.x, b.min.y, b.max.x, b.max.y]).fold(0.0, |most: f64, x| most.max(x.abs()));
        let reach = arm.map_or(0.0, |(_, links)| links[0].longest + links[1].longest);
        let slack = (1e-12 * (largest + radius + reach)).max(SMALLEST_SLACK);
        // A joint that turns by this moves no point of the arm farther than the same part of the slack.
        let turns = |axis: usize| arm.is_some_and(|(_, links)| links[axis].turns());
        let rounded = [0, 1].map(|axis| ROUNDED * if turns(axis) { slack / reach } else { slack });
        // In a world as wide as the disc rounding may exchange the ends.
        let ranges = ranges.map(|[low, high]| [f64::min(low, high), f64::max(low, high)]);
        Ok(Self { scenario, arm, radius, ranges, wraps, slack, rounded, examined: 0 })
    }

    /// A configuration within the ranges: angles of circles are turned into them. A disc may be outside its range by the
    /// slack, as contact with the bounds is allowed; `None` if it is farther outside.
    fn placed(&self, q: &[f64]) -> Option<[f64; 2]> {
        let at = [0, 1].map(|axis| if self.wraps[axis] { libm::remainder(q[axis], TAU) } else { q[axis] });
        let within = [0, 1].map(|axis| at[axis].clamp(self.ranges[axis][0], self.ranges[axis][1]));
        (0..2).all(|axis| (at[axis] - within[axis]).abs() <= self.slack).then_some(within)
    }

    /// A length along an axis in sides of the smallest cells; infinite along an axis without length, unless it is 0.
    fn units(&self, axis: usize, length: f64) -> f64 {
        let [low, high] = self.ranges[axis];
        if length == 0.0 { 0.0 } else { SIDE as f64 * (length / (high - low)) }
    }

    /// Checks that the parts of the document agree, then what it proves.
    fn check(&mut self, certificate: &Certificate, ends: [&[f64]; 2]) -> Result<(), String> {
        let [Some(start), Some(goal)] = ends.map(|q| self.placed(q)) else {
            return Err("the start or the goal is outside the bounds".into());
        };
        let ends = [start, goal];
        let Certificate { clearance, verdict, clearance_at_most, slack, wall, channel, .. } = certificate;
        let own = 2.0 * self.slack;
        if (slack - own).abs() > 1e-9 * own {
            return Err(format!("the slack is {own} m, not {slack} m"));
        }
        check_claims(certificate)?;
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
        let points = ends.map(|q| [0, 1].map(|axis| self.units(axis, q[axis] - self.ranges[axis][0])));
        let rounded = [0, 1].map(|axis| self.units(axis, self.rounded[axis]));
        if separation::separates(&cells, self.wraps, points, rounded) {
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
                let part = if self.arm.is_some() { link_name(blocked.part) } else { "the disc".into() };
                let with = match blocked.with {
                    Touched::Obstacle(i) => format!("obstacle {i}"),
                    Touched::Bounds => "the bounds".into(),
                };
                return Err(format!("{name}: {part} is not proven to stay near {with}"));
            }
        }
        Ok(())
    }

    /// Whether the point stays within `most` of the last shape, or of one of the convex ones before it that are contained in it;
    /// without shapes, whether it stays outside the bounds. The ranges are halved at most so often.
    fn stays_near(&mut self, blocked: &Blocked, shapes: &[Obstacle], ranges: Ranges, most: f64, halvings: u32) -> bool {
        self.examined += 1;
        let [[a, b], [c, d]] = ranges;
        let middle = [0.5 * (a + b), 0.5 * (c + d)];
        let place = |q: [f64; 2]| self.place(q, blocked.part, blocked.along);
        let (center, corners) = (place(middle), [[a, c], [b, c], [a, d], [b, d]].map(place));
        let bulge = self.bulge(ranges, blocked.part, blocked.along);
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
        for (what, cell, q) in [("start", first, ends[0]), ("goal", last, ends[1])] {
            let ranges = self.ranges_of(cell, what)?;
            let is_in = |axis: usize, turn: f64| {
                let ([low, high], x, rounded) = (ranges[axis], q[axis] + turn, self.rounded[axis]);
                low - rounded <= x && x <= high + rounded
            };
            // Both ends of a range that wraps are the same angle.
            let turns = |axis: usize| if self.wraps[axis] { &[0.0, -TAU, TAU][..] } else { &[0.0] };
            if !(0..2).all(|axis| turns(axis).iter().any(|&turn| is_in(axis, turn))) {
                return Err(format!("the channel does not contain the {what}"));
            }
        }
        let apart = |low: u64, high: u64| low.saturating_sub(high);
        let do_touch = |pair: &[Cell]| {
            let (here, there) = (pair[0].spans(), pair[1].spans());
            (0..2).all(|axis| {
                let ([a, b], [c, d]) = (here[axis], there[axis]);
                let gap = apart(c, b).max(apart(a, d));
                gap == 0 || (self.wraps[axis] && gap + (b - a) + (d - c) == SIDE)
            })
        };
        match channel.windows(2).position(|pair| !do_touch(pair)) {
            Some(i) => Err(format!("cells {i} and {} of the channel do not touch", i + 1)),
            None => Ok(()),
        }
    }

    /// Whether the robot keeps more than the clearance over the ranges, which are halved at most so often, and stays within the
    /// bounds.
    fn is_clear(&mut self, ranges: Ranges, clearance: f64, halvings: u32) -> bool {
        self.examined += 1;
        let [[a, b], [c, d]] = ranges;
        let middle = [0.5 * (a + b), 0.5 * (c + d)];
        let half = [0.5 * (b - a), 0.5 * (d - c)];
        let (mut is_proven, mut is_hopeless) = (true, false);
        for part in 0..=usize::from(self.arm.is_some()) {
            let axis = Segment::new(self.place(middle, part, 0.0), self.place(middle, part, 1.0));
            // A joint that slides moves no point farther than it slides.
            let moved = |link: &Link, far: f64, half: f64| if link.turns() { far * half } else { half };
            let travel = match (self.arm, part) {
                (Some((_, [inner, _])), 0) => moved(&inner, inner.longest, half[0]),
                (Some((_, [inner, outer])), _) => {
                    moved(&inner, inner.longest + outer.longest, half[0]) + moved(&outer, outer.longest, half[1])
                }
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
                // Contact with the bounds is allowed.
                let room = |end: Point| bounds.depth(end) - self.radius + self.slack;
                let corners = [[a, c], [b, c], [a, d], [b, d]].map(|q| room(self.place(q, part, 1.0)));
                is_proven &= corners.iter().all(|&room| room > self.bulge(ranges, part, 1.0));
                is_hopeless |= room(axis.b) <= 0.0;
            }
        }
        is_proven
            || (!is_hopeless
                && halvings > 0
                && self.examined < MOST_EXAMINED
                && quarters(ranges).into_iter().all(|part| self.is_clear(part, clearance, halvings - 1)))
    }

    /// How far a point of a part can leave the hull of its places at the corners of the ranges: a function differs from its
    /// bilinear interpolation by the squares of the sides times its second derivatives, over 8.
    fn bulge(&self, [[a, b], [c, d]]: Ranges, part: usize, along: f64) -> f64 {
        self.arm.map_or(0.0, |(_, [inner, outer])| {
            // The second derivatives: the distance from the joint that turns, nothing along one that slides.
            let (first, second) = if part == 0 {
                (inner.longest * along, 0.0)
            } else {
                (inner.longest + outer.longest * along, outer.longest * along)
            };
            let share = |link: &Link, side: f64, derivative: f64| {
                if link.turns() { side * side * derivative } else { 0.0 }
            };
            (share(&inner, b - a, first) + share(&outer, d - c, second)) / 8.0
        })
    }

    /// The point at a fraction of the axis of a part.
    fn place(&self, q: [f64; 2], part: usize, along: f64) -> Point {
        let Some((base, links)) = self.arm else { return Point::new(q[0], q[1]) };
        let (mut at, mut angle) = (base, 0.0);
        for (i, link) in links.iter().enumerate().take(part + 1) {
            angle += link.fixed.unwrap_or(q[i]);
            let length = if link.turns() { link.length } else { link.length + q[i] };
            let length = if i == part { along * length } else { length };
            at += Vector::new(length * libm::cos(angle), length * libm::sin(angle));
        }
        at
    }

    /// The ranges over a cell.
    fn ranges_of(&self, cell: &Cell, name: &str) -> Result<Ranges, String> {
        if cell.depth > DEEPEST || cell.column >> cell.depth != 0 || cell.row >> cell.depth != 0 {
            return Err(format!("{name} is not within the square: {cell:?}"));
        }
        let side = SIDE as f64;
        let [columns, rows] = cell.spans();
        Ok([(columns, self.ranges[0]), (rows, self.ranges[1])]
            .map(|(span, [low, high])| span.map(|at| low + at as f64 / side * (high - low))))
    }
}

/// Convex pieces of an obstacle, of a polygon with holes those of its border, and then the obstacle itself.
fn pieces_and_whole(obstacle: &Obstacle) -> Vec<Obstacle> {
    let mut shapes = match obstacle {
        Obstacle::Polygon(polygon) => convex_pieces(polygon).into_iter().map(Obstacle::Polygon).collect(),
        Obstacle::PolygonWithHoles(polygon) => polygon.border().map(Obstacle::Wall).collect(),
        Obstacle::Wall(wall) => wall.pieces().map(Obstacle::Wall).collect(),
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
        Obstacle::Polygon(polygon) => signed_distance_rings(p, std::iter::once(polygon)),
        Obstacle::PolygonWithHoles(polygon) => signed_distance_rings(p, polygon.rings()),
        Obstacle::Wall(wall) => {
            wall.segments().map(|s| distance_point_segment(p, &s)).fold(f64::INFINITY, f64::min) - wall.radius()
        }
    }
}

fn signed_distance_rings<'a>(p: Point, rings: impl Iterator<Item = &'a Polygon>) -> f64 {
    let (mut nearest, mut is_inside) = (f64::INFINITY, false);
    let ray = Aabb { min: p, max: Point::new(f64::INFINITY, p.y) };
    for ring in rings {
        nearest = nearest.min(Placed::resting(ring).distance_to_border(p, f64::INFINITY, &mut 0));
        ring.any_edge_near(&ray, |_, &Segment { a, b }| {
            if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) {
                is_inside = !is_inside;
            }
            false
        });
    }
    if is_inside { -nearest } else { nearest }
}
