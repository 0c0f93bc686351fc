//! The collision checker of a body over the space of its placements (x, y, theta).

use super::{BodyCollision, BodyMotion, LONGEST_TURN, blend};
use crate::geometry::Aabb;
use crate::problem::{Contact, Validity};
use crate::space::steering::{Curve, wrap};
use crate::space::{MotionSpace, Space};
use std::sync::Arc;

/// The collision checker of a body in a space of placements (x, y, theta), in which motions are straight or the curves of
/// a car.
pub struct BodyValidity<const N: usize> {
    space: MotionSpace<N>,
    collision: Arc<BodyCollision>,
}

impl<const N: usize> BodyValidity<N> {
    /// The body in that space. The collision may be shared with the dynamics of the body: all its work is counted here.
    pub fn new(space: MotionSpace<N>, collision: Arc<BodyCollision>) -> Self {
        Self { space, collision }
    }

    /// Whether the body may touch something in one of the boxes on the motion from `a` to `b`.
    pub fn may_meet(&self, a: &[f64; N], b: &[f64; N], boxes: &[Aabb]) -> bool {
        match self.curve(a, b) {
            None => self.straight(a, b).is_none_or(|motion| self.collision.may_meet(&motion, boxes)),
            Some(curve) => arcs(placement(a), &curve).any(|arc| self.collision.may_meet(&arc, boxes)),
        }
    }

    /// The curve between two states; `None` if the motion is straight, as it is between states that differ by rounding only.
    fn curve(&self, a: &[f64; N], b: &[f64; N]) -> Option<Curve> {
        self.space.curve(a, b).filter(|curve| !curve.segments().is_empty())
    }

    /// Whether a curve that ends at `end` reaches the state: the difference by rounding may be half the slack at most,
    /// also if the curve is driven back. With a turning circle far wider than the world it may be more.
    fn is_reached(&self, end: [f64; 3], state: &[f64; N]) -> bool {
        let mut reached = [0.0; N];
        (reached[0], reached[1], reached[2]) = (end[0], end[1], wrap(end[2]));
        let [x, y, turn] = placement(&self.space.product().difference(&reached, state)).map(f64::abs);
        x + y + 4.0 * self.collision.scale * turn <= 0.5 * self.collision.scene.tolerance.eta
    }

    /// The straight motion; `None` if the short way round is ambiguous.
    fn straight(&self, a: &[f64; N], b: &[f64; N]) -> Option<BodyMotion> {
        let delta = placement(&self.space.product().difference(a, b));
        (delta[2].abs() < LONGEST_TURN).then_some(BodyMotion::Straight { from: placement(a), delta })
    }
}

/// The arcs of the curve driven from a placement at a metre a second.
fn arcs(from: [f64; 3], curve: &Curve) -> impl Iterator<Item = BodyMotion> {
    curve.segments().iter().scan(from, move |from, segment| {
        let speed = libm::copysign(1.0, segment.length);
        let turn_rate = speed * curve.curvature(segment.turn);
        let arc = BodyMotion::Arc { from: *from, speed, turn_rate, duration: segment.length.abs() };
        *from = arc.at(1.0);
        Some(arc)
    })
}

/// The placement of a state, whose other entries are zero.
pub(super) fn placement<const N: usize>(state: &[f64; N]) -> [f64; 3] {
    [state[0], state[1], state[2]]
}

impl<const N: usize> Validity<[f64; N]> for BodyValidity<N> {
    fn is_free(&self, state: &[f64; N]) -> bool {
        self.collision.is_free(&placement(state))
    }

    fn is_motion_free(&self, a: &[f64; N], b: &[f64; N]) -> bool {
        let Some(curve) = self.curve(a, b) else {
            return self.straight(a, b).is_some_and(|motion| self.collision.is_motion_free(&motion));
        };
        let mut end = placement(a);
        arcs(end, &curve).all(|arc| {
            end = arc.at(1.0);
            self.collision.is_motion_free(&arc)
        }) && self.is_reached(end, b)
    }

    fn first_hit(&self, a: &[f64; N], b: &[f64; N]) -> Option<f64> {
        let Some(curve) = self.curve(a, b) else {
            return self.straight(a, b).map_or(Some(0.0), |motion| self.collision.first_hit(&motion));
        };
        if !arcs(placement(a), &curve).last().is_some_and(|arc| self.is_reached(arc.at(1.0), b)) {
            return Some(0.0);
        }
        let mut before = 0.0;
        for (arc, segment) in arcs(placement(a), &curve).zip(curve.segments()) {
            let length = segment.length.abs();
            if let Some(hit) = self.collision.first_hit(&arc) {
                return Some(((before + hit * length) / curve.length()).min(1.0));
            }
            before += length;
        }
        None
    }

    fn is_blend_free(&self, [from, corner, to]: &[[f64; N]; 3]) -> bool {
        let product = self.space.product();
        let [corner, before, after] =
            [corner, &product.difference(corner, from), &product.difference(corner, to)].map(placement);
        self.space.steering().is_none()
            && blend::is_free(&corner, &before, &after, |&from, &delta, &aside| {
                self.collision.is_band_free(&BodyMotion::Straight { from, delta }, aside)
            })
    }

    fn contacts(&self, state: &[f64; N]) -> Vec<Contact> {
        self.collision.contacts(&placement(state))
    }

    fn part_name(&self, _part: usize) -> String {
        self.collision.name.into()
    }

    fn clearance_evaluations(&self) -> u64 {
        self.collision.clearance_evaluations()
    }

    fn unproven_motions(&self) -> u64 {
        self.collision.unproven_motions()
    }
}
