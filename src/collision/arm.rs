//! Collision of an arm: contacts of its links, and which motions are free.

use super::motion::{LONGEST_TURN, parts_of_motion};
use super::obstacles::largest_coordinate;
use super::proof::oracle::{self, PartDistance};
use super::proof::{MovingArm, Order, Prover, Scene};
use super::{CollisionWorld, Obstacles, Tolerance, blend};
use crate::geometry::{Aabb, Segment};
use crate::problem::{Contact, Touched, Validity};
use crate::robot::{Arm, Joint, link_name};
use crate::space::{ProductSpace, Space};
use std::cell::RefCell;
use std::sync::Arc;

/// If joint limits or fixed angles are wider than this, in radians, the slack is doubled.
const WIDE: f64 = 50.0;

/// The collision checker of an arm, over the space of its joints.
pub struct ArmValidity<const N: usize> {
    space: ProductSpace<N>,
    arm: Arm,
    /// The obstacles as they are; those of the scene are their convex pieces.
    obstacles: Arc<Obstacles>,
    scene: Scene,
    prover: RefCell<Prover<MovingArm<N>>>,
    /// Whether the base lies in a polygon with holes: then so does whatever does not meet the border of that.
    is_buried: bool,
}

impl<const N: usize> ArmValidity<N> {
    /// The arm in the world; `tolerance` is the wanted tolerance as a fraction of the longer side of the bounds (of twice the
    /// reach if there are none), greater than 0.
    pub fn new(arm: &Arm, space: ProductSpace<N>, world: impl Into<CollisionWorld>, tolerance: f64) -> Self {
        let world = world.into();
        let obstacles = world.obstacles();
        let base = arm.base().x.abs().max(arm.base().y.abs());
        let bounds = world.bounds().map_or(0.0, largest_coordinate);
        let scale = obstacles.largest_coordinate().max(base).max(bounds) + arm.reach() + arm.kept_radius();
        let side = world.bounds().map_or(2.0 * arm.reach(), Aabb::longer_side);
        // Sums of angles round more if limits are wide: see `proof/arm.rs`.
        let widest = arm.joint_types().iter().map(|joint| match *joint {
            Joint::Revolute { limits } => limits.map_or(0.0, |[low, high]| low.abs().max(high.abs())),
            Joint::Prismatic { angle, .. } => angle.abs(),
        });
        let widest = widest.fold(0.0, f64::max);
        let scale = if widest > WIDE { 2.0 * scale } else { scale };
        let tolerance = Tolerance::new(scale, tolerance * side);
        let prover = RefCell::new(Prover::new(MovingArm::new(arm, tolerance.eta)));
        let scene = Scene { obstacles: world.pieces(), bounds: world.bounds().copied(), tolerance };
        let is_buried = obstacles.is_in_polygon_with_holes(arm.base());
        Self { space, arm: arm.clone(), obstacles, scene, prover, is_buried }
    }

    /// The same with a tolerance no coarser than half the clearance of either configuration, and half its depth within the
    /// bounds.
    #[must_use]
    pub fn fitted(mut self, start: &[f64; N], goal: &[f64; N]) -> Self {
        let depths = [start, goal].map(|q| self.depth(q));
        // A clearance above twice the tolerance does not make it finer.
        let most = 2.0 * self.scene.tolerance.tau;
        let clearances = [start, goal].map(|q| self.clearance_within(q, most));
        self.scene.tolerance = self.scene.tolerance.fitted(clearances, depths);
        self
    }

    /// The same with the finest tolerance: it proves whatever is proven with a coarser one.
    #[must_use]
    pub fn finest(mut self) -> Self {
        self.scene.tolerance = self.scene.tolerance.finest();
        self
    }

    /// The distance from the arm to the nearest obstacle, in metres; infinite without obstacles. O(links x obstacles).
    pub fn clearance(&self, q: &[f64; N]) -> f64 {
        let clearance = |link: Segment| self.obstacles.clearance(&link) - self.arm.kept_radius();
        self.links(q).map(clearance).fold(f64::INFINITY, f64::min)
    }

    /// The verdict of the proof by distances: slower and simpler, the oracle of the tests. The start of the first
    /// interval of the motion that it cannot prove free; `None` if it proves all.
    pub fn first_hit_by_distances(&self, a: &[f64; N], b: &[f64; N]) -> Option<f64> {
        let Some(delta) = self.delta(a, b) else { return Some(0.0) };
        let travel = self.arm.travel(&delta);
        let parts = |t: f64| {
            let mut q = *a;
            q.iter_mut().zip(&delta).for_each(|(angle, delta)| *angle += t * delta);
            let part = |(i, link): (usize, Segment)| PartDistance {
                clearance: self.obstacles.clearance(&link) - self.arm.kept_radius(),
                depth: self.depth_of(&link),
                travel: travel[i],
            };
            self.links(&q).enumerate().map(part).collect()
        };
        oracle::first_hit(&self.scene.tolerance, &parts)
    }

    /// The slack and the tolerance.
    pub fn tolerance(&self) -> Tolerance {
        self.scene.tolerance
    }

    /// Whether the arm may touch something in one of the boxes on the motion from `a` to `b`, or come within the slack of it.
    /// O(links x boxes).
    pub fn may_meet(&self, a: &[f64; N], b: &[f64; N], boxes: &[Aabb]) -> bool {
        let Some(delta) = self.delta(a, b) else { return true };
        let travel = self.arm.travel(&delta);
        let own = self.arm.kept_radius() + 2.0 * self.scene.tolerance.eta;
        parts_of_motion().any(|(middle, half)| {
            let q: [f64; N] = std::array::from_fn(|i| a[i] + middle * delta[i]);
            let mut around = self.links(&q).zip(travel).map(|(link, travel)| link.aabb().grown(own + half * travel));
            around.any(|around| boxes.iter().any(|one| one.intersects(&around)))
        })
    }

    /// How far each joint moves on the motion from `a` to `b`; `None` if the short way round is ambiguous.
    #[inline(always)]
    fn delta(&self, a: &[f64; N], b: &[f64; N]) -> Option<[f64; N]> {
        let delta = self.space.difference(a, b);
        let is_ambiguous = |i: usize| delta[i].abs() >= LONGEST_TURN && self.space.is_circle(i);
        (!(0..self.space.dimension()).any(is_ambiguous)).then_some(delta)
    }

    /// The start of the first interval, in this order, that cannot be proven free.
    #[inline(always)]
    fn first_unproven(&self, a: &[f64; N], b: &[f64; N], order: Order) -> Option<f64> {
        let Some(delta) = self.delta(a, b) else { return Some(0.0) };
        self.prove(a, &delta, order)
    }

    /// The same of a motion by `delta`.
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    fn prove(&self, from: &[f64; N], delta: &[f64; N], order: Order) -> Option<f64> {
        if self.is_buried {
            return Some(0.0);
        }
        let prover = &mut *self.prover.borrow_mut();
        let state = prover.moving.begin(from, delta);
        prover.first_unproven(&self.scene, state, order, 0)
    }

    /// Whether a straight motion by `delta` is proven free, also off by any part of `aside`, forward or back.
    fn is_band_free(&self, from: &[f64; N], delta: &[f64; N], aside: &[f64; N]) -> bool {
        let off = self.arm.travel(aside)[self.arm.links().len() - 1];
        self.prover.borrow_mut().moving.set_radius(self.arm.kept_radius() + off);
        let is_free = self.prove(from, delta, Order::MiddleFirst).is_none();
        self.prover.borrow_mut().moving.set_radius(self.arm.kept_radius());
        is_free
    }

    /// The clearance if it is at most `most`; else something larger.
    fn clearance_within(&self, q: &[f64; N], most: f64) -> f64 {
        let mut least = f64::INFINITY;
        for link in self.links(q) {
            let near = link.aabb().grown(self.arm.kept_radius() + most);
            self.obstacles.any_near(&near, |i| {
                least = least.min(self.obstacles.distance(i, &link) - self.arm.kept_radius());
                false
            });
        }
        least
    }

    /// The axes of the links at `q`, from the base outwards.
    fn links(&self, q: &[f64; N]) -> impl Iterator<Item = Segment> + use<N> {
        let joints = self.arm.joints(self.space.coordinates(q));
        (0..self.arm.links().len()).map(move |i| Segment::new(joints[i], joints[i + 1]))
    }

    /// The depth of the outer ends of the links within the bounds, in metres; infinite without bounds. The base does not
    /// move.
    fn depth(&self, q: &[f64; N]) -> f64 {
        let outer_end = |link: Segment| self.depth_of(&Segment::new(link.b, link.b));
        self.links(q).map(outer_end).fold(f64::INFINITY, f64::min)
    }

    /// The depth of the link within the bounds, in metres; infinite without bounds.
    fn depth_of(&self, axis: &Segment) -> f64 {
        let depth = |bounds: &Aabb| bounds.depth(axis.a).min(bounds.depth(axis.b)) - self.arm.kept_radius();
        self.scene.bounds.as_ref().map_or(f64::INFINITY, depth)
    }
}

impl<const N: usize> Validity<[f64; N]> for ArmValidity<N> {
    /// Decided by the tests of the proof if these leave half the slack to spare, else by the distances of the contacts:
    /// both give the same verdict.
    fn is_free(&self, q: &[f64; N]) -> bool {
        let prover = &mut *self.prover.borrow_mut();
        prover.moving.rest(q);
        match prover.is_free_at_rest(&self.scene) {
            Some(is_clear) => is_clear && !self.is_buried,
            None => self.contacts(q).is_empty(),
        }
    }

    fn is_motion_free(&self, a: &[f64; N], b: &[f64; N]) -> bool {
        self.first_unproven(a, b, Order::MiddleFirst).is_none()
    }

    fn first_hit(&self, a: &[f64; N], b: &[f64; N]) -> Option<f64> {
        self.first_unproven(a, b, Order::FrontFirst { steps: None })
    }

    fn is_blend_free(&self, [from, corner, to]: &[[f64; N]; 3]) -> bool {
        let [before, after] = [from, to].map(|end| self.space.difference(corner, end));
        blend::is_free(corner, &before, &after, |from, delta, aside| self.is_band_free(from, delta, aside))
    }

    /// Ordered by link, then by obstacle, the bounds last.
    fn contacts(&self, q: &[f64; N]) -> Vec<Contact> {
        let Tolerance { eta, .. } = self.scene.tolerance;
        let mut contacts = Vec::new();
        for (part, axis) in self.links(q).enumerate() {
            let near = axis.aabb().grown(self.arm.kept_radius() + eta);
            let is_touched = |&i: &usize| {
                self.obstacles.aabb(i).intersects(&near)
                    && self.obstacles.distance(i, &axis) - self.arm.kept_radius() <= eta
            };
            let touched = (0..self.obstacles.len()).filter(is_touched).map(Touched::Obstacle);
            let leaves = (self.depth_of(&axis) < -eta).then_some(Touched::Bounds);
            contacts.extend(touched.chain(leaves).map(|with| Contact { part, with }));
        }
        contacts
    }

    fn part_name(&self, part: usize) -> String {
        link_name(part)
    }

    fn clearance_evaluations(&self) -> u64 {
        self.prover.borrow().evaluations
    }

    fn unproven_motions(&self) -> u64 {
        self.prover.borrow().unproven
    }
}
