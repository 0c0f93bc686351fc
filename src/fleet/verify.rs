//! The independent verifier of plans.
//!
//! Planners prove a pair of motions from the middle of their time, discs by a formula. The verifier goes from the front, whatever the shapes:
//! from a time at which two robots are a distance apart it advances by the time in which they cannot meet, and looks again
//! (conservative advancement: Mirtich 1996, "Impulse-based dynamic simulation of rigid body systems"). Its distances are those of corners from
//! edges, and an exact test of intersection. Each robot's way among the obstacles is judged by [`path::verify`](crate::path::verify()).

use super::document::{Fleet, pose};
use super::motion::{Footprint, Motion, Pose};
use super::run::FleetResult;
use super::trajectory::Trajectory;
use crate::error::{Code, Error, Number, quoted};
use crate::geometry::{Point, Polygon, distance_point_segment, intersects_polygon_polygon};
use crate::path::{self, ResultDocument, Verdict};
use crate::problem::{Stats, Status};
use crate::robot::Part;
use crate::scenario::Robot;
use serde::Serialize;

/// How far a coordinate may be from that of the start or the goal, and by what fraction a speed may exceed the robot's.
const REACHED: f64 = 1e-9;

/// The most distances of one pair of robots; a plan that needs more is refused.
const MOST_DISTANCES: u32 = 1_000_000;

/// While bodies are in conflict, their distance is evaluated so many times in each motion at least.
const LOOKS: f64 = 64.0;

/// Two robots that touch for a while.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null, rename = "FleetConflict"))]
pub struct Conflict {
    /// The robots, by their indices, the lower first.
    pub robots: [usize; 2],
    /// When they come into contact, in seconds.
    pub from: f64,
    /// A time at which they are apart again; `None` if they never are.
    pub to: Option<f64>,
    /// Where they are at first: x, y, theta of each; theta of a disc is 0.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[[number, number, number], [number, number, number]]"))]
    pub places: [Pose; 2],
}

/// What is wrong with the trajectory of one robot by itself.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "FleetFault"))]
pub struct Fault {
    /// The robot, by its index.
    pub robot: usize,
    /// The reason, in a sentence.
    pub why: String,
}

/// The verdict on a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "FleetVerification"))]
pub struct Verification {
    /// Whether there is no conflict and no fault.
    pub valid: bool,
    /// The conflicts, in the order of their times.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "FleetConflict[]"))]
    pub conflicts: Vec<Conflict>,
    /// What is wrong with single robots: a start or a goal missed, too fast, an obstacle touched.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "FleetFault[]"))]
    pub faults: Vec<Fault>,
    /// How many distances between robots were evaluated.
    pub looks: u64,
}

impl Verification {
    /// Whether there is no conflict and no fault.
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
/// For each pair of robots the number of motions, and of distances near contact; for each robot that of
/// [`path::verify`](crate::path::verify()).
pub fn verify(fleet: &Fleet, result: &FleetResult) -> Result<Verification, Error> {
    let trajectories = trajectories(fleet, result)?;
    let mut faults = Vec::new();
    for (robot, trajectory) in trajectories.iter().enumerate() {
        if let Err(why) = check_alone(fleet, robot, trajectory, &result.robots[robot].path) {
            faults.push(Fault { robot, why });
        }
    }
    let (conflicts, looks) = found(fleet, &trajectories);
    Ok(Verification { valid: conflicts.is_empty() && faults.is_empty(), conflicts, faults, looks })
}

/// The conflicts of trajectories, one of every robot in order, in the order of their times.
///
/// # Panics
/// If there are fewer trajectories than robots.
pub fn conflicts(fleet: &Fleet, trajectories: &[Trajectory]) -> Vec<Conflict> {
    found(fleet, trajectories).0
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
/// `invalid-result` with a pointer into the result: if it belongs to another fleet, is not solved, names other robots or in another order,
/// if a configuration has the wrong length, or if times do not begin at 0 or go back.
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
    let mut trajectories = Vec::with_capacity(result.robots.len());
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
    // What places and times are rounded by: a motion of nanoseconds can have any speed.
    let rounding = fleet.slack() + f64::EPSILON * member.speed * trajectory.times().iter().copied().fold(0.0, f64::max);
    let (speed, row) = trajectory.fastest(&Footprint::of(&member.robot), rounding);
    if speed > member.speed * (1.0 + REACHED) {
        let [most, speed] = [member.speed, speed].map(Number);
        return Err(format!("from row {row} on it moves at up to {speed} m/s, faster than its speed of {most}"));
    }
    let scenario = fleet.scenario(robot);
    let weights = member.robot.placed_shape().map(|(_, weights)| weights);
    let length = trajectory.poses().windows(2).map(|ends| {
        let [x, y, turn] = super::motion::difference(ends[0], ends[1]);
        let way = (x * x + y * y).sqrt();
        weights.map_or(way, |weights| weights.translation * way + weights.rotation * turn.abs())
    });
    let result = ResultDocument {
        scenario: scenario.name().to_owned(),
        query: member.name.clone(),
        planner: String::new(),
        seed: 0,
        status: Status::Solved,
        reason: None,
        explanation: None,
        path: path.to_vec(),
        motions: None,
        blends: None,
        integration: None,
        length: length.sum::<f64>() + 0.0,
        length_measure: None,
        blended_length: None,
        chord_length: None,
        stats: Stats::default(),
        fingerprint: 0,
        edge_check: None,
        coverage: None,
        moved_start: None,
        moved_goal: None,
        approximate: None,
    };
    match path::verify(&scenario, &result) {
        Ok(Verdict::Valid { .. }) => Ok(()),
        Ok(Verdict::Invalid { why }) => Err(why),
        Err(error) => Err(error.message().to_owned()),
    }
}

/// The conflicts of all pairs, and the number of distances evaluated.
fn found(fleet: &Fleet, trajectories: &[Trajectory]) -> (Vec<Conflict>, u64) {
    let (mut conflicts, mut looks) = (Vec::new(), 0);
    let robots: Vec<&Robot> = fleet.robots().iter().map(|member| &member.robot).collect();
    for second in 1..robots.len() {
        for first in 0..second {
            let pair = Advancement {
                robots: [robots[first], robots[second]],
                trajectories: [&trajectories[first], &trajectories[second]],
                // A tenth of the slack of planners: what they have proven passes whatever is rounded here.
                slack: 0.1 * fleet.slack(),
            };
            pair.run(&mut looks, |from, to, places| {
                conflicts.push(Conflict { robots: [first, second], from, to, places });
            });
        }
    }
    conflicts.sort_by(|a: &Conflict, b: &Conflict| a.from.total_cmp(&b.from).then(a.robots.cmp(&b.robots)));
    (conflicts, looks)
}

/// Two robots along their trajectories.
struct Advancement<'a> {
    robots: [&'a Robot; 2],
    trajectories: [&'a Trajectory; 2],
    slack: f64,
}

impl Advancement<'_> {
    /// Calls `report` for every conflict: when it begins, when it is over, and where the robots are.
    fn run(&self, looks: &mut u64, mut report: impl FnMut(f64, Option<f64>, [Pose; 2])) {
        let mut time = 0.0;
        let mut touching: Option<(f64, [Pose; 2])> = None;
        for _ in 0..MOST_DISTANCES {
            let motions = self.trajectories.map(|trajectory| trajectory.motion_at(time));
            let end = motions[0].end.min(motions[1].end);
            let places = self.trajectories.map(|trajectory| trajectory.at(time));
            let distance = distance(self.robots, places);
            *looks += 1;
            let rate = self.rate(&motions);
            let room = distance - self.slack;
            if room <= 0.0 {
                touching.get_or_insert((time, places));
            } else if let Some((from, places)) = touching.take() {
                report(from, Some(time), places);
            }
            let is_last = end == f64::INFINITY;
            if is_last && touching.is_some() {
                break;
            }
            // Apart: they cannot meet before; touching: discs cannot be apart before, bodies are looked at often.
            let mut next = time + room.abs() / rate;
            if touching.is_some() {
                next = next.max(time + (end - motions[0].begin.max(motions[1].begin)) / LOOKS);
            }
            if next >= end {
                if is_last {
                    return;
                }
                next = end;
            } else if next <= time {
                // Closer than the times can tell.
                touching.get_or_insert((time, places));
                next = time.next_up();
            }
            time = next;
        }
        if let Some((from, places)) = touching {
            report(from, None, places);
        } else {
            report(time, None, self.trajectories.map(|trajectory| trajectory.at(time)));
        }
    }

    /// How fast the distance can change at most, in metres per second.
    fn rate(&self, motions: &[Motion; 2]) -> f64 {
        let rates = motions.each_ref().map(Motion::rates);
        let (x, y) = (rates[0][0] - rates[1][0], rates[0][1] - rates[1][1]);
        let turning =
            |i: usize| self.robots[i].placed_shape().map_or(0.0, |(shape, _)| shape.reach()) * rates[i][2].abs();
        (x * x + y * y).sqrt() + turning(0) + turning(1)
    }
}

/// The distance between two robots, in metres; 0 or less if they touch.
fn distance(robots: [&Robot; 2], places: [Pose; 2]) -> f64 {
    let part = |i: usize| robots[i].footprint(&places[i][..robots[i].dimension()]).swap_remove(0);
    match (part(0), part(1)) {
        (Part::Disc { center: a, radius: r }, Part::Disc { center: b, radius: s }) => (a - b).norm() - r - s,
        (Part::Disc { center, radius }, Part::Polygon { vertices })
        | (Part::Polygon { vertices }, Part::Disc { center, radius }) => {
            let Ok(polygon) = Polygon::new(&vertices) else { return 0.0 };
            if polygon.contains(center) { -radius } else { from_border(center, &polygon) - radius }
        }
        (Part::Polygon { vertices: a }, Part::Polygon { vertices: b }) => {
            let (Ok(a), Ok(b)) = (Polygon::new(&a), Polygon::new(&b)) else { return 0.0 };
            if intersects_polygon_polygon(&a, &b) {
                return 0.0;
            }
            let least = |from: &Polygon, to: &Polygon| {
                from.vertices().iter().map(|&corner| from_border(corner, to)).fold(f64::INFINITY, f64::min)
            };
            least(&a, &b).min(least(&b, &a))
        }
        _ => 0.0,
    }
}

/// The distance of a point from the border of a polygon.
fn from_border(point: Point, polygon: &Polygon) -> f64 {
    polygon.edges().map(|edge| distance_point_segment(point, &edge)).fold(f64::INFINITY, f64::min)
}
