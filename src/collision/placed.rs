//! What is free for a body that is placed by (x, y, theta), over the space of its placements.

use super::body::BodyCollision;
use super::motion::{BodyMotion, LONGEST_TURN};
use crate::geometry::{Aabb, Point, Polygon};
use crate::robot::Weights;
use crate::scenario::World;
use crate::space::Torus;
use crate::validity::{Contact, Validity};

/// The space of a body's placements: all at which it could lie within the bounds.
///
/// # Panics
/// Where `N` is less than 3.
pub fn placements<const N: usize>(shape: &Polygon, weights: Weights, bounds: &Aabb) -> Torus<N> {
    // An origin outside the shape may lie outside the bounds too, by no more than the shape reaches.
    let sides = if shape.contains(Point::origin()) { *bounds } else { bounds.grown(shape.reach()) };
    let Weights { translation, rotation } = weights;
    Torus::of_placements([sides.min.x, sides.min.y], [sides.max.x, sides.max.y], translation, rotation)
}

/// What is free for a body among obstacles. Motions are straight in x, y and theta, the short way round.
pub struct BodyValidity<const N: usize> {
    space: Torus<N>,
    collision: BodyCollision,
}

impl<const N: usize> BodyValidity<N> {
    /// The body in the world; `tolerance` is the wanted tolerance as a fraction of the longer side of the bounds, greater than 0.
    pub fn new(shape: &Polygon, space: Torus<N>, world: &World, tolerance: f64) -> Self {
        Self { space, collision: BodyCollision::new(shape, world, tolerance) }
    }

    /// The same with a tolerance no coarser than half the clearance of either placement.
    #[must_use]
    pub fn fitted(self, start: &[f64; N], goal: &[f64; N]) -> Self {
        let collision = self.collision.fitted(&placement(start), &placement(goal));
        Self { collision, ..self }
    }

    /// The same with the finest tolerance there is.
    #[must_use]
    pub fn finest(self) -> Self {
        Self { collision: self.collision.finest(), ..self }
    }

    /// The motion from `a` to `b`; `None` where the short way round is ambiguous.
    fn motion(&self, a: &[f64; N], b: &[f64; N]) -> Option<BodyMotion> {
        let delta = placement(&self.space.difference(a, b));
        (delta[2].abs() < LONGEST_TURN).then(|| BodyMotion::Straight { from: placement(a), delta })
    }
}

/// The three numbers of a padded state.
fn placement<const N: usize>(state: &[f64; N]) -> [f64; 3] {
    [state[0], state[1], state[2]]
}

impl<const N: usize> Validity<[f64; N]> for BodyValidity<N> {
    fn is_free(&self, q: &[f64; N]) -> bool {
        self.collision.is_free(&placement(q))
    }

    fn is_motion_free(&self, a: &[f64; N], b: &[f64; N]) -> bool {
        self.motion(a, b).is_some_and(|motion| self.collision.is_motion_free(&motion))
    }

    fn first_hit(&self, a: &[f64; N], b: &[f64; N]) -> Option<f64> {
        self.motion(a, b).map_or(Some(0.0), |motion| self.collision.first_hit(&motion))
    }

    fn contacts(&self, q: &[f64; N]) -> Vec<Contact> {
        self.collision.contacts(&placement(q))
    }

    fn clearance_evaluations(&self) -> u64 {
        self.collision.clearance_evaluations()
    }
}
