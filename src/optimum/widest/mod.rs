//! How wide a robot may be: the widest disc that passes from the start to the goal of a query, exact.
//!
//! All points within a distance r of an obstacle, or of what is outside the bounds, separate start and goal if, and only if, they
//! contain a closed curve that crosses the segment from start to goal an odd number of times. As r grows, borders that were apart
//! come into contact: half the length of the segment between them is the r at which they do. So these segments are added in
//! ascending order (`links.rs`), and with each place that is connected goes the parity of the crossings on the way to it
//! (`parity.rs`), until one closes an odd curve: it is the bottleneck. If none does before r is the clearance of the start or the
//! goal, that is the limit.
//!
//! That the segments suffice: borders are a union of segments, points and discs (`features.rs`), all convex, and so are all
//! points within r of each. A union of convex sets has the closed curves of the graph in which those are joined that share a
//! point (the nerve theorem), but for those around three with a common point, which enclose nothing.
//!
//! Sources: Kruskal 1956, "On the shortest spanning subtree of a graph and the traveling salesman problem" (edges in ascending
//! order); Ó'Dúnlaing and Yap 1985, "A 'retraction' method for planning the motion of a disc" (clearances are critical midway
//! between two obstacles); Gabriel and Sokal 1969, "A new statistical approach to geographic variation analysis" (which pairs
//! matter).

mod features;
mod links;
mod parity;

use super::grown::larger;
use crate::error::{Code, Error, Number};
use crate::geometry::{Aabb, Point, Segment, sort_stably};
use crate::problem::Touched;
use crate::scenario::{Query, Robot};
use crate::world::PlanningWorld;
use features::Features;
use links::{Link, Links};
use parity::Way;
use serde::Serialize;

/// What keeps wider discs from passing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Limit {
    /// A wider disc does not fit at the start.
    Start,
    /// A wider disc does not fit at the goal.
    Goal,
    /// A gap between two obstacles, two parts of one, or one and the bounds is too narrow.
    Gap,
    /// Obstacles in contact: not even a point passes.
    Closed,
}

/// The widest disc that passes, in the order and under the names of its JSON form. Lengths are metres.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "full"), derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Widest {
    /// The name of the scenario.
    pub scenario: String,
    /// The name of the query.
    pub query: String,
    /// The supremum of the radii of all discs that have a path, to 1e-12 of the world's size: a narrower disc passes, a wider one
    /// does not, and one of this radius only touches something. 0 if a point passes, but starts or ends on the bounds; null if
    /// not even a point passes.
    pub radius: Option<f64>,
    /// What keeps wider discs from passing.
    #[cfg_attr(
        all(target_arch = "wasm32", feature = "full"),
        tsify(type = "\"gap\" | \"start\" | \"goal\" | \"closed\"")
    )]
    pub limit: Limit,
    /// The ends of the narrowest gap, `[x, y]` each; or the start or the goal, and the point that is nearest to it. Null if not
    /// even a point passes.
    pub bottleneck: Option<[[f64; 2]; 2]>,
    /// The index of the obstacle at each end of the gap, or `bounds`; of the start or the goal, of what is nearest to it. Empty
    /// if there is no `bottleneck`.
    #[cfg_attr(all(target_arch = "wasm32", feature = "full"), tsify(type = "(number | \"bounds\")[]"))]
    pub between: Vec<Touched>,
    /// A gap of up to twice this counts as contact, as in a shortest path.
    pub slack: f64,
}

/// The widest disc that passes from the start to the goal of a query of the scenario, of the first one if none is named. Radius
/// and margin of the scenario's robot do not matter. Contact with an obstacle is collision, bounds may be touched.
///
/// O(n log n) for n corners, points of walls and discs of usual worlds; at worst every two of them are compared.
///
/// # Errors
/// `unknown-query`; `unsupported` for any robot but a disc, and for a query with a target; `start-in-collision`,
/// `goal-in-collision` if a point there is outside the bounds, or no farther from an obstacle than `slack`; `too-large` for more
/// than 4,000,000 contacts or gaps between neighbours.
///
/// # Example
/// ```
/// use planarium::optimum::{Limit, widest};
/// use planarium::scenario::Scenario;
///
/// let door = Scenario::parse(
///     r#"{ "format": "planarium-scenario-1", "name": "door",
///          "world": { "bounds": { "min": [0, 0], "max": [6, 4] }, "obstacles": [
///              { "type": "wall", "points": [[3, 0], [3, 1.5]], "width": 0 },
///              { "type": "wall", "points": [[3, 2.5], [3, 4]], "width": 0 } ] },
///          "robot": { "type": "disc", "radius": 0.2 },
///          "queries": [ { "name": "through", "start": [1, 2], "goal": [5, 2] } ] }"#,
/// )?;
/// let found = widest(&door, None)?;
/// assert_eq!((found.radius, found.limit), (Some(0.5), Limit::Gap));
/// assert_eq!(found.bottleneck, Some([[3.0, 1.5], [3.0, 2.5]]));
/// # Ok::<(), planarium::Error>(())
/// ```
pub fn widest(scenario: impl Into<PlanningWorld>, query: Option<&str>) -> Result<Widest, Error> {
    let world = scenario.into();
    let (index, query) = world.scenario().find_query(query)?;
    let [start, goal] = ends(world.robot(), query)?;
    let slack = larger(world.scenario().world(), world.bounds(), 0.0);
    for (what, at, code) in [("start", start, Code::StartInCollision), ("goal", goal, Code::GoalInCollision)] {
        if let Some(why) = collision(&world, at, slack) {
            let sentence = format!("the {what} [{}, {}] {why}", Number(at.x), Number(at.y));
            return Err(Error::new(code, format!("/queries/{index}/{what}"), sentence));
        }
    }
    let found = search(&world, Way { start, goal }, slack)?;
    let (limit, link, between) = match found {
        Found::Closed => (Limit::Closed, None, Vec::new()),
        Found::End(limit, room) => (limit, Some((room.distance, room.segment)), vec![room.with]),
        Found::Gap(link, between) => (Limit::Gap, Some((0.5 * link.gap, link.ends)), between.to_vec()),
    };
    Ok(Widest {
        scenario: world.scenario().name().to_owned(),
        query: query.name.clone(),
        radius: link.map(|(radius, _)| radius),
        limit,
        bottleneck: link.map(|(_, ends)| ends.map(|p| [p.x, p.y])),
        between,
        slack,
    })
}

/// Start and goal of a disc.
///
/// # Errors
/// `unsupported`.
pub(in crate::optimum) fn ends(robot: &Robot, query: &Query) -> Result<[Point; 2], Error> {
    let why = match (robot, query.configuration()) {
        (Robot::Disc(_), Some(goal)) => return Ok([&query.start[..], goal].map(|q| Point::new(q[0], q[1]))),
        (Robot::Disc(_), None) => "a query with a target",
        (Robot::Arm(_), _) => "an arm",
        (Robot::RigidBody(_), _) => "a rigid body",
        (Robot::Car(_), _) => "a car",
    };
    let sentence = format!("the widest robot is not known of {why}; served are discs, from a start to a goal");
    Err(Error::new(Code::Unsupported, "", sentence))
}

/// Why a point is in collision, for a sentence; `None` if it is free.
fn collision(world: &PlanningWorld, at: Point, slack: f64) -> Option<String> {
    let (here, obstacles) = (Segment::new(at, at), world.collision().obstacles());
    if world.bounds().depth(at) < 0.0 {
        return Some("is outside the bounds".to_owned());
    }
    let is_near = |i| obstacles.distance_within(i, &here, 2.0 * slack) <= slack;
    let touches = obstacles.any_near(&here.aabb().grown(slack), is_near);
    touches.then(|| format!("is no farther from an obstacle than {} m", Number(slack)))
}

/// What is nearest to the start or the goal.
#[derive(Debug, Clone, Copy)]
struct Room {
    distance: f64,
    segment: [Point; 2],
    with: Touched,
}

enum Found {
    Closed,
    End(Limit, Room),
    Gap(Link, [Touched; 2]),
}

fn search(world: &PlanningWorld, way: Way, slack: f64) -> Result<Found, Error> {
    let bounds = *world.bounds();
    let features = Features::new(&world.scenario().world().obstacles, &bounds);
    let [start, goal] = [way.start, way.goal].map(|at| room(&features, &bounds, at));
    let (limit, end) = if goal.distance < start.distance { (Limit::Goal, goal) } else { (Limit::Start, start) };
    if way.start == way.goal {
        return Ok(Found::End(limit, end));
    }
    let Links { mut found, mut parities, is_closed, .. } =
        Links::new(&features, bounds, way, 2.0 * slack, 2.0 * end.distance)?;
    if is_closed {
        return Ok(Found::Closed);
    }
    sort_stably(&mut found, |a, b| a.gap.total_cmp(&b.gap));
    let narrowest = found.into_iter().find(|link| !parities.join(link.places, link.is_odd));
    let of = |place: u32| features.vertices.get(place as usize).map_or(Touched::Bounds, |vertex| vertex.touched());
    Ok(match narrowest.filter(|link| link.gap < 2.0 * end.distance) {
        Some(link) => Found::Gap(link, link.places.map(of)),
        None => Found::End(limit, end),
    })
}

/// What is nearest to a point within the bounds and outside all obstacles.
fn room(features: &Features, bounds: &Aabb, at: Point) -> Room {
    let (Aabb { min, max }, point) = (bounds, Point::new);
    let sides = [point(min.x, at.y), point(max.x, at.y), point(at.x, min.y), point(at.x, max.y)];
    let to_side = |foot: Point| Room { distance: (foot - at).norm(), segment: [at, foot], with: Touched::Bounds };
    let nearest = features.nearest(at).map(|(distance, q, with)| Room { distance, segment: [at, q], with });
    let all = nearest.into_iter().chain(sides.into_iter().map(to_side));
    all.reduce(|a, b| if b.distance < a.distance { b } else { a }).expect("bounds have sides")
}
