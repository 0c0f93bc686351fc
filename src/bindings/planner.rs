//! A planning run in JavaScript's hands.

use super::convert::{count, cursor, throw};
use crate::error::{Code, Error};
use crate::kept::RoadmapDocument;
use crate::run::{EVENT_HEAD, HISTORY_WIDTH, Run};
use wasm_bindgen::prelude::*;

/// A planning run. Arrays handed out are copies and stay valid.
#[wasm_bindgen]
pub struct RawPlanner {
    run: Box<dyn Run>,
}

impl RawPlanner {
    pub(super) fn new(run: Box<dyn Run>) -> Self {
        Self { run }
    }

    fn document(&self) -> Result<RoadmapDocument, JsValue> {
        let sentence = "this planner builds no roadmap that could be kept";
        self.run.roadmap().ok_or_else(|| throw(Error::new(Code::Unsupported, "", sentence)))
    }
}

#[wasm_bindgen]
impl RawPlanner {
    /// Does at most `iterations` iterations; answers how many it did.
    pub fn advance(&mut self, iterations: f64) -> Result<f64, JsValue> {
        let before = self.run.iterations();
        self.run.step(count(iterations, "iterations").map_err(throw)?);
        Ok((self.run.iterations() - before) as f64)
    }

    /// Takes the path as it is while it is being improved.
    pub fn finish(&mut self) {
        self.run.finish();
    }

    /// Asks a built roadmap for another path; answers a result document, as JSON text.
    pub fn query(&mut self, start: &[f64], goal: &[f64], keep: bool) -> Result<String, JsValue> {
        Ok(self.run.query(start, goal, keep).map_err(throw)?.to_json())
    }

    /// The roadmap as JSON text.
    pub fn roadmap_text(&self) -> Result<String, JsValue> {
        Ok(self.document()?.to_json())
    }

    /// The roadmap in its binary form.
    pub fn roadmap_bytes(&self) -> Result<Vec<u8>, JsValue> {
        Ok(self.document()?.to_bytes())
    }

    /// The lengths of the roadmap's edges in its metric.
    pub fn roadmap_lengths(&self) -> Result<Vec<f64>, JsValue> {
        let document = self.document()?;
        Ok(document.edges.iter().map(|&edge| document.length(edge)).collect())
    }

    /// Whether the roadmap's edges lead from their first vertex to their second only.
    pub fn is_roadmap_directed(&self) -> Result<bool, JsValue> {
        Ok(self.document()?.is_directed())
    }

    /// 0 where the run goes on, 1 where it is solved, 2 where it is exhausted.
    pub fn status(&self) -> u8 {
        self.run.status() as u8
    }

    /// What the run is busy with: the number of the phase.
    pub fn phase(&self) -> u8 {
        self.run.phase() as u8
    }

    /// Has every iteration leave a row behind.
    pub fn record(&mut self) -> Result<(), JsValue> {
        self.run.record().map_err(throw)
    }

    /// The rows left behind since the last call, `history_width` numbers each.
    pub fn take_history(&mut self) -> Vec<f64> {
        self.run.take_history()
    }

    /// Numbers a row of the history.
    pub fn history_width(&self) -> usize {
        HISTORY_WIDTH
    }

    /// Iterations made so far.
    pub fn iterations(&self) -> f64 {
        self.run.iterations() as f64
    }

    /// Numbers a configuration.
    pub fn dimension(&self) -> usize {
        self.run.dimension()
    }

    /// Numbers an event row.
    pub fn event_width(&self) -> usize {
        EVENT_HEAD + self.run.dimension()
    }

    /// Vertices so far.
    pub fn vertex_count(&self) -> usize {
        self.run.vertex_count()
    }

    /// Edges so far.
    pub fn edge_count(&self) -> usize {
        self.run.edge_count()
    }

    /// Events so far.
    pub fn event_count(&self) -> usize {
        self.run.event_count()
    }

    /// The vertices from row `row` on, `dimension` numbers each.
    pub fn vertices_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        Ok(self.run.vertices_since(cursor(row, self.run.vertex_count())?))
    }

    /// The edges from row `row` on, two vertex numbers each.
    pub fn edges_since(&self, row: f64) -> Result<Vec<u32>, JsValue> {
        Ok(self.run.edges_since(cursor(row, self.run.edge_count())?))
    }

    /// What is done along the edges from row `row` on: edge, speed, steering angle, duration each.
    pub fn motions_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        Ok(self.run.motions_since(cursor(row, self.run.edge_count())?))
    }

    /// What the edges from row `row` on look like that are not straight: edge and configuration each.
    pub fn traces_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        Ok(self.run.traces_since(cursor(row, self.run.edge_count())?))
    }

    /// The events from row `row` on, `event_width` numbers each.
    pub fn events_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        Ok(self.run.events_since(cursor(row, self.run.event_count())?))
    }

    /// The configurations that the run may end at, in rows of `dimension`.
    pub fn goals(&self) -> Vec<f64> {
        self.run.goals().concat()
    }

    /// The path, `dimension` numbers a waypoint; empty until solved.
    pub fn path(&self) -> Vec<f64> {
        self.run.path().concat()
    }

    /// The path as the planner found it, in the same form.
    pub fn raw_path(&self) -> Vec<f64> {
        self.run.raw_path().concat()
    }

    /// For rows of two configurations, from and to, the fraction where the motion is first refused; 1 where it is free.
    pub fn first_hits(&mut self, ends: &[f64]) -> Result<Vec<f64>, JsValue> {
        self.run.first_hits(ends).map_err(throw)
    }

    /// What was counted, as JSON text.
    pub fn stats(&self) -> String {
        self.run.stats().to_node().to_json()
    }

    /// The result document, as JSON text.
    pub fn result(&self) -> String {
        self.run.result().to_json()
    }

    /// 16 hexadecimal digits over every vertex, edge and event.
    pub fn fingerprint(&self) -> String {
        format!("{:016x}", self.run.fingerprint())
    }
}
