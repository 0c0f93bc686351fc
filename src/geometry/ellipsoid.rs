//! The ellipsoid WGS 84, on which longitude and latitude are measured.

use std::f64::consts::PI;

/// The larger half axis of the ellipsoid, in metres.
const EQUATOR: f64 = 6_378_137.0;

/// The square of its eccentricity: f (2 - f) with f = 1 / 298.257223563.
const ECCENTRICITY_SQUARED: f64 = 6.694_379_990_141_317e-3;

/// Metres per degree of longitude and of latitude on the ellipsoid WGS 84, at a latitude in degrees
/// (<https://en.wikipedia.org/wiki/Geographic_coordinate_conversion>).
pub fn metres_per_degree(latitude: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(latitude * (PI / 180.0));
    let curvature = 1.0 - ECCENTRICITY_SQUARED * sin * sin;
    let across = EQUATOR / curvature.sqrt();
    let along = across * (1.0 - ECCENTRICITY_SQUARED) / curvature;
    [across * cos * (PI / 180.0), along * (PI / 180.0)]
}
