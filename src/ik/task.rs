//! An arm and a target: how far the tip is from it, and how it moves with the joints.

use super::joints::Joints;
use super::target::Target;
use crate::robot::{Arm, MAX_LINKS};
use crate::space::wrap;

/// Errors below this fraction of the reach and the coordinates are rounding.
const FINEST: f64 = 1e-12;

/// What a radian of the orientation counts against a metre of the tip, as a part of the reach.
const LEVER: f64 = 0.3;

/// An arm with its base moved to the origin, and a target.
#[derive(Debug, Clone)]
pub(super) struct Task {
    /// The lengths of the links, in metres; 0 past the last.
    pub links: [f64; MAX_LINKS],
    /// The joints.
    pub joints: Joints,
    /// The sum of the lengths, in metres.
    pub reach: f64,
    /// What a radian of the orientation counts, in metres.
    pub lever: f64,
    /// The target from the base, in metres.
    pub point: [f64; 2],
    /// The wanted absolute angle of the last link, in (-pi, pi].
    pub orientation: Option<f64>,
    /// The smallest error that means something: 1e-12 times the reach plus the largest coordinate of the base.
    pub finest: f64,
}

/// How far a configuration is from the target.
#[derive(Debug, Clone, Copy)]
pub(super) struct Deviation {
    /// From the tip to the target in metres, and where an orientation is wanted the turn to it times the lever; else 0.
    pub vector: [f64; 3],
    /// How far the tip is from the point, in metres.
    pub distance: f64,
    /// How far the last link has to turn, in radians, 0 or more.
    pub turn: f64,
}

impl Deviation {
    /// The larger of the distance (metres) and the turn (radians).
    pub fn error(&self) -> f64 {
        self.distance.max(self.turn)
    }

    /// The square of the vector.
    pub fn square(&self) -> f64 {
        let [x, y, z] = self.vector;
        x * x + y * y + z * z
    }
}

/// The linear model of a task at a configuration.
#[derive(Debug, Clone)]
pub(super) struct Linear {
    /// What is missing: see [`Deviation`].
    pub vector: [f64; 3],
    /// How the tip (metres) and the last link (radians times the lever) move with each joint (radians).
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

    /// The places of the joints from the base, and of the tip.
    #[inline(never)]
    pub fn places(&self, q: &[f64; MAX_LINKS]) -> [[f64; 2]; MAX_LINKS + 1] {
        let mut places = [[0.0; 2]; MAX_LINKS + 1];
        let mut angle = 0.0;
        for i in 0..self.joints.count {
            angle += q[i];
            let (sin, cos) = libm::sincos(angle);
            places[i + 1] = [places[i][0] + self.links[i] * cos, places[i][1] + self.links[i] * sin];
        }
        places
    }

    /// How far the configuration is from the target. O(links).
    #[inline(never)]
    pub fn deviation(&self, q: &[f64; MAX_LINKS]) -> Deviation {
        self.deviation_at(q, &self.places(q))
    }

    fn deviation_at(&self, q: &[f64; MAX_LINKS], places: &[[f64; 2]; MAX_LINKS + 1]) -> Deviation {
        let tip = places[self.joints.count];
        let [x, y] = [self.point[0] - tip[0], self.point[1] - tip[1]];
        let turn = self.orientation.map_or(0.0, |wanted| wrap(wanted - q.iter().sum::<f64>()));
        Deviation { vector: [x, y, self.lever * turn], distance: (x * x + y * y).sqrt(), turn: turn.abs() }
    }

    /// The linear model at the configuration. O(links).
    pub fn linear(&self, q: &[f64; MAX_LINKS]) -> Linear {
        let places = self.places(q);
        let count = self.joints.count;
        let (mut jacobian, tip) = ([[0.0; MAX_LINKS]; 3], places[count]);
        for i in 0..count {
            jacobian[0][i] = places[i][1] - tip[1];
            jacobian[1][i] = tip[0] - places[i][0];
            if self.orientation.is_some() {
                jacobian[2][i] = self.lever;
            }
        }
        let rows = if self.orientation.is_some() { 3 } else { 2 };
        Linear { vector: self.deviation_at(q, &places).vector, jacobian, rows }
    }

    /// The nearest and the farthest that the tip of the first `count` links can be from the base where nothing limits the
    /// joints, in metres: a ring.
    pub fn ring(&self, count: usize) -> [f64; 2] {
        let (mut sum, mut longest) = (0.0, 0.0);
        for &link in &self.links[..count] {
            sum += link;
            longest = f64::max(longest, link);
        }
        [(longest - (sum - longest)).max(0.0), sum]
    }

    /// Where the last joint has to be for a wanted orientation, from the base; the target where there is none. And the number
    /// of the links that bring it there.
    pub fn wrist(&self) -> ([f64; 2], usize) {
        let count = self.joints.count;
        match self.orientation {
            None => (self.point, count),
            Some(angle) => {
                let (sin, cos) = libm::sincos(angle);
                let last = self.links[count - 1];
                ([self.point[0] - last * cos, self.point[1] - last * sin], count - 1)
            }
        }
    }
}
