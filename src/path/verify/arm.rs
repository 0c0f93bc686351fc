//! An arm: its links, each between two joints.
//!
//! Along an edge the absolute angle of link m is linear in t in [0, 1], with rate w_m. The acceleration of joint k is at
//! most the sum over m <= k of L_m w_m^2.

use super::moving::{Checker, Moving};
use super::{Examined, Scale, difference};
use crate::geometry::Vector;
use crate::robot::{Arm, MAX_LINKS};
use crate::scenario::World;

/// Examines the first waypoint, then every edge.
pub(super) fn check(world: &World, arm: &Arm, path: &[Vec<f64>], scale: &Scale) -> Result<Examined, String> {
    check_limits(arm, path)?;
    let mut checker = Checker::new(world, scale);
    let first_circle = if arm.joint_limits().is_none() { 0 } else { usize::MAX };
    for (i, to) in path.iter().enumerate() {
        let edge = i.saturating_sub(1);
        // The step from zero is the angle itself, without whole turns.
        let from = difference(first_circle, &[0.0; MAX_LINKS][..to.len()], &path[edge]);
        let turns = difference(first_circle, &path[edge], to);
        // The absolute angle of each link at the start of the edge, and its turn along it; of each joint, from the base
        // outwards, the bounds of the motion.
        let (mut links, mut travel, mut bulge) = (Vec::new(), vec![0.0], vec![0.0]);
        let (mut angle, mut rate) = (0.0, 0.0);
        for (k, &length) in arm.links().iter().enumerate() {
            angle += from[k];
            rate += turns[k];
            links.push((length, angle, rate));
            travel.push(travel[k] + length * f64::abs(rate));
            bulge.push(bulge[k] + length * rate * rate / 8.0);
        }
        let points = |t: f64| {
            let mut joints = vec![arm.base()];
            for (k, &(length, angle, rate)) in links.iter().enumerate() {
                let angle = angle + t * rate;
                joints.push(joints[k] + Vector::new(length * libm::cos(angle), length * libm::sin(angle)));
            }
            joints
        };
        let robot = Moving { edge, points: &points, travel: &travel, bulge: &bulge, radius: arm.radius(), body: None };
        if i == 0 { checker.check_start(&robot)? } else { checker.check_edge(&robot)? }
    }
    Ok(checker.examined)
}

/// Returns an error if a waypoint is outside the joint limits; between two waypoints inside, an interval joint stays inside.
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
