//! Triangles of a simple polygon, by cutting off ears.

use super::{Aabb, Point, Polygon, orientation};

/// Triangles between vertices of the polygon that cover it without overlap: three indices each, counter-clockwise, two fewer
/// than there are vertices, none flat. Decided exactly. O(n^2) predicates as a rule, O(n^3) at worst.
///
/// An ear is a corner whose triangle with its neighbours lies in the polygon and holds no further vertex; every simple polygon
/// of more than three vertices has two (Meisters 1975, "Polygons have ears"). Corners on straight edges are no ears themselves
/// but are vertices like any other, so that a cut never passes through one.
pub fn triangles(polygon: &Polygon) -> Vec<[u32; 3]> {
    let vertices = polygon.vertices();
    let mut left: Vec<u32> = (0..vertices.len() as u32).collect();
    let mut triangles = Vec::with_capacity(left.len() - 2);
    let mut at = 0;
    while left.len() > 3 {
        let n = left.len();
        // Going on behind the last ear, not from the start, keeps triangles from becoming a fan of slivers.
        let ear = (0..n).map(|i| (at + i) % n).find(|&i| is_ear(vertices, &left, i));
        let ear = ear.expect("a simple polygon has ears");
        triangles.push(corner(&left, ear));
        left.remove(ear);
        at = ear + 1;
    }
    triangles.push([left[0], left[1], left[2]]);
    triangles
}

/// The vertices before, at and after place `i`.
fn corner(left: &[u32], i: usize) -> [u32; 3] {
    let n = left.len();
    [left[(i + n - 1) % n], left[i], left[(i + 1) % n]]
}

/// Whether the corner at place `i` can be cut off.
fn is_ear(vertices: &[Point], left: &[u32], i: usize) -> bool {
    let ear = corner(left, i);
    let [a, b, c] = ear.map(|v| vertices[v as usize]);
    if orientation(a, b, c) <= 0.0 {
        return false;
    }
    let around = Aabb::of(a, b).union(&Aabb::of(b, c));
    let is_in_ear = |p: Point| {
        around.contains(p) && orientation(a, b, p) >= 0.0 && orientation(b, c, p) >= 0.0 && orientation(c, a, p) >= 0.0
    };
    left.iter().all(|v| ear.contains(v) || !is_in_ear(vertices[*v as usize]))
}
