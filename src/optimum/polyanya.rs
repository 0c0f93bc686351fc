//! The shortest paths of a disc, or of a point, among polygons, walls and discs, in large worlds: exact.
//!
//! A shortest path turns around circles and goes straight between them (`tangent_graph.rs`). Instead of comparing all pairs of
//! circles, the search pushes the rays that leave a circle through a navigation mesh, as intervals of rays through a side of a
//! triangle, in the order of a bound on the length of paths that begin so (Cui, Harabor and Grastien 2017, "Compromise-free
//! pathfinding on a navigation mesh"). There the rays leave a corner; here they are tangent to a circle, so an interval is given
//! by the left normals of its outermost rays.
//!
//! - An interval contains every free ray, and others: rays that cross a side too close to its ends are taken away, but a ray may
//!   be too close to what lies elsewhere. So a tangent is tested for itself before a path may use it.
//! - A circle is found in the triangles that its free arcs pass through: the end of every free tangent lies in a triangle that
//!   the interval with the tangent enters.
//!
//! As bounds are never above the length and tangents are exact, the first path that reaches the goal is the shortest.

use super::arcs::{Arc, Arcs, Part};
use super::circles::{Circle, Path, Tangent, Turn, tangent, turn_left, turned};
use super::dead_ends::DeadEnds;
use super::grown::Grown;
use super::mesh::{Mesh, Side};
use super::rays::{Rays, SLACK, Source, outermost};
use super::route::{Bend, Route};
use crate::error::Error;
use crate::geometry::{Aabb, Disc, Point, Segment, Vector};
use crate::graph::Ordered;
use crate::scenario::World;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::TAU;

/// Rays that cross a side at less than this angle, in radians, meet it somewhere: beyond, where is known to 1e-12 of the size.
const PARALLEL: f64 = 1e-3;

/// No shortest path turns so nearly around a whole circle, in radians.
const ROUNDED: f64 = 1e-6;

/// The world of a disc, prepared for the shortest paths between any two positions.
pub(super) struct Prepared {
    pub grown: Grown,
    mesh: Mesh,
    arcs: Arcs,
    ends: DeadEnds,
}

/// Where a path begins, or touches a circle and turns around it.
#[derive(Debug, Clone, Copy)]
struct Root {
    /// The root before, and the angle at which its circle is left.
    before: u32,
    left_at: f64,
    /// The arc, [`START`] for none.
    arc: u32,
    turn: Turn,
    /// The angle at which the circle is touched first.
    angle: f64,
    /// The length of the path to there.
    length: f64,
    point: Point,
    /// The root before on the same arc with the same turn; [`START`] for none.
    other: u32,
}

/// Where a path begins there is no arc.
const START: u32 = u32::MAX;

/// What the search may do next.
#[derive(Debug, Clone, Copy)]
enum Node {
    /// Rays of a source enter a triangle through a side.
    Interval { source: u32, side: Side, rays: Rays },
    /// A tangent from a source to a circle, its end at an angle, which a path may turn around.
    Arrival { source: u32, part: u32, turn: Turn, segment: Segment, angles: [f64; 2] },
    /// A root leaves its arc in a part of it: the number of the part in the order of the turn.
    Departure { root: u32, number: u32 },
    /// A tangent from a source to the goal.
    Goal { source: u32, segment: Segment, left_at: f64 },
}

impl Prepared {
    /// Prepares a world for a disc of a radius, in metres.
    pub fn new(world: &World, bounds: Aabb, radius: f64) -> Self {
        let grown = Grown::new(world, bounds, radius);
        let mesh = Mesh::new(&grown);
        let arcs = Arcs::new(&grown, &mesh);
        let ends = DeadEnds::new(&mesh, &arcs);
        Self { grown, mesh, arcs, ends }
    }

    /// The shortest path between two positions: its length and its points, where arcs are replaced by chords of at most 0.05
    /// radians. `None` if there is no path.
    ///
    /// # Errors
    /// `start-in-collision`, `goal-in-collision`.
    pub fn shortest(&self, ends: [Point; 2]) -> Result<Option<Path>, Error> {
        Ok(self.route(ends)?.map(|route| route.chords(self.grown.larger)))
    }

    /// The shortest path between two positions with its arcs; `None` if there is no path.
    ///
    /// # Errors
    /// `start-in-collision`, `goal-in-collision`.
    pub fn route(&self, ends: [Point; 2]) -> Result<Option<Route>, Error> {
        self.grown.check(ends)?;
        if ends[0] == ends[1] {
            return Ok(Some(Route { length: 0.0, ends, bends: Vec::new() }));
        }
        let triangles = ends.map(|p| self.mesh.locate(p, 0));
        if !self.ends.are_joined(triangles) {
            return Ok(None);
        }
        Ok(Search::new(self, ends, triangles).run())
    }
}

/// One search.
struct Search<'a> {
    mesh: &'a Mesh,
    arcs: &'a Arcs,
    grown: &'a Grown,
    ends: &'a DeadEnds,
    /// Triangles of dead ends that lead from start and goal out of them.
    allowed: Vec<u32>,
    goal: Point,
    goal_in: u32,
    frontier: BinaryHeap<(Reverse<Ordered>, u32)>,
    nodes: Vec<Node>,
    roots: Vec<Root>,
    sources: Vec<Source>,
    /// The latest root on each arc, for either turn.
    latest: Vec<[u32; 2]>,
}

impl<'a> Search<'a> {
    fn new(prepared: &'a Prepared, [start, goal]: [Point; 2], triangles: [u32; 2]) -> Self {
        let Prepared { grown, mesh, arcs, ends } = prepared;
        let circle = Circle { disc: Disc { center: start, radius: 0.0 }, normals: None };
        let root = Root {
            before: 0,
            left_at: 0.0,
            arc: START,
            turn: Turn::Left,
            angle: 0.0,
            length: 0.0,
            point: start,
            other: START,
        };
        let source = Source { root: 0, circle, turn: Turn::Left, point: start, length: 0.0 };
        let mut search = Self {
            mesh,
            arcs,
            grown,
            goal,
            ends,
            allowed: triangles.into_iter().flat_map(|triangle| ends.out_of(triangle)).collect(),
            goal_in: triangles[1],
            frontier: BinaryHeap::new(),
            nodes: Vec::new(),
            roots: vec![root],
            sources: vec![source],
            latest: vec![[START; 2]; arcs.arcs.len()],
        };
        search.leave(0, triangles[0], None);
        search
    }

    fn run(mut self) -> Option<Route> {
        while let Some((_, number)) = self.frontier.pop() {
            match self.nodes[number as usize] {
                Node::Interval { source, side, rays } => self.enter(source, side, rays),
                Node::Arrival { source, part, turn, segment, angles } => {
                    self.arrive(source, part, turn, segment, angles);
                }
                Node::Departure { root, number } => self.depart(root, number),
                Node::Goal { source, segment, left_at } => {
                    if self.grown.is_free(&segment) {
                        return Some(self.route(source, left_at));
                    }
                }
            }
        }
        None
    }

    fn push(&mut self, bound: f64, node: Node) {
        // Of equal bounds the later node is tried first: it is nearer to the goal.
        self.frontier.push((Reverse(Ordered::new(bound)), self.nodes.len() as u32));
        self.nodes.push(node);
    }

    /// Rays of a source enter a triangle through a side, and the next ones as long as there is one way to go on.
    fn enter(&mut self, source: u32, mut side: Side, mut rays: Rays) {
        loop {
            self.look(source, side.triangle(), Some(&rays));
            let [left, right] = [side.next().next(), side.next()].map(|side| {
                let (across, open) = self.across(side)?;
                Some((across, self.sources[source as usize].through(&rays, open)?))
            });
            match (left, right) {
                (None, None) => return,
                (Some(only), None) | (None, Some(only)) => (side, rays) = only,
                (Some(left), Some(right)) => {
                    for (side, rays) in [left, right] {
                        self.push_interval(source, side, rays);
                    }
                    return;
                }
            }
        }
    }

    /// The side of the triangle beyond and its open part, if a shortest path may go there.
    fn across(&self, side: Side) -> Option<(Side, [Point; 2])> {
        let (across, open) = self.mesh.across(side)?;
        let triangle = across.triangle();
        (!self.ends.is_closed(triangle) || self.allowed.contains(&triangle)).then_some((across, open))
    }

    /// Rays of a source leave the triangle in which they begin: those between two if given, else all, from a point.
    fn leave(&mut self, source: u32, triangle: u32, only: Option<&Rays>) {
        self.look(source, triangle, only);
        for side in self.mesh.sides(triangle) {
            let Some((across, open)) = self.across(side) else { continue };
            let from = &self.sources[source as usize];
            let through = match only {
                Some(rays) => {
                    from.through(rays, open).filter(|rays| from.crosses(&rays.middle(), &self.mesh.segment(side)))
                }
                None => {
                    let [right, left] = open.map(|point| outermost(&(point - from.point), 0.0));
                    left.zip(right)
                        .map(|(left, right)| Rays { left, right })
                        .filter(|rays| rays.right.perp(&rays.left) >= -SLACK)
                }
            };
            if let Some(rays) = through {
                self.push_interval(source, across, rays);
            }
        }
    }

    /// Rays of a source are to enter a triangle through a side.
    fn push_interval(&mut self, source: u32, side: Side, rays: Rays) {
        let from = &self.sources[source as usize];
        let Segment { a, b } = self.mesh.segment(side);
        let along = b - a;
        let (center, length) = (from.circle.disc.center - a, along.norm());
        // Where a ray crosses the side, as a part of it; of one that is nearly parallel to it little is known.
        let crossing = |normal: &Vector, end: f64| {
            let across = normal.dot(&along);
            let is_known = across.abs() > PARALLEL * length;
            if is_known { ((normal.dot(&center) - from.offset()) / across).clamp(0.0, 1.0) } else { end }
        };
        // Seen from where the rays come from, a side begins on the left.
        let [first, last] = [crossing(&rays.left, 0.0), crossing(&rays.right, 1.0)];
        // The way through the side and on to the goal, or to its mirror image if it is on the near side.
        let squared = length * length;
        let [own, goal] = [from.point, self.goal].map(|p| (p - a, along.perp(&(p - a)).abs()));
        let [at, goal_at] = [own, goal].map(|(p, _)| along.dot(&p) / squared);
        let straight = (at * goal.1 + goal_at * own.1) / (own.1 + goal.1);
        let part = if straight.is_nan() { goal_at } else { straight };
        let through = a + part.max(first.min(last)).min(first.max(last)) * along;
        let bound = from.length + (through - from.point).norm() + (self.goal - through).norm();
        self.push(bound, Node::Interval { source, side, rays });
    }

    /// Looks for the goal and for arcs in a triangle that rays of a source have entered.
    fn look(&mut self, source: u32, triangle: u32, rays: Option<&Rays>) {
        let from = self.sources[source as usize];
        let is_seen = |tangent: &Tangent| {
            let along = tangent.segment.b - tangent.segment.a;
            rays.is_none_or(|rays| rays.contain(&(Vector::new(-along.y, along.x) / along.norm())))
        };
        if triangle == self.goal_in {
            let goal = Circle { disc: Disc { center: self.goal, radius: 0.0 }, normals: None };
            if let Some(found) = tangent([&from.circle, &goal], [from.turn, Turn::Left]).filter(is_seen) {
                let [left_at, _] = found.angles;
                let length = self.length_at(from.root, left_at) + length_of(&found.segment);
                self.push(length, Node::Goal { source, segment: found.segment, left_at });
            }
        }
        for number in self.arcs.parts_in(triangle) {
            let part = self.arcs.parts[number as usize];
            let circle = self.arcs.circle(part.arc);
            let may_touch = rays.map_or([true; 2], |rays| from.may_touch(rays, &circle.disc));
            for (turn, _) in Turn::BOTH.into_iter().zip(may_touch).filter(|(_, may_touch)| *may_touch) {
                let Some(found) = tangent([&from.circle, circle], [from.turn, turn]).filter(is_seen) else { continue };
                let [left_at, angle] = found.angles;
                let after = self.arcs.arcs[part.arc as usize].after(angle);
                if (part.from..=part.to).contains(&after) {
                    let length = self.length_at(from.root, left_at) + length_of(&found.segment);
                    let bound = length + (self.goal - found.segment.b).norm();
                    if !self.is_needless(part.arc, turn, angle, length) {
                        let (segment, angles) = (found.segment, found.angles);
                        self.push(bound, Node::Arrival { source, part: number, turn, segment, angles });
                    }
                }
            }
        }
    }

    /// The length of the path to where a root leaves its circle.
    fn length_at(&self, root: u32, angle: f64) -> f64 {
        let root = &self.roots[root as usize];
        root.length + if root.arc == START { 0.0 } else { self.along(root.arc, root.turn, root.angle, angle) }
    }

    /// The length of an arc from one angle to another, at the true radius.
    fn along(&self, arc: u32, turn: Turn, from: f64, to: f64) -> f64 {
        (self.arcs.circle(arc).disc.radius - self.grown.larger) * turned_by(turn, from, to)
    }

    /// Whether a path that touches an arc at an angle is no shorter than one that has come before.
    fn is_needless(&self, arc: u32, turn: Turn, angle: f64, length: f64) -> bool {
        let on = &self.arcs.arcs[arc as usize];
        let latest = self.latest[arc as usize][usize::from(turn == Turn::Right)];
        let next = |root: &Root| Some(root.other).filter(|&root| root != START).map(|root| self.roots[root as usize]);
        let first = Some(latest).filter(|&root| root != START).map(|root| self.roots[root as usize]);
        std::iter::successors(first, next).any(|before| {
            let [first, then] = [before.angle, angle].map(|angle| on.after(angle));
            let is_ahead = on.is_whole() || if turn == Turn::Left { first <= then } else { then <= first };
            is_ahead && before.length + self.along(arc, turn, before.angle, angle) <= length
        })
    }

    /// A path reaches a circle, to turn around it.
    fn arrive(&mut self, source: u32, part: u32, turn: Turn, segment: Segment, [left_at, angle]: [f64; 2]) {
        let before = self.sources[source as usize].root;
        let length = self.length_at(before, left_at) + length_of(&segment);
        let arc = self.arcs.parts[part as usize].arc;
        if self.is_needless(arc, turn, angle, length) || !self.grown.is_free(&segment) {
            return;
        }
        let root = self.roots.len() as u32;
        let latest = &mut self.latest[arc as usize][usize::from(turn == Turn::Right)];
        let other = std::mem::replace(latest, root);
        self.roots.push(Root { before, left_at, arc, turn, angle, length, point: segment.b, other });
        self.depart(root, 0);
    }

    /// The next part of its arc, from a number on in the order of its turn, at which a root may leave: its number there, the
    /// part, and the angles between.
    fn departure(&self, root: u32, number: u32) -> Option<(u32, u32, [f64; 2])> {
        let Root { arc, turn, angle, .. } = self.roots[root as usize];
        let Arc { from, ref parts, .. } = self.arcs.arcs[arc as usize];
        let is_whole = self.arcs.arcs[arc as usize].is_whole();
        let at = self.arcs.arcs[arc as usize].after(angle);
        let count = parts.len() as u32;
        // Of a whole circle those before where the turn begins come again after all others.
        (number..if is_whole { 2 * count } else { count }).find_map(|place| {
            let part = if turn == Turn::Left { parts.start + place % count } else { parts.end - 1 - place % count };
            let Part { from: low, to: high, .. } = self.arcs.parts[part as usize];
            let is_ahead = (turn == Turn::Left) == (place < count);
            let [low, high] = if is_ahead { [low.max(at), high] } else { [low, high.min(at)] };
            (low <= high).then_some((place, part, [from + low, from + high]))
        })
    }

    /// A root leaves its arc in the next part of it from a number on.
    fn depart(&mut self, root: u32, number: u32) {
        let Some((place, part, [low, high])) = self.departure(root, number) else { return };
        let Root { arc, turn, angle, length, point, .. } = self.roots[root as usize];
        let circle = *self.arcs.circle(arc);
        let first = turned_to(if turn == Turn::Left { low } else { high });
        let (point, length) = if number == 0 {
            (point, length)
        } else {
            (circle.at(first), length + self.along(arc, turn, angle, first))
        };
        let normal = |angle: f64| {
            let (sin, cos) = libm::sincos(angle);
            -turn.sign() * Vector::new(cos, sin)
        };
        let rays = Rays { left: normal(high), right: normal(low) };
        let source = self.sources.len() as u32;
        self.sources.push(Source { root, circle, turn, point, length });
        self.leave(source, self.arcs.parts[part as usize].triangle, Some(&rays));
        if let Some((next, _, [low, high])) = self.departure(root, place + 1) {
            let then = turned_to(if turn == Turn::Left { low } else { high });
            let (at, length) = (circle.at(then), self.roots[root as usize].length + self.along(arc, turn, angle, then));
            self.push(length + (self.goal - at).norm(), Node::Departure { root, number: next });
        }
    }

    /// The path that ends with a straight way from a source to the goal.
    fn route(&self, source: u32, left_at: f64) -> Route {
        let mut ways = vec![(self.sources[source as usize].root, left_at)];
        while let Some(&(root, _)) = ways.last().filter(|(root, _)| self.roots[*root as usize].arc != START) {
            let root = &self.roots[root as usize];
            ways.push((root.before, root.left_at));
        }
        // The last one is the start.
        let (start, _) = ways.pop().expect("a path begins somewhere");
        let bend = |(root, left_at): (u32, f64)| {
            let Root { arc, turn, angle: from, .. } = self.roots[root as usize];
            let to = if turned_by(turn, from, left_at) > 0.0 { left_at } else { from };
            Bend { disc: self.arcs.circle(arc).disc, turn, from, to }
        };
        let bends = ways.into_iter().rev().map(bend).collect();
        let source = &self.sources[source as usize];
        let end = source.circle.at(left_at);
        let length = self.length_at(source.root, left_at) + (self.goal - end).norm();
        Route { length, ends: [self.roots[start as usize].point, self.goal], bends }
    }
}

/// How far a turn goes from one angle to another, in radians: nothing if the second one is before the first by a rounding.
fn turned_by(turn: Turn, from: f64, to: f64) -> f64 {
    let angle = if turn == Turn::Left { turn_left(from, to) } else { turn_left(to, from) };
    if angle < TAU - ROUNDED { angle } else { 0.0 }
}

fn length_of(segment: &Segment) -> f64 {
    (segment.b - segment.a).norm()
}

/// An angle of less than two turns in [0, 2 pi).
fn turned_to(angle: f64) -> f64 {
    turned(if angle >= TAU { angle - TAU } else { angle })
}
