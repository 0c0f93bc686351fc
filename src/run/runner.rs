//! A planner at work on a problem, its path shortened afterwards where that is asked for.

use super::{EVENT_HEAD, Run};
use crate::path::{self, Shortcut};
use crate::planner::{Planner, Status};
use crate::problem::Problem;
use crate::result::ResultDocument;
use crate::space::Space;
use crate::stats::Stats;
use crate::validity::Validity;

/// The names and numbers that a run carries into its result.
#[derive(Debug, Clone)]
pub(super) struct Ticket {
    pub scenario: String,
    pub query: String,
    pub planner: &'static str,
    pub seed: u64,
    pub max_iterations: u32,
    pub shortcuts: u64,
}

/// The run of one planner on one problem.
pub(super) struct Runner<S: Space, V, P> {
    problem: Problem<S, V>,
    planner: P,
    ticket: Ticket,
    /// Iterations of the planner.
    iteration: u32,
    status: Status,
    /// The path and how many attempts at shortening it were made, once the planner has solved the problem.
    shortcut: Option<(Shortcut<S>, u64)>,
}

impl<S: Space, V: Validity<S::State>, P: Planner<S>> Runner<S, V, P> {
    pub(super) fn new(problem: Problem<S, V>, planner: P, ticket: Ticket) -> Self {
        Self { problem, planner, ticket, iteration: 0, status: Status::Running, shortcut: None }
    }

    /// One iteration: of the planner, or an attempt at shortening its path.
    fn iterate(&mut self) {
        let Some((shortcut, attempts)) = &mut self.shortcut else { return self.iterate_planner() };
        shortcut.attempt(&self.problem);
        *attempts += 1;
        if *attempts == self.ticket.shortcuts {
            self.status = Status::Solved;
        }
    }

    fn iterate_planner(&mut self) {
        self.iteration += 1;
        self.status = self.planner.iterate(&self.problem, self.iteration);
        match self.status {
            Status::Solved => {
                let graph = self.planner.graph();
                let path = self.planner.path().into_iter().map(|vertex| *graph.state(vertex)).collect();
                self.shortcut = Some((Shortcut::new(path, self.ticket.seed), 0));
                if self.ticket.shortcuts > 0 {
                    self.status = Status::Running;
                }
            }
            Status::Running if self.iteration == self.ticket.max_iterations => self.status = Status::Exhausted,
            Status::Running | Status::Exhausted => {}
        }
    }

    /// The path as it is emitted; empty until solved.
    fn states(&self) -> Vec<S::State> {
        match &self.shortcut {
            Some((shortcut, _)) if self.status == Status::Solved => path::split(self.problem.space(), shortcut.path()),
            _ => Vec::new(),
        }
    }
}

impl<S: Space, V: Validity<S::State>, P: Planner<S>> Run for Runner<S, V, P> {
    fn step(&mut self, iterations: u64) -> Status {
        let mut left = iterations;
        while left > 0 && self.status == Status::Running {
            self.iterate();
            left -= 1;
        }
        self.status
    }

    fn status(&self) -> Status {
        self.status
    }

    fn phase(&self) -> &'static str {
        match (&self.shortcut, self.status) {
            (Some(_), Status::Running) => "shortcutting",
            (None, Status::Running) => self.planner.phase(),
            _ => "done",
        }
    }

    fn iterations(&self) -> u64 {
        u64::from(self.iteration) + self.shortcut.as_ref().map_or(0, |(_, attempts)| *attempts)
    }

    fn max_iterations(&self) -> u64 {
        u64::from(self.ticket.max_iterations)
    }

    fn dimension(&self) -> usize {
        self.problem.space().dimension()
    }

    fn vertex_count(&self) -> usize {
        self.planner.graph().states().len()
    }

    fn edge_count(&self) -> usize {
        self.planner.graph().edges().len()
    }

    fn event_count(&self) -> usize {
        self.planner.graph().events().len()
    }

    fn vertices_since(&self, row: usize) -> Vec<f64> {
        let states = self.planner.graph().states().get(row..).unwrap_or_default();
        let mut rows = Vec::with_capacity(states.len() * self.dimension());
        states.iter().for_each(|state| rows.extend_from_slice(self.problem.space().coordinates(state)));
        rows
    }

    fn edges_since(&self, row: usize) -> Vec<u32> {
        let edges = self.planner.graph().edges().get(row..).unwrap_or_default();
        edges.iter().flatten().map(|vertex| vertex.0).collect()
    }

    fn events_since(&self, row: usize) -> Vec<f64> {
        let events = self.planner.graph().events().get(row..).unwrap_or_default();
        let mut rows = Vec::with_capacity(events.len() * (EVENT_HEAD + self.dimension()));
        for event in events {
            rows.extend([f64::from(event.kind as u8), f64::from(event.iteration)]);
            rows.extend([event.vertex, event.other].map(|vertex| vertex.map_or(-1.0, |v| f64::from(v.0))));
            rows.extend_from_slice(self.problem.space().coordinates(&event.state));
        }
        rows
    }

    fn path(&self) -> Vec<Vec<f64>> {
        self.states().iter().map(|state| self.problem.space().coordinates(state).to_vec()).collect()
    }

    fn length(&self) -> f64 {
        path::length(self.problem.space(), &self.states())
    }

    fn stats(&self) -> Stats {
        let counters = self.planner.counters();
        let shortcut_checks = self.shortcut.as_ref().map_or(0, |(shortcut, _)| shortcut.motion_checks());
        Stats {
            iterations: self.iterations(),
            vertices: self.vertex_count() as u64,
            edges: self.edge_count() as u64,
            configuration_checks: counters.configuration_checks,
            motion_checks: counters.motion_checks + shortcut_checks,
            nearest_queries: counters.nearest_queries,
            visited: counters.visited,
            clearance_evaluations: self.problem.validity().clearance_evaluations(),
            build_seconds: 0.0,
            search_seconds: 0.0,
        }
    }

    fn fingerprint(&self) -> u64 {
        self.planner.graph().fingerprint(self.problem.space())
    }

    fn result(&self) -> ResultDocument {
        ResultDocument {
            scenario: self.ticket.scenario.clone(),
            query: self.ticket.query.clone(),
            planner: self.ticket.planner.to_owned(),
            seed: self.ticket.seed,
            status: self.status,
            path: self.path(),
            length: self.length(),
            stats: self.stats(),
            fingerprint: self.fingerprint(),
        }
    }
}
