//! Motions of an arm tested along the straight lines between the places of its joints, as in a course report, to show what that
//! misses.

use super::CollisionWorld;
use crate::geometry::Segment;
use crate::problem::{Contact, Validity};
use crate::robot::{Arm, link_name};
use crate::space::{ProductSpace, Space};

/// How often a refused motion is halved to find a part that passes.
const HALVINGS: usize = 10;

/// A collision checker of an arm for which a motion is free if its far end is, and if no obstacle meets the straight segment, as
/// wide as a link, between the places of any joint or of the end effector at both ends. Joints move on arcs and links sweep
/// areas, so this proves nothing: it accepts motions that collide, and refuses some that do not.
pub struct JointLines<const N: usize> {
    space: ProductSpace<N>,
    arm: Arm,
    world: CollisionWorld,
    proven: Box<dyn Validity<[f64; N]>>,
}

impl<const N: usize> JointLines<N> {
    /// The checker of the arm; `proven` is the one of its configurations in the same world.
    pub fn new(arm: &Arm, space: ProductSpace<N>, world: CollisionWorld, proven: Box<dyn Validity<[f64; N]>>) -> Self {
        Self { space, arm: arm.clone(), world, proven }
    }
}

impl<const N: usize> Validity<[f64; N]> for JointLines<N> {
    fn is_free(&self, q: &[f64; N]) -> bool {
        self.proven.is_free(q)
    }

    /// O(links log obstacles) if few obstacles are near.
    fn is_motion_free(&self, a: &[f64; N], b: &[f64; N]) -> bool {
        if !self.is_free(b) {
            return false;
        }
        let obstacles = self.world.obstacles();
        let [from, to] = [a, b].map(|q| self.arm.joints(self.space.coordinates(q)));
        let radius = self.arm.kept_radius();
        // The base does not move.
        (1..=self.arm.links().len()).all(|joint| {
            let line = Segment::new(from[joint], to[joint]);
            !obstacles.any_near(&line.aabb().grown(radius), |i| obstacles.distance(i, &line) <= radius)
        })
    }

    /// The longest part of the motion that passes, of those halved again and again; 0 if none does.
    fn first_hit(&self, a: &[f64; N], b: &[f64; N]) -> Option<f64> {
        let passes = |part: f64| self.is_motion_free(a, &self.space.interpolate(a, b, part));
        let mut halves = std::iter::successors(Some(0.5), |part| Some(0.5 * part)).take(HALVINGS);
        (!self.is_motion_free(a, b)).then(|| halves.find(|&part| passes(part)).unwrap_or(0.0))
    }

    fn contacts(&self, q: &[f64; N]) -> Vec<Contact> {
        self.proven.contacts(q)
    }

    fn part_name(&self, part: usize) -> String {
        link_name(part)
    }

    fn evaluation_nanoseconds(&self) -> u64 {
        self.proven.evaluation_nanoseconds()
    }

    fn clearance_evaluations(&self) -> u64 {
        self.proven.clearance_evaluations()
    }

    fn unproven_motions(&self) -> u64 {
        self.proven.unproven_motions()
    }
}
