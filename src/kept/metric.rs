//! How a document names a metric that is more than a word: that of placements by its weights, that of curves by how a car is steered.

use crate::decimal::Decimal;
use crate::json::Node;
use crate::steering::Steering;

/// How a document names the metric of placements (x, y, theta) with these weights.
pub fn placement_metric(translation: f64, rotation: f64) -> String {
    format!("{} translation + {} rotation", Decimal(translation), Decimal(rotation))
}

/// How a document names the length of the curves of a car that turns no tighter than `radius` metres.
pub fn curve_metric(steering: Steering, radius: f64) -> String {
    format!("{} of radius {}", steering.as_str(), Decimal(radius))
}

/// The weights in the name of a metric of placements.
pub(super) fn placement_weights(metric: &str) -> Option<[f64; 2]> {
    let (translation, rest) = metric.split_once(" translation + ")?;
    let rotation = rest.strip_suffix(" rotation")?;
    Some([number(translation)?, number(rotation)?])
}

/// The steering and the radius in the name of a metric of curves.
pub(super) fn curves(metric: &str) -> Option<(Steering, f64)> {
    let (word, radius) = metric.split_once(" of radius ")?;
    let steering = [Steering::Dubins, Steering::ReedsShepp].into_iter().find(|steering| steering.as_str() == word)?;
    Some((steering, number(radius).filter(|&radius| radius > 0.0)?))
}

fn number(text: &str) -> Option<f64> {
    if let Ok(Node::Number(number)) = Node::parse(text) { Some(number) } else { None }
}
