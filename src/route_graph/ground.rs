//! Where the robot can turn on the spot, and which straight ways it can take between such places.

use crate::collision::{BodyCollision, BodyMotion, DiscValidity};
use crate::error::{Code, Error};
use crate::geometry::Aabb;
use crate::problem::Validity;
use crate::robot::{DiscRobot, plane};
use crate::scenario::Robot;
use crate::space::{MotionSpace, Space};
use crate::world::{PlanningWorld, SMALL};

/// A place, x and y in metres; further entries are 0.
pub(super) type State = [f64; SMALL];

/// The tolerance of the proofs of a footprint, as a fraction of the world's longer side: that of runs.
const TOLERANCE: f64 = 1e-4;

/// The free places and ways of a robot.
///
/// A disc is free at a place if it touches nothing there. A footprint is free there if the disc about its reference point that
/// contains it at every heading is. A footprint drives forward, so that its heading is that of the way.
pub(super) struct Ground {
    pub space: MotionSpace<SMALL>,
    bounds: Aabb,
    radius: f64,
    standing: DiscValidity,
    /// Of a robot that is no disc.
    driven: Option<BodyCollision>,
}

impl Ground {
    /// # Errors
    /// `unsupported` (pointer `/robot/type`) for an arm, which is at no place, and for a car, which cannot turn on the spot.
    pub fn new(world: &PlanningWorld) -> Result<Self, Error> {
        let disc = match world.robot() {
            Robot::Disc(disc) => disc.clone(),
            Robot::RigidBody(body) => DiscRobot::new(body.shape.reach())?.with_margin(body.margin())?,
            Robot::Arm(_) => return Err(refusal("an arm is at no place")),
            Robot::Car(_) => return Err(refusal("a car cannot turn on the spot")),
        };
        let driven = match world.robot() {
            Robot::RigidBody(body) => Some(world.body(&body.shape, TOLERANCE)),
            _ => None,
        };
        Ok(Self {
            space: MotionSpace::new(plane(world.bounds())),
            bounds: *world.bounds(),
            radius: disc.kept_radius(),
            standing: DiscValidity::new(&disc, world.collision().clone()),
            driven,
        })
    }

    /// The bounds of the world.
    pub fn bounds(&self) -> &Aabb {
        &self.bounds
    }

    /// The radius of the disc that is free at every place, with the margin, in metres.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Whether the robot can turn on the spot.
    pub fn is_place_free(&self, at: &State) -> bool {
        self.standing.is_free(at)
    }

    /// Whether the robot is proven free on the way between two free places, in both directions: as the disc that it turns in,
    /// or else as a footprint that drives forward.
    pub fn is_way_free(&self, a: &State, b: &State) -> bool {
        if self.standing.is_motion_free(a, b) {
            return true;
        }
        let Some(body) = &self.driven else { return false };
        let drives = |a: &State, b: &State| {
            let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
            let from = [a[0], a[1], libm::atan2(dy, dx)];
            body.is_motion_free(&BodyMotion::Straight { from, delta: [dx, dy, 0.0] })
        };
        drives(a, b) && drives(b, a)
    }

    /// The distance of two places, in metres.
    pub fn distance(&self, a: &State, b: &State) -> f64 {
        self.space.distance(a, b)
    }
}

fn refusal(why: &str) -> Error {
    let sentence = format!("a route graph is for discs and rigid bodies: {why}");
    Error::new(Code::Unsupported, "/robot/type", sentence)
}
