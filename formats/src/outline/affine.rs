//! Affine maps of space. Drawings lie in a plane of it, and what becomes of x and y counts.

use std::ops::Mul;

/// A point in space.
pub type P3 = [f64; 3];

/// A map: three columns, and where the origin goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Affine {
    pub columns: [P3; 3],
    pub origin: P3,
}

impl Affine {
    pub const IDENTITY: Self =
        Self { columns: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin: [0.0, 0.0, 0.0] };

    /// A map of the plane: x' = a x + c y + e, y' = b x + d y + f.
    pub fn plane([a, b, c, d, e, f]: [f64; 6]) -> Self {
        Self { columns: [[a, b, 0.0], [c, d, 0.0], [0.0, 0.0, 1.0]], origin: [e, f, 0.0] }
    }

    pub fn translation(origin: P3) -> Self {
        Self { origin, ..Self::IDENTITY }
    }

    pub fn scale([x, y, z]: P3) -> Self {
        Self { columns: [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]], ..Self::IDENTITY }
    }

    /// A turn about the z axis, in degrees. Quarters of a turn are exact.
    pub fn rotation(degrees: f64) -> Self {
        let (sin, cos) = sin_cos(degrees);
        Self::plane([cos, sin, -sin, cos, 0.0, 0.0])
    }

    /// Where a point goes.
    pub fn apply(&self, p: P3) -> P3 {
        let v = self.turn(p);
        std::array::from_fn(|i| v[i] + self.origin[i])
    }

    /// Where a difference of two points goes.
    pub fn turn(&self, [x, y, z]: P3) -> P3 {
        let [a, b, c] = self.columns;
        std::array::from_fn(|i| a[i] * x + b[i] * y + c[i] * z)
    }

    /// By how much the map stretches lengths of the plane z = 0 at most, and at least, seen along z. The square roots
    /// are rounded up by far more than an ulp.
    pub fn stretch(&self) -> [f64; 2] {
        let [[a, b, _], [c, d, _], _] = self.columns;
        let sum = norm([(a + d) / 2.0, (b - c) / 2.0]);
        let difference = norm([(a - d) / 2.0, (b + c) / 2.0]);
        [(sum + difference) * (1.0 + 1e-15), (sum - difference).abs()]
    }
}

impl Mul for Affine {
    type Output = Self;

    /// First the right one, then the left one.
    fn mul(self, right: Self) -> Self {
        Self { columns: right.columns.map(|column| self.turn(column)), origin: self.apply(right.origin) }
    }
}

/// Sine and cosine of degrees, exact for quarters of a turn, and the same on every platform.
pub fn sin_cos(degrees: f64) -> (f64, f64) {
    let turn = degrees % 360.0;
    match turn {
        0.0 => (0.0, 1.0),
        90.0 | -270.0 => (1.0, 0.0),
        180.0 | -180.0 => (0.0, -1.0),
        270.0 | -90.0 => (-1.0, 0.0),
        _ => libm::sincos(turn.to_radians()),
    }
}

/// The length of a vector, the same on every platform.
pub fn norm([x, y]: [f64; 2]) -> f64 {
    libm::hypot(x, y)
}
