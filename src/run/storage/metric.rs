//! The metric that a roadmap was built in.

use super::damaged;
use crate::error::Error;
use crate::run::SpaceDescription;
use crate::space::steering::Steering;
use crate::space::{MAX_DIMENSION, MotionSpace, Space};
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// The metric of a roadmap, with everything needed to compute the length of an edge.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum RoadmapMetric {
    /// The sum of the joint differences.
    Sum,
    /// The root of the sum of their squares, or the distance of two points.
    Euclidean,
    /// The same without wrap-around.
    Naive,
    /// Of placements (x, y, theta): the weighted sum of how far they lie apart and how far one is turned against the other.
    Placement {
        /// The weight of a metre.
        translation: f64,
        /// The weight of a radian.
        rotation: f64,
    },
    /// Of placements of a car: the length of the shortest forward curve.
    Dubins {
        /// The turning radius, in metres.
        radius: f64,
    },
    /// The same of the shortest curve with cusps.
    ReedsShepp {
        /// The turning radius, in metres.
        radius: f64,
    },
    /// Of a custom robot: its space, with every weight and the metric.
    Space(SpaceDescription),
}

impl RoadmapMetric {
    /// The length of the curves of a car that turns no tighter than `radius` metres.
    pub fn of_curves(steering: Steering, radius: f64) -> Self {
        match steering {
            Steering::Dubins => RoadmapMetric::Dubins { radius },
            Steering::ReedsShepp => RoadmapMetric::ReedsShepp { radius },
        }
    }

    /// How the car is steered, and its turning radius, if edges are curves.
    pub fn curves(&self) -> Option<(Steering, f64)> {
        match *self {
            RoadmapMetric::Dubins { radius } => Some((Steering::Dubins, radius)),
            RoadmapMetric::ReedsShepp { radius } => Some((Steering::ReedsShepp, radius)),
            _ => None,
        }
    }

    /// The JSON form.
    pub(super) fn to_json(&self) -> String {
        serde_json::to_string(self).expect("words and numbers are JSON")
    }

    /// The JSON form as a tree.
    pub(super) fn to_tree(&self) -> Value {
        serde_json::from_str(&self.to_json()).expect("it has just been written")
    }

    /// Reads the JSON form.
    pub(super) fn parse(text: &str) -> Result<Self, Error> {
        let refuse = |_| damaged("/metric", format!("{text} is no metric of a roadmap"));
        serde_json::from_str(text).map_err(refuse).and_then(|tree| Self::read(&tree))
    }

    /// Reads the JSON form from a tree.
    pub(super) fn read(tree: &Value) -> Result<Self, Error> {
        let metric = Self::deserialize(tree);
        Ok(match metric.map_err(|_| damaged("/metric", format!("{tree} is no metric of a roadmap")))? {
            RoadmapMetric::Space(space) => RoadmapMetric::Space(space.without_negative_zero()),
            metric => metric,
        })
    }

    /// Refuses weights and radii that make no metric, and a space with other coordinates than those of the vertices.
    pub(super) fn check(&self, circles: &[bool]) -> Result<(), Error> {
        let is_sound = match *self {
            RoadmapMetric::Space(ref space) => return check_space(space, circles),
            RoadmapMetric::Sum | RoadmapMetric::Euclidean | RoadmapMetric::Naive => true,
            RoadmapMetric::Placement { translation, rotation } => {
                [translation, rotation].iter().all(|weight| weight.is_finite() && *weight >= 0.0)
            }
            RoadmapMetric::Dubins { radius } | RoadmapMetric::ReedsShepp { radius } => {
                radius.is_finite() && radius > 0.0
            }
        };
        if is_sound { Ok(()) } else { Err(damaged("/metric", format!("{self} is no metric"))) }
    }
}

fn check_space(space: &SpaceDescription, circles: &[bool]) -> Result<(), Error> {
    let read: MotionSpace<MAX_DIMENSION> =
        space.read().map_err(|error| damaged(format!("/metric{}", error.pointer()), error.message()))?;
    if *space != space.in_full() {
        return Err(damaged("/metric/space", "the space of a roadmap must have every weight and the metric"));
    }
    if !circles.iter().copied().eq((0..read.dimension()).map(|i| read.product().is_circle(i))) {
        return Err(damaged("/circles", "the circles are not those of the space"));
    }
    Ok(())
}

/// The JSON form, words without their quotes.
impl std::fmt::Display for RoadmapMetric {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.to_json().trim_matches('"'))
    }
}
