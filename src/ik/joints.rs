//! The joints of an arm as the solvers see them: circles, or intervals that no angle leaves.

use crate::random::Random;
use crate::robot::{Arm, MAX_LINKS};
use crate::space::wrap;
use std::f64::consts::{PI, TAU};

/// How far outside its limits, in radians, a computed angle still means the limit. What comes of it is measured afterwards.
const SLACK: f64 = 1e-7;

/// The ranges of up to eight joints, in radians; the rest of the arrays is 0.
#[derive(Debug, Clone)]
pub(super) struct Joints {
    /// How many there are.
    pub count: usize,
    low: [f64; MAX_LINKS],
    high: [f64; MAX_LINKS],
    are_circles: bool,
}

impl Joints {
    /// The joints of the arm.
    pub fn of(arm: &Arm) -> Self {
        let count = arm.links().len();
        let (mut low, mut high) = ([0.0; MAX_LINKS], [0.0; MAX_LINKS]);
        for i in 0..count {
            [low[i], high[i]] = arm.joint_limits().map_or([-PI, PI], |limits| limits[i]);
        }
        Self { count, low, high, are_circles: arm.joint_limits().is_none() }
    }

    /// Whether the joint can point its link anywhere: a circle, or limits a whole turn apart.
    pub fn turns_around(&self, i: usize) -> bool {
        self.are_circles || self.high[i] - self.low[i] >= TAU
    }

    /// The lowest and the highest angle of the joint, in radians; of a circle, -pi and pi.
    pub fn range(&self, i: usize) -> [f64; 2] {
        [self.low[i], self.high[i]]
    }

    /// Whether the joint is a circle.
    pub fn is_circle(&self) -> bool {
        self.are_circles
    }

    /// The angle that differs from the given one by whole turns, lies within the limits, and among those next to `near`;
    /// `None` where there is none. On circles it is the one in (-pi, pi]. Up to 1e-7 outside counts as the limit itself.
    #[inline(never)]
    pub fn fit(&self, i: usize, angle: f64, near: f64) -> Option<f64> {
        if self.are_circles {
            return Some(wrap(angle));
        }
        let [low, high] = self.range(i);
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
        // `clamp` would bring the standard library's printing of floats along.
        angle.max(self.low[i]).min(self.high[i]) + 0.0
    }

    /// The turn of the joint from one angle to another: the short way round on circles.
    pub fn turn(&self, from: f64, to: f64) -> f64 {
        if self.are_circles { wrap(to - from) } else { to - from }
    }

    /// The configuration nearest to `q` within the limits, in canonical form.
    #[inline(never)]
    pub fn hold_all(&self, q: &[f64; MAX_LINKS]) -> [f64; MAX_LINKS] {
        let mut held = [0.0; MAX_LINKS];
        for i in 0..self.count {
            held[i] = self.hold(i, q[i]);
        }
        held
    }

    /// All joints at 0, or as near to it as they may be.
    pub fn rest(&self) -> [f64; MAX_LINKS] {
        self.hold_all(&[0.0; MAX_LINKS])
    }

    /// A configuration drawn uniformly: one number a joint.
    pub fn draw(&self, random: &mut Random) -> [f64; MAX_LINKS] {
        let mut q = [0.0; MAX_LINKS];
        for (i, angle) in q.iter_mut().enumerate().take(self.count) {
            let [low, high] = self.range(i);
            *angle = self.hold(i, low + (high - low) * random.uniform());
        }
        q
    }
}
