//! Refinement of a plan: one robot after another plans again, among the trajectories of all others.
//!
//! Okumura, Tamura and Defago 2021, "Iterative refinement for real-time multi-robot path planning". A trajectory is replaced by
//! one that arrives earlier, so a plan stays a plan, and no robot arrives later.

use super::priority_tree::Ground;
use super::result::FleetStats;
use super::safe_intervals::{Expansion, Search};
use super::trajectory::Trajectory;
use crate::geometry::sort_stably;
use std::sync::Arc;

/// An arrival counts as earlier if it is by more than this part of itself.
const EARLIER: f64 = 1e-9;

/// A plan, and which robot plans again. An iteration is an expansion of its search, or compares one trajectory with all others.
pub(super) struct Refinement {
    pub trajectories: Vec<Arc<Trajectory>>,
    all: Vec<usize>,
    /// How many trajectories have been compared with all before them.
    compared: usize,
    /// The robots that have still to plan in this round, the next one last; how many rounds are left, and whether one arrives
    /// earlier.
    left: Vec<usize>,
    rounds: u32,
    is_earlier: bool,
    search: Option<Search>,
}

/// How a refinement goes on.
pub(super) enum Refined {
    NotYet,
    /// Nothing more is to be done.
    Plan,
    /// Two trajectories are not proven apart.
    Refused,
}

impl Refinement {
    pub fn new(trajectories: Vec<Arc<Trajectory>>, rounds: u32) -> Self {
        let all = (0..trajectories.len()).collect();
        Self { trajectories, all, compared: 0, left: Vec::new(), rounds, is_earlier: true, search: None }
    }

    pub fn iterate(&mut self, ground: &Ground, stats: &mut FleetStats) -> Refined {
        if self.compared < self.all.len() {
            let robot = self.compared;
            self.compared += 1;
            let mut meets = |other| ground.first_conflict([other, robot], &self.trajectories, &mut stats.pair_checks);
            return if (0..robot).any(|other| meets(other).is_some()) { Refined::Refused } else { Refined::NotYet };
        }
        let Some(&robot) = self.left.last() else {
            if self.rounds == 0 || !self.is_earlier {
                return Refined::Plan;
            }
            // Who arrives last plans first.
            let mut left = self.all.clone();
            sort_stably(&mut left, |&a, &b| self.arrival(a).total_cmp(&self.arrival(b)).then(b.cmp(&a)));
            self.left = left;
            (self.rounds, self.is_earlier) = (self.rounds - 1, false);
            return Refined::NotYet;
        };
        let scene = ground.scene(robot, &self.trajectories, &self.all);
        let search = self.search.get_or_insert_with(|| ground.search(&scene));
        match search.step(&scene, &mut stats.pair_checks) {
            Expansion::Vertex => {
                stats.expanded += 1;
                return Refined::NotYet;
            }
            Expansion::Part => return Refined::NotYet,
            Expansion::Found(trajectory) if trajectory.arrival() < self.arrival(robot) * (1.0 - EARLIER) => {
                self.trajectories[robot] = Arc::new(trajectory);
                self.is_earlier = true;
            }
            Expansion::Found(_) | Expansion::Nothing(_) => {}
        }
        self.search = None;
        self.left.pop();
        Refined::NotYet
    }

    fn arrival(&self, robot: usize) -> f64 {
        self.trajectories[robot].arrival()
    }
}
