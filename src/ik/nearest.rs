//! The point nearest to a target that an arm can reach, exactly, with limits.
//!
//! If the tip is as near as possible to a target that it cannot reach, every joint that could still turn is collinear with the
//! tip and the target, and all others are at a limit. The links between two such joints form one rigid link along that line,
//! forwards or backwards, and there are finitely many such configurations. If the target can be reached, some configuration that
//! reaches it has the least angle of the first joint that is not at a limit; then all later free joints are collinear with the
//! tip in the same way, and the first joint, the rigid link from it and that line form a triangle with the target. All of these
//! configurations are tried, and each is measured by the actual position of the tip, so nothing is reported as reached by
//! mistake.
//!
//! A wanted orientation moves the target to the last joint. If that joint is then at a limit, the link before has a wanted
//! orientation too, and so on inwards.
//!
//! Sources: that the joints line up on the border of the workspace is in Kumar and Waldron 1981, "The workspaces of a mechanical
//! manipulator"; limits in Haug, Luh, Adkins and Wang 1996, "Numerical algorithms for mapping boundaries of manipulator
//! workspaces".

use super::task::{Deviation, Task};
use crate::error::{Code, Error};
use crate::geometry::Point;
use crate::robot::{Arm, MAX_LINKS, Target};
use serde::Serialize;
use std::f64::consts::PI;

/// Rotations of the last link up to the first, in radians, are rounding: of sums of eight angles up to 100. Far from the origin
/// the rounding of coordinates rotates it more, up to the second.
const SAME: [f64; 2] = [1e-11, 1e-6];

/// How near an arm can come to a target.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "NearestPoint"))]
pub struct Nearest {
    /// A configuration that comes that near, in radians.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Float64Array"))]
    pub configuration: Vec<f64>,
    /// The position of the tip there, in metres.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Point"))]
    pub point: Point,
    /// Its distance from the target, in metres.
    pub distance: f64,
    /// The rotation from the last link there to the wanted orientation, in radians: 0 unless the limits exclude that orientation
    /// everywhere, and then the least possible; the distance is the least among configurations of this orientation.
    pub turn: f64,
}

/// The point nearest to the target that the arm can reach, with a configuration. With an orientation: among the points that it
/// can reach in that orientation, or in the nearest one that the limits allow. O(4^links) with limits, O(2^links) without.
///
/// # Errors
/// Of the target: `not-finite`, `out-of-range`, `unsupported` (see [`Target`]); `unsupported` (pointer `/robot/joints`) for an
/// arm with a prismatic joint, for which the search is not exact.
pub fn nearest_reachable(arm: &Arm, target: Target) -> Result<Nearest, Error> {
    let target = target.checked(arm)?;
    if arm.has_prismatic_joint() {
        let sentence = "the nearest point that an arm with a prismatic joint can reach is not computed";
        return Err(Error::new(Code::Unsupported, "/robot/joints", sentence));
    }
    Ok(nearest(arm, &Task::new(arm, &target)))
}

pub(super) fn nearest(arm: &Arm, task: &Task) -> Nearest {
    let q = nearest_configuration(task);
    let deviation = task.deviation(&q);
    let turn = turn_of(task, &deviation);
    let configuration = q[..task.joints.count].to_vec();
    Nearest { configuration, point: arm.end_effector(&q), distance: deviation.distance, turn }
}

/// The rotation from the last link to the wanted orientation, 0 if it is rounding.
fn turn_of(task: &Task, deviation: &Deviation) -> f64 {
    let [least, most] = SAME;
    if deviation.turn > (task.finest / task.reach).max(least).min(most) { deviation.turn } else { 0.0 }
}

pub(super) fn nearest_configuration(task: &Task) -> [f64; MAX_LINKS] {
    let (q, count, rest, point) = ([0.0; MAX_LINKS], task.joints.count, task.joints.rest(), task.point);
    let mut search = Search { task, rest, q, count, point, last: None, best: None, is_done: false };
    match task.orientation {
        None => search.prefix(0, 0.0, [0.0; 2], false),
        Some(wanted) => search.oriented(count - 1, point, wanted),
    }
    search.best.map_or_else(|| farthest_turned(task), |(_, q)| q)
}

/// If no configuration has the wanted orientation: all joints at their low limits, or all at their high ones, whichever
/// rotates the last link nearer to it.
fn farthest_turned(task: &Task) -> [f64; MAX_LINKS] {
    let ends = [0, 1].map(|end| {
        let q = task.joints.hold_all(|i| task.joints.ranges[i][end]);
        (q, task.deviation(&q).turn)
    });
    if ends[1].1 < ends[0].1 { ends[1].0 } else { ends[0].0 }
}

/// How a line of joints is completed once it reaches the tip.
#[derive(Clone, Copy)]
enum Purpose {
    /// The line runs through the target, at this distance from its beginning.
    Approach { away: f64 },
    /// The line is the third side of a triangle.
    Triangle(Corner),
}

/// The first two corners of the triangle: the joint that has the least angle, and the first joint of the line.
#[derive(Clone, Copy)]
struct Corner {
    joint: usize,
    position: [f64; 2],
    /// The absolute angle of the link before the joint.
    before: f64,
    line: usize,
    /// The rigid link from one to the other, its angle to the first link in it, and that of the last link in it.
    length: f64,
    angle: f64,
    end: f64,
}

/// The search for the best configuration of the first `count` joints, the rest being known.
struct Search<'a> {
    task: &'a Task,
    rest: [f64; MAX_LINKS],
    q: [f64; MAX_LINKS],
    count: usize,
    point: [f64; 2],
    /// The joint after the first `count`, and the required absolute angle of its link.
    last: Option<(usize, f64)>,
    /// The error of the best, metres plus radians times the reach, and its configuration.
    best: Option<(f64, [f64; MAX_LINKS])>,
    is_done: bool,
}

impl Search<'_> {
    /// The link after `joint` must have the absolute angle `wanted` and end at `point`; all later joints are known.
    fn oriented(&mut self, joint: usize, point: [f64; 2], wanted: f64) {
        let (sin, cos) = libm::sincos(wanted);
        let length = self.task.links[joint];
        let point = [point[0] - length * cos, point[1] - length * sin];
        (self.count, self.point, self.last) = (joint, point, Some((joint, wanted)));
        self.prefix(0, 0.0, [0.0; 2], false);
        if joint > 0 && !self.task.joints.turns_around(joint) {
            for limit in self.task.joints.ranges[joint] {
                self.q[joint] = limit;
                self.oriented(joint - 1, point, wanted - limit);
            }
        }
    }

    /// Joints before `joint` are fixed, the link before it at the absolute angle `before`. `is_cut` if one of them is a circle,
    /// whose only limit is the angle at which it was cut open.
    fn prefix(&mut self, joint: usize, before: f64, position: [f64; 2], is_cut: bool) {
        if self.is_done {
            return;
        }
        if joint == self.count {
            return self.measure();
        }
        self.triangles(joint, before, position);
        if !is_cut {
            let [x, y] = [self.point[0] - position[0], self.point[1] - position[1]];
            let away = (x * x + y * y).sqrt();
            // At the target itself, any direction leads to it.
            let direction = if away > 0.0 { libm::atan2(y, x) } else { before + self.rest[joint] };
            self.line(joint, Some(before - direction), 0.0, Purpose::Approach { away });
        }
        if self.task.joints.turns_around(joint) {
            self.stop(joint, self.rest[joint], before, position, true);
        } else {
            for limit in self.task.joints.ranges[joint] {
                self.stop(joint, limit, before, position, is_cut);
            }
        }
    }

    fn stop(&mut self, joint: usize, angle: f64, before: f64, position: [f64; 2], is_cut: bool) {
        self.q[joint] = angle;
        let (sin, cos) = libm::sincos(before + angle);
        let length = self.task.links[joint];
        self.prefix(joint + 1, before + angle, [position[0] + length * cos, position[1] + length * sin], is_cut);
    }

    /// Every rigid link from `joint` to the first joint of a line.
    fn triangles(&mut self, joint: usize, before: f64, position: [f64; 2]) {
        let corner = Corner { joint, position, before, line: 0, length: 0.0, angle: 0.0, end: 0.0 };
        self.rigid(joint, [self.task.links[joint], 0.0], 0.0, &mut |search, line, length, angle, end| {
            if line < search.count {
                search.line(line, None, 0.0, Purpose::Triangle(Corner { line, length, angle, end, ..corner }));
            }
        });
    }

    /// Every rigid link that begins with the link after `joint`, all joints in it at limits: `vector` so far, from the first
    /// link, whose own angle is 0; `end` the angle of the last. Calls `then` with the joint at its end, its length, its angle and
    /// `end`.
    fn rigid(
        &mut self,
        joint: usize,
        vector: [f64; 2],
        end: f64,
        then: &mut dyn FnMut(&mut Self, usize, f64, f64, f64),
    ) {
        let next = joint + 1;
        let [x, y] = vector;
        then(self, next, (x * x + y * y).sqrt(), libm::atan2(y, x), end);
        if next == self.count || self.task.joints.turns_around(next) {
            return;
        }
        for limit in self.task.joints.ranges[next] {
            self.q[next] = limit;
            let (sin, cos) = libm::sincos(end + limit);
            let length = self.task.links[next];
            self.rigid(next, [x + length * cos, y + length * sin], end + limit, then);
        }
    }

    /// Joints from `joint` on lie on a line, along which the tip of the links before is at `along`; the angle of the last of
    /// those to the line is `before`, if known.
    fn line(&mut self, joint: usize, before: Option<f64>, along: f64, purpose: Purpose) {
        if self.is_done {
            return;
        }
        if joint == self.count {
            return self.finish(along, purpose);
        }
        if let (Purpose::Approach { away }, Some((best, _))) = (purpose, self.best) {
            let rest: f64 = self.task.links[joint..self.count].iter().sum();
            if (away - along).abs() - rest >= best {
                return;
            }
        }
        self.rigid(joint, [self.task.links[joint], 0.0], 0.0, &mut |search, next, length, angle, end| {
            for (sign, turned) in [(1.0, -angle), (-1.0, PI - angle)] {
                // The joints of the rigid link are set already; the recursion does not change them.
                let saved = search.q;
                match before {
                    None => search.q[joint] = turned,
                    Some(before) => match search.task.joints.fit(joint, turned - before, search.rest[joint]) {
                        Some(fitting) => search.q[joint] = fitting,
                        None => continue,
                    },
                }
                search.line(next, Some(turned + end), along + sign * length, purpose);
                search.q = saved;
            }
        });
    }

    /// The line has reached the tip, `along` from its beginning.
    fn finish(&mut self, along: f64, purpose: Purpose) {
        match purpose {
            Purpose::Approach { away } => {
                // `measure` is expensive; rounding may make the result a little better than it seems here.
                if self.best.is_none_or(|(best, _)| (away - along).abs() < best + self.task.finest) {
                    self.measure();
                }
            }
            Purpose::Triangle(corner) => self.close(corner, along),
        }
    }

    /// Closes the triangle of the rigid link, the line and the segment to the target, on either side.
    fn close(&mut self, corner: Corner, along: f64) {
        let [x, y] = [self.point[0] - corner.position[0], self.point[1] - corner.position[1]];
        let (r, a, b) = ((x * x + y * y).sqrt(), corner.length, along.abs());
        let square = (a + b + r) * (a + b - r) * (r + (a - b)) * (r - (a - b));
        // Degenerate triangles are lines through the target, which are found as such.
        if !(square > 0.0 && b > 0.0) {
            return;
        }
        let (towards, inner) = (libm::atan2(y, x), libm::atan2(square.sqrt(), r * r + (a - b) * (a + b)));
        let (joints, turned) = (&self.task.joints, self.q[corner.line]);
        for rigid in [towards - inner, towards + inner] {
            let first = rigid - corner.angle;
            let (sin, cos) = libm::sincos(rigid);
            let [dx, dy] = [x - a * cos, y - a * sin];
            let direction = libm::atan2(dy, dx) + if along < 0.0 { PI } else { 0.0 };
            let wanted =
                [(corner.joint, first - corner.before), (corner.line, direction + turned - first - corner.end)];
            let [one, other] = wanted.map(|(joint, angle)| joints.fit(joint, angle, self.rest[joint]));
            if let (Some(one), Some(other)) = (one, other) {
                (self.q[corner.joint], self.q[corner.line]) = (one, other);
                self.measure();
            }
        }
        self.q[corner.line] = turned;
    }

    /// Measures the actual error of the configuration.
    fn measure(&mut self) {
        let mut q = self.q;
        if let Some((joint, wanted)) = self.last {
            let angle = wanted - q[..joint].iter().sum::<f64>();
            match self.task.joints.fit(joint, angle, self.rest[joint]) {
                Some(fitting) => q[joint] = fitting,
                None => return,
            }
        }
        let q = self.task.joints.hold_all(|i| q[i]);
        // An angle held at its limit may be off by a little, so configurations of the exact orientation come first.
        let deviation = self.task.deviation(&q);
        let turn = turn_of(self.task, &deviation);
        let error = deviation.distance + self.task.reach * turn;
        if self.best.is_none_or(|(best, _)| error < best) {
            self.best = Some((error, q));
            self.is_done = error <= self.task.finest && turn == 0.0;
        }
    }
}
