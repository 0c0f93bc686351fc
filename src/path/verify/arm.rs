//! An arm: its links, each between two joints.
//!
//! The absolute angle of link m is linear in t in [0, 1] along an edge, quadratic along a blend. With w_m its greatest rate and
//! v_m the change of that, the acceleration of joint k is at most the sum over m <= k of L_m (w_m^2 + |v_m|).

use super::blend::Quadratic;
use super::moving::{Checker, Moving, Stretch};
use super::{Examined, Scale, difference};
use crate::geometry::Vector;
use crate::robot::{Arm, MAX_LINKS, link_name};
use crate::scenario::World;

/// Examines the first waypoint, then every edge, then every blend, given with its waypoint.
pub(super) fn check(
    world: &World,
    arm: &Arm,
    path: &[Vec<f64>],
    blends: &[(usize, Quadratic)],
    scale: &Scale,
) -> Result<Examined, String> {
    check_limits(arm, path)?;
    let mut checker = Checker::new(world, scale);
    let first_circle = if arm.joint_limits().is_none() { 0 } else { usize::MAX };
    let edges = path.iter().enumerate().map(|(i, to)| {
        let edge = i.saturating_sub(1);
        // The step from zero is the angle itself, without whole turns.
        let from = difference(first_circle, &[0.0; MAX_LINKS][..to.len()], &path[edge]);
        (Stretch::Edge(edge), Quadratic::straight(from, difference(first_circle, &path[edge], to)))
    });
    let blends = blends.iter().map(|(waypoint, motion)| (Stretch::Blend(*waypoint), motion.clone()));
    for (i, (stretch, motion)) in edges.chain(blends).enumerate() {
        // The absolute angle of each link at the start, its rate there, and its bend; of each joint, from the base outwards, the
        // bounds of the motion.
        let (mut links, mut travel, mut bulge) = (Vec::new(), vec![0.0], vec![0.0]);
        let (mut angle, mut rate, mut bend) = (0.0, 0.0, 0.0);
        for (k, &length) in arm.links().iter().enumerate() {
            angle += motion.from[k];
            rate += motion.rate[k];
            bend += motion.bend[k];
            links.push((length, angle, rate, bend));
            let fastest = f64::abs(rate).max(f64::abs(rate + 2.0 * bend));
            travel.push(travel[k] + length * fastest);
            bulge.push(bulge[k] + length * (fastest * fastest + 2.0 * f64::abs(bend)) / 8.0);
        }
        let points = |t: f64| {
            let mut joints = vec![arm.base()];
            for (k, &(length, angle, rate, bend)) in links.iter().enumerate() {
                let angle = angle + t * (rate + t * bend);
                joints.push(joints[k] + Vector::new(length * libm::cos(angle), length * libm::sin(angle)));
            }
            joints
        };
        let robot = Moving {
            stretch,
            points: &points,
            travel: &travel,
            bulge: &bulge,
            radius: arm.radius(),
            body: None,
            part_name: link_name,
        };
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
