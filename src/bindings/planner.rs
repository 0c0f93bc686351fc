//! A planning run in JavaScript's hands.

use super::convert::{count, cursor, record, throw};
use crate::error::{Code, Error};
use crate::path::ResultDocument;
use crate::problem::{Phase, Stats};
use crate::run::storage::RoadmapDocument;
use crate::run::{EVENT_HEAD, HISTORY_WIDTH, Run};
use std::cell::{Cell, RefCell};
use wasm_bindgen::prelude::*;
use web_sys::Performance;

/// A planning run. Arrays handed out are copies and stay valid.
#[wasm_bindgen]
pub struct RawPlanner {
    // A clock that a caller has replaced may ask the planner: no borrow is held while the clock is read.
    run: RefCell<Box<dyn Run>>,
    /// Milliseconds spent building and searching.
    spent: Cell<[f64; 2]>,
}

#[wasm_bindgen]
extern "C" {
    /// The clock of the page, the worker or Node.
    #[wasm_bindgen(thread_local_v2, js_name = performance)]
    static PERFORMANCE: Performance;
}

/// The most iterations between two looks at the clock: cheap iterations still outweigh the look, expensive ones do not stall.
const LONGEST_SLICE: u64 = 64;

impl RawPlanner {
    pub(super) fn new(run: Box<dyn Run>) -> Self {
        Self { run: RefCell::new(run), spent: Cell::default() }
    }

    /// Steps in slices; the time of a slice counts for the phase it began in. A slice doubles while two of it would fit a
    /// quarter of the budget, halves when it took more than that, and starts from one iteration in each phase, since the costs
    /// of phases differ by a factor of a hundred. So the budget, in milliseconds, is exceeded by less than a quarter.
    fn advance(&self, iterations: u64, budget: f64) -> u8 {
        let began = PERFORMANCE.with(Performance::now);
        let (mut now, mut left, mut slice) = (began, iterations, 1);
        let mut phase = self.run.borrow().phase();
        while left > 0 {
            let asked = slice.min(left);
            let before = self.run.borrow().iterations();
            self.run.borrow_mut().step(asked);
            let made = self.run.borrow().iterations() - before;
            let took = PERFORMANCE.with(Performance::now) - now;
            now += took;
            let mut spent = self.spent.get();
            spent[usize::from(matches!(phase, Phase::Searching | Phase::Improving))] += took;
            self.spent.set(spent);
            left -= made;
            let room = (budget / 4.0).min(budget - (now - began));
            // A run that made fewer than it was asked for is over.
            if made < asked || room <= 0.0 {
                break;
            }
            let reached = self.run.borrow().phase();
            if reached != phase {
                slice = 1;
            } else if took > room {
                slice = (slice / 2).max(1);
            } else if 2.0 * took <= room {
                slice = (2 * slice).min(LONGEST_SLICE);
            }
            phase = reached;
        }
        self.status()
    }

    /// What was counted, with the time spent.
    fn timed(&self, stats: Stats) -> Stats {
        let [build_seconds, search_seconds] = self.spent.get().map(|milliseconds| milliseconds / 1000.0);
        Stats { build_seconds, search_seconds, ..stats }
    }

    fn document(&self) -> Result<RoadmapDocument, JsValue> {
        let sentence = "this planner builds no roadmap that could be kept";
        self.run.borrow().roadmap().ok_or_else(|| throw(Error::new(Code::Unsupported, "", sentence)))
    }
}

#[wasm_bindgen]
impl RawPlanner {
    /// Makes at most `iterations` iterations; returns the status.
    pub fn step(&self, iterations: f64) -> Result<u8, JsValue> {
        Ok(self.advance(count(iterations, "n").map_err(throw)?, f64::INFINITY))
    }

    /// Makes iterations for about `milliseconds`, one at least; returns the status.
    pub fn step_for(&self, milliseconds: f64) -> u8 {
        self.advance(u64::MAX, milliseconds)
    }

    /// Takes the path as it is while it is being improved.
    pub fn finish(&self) {
        self.run.borrow_mut().finish();
    }

    /// Asks a built roadmap for another path; returns a result document.
    pub fn query(&self, start: &[f64], goal: &[f64], keep: bool) -> Result<JsValue, JsValue> {
        self.run.borrow_mut().query(start, goal, keep).map(|result| record(&result)).map_err(throw)
    }

    /// The roadmap as JSON text.
    pub fn roadmap_text(&self) -> Result<String, JsValue> {
        Ok(self.document()?.to_json())
    }

    /// The roadmap in its binary form.
    pub fn roadmap_bytes(&self) -> Result<Vec<u8>, JsValue> {
        Ok(self.document()?.to_bytes())
    }

    /// The roadmap as GraphML.
    pub fn roadmap_graphml(&self) -> Result<String, JsValue> {
        Ok(self.document()?.to_graphml())
    }

    /// 0 where the run goes on, 1 where it is solved, 2 where it is exhausted.
    pub fn status(&self) -> u8 {
        self.run.borrow().status() as u8
    }

    /// What the run is busy with: the number of the phase.
    pub fn phase(&self) -> u8 {
        self.run.borrow().phase() as u8
    }

    /// Has every iteration leave a row behind.
    pub fn record(&self) -> Result<(), JsValue> {
        self.run.borrow_mut().record().map_err(throw)
    }

    /// The rows left behind since the last call, `history_width` numbers each.
    pub fn take_history(&self) -> Vec<f64> {
        self.run.borrow_mut().take_history()
    }

    /// Numbers a row of the history.
    pub fn history_width(&self) -> usize {
        HISTORY_WIDTH
    }

    /// Iterations made so far.
    pub fn iterations(&self) -> f64 {
        self.run.borrow().iterations() as f64
    }

    /// Numbers a configuration.
    pub fn dimension(&self) -> usize {
        self.run.borrow().dimension()
    }

    /// Numbers an event row.
    pub fn event_width(&self) -> usize {
        EVENT_HEAD + self.run.borrow().dimension()
    }

    /// Vertices so far.
    pub fn vertex_count(&self) -> usize {
        self.run.borrow().vertex_count()
    }

    /// Edges so far.
    pub fn edge_count(&self) -> usize {
        self.run.borrow().edge_count()
    }

    /// Events so far.
    pub fn event_count(&self) -> usize {
        self.run.borrow().event_count()
    }

    /// The vertices from row `row` on, `dimension` numbers each.
    pub fn vertices_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        Ok(self.run.borrow().vertices_since(cursor(row, self.run.borrow().vertex_count())?))
    }

    /// The edges from row `row` on, two vertex numbers each.
    pub fn edges_since(&self, row: f64) -> Result<Vec<u32>, JsValue> {
        Ok(self.run.borrow().edges_since(cursor(row, self.run.borrow().edge_count())?))
    }

    /// What is done along the edges from row `row` on: edge, speed, steering angle, duration each.
    pub fn motions_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        Ok(self.run.borrow().motions_since(cursor(row, self.run.borrow().edge_count())?))
    }

    /// What the edges from row `row` on look like that are not straight: edge and configuration each.
    pub fn traces_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        Ok(self.run.borrow().traces_since(cursor(row, self.run.borrow().edge_count())?))
    }

    /// The events from row `row` on, `event_width` numbers each.
    pub fn events_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        Ok(self.run.borrow().events_since(cursor(row, self.run.borrow().event_count())?))
    }

    /// The configurations that the run may end at, in rows of `dimension`.
    pub fn goals(&self) -> Vec<f64> {
        self.run.borrow().goals().concat()
    }

    /// The path, `dimension` numbers a waypoint; empty until solved.
    pub fn path(&self) -> Vec<f64> {
        self.run.borrow().path().concat()
    }

    /// The path as the planner found it, in the same form.
    pub fn raw_path(&self) -> Vec<f64> {
        self.run.borrow().raw_path().concat()
    }

    /// For rows of two configurations, from and to, the fraction where the motion is first refused; 1 where it is free.
    pub fn first_hits(&self, ends: &[f64]) -> Result<Vec<f64>, JsValue> {
        self.run.borrow_mut().first_hits(ends).map_err(throw)
    }

    /// What was counted.
    pub fn stats(&self) -> JsValue {
        record(&self.timed(self.run.borrow().stats()))
    }

    /// The result document.
    pub fn result(&self) -> JsValue {
        let result = self.run.borrow().result();
        record(&ResultDocument { stats: self.timed(result.stats), ..result })
    }

    /// 16 hexadecimal digits over every vertex, edge and event.
    pub fn fingerprint(&self) -> String {
        format!("{:016x}", self.run.borrow().fingerprint())
    }
}
