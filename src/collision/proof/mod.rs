//! The proof that a motion of an arm or of a body is free.
//!
//! In the middle of a stretch of motion it is known where the links are, and a bound on how far they can travel to either
//! end. Where a link is farther from an obstacle than it can travel, the two are apart on the whole stretch; otherwise the
//! stretch is halved and looked at again. (Schwarzer, Saha and Latombe 2005, "Adaptive dynamic collision checking for
//! single and multiple articulated robots in complex environments"; LaValle 2006, "Planning Algorithms", section 5.3.4.)
//!
//! [`distance`] and [`body_distance`] are that idea in its simplest form and the oracles of the tests; [`separation`] and
//! [`body_separation`] are the ones that planners use.

pub(super) mod body_distance;
mod body_pair;
pub(super) mod body_separation;
mod body_shape;
mod course;
pub(super) mod distance;
mod joint;
mod pair;
mod rotation;
pub(super) mod separation;

pub(super) use body_shape::BodyShape;
pub(super) use joint::MovingJoint;
pub(super) use pair::{Answer, Link};
pub(super) use rotation::unit;

use super::{Obstacles, Tolerance};
use crate::geometry::{Aabb, Polygon};
use crate::robot::Arm;

/// An arm in its world, as a proof sees it.
#[derive(Clone, Copy)]
pub(super) struct Setting<'a> {
    pub arm: &'a Arm,
    pub obstacles: &'a Obstacles,
    pub bounds: Option<&'a Aabb>,
    pub tolerance: Tolerance,
}

/// A body in its world, as a proof sees it.
#[derive(Clone, Copy)]
pub(super) struct BodySetting<'a> {
    pub body: &'a Polygon,
    /// The body's convex pieces.
    pub shape: &'a BodyShape,
    /// The obstacles' convex pieces.
    pub obstacles: &'a Obstacles,
    /// The obstacles as they are.
    pub whole: &'a Obstacles,
    pub bounds: &'a Aabb,
    pub tolerance: Tolerance,
}

/// A motion: from a configuration, every joint turning at a constant rate by `delta` radians in all. Entries past the
/// arm's links are 0.
#[derive(Clone, Copy)]
pub(super) struct Motion<'a, const N: usize> {
    pub from: &'a [f64; N],
    pub delta: &'a [f64; N],
}
