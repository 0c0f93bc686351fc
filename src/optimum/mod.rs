//! The ground truth beside a run: the shortest path of a query, or a reference where it is not known.
//!
//! | robot | method |
//! |---|---|
//! | a disc or a point | the tangent graph, exact (`tangent_graph.rs`, `circles.rs`) |
//! | an arm of two joints | a fine grid over the two joints, then shortcuts and finer grids around corners (`grid.rs`) |
//! | a rigid body whose query keeps its angle | the same over x and y, without turns |
//!
//! Other robots have none.
//!
//! Beside it, the widest disc that has a path (`widest/`).

mod circles;
mod grid;
mod tangent_graph;
mod widest;

pub use crate::planner::MetricOptions;
pub use widest::{Limit, Widest, widest};

use crate::error::{Code, Error};
use crate::geometry::{Point, wrap};
use crate::path::{LengthMeasure, length, split};
use crate::problem::Problem;
use crate::scenario::{Query, Robot};
use crate::space::{MotionSpace, Space};
use crate::world::{PlanningWorld, SMALL};
use serde::Serialize;

/// The tolerance of the proofs of a reference, as a fraction of the world's longer side: finer than that of runs.
const TOLERANCE: f64 = 1e-6;

/// How an optimum was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Method {
    /// The tangent graph: the infimum of the lengths of all free paths.
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
/// Exact for a disc, in O(n^2 log n) for n corners and discs. Else a reference, in some million proofs of motions to a neighbour
/// on a grid at most, and some thousand shortcuts.
///
/// # Errors
/// `unknown-query`; `out-of-range` for a metric of other robots (pointer `/metric`); `unsupported` for a car, an arm without
/// exactly two joints, a body that turns, and a query with a target; `start-in-collision`, `goal-in-collision`; `too-large` for
/// more than 4000 convex corners and discs, or more than 2,000,000 free tangents between them.
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
        let bounds = *world.bounds();
        let shortest =
            tangent_graph::shortest(world.scenario().world(), bounds, disc.kept_radius(), ends).map_err(at_query)?;
        let (length, points) = shortest.unzip();
        let path = points.unwrap_or_default().iter().map(|p| vec![p.x, p.y]).collect();
        let slack = Some(tangent_graph::larger(world.scenario().world(), &bounds, disc.kept_radius()));
        return Ok(Optimum { slack, ..found(Method::TangentGraph, length, path) });
    }
    let path = grid::reference(&problem).unwrap_or_default();
    let along = (!path.is_empty()).then(|| length(&space, &path));
    let rows = split(&space, &path).iter().map(|state| space.coordinates(state).to_vec()).collect();
    Ok(found(Method::Grid, along, rows))
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
