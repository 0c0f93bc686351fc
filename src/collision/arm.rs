//! Collision of an arm: which link touches what, and which motions are free.

use super::motion::LONGEST_TURN;
use super::obstacles::largest_coordinate;
use super::proof::separation::Work;
use super::proof::{Answer, Link, Motion, MovingJoint, Setting, distance, separation, unit};
use super::{Obstacles, Tolerance};
use crate::geometry::{Aabb, Segment};
use crate::robot::Arm;
use crate::scenario::World;
use crate::space::{Joint, Metric, Space, Torus};
use crate::validity::{Contact, Touched, Validity};
use std::cell::RefCell;

/// From joint limits wider than this on, in radians, the slack is doubled.
const WIDE: f64 = 50.0;

/// The space of an arm: a circle a joint, or an interval where the arm has limits.
///
/// # Panics
/// Where the arm has more than `N` links.
pub fn joint_space<const N: usize>(arm: &Arm, metric: Metric) -> Torus<N> {
    let joints: Vec<Joint> = match arm.joint_limits() {
        Some(limits) => limits.iter().map(|&[low, high]| Joint::Interval { low, high }).collect(),
        None => vec![Joint::Circle; arm.links().len()],
    };
    Torus::new(&joints, metric)
}

/// What is free for an arm among obstacles, over the space of its joints.
pub struct ArmValidity<const N: usize> {
    space: Torus<N>,
    collision: ArmCollision,
    work: RefCell<Work<N>>,
}

impl<const N: usize> ArmValidity<N> {
    /// The arm in the world; `tolerance` is the wanted tolerance as a fraction of the longer side of the bounds (of twice the
    /// reach where there are none), greater than 0.
    pub fn new(arm: &Arm, space: Torus<N>, world: &World, tolerance: f64) -> Self {
        Self { space, collision: ArmCollision::new(arm, world, tolerance), work: RefCell::default() }
    }

    /// The same with a tolerance no coarser than half the clearance of either configuration.
    #[must_use]
    pub fn fitted(mut self, start: &[f64; N], goal: &[f64; N]) -> Self {
        let tolerance = self.collision.tolerance;
        let depths = [start, goal].map(|q| self.collision.depth(self.space.coordinates(q)));
        // Twice the tolerance is as much clearance as can make it finer.
        let clearances =
            [start, goal].map(|q| self.collision.clearance_within(self.space.coordinates(q), 2.0 * tolerance.tau));
        self.collision.tolerance = tolerance.fitted(clearances, depths);
        self
    }

    /// The same with the finest tolerance there is: it proves again whatever was proven with a coarser one. A motion along
    /// an obstacle, nearer than is ever drawn, takes it long.
    #[must_use]
    pub fn finest(mut self) -> Self {
        self.collision.tolerance = self.collision.tolerance.finest();
        self
    }

    /// The distance from the arm to the nearest obstacle, in metres; infinite without obstacles. O(links x obstacles).
    pub fn clearance(&self, q: &[f64; N]) -> f64 {
        self.collision.clearance(self.space.coordinates(q))
    }

    /// The same verdicts by the proof by distances: slower and simpler, the oracle of the tests. Where the first stretch of
    /// the motion begins that it cannot prove free; `None` where it proves all.
    pub fn first_hit_by_distances(&self, a: &[f64; N], b: &[f64; N]) -> Option<f64> {
        let first_hit = |setting: &Setting, motion: &Motion<N>, work: &mut Work<N>| {
            distance::first_hit(setting, motion, &mut work.evaluations)
        };
        self.prove(a, b, first_hit).unwrap_or(Some(0.0))
    }

    /// Runs `prove` on the motion from `a` to `b`; `None` where the short way round is ambiguous.
    #[inline(always)]
    fn prove<T>(
        &self,
        a: &[f64; N],
        b: &[f64; N],
        prove: impl FnOnce(&Setting, &Motion<N>, &mut Work<N>) -> T,
    ) -> Option<T> {
        let delta = self.space.difference(a, b);
        let is_ambiguous = |i: usize| delta[i].abs() >= LONGEST_TURN && self.space.is_circle(i);
        if (0..self.space.dimension()).any(is_ambiguous) {
            return None;
        }
        Some(prove(&self.collision.setting(), &Motion { from: a, delta: &delta }, &mut self.work.borrow_mut()))
    }
}

impl<const N: usize> Validity<[f64; N]> for ArmValidity<N> {
    fn is_free(&self, q: &[f64; N]) -> bool {
        self.collision.is_free(self.space.coordinates(q), &mut self.work.borrow_mut().evaluations)
    }

    fn is_motion_free(&self, a: &[f64; N], b: &[f64; N]) -> bool {
        self.prove(a, b, separation::is_free).unwrap_or(false)
    }

    fn first_hit(&self, a: &[f64; N], b: &[f64; N]) -> Option<f64> {
        self.prove(a, b, separation::first_hit).unwrap_or(Some(0.0))
    }

    fn contacts(&self, q: &[f64; N]) -> Vec<Contact> {
        self.collision.contacts(self.space.coordinates(q))
    }

    fn clearance_evaluations(&self) -> u64 {
        self.work.borrow().evaluations
    }
}

/// The arm among obstacles, for configurations of any dimension: compiled once.
struct ArmCollision {
    arm: Arm,
    obstacles: Obstacles,
    bounds: Option<Aabb>,
    tolerance: Tolerance,
}

impl ArmCollision {
    fn new(arm: &Arm, world: &World, tolerance: f64) -> Self {
        let obstacles = Obstacles::new(&world.obstacles);
        let base = arm.base().x.abs().max(arm.base().y.abs());
        let bounds = world.bounds.as_ref().map_or(0.0, largest_coordinate);
        let scale = obstacles.largest_coordinate().max(base).max(bounds) + arm.reach() + arm.radius();
        let side = world.bounds.as_ref().map_or(2.0 * arm.reach(), Aabb::longer_side);
        // Sums of angles round more where limits are wide: see `proof/separation.rs`.
        let widest =
            arm.joint_limits().unwrap_or_default().iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        let scale = if widest > WIDE { 2.0 * scale } else { scale };
        let tolerance = Tolerance::new(scale, tolerance * side);
        Self { arm: arm.clone(), obstacles, bounds: world.bounds, tolerance }
    }

    fn setting(&self) -> Setting<'_> {
        let bounds = self.bounds.as_ref();
        Setting { arm: &self.arm, obstacles: &self.obstacles, bounds, tolerance: self.tolerance }
    }

    fn clearance(&self, q: &[f64]) -> f64 {
        let nearest = |link: Segment| self.obstacles.clearance(&link) - self.arm.radius();
        self.links(q).map(nearest).fold(f64::INFINITY, f64::min)
    }

    /// The clearance where it is `most` at most; else something larger.
    fn clearance_within(&self, q: &[f64], most: f64) -> f64 {
        let mut least = f64::INFINITY;
        for link in self.links(q) {
            let near = link.aabb().grown(self.arm.radius() + most);
            self.obstacles.any_near(&near, |i| {
                least = least.min(self.obstacles.distance(i, &link) - self.arm.radius());
                false
            });
        }
        least
    }

    /// The axes of the links at `q`, from the base outwards.
    fn links(&self, q: &[f64]) -> impl Iterator<Item = Segment> + use<> {
        let places = self.arm.joints(q);
        (0..self.arm.links().len()).map(move |i| Segment::new(places[i], places[i + 1]))
    }

    /// Whether the link touches obstacle `i`.
    fn touches(&self, i: usize, axis: &Segment) -> bool {
        self.obstacles.distance(i, axis) - self.arm.radius() <= self.tolerance.eta
    }

    /// How deep the links that can move lie within the bounds, in metres; infinite without bounds.
    fn depth(&self, q: &[f64]) -> f64 {
        let Some(bounds) = &self.bounds else { return f64::INFINITY };
        self.links(q).map(|axis| bounds.depth(axis.b) - self.arm.radius()).fold(f64::INFINITY, f64::min)
    }

    /// How deep the link lies within the bounds, in metres; infinite without bounds.
    fn depth_of(&self, axis: &Segment) -> f64 {
        let depth = |bounds: &Aabb| bounds.depth(axis.a).min(bounds.depth(axis.b)) - self.arm.radius();
        self.bounds.as_ref().map_or(f64::INFINITY, depth)
    }

    /// Whether a part of the link is outside the bounds.
    fn is_outside(&self, axis: &Segment) -> bool {
        self.depth_of(axis) < -self.tolerance.eta
    }

    /// Whether nothing is touched: told by quick kinematics and separating lines where these leave half the slack to spare,
    /// else by the distances of [`ArmCollision::contacts`]. Both give the same answer.
    fn is_free(&self, q: &[f64], evaluations: &mut u64) -> bool {
        let Tolerance { eta, .. } = self.tolerance;
        let margin = self.arm.radius() + 1.5 * eta;
        let mut inner = MovingJoint::base(self.arm.base());
        let mut angle = 0.0;
        for (i, &length) in self.arm.links().iter().enumerate() {
            angle += q[i];
            let along = unit(angle);
            let outer = inner.next(along, length, 0.0, 0.0);
            let link = Link { ends: [&inner, &outer], along };
            let axis = Segment::new(inner.place(), outer.place());
            let is_outside = match self.depth_of(&axis) {
                depth if depth >= -0.5 * eta => false,
                depth if depth < -1.5 * eta => true,
                _ => self.is_outside(&self.link(q, i)),
            };
            let touches = |k: usize| {
                *evaluations += 1;
                match link.separate_at_rest(&self.obstacles, k, margin, eta) {
                    Answer::Apart => false,
                    Answer::Touching => true,
                    _ => self.touches_at(q, i, k),
                }
            };
            if is_outside || self.obstacles.any_near(&axis.aabb().grown(margin), touches) {
                return false;
            }
            inner = outer;
        }
        true
    }

    /// The axis of link `i` at `q`.
    fn link(&self, q: &[f64], i: usize) -> Segment {
        let places = self.arm.joints(q);
        Segment::new(places[i], places[i + 1])
    }

    /// Whether link `i` touches obstacle `k` at `q`, by their distance.
    #[cold]
    fn touches_at(&self, q: &[f64], i: usize, k: usize) -> bool {
        let axis = self.link(q, i);
        self.obstacles.aabb(k).intersects(&self.near(&axis)) && self.touches(k, &axis)
    }

    /// Every contact at `q`, by link, then by obstacle, the bounds last.
    fn contacts(&self, q: &[f64]) -> Vec<Contact> {
        let mut contacts = Vec::new();
        for (part, axis) in self.links(q).enumerate() {
            let near = self.near(&axis);
            let obstacles = (0..self.obstacles.len()).filter(|&i| self.obstacles.aabb(i).intersects(&near));
            let touched = obstacles.filter(|&i| self.touches(i, &axis)).map(Touched::Obstacle);
            contacts.extend(touched.map(|with| Contact { part, with }));
            contacts.extend(self.is_outside(&axis).then_some(Contact { part, with: Touched::Bounds }));
        }
        contacts
    }

    /// The box outside which nothing can touch the link.
    fn near(&self, axis: &Segment) -> Aabb {
        axis.aabb().grown(self.arm.radius() + self.tolerance.eta)
    }
}
