//! Joint walks: all robots first go towards places drawn at random, and from there to their goals.
//!
//! A random tree over the joint configurations of the roadmaps, whose local planner is the joint move (Solovey, Salzman and
//! Halperin 2016, "Finding a needle in an exponential haystack: discrete RRT for exploration of implicit roadmaps in multi-robot
//! motion planning"). A walk begins at a configuration that an earlier one came to, or at the starts. Half of the robots are
//! drawn a place to go to first, and go before the others, which go to their goals: so some step aside to where nobody else wants
//! to go, as into a bay, and others pass. Then all go to their goals.

use super::joint_move::{JointMove, Moved, timed};
use super::priority_tree::Ground;
use super::result::FleetStats;
use super::trajectory::Trajectory;
use crate::problem::Status;
use crate::random::{Random, Stream};
use std::sync::Arc;

/// The most moves of each half of a walk, as a multiple of the edges that lead from the farthest vertex to a goal.
const MOVES: [f64; 2] = [20.0, 2.0];

/// A walk begins at the starts once in this number of times.
const AFRESH: u64 = 4;

/// The walks. An iteration tries one vertex for one robot, or computes the distances to one place.
pub(super) struct Walks {
    goals: Vec<u32>,
    /// The configurations that walks went through, each with that before it; the first is that of the starts.
    tree: Vec<(Arc<[u32]>, usize)>,
    /// The last configuration of every walk.
    ends: Vec<usize>,
    /// The most moves of half a walk.
    moves: u32,
    walk: Option<Walk>,
    random: Random,
    solution: Vec<Arc<Trajectory>>,
}

struct Walk {
    at: usize,
    /// The distances to the places that were drawn, or to the goals, of all robots once it has begun.
    distances: Vec<Arc<[f64]>>,
    /// First the robots that have been drawn a place, then the others; the other way round in the second half.
    order: Vec<usize>,
    /// How many have been drawn a place.
    drawn: usize,
    /// The moves left to the places, and to the goals.
    left: [u32; 2],
    chosen: Option<JointMove>,
}

impl Walks {
    /// The walks of a seed.
    pub fn new(ground: &Ground, seed: u64) -> Self {
        let robots = 0..ground.fleet.kinds().len();
        let ends: Vec<[u32; 2]> =
            robots.map(|robot| ground.roadmaps[ground.fleet.kinds()[robot]].ends(robot)).collect();
        let [starts, goals] = [0, 1].map(|end| ends.iter().map(|ends| ends[end]).collect::<Vec<u32>>());
        let random = Random::new(seed, Stream::Moves);
        let (tree, ends) = (vec![(starts.into(), 0)], vec![0]);
        let edges = |robot: usize| {
            let distances = ground.distances[robot].iter().copied().filter(|distance| distance.is_finite());
            distances.fold(0.0, f64::max) / ground.roadmaps[ground.fleet.kinds()[robot]].mean_way()
        };
        let most = (0..goals.len()).map(edges).filter(|edges| edges.is_finite()).fold(0.0, f64::max);
        let moves = (MOVES[0] + MOVES[1] * most) as u32;
        Self { goals, tree, ends, moves, walk: None, random, solution: Vec::new() }
    }

    /// `Solved` once a walk comes to the goals.
    pub fn iterate(&mut self, ground: &Ground, stats: &mut FleetStats) -> Status {
        let Some(walk) = &mut self.walk else {
            self.begin();
            return Status::Running;
        };
        if walk.distances.len() < self.goals.len() {
            let robot = walk.distances.len();
            let roadmap = &ground.roadmaps[ground.fleet.kinds()[robot]];
            let distances = if self.random.below(2) == 0 {
                walk.order.push(robot);
                Arc::clone(&ground.distances[robot])
            } else {
                let at = self.random.below(walk.drawn as u64 + 1) as usize;
                walk.order.insert(at, robot);
                walk.drawn += 1;
                let place = self.random.below(roadmap.vertex_count() as u64) as u32;
                roadmap.distances_to(place).into()
            };
            walk.distances.push(distances);
            return Status::Running;
        }
        let is_first = walk.left[0] > 0;
        let towards = Ground { distances: if is_first { &walk.distances } else { ground.distances }, ..*ground };
        let before = walk.at;
        let chosen =
            walk.chosen.get_or_insert_with(|| JointMove::new(self.tree[before].0.to_vec(), &walk.order, Vec::new()));
        match chosen.iterate(&towards, &mut self.random, 0.0, stats) {
            Moved::NotYet => return Status::Running,
            Moved::To(at) if at[..] != self.tree[before].0[..] => {
                let is_there = at == self.goals;
                self.tree.push((at.into(), before));
                walk.at = self.tree.len() - 1;
                walk.left[usize::from(!is_first)] -= 1;
                if is_there {
                    let mut numbers = vec![walk.at];
                    while let number = numbers[numbers.len() - 1]
                        && number > 0
                    {
                        numbers.push(self.tree[number].1);
                    }
                    let chain: Vec<_> = numbers.iter().rev().map(|&number| Arc::clone(&self.tree[number].0)).collect();
                    self.solution = timed(ground, &chain);
                    return Status::Solved;
                }
            }
            // Nobody moves, or nobody can: that part of the walk is over.
            Moved::To(_) | Moved::Nowhere => walk.left[usize::from(!is_first)] = 0,
        }
        walk.chosen = None;
        if is_first && walk.left[0] == 0 {
            self.ends.push(walk.at);
            walk.order.reverse();
        }
        if walk.left[1] == 0 {
            self.walk = None;
        }
        Status::Running
    }

    /// Begins a walk.
    fn begin(&mut self) {
        let afresh = self.random.below(AFRESH) == 0;
        let at = if afresh { 0 } else { self.ends[self.random.below(self.ends.len() as u64) as usize] };
        let (distances, order) = (Vec::new(), Vec::new());
        self.walk = Some(Walk { at, distances, order, drawn: 0, left: [self.moves; 2], chosen: None });
    }

    /// The trajectories of all robots, once solved.
    pub fn take_solution(&mut self) -> Vec<Arc<Trajectory>> {
        std::mem::take(&mut self.solution)
    }
}
