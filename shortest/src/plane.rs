//! The plane in which paths are sought: that of the numbers themselves, or one that lies at the ellipsoid.

use planarium::geometry::{Aabb, Point, metres_per_degree};

/// The most that a plane of degrees may distort distances, as a part of them.
pub const MAX_DISTORTION: f64 = 0.1;

/// Where the numbers of a map lie in a plane, in metres.
///
/// Degrees are scaled, east and north each by what a degree measures in the middle of the map on the ellipsoid WGS 84
/// (equirectangular projection), as `planarium import` does: a straight line of longitude and latitude stays one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// The position that becomes the origin.
    origin: [f64; 2],
    /// Metres per unit of each number.
    scale: [f64; 2],
    is_of_degrees: bool,
}

impl Plane {
    /// The plane whose numbers are x and y in metres.
    pub const METRES: Self = Self { origin: [0.0; 2], scale: [1.0; 2], is_of_degrees: false };

    /// The plane of degrees that fits in the middle between two corners.
    pub fn at_middle([low, high]: [[f64; 2]; 2]) -> Self {
        let origin = [0, 1].map(|i| (low[i] + high[i]) / 2.0);
        Self { origin, scale: metres_per_degree(origin[1]), is_of_degrees: true }
    }

    /// Where a position lies in the plane.
    pub fn point(&self, position: [f64; 2]) -> Point {
        let [x, y] = [0, 1].map(|i| (position[i] - self.origin[i]) * self.scale[i]);
        Point::new(x, y)
    }

    /// The position that lies at a point of the plane.
    pub fn position(&self, point: Point) -> [f64; 2] {
        if self.is_of_degrees {
            [point.x / self.scale[0] + self.origin[0], point.y / self.scale[1] + self.origin[1]]
        } else {
            [point.x, point.y]
        }
    }

    /// The most that the plane distorts distances between two latitudes, as a part of them: 0.01 is a hundredth.
    pub fn distortion(&self, [low, high]: [f64; 2]) -> f64 {
        if !self.is_of_degrees {
            return 0.0;
        }
        // A degree of longitude is longest at the equator, one of latitude shortest.
        let equator = (low < 0.0 && high > 0.0).then_some(0.0);
        let off = |latitude| {
            let there = metres_per_degree(latitude);
            [0, 1].map(|i| (there[i] / self.scale[i] - 1.0).abs()).into_iter().fold(0.0, f64::max)
        };
        [low, high].into_iter().chain(equator).map(off).fold(0.0, f64::max)
    }

    /// By how much the line between two points of the plane is longer on the ellipsoid, in metres.
    pub fn excess(&self, from: Point, to: Point) -> f64 {
        if !self.is_of_degrees {
            return 0.0;
        }
        let [from, to] = [from, to].map(|point| self.position(point));
        let [east, north] = [to[0] - from[0], to[1] - from[1]];
        let speed = |[across, along]: [f64; 2]| libm::hypot(across * east, along * north);
        // The rule of Gauss with three points: its error is below 1e-9 of the length for 10 degrees.
        let nodes = [(0.5 - 0.15_f64.sqrt(), 5.0), (0.5, 8.0), (0.5 + 0.15_f64.sqrt(), 5.0)];
        let sum: f64 =
            nodes.iter().map(|(part, weight)| weight * speed(metres_per_degree(from[1] + part * north))).sum();
        sum / 18.0 - speed(self.scale)
    }
}

/// The lowest and the highest of both numbers; `None` without a position.
pub(crate) fn corners(positions: impl IntoIterator<Item = [f64; 2]>) -> Option<[[f64; 2]; 2]> {
    let around = Aabb::around(positions.into_iter().map(Point::from))?;
    Some([around.min.into(), around.max.into()])
}
