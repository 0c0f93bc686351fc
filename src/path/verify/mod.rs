//! The independent judge of finished paths.
//!
//! A planner proves its edges by clearances and bounds on motion. The judge goes another way: it looks at the robot at many
//! places along every edge, at most a thousandth of the world's size of motion apart, and between two looks it takes the
//! whole region that each link can have swept: the convex hull of its two places, grown by how far the ends can leave
//! their chords. Where that region comes near an obstacle, it looks again in between. So nothing is missed between two
//! looks, however thin it is.
//!
//! **Promise.** Let S be the largest coordinate of the world plus the robot's reach. A path is called valid only if the
//! robot keeps more than 1e-13 S away from every obstacle all along it, rounding included; so touching is collision. A
//! point among polygons is judged exactly. A path that keeps more than 1e-12 S away is never refused for collision, unless
//! it stays so near for so long that ten million looks do not settle it. Bounds may be touched, and overstepped by no
//! more than 2e-12 S; joint limits not at all.

mod arm;
mod disc;
mod near;
mod swept;

use crate::error::{Code, Error};
use crate::geometry::Aabb;
use crate::result::ResultDocument;
use crate::scenario::{Obstacle, Query, Robot, Scenario, World};
use crate::status::Status;
use std::f64::consts::{PI, TAU};

/// How near the first and the last waypoint must be to the start and the goal, in radians or metres a coordinate.
const REACHED: f64 = 1e-9;

/// How far from half a turn a step of a circle joint must stay, in radians: nearer, the short way round is ambiguous.
const AMBIGUOUS: f64 = 1e-9;

/// How far the told length may differ from the measured one, relative to it.
const LENGTH: f64 = 1e-9;

/// What the judge says.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// The path leads from the start to the goal of its query, clear of everything.
    Valid {
        /// How many waypoints the path has.
        waypoints: usize,
        /// How many times the judge looked at the robot; for a disc, swept segments.
        looks: u64,
        /// The smallest distance to an obstacle that was seen, in metres; infinite without obstacles. For a disc it is
        /// the true one; for an arm the true one is smaller by no more than half the motion between two looks.
        clearance: f64,
    },
    /// The path is refused.
    Invalid {
        /// Why, naming waypoint or edge, link and obstacle, all counted from 0.
        why: String,
    },
}

/// What has been seen so far.
struct Seen {
    looks: u64,
    clearance: f64,
}

/// The lengths that a judgement rests on, in metres.
struct Scale {
    /// At this distance or less the robot touches an obstacle.
    slack: f64,
    /// How far the robot may leave the bounds.
    overstep: f64,
    /// The largest motion between two looks.
    spacing: f64,
}

/// Judges a result against its scenario.
///
/// # Errors
/// `invalid-result` (pointer `/scenario`) where the result belongs to another scenario, `unknown-query` (pointer `/query`)
/// where the scenario has no query of that name. Everything else that is wrong is a [`Verdict::Invalid`].
///
/// # Complexity
/// For each edge, its motion divided by a thousandth of the world's size, times links, times what is near.
pub fn verify(scenario: &Scenario, result: &ResultDocument) -> Result<Verdict, Error> {
    if result.scenario != scenario.name() {
        let sentence = format!("the result belongs to scenario {:?}, not to {:?}", result.scenario, scenario.name());
        return Err(Error::new(Code::InvalidResult, "/scenario", sentence));
    }
    let query = scenario.queries().iter().find(|query| query.name == result.query).ok_or_else(|| {
        Error::new(Code::UnknownQuery, "/query", format!("the scenario has no query {:?}", result.query))
    })?;
    Ok(match judge(scenario, query, result) {
        Ok(Seen { looks, clearance }) => Verdict::Valid { waypoints: result.path.len(), looks, clearance },
        Err(why) => Verdict::Invalid { why },
    })
}

/// All that must hold, in the order in which a person would ask.
fn judge(scenario: &Scenario, query: &Query, result: &ResultDocument) -> Result<Seen, String> {
    let (robot, path) = (scenario.robot(), &result.path);
    if result.status != Status::Solved {
        return Err(format!("the status is {}: there is no path to judge", result.status.as_str()));
    }
    check_numbers(robot.dimension(), path)?;
    let circles = has_circles(robot);
    for (what, waypoint, wanted) in [("start", &path[0], &query.start), ("goal", &path[path.len() - 1], &query.goal)] {
        let far = difference(circles, wanted, waypoint).into_iter().position(|gap| f64::abs(gap) > REACHED);
        if let Some(i) = far {
            let verb = if what == "start" { "starts" } else { "ends" };
            return Err(format!("the path {verb} at {waypoint:?}, not at the {what} {wanted:?} (coordinate {i})"));
        }
    }
    if circles {
        check_steps(path)?;
    }
    let scale = Scale::of(scenario.world(), robot);
    let seen = match robot {
        Robot::Arm(arm) => arm::judge(scenario.world(), arm, path, &scale)?,
        Robot::Disc(disc) => disc::judge(scenario.world(), disc, path, &scale)?,
        Robot::RigidBody(_) | Robot::Car(_) => unimplemented!("bodies are on their way"),
    };
    check_length(robot, path, result.length)?;
    Ok(seen)
}

/// Refuses an empty path and waypoints that are not `dimension` finite numbers.
fn check_numbers(dimension: usize, path: &[Vec<f64>]) -> Result<(), String> {
    if path.is_empty() {
        return Err("the path is empty".into());
    }
    for (i, waypoint) in path.iter().enumerate() {
        if waypoint.len() != dimension {
            return Err(format!("waypoint {i} has {} numbers, a configuration has {dimension}", waypoint.len()));
        }
        if let Some(value) = waypoint.iter().find(|value| !value.is_finite()) {
            return Err(format!("waypoint {i} holds {value}"));
        }
    }
    Ok(())
}

/// Refuses steps that turn a circle joint by half a turn: there is no short way round.
fn check_steps(path: &[Vec<f64>]) -> Result<(), String> {
    for (edge, ends) in path.windows(2).enumerate() {
        let turns = difference(true, &ends[0], &ends[1]);
        if let Some(joint) = turns.iter().position(|turn| turn.abs() >= PI - AMBIGUOUS) {
            let turn = turns[joint].abs();
            return Err(format!("edge {edge} turns joint {joint} by {turn} rad: the short way round is ambiguous"));
        }
    }
    Ok(())
}

/// Refuses a told length that is not the sum of the steps, by either metric of an arm.
fn check_length(robot: &Robot, path: &[Vec<f64>], told: f64) -> Result<(), String> {
    let (mut sum, mut euclidean) = (0.0, 0.0);
    for ends in path.windows(2) {
        let step = difference(has_circles(robot), &ends[0], &ends[1]);
        sum += step.iter().map(|d| d.abs()).sum::<f64>();
        euclidean += step.iter().map(|d| d * d).sum::<f64>().sqrt();
    }
    let largest = path.iter().flatten().fold(1.0, |largest: f64, value| largest.max(value.abs()));
    let is_told = |measured: f64| f64::abs(told - measured) <= LENGTH * measured + 1e-12 * largest;
    match robot {
        Robot::Arm(_) if !is_told(sum) && !is_told(euclidean) => Err(format!(
            "the length is told as {told}, but the path measures {sum} (sum of the joints) or {euclidean} (Euclidean)"
        )),
        Robot::Disc(_) if !is_told(euclidean) => {
            Err(format!("the length is told as {told}, but the path measures {euclidean}"))
        }
        _ => Ok(()),
    }
}

/// Whether the joints of the robot are circles.
fn has_circles(robot: &Robot) -> bool {
    matches!(robot, Robot::Arm(arm) if arm.joint_limits().is_none())
}

/// The step from `a` to `b`, angles the short way round where they are circles. The double nearest to 2 pi stands for a
/// turn: off by less than an angle's own rounding.
fn difference(circles: bool, a: &[f64], b: &[f64]) -> Vec<f64> {
    let step = |(&a, &b): (&f64, &f64)| {
        if circles { libm::remainder(libm::remainder(b, TAU) - libm::remainder(a, TAU), TAU) } else { b - a }
    };
    a.iter().zip(b).map(step).collect()
}

impl Scale {
    /// The lengths for a robot in a world.
    fn of(world: &World, robot: &Robot) -> Self {
        let mut boxes: Vec<Aabb> = world.obstacles.iter().map(Obstacle::aabb).chain(world.bounds).collect();
        let reach = match robot {
            Robot::Arm(arm) => {
                boxes.push(Aabb { min: arm.base(), max: arm.base() });
                arm.reach() + arm.radius()
            }
            Robot::Disc(disc) => disc.radius(),
            Robot::RigidBody(_) | Robot::Car(_) => robot.placed_shape().expect("both are placed").0.reach(),
        };
        let coordinates = boxes.iter().flat_map(|b| [b.min.x, b.min.y, b.max.x, b.max.y]);
        let largest = coordinates.fold(0.0, |largest: f64, coordinate| largest.max(coordinate.abs())) + reach;
        let side = world.bounds.map_or(f64::INFINITY, |bounds| bounds.longer_side());
        let size = if reach > 0.0 { side.min(2.0 * reach) } else { side };
        Self { slack: 1e-13 * largest, overstep: 2e-12 * largest, spacing: 1e-3 * size }
    }
}
