//! A run of a planner on a problem; its path is improved afterwards if requested.

use super::emitted::{self, EmittedPath};
use super::info::{Reopen, RunInfo};
use super::termination::{Limiting, Progress};
use super::work::Weights;
use super::{EVENT_HEAD, Event, HISTORY_WIDTH, Run, questions, sealed};
use crate::error::{Code, Error};
use crate::graph::MAX_RECORDS;
use crate::options::Choice;
use crate::path::{self, Approximate, Blending, Improvement, ResultDocument};
use crate::planner::{EdgeCheck, Limits, Phase, Planner, Reason, Status};
use crate::problem::{Motion, Problem, Stats};
use crate::run::storage::RoadmapDocument;
use crate::space::Space;
use crate::world::PlanningWorld;

/// The name of further queries in result documents.
const ASKED: &str = "asked";

/// The run of one planner on one problem.
pub(super) struct Runner<S: Space> {
    problem: Problem<S>,
    planner: Box<dyn Planner<S>>,
    info: RunInfo,
    /// The document of the roadmap without vertices and edges; `None` for planners that build none.
    roadmap: Option<RoadmapDocument>,
    /// `None` if no scenario describes the problem.
    reopen: Option<Reopen<S>>,
    /// Iterations of the planner.
    iteration: u32,
    status: Status,
    /// Why the run has ended without a path, or with one before all was done that was asked.
    reason: Option<Reason>,
    limiting: Limiting,
    weights: Weights,
    /// The lengths of the paths so far, if the planner goes on to shorter ones.
    progress: Option<Progress>,
    /// The length of the planner's path, and the planner's cost for which it was computed; both are infinite without a path.
    length: f64,
    cost: f64,
    /// The path being improved, once the planner has solved the problem.
    improvement: Option<Improvement<S>>,
    /// The rows of recorded iterations that have not been taken yet; `None` if iterations are not recorded.
    history: Option<Vec<f64>>,
    /// Clearance evaluations and unproven motions on behalf of viewers, not of the run.
    viewer_work: [u64; 2],
}

impl<S: Space> Runner<S> {
    pub(super) fn new(
        problem: Problem<S>,
        planner: Box<dyn Planner<S>>,
        info: RunInfo,
        roadmap: Option<RoadmapDocument>,
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
            length: f64::INFINITY,
            cost: f64::INFINITY,
            improvement: None,
            history: None,
            viewer_work: [0; 2],
        }
    }

    /// The word for edges that are not proven.
    fn edge_check(&self) -> Option<String> {
        let word = if self.info.is_learned { "rollouts" } else { self.info.edge_check.word() };
        (self.info.is_learned || self.info.edge_check != EdgeCheck::Proven).then(|| word.to_owned())
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

    /// Clearance evaluations of the run so far.
    fn evaluations(&self) -> u64 {
        let own = self.problem.validity().clearance_evaluations() - self.viewer_work[0];
        self.planner.growth().counters.clearance_evaluations + own
    }

    /// The work of the planner so far.
    fn work(&self) -> u64 {
        self.weights.work(u64::from(self.iteration), self.planner.growth(), self.evaluations())
    }

    /// Computes the length of the planner's path, if that has changed. O(1) if not.
    fn measure(&mut self) {
        let cost = self.planner.cost();
        if cost == self.cost && self.length < f64::INFINITY {
            return;
        }
        let path = self.raw();
        if path.states.is_empty() {
            return;
        }
        (self.cost, self.length) = (cost, path.length);
        if let Some(progress) = &mut self.progress {
            progress.note(self.iteration, self.length, cost);
        }
    }

    /// Whether the planner has a path already, which it improves or grows past.
    fn has_path(&self) -> bool {
        !self.planner.path().is_empty()
    }

    /// Accepts the planner's path as it is now.
    fn accept(&mut self) {
        let graph = self.planner.graph();
        let path = self.planner.path().into_iter().map(|vertex| *graph.state(vertex)).collect();
        let improvement = Improvement::new(path, self.info.wanted, self.info.seed);
        self.status = if improvement.is_done() { Status::Solved } else { Status::Running };
        self.improvement = Some(improvement);
    }

    /// The length of the best path so far; infinite while there is none.
    fn cost(&self) -> f64 {
        if let Some(improvement) = self.improvement.as_ref().filter(|_| self.planner.graph().motions().is_empty()) {
            return path::length(self.problem.space(), improvement.path());
        }
        self.length
    }

    /// A row of the history: the present state of the run.
    fn history_row(&self) -> [f64; HISTORY_WIDTH] {
        let stats = self.stats();
        [
            stats.vertices as f64,
            stats.edges as f64,
            self.event_count() as f64,
            f64::from(self.phase() as u8),
            stats.configuration_checks as f64,
            stats.motion_checks as f64,
            stats.clearance_evaluations as f64,
            self.cost(),
        ]
    }

    /// The planner's path as it found it; empty until then.
    fn raw(&self) -> EmittedPath<S> {
        EmittedPath::along(&self.problem, self.planner.graph(), &self.planner.path())
    }

    /// The path as it is reported; empty until solved.
    fn emitted(&self) -> EmittedPath<S> {
        match &self.improvement {
            // A path of controlled motions is reported as it was found: it cannot be improved.
            Some(_) if self.status == Status::Solved && !self.planner.graph().motions().is_empty() => self.raw(),
            Some(improvement) if self.status == Status::Solved => match improvement.blending() {
                Some(Blending { path, shares, .. }) => {
                    EmittedPath::cornered(&self.problem, path.clone(), shares.clone())
                }
                None => EmittedPath::through(&self.problem, improvement.path()),
            },
            _ => EmittedPath::through(&self.problem, &[]),
        }
    }

    fn rows(&self, states: &[S::State]) -> Vec<Vec<f64>> {
        states.iter().map(|state| self.problem.space().coordinates(state).to_vec()).collect()
    }

    /// The path to the vertex nearest to the goal, for planners that have one, if they gave up.
    fn approximate(&self) -> Option<Approximate> {
        let vertices = self.planner.approximate_path();
        if self.status != Status::Exhausted || vertices.is_empty() {
            return None;
        }
        let nearest = self.planner.graph().state(vertices[vertices.len() - 1]);
        let goal_distance = self.problem.distance_to_goal(nearest);
        let path = EmittedPath::along(&self.problem, self.planner.graph(), &vertices);
        Some(Approximate { path: self.rows(&path.states), motions: path.motions, goal_distance })
    }

    /// The goal of a path with this end, if it was moved; without a path, and where it ends in a region about its goal, the
    /// first.
    fn moved_goal(&self, end: Option<&Vec<f64>>) -> Option<&Vec<f64>> {
        let moved = &self.info.moved_goals;
        let reached = end.filter(|_| self.problem.goals().len() > 1);
        reached.map_or(moved.first(), |end| moved.iter().find(|&goal| goal == end))
    }

    /// A reason in words.
    fn explained(&self, reason: Reason) -> String {
        let Limits { max_iterations, .. } = self.info.limits;
        let termination = self.info.termination.unwrap_or_default();
        let number = match reason {
            Reason::IterationLimit => u64::from(max_iterations.unwrap_or(u32::MAX)),
            Reason::WorkLimit => self.info.limits.work(),
            Reason::EvaluationLimit => termination.stop_evaluations.unwrap_or_default(),
            Reason::VertexLimit => self.info.vertices.map_or(0, u64::from),
            Reason::GraphFull => MAX_RECORDS as u64,
            _ => self.vertex_count() as u64,
        };
        let is_unsearched = self.planner.roadmap().is_some() && self.planner.growth().counters.visited == 0;
        let before = if is_unsearched { ", before the roadmap was searched" } else { "" };
        reason.sentence(number, self.has_path()) + before
    }

    fn document(
        &self,
        query: &str,
        (status, reason): (Status, Option<Reason>),
        path: EmittedPath<S>,
    ) -> ResultDocument {
        let is_driven = !self.planner.graph().motions().is_empty() && !path.states.is_empty();
        let length = path.length;
        let saving = path::blend_saving(self.problem.space(), &path.states, &path.blends);
        let is_blended = !path.blends.is_empty();
        ResultDocument {
            scenario: self.info.scenario.clone(),
            query: query.to_owned(),
            planner: self.info.planner.to_owned(),
            seed: self.info.seed,
            status,
            reason,
            explanation: reason.map(|reason| self.explained(reason)),
            path: self.rows(&path.states),
            length,
            length_measure: self.info.measure,
            blended_length: is_blended.then_some(length - saving),
            blends: is_blended.then_some(path.blends),
            chord_length: is_driven.then(|| path::length(self.problem.space(), &path.states)),
            motions: path.motions,
            integration: self.info.is_euler.then(|| "euler".to_owned()),
            stats: self.stats(),
            fingerprint: self.fingerprint(),
            edge_check: self.edge_check(),
            coverage: self.planner.coverage(),
            moved_start: None,
            moved_goal: None,
            approximate: None,
        }
    }
}

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
        let validity = self.problem.validity();
        let work = || [validity.clearance_evaluations(), validity.unproven_motions()];
        let before = work();
        let hits = motions.iter().map(|[from, to]| validity.first_hit(from, to).unwrap_or(1.0)).collect();
        let after = work();
        (0..2).for_each(|i| self.viewer_work[i] += after[i] - before[i]);
        self.failure().map_or(Ok(hits), Err)
    }

    fn stats(&self) -> Stats {
        let counters = self.planner.growth().counters;
        let improvement_checks = self.improvement.as_ref().map_or(0, |improvement| improvement.motion_checks);
        let validity = self.problem.validity();
        let [evaluations, unproven] = self.viewer_work;
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
        let document = RoadmapDocument { k: roadmap.connection.k() as u32, ..self.roadmap.clone()? };
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
        let ended = match found.path.is_empty() {
            true => (Status::Exhausted, Some(Reason::NotConnected)),
            false => (Status::Solved, None),
        };
        let path = EmittedPath::through(&self.problem, &found.path);
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
