//! An arm and a target: the deviation of the tip from the target, and how it moves with the joints.

use super::joints::Joints;
use crate::error::{Code, Error};
use crate::robot::{Arm, LARGEST, MAX_LINKS, Target, check_range};
use crate::space::wrap;
use crate::world::Configurations;

/// Errors below this fraction of the reach and the coordinates are rounding.
const FINEST: f64 = 1e-12;

/// The weight of a radian of the orientation against a metre of the tip, as a fraction of the reach.
const LEVER: f64 = 0.3;

/// An arm with its base moved to the origin, and a target.
#[derive(Debug, Clone)]
pub(super) struct Task {
    /// The lengths of the links, in metres, of prismatic ones at the coordinate 0; 0 past the last.
    pub links: [f64; MAX_LINKS],
    pub joints: Joints,
    /// The sum of the greatest lengths, in metres.
    pub reach: f64,
    /// The weight of a radian of the orientation, in metres.
    pub lever: f64,
    /// The target relative to the base, in metres.
    pub point: [f64; 2],
    /// The wanted absolute angle of the last link, in (-pi, pi].
    pub orientation: Option<f64>,
    /// The smallest meaningful error: 1e-12 times the reach plus the largest coordinate of the base.
    pub finest: f64,
}

/// How far a configuration is from the target.
#[derive(Debug, Clone, Copy)]
pub(super) struct Deviation {
    /// From the tip to the target in metres, and the rotation to the wanted orientation times the lever; 0 without one.
    pub vector: [f64; 3],
    /// From the tip to the point, in metres.
    pub distance: f64,
    /// The rotation that the last link lacks, in radians, 0 or more.
    pub turn: f64,
}

impl Deviation {
    /// The larger of the distance (metres) and the turn (radians).
    pub fn error(&self) -> f64 {
        self.distance.max(self.turn)
    }

    /// The squared norm of the vector.
    pub fn square(&self) -> f64 {
        let [x, y, z] = self.vector;
        x * x + y * y + z * z
    }
}

/// The linear model of a task at a configuration.
#[derive(Debug, Clone)]
pub(super) struct Linear {
    /// See [`Deviation`].
    pub vector: [f64; 3],
    /// How the tip (metres) and the last link (radians times the lever) move with each joint, in its unit.
    pub jacobian: [[f64; MAX_LINKS]; 3],
    /// 2, or 3 with an orientation.
    pub rows: usize,
}

impl Task {
    /// The task of bringing the arm's tip to a checked target.
    pub fn new(arm: &Arm, target: &Target) -> Self {
        let mut links = [0.0; MAX_LINKS];
        links[..arm.links().len()].copy_from_slice(arm.links());
        let (base, reach) = (arm.base(), arm.reach());
        let point = [target.point.x - base.x, target.point.y - base.y];
        let finest = FINEST * (reach + base.x.abs().max(base.y.abs()));
        Self {
            links,
            joints: Joints::of(arm),
            reach,
            lever: LEVER * reach,
            point,
            orientation: target.orientation,
            finest,
        }
    }

    /// The positions of the joints relative to the base, and of the tip.
    #[inline(never)]
    fn positions(&self, q: &[f64; MAX_LINKS]) -> [[f64; 2]; MAX_LINKS + 1] {
        let mut positions = [[0.0; 2]; MAX_LINKS + 1];
        let mut angle = 0.0;
        for i in 0..self.joints.count {
            let joint = self.joints.joint(i);
            angle += joint.angle(q[i]);
            let length = self.links[i] + joint.extension(q[i]);
            let (sin, cos) = libm::sincos(angle);
            let [x, y] = positions[i];
            positions[i + 1] = [x + length * cos, y + length * sin];
        }
        positions
    }

    /// The angle of the last link, in radians, not wrapped.
    fn last_angle(&self, q: &[f64; MAX_LINKS]) -> f64 {
        (0..MAX_LINKS).map(|i| self.joints.joint(i).angle(q[i])).sum()
    }

    /// How far the configuration is from the target. O(links).
    #[inline(never)]
    pub fn deviation(&self, q: &[f64; MAX_LINKS]) -> Deviation {
        self.deviation_at(q, self.positions(q)[self.joints.count])
    }

    fn deviation_at(&self, q: &[f64; MAX_LINKS], tip: [f64; 2]) -> Deviation {
        let [x, y] = [self.point[0] - tip[0], self.point[1] - tip[1]];
        let turn = self.orientation.map_or(0.0, |wanted| wrap(wanted - self.last_angle(q)));
        Deviation { vector: [x, y, self.lever * turn], distance: (x * x + y * y).sqrt(), turn: turn.abs() }
    }

    /// The linear model at the configuration. O(links).
    pub fn linear(&self, q: &[f64; MAX_LINKS]) -> Linear {
        let positions = self.positions(q);
        let count = self.joints.count;
        let (mut jacobian, tip) = ([[0.0; MAX_LINKS]; 3], positions[count]);
        let mut angle = 0.0;
        for i in 0..count {
            let joint = self.joints.joint(i);
            angle += joint.angle(q[i]);
            if joint.is_prismatic() {
                let ((sin, cos), unit) = (libm::sincos(angle), self.joints.unit(i));
                (jacobian[0][i], jacobian[1][i]) = (unit * cos, unit * sin);
                continue;
            }
            jacobian[0][i] = positions[i][1] - tip[1];
            jacobian[1][i] = tip[0] - positions[i][0];
            if self.orientation.is_some() {
                jacobian[2][i] = self.lever;
            }
        }
        let rows = if self.orientation.is_some() { 3 } else { 2 };
        Linear { vector: self.deviation_at(q, tip).vector, jacobian, rows }
    }

    /// The inner and the outer radius, in metres, of the ring that the tip of the first `count` links can reach without joint
    /// limits; with a prismatic joint of one that holds it.
    pub fn ring(&self, count: usize) -> [f64; 2] {
        if self.joints.has_prismatic() {
            return [0.0, self.reach];
        }
        let links = &self.links[..count];
        let (sum, longest) = (links.iter().sum::<f64>(), links.iter().copied().fold(0.0, f64::max));
        [(longest - (sum - longest)).max(0.0), sum]
    }

    /// The position of the last joint that a wanted orientation requires, relative to the base, or the target without one or
    /// if a joint is prismatic; and the number of links up to it.
    pub fn wrist(&self) -> ([f64; 2], usize) {
        let count = self.joints.count;
        match self.orientation {
            Some(angle) if !self.joints.has_prismatic() => {
                let (sin, cos) = libm::sincos(angle);
                let last = self.links[count - 1];
                ([self.point[0] - last * cos, self.point[1] - last * sin], count - 1)
            }
            _ => (self.point, count),
        }
    }
}

impl Target {
    /// Checks a target for this arm; brings its orientation into (-pi, pi].
    ///
    /// # Errors
    /// `not-finite` or `out-of-range` (beyond 1e6), pointers `/target/0`, `/target/1` and `/orientation`; `unsupported`,
    /// pointer `/orientation`, for an orientation of an arm of one link, whose position fixes its orientation.
    pub(super) fn checked(mut self, arm: &Arm) -> Result<Self, Error> {
        for i in 0..2 {
            check_range(&format!("/target/{i}"), "a coordinate of the target", self.point[i], -LARGEST)?;
            self.point[i] += 0.0;
        }
        if let Some(angle) = &mut self.orientation {
            check_range("/orientation", "the orientation", *angle, -LARGEST)?;
            *angle = wrap(*angle);
            if arm.links().len() < 2 {
                let sentence = "an arm of one link has no free orientation: the position of its tip fixes it";
                return Err(Error::new(Code::Unsupported, "/orientation", sentence));
            }
        }
        Ok(self)
    }
}

/// A configuration of the arm, checked and in canonical form: angles of circles in (-pi, pi]. Errors have pointers below
/// `pointer`.
pub(super) fn configuration(arm: &Arm, q: &[f64], pointer: &str) -> Result<[f64; MAX_LINKS], Error> {
    Configurations::of_arm(arm).refuse_outside(q, pointer)?;
    Ok(Joints::of(arm).hold_all(|i| q[i]))
}
