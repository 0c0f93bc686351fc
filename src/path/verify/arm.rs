//! An arm: its links, each between two joints.
//!
//! The absolute angle of link m is linear in t in [0, 1] along an edge, quadratic along a blend. With w_m its greatest rate and
//! v_m the change of that, the acceleration of joint k is at most the sum over m <= k of L_m (w_m^2 + |v_m|). The length of a
//! prismatic link is such a polynomial too: with L_m its greatest, g_m the greatest rate at which it grows and c_m the change of
//! that, its share of the acceleration is at most L_m (w_m^2 + |v_m|) + 2 g_m w_m + |c_m|, and of the travel L_m w_m + g_m.

use super::blend::Quadratic;
use super::moving::{Checker, Moving, Stretch};
use super::{Examined, Scale, difference};
use crate::geometry::Vector;
use crate::robot::{Arm, Joint, MAX_LINKS, link_name};
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
    let circles = arm.circles();
    let edges = path.iter().enumerate().map(|(i, to)| {
        let edge = i.saturating_sub(1);
        // The step from zero is the angle itself, without whole turns.
        let from = difference(&circles, &[0.0; MAX_LINKS][..to.len()], &path[edge]);
        (Stretch::Edge(edge), Quadratic::straight(from, difference(&circles, &path[edge], to)))
    });
    let blends = blends.iter().map(|(waypoint, motion)| (Stretch::Blend(*waypoint), motion.clone()));
    for (i, (stretch, motion)) in edges.chain(blends).enumerate() {
        // The length and the absolute angle of each link, as polynomials; of each joint, from the base outwards, the bounds of
        // the motion.
        let (mut links, mut travel, mut bulge) = (Vec::new(), vec![0.0], vec![0.0]);
        let mut angle = [0.0; 3];
        for (k, (&length, joint)) in arm.links().iter().zip(arm.joint_types()).enumerate() {
            let moved = [motion.from[k], motion.rate[k], motion.bend[k]];
            let mut length = [length, 0.0, 0.0];
            let sums = |a: [f64; 3], b: [f64; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
            match *joint {
                Joint::Revolute { .. } => angle = sums(angle, moved),
                Joint::Prismatic { angle: fixed, .. } => {
                    (angle, length) = (sums(angle, [fixed, 0.0, 0.0]), sums(length, moved));
                }
            }
            links.push((length, angle));
            let fastest = |[_, rate, bend]: [f64; 3]| f64::abs(rate).max(f64::abs(rate + 2.0 * bend));
            let (turning, growing) = (fastest(angle), fastest(length));
            // No longer than at an end, but for what the bend adds between.
            let longest = length[0].max(length[0] + length[1] + length[2]) + 0.25 * length[2].abs();
            travel.push(travel[k] + longest * turning + growing);
            let acceleration = longest * (turning * turning + 2.0 * f64::abs(angle[2]))
                + 2.0 * growing * turning
                + 2.0 * f64::abs(length[2]);
            bulge.push(bulge[k] + acceleration / 8.0);
        }
        let points = |t: f64| {
            let mut joints = vec![arm.base()];
            for (k, &(length, angle)) in links.iter().enumerate() {
                let [length, angle] = [length, angle].map(|[from, rate, bend]| from + t * (rate + t * bend));
                joints.push(joints[k] + Vector::new(length * libm::cos(angle), length * libm::sin(angle)));
            }
            joints
        };
        let robot = Moving {
            stretch,
            points: &points,
            travel: &travel,
            bulge: &bulge,
            radius: arm.kept_radius(),
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
        for (k, (&at, joint)) in waypoint.iter().zip(arm.joint_types()).enumerate() {
            if let Some([low, high]) = joint.range().filter(|[low, high]| !(*low..=*high).contains(&at)) {
                return Err(format!("waypoint {i} leaves the limits of joint {k}: {at} is not in [{low}, {high}]"));
            }
        }
    }
    Ok(())
}
