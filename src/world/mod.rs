//! A scenario prepared for planning: from the robot to its configuration space and its collision checker.
//!
//! Runs, viewers' queries, inverse kinematics, nearest neighbours and driving all start here. Each accepts a
//! `&`[`Scenario`], which is then prepared for that one use, or a `&`[`PlanningWorld`], which is
//! prepared once and shared.

mod checker;
mod configurations;

pub(crate) use checker::Checker;
pub(crate) use configurations::Configurations;

use crate::collision::{BodyCollision, CollisionWorld};
use crate::error::{Code, Error};
use crate::geometry::{Aabb, Polygon};
use crate::robot::{joint_space, placements, plane};
use crate::scenario::{Robot, Scenario};
use crate::space::{Metric, MetricKind, MotionSpace, ProductSpace};
use std::fmt;
use std::ops::Deref;
use std::sync::{Arc, OnceLock};

/// The smaller size of states: most robots have no more coordinates. Entries past the dimension are 0 and change no bit.
pub(crate) const SMALL: usize = 4;

/// A scenario and its obstacles prepared for collision queries. Cheap to clone: clones share all of it.
///
/// ```
/// use planarium::run::{self, Options, inspect::Inspector};
/// use planarium::{PlanningWorld, scenario::Scenario};
///
/// let world = PlanningWorld::new(Scenario::parse(
///     r#"{ "format": "planarium-scenario-1", "name": "post",
///          "world": { "bounds": { "min": [0, 0], "max": [4, 4] },
///                     "obstacles": [ { "type": "disc", "center": [2, 2], "radius": 0.5 } ] },
///          "robot": { "type": "disc", "radius": 0.2 },
///          "queries": [ { "name": "across", "start": [1, 1], "goal": [3, 3] } ] }"#,
/// )?);
/// let mut run = run::start(&world, Options::default())?;
/// run.step(100_000);
/// let inspector = Inspector::new(&world);
/// assert!(run.path().iter().all(|q| inspector.check(q).is_ok_and(|contacts| contacts.is_empty())));
/// # Ok::<(), planarium::Error>(())
/// ```
#[derive(Clone)]
pub struct PlanningWorld(Arc<Prepared>);

struct Prepared {
    scenario: Scenario,
    /// Prepared on first use.
    collision: OnceLock<CollisionWorld>,
}

impl PlanningWorld {
    /// Prepares the scenario; its obstacles on the first query that needs them, in O(n log n).
    pub fn new(scenario: Scenario) -> Self {
        Self(Arc::new(Prepared { scenario, collision: OnceLock::new() }))
    }

    /// A scenario whose obstacles and bounds are prepared already.
    pub(crate) fn sharing(scenario: Scenario, collision: &CollisionWorld) -> Self {
        Self(Arc::new(Prepared { scenario, collision: OnceLock::from(collision.clone()) }))
    }

    /// The scenario.
    pub fn scenario(&self) -> &Scenario {
        &self.0.scenario
    }

    /// The robot.
    pub(crate) fn robot(&self) -> &Robot {
        self.scenario().robot()
    }

    /// The world's bounds.
    ///
    /// # Panics
    /// If there are none, which a scenario allows for an arm only.
    pub(crate) fn bounds(&self) -> &Aabb {
        self.scenario().world().bounds.as_ref().expect("only an arm does without bounds")
    }

    /// In a sentence, why samples are hardly ever free although free configurations exist: a disc that fills its world from side
    /// to side can move on a line only. `None` for any other robot, and where the disc has a billionth of the width to spare.
    pub fn without_width(&self) -> Option<String> {
        let Robot::Disc(disc) = self.robot() else { return None };
        let Aabb { min, max } = self.bounds();
        let fills = |low: f64, high: f64| high - low - 2.0 * disc.kept_radius() <= 1e-9 * (high - low);
        let (axis, other) = match [fills(min.x, max.x), fills(min.y, max.y)] {
            [false, false] => return None,
            [true, true] => {
                return Some(
                    "the disc fills the world: it cannot move, and random samples are hardly ever free".to_owned(),
                );
            }
            [true, false] => ("x", "y"),
            [false, true] => ("y", "x"),
        };
        Some(format!(
            "the disc fills the world along {axis}: random samples are hardly ever free, and a path can only be a straight motion along {other}"
        ))
    }

    /// The obstacles and bounds, prepared.
    pub(crate) fn collision(&self) -> &CollisionWorld {
        self.0.collision.get_or_init(|| CollisionWorld::from(self.scenario().world()))
    }

    /// The robot's space with the named metric: `sum`, `euclidean` or `naive` for an arm, `sum` if none is named. A disc,
    /// a body and a car have one metric of their own.
    ///
    /// # Errors
    /// `out-of-range` (pointer `/metric`) for another metric of a robot that has one of its own.
    ///
    /// # Panics
    /// If a configuration has more than `N` numbers.
    pub(crate) fn space<const N: usize>(&self, metric: Option<MetricKind>) -> Result<ProductSpace<N>, Error> {
        let refuse = |sentence: String| Err(Error::new(Code::OutOfRange, "/metric", sentence));
        Ok(match (self.robot(), metric) {
            (Robot::RigidBody(_) | Robot::Car(_), Some(kind)) => {
                let word: &str = kind.into();
                return refuse(format!("the metric of a body is its scenario's, not \"{word}\""));
            }
            (Robot::Disc(_), Some(kind @ (MetricKind::Sum | MetricKind::Naive))) => {
                let word: &str = kind.into();
                return refuse(format!("the metric of a disc is always euclidean, not \"{word}\""));
            }
            (Robot::Arm(arm), Some(MetricKind::Euclidean)) => joint_space(arm, Metric::Euclidean),
            (Robot::Arm(arm), Some(MetricKind::Naive)) => joint_space(arm, Metric::Euclidean).cut_open(),
            (Robot::Arm(_), None | Some(MetricKind::Sum))
            | (Robot::Disc(_), None | Some(MetricKind::Euclidean))
            | (Robot::RigidBody(_) | Robot::Car(_), None) => self.default_space(),
        })
    }

    /// The robot's space with its default metric.
    ///
    /// # Panics
    /// If a configuration has more than `N` numbers.
    pub(crate) fn default_space<const N: usize>(&self) -> ProductSpace<N> {
        match self.robot() {
            Robot::Arm(arm) => joint_space(arm, Metric::Sum),
            Robot::Disc(_) => plane(self.bounds()),
            Robot::RigidBody(body) => placements(&body.shape, body.weights, self.bounds()),
            Robot::Car(car) => placements(car.shape(), car.weights(), self.bounds()),
        }
    }

    /// The collision checker of the robot in one of its spaces; `tolerance` is the wanted tolerance as a fraction of the
    /// longer side of the bounds (of twice an arm's reach if there are none), greater than 0.
    pub(crate) fn checker<const N: usize>(&self, space: &MotionSpace<N>, tolerance: f64) -> Checker<N> {
        Checker::new(self.robot(), space, self.collision(), tolerance)
    }

    /// The collision checker of a body of this shape, with the margin of the robot and such a tolerance.
    pub(crate) fn body(&self, shape: &Polygon, tolerance: f64) -> BodyCollision {
        BodyCollision::with_margin(shape, self.robot().margin(), self.collision().clone(), tolerance)
    }
}

/// What is prepared of a document beside its content: equal contents have equal ones, so it is not compared, nor shown.
#[derive(Clone)]
pub(crate) struct Derived<T>(pub T);

impl<T> Deref for Derived<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.0
    }
}

impl<T> PartialEq for Derived<T> {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl<T> fmt::Debug for Derived<T> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("..")
    }
}

impl From<Scenario> for PlanningWorld {
    fn from(scenario: Scenario) -> Self {
        Self::new(scenario)
    }
}

impl From<&Scenario> for PlanningWorld {
    fn from(scenario: &Scenario) -> Self {
        Self::new(scenario.clone())
    }
}

impl From<&PlanningWorld> for PlanningWorld {
    fn from(world: &PlanningWorld) -> Self {
        world.clone()
    }
}
