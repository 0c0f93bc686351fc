//! From a scenario and parameters to an index: where names become types.

use super::held::Held;
use super::table::{ExactOptions, ForestOptions, IndexId};
use super::{MAX_CONFIGURATIONS, MAX_PLACES, Neighbours};
use crate::error::Error;
use crate::nearest::{Forest, ForestParameters, KdTree, LinearScan};
use crate::options::{Options, Value};
use crate::random::{Random, Stream};
use crate::space::{MAX_DIMENSION, MotionSpace};
use crate::world::{Configurations, PlanningWorld, SMALL};

/// An empty index of configurations of the scenario's robot: `linear`, `kd-tree` (where none is named) or `forest`, with the
/// parameters of [`super::indexes`]. The same planes follow from the same seed.
///
/// # Errors
/// `out-of-range` with the pointer `/index` for another id; `unknown-parameter`, `duplicate-field`, `wrong-type`, `not-finite` and
/// `out-of-range` of the parameters, with their pointers: the metric of a body or a car is its scenario's, that of a disc is
/// euclidean.
pub fn index(
    scenario: impl Into<PlanningWorld>,
    id: Option<&str>,
    given: &[(String, Value)],
) -> Result<Box<dyn Neighbours>, Error> {
    let world = scenario.into();
    let wanted = match IndexId::of(id)? {
        IndexId::Linear => Wanted::Linear(Options::read(given)?),
        IndexId::KdTree => Wanted::KdTree(Options::read(given)?),
        IndexId::Forest => Wanted::Forest(Options::read(given)?),
    };
    if world.robot().dimension() <= SMALL {
        held::<SMALL>(&world, wanted)
    } else {
        held::<MAX_DIMENSION>(&world, wanted)
    }
}

/// Which index, with its options.
enum Wanted {
    Linear(ExactOptions),
    KdTree(ExactOptions),
    Forest(ForestOptions),
}

/// The index over states of one size.
fn held<const N: usize>(world: &PlanningWorld, wanted: Wanted) -> Result<Box<dyn Neighbours>, Error> {
    let (Wanted::Linear(ExactOptions { measuring })
    | Wanted::KdTree(ExactOptions { measuring })
    | Wanted::Forest(ForestOptions { measuring, .. })) = wanted;
    // The space of planners, so that its tree is compiled once.
    let space = MotionSpace::new(world.space::<N>(measuring.metric)?);
    let configurations = Configurations::of(world);
    let most = MAX_CONFIGURATIONS;
    Ok(match wanted {
        Wanted::Linear(_) => Box::new(Held { space, index: LinearScan::new(), configurations, most }),
        Wanted::KdTree(_) => Box::new(Held { space, index: KdTree::new(), configurations, most }),
        Wanted::Forest(ForestOptions { trees, leaf, candidates, seed, .. }) => {
            let key = Random::new(seed, Stream::Projections).bits();
            let index = Forest::new(ForestParameters { trees, leaf, candidates }, key);
            Box::new(Held { space, index, configurations, most: most.min(MAX_PLACES / trees) })
        }
    })
}
