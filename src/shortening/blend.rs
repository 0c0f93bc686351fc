//! Blends: corners of a path rounded by parabolas, each proven free or left out.
//!
//! With d the distance at which the blend of a corner b begins, before = d / |ab| and after = d / |bc| are its shares of the
//! edges to b and from it. The blend is the quadratic Bezier curve with the control points b + before (a - b), b, b + after (c -
//! b). A robot that follows edges at speed v, in the metric of the space, and is at u = t v / (2 d) of a blend after t seconds,
//! never changes its velocity by a jump: the timed path is C1, and its curve has a tangent everywhere.
//!
//! Parabolas between straight motions, proven one by one: Hauser and Ng-Thow-Hing 2010, "Fast smoothing of manipulator
//! trajectories using optimal bounded-acceleration shortcuts"; where they begin: Kunz and Stilman 2012, "Time-optimal trajectory
//! generation for path following with bounded acceleration and velocity", with circular arcs in place of parabolas.

use crate::problem::Problem;
use crate::space::Space;

/// How often a blend that is not proven is tried again, each time half as long.
const HALVINGS: u32 = 3;

/// A path whose corners are being rounded, from the start on.
#[derive(Debug, Clone)]
pub struct Blending<S: Space> {
    /// The path: no step of it turns far (see [`split`](super::split())), so that a blend turns by less than half a turn.
    pub path: Vec<S::State>,
    /// Of every waypoint but the first and the last, the shares of its blend; both 0 where the corner stays.
    pub shares: Vec<[f64; 2]>,
    /// The number of corners tried.
    tried: usize,
}

impl<S: Space> Blending<S> {
    /// The corners of a path.
    pub(super) fn new(space: &S, path: &[S::State]) -> Self {
        let path = super::split(space, path);
        let shares = vec![[0.0; 2]; path.len().saturating_sub(2)];
        Self { path, shares, tried: 0 }
    }

    /// Whether every corner was tried.
    pub(super) fn is_done(&self) -> bool {
        self.tried == self.shares.len()
    }

    /// Tries the next corner: its blend begins at `largest` of the shorter edge at it, half of that and so on. O(1), each blend
    /// counted as one motion.
    pub(super) fn attempt(&mut self, problem: &Problem<S>, largest: f64, checks: &mut u64) {
        let space = problem.space();
        let [a, b, c] = [0, 1, 2].map(|i| self.path[self.tried + i]);
        let [before, after] = [space.distance(&a, &b), space.distance(&b, &c)];
        let distance = largest.min(0.5) * before.min(after);
        let whole = [distance / before, distance / after];
        let tries = if distance > 0.0 { HALVINGS + 1 } else { 0 };
        let shares = (0..tries).map(|i| whole.map(|share| share / f64::from(1u32 << i)));
        let proven = shares.into_iter().find(|shares| {
            *checks += 1;
            problem.validity().is_blend_free(&control_points(space, [&a, &b, &c], *shares))
        });
        self.shares[self.tried] = proven.unwrap_or_default();
        self.tried += 1;
    }
}

/// By how much blends shorten a path, in the metric of the space: `shares` are those of its inner waypoints.
pub fn blend_saving<S: Space>(space: &S, path: &[S::State], shares: &[[f64; 2]]) -> f64 {
    let corners = path.windows(3).zip(shares);
    corners
        .map(|(at, &shares)| space.blend_saving(&control_points(space, [&at[0], &at[1], &at[2]], shares)))
        .sum::<f64>()
        + 0.0
}

/// The control points of the blend of a corner between two states.
fn control_points<S: Space>(space: &S, [a, b, c]: [&S::State; 3], [before, after]: [f64; 2]) -> [S::State; 3] {
    [space.interpolate(b, a, before), *b, space.interpolate(b, c, after)]
}
