//! Configuration spaces: metric, interpolation, sampling.
//!
//! A planner knows a space through the trait [`Space`] alone. [`ProductSpace`] is the product of circles, intervals and lines in
//! which arms, discs and bodies move; [`MotionSpace`] is the same with motions that may also be the curves of a car. A
//! program can plan in a space of its own: see [`Space`].
//!
//! - `product.rs`: [`ProductSpace`], its coordinates and its metrics. LaValle 2006, "Planning Algorithms", chapters 4 (products
//!   of circles and intervals) and 5.1 (metrics, weights of rotation);
//! - `motion.rs`: [`MotionSpace`], straight motions or the curves of [`steering`];
//! - `blend.rs`: lengths of rounded corners;
//! - `gap.rs`: distances on a line and on a circle, exact enough to bound a kd-tree.
//!
//! A state is a small `Copy` value in canonical form: finite, angles of circles in (-pi, pi], never -0. Arrays of `N` numbers
//! serve every dimension up to `N`: entries past [`Space::dimension`] are 0 and add exactly nothing.

mod blend;
mod gap;
mod lanes;
mod motion;
mod product;
pub mod steering;

pub use crate::geometry::{angular_distance, unwind, wrap};
pub use gap::{gap, gap_to_interval};
pub use lanes::Lanes;
pub use motion::MotionSpace;
pub use product::{Coordinate, Metric, ProductSpace};

use crate::random::Random;
use crate::space::steering::Curve;

/// The metrics of joints and discs that can be chosen by name.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    strum::EnumString,
    strum::IntoStaticStr,
    strum::VariantNames,
    serde::Serialize,
    serde::Deserialize,
)]
#[strum(serialize_all = "kebab-case")]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum MetricKind {
    /// The sum of the differences of the joints.
    Sum,
    /// The root of the sum of their squares.
    Euclidean,
    /// The same on circles cut open, as if no joint wrapped.
    Naive,
}

/// The most numbers that a configuration has.
pub const MAX_DIMENSION: usize = 8;

/// A configuration space.
///
/// A user-defined space needs the eight methods without a default. The defaults are right for any space without curves or
/// steered motions whose metric is symmetric. Nearest neighbours are then found by computing all distances, O(n) per query;
/// give [`norm`](Space::norm), [`period`](Space::period) and [`is_norm_exact`](Space::is_norm_exact) too, and a kd-tree
/// finds them.
///
/// # Example
/// A plane in which one moves along streets, around a wall:
///
/// ```
/// use planarium::planner::{Planner, PlannerKind, RrtConnectOptions, Status};
/// use planarium::problem::Problem;
/// use planarium::space::Space;
/// use planarium::problem::{Contact, Touched, Validity};
///
/// /// The unit square with the taxicab metric.
/// #[derive(Clone)]
/// struct Streets;
///
/// impl Space for Streets {
///     type State = [f64; 2];
///     fn dimension(&self) -> usize {
///         2
///     }
///     fn coordinates<'a>(&self, q: &'a [f64; 2]) -> &'a [f64] {
///         q
///     }
///     fn state(&self, numbers: &[f64]) -> [f64; 2] {
///         [numbers[0] + 0.0, numbers[1] + 0.0]
///     }
///     fn distance(&self, a: &[f64; 2], b: &[f64; 2]) -> f64 {
///         (a[0] - b[0]).abs() + (a[1] - b[1]).abs()
///     }
///     fn interpolate(&self, a: &[f64; 2], b: &[f64; 2], t: f64) -> [f64; 2] {
///         // First along x, then along y.
///         let [x, y] = [b[0] - a[0], b[1] - a[1]];
///         let along = t * self.distance(a, b);
///         if along <= x.abs() {
///             [a[0] + along.min(x.abs()) * x.signum(), a[1]]
///         } else if t < 1.0 {
///             [b[0], a[1] + (along - x.abs()) * y.signum()]
///         } else {
///             *b
///         }
///     }
///     fn at(&self, unit: &[f64]) -> [f64; 2] {
///         [unit[0], unit[1]]
///     }
///     fn contains(&self, q: &[f64; 2]) -> bool {
///         q.iter().all(|x| (0.0..=1.0).contains(x))
///     }
///     fn extent(&self) -> f64 {
///         2.0
///     }
/// }
///
/// /// A wall at 0.4 <= x <= 0.6, open above y = 0.8.
/// struct Wall;
///
/// impl Validity<[f64; 2]> for Wall {
///     fn contacts(&self, q: &[f64; 2]) -> Vec<Contact> {
///         let is_hit = (0.4..=0.6).contains(&q[0]) && q[1] <= 0.8;
///         is_hit.then_some(Contact { part: 0, with: Touched::Obstacle(0) }).into_iter().collect()
///     }
///     fn is_motion_free(&self, a: &[f64; 2], b: &[f64; 2]) -> bool {
///         // Along x at the height of `a`, then along y at the abscissa of `b`.
///         let [left, right] = [a[0].min(b[0]), a[0].max(b[0])];
///         let crosses = left <= 0.6 && right >= 0.4 && a[1] <= 0.8;
///         !crosses && self.is_free(b)
///     }
/// }
///
/// let problem = Problem::new(Streets, Box::new(Wall), [0.1, 0.1], [0.9, 0.1])?;
/// let mut planner = RrtConnectOptions { step: Some(0.1), ..Default::default() }.begin(&problem, 7)?;
/// let status = (1..=1000).map(|i| planner.iterate(&problem, i)).find(|&status| status != Status::Running);
/// assert_eq!(status, Some(Status::Solved));
/// # Ok::<(), planarium::Error>(())
/// ```
pub trait Space: Clone + Send + Sync {
    /// A configuration in canonical form: equal configurations are equal values.
    type State: Copy + Send + Sync + std::fmt::Debug + PartialEq;

    /// The number of coordinates of a configuration, 1 to [`MAX_DIMENSION`].
    fn dimension(&self) -> usize;

    /// The configuration's coordinates: `dimension` finite numbers.
    fn coordinates<'a>(&self, state: &'a Self::State) -> &'a [f64];

    /// The canonical state with the given finite coordinates; angles may have any number of turns.
    ///
    /// # Panics
    /// If there are fewer numbers than `dimension`.
    fn state(&self, coordinates: &[f64]) -> Self::State;

    /// The distance from `a` to `b`: finite, 0 for equal states, no longer than a detour but for rounding, and symmetric if
    /// [`Space::is_symmetric`].
    fn distance(&self, a: &Self::State, b: &Self::State) -> f64;

    /// The distance from `a` to `b` if that is at most `most`; else any number greater than `most`. The default is the distance;
    /// a space may find sooner that it is greater.
    #[inline]
    fn distance_within(&self, a: &Self::State, b: &Self::State, most: f64) -> f64 {
        let _ = most;
        self.distance(a, b)
    }

    /// How far apart two states are if curves do not matter: symmetric, finite, and 0 for equal states. The default is the
    /// distance; a space of curves returns the metric of its coordinates. By it the free state nearest to one in collision is
    /// found.
    fn straight_distance(&self, a: &Self::State, b: &Self::State) -> f64 {
        self.distance(a, b)
    }

    /// The state a fraction `t` in [0, 1] along the motion from `a` to `b`; exactly `a` at 0 and `b` at 1.
    fn interpolate(&self, a: &Self::State, b: &Self::State, t: f64) -> Self::State;

    /// The state at a point of the unit cube [0, 1)^dimension: points drawn uniformly give states drawn uniformly.
    ///
    /// # Panics
    /// If there are fewer numbers than `dimension`.
    fn at(&self, unit: &[f64]) -> Self::State;

    /// Whether the state lies within the limits of the space.
    fn contains(&self, state: &Self::State) -> bool;

    /// The largest distance between two states that are drawn, or a finite bound on it: it limits the steps of a greedy
    /// connection, and default step lengths are fractions of it.
    fn extent(&self) -> f64;

    /// A state drawn uniformly.
    fn sample(&self, random: &mut Random) -> Self::State {
        let mut unit = [0.0; MAX_DIMENSION];
        let unit = &mut unit[..self.dimension()];
        unit.iter_mut().for_each(|number| *number = random.uniform());
        self.at(unit)
    }

    /// The largest turn of a circle between the two states, in radians; 0 in a space without circles.
    fn turn(&self, a: &Self::State, b: &Self::State) -> f64 {
        let _ = (a, b);
        0.0
    }

    /// The largest turn of any coordinate that has the same meaning a whole turn later, in radians: it bounds the steps of a
    /// reported path, in which angles turn the short way round. Equal to [`Space::turn`] unless a circle was cut open.
    fn sweep(&self, a: &Self::State, b: &Self::State) -> f64 {
        self.turn(a, b)
    }

    /// The length of a whole turn of coordinate `i`: 2 pi on a circle, infinity if nothing wraps.
    fn period(&self, i: usize) -> f64 {
        let _ = i;
        f64::INFINITY
    }

    /// The metric as a function of the coordinates' gaps, for as many pairs of states at once as there are lanes: `gap(i)`
    /// returns those of coordinate `i`. With [`gap()`] between the coordinates of two states it is their `distance`, to the bit,
    /// or, if [`Space::is_norm_exact`] is false, a lower bound on it in either direction. It must not decrease when a gap grows,
    /// in floating point too, which holds for sums, products and roots of numbers that are not negative. So with
    /// [`gap_to_interval`] it is a lower bound on the distance to every state in a box. O(lanes x dimension).
    ///
    /// It must be a norm, subadditive and proportional to the gaps: an index computes it in single precision, bounds the error
    /// by the norm of the errors of the gaps, and measures only the states that may be among the nearest in double precision.
    /// A gap that is NaN must give NaN: an index fills its last vector with such gaps.
    ///
    /// The default is 0, a lower bound in every space, which an index cannot use.
    fn norm<T: Lanes>(&self, mut gap: impl FnMut(usize) -> T) -> T {
        T::splat(0.0) * gap(0)
    }

    /// Whether [`Space::norm`] is the distance, and not only a lower bound.
    #[inline]
    fn is_norm_exact(&self) -> bool {
        false
    }

    /// Whether every motion can be reversed, and `distance` is symmetric, to the bit. If not, `distance(a, b)` and all
    /// motions are directed from `a` to `b`.
    #[inline]
    fn is_symmetric(&self) -> bool {
        true
    }

    /// The curve that the motion from `a` to `b` follows, in spaces of steered motions; `None` if motions are straight in the
    /// coordinates. It ends at `b` but for rounding: see [`steering`].
    fn curve(&self, a: &Self::State, b: &Self::State) -> Option<Curve> {
        let _ = (a, b);
        None
    }

    /// By how much the parabola with these control points is shorter than the straight motions from the first to the second and
    /// on to the third. The default is 0, a lower bound.
    fn blend_saving(&self, blend: &[Self::State; 3]) -> f64 {
        let _ = blend;
        0.0
    }
}
