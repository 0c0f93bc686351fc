//! The judge of paths that anybody has made: waypoints alone, without the motions and claims of a result document.
//!
//! Between two waypoints every coordinate changes at a constant rate, angles in the shorter direction; with
//! [`JudgeOptions::arcs`] a body or a car moves along its own axis instead, on an arc of constant curvature. The judge proves
//! each motion free with the proof of the planners, at its finest tolerance. Where a motion cannot be proven, it halves it
//! towards the front until the stretch in question is shorter than the tolerance (LaValle 2006, "Planning Algorithms", section
//! 5.3.4): all before that place is proven free, and there the robot is at most 1e-10 of the largest coordinate plus its reach
//! away from the obstacle that is named: less than a micrometre in worlds of up to 5 km.
//!
//! A path that is free also gets its smallest clearance (`clearance.rs`), and that of a car the turns that it cannot drive
//! (`turns.rs`). [`verify`](crate::path::verify()) is the other judge: it shares no code with the proof, and reads results.

mod clearance;
mod moves;
mod placed;
mod turns;

pub use clearance::PathClearance;
pub use turns::{MOST_TURNS, Turn, TurnFault, Turns};

use self::moves::{Move, Moves};
use self::placed::{Near, PlacedRobot, State};
use crate::collision::Obstacles;
use crate::error::{Code, Error, Number};
use crate::geometry::{Aabb, Point};
use crate::scenario::Robot;
use crate::world::{Configurations, PlanningWorld};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

/// How near the robot is to what it touches first, in multiples of the slack.
const TOUCHING: f64 = 100.0;

/// The most waypoints of a path that is judged.
pub const MAX_WAYPOINTS: usize = 2_000_000;

/// How often a proof that has spent its budget is begun again where it ended, for one motion.
const RESUMED: u32 = 64;

/// How a path is judged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JudgeOptions {
    /// Whether a body or a car moves from waypoint to waypoint on an arc of constant curvature, along its own axis. It turns as
    /// far as the headings differ, and its chord is as long as the way between both along the heading in the middle. What is
    /// then left to the waypoint, such as the rounding of a file, is a straight motion.
    pub arcs: bool,
    /// By how much a turn may exceed what a car can drive, as a fraction: of the curvature, and of the length for the way
    /// sideways. At least 0.
    pub drive_tolerance: f64,
}

impl Default for JudgeOptions {
    fn default() -> Self {
        Self { arcs: false, drive_tolerance: 0.01 }
    }
}

/// What is known of a path. As JSON it has `valid` and `free`, and these names; `contact` is null if the path is free.
#[derive(Debug, Clone, PartialEq)]
#[must_use = "the path may be in collision"]
pub struct Judgement {
    /// The number of waypoints.
    pub waypoints: usize,
    /// What ends the part of the path that is free; `None` if all of it is proven free.
    pub contact: Option<FirstContact>,
    /// The smallest clearance of a path that is free; `None` of others, and without obstacles.
    pub clearance: Option<PathClearance>,
    /// Of a car, the turns between waypoints.
    pub turns: Option<Turns>,
}

impl Judgement {
    /// Whether all of the path is proven free, within the bounds and within the limits of the joints.
    pub fn is_free(&self) -> bool {
        self.contact.is_none()
    }

    /// Whether the path is free and the robot can drive it.
    pub fn is_valid(&self) -> bool {
        self.is_free() && self.is_drivable()
    }

    /// Whether no turn between two waypoints is beyond what the car can drive; true for other robots.
    pub fn is_drivable(&self) -> bool {
        self.turns.as_ref().is_none_or(|turns| turns.count == 0)
    }
}

impl Serialize for Judgement {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_struct("Judgement", 5 + usize::from(self.turns.is_some()))?;
        object.serialize_field("valid", &self.is_valid())?;
        object.serialize_field("free", &self.is_free())?;
        object.serialize_field("waypoints", &self.waypoints)?;
        object.serialize_field("contact", &self.contact)?;
        object.serialize_field("clearance", &self.clearance)?;
        if let Some(turns) = &self.turns {
            object.serialize_field("turns", turns)?;
        }
        object.end()
    }
}

/// A place on a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathPlace {
    /// The motion, by the index of the waypoint that it begins at, from 0.
    pub edge: usize,
    /// The fraction of the motion, from 0 to 1.
    pub fraction: f64,
    /// The configuration there, its angles not wrapped.
    pub configuration: Vec<f64>,
}

/// Where a path is no longer free. All before it is proven.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FirstContact {
    /// The place on the path.
    #[serde(flatten)]
    pub at: PathPlace,
    /// What is there.
    pub with: Blocked,
    /// The part of the robot that touches it: the link of an arm, from 0.
    pub part: usize,
    /// The point of the obstacle or of the robot at which they touch, in metres; `None` if nothing is touched.
    pub point: Option<Point>,
}

/// What ends the free part of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Blocked {
    /// The obstacle with this index, from 0.
    Obstacle(usize),
    /// The border of the world. Turning or sliding along it may count.
    Bounds,
    /// The limit of the joint with this index, from 0.
    JointLimit(usize),
    /// The coordinate with this index turns by half a turn, to 1e-9 rad: the shorter direction is ambiguous.
    HalfTurn(usize),
    /// Nothing is touched here, but the proof has spent its budget.
    Unproven,
}

/// Judges a path of any origin in the world of a scenario: `path` has a configuration of the robot for each waypoint, in metres
/// and radians. The queries of the scenario do not count. The margin of the robot does.
///
/// # Errors
/// `out-of-range` (pointer `/path`) for a path without waypoints, `too-large` for more than [`MAX_WAYPOINTS`]; `out-of-range`
/// (`/drive_tolerance`) for a tolerance that is negative or not finite; `wrong-dimension`, `not-finite` or `out-of-range` with
/// the pointer of a waypoint or its entry for what is no configuration; `unsupported` (`/arcs`) for arcs of a robot without a
/// heading.
///
/// # Complexity
/// For each motion that of its proof, and a number of clearances that grows with its length divided by its clearance, at most
/// 2^20 in all and a few a motion. Near linear in the waypoints.
///
/// ```
/// use planarium::path::{Blocked, JudgeOptions, judge};
/// use planarium::scenario::Scenario;
///
/// let scenario = Scenario::parse(
///     r#"{ "format": "planarium-scenario-1", "name": "post",
///          "world": { "bounds": { "min": [0, 0], "max": [4, 4] },
///                     "obstacles": [ { "type": "disc", "center": [2, 2], "radius": 0.5 } ] },
///          "robot": { "type": "disc", "radius": 0.25 }, "queries": [] }"#,
/// )?;
/// let through = judge(&scenario, &[vec![1.0, 1.0], vec![1.0, 2.0], vec![3.0, 2.0]], &JudgeOptions::default())?;
/// let contact = through.contact.expect("it goes through the post");
/// assert_eq!((contact.at.edge, contact.with), (1, Blocked::Obstacle(0)));
/// assert!((contact.at.fraction - 0.125).abs() < 1e-9);
///
/// let around = judge(&scenario, &[vec![1.0, 2.0], vec![1.0, 3.0], vec![3.0, 3.0]], &JudgeOptions::default())?;
/// assert!(around.is_free() && around.clearance.is_some_and(|least| (least.distance - 0.25).abs() < 1e-3));
/// # Ok::<(), planarium::Error>(())
/// ```
pub fn judge(world: impl Into<PlanningWorld>, path: &[Vec<f64>], options: &JudgeOptions) -> Result<Judgement, Error> {
    let world = world.into();
    check(&world, path, options)?;
    let judge =
        Judge { moves: Moves::new(&world, path, options.arcs), obstacles: world.collision().obstacles(), world };
    let contact = (0..judge.moves.edges()).find_map(|edge| judge.first_contact(edge));
    let clearance = match contact {
        None => clearance::smallest(&judge.moves, &judge.obstacles),
        Some(_) => None,
    };
    let turns = match judge.world.robot() {
        Robot::Car(car) => Some(turns::of(car, path, options.drive_tolerance)),
        _ => None,
    };
    Ok(Judgement { waypoints: path.len(), contact, clearance, turns })
}

fn check(world: &PlanningWorld, path: &[Vec<f64>], options: &JudgeOptions) -> Result<(), Error> {
    if path.is_empty() {
        return Err(Error::new(Code::OutOfRange, "/path", "the path has no waypoint"));
    }
    if path.len() > MAX_WAYPOINTS {
        let sentence = format!("the path has {} waypoints; at most {MAX_WAYPOINTS} are judged", path.len());
        return Err(Error::new(Code::TooLarge, "/path", sentence));
    }
    let tolerance = options.drive_tolerance;
    if !(0.0..f64::INFINITY).contains(&tolerance) {
        let sentence = format!("the tolerance of turns is a number of at least 0, not {}", Number(tolerance));
        return Err(Error::new(Code::OutOfRange, "/drive_tolerance", sentence));
    }
    if options.arcs && !matches!(world.robot(), Robot::RigidBody(_) | Robot::Car(_)) {
        let sentence = "only a body or a car moves along arcs: another robot has no heading";
        return Err(Error::new(Code::Unsupported, "/arcs", sentence));
    }
    let configurations = Configurations::of(world);
    path.iter().enumerate().try_for_each(|(i, q)| {
        // The pointer is made of what is refused only: a path may have a million waypoints.
        configurations.refuse(q, "").map_err(|error| {
            let pointer = format!("/path/{i}{}", error.pointer());
            Error::new(error.code(), pointer, error.message())
        })
    })
}

struct Judge {
    moves: Moves,
    obstacles: std::sync::Arc<Obstacles>,
    world: PlanningWorld,
}

impl Judge {
    /// What ends the free part of a path on this edge.
    fn first_contact(&self, edge: usize) -> Option<FirstContact> {
        let found = |leg: &Move, t: f64, with: Blocked| FirstContact {
            at: leg.place(t, self.moves.dimension()),
            with,
            part: 0,
            point: None,
        };
        if let Some(joint) = self.moves.half_turn(edge) {
            let rest = self.moves.rest(edge);
            return self.hit(&rest).or_else(|| Some(found(&rest, 0.0, Blocked::HalfTurn(joint))));
        }
        let limit = self.moves.limit(edge);
        for leg in self.moves.of_edge(edge) {
            let within = limit.map_or(leg, |(_, at)| leg.part(0.0, at));
            if let Some(contact) = self.hit(&within) {
                return Some(contact);
            }
            if let Some((joint, at)) = limit {
                return Some(found(&leg, at, Blocked::JointLimit(joint)));
            }
        }
        None
    }

    /// The first contact on a leg.
    fn hit(&self, leg: &Move) -> Option<FirstContact> {
        let mut low = 0.0;
        for _ in 0..RESUMED {
            let rest = if low == 0.0 { *leg } else { leg.part(low, 1.0) };
            let hit = self.moves.first_hit(&rest)?;
            low += hit * (1.0 - low);
            if let Some((part, with, point)) = self.touched(&leg.at(low)) {
                let point = Some(point);
                return Some(FirstContact { at: leg.place(low, self.moves.dimension()), with, part, point });
            }
            if hit == 0.0 {
                break;
            }
        }
        let at = leg.place(low, self.moves.dimension());
        Some(FirstContact { at, with: Blocked::Unproven, part: 0, point: None })
    }

    /// The part of the robot that touches something, what, and where.
    fn touched(&self, q: &State) -> Option<(usize, Blocked, Point)> {
        let placed = self.moves.placed(q);
        let within = TOUCHING * self.moves.slack();
        if let Some(Near { part, obstacle, .. }) = placed.nearest(&self.obstacles, within) {
            let point = placed.nearest_point(part, self.obstacles.shape(obstacle));
            return Some((part, Blocked::Obstacle(obstacle), point));
        }
        let bounds: &Aabb = self.world.scenario().world().bounds.as_ref()?;
        let (depth, part, point) = self.shallowest(&placed, bounds);
        (depth <= within).then_some((part, Blocked::Bounds, point))
    }

    /// The least depth of the robot within the bounds, the part, and the point of it.
    fn shallowest(&self, placed: &PlacedRobot, bounds: &Aabb) -> (f64, usize, Point) {
        let radius = placed.radius();
        let depths = placed.points().map(|(part, p)| (bounds.depth(p) - radius, part, p));
        depths.reduce(|a, b| if b.0 < a.0 { b } else { a }).unwrap_or((f64::INFINITY, 0, bounds.min))
    }
}
