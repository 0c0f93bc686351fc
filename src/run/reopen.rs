//! A roadmap among obstacles that have moved: where they are now, and where they were.

use crate::collision::Tolerance;
use crate::error::{Code, Error};
use crate::geometry::Aabb;
use crate::planner::{self, Planner, Roadmap};
use crate::problem::Problem;
use crate::scenario::{Obstacle, Scenario};
use crate::space::Space;

/// A roadmap that was built in another world, and what differs there.
pub(super) struct Kept<'a, S: Space> {
    pub roadmap: &'a Roadmap<S>,
    pub changes: Changes,
    /// The tolerance of its proofs.
    pub tolerance: Tolerance,
}

/// Whether the robot may touch something in one of some boxes on a motion.
type MayMeet<'a, T> = dyn Fn(&T, &T, &[Aabb]) -> bool + 'a;

impl<S: Space + 'static> Kept<'_, S> {
    /// The planner of a run on the roadmap, whose own proofs have this tolerance. `may_meet` tells whether the robot may touch
    /// something in one of some boxes on a motion.
    pub fn reopened(
        &self,
        problem: &Problem<S>,
        tolerance: Tolerance,
        may_meet: &MayMeet<S::State>,
    ) -> Box<dyn Planner<S>> {
        let Changes { added, removed } = &self.changes;
        let before = self.tolerance;
        // A proof counts with a smaller slack, a refusal with the same tolerance.
        let is_rougher = tolerance.eta > before.eta;
        let is_other = (before.tau, before.bounds_tau) != (tolerance.tau, tolerance.bounds_tau);
        planner::reopen(problem, self.roadmap, &|a, b| is_rougher || may_meet(a, b, added), &|a, b| {
            is_other || may_meet(a, b, removed)
        })
    }
}

/// The boxes around obstacles that only one of two worlds has.
pub(super) struct Changes {
    /// Around those of the later one.
    pub added: Vec<Aabb>,
    /// Around those of the earlier one.
    pub removed: Vec<Aabb>,
}

impl Changes {
    /// The changes from one scenario to another. Obstacles are compared in their order, without those at the beginning and at the
    /// end that are the same. O(n) comparisons.
    ///
    /// # Errors
    /// `other-scenario` if robots or bounds differ.
    pub fn between(before: &Scenario, after: &Scenario) -> Result<Self, Error> {
        let refuse = |pointer, what| {
            let sentence = format!("only obstacles and queries may change; the {what} of the roadmap is another one");
            Err(Error::new(Code::OtherScenario, pointer, sentence))
        };
        if before.robot() != after.robot() {
            return refuse("/robot", "robot");
        }
        if before.world().bounds != after.world().bounds {
            return refuse("/world/bounds", "box of bounds");
        }
        let (mut removed, mut added) = (&before.world().obstacles[..], &after.world().obstacles[..]);
        while let ([a, rest @ ..], [b, others @ ..]) = (removed, added)
            && a == b
        {
            (removed, added) = (rest, others);
        }
        while let ([rest @ .., a], [others @ .., b]) = (removed, added)
            && a == b
        {
            (removed, added) = (rest, others);
        }
        let is_other = |these: &[Obstacle], i: usize, one: &Obstacle| removed.len() != added.len() || these[i] != *one;
        let boxes = |list: &[Obstacle], other: &[Obstacle]| {
            let changed = list.iter().enumerate().filter(|&(i, one)| is_other(other, i, one));
            changed.map(|(_, one)| one.aabb()).collect()
        };
        Ok(Self { added: boxes(added, removed), removed: boxes(removed, added) })
    }
}
