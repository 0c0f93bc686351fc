//! Motions proven free by lower bounds on clearance alone: the collision checker of a custom robot.
//!
//! A clearance c at a configuration is a ball of radius c about it without collision. A motion is proven free if balls about some
//! of its configurations cover it: Schwarzer, Saha and Latombe 2005, "Adaptive dynamic collision checking for single and multiple
//! articulated robots in complex environments"; LaValle 2006, "Planning Algorithms", section 5.3.4.
//!
//! ```text
//! is_motion_free(motion):
//!     open = [the whole motion]
//!     while an interval is open:
//!         evaluate the clearance in the middles of all open intervals, in one batch
//!         for each interval:
//!             no clearance?                       the motion is refused
//!             the ball covers it?                 drop it
//!             shorter than twice the tolerance?   the motion is refused
//!             else                                the parts on either side of the ball are open
//!     the motion is free
//! ```
//!
//! **Measure.** The clearance is given in the metric of the space, or in the workspace with the *reach* of each coordinate: a
//! number r such that no point of the robot moves farther than r |d| while the coordinate changes by d. A motion with the
//! differences d_i then moves nothing farther than the sum of r_i |d_i|.
//!
//! **Slack.** A ball covers less than its clearance, by eta = 1e-12 times the largest coordinates of the motion in the same
//! measure, and a configuration is free if its clearance exceeds that. It covers the rounding of this file, which stays below ten
//! units in the last place (2e-15 of the same number): that of the middles, of the distance, and of where balls end. The rest is
//! for rounding in the clearance.
//!
//! **Tolerance.** An open interval whose half is shorter than tau counts as hit: tau = max(10 eta, min(t, half the clearance of
//! the start and of each goal)), t a fraction of the largest distance in the space. So a motion with a true clearance above tau +
//! eta is proven if the bounds are exact.
//!
//! **Budget.** A motion gets [`BUDGET`] evaluations. One that needs more is refused as not proven, and counted.

use super::{Contact, Touched, Validity};
use crate::error::{Code, Error, Number};
use crate::space::{MAX_DIMENSION, Space, gap};
use std::cell::{Cell, RefCell};
use std::f64::consts::PI;
use std::sync::Arc;

/// Evaluates configurations, in rows of as many numbers as the space has coordinates, and writes a number for each.
#[cfg(not(target_arch = "wasm32"))]
pub type Evaluate = Arc<dyn Fn(&[f64], &mut [f64]) -> Result<(), Error> + Send + Sync>;
/// Evaluates configurations, in rows of as many numbers as the space has coordinates, and writes a number for each.
#[cfg(target_arch = "wasm32")]
pub type Evaluate = Arc<dyn Fn(&[f64], &mut [f64]) -> Result<(), Error>>;

/// The most evaluations of one motion.
const BUDGET: usize = 1 << 14;

/// The most configurations of a batch.
pub(crate) const LONGEST_BATCH: usize = 256;

/// The part of the largest coordinates that is left for rounding.
const SLACK: f64 = 1e-12;

/// The least tolerance, in multiples of the slack.
const FEWEST_SLACKS: f64 = 10.0;

/// A circle that turns by this or more has no shorter way.
const LONGEST_TURN: f64 = PI - 1e-9;

/// A collision checker that knows a lower bound on the clearance of configurations.
pub struct ClearanceValidity<S: Space> {
    space: S,
    clearance: Evaluate,
    /// How far any point of the robot moves at most per unit of each coordinate; `None` if clearances are in the metric of the
    /// space.
    reach: Option<[f64; MAX_DIMENSION]>,
    tolerance: f64,
    /// Rows and results of a batch, which batches reuse.
    buffers: RefCell<(Vec<f64>, Vec<f64>)>,
    evaluations: Cell<u64>,
    unproven: Cell<u64>,
    failure: RefCell<Option<Error>>,
}

impl<S: Space> ClearanceValidity<S> {
    /// The checker of a robot by its clearance: 0 or less in collision, infinite where nothing is near. With a `reach`, one
    /// number of at least 0 for each coordinate, clearances are distances in the workspace, else in the metric of the space,
    /// along whose motions distances have to grow evenly. `tolerance` is a fraction of the largest distance.
    ///
    /// An evaluation may fail; a result that is not a number is a failure, too, with the code `not-finite`.
    ///
    /// # Panics
    /// Unless `reach` has a number for each coordinate.
    pub fn new(space: S, clearance: Evaluate, reach: Option<&[f64]>, tolerance: f64) -> Self {
        let reach = reach.map(|reach| {
            assert!(reach.len() == space.dimension(), "one reach for each of {} coordinates", space.dimension());
            std::array::from_fn(|i| reach.get(i).copied().unwrap_or(0.0))
        });
        let mut validity = Self {
            space,
            clearance,
            reach,
            tolerance: 0.0,
            buffers: RefCell::default(),
            evaluations: Cell::new(0),
            unproven: Cell::new(0),
            failure: RefCell::new(None),
        };
        validity.tolerance = tolerance * validity.extent();
        validity
    }

    /// The same with a tolerance no coarser than half the clearance of each of these states, so that motions can start and end
    /// there.
    #[must_use]
    pub fn fitted(mut self, states: &[S::State]) -> Self {
        let mut tolerance = self.tolerance;
        // A failure stays: the next caller gets it too.
        let _ = self.evaluate(states, |_, clearance| {
            if clearance > 0.0 {
                tolerance = tolerance.min(clearance / 2.0);
            }
            true
        });
        self.tolerance = tolerance;
        self
    }

    /// How far the robot moves at most, from the gaps of the coordinates.
    fn measure(&self, mut gap: impl FnMut(usize) -> f64) -> f64 {
        match &self.reach {
            Some(reach) => (0..self.space.dimension()).map(|i| reach[i] * gap(i)).sum::<f64>() + 0.0,
            None => self.space.norm(gap),
        }
    }

    /// The largest distance between two states that are drawn.
    fn extent(&self) -> f64 {
        if self.reach.is_none() {
            return self.space.extent();
        }
        let corner = |at| self.space.at(&[at; MAX_DIMENSION]);
        let [low, high] = [corner(0.0), corner(1.0f64.next_down())];
        let [low, high] = [&low, &high].map(|corner| self.space.coordinates(corner));
        self.measure(|i| (high[i] - low[i]).abs().min(self.space.period(i) / 2.0))
    }

    /// How far the robot moves at most from `a` to `b`.
    fn travel(&self, a: &S::State, b: &S::State) -> f64 {
        if self.reach.is_none() {
            return self.space.distance(a, b);
        }
        let [from, to] = [a, b].map(|state| self.space.coordinates(state));
        self.measure(|i| gap(from[i], to[i], self.space.period(i)))
    }

    /// What is left for rounding on the motion from `a` to `b`.
    fn slack(&self, a: &S::State, b: &S::State, travel: f64) -> f64 {
        let [from, to] = [a, b].map(|state| self.space.coordinates(state));
        SLACK * self.measure(|i| from[i].abs().max(to[i].abs())).max(travel)
    }

    /// Evaluates states in batches, and passes the number of each and its clearance on until `go_on` says no. `None` if an
    /// evaluation fails, or one has failed before.
    fn evaluate(&self, states: &[S::State], mut go_on: impl FnMut(usize, f64) -> bool) -> Option<()> {
        // Taken, not borrowed: the caller's code runs meanwhile.
        let (mut rows, mut clearances) = self.buffers.take();
        let mut evaluate = || {
            for (batch, states) in states.chunks(LONGEST_BATCH).enumerate() {
                if self.failure.borrow().is_some() {
                    return None;
                }
                rows.resize(states.len() * self.space.dimension(), 0.0);
                for (row, state) in rows.chunks_exact_mut(self.space.dimension().max(1)).zip(states) {
                    // The sum makes -0 a 0, and keeps the compiler from a copy of memory: WebAssembly is slow to copy a few
                    // bytes.
                    row.iter_mut().zip(self.space.coordinates(state)).for_each(|(to, from)| *to = from + 0.0);
                }
                clearances.clear();
                clearances.resize(states.len(), f64::NAN);
                self.evaluations.set(self.evaluations.get() + states.len() as u64);
                let result =
                    (self.clearance)(&rows, &mut clearances).and_then(|()| self.refuse_nan(&rows, &clearances));
                if let Err(error) = result {
                    *self.failure.borrow_mut() = Some(error);
                    return None;
                }
                for (i, &clearance) in clearances.iter().enumerate() {
                    if !go_on(batch * LONGEST_BATCH + i, clearance) {
                        return Some(());
                    }
                }
            }
            Some(())
        };
        let done = evaluate();
        self.buffers.replace((rows, clearances));
        done
    }

    fn refuse_nan(&self, rows: &[f64], clearances: &[f64]) -> Result<(), Error> {
        let Some(i) = clearances.iter().position(|clearance| clearance.is_nan()) else { return Ok(()) };
        let q = &rows[i * self.space.dimension()..][..self.space.dimension()];
        Err(Error::new(
            Code::NotFinite,
            "",
            format!("no number was written for the configuration {q:?}, or one that is NaN"),
        ))
    }

    /// Whether a clearance is more than what is left for rounding at the state. That is 0 or more: most clearances of samples do
    /// not need it.
    fn is_beyond_slack(&self, state: &S::State, clearance: f64) -> bool {
        clearance == f64::INFINITY || (clearance > 0.0 && clearance > self.slack(state, state, 0.0))
    }

    /// The clearance of one state, and whether it is free; `None` if the evaluation has failed.
    fn clearance(&self, state: &S::State) -> Option<(f64, bool)> {
        let mut found = f64::NAN;
        self.evaluate(std::slice::from_ref(state), |_, clearance| {
            found = clearance;
            true
        })?;
        Some((found, self.is_beyond_slack(state, found)))
    }

    /// The start, as a fraction of the motion, of an interval that cannot be proven free; `None` if all of it is proven. With
    /// `wants_first` it is the first such interval, and all before it is proven.
    fn unproven(&self, a: &S::State, b: &S::State, wants_first: bool) -> Option<f64> {
        if self.space.turn(a, b) >= LONGEST_TURN {
            return Some(0.0);
        }
        let travel = self.travel(a, b);
        let slack = self.slack(a, b, travel);
        let tolerance = self.tolerance.max(FEWEST_SLACKS * slack);
        // In the order of the motion; none begins after the first hit found.
        let (mut open, mut hit, mut left) = (vec![[0.0, 1.0]], None, BUDGET);
        let (mut next, mut middles) = (Vec::new(), Vec::new());
        while !open.is_empty() {
            if open.len() > left {
                self.unproven.set(self.unproven.get() + 1);
                return Some(open[0][0]);
            }
            left -= open.len();
            middles.clear();
            middles.extend(open.iter().map(|[low, high]| self.space.interpolate(a, b, 0.5 * (low + high))));
            next.clear();
            let done = self.evaluate(&middles, |i, clearance| {
                let [low, high] = open[i];
                let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
                // As a fraction of the motion, of which all is covered if it moves nothing.
                let (is_free, covered) = (clearance > slack, (clearance - slack) / travel);
                if is_free && covered >= (middle - low).max(high - middle) {
                    return true;
                }
                let is_short = half * travel < tolerance;
                if is_free && !is_short {
                    next.extend([[low, middle - covered], [middle + covered, high]]);
                    return true;
                }
                hit = Some(low);
                if !is_short {
                    next.push([low, middle]);
                }
                false
            });
            if done.is_none() || (hit.is_some() && !wants_first) {
                return Some(open[0][0]);
            }
            std::mem::swap(&mut open, &mut next);
        }
        hit
    }
}

impl<S: Space> Validity<S::State> for ClearanceValidity<S> {
    /// One contact, of part 0 with obstacle 0, if the clearance is not greater than the slack.
    fn contacts(&self, state: &S::State) -> Vec<Contact> {
        let is_free = self.is_free(state);
        (!is_free).then_some(Contact { part: 0, with: Touched::Obstacle(0) }).into_iter().collect()
    }

    fn is_motion_free(&self, a: &S::State, b: &S::State) -> bool {
        self.unproven(a, b, false).is_none()
    }

    fn is_free(&self, state: &S::State) -> bool {
        self.clearance(state).is_some_and(|(_, is_free)| is_free)
    }

    fn are_free(&self, states: &[S::State]) -> bool {
        let mut are_free = true;
        let done = self.evaluate(states, |i, clearance| {
            are_free = self.is_beyond_slack(&states[i], clearance);
            are_free
        });
        done.is_some() && are_free
    }

    fn collision(&self, state: &S::State) -> Option<String> {
        match self.clearance(state) {
            Some((_, true)) => None,
            Some((f64::NEG_INFINITY, _)) => Some("it is not free".to_owned()),
            Some((clearance, _)) => Some(format!("its clearance is {}", Number(clearance))),
            None => Some("it cannot be evaluated".to_owned()),
        }
    }

    fn first_hit(&self, a: &S::State, b: &S::State) -> Option<f64> {
        self.unproven(a, b, true)
    }

    fn failure(&self) -> Option<Error> {
        self.failure.borrow().clone()
    }

    /// A call of a function from outside, a share of a batch.
    fn evaluation_nanoseconds(&self) -> u64 {
        200
    }

    fn clearance_evaluations(&self) -> u64 {
        self.evaluations.get()
    }

    fn unproven_motions(&self) -> u64 {
        self.unproven.get()
    }
}
