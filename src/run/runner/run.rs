//! The runner as a [`Run`].

use super::Runner;
use crate::error::{Code, Error};
use crate::path::ResultDocument;
use crate::planner::{Limits, Phase, Reason, Status};
use crate::problem::{Motion, Stats};
use crate::run::emitted::{self, EmittedPath};
use crate::run::storage::RoadmapDocument;
use crate::run::{EVENT_HEAD, Event, HISTORY_WIDTH, Run, questions, sealed};
use crate::space::Space;
use crate::world::PlanningWorld;

/// The name of further queries in result documents.
const ASKED: &str = "asked";

impl<S: Space> sealed::Sealed for Runner<S> {}

impl<S: Space> Run for Runner<S> {
    fn step(&mut self, iterations: u64) -> Status {
        let mut left = iterations;
        while left > 0 && self.status == Status::Running {
            self.iterate();
            if self.failure().is_some() {
                self.status = Status::Failed;
            }
            if self.history.is_some() {
                let row = self.history_row();
                self.history.get_or_insert_default().extend(row);
            }
            left -= 1;
        }
        self.status
    }

    #[cfg(feature = "parallel")]
    fn set_threads(&mut self, threads: std::num::NonZeroUsize) {
        self.problem.threads = threads;
    }

    fn finish(&mut self) -> Status {
        if self.status == Status::Failed {
            return self.status;
        }
        if self.improvement.is_none() && self.has_path() {
            self.accept();
        }
        if self.improvement.is_some() {
            self.status = Status::Solved;
        }
        self.status
    }

    fn status(&self) -> Status {
        self.status
    }

    fn reason(&self) -> Option<Reason> {
        self.reason.filter(|_| self.status != Status::Running)
    }

    fn explanation(&self) -> Option<String> {
        self.reason().map(|reason| self.explained(reason))
    }

    fn failure(&self) -> Option<Error> {
        self.problem.validity().failure()
    }

    fn phase(&self) -> Phase {
        match (&self.improvement, self.status) {
            (Some(_), Status::Running) => Phase::Improving,
            (None, Status::Running) => self.planner.phase(),
            _ => Phase::Done,
        }
    }

    fn record(&mut self) -> Result<(), Error> {
        if self.history.is_none() && self.iterations() > 0 {
            let sentence = format!("recording must begin before the first iteration; {} were made", self.iterations());
            return Err(Error::new(Code::Unsupported, "", sentence));
        }
        self.history.get_or_insert_default();
        Ok(())
    }

    fn history_count(&self) -> usize {
        self.history.as_ref().map_or(0, Vec::len) / HISTORY_WIDTH
    }

    fn history_since(&self, row: usize) -> Vec<f64> {
        let rows = self.history.as_ref().and_then(|rows| rows.get(row.checked_mul(HISTORY_WIDTH)?..));
        rows.unwrap_or_default().to_vec()
    }

    fn iterations(&self) -> u64 {
        u64::from(self.iteration) + self.improvement.as_ref().map_or(0, |improvement| improvement.attempts)
    }

    fn limits(&self) -> Limits {
        self.info.limits
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

    fn vertex(&self, row: usize) -> &[f64] {
        self.problem.space().coordinates(&self.planner.graph().states()[row])
    }

    fn edge(&self, row: usize) -> [u32; 2] {
        self.planner.graph().edges()[row].map(|vertex| vertex.0)
    }

    fn event(&self, row: usize) -> Event<&[f64]> {
        let Event { kind, iteration, vertex, other, ref state } = self.planner.graph().events()[row];
        Event { kind, iteration, vertex, other, state: self.problem.space().coordinates(state) }
    }

    fn vertex_rows(&self, row: usize) -> Vec<f64> {
        let states = self.planner.graph().states().get(row..).unwrap_or_default();
        states.iter().flat_map(|state| self.problem.space().coordinates(state)).copied().collect()
    }

    fn edge_rows(&self, row: usize) -> Vec<u32> {
        let edges = self.planner.graph().edges().get(row..).unwrap_or_default();
        edges.iter().flatten().map(|vertex| vertex.0).collect()
    }

    fn motion_rows(&self, row: usize) -> Vec<f64> {
        let (graph, mut rows) = (self.planner.graph(), Vec::new());
        for edge in row..graph.edges().len() {
            for Motion { control, duration } in emitted::motions(&self.problem, graph, edge) {
                rows.extend([edge as f64, control.speed, control.steering, duration]);
            }
        }
        rows
    }

    fn trace_rows(&self, row: usize) -> Vec<f64> {
        let (graph, mut rows) = (self.planner.graph(), Vec::new());
        for edge in row..graph.edges().len() {
            for state in emitted::trace(&self.problem, graph, edge) {
                rows.push(edge as f64);
                rows.extend_from_slice(self.problem.space().coordinates(&state));
            }
        }
        rows
    }

    fn event_rows(&self, row: usize) -> Vec<f64> {
        let events = self.planner.graph().events().get(row..).unwrap_or_default();
        let mut rows = Vec::with_capacity(events.len() * (EVENT_HEAD + self.dimension()));
        for event in events {
            rows.extend([f64::from(event.kind as u8), f64::from(event.iteration)]);
            rows.extend([event.vertex, event.other].map(|vertex| vertex.map_or(-1.0, |v| f64::from(v.0))));
            rows.extend_from_slice(self.problem.space().coordinates(&event.state));
        }
        rows
    }

    fn goals(&self) -> Vec<Vec<f64>> {
        self.rows(self.problem.goals())
    }

    fn path(&self) -> Vec<Vec<f64>> {
        self.rows(&self.emitted().states)
    }

    fn raw_path(&self) -> Vec<Vec<f64>> {
        self.rows(&self.raw().states)
    }

    fn length(&self) -> f64 {
        self.emitted().length
    }

    fn first_hits(&mut self, ends: &[f64]) -> Result<Vec<f64>, Error> {
        let motions = questions::motions(self.problem.space(), ends)?;
        let first_hit = |[from, to]: &[S::State; 2]| self.problem.validity().first_hit(from, to).unwrap_or(1.0);
        let hits = self.for_viewers(|| motions.iter().map(first_hit).collect());
        self.failure().map_or(Ok(hits), Err)
    }

    fn stats(&self) -> Stats {
        let counters = self.planner.growth().counters;
        let improvement_checks = self.improvement.as_ref().map_or(0, |improvement| improvement.motion_checks);
        let validity = self.problem.validity();
        let [evaluations, unproven] = self.viewer_work.get();
        Stats {
            iterations: self.iterations(),
            work: self.work(),
            vertices: self.vertex_count() as u64,
            edges: self.edge_count() as u64,
            motion_checks: counters.motion_checks + improvement_checks,
            clearance_evaluations: counters.clearance_evaluations + validity.clearance_evaluations() - evaluations,
            unproven_motions: counters.unproven_motions + validity.unproven_motions() - unproven,
            ..counters
        }
    }

    fn fingerprint(&self) -> u64 {
        self.planner.graph().fingerprint(self.problem.space())
    }

    fn result(&self) -> ResultDocument {
        let document = self.document(&self.info.query, (self.status, self.reason()), self.emitted());
        let moved_goal = self.moved_goal(document.path.last()).cloned();
        let moved_start = self.info.moved_start.clone();
        ResultDocument { approximate: self.approximate(), moved_start, moved_goal, ..document }
    }

    fn roadmap(&self) -> Option<RoadmapDocument> {
        let roadmap = self.planner.roadmap()?;
        let (k, radius) = (roadmap.connection.k() as u32, roadmap.connection.radius());
        let document = RoadmapDocument { k, radius, ..self.roadmap.as_ref()?() };
        // Where obstacles have moved, one may be upon a vertex that no path has wanted since.
        let is_free = |(i, state)| !roadmap.is_unchecked(i) || self.problem.validity().is_free(state);
        let kept: Vec<bool> = roadmap.graph().states().iter().enumerate().map(is_free).collect();
        Some(document.filled(self.vertex_rows(0), &self.edge_rows(0), &kept))
    }

    fn query(&mut self, start: &[f64], goal: &[f64], keep: bool) -> Result<ResultDocument, Error> {
        let ends = questions::ends(self.problem.space(), start, goal)?;
        self.problem.check_ends(&ends[0], &ends[1])?;
        // A builder counts the vertices of its roadmap: these would be counted as well.
        if keep && self.status == Status::Running && self.improvement.is_none() {
            let sentence = format!(
                "start and goal can be added once the roadmap is built and searched, not while {}",
                self.phase().as_str()
            );
            return Err(Error::new(Code::Unsupported, "/keep", sentence));
        }
        let Some(roadmap) = self.planner.roadmap_mut() else {
            let sentence = format!("{} builds no roadmap to query", self.info.planner);
            return Err(Error::new(Code::Unsupported, "", sentence));
        };
        let found = roadmap.query(&self.problem, ends, keep.then_some(self.iteration));
        if let Some(error) = self.failure() {
            return Err(error);
        }
        let ended = match (found.path.is_empty(), found.is_exhaustive) {
            (true, true) => (Status::Exhausted, Some(Reason::NotConnected)),
            (true, false) => (Status::Exhausted, Some(Reason::SearchFailed)),
            (false, _) => (Status::Solved, None),
        };
        let path = self.for_viewers(|| EmittedPath::through(&self.problem, &found.path));
        Ok(self.document(ASKED, ended, path))
    }

    fn reopen(&self, world: &PlanningWorld) -> Result<Box<dyn Run>, Error> {
        let unsupported = |sentence| Err(Error::new(Code::Unsupported, "", sentence));
        let Some(reopen) = self.reopen.as_ref() else {
            return unsupported(
                "only runs of this crate's planners in a scenario can be reopened in another world".to_owned(),
            );
        };
        let Some(roadmap) = self.planner.roadmap() else {
            return unsupported(format!("{} builds no roadmap to reopen", self.info.planner));
        };
        if self.status == Status::Running {
            return unsupported(format!(
                "a roadmap can be reopened once the run is over, not while {}",
                self.phase().as_str()
            ));
        }
        reopen(world, roadmap)
    }
}
