//! One joint move: from the vertices where all robots stand, each goes to a neighbour on its roadmap or stays, all at the same
//! time.
//!
//! Okumura, Machida, Defago and Tamura 2022, "Priority inheritance with backtracking for iterative multi-agent path finding". The
//! most urgent robot chooses the vertex nearest to its goal. Whoever stands in the way of its motion chooses next, in its place,
//! and must go; if it cannot, the first one chooses its next vertex. Motions of several robots at once are proven apart in
//! continuous time: all take the same time, so the proof does not depend on how long that is.

use super::motion::{CLEAR, Motion, Pair, Pose};
use super::priority_tree::{Ground, MARGIN};
use super::result::FleetStats;
use super::trajectory::Trajectory;
use crate::geometry::sort_stably;
use crate::random::Random;
use std::sync::Arc;

/// The average number of vertices tried for each robot before a move is given up.
const TRIES: usize = 60;

/// The choice of one robot.
struct Choice {
    robot: usize,
    /// The vertices still to try, the last first.
    left: Vec<u32>,
    /// How many robots had decided before it.
    decided: usize,
    /// Whether it has decided, as long as these, which are in its way, can decide, too.
    has_decided: bool,
    pushed: Vec<usize>,
}

/// What has become of a move.
pub(super) enum Moved {
    NotYet,
    /// The vertex of every robot at its end.
    To(Vec<u32>),
    Nowhere,
}

/// A move that is being chosen. An iteration tries one vertex for one robot: the motion there against those of all others.
pub(super) struct JointMove {
    at: Vec<u32>,
    /// The robots, the most urgent first.
    order: Vec<usize>,
    /// Robots that have no choice, with their vertices.
    fixed: Vec<(usize, u32)>,
    to: Vec<Option<u32>>,
    /// The robots that have decided, in the order in which they did.
    decided: Vec<usize>,
    choices: Vec<Choice>,
    tries: usize,
}

impl JointMove {
    /// The move from these vertices. `order` has the robots, the most urgent first; those that are `fixed` come before.
    pub fn new(at: Vec<u32>, order: &[usize], fixed: Vec<(usize, u32)>) -> Self {
        let count = at.len();
        let first = fixed.iter().map(|(robot, _)| *robot);
        let order = first.chain(order.iter().copied()).collect();
        let (to, tries) = (vec![None; count], TRIES * count);
        Self { at, order, fixed, to, decided: Vec::new(), choices: Vec::new(), tries }
    }

    /// Tries one vertex. Distances to the goal count up to `1 + noise` times what they are.
    pub fn iterate(&mut self, ground: &Ground, random: &mut Random, noise: f64, stats: &mut FleetStats) -> Moved {
        if self.tries == 0 {
            return Moved::Nowhere;
        }
        self.tries -= 1;
        // Choices that need nothing more are over.
        while let Some(choice) = self.choices.last_mut().filter(|choice| choice.has_decided) {
            match choice.pushed.pop() {
                Some(robot) if self.to[robot].is_none() => self.begin(ground, robot, random, noise),
                Some(_) => {}
                None => drop(self.choices.pop()),
            }
        }
        if self.choices.is_empty() {
            match self.order.iter().copied().find(|&robot| self.to[robot].is_none()) {
                Some(robot) => self.begin(ground, robot, random, noise),
                None => return Moved::To(self.to.iter().flatten().copied().collect()),
            }
        }
        self.try_next(ground, stats)
    }

    /// Begins the choice of a robot.
    fn begin(&mut self, ground: &Ground, robot: usize, random: &mut Random, noise: f64) {
        let left = match self.fixed.iter().find(|(fixed, _)| *fixed == robot) {
            Some((_, vertex)) => vec![*vertex],
            None => {
                let roadmap = &ground.roadmaps[ground.fleet.kinds()[robot]];
                let neighbours = roadmap.neighbours(self.at[robot]).iter().map(|(vertex, _)| *vertex);
                let mut left: Vec<(f64, u32)> = neighbours
                    .chain([self.at[robot]])
                    .map(|vertex| {
                        let part = if noise > 0.0 { noise * random.uniform() } else { 0.0 };
                        (ground.distances[robot][vertex as usize] * (1.0 + part), vertex)
                    })
                    .collect();
                sort_stably(&mut left, |a, b| b.0.total_cmp(&a.0).then(b.1.cmp(&a.1)));
                left.into_iter().map(|(_, vertex)| vertex).collect()
            }
        };
        let (decided, has_decided, pushed) = (self.decided.len(), false, Vec::new());
        self.choices.push(Choice { robot, left, decided, has_decided, pushed });
    }

    /// Tries the next vertex of the last choice; without one, the choice before it is undone.
    fn try_next(&mut self, ground: &Ground, stats: &mut FleetStats) -> Moved {
        let choice = self.choices.last_mut().expect("a choice has begun");
        let robot = choice.robot;
        let Some(vertex) = choice.left.pop() else {
            self.choices.pop();
            let Some(before) = self.choices.last_mut() else { return Moved::Nowhere };
            (before.has_decided, before.pushed) = (false, Vec::new());
            for undone in self.decided.drain(before.decided..) {
                self.to[undone] = None;
            }
            return Moved::NotYet;
        };
        let footprints = ground.fleet.footprints();
        let motion = motion(ground, robot, [self.at[robot], vertex]);
        let near = motion.covered(&footprints[robot]).grown(CLEAR * MARGIN * ground.fleet.slack());
        let mut pushed = Vec::new();
        for other in (0..self.at.len()).filter(|&other| other != robot) {
            let theirs = self::motion(ground, other, [self.at[other], self.to[other].unwrap_or(self.at[other])]);
            let is_beside = theirs.covered(&footprints[other]).intersects(&near);
            if !is_beside || is_apart(ground, [other, robot], [&theirs, &motion], stats) {
                continue;
            }
            if self.to[other].is_some() {
                return Moved::NotYet;
            }
            pushed.push(other);
        }
        self.to[robot] = Some(vertex);
        self.decided.push(robot);
        (choice.has_decided, choice.pushed) = (true, pushed);
        Moved::NotYet
    }
}

/// The trajectories along joint configurations: in every move the slowest robot decides how long it takes.
pub(super) fn timed(ground: &Ground, chain: &[Arc<[u32]>]) -> Vec<Arc<Trajectory>> {
    let robots = 0..chain[0].len();
    let start = |robot: usize| Trajectory::standing(pose(ground, robot, chain[0][robot]));
    let mut trajectories: Vec<Trajectory> = robots.clone().map(start).collect();
    let mut time = 0.0;
    for ends in chain.windows(2) {
        let way = |robot: usize| [0, 1].map(|end: usize| pose(ground, robot, ends[end][robot]));
        let duration = |robot: usize| {
            let [from, to] = way(robot);
            ground.fleet.footprints()[robot].travel(from, to) / ground.fleet.robots()[robot].speed
        };
        let end = time + robots.clone().map(duration).fold(0.0, f64::max);
        for (robot, trajectory) in trajectories.iter_mut().enumerate() {
            let [from, to] = way(robot);
            if from != to {
                if trajectory.times().last() < Some(&time) {
                    trajectory.add(time, from);
                }
                trajectory.add(end, to);
            }
        }
        time = end;
    }
    trajectories.into_iter().map(Arc::new).collect()
}

/// The place of a robot at a vertex.
fn pose(ground: &Ground, robot: usize, vertex: u32) -> Pose {
    ground.roadmaps[ground.fleet.kinds()[robot]].pose(vertex)
}

/// A robot's motion between two vertices in the time that the move takes, or its stand.
fn motion(ground: &Ground, robot: usize, [from, to]: [u32; 2]) -> Motion {
    let from_pose = pose(ground, robot, from);
    if from == to {
        Motion::standing([0.0, 1.0], from_pose)
    } else {
        Motion::new([0.0, 1.0], from_pose, pose(ground, robot, to))
    }
}

/// Whether the motions of two robots are proven apart.
fn is_apart(ground: &Ground, robots: [usize; 2], motions: [&Motion; 2], stats: &mut FleetStats) -> bool {
    stats.pair_checks += 1;
    let footprints = robots.map(|robot| &ground.fleet.footprints()[robot]);
    Pair { footprints, motions, slack: MARGIN * ground.fleet.slack() }.is_apart()
}
