//! Priority-based search: who gives way to whom is decided for two robots at a time, where their trajectories conflict.
//!
//! Ma, Harabor, Stuckey, Li and Koenig 2019, "Searching with consistent prioritization for multi-agent path finding". A branch
//! has some pairs of robots, of which the first goes before the second, and a trajectory of every robot, clear of all that go
//! before it and of no others. At first there are no pairs. If no two trajectories of a branch conflict, they are a plan. Else
//! the earliest conflict makes two branches of it, in each of which another one of the two gives way and plans again, and with it
//! whoever is below it and in conflict with one above. The branch with the earlier arrivals is looked into first (depth first).
//!
//! Robots are clear of those above them from time 0 on, so a robot moves aside, though it would rather stand, and comes back.

use super::document::Fleet;
use super::motion::{CLEAR, Footprint, Pair};
use super::result::{Blocked, FleetStats};
use super::roadmap::Roadmap;
use super::safe_intervals::{Expansion, Search};
use super::traffic::Scene;
use super::trajectory::Trajectory;
use crate::geometry::sort_stably;
use crate::problem::Status;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The earliest departures graze the others: this number of slacks is left between them, a hundred-millionth of the world's size.
pub(super) const MARGIN: f64 = 1e4;

/// What searches need, on roadmaps that are complete.
#[derive(Clone, Copy)]
pub(super) struct Ground<'a> {
    pub fleet: &'a Fleet,
    pub roadmaps: &'a [Roadmap],
    /// Of every robot and every vertex of its roadmap, the length of the way to the robot's goal; empty where these are too
    /// many to keep.
    pub distances: &'a [Arc<[f64]>],
}

impl Ground<'_> {
    /// The scene of a robot among some of the others.
    pub fn scene<'a>(&'a self, robot: usize, trajectories: &'a [Arc<Trajectory>], among: &'a [usize]) -> Scene<'a> {
        let fleet = self.fleet;
        let (speed, roadmap) = (fleet.robots()[robot].speed, &self.roadmaps[fleet.kinds()[robot]]);
        let (footprints, slack) = (fleet.footprints(), MARGIN * fleet.slack());
        Scene { robot, speed, roadmap, footprints, trajectories, among, slack }
    }

    /// The search of the robot of a scene.
    pub fn search(&self, scene: &Scene) -> Search {
        if let Some(known) = self.distances.get(scene.robot).filter(|known| !known.is_empty()) {
            return Search::new(scene, known);
        }
        let [_, goal] = scene.roadmap.ends(scene.robot);
        Search::new(scene, &scene.roadmap.distances_to(goal))
    }

    /// When two trajectories conflict first, if they do.
    pub fn first_conflict(&self, pair: [usize; 2], trajectories: &[Arc<Trajectory>], checks: &mut u64) -> Option<f64> {
        let [a, b] = pair.map(|robot| &*trajectories[robot]);
        let footprints: [&Footprint; 2] = pair.map(|robot| &self.fleet.footprints()[robot]);
        let clear = CLEAR * MARGIN * self.fleet.slack();
        if !a.around().grown(footprints[0].radius() + footprints[1].radius() + clear).intersects(b.around()) {
            return None;
        }
        b.motions().find_map(|motion| {
            let near = motion.covered(footprints[1]).grown(clear);
            let during = a.during(motion.begin, motion.end);
            let mut beside = during.filter(|other| other.covered(footprints[0]).intersects(&near));
            let met = beside.find(|other| {
                *checks += 1;
                !Pair { footprints, motions: [other, &motion], slack: self.fleet.slack() }.is_apart()
            })?;
            Some(met.begin.max(motion.begin))
        })
    }
}

/// Trajectories that keep to some pairs of priorities.
#[derive(Clone)]
struct Branch {
    /// Of every robot those that go before it, directly or not, in order.
    above: Vec<Arc<[usize]>>,
    trajectories: Vec<Arc<Trajectory>>,
    /// Of every pair of robots that conflict, when they do first.
    conflicts: BTreeMap<[usize; 2], f64>,
    cost: f64,
}

impl Branch {
    fn is_above(&self, first: usize, second: usize) -> bool {
        self.above[second].binary_search(&first).is_ok()
    }

    /// A robot and all below it, those with most above them first: each comes before all that are above it.
    fn lowest_first(&self, robot: usize) -> Vec<usize> {
        let mut robots: Vec<usize> =
            (0..self.above.len()).filter(|&one| one == robot || self.is_above(robot, one)).collect();
        sort_stably(&mut robots, |&one, &other| (self.above[other].len(), other).cmp(&(self.above[one].len(), one)));
        robots
    }

    /// Lets one robot go before another, and before all below that.
    fn put_above(&mut self, first: usize, second: usize) {
        let mut added = self.above[first].to_vec();
        added.push(first);
        for robot in self.lowest_first(second) {
            let mut above = [&self.above[robot][..], &added].concat();
            above.sort_unstable();
            above.dedup();
            self.above[robot] = above.into();
        }
    }
}

/// A branch whose robots are planning again.
struct Work {
    branch: Branch,
    /// The robots to look at, the last first, and those that must plan again.
    left: Vec<usize>,
    must: Vec<usize>,
    /// The robot that plans, those above it, and its search.
    planning: Option<(usize, Arc<[usize]>, Option<Search>)>,
}

/// The tree of branches. An iteration is an expansion of the search of one robot, or a comparison of one trajectory with all
/// others.
pub(super) struct PriorityTree {
    /// The branches to look into, the next one last.
    open: Vec<Branch>,
    work: Option<Work>,
    /// The pairs that have still to make a branch, and the branches made, of the branch looked into.
    parent: Option<Branch>,
    pairs: Vec<[usize; 2]>,
    made: Vec<Branch>,
    solution: Vec<Arc<Trajectory>>,
    blocked: Option<Blocked>,
}

impl PriorityTree {
    pub fn new(fleet: &Fleet) -> Self {
        let count = fleet.kinds().len();
        let branch = Branch {
            above: (0..count).map(|_| Arc::new([]) as Arc<[usize]>).collect(),
            trajectories: standing(fleet),
            conflicts: BTreeMap::new(),
            cost: f64::INFINITY,
        };
        let all: Vec<usize> = (0..count).rev().collect();
        Self {
            open: Vec::new(),
            work: Some(Work { branch, left: all.clone(), must: all, planning: None }),
            parent: None,
            pairs: Vec::new(),
            made: Vec::new(),
            solution: Vec::new(),
            blocked: None,
        }
    }

    /// `Exhausted` once every branch has been looked into.
    pub fn iterate(&mut self, ground: &Ground, stats: &mut FleetStats) -> Status {
        if let Some(mut work) = self.work.take() {
            match work.iterate(ground, stats) {
                Done::Not => self.work = Some(work),
                Done::Branch => self.made.push(work.branch),
                Done::Nothing(blocked) => self.blocked = Some(blocked),
            }
            return Status::Running;
        }
        if let Some([first, second]) = self.pairs.pop()
            && let Some(parent) = &self.parent
        {
            // Who goes before a robot does not give way to it.
            if !parent.is_above(second, first) {
                let mut branch = parent.clone();
                branch.put_above(first, second);
                let left = branch.lowest_first(second);
                stats.restarts += 1;
                self.work = Some(Work { branch, left, must: vec![second], planning: None });
            }
            return Status::Running;
        }
        // The cheaper one of two is looked into first.
        sort_stably(&mut self.made, |a, b| b.cost.total_cmp(&a.cost));
        self.open.append(&mut self.made);
        let Some(branch) = self.open.pop() else { return Status::Exhausted };
        let earliest = branch.conflicts.iter().min_by(|a, b| a.1.total_cmp(b.1).then(a.0.cmp(b.0)));
        let Some((&[a, b], _)) = earliest else {
            self.solution = branch.trajectories;
            return Status::Solved;
        };
        self.pairs = vec![[a, b], [b, a]];
        self.parent = Some(branch);
        Status::Running
    }

    /// The trajectories of all robots, once solved.
    pub fn take_solution(&mut self) -> Vec<Arc<Trajectory>> {
        std::mem::take(&mut self.solution)
    }

    /// The robot that found no way last, among those above it.
    pub fn blocked(&self) -> Option<&Blocked> {
        self.blocked.as_ref()
    }
}

enum Done {
    Not,
    Branch,
    Nothing(Blocked),
}

impl Work {
    fn iterate(&mut self, ground: &Ground, stats: &mut FleetStats) -> Done {
        let Some((robot, above, search)) = &mut self.planning else {
            return self.next();
        };
        let robot = *robot;
        if self.must.contains(&robot) {
            let scene = ground.scene(robot, &self.branch.trajectories, above);
            let search = search.get_or_insert_with(|| ground.search(&scene));
            match search.step(&scene, &mut stats.pair_checks) {
                Expansion::Vertex => stats.expanded += 1,
                Expansion::Part => {}
                Expansion::Found(trajectory) => {
                    self.branch.trajectories[robot] = Arc::new(trajectory);
                    self.must.retain(|one| *one != robot);
                }
                Expansion::Nothing(by) => return Done::Nothing(Blocked { robot, by: by.unwrap_or_default() }),
            }
            return Done::Not;
        }
        let Branch { trajectories, conflicts, .. } = &mut self.branch;
        conflicts.retain(|pair, _| !pair.contains(&robot));
        for other in (0..trajectories.len()).filter(|&other| other != robot && !self.must.contains(&other)) {
            let pair = [robot.min(other), robot.max(other)];
            if let Some(time) = ground.first_conflict(pair, trajectories, &mut stats.pair_checks) {
                conflicts.insert(pair, time);
            }
        }
        self.planning = None;
        Done::Not
    }

    /// Takes the next robot that has to plan again.
    fn next(&mut self) -> Done {
        while let Some(robot) = self.left.pop() {
            let above = Arc::clone(&self.branch.above[robot]);
            let is_hit = |other: &usize| self.branch.conflicts.contains_key(&[robot.min(*other), robot.max(*other)]);
            if self.must.contains(&robot) || above.iter().any(is_hit) {
                if !self.must.contains(&robot) {
                    self.must.push(robot);
                }
                self.planning = Some((robot, above, None));
                return Done::Not;
            }
        }
        self.branch.cost = self.branch.trajectories.iter().map(|one| one.arrival()).sum();
        Done::Branch
    }
}

/// Every robot at its start.
pub(super) fn standing(fleet: &Fleet) -> Vec<Arc<Trajectory>> {
    let stand = |member: &super::FleetRobot| Arc::new(Trajectory::standing(super::document::pose(&member.start)));
    fleet.robots().iter().map(stand).collect()
}
