//! A product space whose motions are straight, or the curves of a car.

use super::{Lanes, ProductSpace, Space, gap};
use crate::space::steering::{Curve, Pose, Steering};

/// A [`ProductSpace`] with its motions. Without steering, motions and distances are those of the product, to the bit. With
/// steering a state is a placement (x, y, heading) and a motion is the shortest curve that a car can follow; distances are
/// metres along it. Curves may leave the box that (x, y) is drawn from: the collision checker decides whether that is free.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionSpace<const N: usize> {
    product: ProductSpace<N>,
    steering: Option<(Steering, f64)>,
}

impl<const N: usize> MotionSpace<N> {
    /// The space in which motions are those of the product.
    pub fn new(product: ProductSpace<N>) -> Self {
        Self { product, steering: None }
    }

    /// The space of a car with a turning radius of at least `radius` metres; its metric is the length of the curves.
    ///
    /// # Panics
    /// Unless the coordinates are two intervals and a circle, or if the radius is not greater than 0.
    pub fn steered(product: ProductSpace<N>, steering: Steering, radius: f64) -> Self {
        let circles: Vec<bool> = (0..product.dimension()).map(|i| product.is_circle(i)).collect();
        assert!(circles == [false, false, true], "only placements are steered");
        assert!(radius > 0.0, "a turning radius is greater than 0");
        Self { product, steering: Some((steering, radius)) }
    }

    /// The product of circles and intervals.
    pub fn product(&self) -> &ProductSpace<N> {
        &self.product
    }

    /// The steering and the least turning radius in metres; `None` if motions are straight.
    pub fn steering(&self) -> Option<(Steering, f64)> {
        self.steering
    }

    /// The shortest curve between two states.
    fn curve_of(&self, (steering, radius): (Steering, f64), a: &[f64; N], b: &[f64; N]) -> Curve {
        steering.shortest(pose(a), pose(b), radius)
    }
}

/// A lower bound on the length of a curve from the gaps of its ends.
#[inline(always)]
fn least<T: Lanes>(x: T, y: T, turn: T, radius: f64) -> T {
    (T::splat(radius) * turn).greater((x * x + y * y).sqrt())
}

/// A state as a pose.
fn pose<const N: usize>(state: &[f64; N]) -> Pose {
    Pose { x: state[0], y: state[1], heading: state[2] }
}

impl<const N: usize> Space for MotionSpace<N> {
    type State = [f64; N];

    fn dimension(&self) -> usize {
        self.product.dimension()
    }

    #[inline]
    fn coordinates<'a>(&self, state: &'a [f64; N]) -> &'a [f64] {
        self.product.coordinates(state)
    }

    fn state(&self, coordinates: &[f64]) -> [f64; N] {
        self.product.state(coordinates)
    }

    /// With steering O(1), about a microsecond.
    #[inline]
    fn distance(&self, a: &[f64; N], b: &[f64; N]) -> f64 {
        self.distance_within(a, b, f64::INFINITY)
    }

    #[inline]
    fn distance_within(&self, a: &[f64; N], b: &[f64; N], most: f64) -> f64 {
        let Some((steering, radius)) = self.steering else { return self.product.distance(a, b) };
        let [x, y, turn] = [0, 1, 2].map(|i| gap(a[i], b[i], self.product.period(i)));
        // A curve may fall short of its goal by rounding; the distance is never below its bound.
        steering.length_within(pose(a), pose(b), radius, most).max(least(x, y, turn, radius))
    }

    fn straight_distance(&self, a: &[f64; N], b: &[f64; N]) -> f64 {
        self.product.distance(a, b)
    }

    #[inline]
    fn interpolate(&self, a: &[f64; N], b: &[f64; N], t: f64) -> [f64; N] {
        let Some(steered) = self.steering.filter(|_| t != 0.0 && t != 1.0) else {
            return self.product.interpolate(a, b, t);
        };
        let curve = self.curve_of(steered, a, b);
        let at = curve.at(pose(a), t * curve.length());
        let mut state = [0.0; N];
        (state[0], state[1], state[2]) = (at.x, at.y, at.heading);
        state
    }

    fn at(&self, unit: &[f64]) -> [f64; N] {
        self.product.at(unit)
    }

    fn contains(&self, state: &[f64; N]) -> bool {
        self.product.contains(state)
    }

    /// With steering, the diagonal of the box and what turning can add. Reversing, a turn of a quarter at most, a line
    /// and a turn of a half at most lead everywhere, and centres are at most two radii farther apart than positions.
    /// Forwards alone, 2.658 half turns are enough (Savla, Frazzoli and Bullo 2005, "On the point-to-point and traveling
    /// salesperson problems for Dubins' vehicle").
    fn extent(&self) -> f64 {
        use std::f64::consts::PI;
        let Some((steering, radius)) = self.steering else { return self.product.extent() };
        let [width, height] = [0, 1].map(|i| self.product.range(i)[1] - self.product.range(i)[0]);
        let turning = if steering.is_symmetric() { 2.0 + 1.5 * PI } else { 2.658 * PI };
        (width * width + height * height).sqrt() + turning * radius
    }

    fn turn(&self, a: &[f64; N], b: &[f64; N]) -> f64 {
        if self.steering.is_some() { 0.0 } else { self.product.turn(a, b) }
    }

    fn sweep(&self, a: &[f64; N], b: &[f64; N]) -> f64 {
        if self.steering.is_some() { 0.0 } else { self.product.sweep(a, b) }
    }

    #[inline]
    fn period(&self, i: usize) -> f64 {
        self.product.period(i)
    }

    #[inline(always)]
    fn norm<T: Lanes>(&self, mut gap: impl FnMut(usize) -> T) -> T {
        let Some((_, radius)) = self.steering else { return self.product.norm(gap) };
        least(gap(0), gap(1), gap(2), radius)
    }

    #[inline]
    fn is_symmetric(&self) -> bool {
        self.steering.is_none_or(|(steering, _)| steering.is_symmetric())
    }

    #[inline]
    fn is_norm_exact(&self) -> bool {
        self.steering.is_none()
    }

    fn curve(&self, a: &[f64; N], b: &[f64; N]) -> Option<Curve> {
        self.steering.map(|steered| self.curve_of(steered, a, b))
    }

    fn blend_saving(&self, blend: &[[f64; N]; 3]) -> f64 {
        if self.steering.is_some() { 0.0 } else { self.product.blend_saving(blend) }
    }
}
