//! From a scenario and parameters to an index: where names become types.

use super::held::Held;
use super::table::index_info;
use super::{MAX_CONFIGURATIONS, MAX_PLACES, Neighbours};
use crate::error::{Code, Error};
use crate::inspect::{Configurations, space_of};
use crate::nearest::{Forest, ForestParameters, KdTree, LinearScan};
use crate::parameters::{Parameters, Value};
use crate::random::{Random, Stream};
use crate::scenario::{Robot, Scenario};
use crate::space::{MAX_DIMENSION, Metric, MotionSpace};

/// The smaller size of states, as in [`crate::run`]; in WebAssembly one size serves all.
const SMALL: usize = if cfg!(target_arch = "wasm32") { MAX_DIMENSION } else { 4 };

/// An empty index of configurations of the scenario's robot: `linear`, `kd-tree` (where none is named) or `forest`, with the
/// parameters of [`super::indexes`]. The same planes follow from the same seed.
///
/// # Errors
/// `out-of-range` with the pointer `/index` for another id; `unknown-parameter`, `duplicate-field`, `wrong-type`, `not-finite` and
/// `out-of-range` of the parameters, with their pointers: the metric of a body or a car is its scenario's, that of a disc is
/// euclidean.
pub fn index(scenario: &Scenario, id: Option<&str>, given: &[(String, Value)]) -> Result<Box<dyn Neighbours>, Error> {
    let info = index_info(id)?;
    let parameters = Parameters::resolve(info.parameters, given)?;
    let metric = metric(scenario.robot(), parameters.text("metric"))?;
    let configurations = Configurations::of(scenario);
    Ok(if configurations.dimension() <= SMALL {
        held::<SMALL>(scenario, info.id, metric, configurations, &parameters)
    } else {
        held::<MAX_DIMENSION>(scenario, info.id, metric, configurations, &parameters)
    })
}

/// The metric of that name, and whether it is the naive one.
fn metric(robot: &Robot, word: Option<&str>) -> Result<(Metric, bool), Error> {
    let refuse = |sentence: String| Err(Error::new(Code::OutOfRange, "/metric", sentence));
    match (robot, word) {
        (Robot::RigidBody(_) | Robot::Car(_), Some(word)) => {
            refuse(format!("the metric of a body is its scenario's, not \"{word}\""))
        }
        (Robot::Disc(_), Some(word @ ("sum" | "naive"))) => {
            refuse(format!("the metric of a disc is always euclidean, not \"{word}\""))
        }
        (_, Some("euclidean")) => Ok((Metric::Euclidean, false)),
        (_, Some("naive")) => Ok((Metric::Euclidean, true)),
        _ => Ok((Metric::Sum, false)),
    }
}

/// The index over states of one size.
fn held<const N: usize>(
    scenario: &Scenario,
    id: &str,
    (metric, is_naive): (Metric, bool),
    configurations: Configurations,
    parameters: &Parameters,
) -> Box<dyn Neighbours> {
    let torus = space_of::<N>(scenario, metric);
    // The space of planners, so that its tree is compiled once.
    let space = MotionSpace::new(if is_naive { torus.cut_open() } else { torus });
    let most = MAX_CONFIGURATIONS;
    match id {
        "linear" => Box::new(Held { space, index: LinearScan::new(), configurations, most }),
        "kd-tree" => Box::new(Held { space, index: KdTree::new(), configurations, most }),
        "forest" => {
            let [trees, leaf, candidates] =
                ["trees", "leaf", "candidates"].map(|name| parameters.integer(name) as usize);
            let key = Random::new(parameters.integer("seed"), Stream::Projections).bits();
            let index = Forest::new(ForestParameters { trees, leaf, candidates }, key);
            Box::new(Held { space, index, configurations, most: most.min(MAX_PLACES / trees) })
        }
        other => unreachable!("the table lists {other}, nothing here makes it"),
    }
}
