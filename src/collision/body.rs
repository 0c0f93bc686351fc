//! Collision of a body: any simple polygon that moves and turns, and which of its motions are free.

use super::obstacles::{depth, largest_coordinate};
use super::proof::{BodySetting, body_distance};
use super::{BodyMotion, Obstacles, Tolerance};
use crate::geometry::{Aabb, Point, Polygon};
use crate::robot::LARGEST;
use crate::scenario::World;
use crate::validity::{Contact, Touched};
use std::cell::Cell;

/// The largest angle to begin from, in radians, that proofs cover.
const LARGEST_ANGLE: f64 = 1e4;

/// The largest turn of a straight motion, in radians, that proofs cover: more than once around.
const LARGEST_TURN: f64 = 7.0;

/// A motion longer than so many times the scale leaves every world of that scale, straight or along an arc of one turn.
const LONGEST_PATH: f64 = 16.0;

/// What is free for a body among obstacles: compiled once. Placements are (x, y, theta) of the origin of the body's frame.
pub struct BodyCollision {
    body: Polygon,
    reach: f64,
    obstacles: Obstacles,
    bounds: Aabb,
    scale: f64,
    tolerance: Tolerance,
    evaluations: Cell<u64>,
}

impl BodyCollision {
    /// The body, in its own frame, in the world; `tolerance` is the wanted tolerance as a fraction of the longer side of the
    /// bounds, greater than 0. Where the world has no bounds, these are coordinates up to 1e6, and the slack is that of a
    /// world so large.
    pub fn new(body: &Polygon, world: &World, tolerance: f64) -> Self {
        let obstacles = Obstacles::new(&world.obstacles);
        let everywhere = Aabb { min: Point::new(-LARGEST, -LARGEST), max: Point::new(LARGEST, LARGEST) };
        let bounds = world.bounds.unwrap_or(everywhere);
        let reach = body.reach();
        let scale = obstacles.largest_coordinate().max(largest_coordinate(&bounds)) + reach;
        let tolerance = Tolerance::new(scale, tolerance * bounds.longer_side());
        Self { body: body.clone(), reach, obstacles, bounds, scale, tolerance, evaluations: Cell::new(0) }
    }

    /// The same with a tolerance no coarser than half the clearance, and half the depth within the bounds, of either placement.
    #[must_use]
    pub fn fitted(mut self, start: &[f64; 3], goal: &[f64; 3]) -> Self {
        let clearances = [start, goal].map(|q| self.clearance(q));
        let depths = [start, goal].map(|q| self.depth(q));
        self.tolerance = self.tolerance.fitted(clearances, depths);
        self
    }

    /// The same with the finest tolerance there is: it proves again whatever was proven with a coarser one.
    #[must_use]
    pub fn finest(mut self) -> Self {
        self.tolerance = self.tolerance.finest();
        self
    }

    /// Whether the body at `q` lies within the bounds and touches no obstacle.
    pub fn is_free(&self, q: &[f64; 3]) -> bool {
        self.contacts(q).is_empty()
    }

    /// Every contact at `q`: part 0 with obstacles by their index, the bounds last. O(vertices of the body x all vertices).
    pub fn contacts(&self, q: &[f64; 3]) -> Vec<Contact> {
        let placed = self.body.placed(*q);
        let near = placed.aabb().grown(self.tolerance.eta);
        let is_near = |&i: &usize| self.obstacles.aabb(i).intersects(&near);
        let touches = |&i: &usize| self.obstacles.distance_from(&placed, i) <= self.tolerance.eta;
        let touched = (0..self.obstacles.len()).filter(is_near).filter(touches).map(Touched::Obstacle);
        let leaves = depth(&self.bounds, placed.vertices()) < -self.tolerance.eta;
        touched.chain(leaves.then_some(Touched::Bounds)).map(|with| Contact { part: 0, with }).collect()
    }

    /// The distance from the body at `q` to the nearest obstacle, in metres; infinite without obstacles.
    pub fn clearance(&self, q: &[f64; 3]) -> f64 {
        let placed = self.body.placed(*q);
        (0..self.obstacles.len()).map(|i| self.obstacles.distance_from(&placed, i)).fold(f64::INFINITY, f64::min)
    }

    /// How deep the body at `q` lies within the bounds: negative where it is not wholly inside, in metres.
    pub fn depth(&self, q: &[f64; 3]) -> f64 {
        depth(&self.bounds, self.body.placed(*q).vertices())
    }

    /// Whether the motion is proven free, both ends included. Looks at the middle first, where collisions are found early.
    pub fn is_motion_free(&self, motion: &BodyMotion) -> bool {
        self.first_hit_by_distances(motion).is_none()
    }

    /// Where, as a fraction of the motion, the first stretch begins that cannot be proven free; all before it is proven. `None`
    /// where the whole motion is proven. Motions that no world of this scale holds are refused at 0: those that are not
    /// finite, begin at angles beyond 1e4 radians, turn by more than 7 on a straight way, or are longer than 16 scales.
    pub fn first_hit(&self, motion: &BodyMotion) -> Option<f64> {
        self.first_hit_by_distances(motion)
    }

    /// The same verdicts by the proof by distances: slower and simpler, the oracle of the tests.
    pub fn first_hit_by_distances(&self, motion: &BodyMotion) -> Option<f64> {
        let mut evaluations = self.evaluations.get();
        let hit = self.prove(motion, |setting, motion| body_distance::first_hit(setting, motion, &mut evaluations));
        self.evaluations.set(evaluations);
        hit
    }

    /// How many times the clearance of a part has been evaluated so far.
    pub fn clearance_evaluations(&self) -> u64 {
        self.evaluations.get()
    }

    /// Runs `prove` on the motion, or on its first turn where it goes round again and again.
    fn prove(&self, motion: &BodyMotion, prove: impl FnOnce(&BodySetting, &BodyMotion) -> Option<f64>) -> Option<f64> {
        let (once, part) = motion.once_around();
        let (path, turn) = once.extent();
        let [x, y, theta] = once.from();
        let is_covered = path <= LONGEST_PATH * self.scale
            && turn <= LARGEST_TURN
            && theta.abs() <= LARGEST_ANGLE
            && x.abs() <= self.scale
            && y.abs() <= self.scale;
        if !is_covered {
            return Some(0.0);
        }
        prove(&self.setting(), &once).map(|hit| hit * part)
    }

    fn setting(&self) -> BodySetting<'_> {
        BodySetting {
            body: &self.body,
            reach: self.reach,
            obstacles: &self.obstacles,
            bounds: &self.bounds,
            tolerance: self.tolerance,
        }
    }
}
