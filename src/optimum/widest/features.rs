//! The borders of all obstacles as segments and points with a radius, in a tree of boxes.

use crate::geometry::{Aabb, BoxTree, LEAF, Point, Polygon, Segment, Vector, arrange, orientation};
use crate::problem::Touched;
use crate::scenario::Obstacle;
use std::ops::Range;

/// A corner of a polygon or of a hole, a point of a wall, or the centre of a disc.
#[derive(Debug, Clone, Copy)]
pub(super) struct Vertex {
    pub at: Point,
    /// All within this distance belongs to the obstacle, in metres: 0 of a polygon.
    pub radius: f64,
    pub obstacle: u32,
    /// Whether the obstacle may be nearest to something at this vertex: not where its corner is straight or reflex.
    pub is_tip: bool,
    /// The vertices that edges join to it.
    pub beside: [Option<u32>; 2],
}

impl Vertex {
    /// The obstacle, as what a robot touches.
    pub fn touched(&self) -> Touched {
        Touched::Obstacle(self.obstacle as usize)
    }
}

/// The borders of all obstacles.
pub(super) struct Features {
    pub vertices: Vec<Vertex>,
    /// The two ends of each segment; of a disc its centre twice. All within the radius of its ends is the obstacle.
    pub cores: Vec<[u32; 2]>,
    /// The cores that may reach into the bounds, so that neighbours are adjacent.
    order: Vec<u32>,
    /// Of these; `None` if there are none.
    tree: Option<BoxTree>,
}

impl Features {
    /// O(n log n) for n vertices.
    pub fn new(obstacles: &[Obstacle], bounds: &Aabb) -> Self {
        let mut features = Self { vertices: Vec::new(), cores: Vec::new(), order: Vec::new(), tree: None };
        for (i, obstacle) in obstacles.iter().enumerate() {
            let i = i as u32;
            match obstacle {
                Obstacle::Disc(disc) => features.add_chain(&[disc.center], disc.radius, false, i),
                Obstacle::Wall(wall) => features.add_chain(wall.points(), wall.radius(), wall.is_closed(), i),
                Obstacle::Polygon(polygon) => features.add_ring(polygon, false, i),
                Obstacle::PolygonWithHoles(polygon) => {
                    features.add_ring(polygon.outline(), false, i);
                    polygon.holes().iter().for_each(|hole| features.add_ring(hole, true, i));
                }
            }
        }
        let boxes: Vec<Aabb> = (0..features.cores.len()).map(|core| features.aabb(core)).collect();
        features.order = (0..boxes.len() as u32).filter(|&core| boxes[core as usize].intersects(bounds)).collect();
        arrange(&mut features.order, &boxes, LEAF);
        if !features.order.is_empty() {
            let around = |items: Range<usize>| {
                let all = features.order[items].iter().map(|&core| boxes[core as usize]);
                all.reduce(|a, b| a.union(&b)).expect("a leaf has a core")
            };
            features.tree = Some(BoxTree::new(features.order.len(), around));
        }
        features
    }

    /// Adds the points of a chain as tips, and what joins them.
    fn add_chain(&mut self, points: &[Point], radius: f64, is_closed: bool, obstacle: u32) {
        let (first, n) = (self.vertices.len() as u32, points.len() as u32);
        let last = first + n - 1;
        for (number, &at) in (first..).zip(points) {
            let before = if number > first { Some(number - 1) } else { is_closed.then_some(last) };
            let after = if number < last { Some(number + 1) } else { is_closed.then_some(first) };
            self.vertices.push(Vertex { at, radius, obstacle, is_tip: true, beside: [before, after] });
            if let Some(after) = after.or((n == 1).then_some(first)) {
                self.cores.push([number, after]);
            }
        }
    }

    /// Adds the border of a polygon, or of a hole of one.
    fn add_ring(&mut self, ring: &Polygon, is_hole: bool, obstacle: u32) {
        let (first, points) = (self.vertices.len(), ring.vertices());
        self.add_chain(points, 0.0, true, obstacle);
        let n = points.len();
        for (i, vertex) in self.vertices[first..].iter_mut().enumerate() {
            let turn = orientation(points[(i + n - 1) % n], points[i], points[(i + 1) % n]);
            vertex.is_tip = if is_hole { turn < 0.0 } else { turn > 0.0 };
        }
    }

    /// A core as a segment.
    pub fn segment(&self, core: usize) -> Segment {
        let [a, b] = self.cores[core];
        Segment::new(self.vertices[a as usize].at, self.vertices[b as usize].at)
    }

    /// How far the obstacle reaches beyond a core, in metres.
    pub fn radius(&self, core: usize) -> f64 {
        self.vertices[self.cores[core][0] as usize].radius
    }

    /// The box around all within the radius of a core.
    fn aabb(&self, core: usize) -> Aabb {
        self.segment(core).aabb().grown(self.radius(core))
    }

    /// Visits the cores in the bounds, those of nearer boxes first: `bound` is a distance of the box, or `None` if nothing in it
    /// matters.
    pub fn visit<T>(&self, visitor: &mut T, bound: impl Fn(&T, &Aabb) -> Option<f64>, visit: impl Fn(&mut T, usize)) {
        let Some(tree) = &self.tree else { return };
        let mut stack = vec![tree.root()];
        while let Some(node) = stack.pop() {
            // What was found since the node was put there may exclude it.
            if bound(visitor, tree.aabb(node)).is_none() {
                continue;
            }
            let Some((first, second)) = tree.children(node) else {
                self.order[tree.items(node)].iter().for_each(|&core| visit(visitor, core as usize));
                continue;
            };
            let of = |node| bound(visitor, tree.aabb(node)).map(|distance| (distance, node));
            match (of(first), second.and_then(of)) {
                (Some((near, first)), Some((far, second))) if far < near => stack.extend([first, second]),
                (first, second) => stack.extend(second.into_iter().chain(first).map(|(_, node)| node)),
            }
        }
    }

    /// Calls `visit` with every core in the bounds whose box meets the given one.
    pub fn near(&self, near: &Aabb, mut visit: impl FnMut(usize)) {
        self.visit(&mut visit, |_, aabb| aabb.intersects(near).then_some(0.0), |visit, core| visit(core));
    }

    /// The point of any obstacle's border nearest to a point that is in none: how far it is, the point, and the obstacle; `None`
    /// if there are no obstacles. O(n).
    pub fn nearest(&self, p: Point) -> Option<(f64, Point, Touched)> {
        let of = |core: usize| {
            let y = nearest_on(&self.segment(core), p);
            let away = y - p;
            let (distance, radius) = (away.norm(), self.radius(core));
            let q = if radius > 0.0 { p + away * (1.0 - radius / distance) } else { y };
            (distance - radius, q, self.vertices[self.cores[core][0] as usize].touched())
        };
        (0..self.cores.len()).map(of).reduce(|a, b| if b.0 < a.0 { b } else { a })
    }
}

/// The point of the segment that is nearest to a point; an end of it if that is.
pub(super) fn nearest_on(s: &Segment, p: Point) -> Point {
    let along: Vector = s.b - s.a;
    let (projection, length_squared) = ((p - s.a).dot(&along), along.norm_squared());
    if projection <= 0.0 {
        s.a
    } else if projection >= length_squared {
        s.b
    } else {
        s.a + along * (projection / length_squared)
    }
}
