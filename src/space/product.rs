//! A product of circles, circles cut open, intervals and lines: the space of arms, discs and bodies, and of custom robots.
//!
//! LaValle 2006, "Planning Algorithms", sections 4.1.2 and 4.2 (products of circles and intervals) and 5.1.2 (metrics).

use super::{Lanes, Space, blend, gap, unwind, wrap};
use std::f64::consts::{PI, TAU};

/// The largest angle below 2 pi.
const LAST: f64 = TAU.next_down();

/// One coordinate of a configuration.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Coordinate {
    /// An angle that wraps: in (-pi, pi], differences the short way round.
    Circle,
    /// A circle cut open at 0: angles in [0, 2 pi), linear, nothing wraps. A naive measure, for comparison: 0.1
    /// and 6.2 are near each other on a circle and far apart here.
    CutCircle,
    /// A number between two limits, in radians or metres; linear, nothing wraps.
    Interval {
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
    /// A number without limits, linear. Samples are drawn between two numbers; motions may leave that range.
    Line {
        /// The least number drawn.
        low: f64,
        /// The greatest number drawn.
        high: f64,
    },
}

/// The combination of the distances of the coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Metric {
    /// Their sum.
    Sum,
    /// The square root of the sum of their squares.
    Euclidean,
    /// Of a placement (x, y, theta): the weighted sum of the Euclidean distance of (x, y) and the turn. With weights greater
    /// than 0 it is a metric.
    Placement {
        /// The weight of a metre.
        translation: f64,
        /// The weight of a radian.
        rotation: f64,
    },
}

/// A product of up to `N` circles, intervals and lines. Angles are in radians, lengths in metres.
#[derive(Debug, Clone, PartialEq)]
pub struct ProductSpace<const N: usize> {
    dimension: usize,
    /// The limits; infinite on a line.
    low: [f64; N],
    high: [f64; N],
    /// The range that samples are drawn from: the limits, except on a line.
    drawn: [[f64; 2]; N],
    /// A gap wider than this is shorter in the other direction: pi on a circle, infinite on an interval.
    half: [f64; N],
    is_cut: [bool; N],
    metric: Metric,
    /// The weights of the coordinates; `None` if all are 1.
    weights: Option<[f64; N]>,
}

impl<const N: usize> ProductSpace<N> {
    /// The space with the given coordinates.
    ///
    /// # Panics
    /// If there are more than `N` coordinates, or the range of one is empty.
    pub fn new(coordinates: &[Coordinate], metric: Metric) -> Self {
        assert!(coordinates.len() <= N, "at most {N} coordinates, not {}", coordinates.len());
        let (zeros, half) = ([0.0; N], [f64::INFINITY; N]);
        let mut space = Self {
            dimension: coordinates.len(),
            low: zeros,
            high: zeros,
            drawn: [[0.0; 2]; N],
            half,
            is_cut: [false; N],
            metric,
            weights: None,
        };
        for (i, coordinate) in coordinates.iter().enumerate() {
            match *coordinate {
                Coordinate::Circle => (space.low[i], space.high[i], space.half[i]) = (-PI, PI, PI),
                Coordinate::CutCircle => (space.high[i], space.is_cut[i]) = (LAST, true),
                Coordinate::Interval { low, high } => {
                    assert!(low < high, "an interval must not be empty");
                    (space.low[i], space.high[i]) = (low, high);
                }
                Coordinate::Line { low, high } => {
                    assert!(low < high, "the range of a line must not be empty");
                    (space.low[i], space.high[i]) = (f64::NEG_INFINITY, f64::INFINITY);
                    space.drawn[i] = [low, high];
                    continue;
                }
            }
            space.drawn[i] = [space.low[i], space.high[i]];
        }
        space
    }

    /// The same with a weight for each coordinate, by which its differences are multiplied in the metric.
    ///
    /// # Panics
    /// Unless there is a weight for each coordinate, greater than 0 and finite; or if the metric is that of placements, which has
    /// weights of its own.
    #[must_use]
    pub fn weighted(self, weights: &[f64]) -> Self {
        assert!(weights.len() == self.dimension, "one weight for each of {} coordinates", self.dimension);
        assert!(weights.iter().all(|&weight| weight > 0.0 && weight < f64::INFINITY), "weights are greater than 0");
        assert!(!matches!(self.metric, Metric::Placement { .. }), "the metric of placements has weights of its own");
        let is_plain = weights.iter().all(|&weight| weight == 1.0);
        let all = std::array::from_fn(|i| weights.get(i).copied().unwrap_or(1.0));
        Self { weights: (!is_plain).then_some(all), ..self }
    }

    /// A closed box with the Euclidean metric, in which motions are straight; coordinates in metres.
    ///
    /// # Panics
    /// If a side is empty, or there are more than `N`.
    pub fn of_box(low: &[f64], high: &[f64]) -> Self {
        let sides: Vec<Coordinate> =
            low.iter().zip(high).map(|(&low, &high)| Coordinate::Interval { low, high }).collect();
        Self::new(&sides, Metric::Euclidean)
    }

    /// The placements (x, y, theta) of a body whose origin stays in a box: two intervals in metres, a circle in radians.
    ///
    /// # Panics
    /// If a side is empty, or `N` is less than 3.
    pub fn of_placements(low: [f64; 2], high: [f64; 2], translation: f64, rotation: f64) -> Self {
        let side = |i: usize| Coordinate::Interval { low: low[i], high: high[i] };
        Self::new(&[side(0), side(1), Coordinate::Circle], Metric::Placement { translation, rotation })
    }

    /// The same coordinates with every circle cut open at 0: the naive space.
    #[must_use]
    pub fn cut_open(&self) -> Self {
        let coordinate = |i: usize| match self.range(i) {
            _ if self.is_circle(i) || self.is_cut[i] => Coordinate::CutCircle,
            [low, high] if self.high[i] == f64::INFINITY => Coordinate::Line { low, high },
            [low, high] => Coordinate::Interval { low, high },
        };
        let cut = Self::new(&(0..self.dimension).map(coordinate).collect::<Vec<_>>(), self.metric);
        Self { weights: self.weights, ..cut }
    }

    /// Whether coordinate `i` is a circle.
    pub fn is_circle(&self, i: usize) -> bool {
        self.half[i] == PI
    }

    /// The range of coordinate `i` that samples are drawn from: its limits, unless it is a line, which has none.
    pub fn range(&self, i: usize) -> [f64; 2] {
        self.drawn[i]
    }

    /// The signed difference of each coordinate from `a` to `b`, the short way round on circles.
    #[inline]
    pub fn difference(&self, a: &[f64; N], b: &[f64; N]) -> [f64; N] {
        std::array::from_fn(|i| {
            let d = b[i] - a[i];
            if d > self.half[i] {
                d - TAU
            } else if d < -self.half[i] {
                d + TAU
            } else {
                d
            }
        })
    }

    /// The metric as a function of the gaps of the first `count` coordinates: see [`Space::norm`].
    #[inline(always)]
    fn combine<T: Lanes>(&self, count: usize, mut gap: impl FnMut(usize) -> T) -> T {
        // One call of `gap`, so that it is inlined.
        let is_sum = self.metric == Metric::Sum;
        let (mut sum, mut turn) = (T::splat(0.0), T::splat(0.0));
        for i in 0..count {
            let mut gap = gap(i);
            if let Some(weights) = &self.weights {
                gap = T::splat(weights[i]) * gap;
            }
            if i == 2 && matches!(self.metric, Metric::Placement { .. }) {
                turn = gap;
                break;
            }
            sum = sum + if is_sum { gap } else { gap * gap };
        }
        match self.metric {
            Metric::Sum => sum,
            Metric::Euclidean => sum.sqrt(),
            Metric::Placement { translation, rotation } => {
                T::splat(translation) * sum.sqrt() + T::splat(rotation) * turn
            }
        }
    }
}

impl<const N: usize> Space for ProductSpace<N> {
    type State = [f64; N];

    fn dimension(&self) -> usize {
        self.dimension
    }

    #[inline]
    fn coordinates<'a>(&self, state: &'a [f64; N]) -> &'a [f64] {
        &state[..self.dimension]
    }

    fn state(&self, coordinates: &[f64]) -> [f64; N] {
        let mut state = [0.0; N];
        for i in 0..self.dimension {
            state[i] = if self.is_circle(i) {
                wrap(coordinates[i])
            } else if self.is_cut[i] {
                unwind(coordinates[i])
            } else {
                coordinates[i] + 0.0
            };
        }
        state
    }

    #[inline]
    fn distance(&self, a: &[f64; N], b: &[f64; N]) -> f64 {
        self.combine(N, |i| gap(a[i], b[i], self.period(i)))
    }

    #[inline]
    fn interpolate(&self, a: &[f64; N], b: &[f64; N], t: f64) -> [f64; N] {
        if t == 0.0 {
            return *a;
        }
        if t == 1.0 {
            return *b;
        }
        let turn = self.difference(a, b);
        std::array::from_fn(|i| {
            let angle = a[i] + t * turn[i];
            if angle > self.half[i] {
                angle - TAU
            } else if angle <= -self.half[i] {
                angle + TAU
            } else if self.half[i] == PI {
                angle + 0.0
            } else {
                // `clamp` would bring the standard library's printing of floats along.
                let angle = if angle < self.low[i] { self.low[i] } else { angle };
                (if angle > self.high[i] { self.high[i] } else { angle }) + 0.0
            }
        })
    }

    fn at(&self, unit: &[f64]) -> [f64; N] {
        let mut state = [0.0; N];
        for (i, angle) in state.iter_mut().enumerate().take(self.dimension) {
            let [low, high] = self.drawn[i];
            let along = (high - low) * unit[i];
            // From the top on a circle, so that pi can be drawn and -pi cannot.
            let drawn = if self.is_circle(i) { PI - along } else { low + along };
            *angle = drawn.min(high) + 0.0;
        }
        state
    }

    fn contains(&self, state: &[f64; N]) -> bool {
        (0..self.dimension).all(|i| {
            let (low, high) = (self.low[i], self.high[i]);
            state[i] >= low && state[i] <= high && !(self.is_circle(i) && state[i] == low)
        })
    }

    /// The largest distance between two states that are drawn.
    fn extent(&self) -> f64 {
        let longest = |i: usize| if self.is_circle(i) { PI } else { self.drawn[i][1] - self.drawn[i][0] };
        self.norm(longest)
    }

    fn turn(&self, a: &[f64; N], b: &[f64; N]) -> f64 {
        (0..self.dimension).filter(|&i| self.is_circle(i)).map(|i| gap(a[i], b[i], self.period(i))).fold(0.0, f64::max)
    }

    fn sweep(&self, a: &[f64; N], b: &[f64; N]) -> f64 {
        let cut = (0..self.dimension).filter(|&i| self.is_cut[i]);
        cut.map(|i| gap(a[i], b[i], self.period(i))).fold(self.turn(a, b), f64::max)
    }

    #[inline]
    fn period(&self, i: usize) -> f64 {
        2.0 * self.half[i]
    }

    #[inline]
    fn is_norm_exact(&self) -> bool {
        true
    }

    #[inline(always)]
    fn norm<T: Lanes>(&self, gap: impl FnMut(usize) -> T) -> T {
        self.combine(self.dimension, gap)
    }

    fn blend_saving(&self, [from, corner, to]: &[[f64; N]; 3]) -> f64 {
        let [before, after] = [(from, corner), (corner, to)].map(|(a, b)| {
            let difference = self.difference(a, b);
            let Some(weights) = &self.weights else { return difference };
            std::array::from_fn(|i| weights[i] * difference[i])
        });
        let saving = |first: usize, end: usize| blend::saving((first..end).map(|i| [before[i], after[i]]));
        match self.metric {
            Metric::Sum => (0..self.dimension).map(|i| saving(i, i + 1)).sum(),
            Metric::Euclidean => saving(0, self.dimension),
            Metric::Placement { translation, rotation } => translation * saving(0, 2) + rotation * saving(2, 3),
        }
    }
}
