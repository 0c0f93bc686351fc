//! The independent verifier of plans.
//!
//! Planners prove a pair of motions from the middle of their time, discs by a formula for two points. The verifier goes
//! from the front, row by row ([`advancement`](super::advancement)). Its distances are those of corners from edges, and
//! an exact test of intersection. Each robot's way among the obstacles is judged by
//! [`path::verify`](crate::path::verify()), its speed motion by motion, and every number that a plan claims is compared
//! with its rows.

use super::advancement::{Conflict, found};
use super::document::{Fleet, FleetRobot, pose};
use super::motion::{Footprint, Pose};
use super::result::FleetResult;
use super::trajectory::{Trajectory, moved_until_next};
use crate::error::{Code, Error, Number, quoted};
use crate::path;
use crate::problem::Status;
use crate::robot::LARGEST;
use crate::scenario::Robot;
use serde::Serialize;

/// How far a coordinate may be from that of the start or the goal, and by what fraction a speed may exceed the robot's.
const REACHED: f64 = 1e-9;

/// The most samples between those that the way of every robot among the obstacles takes, all robots together.
const MOST_SAMPLES: u64 = 10_000_000;

/// By how many units in the last place of a coordinate two rows of a motion are rounded together, at most.
const ROUNDED: f64 = 8.0 * f64::EPSILON;

/// What is wrong with the trajectory of one robot by itself.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "FleetFault"))]
pub struct Fault {
    /// The robot, by its index.
    pub robot: usize,
    /// The reason, in a sentence.
    pub why: String,
}

/// A number or a name of a plan that does not agree with its rows.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "FleetClaim"))]
pub struct Claim {
    /// A JSON pointer into the plan.
    pub pointer: String,
    /// The reason, in a sentence.
    pub why: String,
}

/// The verdict on a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "FleetVerification"))]
pub struct Verification {
    /// Whether there is no conflict, no fault and no false claim.
    pub valid: bool,
    /// The conflicts, in the order of their times.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "FleetConflict[]"))]
    pub conflicts: Vec<Conflict>,
    /// What is wrong with single robots: a start or a goal missed, too fast, an obstacle touched.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "FleetFault[]"))]
    pub faults: Vec<Fault>,
    /// What the plan says of itself that its rows do not confirm: its totals, its order, a robot without a way.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "FleetClaim[]"))]
    pub claims: Vec<Claim>,
    /// How many distances between robots were evaluated.
    pub looks: u64,
}

impl Verification {
    /// Whether there is no conflict, no fault and no false claim.
    pub fn is_valid(&self) -> bool {
        self.valid
    }
}

/// Verifies a plan.
///
/// # Errors
/// Those of [`trajectories`].
///
/// # Complexity
/// For each pair of robots the number of their rows; near contact of bodies more distances, whose number is bounded by
/// that of all rows: what is undecided then counts as conflict. For each robot that of
/// [`path::verify`](crate::path::verify()).
pub fn verify(fleet: &Fleet, result: &FleetResult) -> Result<Verification, Error> {
    let trajectories = trajectories(fleet, result)?;
    let mut faults = Vec::new();
    for (robot, trajectory) in trajectories.iter().enumerate() {
        if let Err(why) = check_alone(fleet, robot, trajectory, &result.robots[robot].path) {
            faults.push(Fault { robot, why });
        }
    }
    let (conflicts, looks) = all_conflicts(fleet, &trajectories);
    let claims = claims(fleet, result, &trajectories);
    let valid = conflicts.is_empty() && faults.is_empty() && claims.is_empty();
    Ok(Verification { valid, conflicts, faults, claims, looks })
}

/// The conflicts of trajectories, one of every robot in order, in the order of their times.
///
/// # Panics
/// If there are fewer trajectories than robots.
pub fn conflicts(fleet: &Fleet, trajectories: &[Trajectory]) -> Vec<Conflict> {
    all_conflicts(fleet, trajectories).0
}

/// Every robot straight to its goal at once, at its speed, whatever is in the way.
pub fn straight(fleet: &Fleet) -> Vec<Trajectory> {
    let of = |member: &super::FleetRobot| {
        let [start, goal] = [&member.start, &member.goal].map(|q| pose(q));
        let mut trajectory = Trajectory::standing(start);
        trajectory.add(Footprint::of(&member.robot).travel(start, goal) / member.speed, goal);
        trajectory
    };
    fleet.robots().iter().map(of).collect()
}

/// The trajectories of a result, one of every robot in order.
///
/// # Errors
/// `invalid-result` with a pointer into the result: if it belongs to another fleet, is not solved, names other robots or in
/// another order, if a configuration has the wrong length or a coordinate outside [-1e6, 1e6], if times do not begin at 0 or go
/// back, or if the robot can move by more than the slack of the fleet between a time and the next larger double.
pub fn trajectories(fleet: &Fleet, result: &FleetResult) -> Result<Vec<Trajectory>, Error> {
    let refuse = |pointer: String, sentence: String| Err(Error::new(Code::InvalidResult, pointer, sentence));
    if result.fleet != fleet.name() {
        let sentence =
            format!("the result belongs to fleet {}, not to {}", quoted(&result.fleet), quoted(fleet.name()));
        return refuse("/fleet".to_owned(), sentence);
    }
    if result.status != Status::Solved {
        let sentence = format!("the status is {}: there is no plan", result.status.as_str());
        return refuse("/status".to_owned(), sentence);
    }
    if result.robots.len() != fleet.robots().len() {
        let sentence = format!("there are {} trajectories, and {} robots", result.robots.len(), fleet.robots().len());
        return refuse("/robots".to_owned(), sentence);
    }
    let (slack, mut trajectories) = (fleet.slack(), Vec::with_capacity(result.robots.len()));
    for (i, (given, member)) in result.robots.iter().zip(fleet.robots()).enumerate() {
        if given.name != member.name {
            let sentence = format!("this is robot {}, not {}", quoted(&member.name), quoted(&given.name));
            return refuse(format!("/robots/{i}/name"), sentence);
        }
        let dimension = member.robot.dimension();
        if let Some(row) = given.path.iter().position(|q| q.len() != dimension) {
            let sentence = format!("a configuration has {dimension} numbers, not {}", given.path[row].len());
            return refuse(format!("/robots/{i}/path/{row}"), sentence);
        }
        for (row, q) in given.path.iter().enumerate() {
            if let Some(value) = q.iter().find(|value| value.is_nan() || value.abs() > LARGEST) {
                let sentence = format!("a coordinate must lie within [-{LARGEST:e}, {LARGEST:e}], not {value:e}");
                return refuse(format!("/robots/{i}/path/{row}"), sentence);
            }
        }
        for (row, &time) in given.times.iter().enumerate() {
            // What the next time would be, at the robot's speed.
            let step = moved_until_next(time, member.speed);
            if step.is_nan() || step > slack {
                let [time, step, slack] = [time, step, slack].map(Number);
                let sentence = format!(
                    "the time {time} s is too large to be judged: until the next double the robot moves {step} m, \
                     more than {slack}"
                );
                return refuse(format!("/robots/{i}/times/{row}"), sentence);
            }
        }
        match Trajectory::of_rows(&given.times, given.path.iter().map(|q| pose(q)).collect()) {
            Ok(trajectory) => trajectories.push(trajectory),
            Err((sentence, row)) => return refuse(format!("/robots/{i}/times/{row}"), sentence),
        }
    }
    Ok(trajectories)
}

/// Checks the ends, the speed, and the way among obstacles of one robot.
fn check_alone(fleet: &Fleet, robot: usize, trajectory: &Trajectory, path: &[Vec<f64>]) -> Result<(), String> {
    let member = &fleet.robots()[robot];
    check_speed(member, trajectory)?;
    let refinements = MOST_SAMPLES / fleet.robots().len() as u64;
    path::verify_path(fleet.world(), &member.robot, [&member.start, &member.goal], path, refinements)
}

/// Returns an error if a motion is faster than the robot, judged by its own duration. Its times are rounded to the next
/// double, its coordinates to theirs.
fn check_speed(member: &FleetRobot, trajectory: &Trajectory) -> Result<(), String> {
    let footprint = Footprint::of(&member.robot);
    let rows: Vec<(&f64, &Pose)> = trajectory.times().iter().zip(trajectory.poses()).collect();
    for (row, ends) in rows.windows(2).enumerate() {
        let [(begin, from), (end, to)] = [ends[0], ends[1]];
        let (way, duration) = (footprint.travel(*from, *to), end - begin);
        let size = |[x, y, theta]: &Pose| x.abs() + y.abs() + footprint.reach() * theta.abs();
        let rounding = member.speed * 2.0 * (end.next_up() - end) + ROUNDED * (size(from) + size(to));
        if way > member.speed * duration * (1.0 + REACHED) + rounding {
            let [way, duration, most] = [way, duration, member.speed].map(Number);
            return Err(format!(
                "from row {row} on it moves {way} m in {duration} s, faster than its speed of {most} m/s"
            ));
        }
    }
    Ok(())
}

/// What a plan says of itself and its rows do not confirm.
fn claims(fleet: &Fleet, result: &FleetResult, trajectories: &[Trajectory]) -> Vec<Claim> {
    let mut claims = Vec::new();
    let mut refuse = |pointer: &str, why: String| claims.push(Claim { pointer: pointer.to_owned(), why });
    let sum = |of: fn(&Trajectory) -> f64| trajectories.iter().map(of).sum::<f64>();
    let makespan = trajectories.iter().map(Trajectory::arrival).fold(0.0, f64::max);
    let costs = sum(Trajectory::arrival);
    // Waits are differences of times, which round as the arrivals do.
    for (name, given, measured, size, what) in [
        ("makespan", result.makespan, makespan, makespan, "the last robot arrives at"),
        ("sum_of_costs", result.sum_of_costs, costs, costs, "the arrivals add up to"),
        ("waits", result.waits, sum(Trajectory::waits), costs, "the waits add up to"),
    ] {
        let off = (given - measured).abs();
        if off.is_nan() || off > REACHED * size {
            let [given, measured] = [given, measured].map(Number);
            refuse(&format!("/{name}"), format!("the {name} is given as {given} s, but {what} {measured} s"));
        }
    }
    if let Some(order) = &result.order {
        let [mut given, mut names]: [Vec<&str>; 2] = [
            order.iter().map(String::as_str).collect(),
            fleet.robots().iter().map(|member| member.name.as_str()).collect(),
        ];
        given.sort_unstable();
        names.sort_unstable();
        if given != names {
            refuse("/order", "the order of priorities does not name every robot once".to_owned());
        }
    }
    if let Some(blocked) = &result.blocked {
        let name = quoted(&blocked.robot);
        refuse("/blocked", format!("robot {name} is said to find no way, but the plan is solved"));
    }
    claims
}

/// The conflicts of all pairs, and the number of distances evaluated.
fn all_conflicts(fleet: &Fleet, trajectories: &[Trajectory]) -> (Vec<Conflict>, u64) {
    let robots: Vec<&Robot> = fleet.robots().iter().map(|member| &member.robot).collect();
    // A tenth of the slack of planners: what they have proven passes whatever is rounded here.
    found(&robots, trajectories, 0.1 * fleet.slack())
}
