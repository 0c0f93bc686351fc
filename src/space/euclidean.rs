//! Euclidean space within a closed box.

use super::Space;

/// A closed box of `N` dimensions with the Euclidean metric; straight motions. Coordinates in metres.
#[derive(Debug, Clone, PartialEq)]
pub struct Euclidean<const N: usize> {
    low: [f64; N],
    high: [f64; N],
}

impl<const N: usize> Euclidean<N> {
    /// The box between the two corners.
    ///
    /// # Panics
    /// Where a side is negative or not a number.
    pub fn new(low: [f64; N], high: [f64; N]) -> Self {
        assert!((0..N).all(|i| low[i] <= high[i]), "the box from {low:?} to {high:?} is empty");
        Self { low, high }
    }
}

impl<const N: usize> Space for Euclidean<N> {
    type State = [f64; N];

    fn dimension(&self) -> usize {
        N
    }

    fn coordinates<'a>(&self, state: &'a [f64; N]) -> &'a [f64] {
        state
    }

    fn state(&self, coordinates: &[f64]) -> [f64; N] {
        std::array::from_fn(|i| coordinates[i] + 0.0)
    }

    #[inline]
    fn distance(&self, a: &[f64; N], b: &[f64; N]) -> f64 {
        let mut sum = 0.0;
        for i in 0..N {
            let gap = a[i] - b[i];
            sum += gap * gap;
        }
        sum.sqrt()
    }

    fn interpolate(&self, a: &[f64; N], b: &[f64; N], t: f64) -> [f64; N] {
        if t == 0.0 {
            return *a;
        }
        if t == 1.0 {
            return *b;
        }
        std::array::from_fn(|i| a[i] + t * (b[i] - a[i]) + 0.0)
    }

    fn at(&self, place: &[f64]) -> [f64; N] {
        std::array::from_fn(|i| self.low[i] + (self.high[i] - self.low[i]) * place[i] + 0.0)
    }

    fn contains(&self, state: &[f64; N]) -> bool {
        (0..N).all(|i| state[i] >= self.low[i] && state[i] <= self.high[i])
    }

    fn extent(&self) -> f64 {
        self.distance(&self.low, &self.high)
    }

    fn turn(&self, _: &[f64; N], _: &[f64; N]) -> f64 {
        0.0
    }

    #[inline]
    fn period(&self, _: usize) -> f64 {
        f64::INFINITY
    }

    #[inline(always)]
    fn norm<const L: usize>(&self, mut gap: impl FnMut(usize) -> [f64; L]) -> [f64; L] {
        let mut sum = [0.0; L];
        for i in 0..N {
            let gaps = gap(i);
            for lane in 0..L {
                sum[lane] += gaps[lane] * gaps[lane];
            }
        }
        sum.map(f64::sqrt)
    }
}
