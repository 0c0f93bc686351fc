//! One interval of a blend: which squares x of the rate of u, and which second derivatives r of u by time, are within the limits.
//!
//! Between two knots r is constant and x linear in u, and so is every q' r + q'' x: within its limit everywhere if it is at both
//! ends. Those are convex conditions on x at the first knot and r.

use super::limits::{Bound, dot};

/// The most steps of Newton's method and the halvings after them, of which few paths need any.
const STEPS: u32 = 16;
const HALVINGS: u32 = 48;

/// By how much less than the exact solution a value is taken, relative to it.
const INSIDE: f64 = 1e-12;

/// The condition |a r + b x| <= most on r and x, by numbers that are computed once.
#[derive(Debug, Clone, Copy)]
struct Condition {
    /// |a|^2, at least 0.
    size: f64,
    /// a b / |a|^2, and the product of the limit and of |a|^-1.
    middle: f64,
    half: f64,
    /// The square of |a x b| / |a|^2.
    across: f64,
}

impl Condition {
    fn new(a: [f64; 2], b: [f64; 2], most: f64) -> Self {
        let size = dot(a, a);
        let cross = a[0] * b[1] - a[1] * b[0];
        let across = cross / size;
        Self { size, middle: dot(a, b) / size, half: most / size.sqrt(), across: across * across }
    }

    /// Half the width of the range of r at x, and its derivative.
    fn half(&self, x: f64) -> [f64; 2] {
        if self.across == 0.0 {
            return [self.half, 0.0];
        }
        let half = (self.half * self.half - self.across * x * x).max(0.0).sqrt();
        [half, -self.across * x / half]
    }
}

/// The conditions on an interval.
#[derive(Debug, Clone)]
pub(super) struct Interval {
    conditions: Vec<Condition>,
    /// The greatest x at which every condition by itself has a solution.
    most: f64,
    /// Twice the length of the interval.
    twice: f64,
}

/// A bound on r, and its derivative by x.
type Side = [f64; 2];

impl Interval {
    /// That from `u` on, of this length.
    pub fn new(bounds: &[Bound], u: f64, length: f64) -> Self {
        let (mut conditions, mut most) = (Vec::with_capacity(2 * bounds.len()), f64::INFINITY);
        for bound in bounds {
            let (near, b) = (bound.at(u), bound.second);
            // At the second knot x is greater by 2 r length.
            let far = [0, 1].map(|i| near[i] + 3.0 * length * b[i]);
            for a in [near, far] {
                let size = dot(a, a).sqrt();
                let cross = (a[0] * b[1] - a[1] * b[0]).abs();
                let domain =
                    if size > 0.0 { bound.acceleration * size / cross } else { bound.acceleration / dot(b, b).sqrt() };
                // NaN where neither has a share in it.
                most = most.min(if domain.is_nan() { f64::INFINITY } else { domain });
                let condition = Condition::new(a, b, bound.acceleration);
                if condition.size > 0.0 {
                    conditions.push(condition);
                }
            }
        }
        Self { conditions, most: most * (1.0 - INSIDE), twice: 2.0 * length }
    }

    /// The range of r at x, if x at the second knot is to be within [0, next].
    fn range(&self, x: f64, next: f64) -> [Side; 2] {
        let slope = -1.0 / self.twice;
        let (mut low, mut high) = ([slope * x, slope], [slope * (x - next), slope]);
        for condition in &self.conditions {
            let [half, narrowing] = condition.half(x);
            let middle = -condition.middle * x;
            if middle - half > low[0] {
                low = [middle - half, -condition.middle - narrowing];
            }
            if middle + half < high[0] {
                high = [middle + half, -condition.middle + narrowing];
            }
        }
        [low, high]
    }

    /// How wide the range is, and its derivative: a concave function of x.
    fn width(&self, x: f64, next: f64) -> Side {
        let [low, high] = self.range(x, next);
        [high[0] - low[0], high[1] - low[1]]
    }

    /// The greatest x up to `cap` from which a knot with at most `next` can be reached. From any smaller x one can, too: the
    /// conditions are convex, and hold at rest. Newton's method comes down on the concave width from above.
    pub fn greatest(&self, cap: f64, next: f64) -> f64 {
        let mut x = cap.min(self.most);
        for _ in 0..STEPS {
            let [width, slope] = self.width(x, next);
            if width >= 0.0 {
                return x;
            }
            let below = (x - width / slope) * (1.0 - INSIDE);
            if !(below > 0.0 && below < x) {
                break;
            }
            x = below;
        }
        let (mut good, mut bad) = (0.0, x);
        // Again where speeds allow so much more than accelerations do that no x is found within so many halvings.
        while good == 0.0 && bad >= f64::MIN_POSITIVE {
            for _ in 0..HALVINGS {
                let middle = 0.5 * (good + bad);
                if self.width(middle, next)[0] >= 0.0 { good = middle } else { bad = middle }
            }
        }
        good
    }

    /// The greatest r at x with which the second knot has at most `next`; `None` if rounding leaves none.
    pub fn fastest(&self, x: f64, next: f64) -> Option<f64> {
        let [low, high] = self.range(x, next);
        (low[0] <= high[0]).then_some(high[0])
    }
}
