//! The collision checker of a robot in one of its spaces, before it is passed to a planner.

use crate::collision::{
    ArmValidity, BodyCollision, BodyValidity, CarDynamics, CollisionWorld, DiscValidity, Integration, KeepAway,
    Tolerance,
};
use crate::geometry::Aabb;
use crate::problem::{Dynamics, Validity};
use crate::scenario::Robot;
use crate::space::MotionSpace;
use std::sync::Arc;

/// Validity and, of a car, dynamics.
type Checked<S> = (Box<dyn Validity<S>>, Option<Box<dyn Dynamics<S>>>);

/// Whether the robot may touch something in one of the boxes on the motion between two states.
type MayMeet<const N: usize> = Box<dyn Fn(&[f64; N], &[f64; N], &[Aabb]) -> bool>;

/// The collision checker of a robot.
#[allow(clippy::large_enum_variant, reason = "it is moved once, into the box of `validity`")]
pub(crate) enum Checker<const N: usize> {
    Arm(ArmValidity<N>),
    Disc(DiscValidity),
    /// A rigid body or a car, and the space of its motions.
    Body(BodyCollision, MotionSpace<N>),
}

impl<const N: usize> Checker<N> {
    pub(super) fn new(robot: &Robot, space: &MotionSpace<N>, world: &CollisionWorld, tolerance: f64) -> Self {
        let body = |shape, name| {
            let collision = BodyCollision::with_margin(shape, robot.margin(), world.clone(), tolerance);
            Self::Body(collision.named(name), space.clone())
        };
        match robot {
            Robot::Arm(arm) => Self::Arm(ArmValidity::new(arm, space.product().clone(), world.clone(), tolerance)),
            Robot::Disc(disc) => Self::Disc(DiscValidity::new(disc, world.clone())),
            Robot::RigidBody(rigid) => body(&rigid.shape, "the body"),
            Robot::Car(car) => body(car.shape(), "the car"),
        }
    }

    /// The same, whose motions cost more near obstacles if it is a disc.
    #[must_use]
    pub(crate) fn keeping_away(self, keep_away: Option<KeepAway>) -> Self {
        match self {
            Self::Disc(disc) => Self::Disc(disc.keeping_away(keep_away)),
            other => other,
        }
    }

    /// The same with a tolerance no coarser than half the clearance of either configuration, so that motions can start and end
    /// there.
    #[must_use]
    pub(crate) fn fitted(self, start: &[f64; N], goal: &[f64; N]) -> Self {
        match self {
            Self::Arm(arm) => Self::Arm(arm.fitted(start, goal)),
            Self::Disc(disc) => Self::Disc(disc),
            Self::Body(body, space) => {
                let [start, goal] = [start, goal].map(|q| [q[0], q[1], q[2]]);
                Self::Body(body.fitted(&start, &goal), space)
            }
        }
    }

    /// The same with the finest tolerance: it proves whatever is proven with a coarser one.
    #[must_use]
    pub(crate) fn finest(self) -> Self {
        match self {
            Self::Arm(arm) => Self::Arm(arm.finest()),
            Self::Disc(disc) => Self::Disc(disc),
            Self::Body(body, space) => Self::Body(body.finest(), space),
        }
    }

    /// Whether the robot may touch something in one of some boxes on the motion between two states.
    pub(crate) fn may_meet(self) -> MayMeet<N> {
        match self {
            Self::Arm(arm) => Box::new(move |a, b, boxes| arm.may_meet(a, b, boxes)),
            Self::Disc(disc) => Box::new(move |a, b, boxes| disc.may_meet(a, b, boxes)),
            Self::Body(body, space) => {
                let body = BodyValidity::new(space, Arc::new(body));
                Box::new(move |a, b, boxes| body.may_meet(a, b, boxes))
            }
        }
    }

    /// The slack and the tolerance of its proofs.
    pub(crate) fn tolerance(&self) -> Tolerance {
        match self {
            Self::Arm(arm) => arm.tolerance(),
            Self::Disc(disc) => disc.tolerance(),
            Self::Body(body, _) => body.tolerance(),
        }
    }

    /// The checker as planners see it.
    pub(crate) fn validity(self) -> Box<dyn Validity<[f64; N]>> {
        match self {
            Self::Arm(arm) => Box::new(arm),
            Self::Disc(disc) => Box::new(disc),
            Self::Body(body, space) => Box::new(BodyValidity::new(space, Arc::new(body))),
        }
    }

    /// The checker and, of a car, its dynamics among the same obstacles: the work of both is counted together.
    pub(crate) fn with_dynamics(self, robot: &Robot, integration: Integration) -> Checked<[f64; N]> {
        match (self, robot) {
            (Self::Body(body, space), Robot::Car(car)) => {
                let body = Arc::new(body);
                let dynamics = CarDynamics::new(car, space.clone(), Arc::clone(&body), integration);
                (Box::new(BodyValidity::new(space, body)), Some(Box::new(dynamics)))
            }
            (other, _) => (other.validity(), None),
        }
    }
}
