//! A planning run for JavaScript.

use super::convert::{count, cursor, digits, record};
use crate::error::{Code, Error};
use crate::path::ResultDocument;
use crate::problem::{Phase, Stats};
use crate::run::storage::RoadmapDocument;
use crate::run::{EVENT_HEAD, HISTORY_WIDTH, Run};
use std::cell::{Cell, RefCell};
use wasm_bindgen::prelude::*;
use web_sys::Performance;

/// A planning run.
#[wasm_bindgen]
pub struct RawPlanner {
    // A clock that a caller has replaced may call the planner: no borrow is held while the clock is read.
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

/// The most iterations between two readings of the clock: cheap iterations outweigh the reading, expensive ones do not stall.
const LONGEST_SLICE: u64 = 64;

impl RawPlanner {
    pub(super) fn new(run: Box<dyn Run>) -> Self {
        Self { run: RefCell::new(run), spent: Cell::default() }
    }

    /// Steps in slices; the time of a slice counts for the phase it began in. A slice doubles while twice its time fits a
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
            // A run that made fewer iterations than requested is over.
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

    /// The counts with the time spent.
    fn timed(&self, stats: Stats) -> Stats {
        let [build_seconds, search_seconds] = self.spent.get().map(|milliseconds| milliseconds / 1000.0);
        Stats { build_seconds, search_seconds, ..stats }
    }

    fn document(&self) -> Result<RoadmapDocument, Error> {
        let sentence = "this planner builds no roadmap that could be saved";
        self.run.borrow().roadmap().ok_or_else(|| Error::new(Code::Unsupported, "", sentence))
    }
}

#[wasm_bindgen]
impl RawPlanner {
    /// Makes at most `iterations` iterations; returns the status.
    pub fn step(&self, iterations: f64) -> Result<u8, Error> {
        Ok(self.advance(count(iterations, "n")?, f64::INFINITY))
    }

    /// Makes iterations for about `milliseconds`, one at least; returns the status.
    pub fn step_for(&self, milliseconds: f64) -> u8 {
        self.advance(u64::MAX, milliseconds)
    }

    /// Ends the improvement of the path.
    pub fn finish(&self) {
        self.run.borrow_mut().finish();
    }

    /// Queries a built roadmap for another path; returns a result document.
    pub fn query(&self, start: &[f64], goal: &[f64], keep: bool) -> Result<JsValue, Error> {
        self.run.borrow_mut().query(start, goal, keep).map(|result| record(&result))
    }

    /// The roadmap as JSON text.
    pub fn roadmap_text(&self) -> Result<String, Error> {
        Ok(self.document()?.to_json())
    }

    /// The roadmap in its binary form.
    pub fn roadmap_bytes(&self) -> Result<Vec<u8>, Error> {
        Ok(self.document()?.to_bytes())
    }

    /// The roadmap as GraphML.
    pub fn roadmap_graphml(&self) -> Result<String, Error> {
        Ok(self.document()?.to_graphml())
    }

    /// Records a row for every iteration from now on.
    pub fn record(&self) -> Result<(), Error> {
        self.run.borrow_mut().record()
    }

    /// The vertices from row `row` on, `dimension` numbers each.
    pub fn vertices_since(&self, row: f64) -> Result<Vec<f64>, Error> {
        Ok(self.run.borrow().vertices_since(cursor(row, self.vertex_count())?))
    }

    /// The edges from row `row` on, two vertex numbers each.
    pub fn edges_since(&self, row: f64) -> Result<Vec<u32>, Error> {
        Ok(self.run.borrow().edges_since(cursor(row, self.edge_count())?))
    }

    /// The motions along the edges from row `row` on: edge, speed, steering angle, duration each.
    pub fn motions_since(&self, row: f64) -> Result<Vec<f64>, Error> {
        Ok(self.run.borrow().motions_since(cursor(row, self.edge_count())?))
    }

    /// The curves of the edges from row `row` on that are not straight: edge and configuration each.
    pub fn traces_since(&self, row: f64) -> Result<Vec<f64>, Error> {
        Ok(self.run.borrow().traces_since(cursor(row, self.edge_count())?))
    }

    /// The events from row `row` on, `event_width` numbers each.
    pub fn events_since(&self, row: f64) -> Result<Vec<f64>, Error> {
        Ok(self.run.borrow().events_since(cursor(row, self.event_count())?))
    }

    /// For rows of two configurations, from and to, the fraction at which the motion is first refused; 1 if it is free.
    pub fn first_hits(&self, ends: &[f64]) -> Result<Vec<f64>, Error> {
        self.run.borrow_mut().first_hits(ends)
    }
}

getters! { RawPlanner(self)
    /// 0 while running, 1 if solved, 2 if exhausted.
    status: u8 = self.run.borrow().status() as u8;
    phase: u8 = self.run.borrow().phase() as u8;
    /// The rows recorded since the last call, `history_width` numbers each.
    take_history: Vec<f64> = self.run.borrow_mut().take_history();
    /// Numbers per row of the history.
    history_width: usize = HISTORY_WIDTH;
    iterations: f64 = self.run.borrow().iterations() as f64;
    /// Numbers per configuration.
    dimension: usize = self.run.borrow().dimension();
    /// Numbers per event row.
    event_width: usize = EVENT_HEAD + self.dimension();
    vertex_count: usize = self.run.borrow().vertex_count();
    edge_count: usize = self.run.borrow().edge_count();
    event_count: usize = self.run.borrow().event_count();
    /// The configurations at which the run may end, in rows of `dimension`.
    goals: Vec<f64> = self.run.borrow().goals().concat();
    /// The path, `dimension` numbers per waypoint; empty until solved.
    path: Vec<f64> = self.run.borrow().path().concat();
    /// The path as the planner found it, in the same form.
    raw_path: Vec<f64> = self.run.borrow().raw_path().concat();
    stats: JsValue = record(&self.timed(self.run.borrow().stats()));
    result: JsValue = {
        let result = self.run.borrow().result();
        record(&ResultDocument { stats: self.timed(result.stats), ..result })
    };
    /// 16 hexadecimal digits over every vertex, edge and event.
    fingerprint: String = digits(self.run.borrow().fingerprint());
}
