//! An arm: its links, each between two joints.
//!
//! Along an edge the absolute angle of link m is linear in t in [0, 1], with rate w_m. The acceleration of joint k is at most the
//! sum over m <= k of L_m w_m^2.

use super::moving::{Judge, Moving};
use super::{Scale, Seen, difference};
use crate::geometry::{Point, Vector};
use crate::robot::{Arm, MAX_LINKS};
use crate::scenario::World;

/// Judges every edge, and the only waypoint where there is one.
pub(super) fn judge(world: &World, arm: &Arm, path: &[Vec<f64>], scale: &Scale) -> Result<Seen, String> {
    check_limits(arm, path)?;
    let mut judge = Judge::new(world, scale);
    judge.look_at_start(&Edge::new(arm, 0, &path[0], &path[0]))?;
    for (i, ends) in path.windows(2).enumerate() {
        judge.follow(&Edge::new(arm, i, &ends[0], &ends[1]))?;
    }
    Ok(judge.seen)
}

/// Refuses waypoints outside the joint limits; between two waypoints inside, an interval joint stays inside.
fn check_limits(arm: &Arm, path: &[Vec<f64>]) -> Result<(), String> {
    for (i, waypoint) in path.iter().enumerate() {
        for (joint, (&angle, &[low, high])) in waypoint.iter().zip(arm.joint_limits().unwrap_or(&[])).enumerate() {
            if !(low..=high).contains(&angle) {
                return Err(format!(
                    "waypoint {i} leaves the limits of joint {joint}: {angle} is not in [{low}, {high}]"
                ));
            }
        }
    }
    Ok(())
}

/// One edge of the path as a motion of links with constant absolute rates.
struct Edge<'a> {
    arm: &'a Arm,
    index: usize,
    /// The absolute angle of each link at the start of the edge.
    angles: [f64; MAX_LINKS],
    /// The absolute turn of each link along the edge.
    rates: [f64; MAX_LINKS],
    /// How far each joint travels along the edge, at most, from the base outwards.
    travel: [f64; MAX_LINKS + 1],
    /// How far each joint can leave its chord, over the whole edge.
    bulge: [f64; MAX_LINKS + 1],
}

impl<'a> Edge<'a> {
    fn new(arm: &'a Arm, index: usize, from: &[f64], to: &[f64]) -> Self {
        let zero = [0.0; MAX_LINKS];
        let still = [0.0; MAX_LINKS + 1];
        let mut edge = Self { arm, index, angles: zero, rates: zero, travel: still, bulge: still };
        let first_circle = if arm.joint_limits().is_none() { 0 } else { usize::MAX };
        let turns = difference(first_circle, from, to);
        // The step from zero is the angle itself, without whole turns.
        let from = difference(first_circle, &[0.0; MAX_LINKS][..from.len()], from);
        let (mut angle, mut rate, mut travel, mut bulge) = (0.0, 0.0, 0.0, 0.0);
        for (i, &length) in arm.links().iter().enumerate() {
            angle += from[i];
            rate += turns[i];
            travel += length * f64::abs(rate);
            bulge += length * rate * rate / 8.0;
            (edge.angles[i], edge.rates[i]) = (angle, rate);
            (edge.travel[i + 1], edge.bulge[i + 1]) = (travel, bulge);
        }
        edge
    }
}

impl Moving for Edge<'_> {
    fn edge(&self) -> usize {
        self.index
    }

    fn points(&self, t: f64) -> Vec<Point> {
        let mut joints = vec![self.arm.base()];
        for (i, &length) in self.arm.links().iter().enumerate() {
            let angle = self.angles[i] + t * self.rates[i];
            joints.push(joints[i] + Vector::new(length * libm::cos(angle), length * libm::sin(angle)));
        }
        joints
    }

    fn travel(&self, k: usize) -> f64 {
        self.travel[k]
    }

    fn bulge(&self, k: usize) -> f64 {
        self.bulge[k]
    }

    fn radius(&self) -> f64 {
        self.arm.radius()
    }

    fn name(&self, i: usize) -> String {
        format!("link {i}")
    }

    /// Segments have no inside.
    fn encloses(&self, _: Point) -> bool {
        false
    }
}
