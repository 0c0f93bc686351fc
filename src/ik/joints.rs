//! The joints of an arm: circles, or intervals that no coordinate leaves.

use crate::random::Random;
use crate::robot::{Arm, Joint, MAX_LINKS};
use crate::space::wrap;
use std::array::from_fn;
use std::f64::consts::{PI, TAU};

/// Computed angles up to this far outside the limits, in radians, mean the limit. The result is measured afterwards.
const SLACK: f64 = 1e-7;

/// The ranges of up to eight joints, in radians, or metres of prismatic ones; the rest of the arrays is 0.
#[derive(Debug, Clone)]
pub(super) struct Joints {
    pub count: usize,
    types: [Joint; MAX_LINKS],
    /// The lowest and the highest coordinate of each joint; of a circle, -pi and pi.
    pub ranges: [[f64; 2]; MAX_LINKS],
    /// The unit of each coordinate in the equations: a radian, or the reach of the arm in metres.
    units: [f64; MAX_LINKS],
}

impl Joints {
    /// The joints of the arm.
    pub fn of(arm: &Arm) -> Self {
        let (count, reach) = (arm.links().len(), arm.reach());
        let types = from_fn(|i| arm.joint_types().get(i).copied().unwrap_or(Joint::CIRCLE));
        let range = |i: usize| if i < count { types[i].range().unwrap_or([-PI, PI]) } else { [0.0; 2] };
        let unit = |i: usize| if types[i].is_prismatic() { reach } else { 1.0 };
        Self { count, types, ranges: from_fn(range), units: from_fn(unit) }
    }

    /// The joint.
    pub fn joint(&self, i: usize) -> &Joint {
        &self.types[i]
    }

    /// The unit of its coordinate in the equations: a radian, or the reach of the arm in metres.
    pub fn unit(&self, i: usize) -> f64 {
        self.units[i]
    }

    /// Whether the joint turns without limits.
    pub fn is_circle(&self, i: usize) -> bool {
        self.types[i] == Joint::CIRCLE
    }

    /// Whether a joint slides.
    pub fn has_prismatic(&self) -> bool {
        self.types.iter().any(Joint::is_prismatic)
    }

    /// Whether the joint can point its link in every direction: a circle, or limits a whole turn apart.
    pub fn turns_around(&self, i: usize) -> bool {
        let [low, high] = self.ranges[i];
        self.is_circle(i) || high - low >= TAU
    }

    /// The angle that differs from the given one by whole turns, lies within the limits, and is the nearest of these to `near`;
    /// `None` if there is none. On circles it is the one in (-pi, pi]. Up to 1e-7 outside counts as the limit itself.
    #[inline(never)]
    pub fn fit(&self, i: usize, angle: f64, near: f64) -> Option<f64> {
        if self.is_circle(i) {
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

    /// The coordinate within the limits that is nearest to the given one; on a circle the same angle in (-pi, pi].
    #[inline(never)]
    pub fn hold(&self, i: usize, angle: f64) -> f64 {
        if self.is_circle(i) {
            return wrap(angle);
        }
        // Not `clamp`, whose panic would link the formatting of floats.
        let [low, high] = self.ranges[i];
        angle.max(low).min(high) + 0.0
    }

    /// How far the joint moves from one coordinate to another, in its unit: in the shorter direction on a circle.
    pub fn turn(&self, i: usize, from: f64, to: f64) -> f64 {
        if self.is_circle(i) { wrap(to - from) } else { (to - from) / self.unit(i) }
    }

    /// The configuration within the limits nearest to the one with these coordinates, in canonical form.
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
