//! What a run reports: its path, its counts, and its result document.

use super::Runner;
use crate::collision::KeepAway;
use crate::graph::MAX_RECORDS;
use crate::options::Choice;
use crate::path::{self, Approximate, Blending, PathCost, ResultDocument};
use crate::planner::{EdgeCheck, Limits, Reason, Status};
use crate::run::emitted::EmittedPath;
use crate::run::{HISTORY_WIDTH, Run};
use crate::space::Space;

impl<S: Space> Runner<S> {
    /// The planner's path as it found it; empty until then.
    pub(super) fn raw(&self) -> EmittedPath<S> {
        self.for_viewers(|| EmittedPath::along(&self.problem, self.planner.graph(), &self.planner.path()))
    }

    /// The path as it is reported; empty until solved.
    pub(super) fn emitted(&self) -> EmittedPath<S> {
        self.for_viewers(|| match &self.improvement {
            // A path of controlled motions is reported as it was found: it cannot be improved.
            Some(_) if self.status == Status::Solved && !self.planner.graph().motions().is_empty() => self.raw(),
            Some(improvement) if self.status == Status::Solved => match improvement.blending() {
                Some(Blending { path, shares, .. }) => {
                    EmittedPath::cornered(&self.problem, path.clone(), shares.clone())
                }
                None => EmittedPath::through(&self.problem, improvement.path()),
            },
            _ => EmittedPath::through(&self.problem, &[]),
        })
    }

    pub(super) fn rows(&self, states: &[S::State]) -> Vec<Vec<f64>> {
        states.iter().map(|state| self.problem.space().coordinates(state).to_vec()).collect()
    }

    /// The path to the vertex nearest to the goal, for planners that have one, if they gave up.
    pub(super) fn approximate(&self) -> Option<Approximate> {
        let vertices = self.planner.approximate_path();
        if self.status != Status::Exhausted || vertices.is_empty() {
            return None;
        }
        let nearest = self.planner.graph().state(vertices[vertices.len() - 1]);
        let goal_distance = self.problem.distance_to_goal(nearest);
        let path = self.for_viewers(|| EmittedPath::along(&self.problem, self.planner.graph(), &vertices));
        Some(Approximate { path: self.rows(&path.states), motions: path.motions, goal_distance })
    }

    /// The goal of a path with this end, if it was moved; without a path, and where it ends in a region about its goal, the
    /// first.
    pub(super) fn moved_goal(&self, end: Option<&Vec<f64>>) -> Option<&Vec<f64>> {
        let moved = &self.info.moved_goals;
        let reached = end.filter(|_| self.problem.goals().len() > 1);
        reached.map_or(moved.first(), |end| moved.iter().find(|&goal| goal == end))
    }

    /// A reason in words.
    pub(super) fn explained(&self, reason: Reason) -> String {
        let Limits { max_iterations, .. } = self.info.limits;
        let termination = self.info.termination.unwrap_or_default();
        let number = match reason {
            Reason::IterationLimit => u64::from(max_iterations.unwrap_or(self.iteration)),
            Reason::WorkLimit => self.info.limits.work(),
            Reason::EvaluationLimit => termination.stop_evaluations.unwrap_or_else(|| self.evaluations()),
            Reason::VertexLimit => self.info.vertices.map_or(self.vertex_count() as u64, u64::from),
            Reason::GraphFull => MAX_RECORDS as u64,
            _ => self.vertex_count() as u64,
        };
        let is_unsearched = self.planner.roadmap().is_some() && self.planner.growth().counters.visited == 0;
        let before = if is_unsearched { ", before the roadmap was searched" } else { "" };
        reason.sentence(number, self.has_path()) + before
    }

    pub(super) fn document(
        &self,
        query: &str,
        (status, reason): (Status, Option<Reason>),
        path: EmittedPath<S>,
    ) -> ResultDocument {
        let is_driven = !self.planner.graph().motions().is_empty() && !path.states.is_empty();
        let (length, value) = (path.length, path.cost);
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
            cost: self.info.keep_away.map(|KeepAway { weight, within }| PathCost { value, weight, within }),
            margin: (self.info.margin > 0.0).then_some(self.info.margin),
            stats: self.stats(),
            fingerprint: self.fingerprint(),
            edge_check: self.edge_check(),
            coverage: self.planner.coverage(),
            moved_start: None,
            moved_goal: None,
            approximate: None,
        }
    }

    /// The word for edges that are not proven.
    pub(super) fn edge_check(&self) -> Option<String> {
        let word = if self.info.is_learned { "rollouts" } else { self.info.edge_check.word() };
        (self.info.is_learned || self.info.edge_check != EdgeCheck::Proven).then(|| word.to_owned())
    }

    /// A row of the history: the present state of the run.
    pub(super) fn history_row(&self) -> [f64; HISTORY_WIDTH] {
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
}
