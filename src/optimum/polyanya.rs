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
//!
//! Where the tangents between arcs are known beforehand (`tangents.rs`), the search propagates the rays of the start alone. The
//! rays of the goal find the tangents that reach it.

use super::arcs::{Arc, Part};
use super::circles::{Circle, Tangent, Turn, tangent, turn_left, turned};
use super::grown::Grown;
use super::mesh::Side;
use super::rays::{Rays, Source};
use super::route::{Bend, Route};
use super::sight::{Sight, Touch, is_among};
use super::tangents::{End, Known, Way};
use crate::geometry::{Point, Segment, Vector};
use crate::graph::Ordered;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::TAU;

/// Rays that cross a side at less than this angle, in radians, meet it somewhere: beyond, where is known to 1e-12 of the size.
const PARALLEL: f64 = 1e-3;

/// No shortest path turns so nearly around a whole circle, in radians.
const ROUNDED: f64 = 1e-6;

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
    /// A tangent from a source to an arc, its end at an angle, which a path may turn around.
    Arrival { source: u32, arc: u32, turn: Turn, segment: Segment, angles: [f64; 2] },
    /// A root leaves its arc in a part of it: the number of the part in the order of the turn.
    Departure { root: u32, number: u32 },
    /// A known tangent from a root to an arc.
    Way { root: u32, way: u32 },
    /// A tangent from a root to the goal.
    Goal { root: u32, segment: Segment, left_at: f64 },
}

/// One search.
pub(super) struct Search<'a> {
    sight: &'a Sight<'a>,
    grown: &'a Grown,
    known: Option<&'a Known<'a>>,
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
    /// From a start to a goal, in their triangles.
    pub fn new(
        sight: &'a Sight<'a>,
        grown: &'a Grown,
        known: Option<&'a Known<'a>>,
        [start, goal]: [Point; 2],
        triangles: [u32; 2],
    ) -> Self {
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
        let mut search = Self {
            sight,
            grown,
            known,
            goal,
            goal_in: triangles[1],
            frontier: BinaryHeap::new(),
            nodes: Vec::new(),
            roots: vec![root],
            sources: vec![Source::at(start)],
            latest: vec![[START; 2]; sight.arcs.arcs.len()],
        };
        search.leave(0, triangles[0], None);
        search
    }

    /// The shortest path; `None` if there is none.
    pub fn run(mut self) -> Option<Route> {
        while let Some((_, number)) = self.frontier.pop() {
            match self.nodes[number as usize] {
                Node::Interval { source, side, rays } => self.enter(source, side, rays),
                Node::Arrival { source, arc, turn, segment, angles } => {
                    self.arrive(source, arc, turn, segment, angles);
                }
                Node::Departure { root, number } => self.depart(root, number),
                Node::Way { root, way } => {
                    let known = self.known.expect("a known tangent");
                    self.arrive_by(known, root, way);
                }
                Node::Goal { root, segment, left_at } => {
                    if self.grown.is_free(&segment) {
                        return Some(self.route(root, left_at));
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
            let ways = self.sight.onward(&self.sources[source as usize], side, &rays);
            match ways {
                [None, None] => return,
                [Some(only), None] | [None, Some(only)] => (side, rays) = only,
                [Some(left), Some(right)] => {
                    for (side, rays) in [left, right] {
                        self.push_interval(source, side, rays);
                    }
                    return;
                }
            }
        }
    }

    /// Rays of a source leave the triangle in which they begin: those between two if given, else all, from a point.
    fn leave(&mut self, source: u32, triangle: u32, only: Option<&Rays>) {
        self.look(source, triangle, only);
        for side in self.sight.mesh.sides(triangle) {
            if let Some((side, rays)) = self.sight.outward(&self.sources[source as usize], side, only) {
                self.push_interval(source, side, rays);
            }
        }
    }

    /// Rays of a source are to enter a triangle through a side.
    fn push_interval(&mut self, source: u32, side: Side, rays: Rays) {
        let from = &self.sources[source as usize];
        let Segment { a, b } = self.sight.mesh.segment(side);
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
        if triangle == self.goal_in {
            let found = tangent([&from.circle, &Circle::point(self.goal)], [from.turn, Turn::Left]);
            if let Some(Tangent { segment, angles: [left_at, _] }) = found.filter(|found| is_among(rays, found)) {
                self.push_goal(from.root, segment, left_at);
            }
        }
        self.sight.touch(&from, triangle, rays, &mut |Touch { arc, turn, tangent: Tangent { segment, angles } }| {
            let length = self.length_at(from.root, angles[0]) + length_of(&segment);
            if !self.is_needless(arc, turn, angles[1], length) {
                let bound = length + (self.goal - segment.b).norm();
                self.push(bound, Node::Arrival { source, arc, turn, segment, angles });
            }
        });
    }

    fn push_goal(&mut self, root: u32, segment: Segment, left_at: f64) {
        let length = self.length_at(root, left_at) + length_of(&segment);
        self.push(length, Node::Goal { root, segment, left_at });
    }

    /// The length of the path to where a root leaves its circle.
    fn length_at(&self, root: u32, angle: f64) -> f64 {
        let root = &self.roots[root as usize];
        root.length + if root.arc == START { 0.0 } else { self.along(root.arc, root.turn, root.angle, angle) }
    }

    /// The length of an arc from one angle to another, at the true radius.
    fn along(&self, arc: u32, turn: Turn, from: f64, to: f64) -> f64 {
        (self.sight.arcs.circle(arc).disc.radius - self.grown.larger) * turned_by(turn, from, to)
    }

    /// Whether a path that touches an arc at an angle is no shorter than one that has come before.
    fn is_needless(&self, arc: u32, turn: Turn, angle: f64, length: f64) -> bool {
        let on = &self.sight.arcs.arcs[arc as usize];
        let latest = self.latest[arc as usize][usize::from(turn == Turn::Right)];
        let next = |root: &Root| Some(root.other).filter(|&root| root != START).map(|root| self.roots[root as usize]);
        let first = Some(latest).filter(|&root| root != START).map(|root| self.roots[root as usize]);
        std::iter::successors(first, next).any(|before| {
            let is_ahead = on.is_whole() || on.place(turn, before.angle) <= on.place(turn, angle);
            is_ahead && before.length + self.along(arc, turn, before.angle, angle) <= length
        })
    }

    /// A path reaches an arc, to turn around it, if the way there is free.
    fn arrive(&mut self, source: u32, arc: u32, turn: Turn, segment: Segment, [left_at, angle]: [f64; 2]) {
        let before = self.sources[source as usize].root;
        let length = self.length_at(before, left_at) + length_of(&segment);
        if !self.is_needless(arc, turn, angle, length) && self.grown.is_free(&segment) {
            self.add(Root { before, left_at, arc, turn, angle, length, point: segment.b, other: START });
        }
    }

    /// A path reaches an arc by a known tangent.
    fn arrive_by(&mut self, known: &Known<'_>, before: u32, way: u32) {
        let &Way { left_at, to: End { arc, turn, angle, point }, length, .. } = known.way(way);
        let length = self.length_at(before, left_at) + length;
        if !self.is_needless(arc, turn, angle, length) {
            self.add(Root { before, left_at, arc, turn, angle, length, point, other: START });
        }
    }

    /// Adds a root, and where a path may go from there.
    fn add(&mut self, root: Root) {
        let number = self.roots.len() as u32;
        let latest = &mut self.latest[root.arc as usize][usize::from(root.turn == Turn::Right)];
        let other = std::mem::replace(latest, number);
        self.roots.push(Root { other, ..root });
        match self.known {
            Some(known) => self.depart_by(known, number),
            None => self.depart(number, 0),
        }
    }

    /// A root leaves its arc by known tangents.
    fn depart_by(&mut self, known: &Known<'_>, root: u32) {
        let Root { arc, turn, angle, .. } = self.roots[root as usize];
        for number in known.leaving(self.sight.arcs, arc, turn, angle) {
            let &Way { left_at, to: End { arc, turn, angle, point }, length, .. } = known.way(number);
            let length = self.length_at(root, left_at) + length;
            if !self.is_needless(arc, turn, angle, length) {
                self.push(length + (self.goal - point).norm(), Node::Way { root, way: number });
            }
        }
        let to_goal = known.to_goal(self.sight.arcs, arc, turn, angle);
        if let Some(&Tangent { segment, angles: [_, left_at] }) = to_goal {
            self.push_goal(root, Segment::new(segment.b, segment.a), left_at);
        }
    }

    /// The next part of its arc, from a number on in the order of its turn, at which a root may leave: its number there, the
    /// part, and the angles between.
    fn departure(&self, root: u32, number: u32) -> Option<(u32, u32, [f64; 2])> {
        let Root { arc, turn, angle, .. } = self.roots[root as usize];
        let Arc { from, ref parts, .. } = self.sight.arcs.arcs[arc as usize];
        let is_whole = self.sight.arcs.arcs[arc as usize].is_whole();
        let at = self.sight.arcs.arcs[arc as usize].after(angle);
        let count = parts.len() as u32;
        // Of a whole circle those before where the turn begins come again after all others.
        (number..if is_whole { 2 * count } else { count }).find_map(|place| {
            let part = if turn == Turn::Left { parts.start + place % count } else { parts.end - 1 - place % count };
            let Part { from: low, to: high, .. } = self.sight.arcs.parts[part as usize];
            let is_ahead = (turn == Turn::Left) == (place < count);
            let [low, high] = if is_ahead { [low.max(at), high] } else { [low, high.min(at)] };
            (low <= high).then_some((place, part, [from + low, from + high]))
        })
    }

    /// A root leaves its arc in the next part of it from a number on.
    fn depart(&mut self, root: u32, number: u32) {
        let Some((place, part, [low, high])) = self.departure(root, number) else { return };
        let Root { arc, turn, angle, length, point, .. } = self.roots[root as usize];
        let circle = *self.sight.arcs.circle(arc);
        let first = turned_to(if turn == Turn::Left { low } else { high });
        let (point, length) = if number == 0 {
            (point, length)
        } else {
            (circle.at(first), length + self.along(arc, turn, angle, first))
        };
        let rays = Rays::from_arc(turn, [low, high]);
        let source = self.sources.len() as u32;
        self.sources.push(Source { root, circle, turn, point, length });
        self.leave(source, self.sight.arcs.parts[part as usize].triangle, Some(&rays));
        if let Some((next, _, [low, high])) = self.departure(root, place + 1) {
            let then = turned_to(if turn == Turn::Left { low } else { high });
            let (at, length) = (circle.at(then), self.roots[root as usize].length + self.along(arc, turn, angle, then));
            self.push(length + (self.goal - at).norm(), Node::Departure { root, number: next });
        }
    }

    /// The path that ends with a straight way from a root to the goal.
    fn route(&self, last: u32, left_at: f64) -> Route {
        let mut ways = vec![(last, left_at)];
        while let Some(&(root, _)) = ways.last().filter(|(root, _)| self.roots[*root as usize].arc != START) {
            let root = &self.roots[root as usize];
            ways.push((root.before, root.left_at));
        }
        // The last one is the start.
        let (start, _) = ways.pop().expect("a path begins somewhere");
        let bend = |(root, left_at): (u32, f64)| {
            let Root { arc, turn, angle: from, .. } = self.roots[root as usize];
            let to = if turned_by(turn, from, left_at) > 0.0 { left_at } else { from };
            Bend { disc: self.sight.arcs.circle(arc).disc, turn, from, to }
        };
        let bends = ways.into_iter().rev().map(bend).collect();
        let root = &self.roots[last as usize];
        let end = if root.arc == START { root.point } else { self.sight.arcs.circle(root.arc).at(left_at) };
        let length = self.length_at(last, left_at) + (self.goal - end).norm();
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
