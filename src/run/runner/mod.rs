//! A run of a planner on a problem; its path is improved afterwards if requested. `run.rs` is its outside, `report.rs` what it
//! reports.

mod report;
mod run;

use super::Run;
use super::info::{EmptyRoadmap, Reopen, RunInfo};
use super::termination::{Limiting, Progress};
use super::work::Weights;
use crate::path::Improvement;
use crate::planner::{Phase, Planner, Reason, Status};
use crate::problem::Problem;
use crate::space::Space;
use std::cell::Cell;

/// The run of one planner on one problem.
pub(super) struct Runner<S: Space> {
    problem: Problem<S>,
    planner: Box<dyn Planner<S>>,
    info: RunInfo,
    /// Makes the document of the roadmap without vertices and edges; `None` if it cannot be saved.
    roadmap: Option<EmptyRoadmap>,
    /// `None` if no scenario describes the problem.
    reopen: Option<Reopen<S>>,
    /// Iterations of the planner.
    iteration: u32,
    status: Status,
    /// Why the run has ended without a path, or with one before all was done that was asked.
    reason: Option<Reason>,
    limiting: Limiting,
    weights: Weights,
    /// The costs of the paths so far, if the planner goes on to better ones.
    progress: Option<Progress>,
    /// The cost of the planner's path, and that by the planner's count for which it was computed; infinite without a path.
    path_cost: f64,
    cost: f64,
    /// The path being improved, once the planner has solved the problem.
    improvement: Option<Improvement<S>>,
    /// The rows of recorded iterations that have not been taken yet; `None` if iterations are not recorded.
    history: Option<Vec<f64>>,
    /// Clearance evaluations and unproven motions on behalf of viewers, not of the run.
    viewer_work: Cell<[u64; 2]>,
}

impl<S: Space> Runner<S> {
    pub(super) fn new(
        problem: Problem<S>,
        planner: Box<dyn Planner<S>>,
        info: RunInfo,
        roadmap: Option<EmptyRoadmap>,
        reopen: Option<Reopen<S>>,
    ) -> Self {
        // A motion by controls may end before the goal.
        let least = if info.is_driven { 0.0 } else { problem.distance_to_goal(problem.start()) };
        let progress = info.termination.map(|termination| Progress::new(termination, least));
        Self {
            limiting: Limiting::new(info.limits),
            weights: Weights::of(&problem),
            problem,
            planner,
            info,
            roadmap,
            reopen,
            iteration: 0,
            status: Status::Running,
            reason: None,
            progress,
            path_cost: f64::INFINITY,
            cost: f64::INFINITY,
            improvement: None,
            history: None,
            viewer_work: Cell::default(),
        }
    }

    /// One iteration: of the planner, or an attempt at improving its path.
    fn iterate(&mut self) {
        let Some(improvement) = &mut self.improvement else { return self.iterate_planner() };
        improvement.attempt(&self.problem);
        if improvement.is_done() {
            self.status = Status::Solved;
        }
    }

    fn iterate_planner(&mut self) {
        self.iteration += 1;
        self.status = self.planner.iterate(&self.problem, self.iteration);
        if self.history.is_some() || self.progress.is_some() {
            self.measure();
        }
        match self.status {
            Status::Solved => self.accept(),
            Status::Running => self.end_if_over(),
            Status::Exhausted => self.reason = Some(self.planner.reason()),
            Status::Failed => {}
        }
    }

    /// Ends the run if a limit is reached, or if a planner that goes on is to end.
    fn end_if_over(&mut self) {
        let evaluations = self.evaluations();
        let is_complete = self.progress.as_ref().is_some_and(|progress| progress.is_over(self.iteration, evaluations));
        let limit = if is_complete { None } else { self.limit() };
        if !is_complete && limit.is_none() {
            return;
        }
        if self.has_path() {
            self.reason = limit;
            self.accept();
        } else {
            (self.status, self.reason) = (Status::Exhausted, limit.or(Some(Reason::EvaluationLimit)));
        }
    }

    /// The limit that ends the run, whether or not there is a path.
    fn limit(&mut self) -> Option<Reason> {
        if self.iteration == u32::MAX {
            return Some(Reason::IterationLimit);
        }
        match self.limiting.exceeded(self.iteration, self.work()) {
            Some(reason) => (!self.goes_on()).then_some(reason),
            None => self.planner.is_full().then_some(Reason::GraphFull),
        }
    }

    /// Whether the run goes on although a limit is spent: limits hold while there is no path. A planner that goes on to shorter
    /// paths ends as its conditions say; where these may never hold, once a limit is spent without a shorter path. A tree that
    /// grows past its goal ends once a limit is spent without a new vertex, and a planner that ends by itself, with the samples
    /// that it was given, once the default limit is.
    fn goes_on(&mut self) -> bool {
        let (vertices, has_path) = (self.vertex_count(), self.has_path());
        let gained = match &self.progress {
            Some(progress) if has_path => {
                !progress.may_never_end(self.iteration) || self.limiting.has_gained(progress.falls())
            }
            None if has_path => self.limiting.has_gained(vertices),
            _ if self.info.is_finite && self.info.limits.are_default() => {
                self.planner.phase() != Phase::Sampling || self.limiting.has_gained(vertices)
            }
            _ => false,
        };
        if gained {
            self.limiting.begin_again(self.iteration, self.work());
        }
        gained
    }

    /// What is found for viewers and results: its work is not counted as that of the run.
    fn for_viewers<T>(&self, find: impl FnOnce() -> T) -> T {
        let validity = self.problem.validity();
        let work = || [validity.clearance_evaluations(), validity.unproven_motions()];
        let (before, counted) = (work(), self.viewer_work.get());
        let found = find();
        let after = work();
        self.viewer_work.set([0, 1].map(|i| counted[i] + after[i] - before[i]));
        found
    }

    /// Clearance evaluations of the run so far.
    fn evaluations(&self) -> u64 {
        let own = self.problem.validity().clearance_evaluations() - self.viewer_work.get()[0];
        self.planner.growth().counters.clearance_evaluations + own
    }

    /// The work of the planner so far.
    fn work(&self) -> u64 {
        self.weights.work(u64::from(self.iteration), self.planner.growth(), self.evaluations())
    }

    /// Computes the cost of the planner's path, if that has changed. O(1) if not.
    fn measure(&mut self) {
        let cost = self.planner.cost();
        if cost == self.cost && self.path_cost < f64::INFINITY {
            return;
        }
        let path = self.raw();
        if path.states.is_empty() {
            return;
        }
        (self.cost, self.path_cost) = (cost, path.cost);
        if let Some(progress) = &mut self.progress {
            progress.note(self.iteration, self.path_cost, cost);
        }
    }

    /// Whether the planner has a path already, which it improves or grows past.
    fn has_path(&self) -> bool {
        !self.planner.path().is_empty()
    }

    /// Accepts the planner's path as it is now.
    fn accept(&mut self) {
        let graph = self.planner.graph();
        let path: Vec<S::State> = self.planner.path().into_iter().map(|vertex| *graph.state(vertex)).collect();
        assert!(!path.is_empty(), "a planner that has returned `Solved` has a path");
        let improvement = Improvement::new(path, self.info.wanted, self.info.seed);
        self.status = if improvement.is_done() { Status::Solved } else { Status::Running };
        self.improvement = Some(improvement);
    }

    /// The cost of the best path so far; infinite while there is none.
    fn cost(&self) -> f64 {
        if let Some(improvement) = self.improvement.as_ref().filter(|_| self.planner.graph().motions().is_empty()) {
            return self.for_viewers(|| self.problem.path_cost(improvement.path()));
        }
        self.path_cost
    }
}
