//! Joint search: all robots move over their roadmaps at once, from one joint configuration to the next.
//!
//! Okumura 2023, "LaCAM: search-based algorithm for quick multi-agent pathfinding". A joint configuration has a vertex of every
//! robot. Depth first, each gets one successor at a time by a joint move (`joint_move.rs`); where a move leads to what is known,
//! the configuration that it led from gets another one, in which some robots have no choice. So every way that the roadmaps have
//! is tried in the end. Robots at their goals step aside for others and come back, which no order of priorities can do more than
//! once.

use super::joint_move::{JointMove, Moved, timed};
use super::priority_tree::Ground;
use super::result::FleetStats;
use super::trajectory::Trajectory;
use crate::geometry::sort_stably;
use crate::problem::Status;
use crate::random::{Random, Stream};
use std::collections::{BTreeMap, VecDeque};
use std::sync::Arc;

/// A joint configuration that was reached.
struct Reached {
    at: Arc<[u32]>,
    /// The one that it was reached from; itself if it is the first.
    from: usize,
    /// For how many moves each robot has not been at its goal.
    urgency: Vec<u32>,
    /// The robots, the most urgent first.
    order: Vec<usize>,
    /// What robots without choice the moves from here are to have: first none.
    fixed: VecDeque<Vec<(usize, u32)>>,
}

/// The search. An iteration tries one vertex for one robot, or takes up a configuration.
pub(super) struct Joint {
    starts: Vec<u32>,
    goals: Vec<u32>,
    reached: Vec<Reached>,
    known: BTreeMap<Arc<[u32]>, usize>,
    /// The configurations to go on from, the next one last.
    open: Vec<usize>,
    /// The move that is being chosen, and from which configuration.
    chosen: Option<(usize, JointMove)>,
    random: Random,
    noise: f64,
    solution: Vec<Arc<Trajectory>>,
}

impl Joint {
    /// Distances to goals count up to `1 + noise` times what they are, drawn by the seed.
    pub fn new(ground: &Ground, seed: u64, noise: f64) -> Self {
        let robots = 0..ground.fleet.kinds().len();
        let ends: Vec<[u32; 2]> =
            robots.map(|robot| ground.roadmaps[ground.fleet.kinds()[robot]].ends(robot)).collect();
        let [starts, goals] = [0, 1].map(|end| ends.iter().map(|ends| ends[end]).collect::<Vec<u32>>());
        let mut joint = Self {
            starts,
            goals,
            reached: Vec::new(),
            known: BTreeMap::new(),
            open: Vec::new(),
            chosen: None,
            random: Random::new(seed, Stream::Moves),
            noise,
            solution: Vec::new(),
        };
        joint.reach(ground, joint.starts.clone(), None);
        joint
    }

    /// Reaches a configuration: it is the next to go on from.
    fn reach(&mut self, ground: &Ground, at: Vec<u32>, from: Option<usize>) {
        let at: Arc<[u32]> = at.into();
        if let Some(&known) = self.known.get(&at) {
            return self.open.push(known);
        }
        let number = self.reached.len();
        let is_away = |robot: usize| u32::from(at[robot] != self.goals[robot]);
        let urgency: Vec<u32> = (0..at.len())
            .map(|robot| is_away(robot) * (1 + from.map_or(0, |from| self.reached[from].urgency[robot])))
            .collect();
        let far = |robot: usize| ground.distances[robot][self.starts[robot] as usize];
        let mut order: Vec<usize> = (0..at.len()).collect();
        sort_stably(&mut order, |&a, &b| urgency[b].cmp(&urgency[a]).then(far(b).total_cmp(&far(a))));
        self.known.insert(Arc::clone(&at), number);
        self.open.push(number);
        let fixed = VecDeque::from([Vec::new()]);
        self.reached.push(Reached { at, from: from.unwrap_or(number), urgency, order, fixed });
    }

    /// `Exhausted` once everything that can be reached has been gone on from in every way.
    pub fn iterate(&mut self, ground: &Ground, stats: &mut FleetStats) -> Status {
        if let Some((from, mut chosen)) = self.chosen.take() {
            match chosen.iterate(ground, &mut self.random, self.noise, stats) {
                Moved::NotYet => self.chosen = Some((from, chosen)),
                Moved::To(at) => self.reach(ground, at, Some(from)),
                Moved::Nowhere => {}
            }
            return Status::Running;
        }
        let Some(&number) = self.open.last() else { return Status::Exhausted };
        let reached = &mut self.reached[number];
        if reached.at[..] == self.goals[..] {
            self.solution = timed(ground, &self.chain(number));
            return Status::Solved;
        }
        let Some(fixed) = reached.fixed.pop_front() else {
            self.open.pop();
            return Status::Running;
        };
        if let Some(&robot) = reached.order.get(fixed.len()) {
            let roadmap = &ground.roadmaps[ground.fleet.kinds()[robot]];
            let neighbours = roadmap.neighbours(reached.at[robot]).iter().map(|(vertex, _)| *vertex);
            let mut vertices: Vec<u32> = neighbours.chain([reached.at[robot]]).collect();
            for i in (1..vertices.len()).rev() {
                vertices.swap(i, self.random.below(i as u64 + 1) as usize);
            }
            let more = vertices.into_iter().map(|vertex| [&fixed[..], &[(robot, vertex)]].concat());
            reached.fixed.extend(more);
        }
        self.chosen = Some((number, JointMove::new(reached.at.to_vec(), &reached.order, fixed)));
        Status::Running
    }

    /// The joint configurations from the first one to another.
    fn chain(&self, last: usize) -> Vec<Arc<[u32]>> {
        let mut chain = vec![Arc::clone(&self.reached[last].at)];
        let mut number = last;
        while self.reached[number].from != number {
            number = self.reached[number].from;
            chain.push(Arc::clone(&self.reached[number].at));
        }
        chain.reverse();
        chain
    }

    /// The trajectories of all robots, once solved.
    pub fn take_solution(&mut self) -> Vec<Arc<Trajectory>> {
        std::mem::take(&mut self.solution)
    }
}
