//! Collision of a body: any simple polygon that moves and turns, and which of its motions are free.

use super::motion::parts_of_motion;
use super::obstacles::{depth, largest_coordinate};
use super::proof::oracle::{self, PartDistance};
use super::proof::{MovingBody, Order, Prover, Scene};
use super::{BodyMotion, CollisionWorld, Obstacles, Tolerance};
use crate::geometry::{Aabb, Placed, Point, Polygon};
use crate::problem::{Contact, Touched};
use crate::robot::LARGEST;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The largest angle to begin from, in radians, that proofs cover.
const LARGEST_ANGLE: f64 = 1e4;

/// The largest turn of a straight motion, in radians, that proofs cover: more than once around.
const LARGEST_TURN: f64 = 7.0;

/// Among more obstacles than this a long motion is halved before it is tested,
const FEW: usize = 64;
/// until its parts are no longer than this many times the reach of the body,
const SHORT: f64 = 16.0;
/// and at most this often.
const MOST_HALVINGS: f64 = 8.0;

/// A motion longer than this many times the scale leaves every world of that scale: straight, or along one turn of an
/// arc. Half a turn is no wider than the diagonal, 2 sqrt(2) scales, so the whole arc no longer than 2 sqrt(2) pi.
const LONGEST_PATH: f64 = 9.0;

/// The collision checker of a body. Placements are (x, y, theta) of the origin of the body's frame.
pub struct BodyCollision {
    body: Polygon,
    /// By how much it is taken as larger on all sides, in metres.
    margin: f64,
    /// The obstacles as they are; those of the scene are their convex pieces.
    obstacles: Arc<Obstacles>,
    bounds: Aabb,
    /// The largest coordinate of the world plus the reach of the body, in metres.
    pub(super) scale: f64,
    pub(super) scene: Scene,
    /// A body and its dynamics share it.
    prover: Mutex<Prover<MovingBody>>,
    /// What sentences call it.
    pub(super) name: &'static str,
}

impl BodyCollision {
    /// The body, in its own frame, in the world; `tolerance` is the wanted tolerance as a fraction of the longer side of the
    /// bounds, greater than 0. If the world has no bounds, these are coordinates up to 1e6, and the slack is that of a
    /// world of this size.
    pub fn new(body: &Polygon, world: impl Into<CollisionWorld>, tolerance: f64) -> Self {
        Self::with_margin(body, 0.0, world, tolerance)
    }

    /// The same of a body that is larger by this margin on all sides, in metres.
    pub fn with_margin(body: &Polygon, margin: f64, world: impl Into<CollisionWorld>, tolerance: f64) -> Self {
        let world = world.into();
        let obstacles = world.obstacles();
        let everywhere = Aabb { min: Point::new(-LARGEST, -LARGEST), max: Point::new(LARGEST, LARGEST) };
        let bounds = world.bounds().copied().unwrap_or(everywhere);
        let scale = obstacles.largest_coordinate().max(largest_coordinate(&bounds)) + body.reach() + margin;
        let tolerance = Tolerance::new(scale, tolerance * bounds.longer_side());
        let mut moving = MovingBody::new(body, tolerance.eta);
        moving.grow(margin);
        let prover = Mutex::new(Prover::new(moving));
        let scene = Scene { obstacles: world.pieces(), bounds: Some(bounds), tolerance };
        Self { body: body.clone(), margin, obstacles, bounds, scale, scene, prover, name: "the body" }
    }

    fn prover(&self) -> MutexGuard<'_, Prover<MovingBody>> {
        self.prover.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The same, which sentences call by this name.
    #[must_use]
    pub(crate) fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
    }

    /// The same with a tolerance no coarser than half the clearance, and half the depth within the bounds, of either
    /// placement.
    #[must_use]
    pub fn fitted(mut self, start: &[f64; 3], goal: &[f64; 3]) -> Self {
        let clearances = [start, goal].map(|q| self.clearance_within(q, 2.0 * self.scene.tolerance.tau));
        let depths = [start, goal].map(|q| self.depth(q));
        self.scene.tolerance = self.scene.tolerance.fitted(clearances, depths);
        self
    }

    /// The same with the finest tolerance: it proves whatever is proven with a coarser one.
    #[must_use]
    pub fn finest(mut self) -> Self {
        self.scene.tolerance = self.scene.tolerance.finest();
        self
    }

    /// Whether the body at `q` lies within the bounds and touches no obstacle: decided by the tests of the proof if these
    /// leave half the slack to spare, else by the distances of [`BodyCollision::contacts`]. Both give the same verdict.
    pub fn is_free(&self, q: &[f64; 3]) -> bool {
        if q[2].abs() > LARGEST_ANGLE {
            return self.contacts(q).is_empty();
        }
        let prover = &mut *self.prover();
        prover.moving.rest(*q);
        match prover.is_free_at_rest(&self.scene) {
            Some(is_clear) => is_clear && !self.is_inside(*q),
            None => self.contacts(q).is_empty(),
        }
    }

    /// Whether the body, whose border does not meet that of any polygon with holes, lies in one.
    fn is_inside(&self, q: [f64; 3]) -> bool {
        self.obstacles.has_holes() && self.obstacles.is_in_polygon_with_holes(Placed::new(&self.body, q).corner(0))
    }

    /// Every contact at `q`: part 0 with obstacles by their index, the bounds last. O(vertices of the body +
    /// obstacles), and more for those that it is near.
    pub fn contacts(&self, q: &[f64; 3]) -> Vec<Contact> {
        let placed = self.body.placed(*q);
        let eta = self.scene.tolerance.eta;
        let near = placed.aabb().grown(eta + self.margin);
        let is_near = |&i: &usize| self.obstacles.aabb(i).intersects(&near);
        let touches =
            |&i: &usize| self.obstacles.distance_from(&placed, i, 2.0 * eta + self.margin) - self.margin <= eta;
        let touched = (0..self.obstacles.len()).filter(is_near).filter(touches).map(Touched::Obstacle);
        let leaves = depth(&self.bounds, placed.vertices()) - self.margin < -eta;
        touched.chain(leaves.then_some(Touched::Bounds)).map(|with| Contact { part: 0, with }).collect()
    }

    /// The distance from the body at `q` to the nearest obstacle, in metres; infinite without obstacles.
    pub fn clearance(&self, q: &[f64; 3]) -> f64 {
        let placed = self.body.placed(*q);
        let nearer = |least: f64, i: usize| least.min(self.obstacles.distance_from(&placed, i, least));
        (0..self.obstacles.len()).fold(f64::INFINITY, nearer) - self.margin
    }

    /// The same if it is less than `most`; else that distance or infinity. O(vertices of the body + log(obstacles)), and more for
    /// those that are near.
    fn clearance_within(&self, q: &[f64; 3], most: f64) -> f64 {
        let placed = self.body.placed(*q);
        let mut least = f64::INFINITY;
        self.obstacles.any_near(&placed.aabb().grown(most + self.margin), |i| {
            least = least.min(self.obstacles.distance_from(&placed, i, least));
            false
        });
        least - self.margin
    }

    /// The depth of the body at `q` within the bounds, in metres: negative if it is not wholly inside.
    pub fn depth(&self, q: &[f64; 3]) -> f64 {
        depth(&self.bounds, self.body.placed(*q).vertices()) - self.margin
    }

    /// Whether the motion is proven free, both ends included. Tests the middle first, where collisions are found early.
    pub fn is_motion_free(&self, motion: &BodyMotion) -> bool {
        self.first_unproven(motion, Order::MiddleFirst).is_none()
    }

    /// Whether a straight motion is proven free, also off by any part of `aside`, forward or back.
    pub(super) fn is_band_free(&self, motion: &BodyMotion, aside: [f64; 3]) -> bool {
        let [x, y, turn] = aside;
        self.prover().moving.grow(self.margin + ((x * x + y * y).sqrt() + turn.abs() * self.body.reach()));
        let is_free = self.is_motion_free(motion);
        self.prover().moving.grow(self.margin);
        is_free
    }

    /// The start, as a fraction of the motion, of the first interval that cannot be proven free; all before it is proven.
    /// `None` if the whole motion is proven. The result is 0 for motions that are not finite or longer than 1e150, begin
    /// far outside the bounds or at an angle beyond 1e4 radians, or turn by more than 7 on a straight motion.
    pub fn first_hit(&self, motion: &BodyMotion) -> Option<f64> {
        self.first_unproven(motion, Order::FrontFirst { steps: None })
    }

    /// How many of the equal steps that the motion consists of are free, from the start on: as many as lie before
    /// [`first_hit`](Self::first_hit), with fewer evaluations.
    pub fn free_steps(&self, motion: &BodyMotion, steps: u32) -> u32 {
        let order = Order::FrontFirst { steps: Some(f64::from(steps)) };
        // A step that rounding has let past the hit is past it by less than the slack of the proof.
        self.first_unproven(motion, order).map_or(steps, |hit| (hit * f64::from(steps)) as u32)
    }

    /// The verdict of the proof by distances: slower and simpler, the oracle of the tests.
    pub fn first_hit_by_distances(&self, motion: &BodyMotion) -> Option<f64> {
        let Some((motion, fraction)) = self.decisive_part(motion) else { return Some(0.0) };
        let (path, turn) = motion.extent();
        let travel = path + turn * self.body.reach();
        let parts = |t: f64| {
            vec![PartDistance { clearance: self.clearance(&motion.at(t)), depth: self.depth(&motion.at(t)), travel }]
        };
        oracle::first_hit(&self.scene.tolerance, &parts).map(|hit| hit * fraction)
    }

    /// The slack and the tolerance.
    pub fn tolerance(&self) -> Tolerance {
        self.scene.tolerance
    }

    /// Whether the body may touch something in one of the boxes on the motion, or come within the slack of it; `true` for motions
    /// that proofs do not cover. O(vertices of the body + boxes).
    pub fn may_meet(&self, motion: &BodyMotion, boxes: &[Aabb]) -> bool {
        let Some((motion, _)) = self.decisive_part(motion) else { return true };
        let (path, turn) = motion.extent();
        let travel = path + turn * self.body.reach();
        let own = self.margin + 2.0 * self.scene.tolerance.eta;
        parts_of_motion().any(|(middle, half)| {
            let around = self.body.placed(motion.at(middle)).aabb().grown(own + half * travel);
            boxes.iter().any(|one| one.intersects(&around))
        })
    }

    /// How many times the clearance of a part has been evaluated so far.
    pub fn clearance_evaluations(&self) -> u64 {
        self.prover().evaluations
    }

    /// How many motions have been refused so far because the budget of their proof was spent.
    pub fn unproven_motions(&self) -> u64 {
        self.prover().unproven
    }

    /// The start of the first interval, in this order, that cannot be proven free.
    #[inline(always)]
    fn first_unproven(&self, motion: &BodyMotion, order: Order) -> Option<f64> {
        let Some((motion, fraction)) = self.decisive_part(motion) else { return Some(0.0) };
        let order = match order {
            Order::FrontFirst { steps: Some(steps) } => Order::FrontFirst { steps: Some(steps * fraction) },
            order => order,
        };
        if self.is_inside(motion.from()) {
            return Some(0.0);
        }
        let halvings = if order == Order::MiddleFirst { self.halvings(&motion) } else { 0 };
        let prover = &mut *self.prover();
        prover.moving.begin(&motion);
        prover.first_unproven(&self.scene, (), order, halvings).map(|hit| hit * fraction)
    }

    /// How often a motion is halved before it is tested.
    fn halvings(&self, motion: &BodyMotion) -> u32 {
        if self.scene.obstacles.len() <= FEW {
            return 0;
        }
        let parts = motion.extent().0 / (SHORT * self.body.reach());
        libm::log2(parts.max(1.0)).ceil().min(MOST_HALVINGS) as u32
    }

    /// The part of the motion that decides about all of it, and its fraction of the motion; `None` if proofs do not cover it.
    #[inline(always)]
    fn decisive_part(&self, motion: &BodyMotion) -> Option<(BodyMotion, f64)> {
        let (path, turn) = motion.extent();
        let [x, y, theta] = motion.from();
        let is_covered = path.is_finite()
            && turn.is_finite()
            && (turn <= LARGEST_TURN || matches!(motion, BodyMotion::Arc { .. }))
            && theta.abs() <= LARGEST_ANGLE
            && x.abs() <= self.scale
            && y.abs() <= self.scale;
        is_covered.then(|| motion.decisive_part(LONGEST_PATH * self.scale))
    }
}
