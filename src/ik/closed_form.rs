//! The joint angles of simple arms in closed form: one joint, two joints, three joints with an orientation.

use super::nearest::nearest_configuration;
use super::task::Task;
use crate::error::{Code, Error};
use crate::robot::MAX_LINKS;

/// Below this angle of the elbow from straight or folded, in radians, the two solutions are one.
const MERGED: f64 = 1e-7;

/// Every configuration that reaches the target, within the limits, as near to `near` as whole turns bring it: none if it is out
/// of reach, two if the elbow can be on either side (first bent counter-clockwise), one if the arm is straight or folded. If two
/// links of the same length fold back to the base, any first angle is a solution, and that of `near` is used. An orientation
/// fixes the last link, and the others reach for its joint. Errors are at most `tolerance`, in metres and radians; for targets
/// that can be reached exactly they are below 1e-12 of the reach and the base's coordinates. If the limits exclude all of these,
/// the exact search decides: near folded arms the first angle follows from rounding alone, and another one may be valid.
pub(super) fn closed_form(
    task: &Task,
    near: &[f64; MAX_LINKS],
    tolerance: f64,
) -> Result<Vec<[f64; MAX_LINKS]>, Error> {
    if task.joints.has_prismatic() {
        let sentence = "there is no closed form for an arm with a prismatic joint; choose another method";
        return Err(Error::new(Code::Unsupported, "/method", sentence));
    }
    let (wrist, count) = task.wrist();
    let mut found = Vec::new();
    match count {
        1 => found.push([libm::atan2(wrist[1], wrist[0]), 0.0]),
        2 => elbows([task.links[0], task.links[1]], wrist, near[0], &mut found),
        _ => {
            let sentence =
                "there is a closed form for 1 or 2 links, or for 2 or 3 with an orientation; choose another method";
            return Err(Error::new(Code::Unsupported, "/method", sentence));
        }
    }
    let complete = |first: &[f64; 2]| {
        let mut q = [0.0; MAX_LINKS];
        for i in 0..count {
            q[i] = task.joints.fit(i, first[i], near[i])?;
        }
        if let Some(wanted) = task.orientation {
            let last = wanted - q[..count].iter().sum::<f64>();
            q[count] = task.joints.fit(count, last, near[count])?;
        }
        (task.deviation(&q).error() <= tolerance).then_some(q)
    };
    let mut solutions: Vec<_> = found.iter().filter_map(complete).collect();
    if solutions.is_empty() {
        let mut q = nearest_configuration(task);
        if task.deviation(&q).error() <= tolerance {
            for i in 0..task.joints.count {
                q[i] = task.joints.fit(i, q[i], near[i]).unwrap_or(q[i]);
            }
            solutions.push(q);
        }
    }
    Ok(solutions)
}

/// Both pairs of angles of two links that reach a point at the distance r, by Heron's formula in factors: nothing cancels
/// near the rim of the ring or near its centre.
fn elbows([a, b]: [f64; 2], [x, y]: [f64; 2], any: f64, found: &mut Vec<[f64; 2]>) {
    let r = (x * x + y * y).sqrt();
    if r == 0.0 {
        if a == b {
            found.push([any, std::f64::consts::PI]);
        }
        return;
    }
    // Four times the area of the triangle; outside the ring the arm is straight or folded.
    let area = ((a + b + r) * (a + b - r) * (r + (a - b)) * (r - (a - b))).max(0.0).sqrt();
    let towards = libm::atan2(y, x);
    let shoulder = libm::atan2(area, r * r + (a - b) * (a + b));
    let elbow = libm::atan2(area, (r - a) * (r + a) - b * b);
    found.push([towards - shoulder, elbow]);
    if elbow > MERGED && elbow < std::f64::consts::PI - MERGED {
        found.push([towards + shoulder, -elbow]);
    }
}
