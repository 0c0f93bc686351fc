//! An arm: looks along every edge, and the swept hull of every link between two looks.
//!
//! Along an edge the absolute angle of link m is linear in t in [0, 1], with rate w_m. Over a stretch of length h, joint k
//! leaves the chord between its two places by at most (h^2 / 8) times the sum over m <= k of L_m w_m^2, the bound on its
//! acceleration; and a point of a link, a fixed mix of its ends, leaves the hull of both chords by no more.

use super::near::{Near, near};
use super::swept::Swept;
use super::{Scale, Seen, difference};
use crate::geometry::{Aabb, Point, Segment};
use crate::robot::{Arm, MAX_LINKS};
use crate::scenario::World;

/// Looks that are taken together, so that what is near is asked for once.
const BLOCK: u64 = 64;

/// How many looks in between may be taken for one path.
const MOST_REFINEMENTS: u64 = 10_000_000;

/// The places of the joints, from the base to the tip.
type Joints = [Point; MAX_LINKS + 1];

/// Judges every edge, and the only waypoint where there is one.
pub(super) fn judge(world: &World, arm: &Arm, path: &[Vec<f64>], scale: &Scale) -> Result<Seen, String> {
    check_limits(arm, path)?;
    let mut judge = Judge { world, scale, seen: Seen { looks: 0, clearance: f64::INFINITY }, refinements: 0 };
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
    /// How far the outer end of each link travels along the edge, at most.
    travel: [f64; MAX_LINKS],
    /// How far the outer end of each link can leave its chord, over the whole edge.
    bulge: [f64; MAX_LINKS],
}

impl<'a> Edge<'a> {
    fn new(arm: &'a Arm, index: usize, from: &[f64], to: &[f64]) -> Self {
        let zero = [0.0; MAX_LINKS];
        let mut edge = Self { arm, index, angles: zero, rates: zero, travel: zero, bulge: zero };
        let circles = arm.joint_limits().is_none();
        let turns = difference(circles, from, to);
        // The step from zero is the angle itself, without whole turns.
        let from = difference(circles, &[0.0; MAX_LINKS][..from.len()], from);
        let (mut angle, mut rate, mut travel, mut bulge) = (0.0, 0.0, 0.0, 0.0);
        for (i, &length) in arm.links().iter().enumerate() {
            angle += from[i];
            rate += turns[i];
            travel += length * f64::abs(rate);
            bulge += length * rate * rate / 8.0;
            (edge.angles[i], edge.rates[i], edge.travel[i], edge.bulge[i]) = (angle, rate, travel, bulge);
        }
        edge
    }

    /// How many links there are.
    fn links(&self) -> usize {
        self.arm.links().len()
    }

    /// The places of the joints at `t`.
    fn joints(&self, t: f64) -> Joints {
        let mut joints = [self.arm.base(); MAX_LINKS + 1];
        for (i, &length) in self.arm.links().iter().enumerate() {
            let angle = self.angles[i] + t * self.rates[i];
            let reach = crate::geometry::Vector::new(length * libm::cos(angle), length * libm::sin(angle));
            joints[i + 1] = joints[i] + reach;
        }
        joints
    }
}

/// Link `i` as the segment between its joints.
fn link(joints: &Joints, i: usize) -> Segment {
    Segment::new(joints[i], joints[i + 1])
}

struct Judge<'a> {
    world: &'a World,
    scale: &'a Scale,
    seen: Seen,
    refinements: u64,
}

impl Judge<'_> {
    /// Looks at the arm where the path starts, all obstacles in view.
    fn look_at_start(&mut self, edge: &Edge) -> Result<(), String> {
        let joints = edge.joints(0.0);
        self.seen.looks += 1;
        for i in 0..edge.links() {
            let here = link(&joints, i);
            for thing in near(&self.world.obstacles, &here.aabb(), f64::INFINITY) {
                self.look(edge, i, &thing, &here, 0.0)?;
            }
        }
        self.check_inside(edge, &joints, 0.0)
    }

    /// Follows the arm along an edge whose start has been looked at.
    fn follow(&mut self, edge: &Edge) -> Result<(), String> {
        let stretches = (edge.travel[edge.links() - 1] / self.scale.spacing).ceil().max(1.0) as u64;
        let at = |k: u64| k as f64 / stretches as f64;
        let mut first = 0;
        while first < stretches {
            let last = (first + BLOCK).min(stretches);
            let looks: Vec<(f64, Joints)> = (first..=last).map(|k| (at(k), edge.joints(at(k)))).collect();
            self.seen.looks += last - first;
            self.follow_block(edge, &looks)?;
            first = last;
        }
        Ok(())
    }

    /// Judges a block of looks, and the stretches between them.
    fn follow_block(&mut self, edge: &Edge, looks: &[(f64, Joints)]) -> Result<(), String> {
        let stretch = looks[1].0 - looks[0].0;
        for i in 0..edge.links() {
            let around = Aabb::around(looks.iter().flat_map(|(_, joints)| [joints[i], joints[i + 1]]));
            let around = around.expect("a block has two looks");
            let reach = self.touching(edge, i, 2.0 * stretch).max(self.seen.clearance + edge.arm.radius());
            let things = near(&self.world.obstacles, &around, reach);
            for (t, joints) in &looks[1..] {
                for thing in &things {
                    self.look(edge, i, thing, &link(joints, i), *t)?;
                }
            }
            for pair in looks.windows(2) {
                let ((t, before), (u, after)) = (&pair[0], &pair[1]);
                for thing in &things {
                    self.sweep(edge, i, thing, (*t, &link(before, i)), (*u, &link(after, i)))?;
                }
            }
        }
        for pair in looks.windows(2) {
            let ((t, before), (u, after)) = (&pair[0], &pair[1]);
            self.check_inside(edge, after, *u)?;
            self.keep_inside(edge, (*t, before), (*u, after))?;
        }
        Ok(())
    }

    /// At this distance from an obstacle or less, the hull of link `i` over a stretch of this length is too near.
    fn touching(&self, edge: &Edge, i: usize, stretch: f64) -> f64 {
        edge.arm.radius() + edge.bulge[i] * stretch * stretch + self.scale.slack
    }

    /// Refuses link `i` where it touches the thing at `t`.
    fn look(&mut self, edge: &Edge, i: usize, thing: &Near, here: &Segment, t: f64) -> Result<(), String> {
        let clearance = thing.distance(here) - edge.arm.radius();
        if clearance <= self.scale.slack {
            return Err(format!("edge {}, link {i} touches obstacle {} at {t} of the way", edge.index, thing.index));
        }
        self.seen.clearance = self.seen.clearance.min(clearance);
        Ok(())
    }

    /// Refuses link `i` where it may touch the thing between two looks, both of which were clear.
    fn sweep(
        &mut self,
        edge: &Edge,
        i: usize,
        thing: &Near,
        (t, before): (f64, &Segment),
        (u, after): (f64, &Segment),
    ) -> Result<(), String> {
        if !Swept::new(before, after).comes_within(self.touching(edge, i, u - t), thing) {
            return Ok(());
        }
        let middle = 0.5 * (t + u);
        if edge.travel[i] * (u - t) <= self.scale.slack || middle <= t || middle >= u {
            let (index, obstacle) = (edge.index, thing.index);
            return Err(format!("edge {index}, link {i} grazes obstacle {obstacle} between {t} and {u} of the way"));
        }
        let joints = self.look_between(edge, middle)?;
        let here = link(&joints, i);
        self.look(edge, i, thing, &here, middle)?;
        self.sweep(edge, i, thing, (t, before), (middle, &here))?;
        self.sweep(edge, i, thing, (middle, &here), (u, after))
    }

    /// Refuses an arm that is not wholly within the bounds at `t`.
    fn check_inside(&self, edge: &Edge, joints: &Joints, t: f64) -> Result<(), String> {
        match (0..=edge.links()).find(|&k| self.depth(edge, joints, k) < -self.scale.overstep) {
            Some(k) => {
                let (index, link) = (edge.index, k.saturating_sub(1));
                Err(format!("edge {index}, link {link} leaves the bounds at {t} of the way"))
            }
            None => Ok(()),
        }
    }

    /// Refuses an arm that may leave the bounds between two looks, at both of which it was inside.
    fn keep_inside(
        &mut self,
        edge: &Edge,
        (t, before): (f64, &Joints),
        (u, after): (f64, &Joints),
    ) -> Result<(), String> {
        let stretch = u - t;
        let stays = |k: usize| {
            let depth = self.depth(edge, before, k).min(self.depth(edge, after, k));
            depth - edge.bulge[k - 1] * stretch * stretch >= -self.scale.overstep
        };
        let Some(k) = (1..=edge.links()).find(|&k| !stays(k)) else { return Ok(()) };
        let middle = 0.5 * (t + u);
        if middle <= t || middle >= u {
            return Err(format!("edge {}, link {} leaves the bounds at {t} of the way", edge.index, k - 1));
        }
        let joints = self.look_between(edge, middle)?;
        self.check_inside(edge, &joints, middle)?;
        self.keep_inside(edge, (t, before), (middle, &joints))?;
        self.keep_inside(edge, (middle, &joints), (u, after))
    }

    /// How far joint `k`, with the radius around it, is within the bounds; negative outside.
    fn depth(&self, edge: &Edge, joints: &Joints, k: usize) -> f64 {
        self.world.bounds.as_ref().map_or(f64::INFINITY, |bounds| bounds.depth(joints[k]) - edge.arm.radius())
    }

    /// The joints at one more look, as long as looks are left.
    fn look_between(&mut self, edge: &Edge, t: f64) -> Result<Joints, String> {
        if self.refinements == MOST_REFINEMENTS {
            let looks = self.seen.looks;
            return Err(format!(
                "edge {} cannot be told from contact at {t} of the way after {looks} looks",
                edge.index
            ));
        }
        self.refinements += 1;
        self.seen.looks += 1;
        Ok(edge.joints(t))
    }
}
