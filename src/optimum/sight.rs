//! What a point, or a part of an arc, sees: its rays pass through the navigation mesh, and find the arcs that they touch.

use super::arcs::Arcs;
use super::circles::{Tangent, Turn, tangent};
use super::dead_ends::DeadEnds;
use super::mesh::{Mesh, Side};
use super::rays::{Rays, SLACK, Source, outermost};
use crate::geometry::{Point, Vector};

/// A navigation mesh and its arcs, and where rays may go.
pub(super) struct Sight<'a> {
    pub mesh: &'a Mesh,
    pub arcs: &'a Arcs,
    ends: &'a DeadEnds,
    /// Triangles of dead ends that rays enter.
    allowed: Vec<u32>,
}

/// A tangent from a source to an arc, and how that is passed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touch {
    pub arc: u32,
    pub turn: Turn,
    pub tangent: Tangent,
}

impl<'a> Sight<'a> {
    /// Rays enter no dead ends, but those in which one of the triangles is.
    pub fn new(mesh: &'a Mesh, arcs: &'a Arcs, ends: &'a DeadEnds, triangles: &[u32]) -> Self {
        let allowed = triangles.iter().flat_map(|&triangle| ends.out_of(triangle)).collect();
        Self { mesh, arcs, ends, allowed }
    }

    /// The side of the triangle beyond and its open part, if a shortest path may go there.
    fn across(&self, side: Side) -> Option<(Side, [Point; 2])> {
        let (across, open) = self.mesh.across(side)?;
        let triangle = across.triangle();
        (!self.ends.is_closed(triangle) || self.allowed.contains(&triangle)).then_some((across, open))
    }

    /// Where rays of a source go on that have entered a triangle through a side: to the left, and to the right.
    pub fn onward(&self, source: &Source, side: Side, rays: &Rays) -> [Option<(Side, Rays)>; 2] {
        let through = |side: Side| {
            let (across, open) = self.across(side)?;
            Some((across, source.through(rays, open)?))
        };
        [through(side.next().next()), through(side.next())]
    }

    /// Where rays of a source leave the triangle in which they begin through a side: those between two if given, else all, from
    /// a point.
    pub fn outward(&self, source: &Source, side: Side, only: Option<&Rays>) -> Option<(Side, Rays)> {
        let (across, open) = self.across(side)?;
        let rays = match only {
            Some(rays) => {
                source.through(rays, open).filter(|rays| source.crosses(&rays.middle(), &self.mesh.segment(side)))?
            }
            None => {
                let [right, left] = open.map(|point| outermost(&(point - source.point), 0.0));
                let rays = Rays { left: left?, right: right? };
                Some(rays).filter(|rays| rays.right.perp(&rays.left) >= -SLACK)?
            }
        };
        Some((across, rays))
    }

    /// Calls a function with each tangent from a source to an arc in a triangle that its rays have entered; from a point all
    /// are rays.
    pub fn touch(&self, source: &Source, triangle: u32, rays: Option<&Rays>, found: &mut dyn FnMut(Touch)) {
        for number in self.arcs.parts_in(triangle) {
            let part = self.arcs.parts[number as usize];
            let circle = self.arcs.circle(part.arc);
            let may_touch = rays.map_or([true; 2], |rays| source.may_touch(rays, &circle.disc));
            for (turn, may_touch) in Turn::BOTH.into_iter().zip(may_touch) {
                if !may_touch {
                    continue;
                }
                let tangent = tangent([&source.circle, circle], [source.turn, turn]);
                let Some(tangent) = tangent.filter(|tangent| is_among(rays, tangent)) else { continue };
                let after = self.arcs.arcs[part.arc as usize].after(tangent.angles[1]);
                if (part.from..=part.to).contains(&after) {
                    found(Touch { arc: part.arc, turn, tangent });
                }
            }
        }
    }

    /// Calls a function with each tangent from a source in a triangle to an arc, with some of them twice; not all are free.
    ///
    /// Takes one of `most` for each triangle that is seen, and for each part of an arc in it; `None` if they do not suffice.
    pub fn touch_all(
        &self,
        source: &Source,
        triangle: u32,
        only: Option<&Rays>,
        most: &mut u64,
        found: &mut dyn FnMut(Touch),
    ) -> Option<()> {
        let mut pay = |triangle: u32| {
            *most = most.checked_sub(1 + self.arcs.parts_in(triangle).len() as u64)?;
            Some(())
        };
        pay(triangle)?;
        self.touch(source, triangle, only, found);
        let sides = self.mesh.sides(triangle).into_iter();
        let mut open: Vec<(Side, Rays)> = sides.filter_map(|side| self.outward(source, side, only)).collect();
        while let Some((side, rays)) = open.pop() {
            pay(side.triangle())?;
            self.touch(source, side.triangle(), Some(&rays), found);
            open.extend(self.onward(source, side, &rays).into_iter().flatten());
        }
        Some(())
    }
}

/// Is the tangent one of the rays, if these are not all?
pub(super) fn is_among(rays: Option<&Rays>, tangent: &Tangent) -> bool {
    let along = tangent.segment.b - tangent.segment.a;
    rays.is_none_or(|rays| rays.contain(&(Vector::new(-along.y, along.x) / along.norm())))
}
