//! The configuration space of each robot.

use super::{Arm, Joint, Weights};
use crate::geometry::{Aabb, Point, Polygon};
use crate::space::{Coordinate, Metric, ProductSpace};

/// The space of an arm: a circle for each joint without limits, an interval for any other; angles in radians, the coordinates of
/// prismatic joints in metres, a metre as far as a radian.
///
/// # Panics
/// If the arm has more than `N` links.
pub fn joint_space<const N: usize>(arm: &Arm, metric: Metric) -> ProductSpace<N> {
    let coordinate = |joint: &Joint| match joint.range() {
        Some([low, high]) => Coordinate::Interval { low, high },
        None => Coordinate::Circle,
    };
    let joints: Vec<Coordinate> = arm.joint_types().iter().map(coordinate).collect();
    ProductSpace::new(&joints, metric)
}

/// The space of a disc's centre: the bounds, in metres, with the Euclidean metric.
///
/// # Panics
/// If `N` is less than 2.
pub fn plane<const N: usize>(bounds: &Aabb) -> ProductSpace<N> {
    ProductSpace::of_box(&[bounds.min.x, bounds.min.y], &[bounds.max.x, bounds.max.y])
}

/// The space of a body's placements (x, y, theta): all at which the body can lie within the bounds.
///
/// # Panics
/// If `N` is less than 3.
pub fn placements<const N: usize>(shape: &Polygon, weights: Weights, bounds: &Aabb) -> ProductSpace<N> {
    // An origin outside the shape can lie outside the bounds, by no more than the shape reaches.
    let sides = if shape.contains(Point::origin()) { *bounds } else { bounds.grown(shape.reach()) };
    let Weights { translation, rotation } = weights;
    ProductSpace::of_placements([sides.min.x, sides.min.y], [sides.max.x, sides.max.y], translation, rotation)
}
