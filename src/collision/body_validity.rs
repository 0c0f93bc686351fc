//! What is free for a body that is placed by (x, y, theta), over the space of its placements.

use super::{BodyCollision, BodyMotion, LONGEST_TURN};
use crate::geometry::{Aabb, Point, Polygon};
use crate::robot::Weights;
use crate::space::Torus;
use crate::validity::{Contact, Validity};
use std::rc::Rc;

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

/// What is free for a body, in a space of placements (x, y, theta) in which motions are straight.
pub struct BodyValidity<const N: usize> {
    space: Torus<N>,
    collision: Rc<BodyCollision>,
}

impl<const N: usize> BodyValidity<N> {
    /// The body in that space. The collision may be shared with what drives the body: its work is counted here.
    pub fn new(space: Torus<N>, collision: Rc<BodyCollision>) -> Self {
        Self { space, collision }
    }

    /// The straight motion; `None` where the short way round is ambiguous.
    fn motion(&self, a: &[f64; N], b: &[f64; N]) -> Option<BodyMotion> {
        let delta = placement(&self.space.difference(a, b));
        (delta[2].abs() < LONGEST_TURN).then_some(BodyMotion::Straight { from: placement(a), delta })
    }
}

/// The placement that a state is; in what follows there are zeros.
pub(super) fn placement<const N: usize>(state: &[f64; N]) -> [f64; 3] {
    [state[0], state[1], state[2]]
}

impl<const N: usize> Validity<[f64; N]> for BodyValidity<N> {
    fn is_free(&self, state: &[f64; N]) -> bool {
        self.collision.is_free(&placement(state))
    }

    fn is_motion_free(&self, a: &[f64; N], b: &[f64; N]) -> bool {
        self.motion(a, b).is_some_and(|motion| self.collision.is_motion_free(&motion))
    }

    fn first_hit(&self, a: &[f64; N], b: &[f64; N]) -> Option<f64> {
        self.motion(a, b).map_or(Some(0.0), |motion| self.collision.first_hit(&motion))
    }

    fn contacts(&self, state: &[f64; N]) -> Vec<Contact> {
        self.collision.contacts(&placement(state))
    }

    fn clearance_evaluations(&self) -> u64 {
        self.collision.clearance_evaluations()
    }
}
