//! A number in the key of a heap.

/// A cost, a distance, a time or a bound in a total order, for heaps and keys. It is at least 0 and may be infinite; NaN is no
/// such number, and -0 counts as 0. The bits of such floats are ordered as their values, so comparing costs as much as for
/// integers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Ordered(u64);

impl Ordered {
    /// The least number.
    pub const ZERO: Self = Self(0);

    /// A number that is not negative.
    #[inline]
    pub fn new(value: f64) -> Self {
        let value = value + 0.0;
        debug_assert!(value >= 0.0 && value.is_sign_positive(), "{value} has no place in the order");
        Self(value.to_bits())
    }

    /// The number.
    #[inline]
    pub fn value(self) -> f64 {
        f64::from_bits(self.0)
    }
}
