//! A navigation mesh: a constrained Delaunay triangulation of all obstacles (Chew 1989, "Constrained Delaunay triangulations").
//!
//! The mesh decides nothing: it says in which order a ray may meet obstacles. Constraints that cross each other, discs, and the
//! bounds may be missing, in part or altogether; then a ray passes where it is not free, which is found later.

use super::grown::Grown;
use crate::geometry::{Aabb, Disc, Point, Segment, Vector, distance_squared_point_segment, orientation};
use crate::scenario::Obstacle;
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation};
use std::f64::consts::TAU;

/// Corners of the polygon in a disc that stands for it.
const AROUND: u32 = 12;

/// Beyond the bounds, as a part of their longer side: so no position is a corner of the mesh.
const BEYOND: f64 = 0.125;

/// A point of the mesh, and the disc around or at it that no ray enters.
#[derive(Debug, Clone, Copy)]
pub(super) struct Vertex {
    pub at: Point,
    pub keep_out: Disc,
}

impl HasPosition for Vertex {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        Point2::new(self.at.x, self.at.y)
    }
}

/// A triangle and one of its sides, as the number of the triangle times 3 plus that of the side. Side i is from corner i to the
/// next one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Side(u32);

impl Side {
    const NONE: Self = Self(u32::MAX);

    pub fn new(triangle: u32, side: u32) -> Self {
        Self(3 * triangle + side)
    }

    pub fn triangle(self) -> u32 {
        self.0 / 3
    }

    /// The next side of the same triangle, counter-clockwise.
    pub fn next(self) -> Self {
        Self(if self.0 % 3 == 2 { self.0 - 2 } else { self.0 + 1 })
    }
}

/// Triangles, counter-clockwise, and which of their sides may be crossed.
pub(super) struct Mesh {
    vertices: Vec<Vertex>,
    /// The first corner of each side.
    corners: Vec<u32>,
    /// The same side of the triangle beyond, if there is one.
    beyond: Vec<Side>,
    /// The part of each side that the centre of the disc may cross.
    open: Vec<Option<[Point; 2]>>,
}

impl Mesh {
    /// Triangulates all obstacles within the bounds. O(n log n) for n corners, as a rule.
    pub fn new(grown: &Grown) -> Self {
        let (vertices, edges) = constraints(grown);
        // A constraint that crosses another one is left out.
        let cdt = ConstrainedDelaunayTriangulation::<Vertex>::try_bulk_load_cdt(vertices, edges, |_| {})
            .expect("coordinates are finite and not too small");
        let mut mesh = Self {
            vertices: cdt.vertices().map(|vertex| *vertex.data()).collect(),
            corners: Vec::with_capacity(3 * cdt.num_inner_faces()),
            beyond: Vec::with_capacity(3 * cdt.num_inner_faces()),
            open: Vec::with_capacity(3 * cdt.num_inner_faces()),
        };
        let faces = cdt.inner_faces();
        // Faces have consecutive numbers; that of the outside is 0.
        for face in faces {
            for edge in face.adjacent_edges() {
                mesh.corners.push(edge.from().fix().index() as u32);
                let other = edge.rev().face().as_inner().map(|face| (face.fix().index() - 1, face.adjacent_edges()));
                mesh.beyond.push(other.map_or(Side::NONE, |(triangle, edges)| {
                    let side = edges.iter().position(|one| *one == edge.rev()).expect("the side of the other triangle");
                    Side::new(triangle as u32, side as u32)
                }));
                let ends = [edge.from(), edge.to()].map(|vertex| *vertex.data());
                mesh.open.push(open_part(ends).filter(|_| !edge.is_constraint_edge()));
            }
        }
        mesh
    }

    /// The number of triangles.
    pub fn len(&self) -> u32 {
        (self.corners.len() / 3) as u32
    }

    /// The sides of a triangle.
    pub fn sides(&self, triangle: u32) -> [Side; 3] {
        [0, 1, 2].map(|side| Side::new(triangle, side))
    }

    /// The vertex from which a side begins.
    fn vertex(&self, side: Side) -> &Vertex {
        &self.vertices[self.corners[side.0 as usize] as usize]
    }

    /// A side as a segment.
    pub fn segment(&self, side: Side) -> Segment {
        Segment::new(self.vertex(side).at, self.vertex(side.next()).at)
    }

    /// The same side of the triangle beyond, and the part of it that the centre of the disc may cross, from right to left for one
    /// who looks across; `None` if there is no such part, or no such triangle.
    pub fn across(&self, side: Side) -> Option<(Side, [Point; 2])> {
        let open = self.open[side.0 as usize]?;
        Some((self.beyond(side)?, open))
    }

    /// The same, through obstacles too.
    fn beyond(&self, side: Side) -> Option<Side> {
        Some(self.beyond[side.0 as usize]).filter(|&side| side != Side::NONE)
    }

    /// A triangle that contains the point, which lies within the mesh: a walk from a triangle towards it (Green and Sibson 1978,
    /// "Computing Dirichlet tessellations in the plane"). O(sqrt n) as a rule.
    pub fn locate(&self, p: Point, near: u32) -> u32 {
        let is_outside = |side: Side| {
            let Segment { a, b } = self.segment(side);
            orientation(a, b, p) < 0.0
        };
        let mut at = near;
        for step in 0..self.len() {
            // The order in which sides are tried changes: so the walk does not go around for ever.
            let [a, b, c] = self.sides(at);
            let order = if step % 2 == 0 { [a, b, c] } else { [c, b, a] };
            match order.into_iter().find(|&side| is_outside(side)).and_then(|side| self.beyond(side)) {
                Some(beyond) => at = beyond.triangle(),
                None => return at,
            }
        }
        (0..self.len()).find(|&triangle| !self.sides(triangle).into_iter().any(is_outside)).unwrap_or(at)
    }

    /// All triangles that have a point within the disc; `near` is one of them. `seen` has a number for each triangle, which is
    /// `number` for none of them before and for these afterwards. O(found).
    pub fn within(&self, disc: &Disc, near: u32, seen: &mut [u32], number: u32) -> Vec<u32> {
        let most = disc.radius * disc.radius * (1.0 + 1e-9);
        let mut found = vec![near];
        seen[near as usize] = number;
        let mut next = 0;
        while let Some(&triangle) = found.get(next) {
            next += 1;
            for side in self.sides(triangle) {
                let Some(beyond) = self.beyond(side).map(Side::triangle) else { continue };
                if seen[beyond as usize] != number
                    && distance_squared_point_segment(disc.center, &self.segment(side)) <= most
                {
                    seen[beyond as usize] = number;
                    found.push(beyond);
                }
            }
        }
        found
    }
}

/// The part of a side that is outside the discs of its ends, each of which contains its end.
fn open_part([from, to]: [Vertex; 2]) -> Option<[Point; 2]> {
    let leaves = |from: &Vertex, to: &Vertex| {
        let Disc { center, radius } = from.keep_out;
        let (inside, along) = (from.at - center, to.at - from.at);
        let (squared, half) = (along.norm_squared(), inside.dot(&along));
        let root = (half * half - squared * (inside.norm_squared() - radius * radius)).max(0.0).sqrt();
        ((root - half) / squared).max(0.0)
    };
    let [first, last] = [leaves(&from, &to), leaves(&to, &from)];
    let at = |part: f64| from.at + part * (to.at - from.at);
    (first + last <= 1.0).then(|| [at(first), at(1.0 - last)])
}

/// All vertices, and the pairs of them that obstacles join.
fn constraints(grown: &Grown) -> (Vec<Vertex>, Vec<[usize; 2]>) {
    let radius = grown.kept_out();
    let mut vertices = Vec::new();
    let mut edges = Vec::new();
    // Numbers that are nearly zero are not allowed.
    let kept = |x: f64| if x.abs() < 1e-30 { 0.0 } else { x };
    let mut chain = |points: &mut dyn Iterator<Item = (Point, Disc)>, is_closed: bool| {
        let first = vertices.len();
        vertices.extend(points.map(|(at, keep_out)| Vertex { at: Point::new(kept(at.x), kept(at.y)), keep_out }));
        let last = vertices.len() - 1;
        edges.extend((first..last).map(|i| [i, i + 1]));
        if is_closed && last > first + 1 {
            edges.push([last, first]);
        }
    };
    let at = |radius: f64| move |&center: &Point| (center, Disc { center, radius });
    let size = grown.bounds.longer_side();
    let frame =
        grown.shapes.iter().fold(grown.bounds, |frame: Aabb, shape| frame.union(&shape.aabb())).grown(BEYOND * size);
    let corners = [
        [frame.min.x, frame.min.y],
        [frame.max.x, frame.min.y],
        [frame.max.x, frame.max.y],
        [frame.min.x, frame.max.y],
    ];
    chain(&mut corners.iter().map(|&[x, y]| Point::new(x, y)).map(|p| at(0.0)(&p)), true);
    for shape in grown.shapes.iter() {
        match shape {
            Obstacle::Disc(disc) if disc.radius == 0.0 => chain(&mut std::iter::once(at(radius)(&disc.center)), false),
            Obstacle::Disc(disc) => {
                let keep_out = Disc { radius: disc.radius + radius, ..*disc };
                let around = (0..AROUND).map(|i| {
                    let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(AROUND));
                    (disc.center + disc.radius * Vector::new(cos, sin), keep_out)
                });
                chain(&mut { around }, true);
            }
            Obstacle::Polygon(polygon) => chain(&mut polygon.vertices().iter().map(at(radius)), true),
            Obstacle::PolygonWithHoles(polygon) => {
                polygon.rings().for_each(|ring| chain(&mut ring.vertices().iter().map(at(radius)), true));
            }
            Obstacle::Wall(wall) => {
                chain(&mut wall.points().iter().map(at(radius + wall.radius())), wall.is_closed());
            }
        }
    }
    (vertices, edges)
}
