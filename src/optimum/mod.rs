//! The ground truth beside a run: the shortest path of a query, or a reference where it is not known.
//!
//! | robot | method |
//! |---|---|
//! | a disc or a point | the tangent graph, exact, as far as a search needs it (`polyanya.rs`) |
//! | an arm of two joints | a fine grid over the two joints, then shortcuts and finer grids around corners (`grid.rs`) |
//! | a rigid body whose query keeps its angle | the same over x and y, without turns |
//!
//! Other robots have none.
//!
//! Of the exact method: `circles.rs` are the circles that a path turns around and their tangents, `grown.rs` is the world as the
//! disc's centre sees it, `arcs.rs` has the free arcs of the circles, `mesh.rs` the navigation mesh, `dead_ends.rs` what of
//! it no path enters, `rays.rs` what a search pushes through it, `sight.rs` what such rays see, `tangents.rs` all of that
//! beforehand, `route.rs` the path that it finds. `tangent_graph.rs` compares all pairs of circles: slower and simpler, it is the
//! oracle of the tests.
//!
//! Beside it, the widest disc that has a path (`widest/`), and the shortest path of that disc, which is the safest (`safest.rs`).

mod arcs;
mod circles;
mod dead_ends;
mod grid;
mod grown;
mod mesh;
mod polyanya;
mod prepared;
mod rays;
mod route;
mod safest;
mod sight;
mod tangent_graph;
mod tangents;
mod widest;

pub use crate::planner::MetricOptions;
pub use safest::{Safest, safest};
pub use widest::{Limit, Widest, widest};

use crate::error::{Code, Error};
use crate::geometry::{Point, wrap};
use crate::path::{LengthMeasure, length, split};
use crate::problem::Problem;
use crate::robot::DiscRobot;
use crate::scenario::{Obstacle, Query, Robot, World};
use crate::space::{MotionSpace, Space};
use crate::world::{PlanningWorld, SMALL};
use prepared::Prepared;
use serde::Serialize;

/// The tolerance of the proofs of a reference, as a fraction of the world's longer side: finer than that of runs.
const TOLERANCE: f64 = 1e-6;

/// How an optimum was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Method {
    /// A search of the tangent graph: the infimum of the lengths of all free paths.
    TangentGraph,
    /// A grid and shortcuts: the length of a path that is proven free. A shorter one may exist.
    Grid,
}

/// The shortest path of a query, in the order and under the names of its JSON form.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Optimum {
    /// The name of the scenario.
    pub scenario: String,
    /// The name of the query.
    pub query: String,
    /// How it was found.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"tangent-graph\" | \"grid\""))]
    pub method: Method,
    /// Whether no free path is shorter, but for 1e-12 of the world's size. If not, the length is that of a proven path.
    pub exact: bool,
    /// The distance between two lines of the grid along each coordinate, in its units; null if there is none.
    pub resolution: Option<[f64; 2]>,
    /// By how much obstacles count as larger, in metres: a passage that leaves less than this on both sides of the disc counts as
    /// closed. It is less than the slack of proofs and certificates, so that a passage which is closed for those may be open
    /// here. Null if not exact.
    pub slack: Option<f64>,
    /// The length; null without a path: none exists if `exact`, else the grid has none.
    pub length: Option<f64>,
    /// What the length measures, as in results of the same robot and `metric`.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "\"metres\" | \"sum-of-joints\" | \"euclidean-of-joints\" | \"weighted\"")
    )]
    pub length_measure: LengthMeasure,
    /// The configurations from the start to the goal. An exact path touches obstacles, and its arcs are replaced by chords of at
    /// most 0.05 radians, which are shorter.
    pub path: Vec<Vec<f64>>,
}

/// The shortest path of a query of the scenario, of the first one if none is named, in a metric of the robot.
///
/// Exact for a disc: see [`ShortestPaths`], which is prepared once for many queries. Else a reference, in some million proofs of
/// motions to a neighbour on a grid at most, and some thousand shortcuts.
///
/// # Errors
/// `unknown-query`; `out-of-range` for a metric of other robots (pointer `/metric`); `unsupported` for a car, an arm without
/// exactly two joints, a body that turns, and a query with a target; `start-in-collision`, `goal-in-collision`.
pub fn optimum(
    scenario: impl Into<PlanningWorld>,
    query: Option<&str>,
    options: MetricOptions,
) -> Result<Optimum, Error> {
    let (world, MetricOptions { metric }) = (scenario.into(), options);
    let (index, query) = world.scenario().find_query(query)?;
    let at_query = |error: Error| match error.code() {
        Code::StartInCollision | Code::GoalInCollision => error.under(&format!("/queries/{index}")),
        _ => error,
    };
    refuse_others(world.robot(), query)?;
    let space = MotionSpace::new(world.space::<SMALL>(metric)?);
    let goal = query.configuration().expect("a query with a target was refused");
    let (start, goal) = (space.state(&query.start), space.state(goal));
    let checker = world.checker(&space, TOLERANCE).fitted(&start, &goal);
    let problem = Problem::new(space.clone(), checker.validity(), start, goal).map_err(at_query)?;
    let found = |method, length, path| Optimum {
        scenario: world.scenario().name().to_owned(),
        query: query.name.clone(),
        method,
        exact: method == Method::TangentGraph,
        resolution: (method == Method::Grid).then(|| [0, 1].map(|i| grid::resolution(&space, i))),
        slack: None,
        length,
        length_measure: LengthMeasure::of(world.robot(), metric),
        path,
    };
    if let Robot::Disc(disc) = world.robot() {
        let ends = [start, goal].map(|q| Point::new(q[0], q[1]));
        let prepared = Prepared::new(world.scenario().world(), *world.bounds(), disc.kept_radius());
        let shortest = prepared.shortest(ends).map_err(at_query)?;
        let (length, points) = shortest.unzip();
        let path = points.unwrap_or_default().iter().map(|p| vec![p.x, p.y]).collect();
        let slack = Some(prepared.grown.larger);
        return Ok(Optimum { slack, ..found(Method::TangentGraph, length, path) });
    }
    let path = grid::reference(&problem).unwrap_or_default();
    let along = (!path.is_empty()).then(|| length(&space, &path));
    let rows = split(&space, &path).iter().map(|state| space.coordinates(state).to_vec()).collect();
    Ok(found(Method::Grid, along, rows))
}

/// The shortest paths of a disc, or of a point, between any two positions of a world, which is prepared once: exact.
///
/// The preparation takes O(n log n) for n corners, walls and discs, as a rule; a query looks at what lies near its path (Cui,
/// Harabor and Grastien 2017, "Compromise-free pathfinding on a navigation mesh", with circles in place of corners).
///
/// # Example
/// Around a square:
///
/// ```
/// use planarium::geometry::{Aabb, Point};
/// use planarium::optimum::ShortestPaths;
/// use planarium::robot::DiscRobot;
/// use planarium::scenario::{Obstacle, Query, Scenario, World};
///
/// let corners = [[4.0, 0.0], [6.0, 0.0], [6.0, 6.0], [4.0, 6.0]].map(|[x, y]| Point::new(x, y));
/// let world = World::new(Some(Aabb::of(Point::new(0.0, 0.0), Point::new(10.0, 10.0))), [Obstacle::polygon(&corners)?]);
/// let paths = ShortestPaths::new(&Scenario::new("square", world, DiscRobot::new(0.0)?, [])?)?;
/// let shortest = paths.query([1.0, 2.0], [9.0, 2.0])?.expect("a path");
/// assert!((shortest.length - 12.0).abs() < 1e-9);
/// assert_eq!(shortest.path.len(), 4);
/// # Ok::<(), planarium::Error>(())
/// ```
pub struct ShortestPaths {
    prepared: Prepared,
}

/// The shortest path between two positions.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[non_exhaustive]
pub struct Shortest {
    /// The length, in metres: the infimum of the lengths of all free paths.
    pub length: f64,
    /// Positions from the start to the goal, in metres. The path touches obstacles, and its arcs are replaced by chords of at
    /// most 0.05 radians.
    pub path: Vec<[f64; 2]>,
}

impl ShortestPaths {
    /// Prepares the world of a scenario for its disc.
    ///
    /// # Errors
    /// `unsupported` for other robots.
    pub fn new(scenario: impl Into<PlanningWorld>) -> Result<Self, Error> {
        let world = scenario.into();
        let Robot::Disc(disc) = world.robot() else {
            return Err(Error::new(Code::Unsupported, "/robot", "shortest paths are prepared for discs alone"));
        };
        Ok(Self { prepared: Prepared::new(world.scenario().world(), *world.bounds(), disc.kept_radius()) })
    }

    /// Prepares obstacles within bounds for a disc, whatever the robot of a scenario is. The world is not checked as that of a
    /// scenario is; a disc of radius 0 is a point.
    ///
    /// # Errors
    /// `missing-field` for a world without bounds; `not-finite` for coordinates that are not.
    pub fn among(world: &World, robot: &DiscRobot) -> Result<Self, Error> {
        let Some(bounds) = world.bounds else {
            return Err(Error::new(Code::MissingField, "/bounds", "a disc needs bounds"));
        };
        let around = world.obstacles.iter().map(Obstacle::aabb).fold(bounds, |around, aabb| around.union(&aabb));
        if ![around.min, around.max].iter().flat_map(|p| [p.x, p.y]).all(f64::is_finite) {
            return Err(Error::new(Code::NotFinite, "", "a coordinate of the world is not finite"));
        }
        Ok(Self { prepared: Prepared::new(world, bounds, robot.kept_radius()) })
    }

    /// Finds all tangents between obstacles beforehand. Preparation then takes up to about twelve times as long, and 128 bytes a
    /// tangent. The longest queries, around much of a large map, take a fifth to a thirtieth of the time; short ones may take
    /// longer. Lengths are the same but for rounding (after Oh and Leong 2017, "Edge N-level sparse visibility graphs: fast
    /// optimal any-angle pathfinding using hierarchical taut paths").
    ///
    /// To bound time and memory, a world with more than 500,000 tangents, or so open that its corners see more than 16 million
    /// triangles of the mesh and arcs in them, counted for every corner, stays as it is; then [`tangents`](Self::tangents) is
    /// `None`.
    pub fn for_many_queries(self) -> Self {
        Self { prepared: self.prepared.with_tangents() }
    }

    /// The number of tangents that are known beforehand; `None` if each query looks for its own.
    pub fn tangents(&self) -> Option<usize> {
        self.prepared.known()
    }

    /// The shortest path between two positions, in metres; `None` if there is none.
    ///
    /// # Errors
    /// `not-finite`; `start-in-collision`, `goal-in-collision`, also outside the bounds.
    pub fn query(&self, start: [f64; 2], goal: [f64; 2]) -> Result<Option<Shortest>, Error> {
        for (position, pointer) in [(start, "/start"), (goal, "/goal")] {
            if let Some(x) = position.iter().find(|x| !x.is_finite()) {
                return Err(Error::new(Code::NotFinite, pointer, format!("a coordinate is {x}")));
            }
        }
        let found = self.prepared.shortest([start, goal].map(|[x, y]| Point::new(x, y)))?;
        let shortest = |(length, points): (f64, Vec<Point>)| {
            let path = points.iter().map(|p| [p.x, p.y]).collect();
            Shortest { length, path }
        };
        Ok(found.map(shortest))
    }
}

/// Refuses a robot whose configurations have more than two coordinates that change.
///
/// # Errors
/// `unsupported`.
fn refuse_others(robot: &Robot, query: &Query) -> Result<(), Error> {
    let why = match (robot, query.configuration()) {
        (Robot::Car(_), _) => "a car".to_owned(),
        (Robot::Arm(arm), _) if arm.links().len() != 2 => format!("an arm with {} joints", arm.links().len()),
        (_, None) => "a query with a target".to_owned(),
        (Robot::RigidBody(_), Some(goal)) if wrap(query.start[2]) != wrap(goal[2]) => "a body that turns".to_owned(),
        _ => return Ok(()),
    };
    let served = "discs, arms of two joints, and rigid bodies that keep their angle, from a start to a goal";
    Err(Error::new(Code::Unsupported, "", format!("the shortest path of {why} is not known; served are {served}")))
}

/// The length of the shortest path of a disc by comparing all pairs of circles: slower and simpler, the oracle of the tests.
///
/// # Errors
/// As [`optimum`]; `too-large` for more than 4000 convex corners and discs, or more than 2,000,000 free tangents between them.
#[doc(hidden)]
pub fn by_all_tangents(scenario: impl Into<PlanningWorld>, query: Option<&str>) -> Result<Option<f64>, Error> {
    let world = scenario.into();
    let (_, query) = world.scenario().find_query(query)?;
    refuse_others(world.robot(), query)?;
    let Robot::Disc(disc) = world.robot() else {
        return Err(Error::new(Code::Unsupported, "", "tangents are compared for discs alone"));
    };
    let goal = query.configuration().expect("a query with a target was refused");
    let ends = [&query.start[..], goal].map(|q| Point::new(q[0], q[1]));
    let grown = grown::Grown::new(world.scenario().world(), *world.bounds(), disc.kept_radius());
    grown.check(ends)?;
    Ok(tangent_graph::shortest(&grown, ends)?.map(|(length, _)| length))
}
