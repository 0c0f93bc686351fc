//! The free arcs of the circles, and the triangles of a navigation mesh that each passes through.

use super::circles::{Circle, Turn, angle_of, turn_left, turned};
use super::grown::Grown;
use super::mesh::Mesh;
use crate::geometry::{Disc, Segment, Vector, sort_stably};
use std::f64::consts::TAU;
use std::ops::Range;

/// By how much a part of an arc is longer at either end than found, in radians: what covers rounding.
const SLACK: f64 = 1e-9;

/// The longest part of an arc, in radians: much less than half a turn.
const LONGEST: f64 = 1.0;

/// How far from its centre it is looked for what covers a circle, in radii.
const REACHES: [f64; 3] = [0.25, 0.75, 2.0];

/// A free arc of a circle.
#[derive(Debug, Clone)]
pub(super) struct Arc {
    pub circle: u32,
    /// Where it begins, and how far to the left it reaches, in radians.
    pub from: f64,
    pub span: f64,
    /// Its parts in order.
    pub parts: Range<u32>,
}

impl Arc {
    /// Is it a whole circle?
    pub fn is_whole(&self) -> bool {
        self.span >= TAU
    }

    /// How far to the left of its beginning an angle is; an angle that rounding has put before that is a little less than 0.
    pub fn after(&self, angle: f64) -> f64 {
        let after = turn_left(self.from, angle);
        if !self.is_whole() && after > 0.5 * (self.span + TAU) { after - TAU } else { after }
    }

    /// How far along the arc an angle is, in the direction of a turn.
    pub fn place(&self, turn: Turn, angle: f64) -> f64 {
        turn.sign() * self.after(angle)
    }
}

/// A part of an arc in one triangle: from one angle, after that where the arc begins, to another one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part {
    pub arc: u32,
    pub triangle: u32,
    pub from: f64,
    pub to: f64,
}

/// All free arcs.
pub(super) struct Arcs {
    pub circles: Vec<Circle>,
    pub arcs: Vec<Arc>,
    pub parts: Vec<Part>,
    /// The parts in each triangle: those in a range of `order`.
    first: Vec<u32>,
    order: Vec<u32>,
}

impl Arcs {
    /// The free arcs of all circles. O(n (log n + k log k)) for n circles, each near k edges and triangles.
    pub fn new(grown: &Grown, mesh: &Mesh) -> Self {
        let circles = grown.circles();
        let (mut arcs, mut parts) = (Vec::new(), Vec::new());
        let (mut seen, mut near) = (vec![u32::MAX; mesh.len() as usize], 0);
        for (number, circle) in circles.iter().enumerate() {
            let free = free(grown, circle);
            if free.is_empty() {
                continue;
            }
            near = mesh.locate(circle.disc.center, near);
            let inside: Vec<(u32, [f64; 2])> = mesh
                .within(&circle.disc, near, &mut seen, number as u32)
                .into_iter()
                .flat_map(|triangle| stretches(mesh, &circle.disc, triangle).map(move |stretch| (triangle, stretch)))
                .collect();
            for [from, span] in free {
                let (arc, first) = (arcs.len() as u32, parts.len());
                for &(triangle, stretch) in &inside {
                    let part = |[from, to]: [f64; 2]| Part { arc, triangle, from, to };
                    parts.extend(overlap([from, span], stretch).map(part));
                }
                let mut own = parts.split_off(first);
                sort_stably(&mut own, |a, b| a.from.total_cmp(&b.from));
                parts.extend(own);
                arcs.push(Arc { circle: number as u32, from, span, parts: first as u32..parts.len() as u32 });
            }
        }
        let mut first = vec![0; mesh.len() as usize + 1];
        parts.iter().for_each(|part: &Part| first[part.triangle as usize + 1] += 1);
        (0..mesh.len() as usize).for_each(|i| first[i + 1] += first[i]);
        let (mut next, mut order) = (first.clone(), vec![0; parts.len()]);
        for (number, part) in parts.iter().enumerate() {
            let place = &mut next[part.triangle as usize];
            order[*place as usize] = number as u32;
            *place += 1;
        }
        Self { circles, arcs, parts, first, order }
    }

    /// The circle of an arc.
    pub fn circle(&self, arc: u32) -> &Circle {
        &self.circles[self.arcs[arc as usize].circle as usize]
    }

    /// The parts in a triangle.
    pub fn parts_in(&self, triangle: u32) -> impl ExactSizeIterator<Item = u32> + '_ {
        let [from, to] = [self.first[triangle as usize], self.first[triangle as usize + 1]];
        self.order[from as usize..to as usize].iter().copied()
    }
}

/// The free arcs of a circle: where each begins, and how far it reaches. O(k log k) for k edges near it, and if some are left,
/// a test of each.
fn free(grown: &Grown, circle: &Circle) -> Vec<[f64; 2]> {
    let [begin, span] = circle.normals.map_or([0.0, TAU], |normals| {
        let [before, after] = normals.map(|normal| angle_of(&normal));
        [before, turn_left(before, after)]
    });
    // Most circles are covered by what is nearest: then the rest is not looked at.
    let mut gaps = vec![[0.0, span]];
    for reach in REACHES {
        gaps = gaps_between(grown.covered(&circle.disc, reach * circle.disc.radius), [begin, span]);
        if gaps.is_empty() {
            return Vec::new();
        }
    }
    let mut stops: Vec<f64> = grown.crossings(&circle.disc).into_iter().map(|angle| turn_left(begin, angle)).collect();
    sort_stably(&mut stops, f64::total_cmp);
    stops.dedup();
    let is_free = |from: f64, to: f64| {
        let at = circle.at(begin + 0.5 * (from + to));
        grown.is_free(&Segment::new(at, at))
    };
    let mut free: Vec<[f64; 2]> = Vec::new();
    for [first, last] in gaps {
        let inside = stops.partition_point(|&stop| stop <= first)..stops.partition_point(|&stop| stop < last);
        let mut from = first;
        for to in stops[inside].iter().copied().chain([last]) {
            if is_free(from, to) {
                match free.last_mut() {
                    Some([_, end]) if *end == from => *end = to,
                    _ => free.push([from, to]),
                }
            }
            from = to;
        }
    }
    // On a whole circle the last one may go on with the first.
    if let [[first, end], .., [last, all]] = free[..]
        && (first, all) == (0.0, TAU)
    {
        free.pop();
        free[0] = [last, TAU + end];
    }
    free.into_iter().map(|[from, to]| [turned(begin + from), to - from]).collect()
}

/// What intervals of angles leave of an arc, as angles after that where it begins, in order.
fn gaps_between(covered: Vec<[f64; 2]>, [begin, span]: [f64; 2]) -> Vec<[f64; 2]> {
    let mut parts: Vec<[f64; 2]> = Vec::with_capacity(2 * covered.len());
    for [from, to] in covered {
        let first = turn_left(begin, turned(from));
        let last = first + (to - from);
        parts.push([first, last]);
        if last > TAU {
            parts.push([0.0, last - TAU]);
        }
    }
    sort_stably(&mut parts, |a, b| a[0].total_cmp(&b[0]));
    let (mut gaps, mut reached) = (Vec::new(), 0.0);
    for [from, to] in parts.into_iter().chain([[span, span]]) {
        if from > reached && reached < span {
            gaps.push([reached, from.min(span)]);
        }
        reached = reached.max(to);
    }
    gaps
}

/// The stretches of a circle in a triangle: from one angle in [0, 2 pi) to another one, at most 2 pi to the left of it.
fn stretches(mesh: &Mesh, circle: &Disc, triangle: u32) -> impl Iterator<Item = [f64; 2]> {
    let sides = mesh.sides(triangle).map(|side| mesh.segment(side));
    let mut stops = Vec::new();
    for side in &sides {
        // Relative to the centre, which often is an end of the side: then nothing is rounded.
        let (from, along) = (side.a - circle.center, side.b - side.a);
        let length = along.norm();
        let cos = along.perp(&from) / (length * circle.radius);
        if cos.abs() <= 1.0 {
            let (middle, half) = (angle_of(&Vector::new(along.y, -along.x)), libm::acos(-cos));
            stops.extend([middle - half, middle + half].map(turned));
        }
    }
    sort_stably(&mut stops, f64::total_cmp);
    if stops.is_empty() {
        stops.push(0.0);
    }
    let is_inside = move |angle: f64| {
        let (sin, cos) = libm::sincos(angle);
        let at = circle.radius * Vector::new(cos, sin);
        sides.iter().all(|side| (side.b - side.a).perp(&((circle.center - side.a) + at)) >= 0.0)
    };
    let ends: Vec<f64> = stops.iter().copied().skip(1).chain([stops[0] + TAU]).collect();
    stops.into_iter().zip(ends).map(|(from, to)| [from, to]).filter(move |[from, to]| is_inside(0.5 * (from + to)))
}

/// The parts of an arc, which begins at an angle and reaches some way, in a stretch, as angles after that where the arc begins.
fn overlap([begin, span]: [f64; 2], [from, to]: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    let first = turn_left(begin, turned(from)) - SLACK;
    let last = first + (to - from) + 2.0 * SLACK;
    // An angle at an end of the arc may be beyond it by a rounding; a whole circle has no end.
    let beyond = if span < TAU { SLACK } else { 0.0 };
    // A turn later the stretch may meet the beginning of the arc, and within the slack a turn before its end.
    let turns = [-TAU, 0.0, TAU].map(|turn| [(first + turn).max(-beyond), (last + turn).min(span + beyond)]);
    turns.into_iter().filter(|[from, to]| from <= to).flat_map(|[from, to]| {
        let pieces = libm::ceil((to - from) / LONGEST).max(1.0);
        let step = (to - from) / pieces;
        (0..pieces as u32).map(move |i| [from + step * f64::from(i), from + step * f64::from(i + 1)])
    })
}
