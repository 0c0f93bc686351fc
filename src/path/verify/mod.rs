//! The independent verifier of finished paths.
//!
//! A planner proves its edges by clearances and bounds on motion. The verifier uses another method: it examines the robot at
//! many samples along every edge, at most a thousandth of the world's size of motion apart (of the robot's, if that is
//! smaller, but a hundred-thousandth of the world's at least). Between two samples it takes the whole region that each
//! link of an arm, or each edge of a body's outline, can have swept: the convex hull of its two positions, grown by how
//! far the ends can leave their chords. If that region comes near an obstacle, it takes another sample in between. So
//! nothing is missed between two samples, however thin it is.
//!
//! **Promise.** Let S be the largest coordinate of the world plus the robot's reach. A path is called valid only if the
//! robot keeps more than 1e-13 S away from every obstacle all along it, rounding included; so touching is collision. A
//! point among polygons is checked exactly. A path that keeps more than 1e-12 S away is never refused for collision,
//! unless it stays so near for so long that ten million samples do not decide. Bounds may be touched, and overstepped by
//! no more than 2e-12 S; joint limits not at all.

mod arm;
mod blend;
mod body;
mod car;
mod disc;
mod moving;
mod near;

pub use body::Leg;

use self::blend::{Norm, Quadratic};
use self::moving::Stretch;
use crate::error::{Code, Error};
use crate::geometry::{Aabb, Point, Polygon};
use crate::path::{LengthMeasure, ResultDocument};
use crate::problem::Status;
use crate::robot::{Joint, LARGEST, Target};
use crate::scenario::{Goal, GoalTolerance, Obstacle, Query, Robot, Scenario, World};
use std::f64::consts::{PI, TAU};

/// How near the first and the last waypoint must be to the start and the goal, in radians or metres per coordinate.
const REACHED: f64 = 1e-9;

/// How near the end effector must be to its target, as a fraction of the arm's reach, if that is less than [`REACHED`]; and
/// the largest effect of rounding on that, as a fraction of all lengths, and of many turns of a wanted orientation.
const AIMED: f64 = 1e-6;
const ROUNDED: f64 = 2e-12;
const TURNED: f64 = 1e-15;

/// How far from half a turn a step of a circle joint must stay, in radians: nearer, the shorter direction is ambiguous.
const AMBIGUOUS: f64 = 1e-9;

/// How far the given length may differ from the measured one, relative to it.
const LENGTH: f64 = 1e-9;

/// How edges that are not proven were checked.
const EDGE_CHECKS: [&str; 4] = ["sampled", "none", "joint-lines", "rollouts"];

/// The most samples in between that may be taken for one path.
const MOST_REFINEMENTS: u64 = 10_000_000;

/// The verdict on a path, which may be that it is not valid: see [`Verdict::is_valid`].
#[derive(Debug, Clone, PartialEq)]
#[must_use = "the path may be invalid"]
pub enum Verdict {
    /// The path leads from the start to the goal of its query, or from and to what the result says they were moved to, clear of
    /// everything.
    Valid {
        /// The number of waypoints.
        waypoints: usize,
        /// The number of samples of the robot that were examined; for a disc, of swept segments.
        samples: u64,
        /// The smallest distance to an obstacle at a sample, less the margin of the robot, in metres; infinite without obstacles.
        /// For a disc it is the true one; for an arm or a body the true one is smaller by at most half the motion between two
        /// samples.
        clearance: f64,
        /// Whether the path begins at the result's `moved_start`, since the start of the query is in collision.
        moved_start: bool,
        /// Whether it ends at the result's `moved_goal` or in the region about it, since the goal of the query is in collision.
        moved_goal: bool,
    },
    /// The path is refused.
    Invalid {
        /// The reason, naming waypoint or edge and obstacle, counted from 0, and the link, counted from 1.
        why: String,
    },
}

impl Verdict {
    /// Whether the path is valid.
    pub fn is_valid(&self) -> bool {
        matches!(self, Verdict::Valid { .. })
    }

    /// Nothing of a valid path: for what takes no other.
    ///
    /// # Errors
    /// `invalid-result` (pointer `/path`) with the reason
    pub fn required(&self) -> Result<(), Error> {
        let Verdict::Invalid { why } = self else { return Ok(()) };
        Err(Error::new(Code::InvalidResult, "/path", format!("the path is not valid: {why}")))
    }
}

/// The samples so far, and the smallest clearance among them.
struct Examined {
    samples: u64,
    clearance: f64,
}

/// The lengths that a verdict depends on, in metres, and the work that it may take.
struct Scale {
    /// At this distance or less the robot touches an obstacle.
    slack: f64,
    /// How far the robot may leave the bounds.
    overstep: f64,
    /// The largest motion between two samples.
    spacing: f64,
    /// The most samples in between.
    refinements: u64,
}

/// Verifies a result against its scenario.
///
/// # Errors
/// `invalid-result` (pointer `/scenario`) if the result belongs to another scenario, or (pointer into `/blends`) if its blends
/// are too many, too few, out of range, or those of a car; `unknown-query` (pointer `/query`) if the scenario has no query of
/// that name. Everything else that is wrong is a [`Verdict::Invalid`].
///
/// # Complexity
/// For each edge, its motion divided by a thousandth of the world's size, times links, times obstacles nearby.
pub fn verify(scenario: &Scenario, result: &ResultDocument) -> Result<Verdict, Error> {
    result.check_scenario(scenario)?;
    let (_, query) = scenario.find_query(Some(&result.query))?;
    let shares = blend::check(result, !matches!(scenario.robot(), Robot::Car(_)))?;
    let moved = [result.moved_start.is_some(), result.moved_goal.is_some()];
    Ok(verdict(result.path.len(), moved, check(scenario, query, result, shares)))
}

/// Verifies a path from a start to a goal by itself, with at most this number of samples in between. Returns why it is not valid.
pub(crate) fn verify_path(
    world: &World,
    robot: &Robot,
    ends: [&[f64]; 2],
    path: &[Vec<f64>],
    refinements: u64,
) -> Result<(), String> {
    check_ends(robot, path, ends.map(Some), None)?;
    check_steps(robot, path)?;
    examine(world, robot, path, &[], &Scale { refinements, ..Scale::of(world, robot) }).map(|_| ())
}

/// Verifies legs of a body of this shape in a world, each by itself: they need not be connected. The verdict counts legs as
/// waypoints.
pub fn verify_legs(world: &World, shape: &Polygon, legs: &[Leg]) -> Verdict {
    let scale = Scale::new(world, None, shape.reach());
    verdict(
        legs.len(),
        [false; 2],
        body::check(world, (shape, 0.0), legs.iter().enumerate().map(|(i, &leg)| (Stretch::Edge(i), leg)), &scale),
    )
}

fn verdict(waypoints: usize, [moved_start, moved_goal]: [bool; 2], examined: Result<Examined, String>) -> Verdict {
    match examined {
        Ok(Examined { samples, clearance }) => {
            Verdict::Valid { waypoints, samples, clearance, moved_start, moved_goal }
        }
        Err(why) => Verdict::Invalid { why },
    }
}

/// Checks the status, the numbers, the ends, the motion and the lengths, in this order; `shares` are those of the blends.
fn check(scenario: &Scenario, query: &Query, result: &ResultDocument, shares: &[[f64; 2]]) -> Result<Examined, String> {
    let (world, robot, path) = (scenario.world(), scenario.robot(), &result.path);
    if result.status != Status::Solved {
        return Err(format!("the status is {}: there is no path to verify", result.status.as_str()));
    }
    check_numbers(robot.dimension(), path)?;
    check_measure(robot, result)?;
    check_claims(robot, result)?;
    check_moved(scenario, query, result)?;
    if let Goal::Target(target) = &query.goal {
        check_target(robot, target, &path[path.len() - 1])?;
    }
    let start = result.moved_start.as_deref().unwrap_or(&query.start);
    let goal = result.moved_goal.as_deref().or(query.configuration());
    check_ends(robot, path, [Some(start), goal], query.goal_tolerance)?;
    let scale = Scale::of(world, robot);
    if let Robot::Car(car) = robot {
        // Its length is that of its motions.
        return car::check(world, car, result, &scale);
    }
    check_steps(robot, path)?;
    let blends = Quadratic::blends(&robot.circles(), path, shares);
    let examined = examine(world, robot, path, &blends, &scale)?;
    check_length(robot, result, &blends)?;
    if let (Robot::Disc(disc), Some(cost)) = (robot, &result.cost) {
        disc::check_cost(world, disc, path, cost)?;
    }
    Ok(examined)
}

/// Examines a path of straight motions with these blends; of one configuration, the robot at rest.
fn examine(
    world: &World,
    robot: &Robot,
    path: &[Vec<f64>],
    blends: &[(usize, Quadratic)],
    scale: &Scale,
) -> Result<Examined, String> {
    match robot {
        Robot::Arm(arm) => arm::check(world, arm, path, blends, scale),
        Robot::Disc(disc) => disc::check(world, disc, path, blends, scale),
        Robot::RigidBody(_) | Robot::Car(_) => {
            let (shape, _) = robot.placed_shape().expect("bodies and cars have a shape");
            let ends = (0..path.len().max(2) - 1).map(|i| [&path[i], &path[(i + 1).min(path.len() - 1)]]);
            let edges = ends.enumerate().map(|(i, [from, to])| (Stretch::Edge(i), Leg::straight(from, to)));
            let blends = blends.iter().map(|(waypoint, motion)| (Stretch::Blend(*waypoint), Leg::blend(motion)));
            body::check(world, (shape, robot.margin()), edges.chain(blends), scale)
        }
    }
}

/// Returns an error if the path is empty or a waypoint is not `dimension` numbers within the range of a scenario's: beyond it
/// rounding errors exceed the slack.
fn check_numbers(dimension: usize, path: &[Vec<f64>]) -> Result<(), String> {
    if path.is_empty() {
        return Err("the path is empty".into());
    }
    for (i, waypoint) in path.iter().enumerate() {
        if waypoint.len() != dimension {
            return Err(format!("waypoint {i} has {} numbers, a configuration has {dimension}", waypoint.len()));
        }
        if let Some(value) = waypoint.iter().find(|value| value.is_nan() || value.abs() > LARGEST) {
            return Err(format!("waypoint {i} contains {value:e}, which is not within [-{LARGEST:e}, {LARGEST:e}]"));
        }
    }
    Ok(())
}

/// Returns an error if paths of this robot are not measured as the result says. One that was planned for in a custom space
/// may have either metric of an arm.
fn check_measure(robot: &Robot, result: &ResultDocument) -> Result<(), String> {
    use LengthMeasure::{EuclideanOfJoints, Metres, Space, SumOfJoints, Weighted};
    let own: &[LengthMeasure] = match robot {
        Robot::Arm(_) => &[SumOfJoints, EuclideanOfJoints],
        Robot::Disc(_) | Robot::Car(_) => &[Metres],
        Robot::RigidBody(_) => &[Weighted],
    };
    match result.length_measure {
        Some(given) if given != Space && !own.contains(&given) => {
            Err(format!("lengths of this robot are measured as {own:?}, not as {given:?}"))
        }
        _ => Ok(()),
    }
}

/// Returns an error if an end of the query was moved that is clearly free, or that is none.
fn check_moved(scenario: &Scenario, query: &Query, result: &ResultDocument) -> Result<(), String> {
    let ends =
        [("start", &result.moved_start, Some(&query.start[..])), ("goal", &result.moved_goal, query.configuration())];
    for (what, moved, own) in ends {
        let Some(moved) = moved else { continue };
        let Some(own) = own else { return Err(format!("the {what} was moved, but the query has a target instead")) };
        if moved.len() != own.len() {
            return Err(format!("the moved {what} has {} numbers, a configuration has {}", moved.len(), own.len()));
        }
        if is_clearly_free(scenario, own) {
            return Err(format!("the {what} was moved to {moved:?}, but the query's own {own:?} is free"));
        }
    }
    Ok(())
}

/// Whether a configuration is free by more than planners and verifier may differ: ten times the slack of planners, and inside the
/// bounds.
fn is_clearly_free(scenario: &Scenario, q: &[f64]) -> bool {
    let (world, robot) = (scenario.world(), scenario.robot());
    let scale = Scale::of(world, robot);
    let scale = Scale { slack: 100.0 * scale.slack, overstep: 0.0, ..scale };
    examine(world, robot, &[q.to_vec()], &[], &scale).is_ok()
}

/// Returns an error if the result says what no result for this robot, or none that is solved, can say.
fn check_claims(robot: &Robot, result: &ResultDocument) -> Result<(), String> {
    let ResultDocument {
        motions,
        integration,
        blended_length,
        chord_length,
        cost,
        edge_check,
        coverage,
        approximate,
        ..
    } = result;
    let is_car = matches!(robot, Robot::Car(_));
    for (name, is_there) in [
        ("motions", motions.is_some() && !is_car),
        ("integration", integration.is_some() && !is_car),
        ("chord_length", chord_length.is_some() && !is_car),
        ("blended_length", blended_length.is_some() && is_car),
        ("cost", cost.is_some() && !matches!(robot, Robot::Disc(_))),
    ] {
        if is_there {
            return Err(format!("it has \"{name}\", which no result for the robot {} has", robot.kind()));
        }
    }
    if let Some(margin) = result.margin.filter(|&margin| margin != robot.margin()) {
        return Err(format!("it is for a margin of {margin} m, but that of the robot is {} m", robot.margin()));
    }
    if approximate.is_some() {
        return Err("it has an approximate solution, although it is solved".into());
    }
    if let Some(word) = edge_check.as_ref().filter(|word| !EDGE_CHECKS.contains(&word.as_str())) {
        return Err(format!("there is no edge check {word:?}"));
    }
    let claimed =
        [("length", Some(result.length)), ("blended_length", *blended_length), ("chord_length", *chord_length)];
    for (name, value) in claimed {
        if let Some(value) = value.filter(|value| !(0.0..f64::INFINITY).contains(value)) {
            return Err(format!("the {name} is given as {value}, which is no length"));
        }
    }
    match coverage.filter(|share| !(0.0..=1.0).contains(share)) {
        Some(share) => Err(format!("the coverage is given as {share}, which is not within [0, 1]")),
        None => Ok(()),
    }
}

/// Returns an error if the path does not lead from the start to the goal, or into the region about it.
fn check_ends(
    robot: &Robot,
    path: &[Vec<f64>],
    [start, goal]: [Option<&[f64]>; 2],
    region: Option<GoalTolerance>,
) -> Result<(), String> {
    let ends = [("start", &path[0], start), ("goal", &path[path.len() - 1], goal)];
    for (what, waypoint, wanted) in ends.into_iter().filter_map(|(what, at, wanted)| Some((what, at, wanted?))) {
        let verb = if what == "start" { "starts" } else { "ends" };
        let gaps = difference(&robot.circles(), wanted, waypoint);
        if let (Some(GoalTolerance { translation, rotation }), "goal") = (region, what) {
            let [apart, turned] = apart(robot, &gaps);
            if apart > translation + REACHED || turned > rotation + REACHED {
                return Err(format!(
                    "the path ends at {waypoint:?}, {apart} m and {turned} rad from the goal {wanted:?}"
                ));
            }
        } else if let Some(i) = gaps.into_iter().position(|gap| f64::abs(gap) > REACHED) {
            return Err(format!("the path {verb} at {waypoint:?}, not at the {what} {wanted:?} (coordinate {i})"));
        }
    }
    Ok(())
}

/// How far a robot with these gaps between its coordinates is from the goal: in metres, and in radians.
fn apart(robot: &Robot, gaps: &[f64]) -> [f64; 2] {
    let largest = |gaps: &mut dyn Iterator<Item = f64>| gaps.map(f64::abs).fold(0.0, f64::max);
    match robot {
        Robot::Arm(arm) => [true, false].map(|is_slide| {
            let joints = arm.joint_types().iter().zip(gaps).filter(|(joint, _)| joint.is_prismatic() == is_slide);
            largest(&mut joints.map(|(_, gap)| *gap))
        }),
        _ => [(gaps[0] * gaps[0] + gaps[1] * gaps[1]).sqrt(), gaps.get(2).map_or(0.0, |turn| turn.abs())],
    }
}

/// Returns an error if the end effector is not at the target at the last waypoint, by forward kinematics of its own.
fn check_target(robot: &Robot, target: &Target, last: &[f64]) -> Result<(), String> {
    let Robot::Arm(arm) = robot else { return Err("only an arm reaches for a target".into()) };
    let (mut x, mut y, mut angle, reach) = (arm.base().x, arm.base().y, 0.0, arm.reach());
    for ((length, joint), &at) in arm.links().iter().zip(arm.joint_types()).zip(last) {
        let (turn, growth) = match *joint {
            Joint::Revolute { .. } => (at, 0.0),
            Joint::Prismatic { angle, .. } => (angle, at),
        };
        let length = length + growth;
        angle += turn;
        let (sine, cosine) = libm::sincos(angle);
        (x, y) = (x + length * cosine, y + length * sine);
    }
    let (to_x, to_y) = (target.point.x, target.point.y);
    let left = ((x - to_x) * (x - to_x) + (y - to_y) * (y - to_y)).sqrt();
    let scale = reach + to_x.abs().max(to_y.abs());
    // The same relative accuracy for a small arm, or one far from the origin.
    let allowed = (REACHED * scale.max(1.0)).min(AIMED * reach).max(ROUNDED * scale.max(1.0));
    if left > allowed {
        return Err(format!("the path ends with the end effector at ({x}, {y}), {left} m from the target"));
    }
    if let Some(wanted) = target.orientation {
        let turn = angle - wanted;
        let off = turn - TAU * libm::rint(turn / TAU);
        if off.abs() > REACHED + TURNED * wanted.abs() {
            return Err(format!("the path ends with the last link at {angle} rad, not at {wanted}"));
        }
    }
    Ok(())
}

/// Returns an error if a step turns a circle joint, or a body, by half a turn: the shorter direction is ambiguous.
fn check_steps(robot: &Robot, path: &[Vec<f64>]) -> Result<(), String> {
    let circles = robot.circles();
    for (edge, ends) in path.windows(2).enumerate() {
        let turns = difference(&circles, &ends[0], &ends[1]);
        let is_ambiguous = |&i: &usize| circles[i] && turns[i].abs() >= PI - AMBIGUOUS;
        if let Some(i) = (0..turns.len()).find(is_ambiguous) {
            let turn = turns[i].abs();
            let what = if matches!(robot, Robot::Arm(_)) { format!("joint {i}") } else { "the body".into() };
            return Err(format!("edge {edge} turns {what} by {turn} rad: the shorter direction is ambiguous"));
        }
    }
    Ok(())
}

/// Returns an error if the given length is not the sum of the steps, by the metric of an arm that the result names or else by
/// either, by the weighted one of a body; or if that along the blends, in the same metric, is not less by what they save.
fn check_length(robot: &Robot, result: &ResultDocument, blends: &[(usize, Quadratic)]) -> Result<(), String> {
    let path = &result.path;
    let length = |step: &[f64]| step.iter().map(|d| d * d).sum::<f64>().sqrt();
    let sum = |step: &[f64]| step.iter().map(|d| d.abs()).sum::<f64>();
    let own = |step: &[f64]| match robot.placed_shape() {
        Some((_, weights)) => weights.translation * length(&step[..2]) + weights.rotation * step[2].abs(),
        None => length(step),
    };
    let steps: Vec<_> = path.windows(2).map(|ends| difference(&robot.circles(), &ends[0], &ends[1])).collect();
    let largest = path.iter().flatten().fold(1.0, |largest: f64, value| largest.max(value.abs()));
    let is_right = |given: f64, measured: f64| f64::abs(given - measured) <= LENGTH * measured + 1e-12 * largest;
    let norms: &[(Norm, &str)] = match (robot, result.length_measure) {
        (Robot::Arm(_), None | Some(LengthMeasure::Space)) => &[(&sum, " (sum of the joints) or "), (&own, "")],
        (Robot::Arm(_), Some(LengthMeasure::SumOfJoints)) => &[(&sum, "")],
        _ => &[(&own, "")],
    };
    let (mut whole, mut along) = (String::new(), String::new());
    for (norm, or) in norms {
        let measured = steps.iter().map(|step| norm(step)).sum::<f64>();
        whole += &format!("{measured}{or}");
        if !is_right(result.length, measured) {
            continue;
        }
        let Some(given) = result.blended_length else { return Ok(()) };
        let blended = measured - blends.iter().map(|(_, motion)| motion.saving(norm)).sum::<f64>();
        if is_right(given, blended) {
            return Ok(());
        }
        along = format!("the blended length is given as {given}, but with its blends the path measures {blended}");
    }
    Err(if along.is_empty() {
        format!("the length is given as {}, but the path measures {whole}", result.length)
    } else {
        along
    })
}

/// The coordinates of a placement that are circles.
const PLACEMENT: [bool; 3] = [false, false, true];

/// The step from `a` to `b`, angles of circles in the shorter direction. The double nearest to 2 pi stands for a turn: its error
/// is less than the rounding of an angle.
fn difference(circles: &[bool], a: &[f64], b: &[f64]) -> Vec<f64> {
    let step = |((&is_circle, &a), &b): ((&bool, &f64), &f64)| {
        if is_circle { libm::remainder(libm::remainder(b, TAU) - libm::remainder(a, TAU), TAU) } else { b - a }
    };
    circles.iter().zip(a).zip(b).map(step).collect()
}

impl Scale {
    /// The lengths for a robot in a world.
    fn of(world: &World, robot: &Robot) -> Self {
        match robot {
            Robot::Arm(arm) => Self::new(world, Some(arm.base()), arm.reach() + arm.kept_radius()),
            Robot::Disc(disc) => Self::new(world, None, disc.kept_radius()),
            Robot::RigidBody(body) => Self::new(world, None, body.shape.reach() + body.margin()),
            Robot::Car(car) => Self::new(world, None, car.shape().reach() + car.margin()),
        }
    }

    /// The lengths for a robot of this reach, from its base if it has one.
    fn new(world: &World, base: Option<Point>, reach: f64) -> Self {
        let base = base.map(|at| Aabb { min: at, max: at });
        let boxes = world.obstacles.iter().map(Obstacle::aabb).chain(world.bounds).chain(base);
        let coordinates = boxes.flat_map(|b| [b.min.x, b.min.y, b.max.x, b.max.y]);
        let largest = coordinates.fold(0.0, |largest: f64, coordinate| largest.max(coordinate.abs())) + reach;
        let side = world.bounds.map_or(f64::INFINITY, |bounds| bounds.longer_side());
        // Nothing is missed between samples: a tiny robot in a wide world needs no sample at every length of its own.
        let size = if reach > 0.0 { side.min(2.0 * reach) } else { side };
        let size = if side < f64::INFINITY { size.max(1e-2 * side) } else { size };
        Self { slack: 1e-13 * largest, overstep: 2e-12 * largest, spacing: 1e-3 * size, refinements: MOST_REFINEMENTS }
    }
}
