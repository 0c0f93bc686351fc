//! B-splines as Bézier curves.

use crate::outline::{Curve, P3};

/// The highest degree.
pub const MAX_DEGREE: usize = 10;

/// The pieces of a B-spline of a degree over its knots, with control points and weights; `None` if knots, points and
/// degree do not fit each other, knots decrease, or a weight is not positive.
///
/// The control points of a piece are values of the blossom (Ramshaw 1989, Blossoms are polar forms), in homogeneous
/// coordinates.
pub fn pieces(degree: usize, knots: &[f64], points: &[(P3, f64)]) -> Option<Vec<Curve>> {
    let fits = (1..=MAX_DEGREE).contains(&degree) && points.len() > degree && knots.len() == points.len() + degree + 1;
    if !fits || knots.windows(2).any(|pair| pair[1] < pair[0]) || points.iter().any(|(_, weight)| *weight <= 0.0) {
        return None;
    }
    let homogeneous: Vec<[f64; 4]> = points.iter().map(|&([x, y, z], w)| [x * w, y * w, z * w, w]).collect();
    let mut curves = Vec::new();
    for i in degree..points.len() {
        let [from, to] = [knots[i], knots[i + 1]];
        if from == to {
            continue;
        }
        let mut controls = Vec::with_capacity(degree + 1);
        for j in 0..=degree {
            // The arguments are `from`, and `to` j times.
            let mut level = homogeneous[i - degree..=i].to_vec();
            for r in 1..=degree {
                let t = if r <= j { to } else { from };
                for k in (r..=degree).rev() {
                    let [low, high] = [knots[k + i - degree], knots[k + 1 + i - r]];
                    let part = (t - low) / (high - low);
                    level[k] = std::array::from_fn(|axis| (1.0 - part) * level[k - 1][axis] + part * level[k][axis]);
                }
            }
            let [x, y, z, w] = level[degree];
            controls.push(([x / w, y / w, z / w], w));
        }
        curves.push(Curve(controls));
    }
    Some(curves)
}
