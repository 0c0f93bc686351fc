//! Collision of an arm: which link touches what, and which motions are free.

use super::obstacles::largest_coordinate;
use super::proof::separation::Work;
use super::proof::{Motion, Setting, distance, separation};
use super::{Obstacles, Tolerance};
use crate::geometry::{Aabb, Segment};
use crate::robot::Arm;
use crate::scenario::World;
use crate::space::{Joint, Metric, Space, Torus};
use crate::validity::{Contact, Touched, Validity};
use std::cell::RefCell;
use std::f64::consts::PI;

/// No edge turns a circle joint by this or more, in radians: there the short way round is ambiguous.
const LONGEST_TURN: f64 = PI - 1e-9;

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
    arm: Arm,
    space: Torus<N>,
    obstacles: Obstacles,
    bounds: Option<Aabb>,
    tolerance: Tolerance,
    work: RefCell<Work>,
}

impl<const N: usize> ArmValidity<N> {
    /// The arm in the world; `tolerance` is the wanted tolerance as a fraction of the longer side of the bounds (of twice the
    /// reach where there are none), greater than 0.
    pub fn new(arm: &Arm, space: Torus<N>, world: &World, tolerance: f64) -> Self {
        let obstacles = Obstacles::new(&world.obstacles);
        let base = arm.base().x.abs().max(arm.base().y.abs());
        let bounds = world.bounds.as_ref().map_or(0.0, largest_coordinate);
        let scale = obstacles.largest_coordinate().max(base).max(bounds) + arm.reach() + arm.radius();
        let side = world.bounds.as_ref().map_or(2.0 * arm.reach(), Aabb::longer_side);
        let tolerance = Tolerance::new(scale, tolerance * side);
        let (arm, bounds, work) = (arm.clone(), world.bounds, RefCell::default());
        Self { arm, space, obstacles, bounds, tolerance, work }
    }

    /// The same with a tolerance no coarser than half the clearance of either configuration.
    #[must_use]
    pub fn fitted(mut self, start: &[f64; N], goal: &[f64; N]) -> Self {
        self.tolerance = self.tolerance.fitted([self.clearance(start), self.clearance(goal)]);
        self
    }

    /// The distance from the arm to the nearest obstacle, in metres; infinite without obstacles. O(links x obstacles).
    pub fn clearance(&self, q: &[f64; N]) -> f64 {
        let nearest = |link: Segment| self.obstacles.clearance(&link) - self.arm.radius();
        self.links(q).map(nearest).fold(f64::INFINITY, f64::min)
    }

    /// The axes of the links at `q`, from the base outwards.
    fn links(&self, q: &[f64; N]) -> impl Iterator<Item = Segment> + use<N> {
        let places = self.arm.joints(self.space.coordinates(q));
        (0..self.space.dimension()).map(move |i| Segment::new(places[i], places[i + 1]))
    }

    /// Calls `found` with every contact at `q` until it answers false.
    fn visit_contacts(&self, q: &[f64; N], mut found: impl FnMut(Contact) -> bool) {
        let (radius, eta) = (self.arm.radius(), self.tolerance.eta);
        for (part, axis) in self.links(q).enumerate() {
            let mut go_on = true;
            let mut evaluations = 0;
            self.obstacles.candidates(&axis.aabb().grown(radius + eta), |i| {
                if go_on {
                    evaluations += 1;
                    if self.obstacles.distance(i, &axis) - radius <= eta {
                        go_on = found(Contact { part, with: Touched::Obstacle(i) });
                    }
                }
            });
            self.work.borrow_mut().evaluations += evaluations;
            let outside = |bounds: &Aabb| bounds.depth(axis.a).min(bounds.depth(axis.b)) - radius < -eta;
            if go_on && self.bounds.as_ref().is_some_and(outside) {
                go_on = found(Contact { part, with: Touched::Bounds });
            }
            if !go_on {
                return;
            }
        }
    }

    /// The same verdicts by the proof by distances: slower and simpler, the oracle of the tests. Where the first stretch of
    /// the motion begins that it cannot prove free; `None` where it proves all.
    pub fn first_hit_by_distances(&self, a: &[f64; N], b: &[f64; N]) -> Option<f64> {
        let first_hit = |setting: &Setting, motion: &Motion, work: &mut Work| {
            distance::first_hit(setting, motion, &mut work.evaluations)
        };
        self.prove(a, b, first_hit).unwrap_or(Some(0.0))
    }

    /// Runs `prove` on the motion from `a` to `b`; `None` where the short way round is ambiguous.
    #[inline]
    fn prove<T>(&self, a: &[f64; N], b: &[f64; N], prove: impl FnOnce(&Setting, &Motion, &mut Work) -> T) -> Option<T> {
        if self.space.turn(a, b) >= LONGEST_TURN {
            return None;
        }
        let delta = self.space.difference(a, b);
        let motion = Motion { from: self.space.coordinates(a), delta: self.space.coordinates(&delta) };
        let bounds = self.bounds.as_ref();
        let setting = Setting { arm: &self.arm, obstacles: &self.obstacles, bounds, tolerance: self.tolerance };
        Some(prove(&setting, &motion, &mut self.work.borrow_mut()))
    }
}

impl<const N: usize> Validity<[f64; N]> for ArmValidity<N> {
    fn is_free(&self, q: &[f64; N]) -> bool {
        let mut free = true;
        self.visit_contacts(q, |_| {
            free = false;
            false
        });
        free
    }

    fn is_motion_free(&self, a: &[f64; N], b: &[f64; N]) -> bool {
        self.prove(a, b, separation::is_free).unwrap_or(false)
    }

    fn first_hit(&self, a: &[f64; N], b: &[f64; N]) -> Option<f64> {
        self.prove(a, b, separation::first_hit).unwrap_or(Some(0.0))
    }

    fn contacts(&self, q: &[f64; N]) -> Vec<Contact> {
        let mut contacts = Vec::new();
        self.visit_contacts(q, |contact| {
            contacts.push(contact);
            true
        });
        contacts.sort_by_key(|contact| match contact.with {
            Touched::Obstacle(i) => (contact.part, i),
            Touched::Bounds => (contact.part, usize::MAX),
        });
        contacts
    }

    fn clearance_evaluations(&self) -> u64 {
        self.work.borrow().evaluations
    }
}
