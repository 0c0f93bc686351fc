//! The safest path: that of the widest disc which passes, and of these the shortest.

use super::grown::larger;
use super::prepared::Prepared;
use super::widest::{Widest, ends, widest};
use crate::error::Error;
use crate::world::PlanningWorld;
use serde::Serialize;

/// By how much the disc of the path is narrower than the widest one, in `slack`s of that: first, and then as long as rounding
/// closes what it passes.
const NARROWER: [f64; 4] = [4.0, 16.0, 64.0, 256.0];

/// The safest path, in the order and under the names of its JSON form. Lengths are metres.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "full"), derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Safest {
    /// The widest disc that passes, and its bottleneck.
    #[serde(flatten)]
    pub widest: Widest,
    /// The distance that the path keeps from all obstacles and from the bounds: `radius` less 4 times `slack`, as a rule; never
    /// below 0. Null without a path.
    pub clearance: Option<f64>,
    /// The infimum of the lengths of all paths with that clearance; null if not even a point passes.
    pub length: Option<f64>,
    /// Positions from the start to the goal. Arcs are replaced by tangents of at most 0.05 radians, which are longer by 0.03 % at
    /// most and keep the clearance.
    pub path: Vec<[f64; 2]>,
}

/// The safest path of a query of the scenario, of the first one if none is named: no path has a larger least distance from
/// obstacles and bounds, and of those that have the same this is the shortest. Radius and margin of the scenario's robot do not
/// matter.
///
/// Where the limit is the start or the goal, the room there is all that a path can keep: elsewhere it comes as near to obstacles.
///
/// O(n log n) for n corners, points of walls and discs of usual worlds: [`widest`] and one search of [`ShortestPaths`].
///
/// # Errors
/// As [`widest`].
///
/// # Example
/// ```
/// use planarium::optimum::safest;
/// use planarium::scenario::Scenario;
///
/// let door = Scenario::parse(
///     r#"{ "format": "planarium-scenario-1", "name": "door",
///          "world": { "bounds": { "min": [0, 0], "max": [6, 4] }, "obstacles": [
///              { "type": "wall", "points": [[3, 0], [3, 1.5]], "width": 0 },
///              { "type": "wall", "points": [[3, 2.5], [3, 4]], "width": 0 } ] },
///          "robot": { "type": "disc", "radius": 0.2 },
///          "queries": [ { "name": "through", "start": [1, 1], "goal": [5, 1] } ] }"#,
/// )?;
/// let found = safest(&door, None)?;
/// assert!(found.clearance.is_some_and(|clearance| (clearance - 0.5).abs() < 1e-9));
/// // It goes through the middle of the door.
/// assert!(found.path.iter().any(|[x, y]| (x - 3.0).abs() < 0.05 && (y - 2.0).abs() < 1e-3));
/// # Ok::<(), planarium::Error>(())
/// ```
///
/// [`ShortestPaths`]: super::ShortestPaths
pub fn safest(scenario: impl Into<PlanningWorld>, query: Option<&str>) -> Result<Safest, Error> {
    let world = scenario.into();
    let widest = widest(&world, query)?;
    let Some(radius) = widest.radius else {
        return Ok(Safest { widest, clearance: None, length: None, path: Vec::new() });
    };
    let (_, query) = world.scenario().find_query(query)?;
    let ends = ends(world.robot(), query)?;
    let slack = larger(world.scenario().world(), world.bounds(), radius);
    for narrower in NARROWER {
        let clearance = (radius - narrower * slack).max(0.0);
        let prepared = Prepared::new(world.scenario().world(), *world.bounds(), clearance);
        // Rounding may refuse an end too, which is a limit.
        if let Ok(Some(route)) = prepared.route(ends) {
            let (length, points) = route.tangents(&prepared.grown);
            let path = points.iter().map(|p| [p.x, p.y]).collect();
            return Ok(Safest { widest, clearance: Some(clearance), length: Some(length), path });
        }
    }
    Ok(Safest { widest, clearance: None, length: None, path: Vec::new() })
}
