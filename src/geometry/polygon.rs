//! A simple polygon, convex or concave, closed and filled.

use super::box_tree::Node;
use super::chain::Chain;
use super::crossing::{find_crossing, left_to_right};
use super::{Aabb, Point, Segment, Vector, orientation};
use serde::Serialize;

/// The smallest magnitude of a vertex coordinate other than 0, in metres.
///
/// Between this and [`MAX_MAGNITUDE`] every difference of coordinates is a multiple of 2^-518, and so every product of two
/// is a multiple of 2^-1036: nothing underflows, nothing overflows, and [`orientation`] is exact.
pub const MIN_MAGNITUDE: f64 = 1e-140;

/// The largest magnitude of a vertex coordinate, in metres.
pub const MAX_MAGNITUDE: f64 = 1e140;

/// The reason why a list of points is not a simple polygon.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum PolygonFault {
    /// A coordinate of this vertex (an index into the given points) is neither 0 nor of a magnitude in
    /// [[`MIN_MAGNITUDE`], [`MAX_MAGNITUDE`]]; NaN and infinity included.
    Magnitude(usize),
    /// Fewer than three distinct vertices are left once repeated ones are dropped.
    TooFewVertices,
    /// All vertices lie on one line.
    ZeroArea,
    /// The edges that start at these two vertices (indices into the given points) touch or cross.
    SelfCrossing(usize, usize),
}

/// A simple polygon with at least three vertices and positive area, counter-clockwise, without repeated vertices.
#[derive(Debug, Clone, Serialize)]
#[serde(tag = "type", rename = "polygon")]
pub struct Polygon {
    #[serde(rename = "vertices")]
    border: Chain,
    #[serde(skip)]
    convex: bool,
}

/// Polygons are equal if their corners are, from the first on.
impl PartialEq for Polygon {
    fn eq(&self, other: &Self) -> bool {
        self.border == other.border
    }
}

impl Polygon {
    /// A polygon from its corners in either direction, open or closed (the first point repeated at the end). Points that
    /// repeat their predecessor are dropped; nothing else is repaired.
    ///
    /// # Errors
    /// The [`PolygonFault`] if the points do not bound a simple polygon. Decided exactly.
    ///
    /// # Complexity
    /// O(n log n) predicates for n points, O(n) if it is convex.
    pub fn new(points: &[Point]) -> Result<Self, PolygonFault> {
        if let Some(i) = points.iter().position(|&p| !is_exact(p)) {
            return Err(PolygonFault::Magnitude(i));
        }
        let mut distinct: Vec<usize> = Vec::with_capacity(points.len());
        for (i, p) in points.iter().enumerate() {
            if distinct.last().is_none_or(|&last| points[last] != *p) {
                distinct.push(i);
            }
        }
        while distinct.len() > 1 && points[distinct[0]] == points[distinct[distinct.len() - 1]] {
            distinct.pop();
        }
        // Adding zero turns -0 into +0, so that equal coordinates are equal bits.
        let mut vertices: Vec<Point> =
            distinct.iter().map(|&i| Point::new(points[i].x + 0.0, points[i].y + 0.0)).collect();
        if vertices.len() < 3 {
            return Err(PolygonFault::TooFewVertices);
        }
        let n = vertices.len();
        if (2..n).all(|i| orientation(vertices[0], vertices[1], vertices[i]) == 0.0) {
            return Err(PolygonFault::ZeroArea);
        }
        let convex = is_convex(&vertices);
        if !convex && let Some((i, j)) = find_crossing(&vertices) {
            return Err(PolygonFault::SelfCrossing(distinct[i], distinct[j]));
        }
        if !is_counter_clockwise(&vertices) {
            vertices.reverse();
        }
        Ok(Self::of(vertices, convex))
    }

    /// The polygon of these corners, known to be simple and counter-clockwise.
    pub(super) fn of(vertices: Vec<Point>, convex: bool) -> Self {
        Self { border: Chain::new(vertices, true), convex }
    }

    /// The polygon turned about the origin by `theta` and then moved by (x, y), for a pose (x, y, theta): the shape of a
    /// body there. Every vertex is rounded by itself, so it may touch itself by a rounding. O(vertices).
    #[must_use]
    pub fn placed(&self, [x, y, theta]: [f64; 3]) -> Self {
        let (sin, cos) = libm::sincos(theta);
        let place = |p: &Point| Point::new(x + (cos * p.x - sin * p.y), y + (sin * p.x + cos * p.y));
        Self::of(self.vertices().iter().map(place).collect(), self.convex)
    }

    /// The distance from the origin to the farthest vertex, in metres: the reach of a body from the origin of its frame.
    pub fn reach(&self) -> f64 {
        self.vertices().iter().map(|p| p.coords.norm()).fold(0.0, f64::max)
    }

    /// The corners, counter-clockwise, each once.
    pub fn vertices(&self) -> &[Point] {
        self.border.points()
    }

    /// The edges, counter-clockwise, the first from vertex 0.
    pub fn edges(&self) -> impl Iterator<Item = Segment> + '_ {
        self.border.edges()
    }

    /// The smallest box around the polygon.
    pub fn aabb(&self) -> &Aabb {
        self.border.aabb()
    }

    /// Whether no corner turns to the right.
    pub fn is_convex(&self) -> bool {
        self.convex
    }

    /// How far the polygon reaches in a direction: the largest scalar product with a corner. O(log n) of a convex
    /// polygon.
    pub fn support(&self, direction: Vector) -> f64 {
        let along = |p: &Point| direction.dot(&p.coords);
        let Some(tree) = self.border.tree() else {
            return self.vertices().iter().map(along).fold(f64::NEG_INFINITY, f64::max);
        };
        // Rounding keeps the order, so the product with the foremost corner of a box is no less than any in it.
        let bound = |node: Node| {
            let Aabb { min, max } = tree.aabb(node);
            let side = |way: f64, low: f64, high: f64| if way > 0.0 { high } else { low };
            along(&Point::new(side(direction.x, min.x, max.x), side(direction.y, min.y, max.y)))
        };
        let mut most = f64::NEG_INFINITY;
        let mut stack = vec![tree.root()];
        while let Some(node) = stack.pop() {
            if bound(node) <= most {
                continue;
            }
            match tree.children(node) {
                None => most = self.vertices()[tree.items(node)].iter().map(along).fold(most, f64::max),
                Some((first, second)) => {
                    let is_farther = |second| bound(first).total_cmp(&bound(second)).is_gt();
                    let children =
                        if second.is_some_and(is_farther) { [second, Some(first)] } else { [Some(first), second] };
                    stack.extend(children.into_iter().flatten());
                }
            }
        }
        most
    }

    /// The closed chain of corners.
    pub(super) fn border(&self) -> &Chain {
        &self.border
    }
}

/// Whether orientations of points with such coordinates are exact.
pub(super) fn is_exact(p: Point) -> bool {
    [p.x, p.y].iter().all(|&x| x == 0.0 || (MIN_MAGNITUDE..=MAX_MAGNITUDE).contains(&x.abs()))
}

/// Whether the closed chain bounds a convex polygon, in either direction: it turns to one side only, nowhere back, and goes
/// round once, since it has one leftmost and one rightmost corner. Neighbouring points must differ. Exact, O(n).
fn is_convex(vertices: &[Point]) -> bool {
    let n = vertices.len();
    let (mut left, mut right, mut extremes) = (false, false, 0);
    for i in 0..n {
        let (before, at, after) = (vertices[(i + n - 1) % n], vertices[i], vertices[(i + 1) % n]);
        let turn = orientation(before, at, after);
        left |= turn > 0.0;
        right |= turn < 0.0;
        if left_to_right(before, at) != left_to_right(at, after) {
            extremes += 1;
            if turn == 0.0 {
                return false;
            }
        }
    }
    extremes == 2 && left != right
}

/// The direction of a simple polygon, read exactly at its lowest, then leftmost corner.
fn is_counter_clockwise(vertices: &[Point]) -> bool {
    let n = vertices.len();
    let lowest = (0..n)
        .min_by(|&i, &j| {
            let (a, b) = (vertices[i], vertices[j]);
            a.y.total_cmp(&b.y).then(a.x.total_cmp(&b.x)).then(i.cmp(&j))
        })
        .expect("a polygon has vertices");
    // That corner is a corner of the convex hull, so it turns strictly.
    orientation(vertices[(lowest + n - 1) % n], vertices[lowest], vertices[(lowest + 1) % n]) > 0.0
}
