//! The joints of an arm: circles, or intervals that no angle leaves.

use crate::random::Random;
use crate::robot::{Arm, MAX_LINKS};
use crate::space::wrap;
use std::array::from_fn;
use std::f64::consts::{PI, TAU};

/// Computed angles up to this far outside the limits, in radians, mean the limit. The result is measured afterwards.
const SLACK: f64 = 1e-7;

/// The ranges of up to eight joints, in radians; the rest of the arrays is 0.
#[derive(Debug, Clone)]
pub(super) struct Joints {
    pub count: usize,
    pub are_circles: bool,
    /// The lowest and the highest angle of each joint; of a circle, -pi and pi.
    pub ranges: [[f64; 2]; MAX_LINKS],
}

impl Joints {
    /// The joints of the arm.
    pub fn of(arm: &Arm) -> Self {
        let (count, limits) = (arm.links().len(), arm.joint_limits());
        let range = |i| if i < count { limits.map_or([-PI, PI], |limits| limits[i]) } else { [0.0; 2] };
        Self { count, are_circles: limits.is_none(), ranges: from_fn(range) }
    }

    /// Whether the joint can point its link in every direction: a circle, or limits a whole turn apart.
    pub fn turns_around(&self, i: usize) -> bool {
        let [low, high] = self.ranges[i];
        self.are_circles || high - low >= TAU
    }

    /// The angle that differs from the given one by whole turns, lies within the limits, and is the nearest of these to `near`;
    /// `None` if there is none. On circles it is the one in (-pi, pi]. Up to 1e-7 outside counts as the limit itself.
    #[inline(never)]
    pub fn fit(&self, i: usize, angle: f64, near: f64) -> Option<f64> {
        if self.are_circles {
            return Some(wrap(angle));
        }
        let [low, high] = self.ranges[i];
        let (least, most) = (libm::ceil((low - angle) / TAU), libm::floor((high - angle) / TAU));
        if least <= most {
            let turns = libm::round((near - angle) / TAU).max(least).min(most);
            return Some(self.hold(i, angle + turns * TAU));
        }
        if low - (angle + most * TAU) <= SLACK {
            Some(low + 0.0)
        } else if angle + least * TAU - high <= SLACK {
            Some(high + 0.0)
        } else {
            None
        }
    }

    /// The angle within the limits that is nearest to the given one; on a circle the same one in (-pi, pi].
    #[inline(never)]
    pub fn hold(&self, i: usize, angle: f64) -> f64 {
        if self.are_circles {
            return wrap(angle);
        }
        // Not `clamp`, whose panic would link the formatting of floats.
        let [low, high] = self.ranges[i];
        angle.max(low).min(high) + 0.0
    }

    /// The rotation of the joint from one angle to another: in the shorter direction on circles.
    pub fn turn(&self, from: f64, to: f64) -> f64 {
        if self.are_circles { wrap(to - from) } else { to - from }
    }

    /// The configuration within the limits nearest to the one with these angles, in canonical form.
    #[inline(never)]
    pub fn hold_all(&self, mut angle: impl FnMut(usize) -> f64) -> [f64; MAX_LINKS] {
        from_fn(|i| if i < self.count { self.hold(i, angle(i)) } else { 0.0 })
    }

    /// All joints at 0, or as near to it as they may be.
    pub fn rest(&self) -> [f64; MAX_LINKS] {
        self.hold_all(|_| 0.0)
    }

    /// A configuration drawn uniformly: one number per joint.
    pub fn draw(&self, random: &mut Random) -> [f64; MAX_LINKS] {
        self.hold_all(|i| {
            let [low, high] = self.ranges[i];
            low + (high - low) * random.uniform()
        })
    }
}
