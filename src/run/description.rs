//! A space as a product of circles, intervals and lines, as a user describes it: plain values that are checked when they are
//! read.

use crate::error::{Code, Error, Number, within};
use crate::json;
use crate::scenario::LARGEST;
use crate::space::{Coordinate, MAX_DIMENSION, Metric, MetricKind, MotionSpace, ProductSpace};
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

/// The weights, reaches and resolutions that are read.
pub(super) const SIZES: RangeInclusive<f64> = 1e-6..=LARGEST;

/// The kind of a coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum CoordinateKind {
    /// An angle in (-pi, pi] that wraps.
    Circle,
    /// A number between two limits.
    Interval,
    /// A number without limits (but within 1e6 where it is given); samples are drawn between two numbers.
    Line,
}

/// A coordinate of a space: `low` and `high` are the limits of an interval, or the range that samples of a line are drawn from.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoordinateDescription {
    /// The kind.
    pub kind: CoordinateKind,
    /// The lower limit, at least -1e6; `None` for a circle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub low: Option<f64>,
    /// The upper limit, more than `low`, at most 1e6; `None` for a circle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub high: Option<f64>,
    /// By what differences are multiplied in the metric, 1e-6 to 1e6; 1 by default.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub weight: Option<f64>,
}

impl CoordinateDescription {
    /// An angle that wraps, in radians.
    pub fn circle() -> Self {
        Self { kind: CoordinateKind::Circle, low: None, high: None, weight: None }
    }

    /// A number between two limits.
    pub fn interval(low: f64, high: f64) -> Self {
        Self { kind: CoordinateKind::Interval, low: Some(low), high: Some(high), weight: None }
    }

    /// A number without limits, drawn between two numbers.
    pub fn line(low: f64, high: f64) -> Self {
        Self { kind: CoordinateKind::Line, ..Self::interval(low, high) }
    }

    /// The same with a weight.
    #[must_use]
    pub fn weighted(self, weight: f64) -> Self {
        Self { weight: Some(weight), ..self }
    }

    /// The coordinate and its weight.
    fn read(&self, pointer: &str) -> Result<(Coordinate, f64), Error> {
        let [low, high] = [("low", self.low), ("high", self.high)].map(|(name, limit)| {
            let pointer = format!("{pointer}/{name}");
            match (self.kind, limit) {
                (CoordinateKind::Circle, None) => Ok(0.0),
                (CoordinateKind::Circle, Some(_)) => {
                    Err(Error::new(Code::UnknownField, pointer, format!("a circle has no {name}")))
                }
                (_, None) => {
                    Err(Error::new(Code::MissingField, pointer, format!("the range of a coordinate needs {name}")))
                }
                (_, Some(limit)) => within(pointer, name, limit, -LARGEST..=LARGEST),
            }
        });
        let (low, high) = (low?, high?);
        if self.kind != CoordinateKind::Circle && low >= high {
            let sentence = format!("high must be greater than low {}, not {}", Number(low), Number(high));
            return Err(Error::new(Code::OutOfRange, format!("{pointer}/high"), sentence));
        }
        let weight = within(format!("{pointer}/weight"), "weight", self.weight.unwrap_or(1.0), SIZES)?;
        let coordinate = match self.kind {
            CoordinateKind::Circle => Coordinate::Circle,
            CoordinateKind::Interval => Coordinate::Interval { low, high },
            CoordinateKind::Line => Coordinate::Line { low, high },
        };
        Ok((coordinate, weight))
    }
}

/// A space as a product of coordinates.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpaceDescription {
    /// The coordinates, 1 to 8.
    pub coordinates: Vec<CoordinateDescription>,
    /// How their weighted differences combine; `euclidean` by default.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub metric: Option<MetricKind>,
}

impl SpaceDescription {
    /// The same with every weight and the metric, and without -0.
    pub(super) fn in_full(&self) -> Self {
        let mut full = self.clone().without_negative_zero();
        full.coordinates.iter_mut().for_each(|one| one.weight = Some(one.weight.unwrap_or(1.0)));
        full.metric = Some(self.metric.unwrap_or(MetricKind::Euclidean));
        full
    }

    /// The same with 0 in place of -0, which JSON does not tell apart.
    pub(super) fn without_negative_zero(mut self) -> Self {
        for one in &mut self.coordinates {
            [&mut one.low, &mut one.high].into_iter().flatten().for_each(|limit| *limit += 0.0);
        }
        self
    }

    /// The first field in which another space differs, as a JSON pointer into the description, and its values here and there.
    /// Both are described in full.
    pub(super) fn difference(&self, other: &Self) -> Option<(String, [String; 2])> {
        let [count, others] = [self, other].map(|space| space.coordinates.len());
        if count != others {
            return Some(("/coordinates".to_owned(), [count, others].map(|n| format!("{n} coordinates"))));
        }
        for (i, (a, b)) in self.coordinates.iter().zip(&other.coordinates).enumerate() {
            let fields = [
                ("kind", (a.kind != b.kind).then(|| [a.kind, b.kind].map(|kind| json::to_string(&kind)))),
                ("low", differing(a.low, b.low)),
                ("high", differing(a.high, b.high)),
                ("weight", differing(a.weight, b.weight)),
            ];
            if let Some((name, values)) = fields.into_iter().find_map(|(name, values)| Some((name, values?))) {
                return Some((format!("/coordinates/{i}/{name}"), values));
            }
        }
        let differs = self.metric != other.metric;
        differs.then(|| ("/metric".to_owned(), [self, other].map(|space| json::to_string(&space.metric))))
    }

    /// The space.
    ///
    /// # Errors
    /// `out-of-range`, `not-finite`, `missing-field` and `unknown-field`, with a pointer into `/space`.
    pub(super) fn read<const N: usize>(&self) -> Result<MotionSpace<N>, Error> {
        let count = self.coordinates.len();
        if !(1..=MAX_DIMENSION).contains(&count) {
            let sentence = format!("a space has 1 to {MAX_DIMENSION} coordinates, not {count}");
            return Err(Error::new(Code::OutOfRange, "/space/coordinates", sentence));
        }
        let read = |(i, one): (usize, &CoordinateDescription)| one.read(&format!("/space/coordinates/{i}"));
        let (coordinates, weights): (Vec<_>, Vec<_>) =
            self.coordinates.iter().enumerate().map(read).collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
        let product = |metric| ProductSpace::new(&coordinates, metric).weighted(&weights);
        Ok(MotionSpace::new(match self.metric.unwrap_or(MetricKind::Euclidean) {
            MetricKind::Sum => product(Metric::Sum),
            MetricKind::Euclidean => product(Metric::Euclidean),
            MetricKind::Naive => product(Metric::Euclidean).cut_open(),
        }))
    }
}

/// Two numbers as text, if they differ.
fn differing(a: Option<f64>, b: Option<f64>) -> Option<[String; 2]> {
    (a != b).then(|| [a, b].map(|number| number.map_or("none".to_owned(), |number| Number(number).to_string())))
}
