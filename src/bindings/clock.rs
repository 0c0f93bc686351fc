//! Stepping by the clock of the page, the worker or Node. The core itself reads no clock.

use crate::Error;
use crate::error::Code;
use crate::problem::{Phase, Stepped};
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::prelude::*;
use web_sys::Performance;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(thread_local_v2, js_name = performance)]
    static PERFORMANCE: Performance;
}

/// The most iterations between two readings of the clock: cheap iterations outweigh the reading, expensive ones do not stall.
const LONGEST_SLICE: u64 = 64;

/// What a function of the caller's has thrown.
#[derive(Clone, Default)]
pub(super) struct Thrown(Rc<RefCell<Option<JsValue>>>);

impl Thrown {
    pub fn note(&self, thrown: JsValue) {
        *self.0.borrow_mut() = Some(thrown);
    }

    /// What has been thrown, if that is the error.
    pub fn or(&self, error: Error) -> JsValue {
        let thrown = self.0.borrow().clone().filter(|_| error.code() == Code::CallbackFailed);
        thrown.unwrap_or_else(|| error.into())
    }
}

/// A run, and the time spent on it.
pub(super) struct Timed<R> {
    pub run: R,
    /// Milliseconds spent building and searching.
    spent: [f64; 2],
    pub thrown: Thrown,
}

impl<R: Stepped> Timed<R> {
    pub fn new(run: R) -> Self {
        Self { run, spent: [0.0; 2], thrown: Thrown::default() }
    }

    /// Returns an error if the run has ended with one.
    pub fn check(&self) -> Result<(), JsValue> {
        self.run.failure().map_or(Ok(()), |error| Err(self.thrown.or(error)))
    }

    /// Seconds spent building and searching, in whole nanoseconds: browsers tell fractions of these that differ between equal
    /// times.
    pub fn seconds(&self) -> [f64; 2] {
        self.spent.map(|milliseconds| libm::rint(milliseconds * 1e6) / 1e9)
    }
}

/// Steps in slices; the time of a slice counts for the phase it began in. A slice doubles while twice its time fits a quarter of
/// the budget, halves when it took more than that, and starts from one iteration in each phase, since the costs of phases differ
/// by a factor of a hundred. So the budget, in milliseconds, is exceeded by less than a quarter.
///
/// A clock that a caller has replaced may call the run: no borrow is held while the clock is read.
pub(super) fn advance<R: Stepped>(cell: &std::cell::RefCell<Timed<R>>, iterations: u64, budget: f64) {
    let began = PERFORMANCE.with(Performance::now);
    let (mut now, mut left, mut slice) = (began, iterations, 1);
    let mut phase = cell.borrow().run.phase();
    while left > 0 {
        let asked = slice.min(left);
        let before = cell.borrow().run.iterations();
        cell.borrow_mut().run.step(asked);
        let made = cell.borrow().run.iterations() - before;
        let took = PERFORMANCE.with(Performance::now) - now;
        now += took;
        cell.borrow_mut().spent[usize::from(matches!(phase, Phase::Searching | Phase::Improving))] += took;
        left -= made;
        let room = (budget / 4.0).min(budget - (now - began));
        // A run that made fewer iterations than requested is over.
        if made < asked || room <= 0.0 {
            break;
        }
        let reached = cell.borrow().run.phase();
        if reached != phase {
            slice = 1;
        } else if took > room {
            slice = (slice / 2).max(1);
        } else if 2.0 * took <= room {
            slice = (2 * slice).min(LONGEST_SLICE);
        }
        phase = reached;
    }
}

/// The methods that step a class of one [`Timed`] run.
macro_rules! stepped {
    ($Class:ident) => {
        #[wasm_bindgen]
        impl $Class {
            /// Makes at most `n` iterations, and none once the status is no longer `running`.
            pub fn step(&self, n: &$crate::bindings::types::JsNumber) -> Result<Status, wasm_bindgen::JsValue> {
                $crate::bindings::clock::advance(&self.0, $crate::bindings::arguments::count(n, "n")?, f64::INFINITY);
                self.0.borrow().check().map(|()| self.status())
            }

            /// Makes iterations for about `ms` milliseconds, one at least. The budget is exceeded by less than a quarter.
            #[wasm_bindgen(js_name = stepFor)]
            pub fn step_for(&self, ms: &$crate::bindings::types::JsNumber) -> Result<Status, wasm_bindgen::JsValue> {
                $crate::bindings::clock::advance(
                    &self.0,
                    u64::MAX,
                    $crate::bindings::arguments::not_negative(ms, "ms")?,
                );
                self.0.borrow().check().map(|()| self.status())
            }
        }
    };
}
pub(super) use stepped;
