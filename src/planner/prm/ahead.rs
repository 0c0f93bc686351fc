//! A batch computed ahead by several threads. Samples are checked and vertices connected in blocks, and each iteration takes its
//! result, and the counts of the work behind it, in turn. So graph, events and counts are those of one thread after every
//! iteration, whatever the number of threads.
//!
//! Motions are tried in one direction or both, as on one thread. Samplers that check for collisions draw on one thread, and the
//! last few samples and vertices are left to it.

use super::connect::{Connect, candidates};
use crate::graph::{EventKind, VertexId};
use crate::nearest::Direction;
use crate::planner::growth::Growth;
use crate::planner::roadmap::Roadmap;
use crate::problem::{Checkers, Problem, Validity};
use crate::sampling::Sampler;
use crate::space::Space;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::collections::VecDeque;
use std::sync::Mutex;

/// The fewest samples or vertices that are worth waking the threads.
const FEWEST: usize = 64;

/// How many samples each thread checks at a time: about a millisecond.
const SAMPLES: usize = 2048;

/// How many motions each thread tries at a time: about ten milliseconds.
const MOTIONS: usize = 16_384;

/// How many times each thread takes some samples or vertices of a block, so that all end at about the same time.
const TURNS: usize = 128;

/// The clearance evaluations and unproven motions behind a result.
type Work = [u64; 2];

/// The motions that a vertex tries in one direction, and whether each is free.
type Tried = Vec<([VertexId; 2], bool)>;

/// The results that no iteration has taken yet.
pub(super) struct Ahead<S: Space> {
    pool: Option<ThreadPool>,
    /// Samples, and whether each is free.
    samples: VecDeque<((S::State, bool), Work)>,
    /// By vertex and direction, and how many vertices the query has visited.
    motions: VecDeque<((Tried, usize), Work)>,
}

impl<S: Space> Default for Ahead<S> {
    fn default() -> Self {
        Self { pool: None, samples: VecDeque::new(), motions: VecDeque::new() }
    }
}

impl<S: Space> Ahead<S> {
    /// The threads, if the run has several, the items are worth waking them, and the system starts them.
    fn threads<'a>(&'a mut self, problem: &'a Problem<S>, items: usize) -> Option<Threads<'a, S>> {
        let (checkers, count) = (problem.checkers.as_ref()?, problem.threads.get());
        if count == 1 || items < FEWEST {
            return None;
        }
        let pool = match self.pool.take().filter(|pool| pool.current_num_threads() == count) {
            Some(pool) => pool,
            None => ThreadPoolBuilder::new().num_threads(count).build().ok()?,
        };
        Some(Threads { pool: self.pool.insert(pool), checkers })
    }

    /// Whether every result was taken.
    pub fn is_empty(&self) -> bool {
        self.motions.is_empty()
    }

    /// An iteration that tries a sample, of `left` to be added at least; `false` if it is to be done on one thread.
    pub fn sample(
        &mut self,
        roadmap: &mut Roadmap<S>,
        problem: &Problem<S>,
        iteration: u32,
        sampler: &mut dyn Sampler<S>,
        left: usize,
    ) -> bool {
        if self.samples.is_empty()
            && sampler.is_blind()
            && let Some(threads) = self.threads(problem, left)
        {
            let count = left.min(SAMPLES * threads.pool.current_num_threads());
            let states: Vec<_> = (0..count).map(|_| sampler.draw(problem, &mut 0).state).collect();
            self.samples = threads.check(&states, |checker, state| (*state, checker.is_free(state))).into();
        }
        let Some(((state, is_free), work)) = self.samples.pop_front() else { return false };
        count(&mut roadmap.growth, work);
        roadmap.growth.counters.configuration_checks += 1;
        if is_free {
            roadmap.add_vertex(problem.space(), iteration, state);
        } else {
            roadmap.growth.reject(EventKind::SampleRejected, iteration, state);
        }
        true
    }

    /// An iteration that connects the next vertex; `false` if it is to be done on one thread.
    pub fn connect(
        &mut self,
        roadmap: &mut Roadmap<S>,
        problem: &Problem<S>,
        iteration: u32,
        left: &mut dyn ExactSizeIterator<Item = VertexId>,
        connect: &mut Connect,
    ) -> bool {
        let directions = Direction::all(problem.space());
        if self.motions.is_empty()
            && let Some(threads) = self.threads(problem, left.len())
        {
            let count = MOTIONS * threads.pool.current_num_threads() / roadmap.connection.k().max(1);
            let vertices = left.take(count.max(FEWEST));
            let block: Vec<_> = vertices.flat_map(|v| directions.iter().map(move |&d| (v, d))).collect();
            self.motions = threads.connect(roadmap, problem.space(), &block, connect).into();
        }
        if self.motions.is_empty() {
            return false;
        }
        for ((tried, visited), work) in self.motions.drain(..directions.len()) {
            count(&mut roadmap.growth, work);
            roadmap.growth.note_visited(problem.space(), visited);
            roadmap.growth.counters.nearest_queries += 1;
            roadmap.growth.counters.motion_checks += tried.len() as u64;
            roadmap.growth.looked += tried.len() as u64;
            for ([from, to], is_free) in tried {
                roadmap.add_tried(iteration, from, to, is_free);
            }
        }
        true
    }
}

/// Several threads, and collision checkers for them.
struct Threads<'a, S: Space> {
    pool: &'a ThreadPool,
    checkers: &'a Checkers<S::State>,
}

impl<S: Space> Threads<'_, S> {
    /// The result of every item, in their order. Each thread begins with a state of its own and takes the next few items until
    /// there are no more.
    fn map<T: Sync, R: Send, I>(
        &self,
        items: &[T],
        begin: impl Fn() -> I + Sync,
        result: impl Fn(&mut I, &T) -> R + Sync,
    ) -> Vec<R> {
        let mut results: Vec<Option<R>> = items.iter().map(|_| None).collect();
        let threads = self.pool.current_num_threads();
        let few = (items.len() / (TURNS * threads)).max(1);
        let next = Mutex::new(items.chunks(few).zip(results.chunks_mut(few)));
        let take = || next.lock().expect("no thread has panicked").next();
        self.pool.install(|| {
            (0..threads).into_par_iter().with_max_len(1).for_each(|_| {
                let mut state = begin();
                while let Some((items, results)) = take() {
                    items.iter().zip(results).for_each(|(item, to)| *to = Some(result(&mut state, item)));
                }
            });
        });
        results.into_iter().flatten().collect()
    }

    /// The result of every item by a collision checker, in their order, and the work behind each.
    fn check<T: Sync, R: Send>(
        &self,
        items: &[T],
        result: impl Fn(&dyn Validity<S::State>, &T) -> R + Sync,
    ) -> Vec<(R, Work)> {
        let work = |checker: &dyn Validity<S::State>| [checker.clearance_evaluations(), checker.unproven_motions()];
        self.map(items, self.checkers, |checker, item| {
            let before = work(&**checker);
            let result = result(&**checker, item);
            let after = work(&**checker);
            (result, [after[0] - before[0], after[1] - before[1]])
        })
    }

    /// What the vertices of a block try, each in the direction beside it.
    fn connect(
        &self,
        roadmap: &Roadmap<S>,
        space: &S,
        block: &[(VertexId, Direction)],
        connect: &mut Connect,
    ) -> Vec<((Tried, usize), Work)> {
        let found = self.map(block, Vec::new, |found, &(vertex, direction)| {
            let (tried, visited) = candidates(roadmap, space, direction, vertex, found);
            (vertex, direction, tried, (visited, found.clone()))
        });
        for (vertex, direction, tried, _) in &found {
            connect.note(space, *direction, *vertex, tried.clone());
        }
        let connect = &*connect;
        self.check(&found, |checker, &(vertex, direction, _, (visited, ref found))| {
            let mut tried = Tried::with_capacity(found.len());
            for neighbour in found.iter().filter(|other| !connect.has_tried(space, direction, vertex, other)) {
                let ends @ [from, to] = direction.ends(vertex, neighbour.vertex);
                let [a, b] = [from, to].map(|end| roadmap.graph().state(end));
                tried.push((ends, checker.is_motion_free(a, b)));
            }
            (tried, visited)
        })
    }
}

/// Counts the work of another collision checker.
fn count<S: Space>(growth: &mut Growth<S>, [evaluations, unproven]: Work) {
    growth.counters.clearance_evaluations += evaluations;
    growth.counters.unproven_motions += unproven;
}
