//! One planning run behind an object-safe trait: what the bindings and the command line hold.
//!
//! # How a slice of steps ends
//! A slice is one call of [`Run::step`]`(n)`. It makes iterations one after the other (`Runner::step`, `iterate` and `accept`
//! in `runner/`). It returns after `n` of them, or as soon as the status is no longer `Running`. After each iteration:
//!
//! | what happened | status |
//! |---|---|
//! | the planner is not done | `Running` |
//! | the planner has a path, and no improvement is wanted | `Solved` |
//! | the planner has a path to be improved | `Running` in the phase `Improving`; each further iteration is one attempt, and the last one ends in `Solved` |
//! | the planner knows that it finds no path | `Exhausted` |
//! | `max_iterations` are made or `max_work` is spent without a path, or the graph is full (`graph::MAX_RECORDS`) | `Exhausted` |
//! | the planner improves its path itself, or grows past the goal | `Running`, if it improves in the phase `Improving` |
//! | then the conditions of [`Termination`] hold, or it has as many `vertices` as were asked for | as if it had just found the path |
//! | or a limit is spent without a new vertex, or, where not the number of iterations but other conditions are awaited, without a shorter path, or the graph is full | the same, with a reason |
//! | `stop_evaluations` are made without a path | `Exhausted` |
//! | the collision checker of a custom robot has failed | `Failed` |
//!
//! An iteration is never interrupted, and nothing depends on where a slice ends: so 1000 slices of one iteration give the same
//! run, to the bit, as one slice of 1000. An `Exhausted` run has a [`Reason`]. A run that has ended does nothing more.
//! [`Run::finish`] takes the path as it is while it is being improved.
//!
//! # Files
//! - `options.rs`: typed options; `request.rs`: options by names; `suitable.rs`: which are for which robots;
//! - `factory.rs`: from scenario and options to a run ([`start`]); `goals.rs`: the goals of a query with a target;
//!   `own_planner.rs`: the same with a planner from outside ([`start_with`]); `custom.rs`: a run of a custom robot;
//!   `description.rs`: its space;
//! - `launch.rs`: what they share, and `info.rs`: what a run knows of how it was launched;
//! - `runner/`: the one implementation of [`Run`]; `termination.rs`: when it ends a planner; `work.rs`: what limits of work
//!   count; `emitted.rs`: paths and edges as they are reported;
//! - `resume.rs`: a run on a saved roadmap; `reopen.rs`: what has changed in a world; `questions.rs`: configurations in requests.
//!
//! Inside, planners are generic over the space and compiled for each; outside, a `Box<dyn Run>` costs one virtual call per slice.
//! A run calls its planner once per iteration, and the planner its collision checker once per check, by virtual calls. Their cost
//! is small compared with the work that they do. So a planner is compiled once per space, whatever the robot.

mod custom;
mod description;
mod emitted;
mod factory;
mod goals;
mod info;
pub mod inspect;
mod launch;
pub mod neighbours;
mod options;
mod own_planner;
mod questions;
mod reopen;
mod request;
mod resume;
mod runner;
pub mod storage;
mod suitable;
mod termination;
mod work;

pub use custom::{CustomProblem, Free, start_problem};
pub use description::{CoordinateDescription, CoordinateKind, SpaceDescription};
pub(crate) use factory::start_learned;
pub use factory::{start, start_on};
pub use options::{Options, default_planner};
pub use own_planner::{OwnPlanner, start_with};
pub use request::Request;
pub use resume::{resume, resume_problem};
pub(crate) use suitable::{LEARNED, check_use};

pub use crate::options::Value;
pub use crate::planner::{
    AorrtcOptions, BitStarOptions, EdgeOptions, FmtStarOptions, GoalBias, Improving, InformedRrtStarOptions,
    KeepingAway, LazyPrmOptions, LazyPrmStarOptions, Limits, Phase, PlannerInfo, PlannerOptions, Preset, PrmOptions,
    PrmStarOptions, Reason, RrtConnectOptions, RrtControlOptions, RrtOptions, RrtStarOptions, Sampling, Searching,
    SstOptions, Status, Termination, VisibilityPrmOptions, planners,
};

pub use crate::graph::{Event, EventKind, VertexId};

use crate::error::Error;
use crate::path::ResultDocument;
pub use crate::path::Wanted;
use crate::problem::{MaybeSend, Stats, Stepped};
use crate::run::storage::RoadmapDocument;
use crate::world::PlanningWorld;

/// Columns of an event row before its configuration: kind, iteration, vertex, other vertex.
pub const EVENT_HEAD: usize = 4;

/// The numbers of a row of [`Run::history_since`]. `phase` is a number in [`Phase::ALL`], `length` that of the best path so
/// far.
pub const HISTORY_COLUMNS: [&str; 8] = [
    "vertices",
    "edges",
    "events",
    "phase",
    "configuration_checks",
    "motion_checks",
    "clearance_evaluations",
    "length",
];

/// Numbers of a row of [`Run::history_since`].
pub const HISTORY_WIDTH: usize = HISTORY_COLUMNS.len();

mod sealed {
    /// Only this crate has runs, so that [`Run`](super::Run) may get further methods.
    pub trait Sealed {}
}

/// A planning run: a value that is stepped and inspected. Rows are numbered from 0 in the order of creation. Further methods may
/// be added, so no other crate can implement it: [`start_on`] makes a run of any planner.
///
/// What is new since a row comes as an iterator ([`vertices_since`](#method.vertices_since), `edges_since`, `events_since`), or
/// copied into a table of numbers ([`Run::vertex_rows`] and its siblings).
///
/// Natively a `Box<dyn Run>` is `Send`, and not `Sync`: threads share a [`PlanningWorld`], and each starts or steps runs. A
/// function of runs takes a `&dyn Run`. To cancel a run, stop stepping it: its result then says `running`.
///
/// # Example
/// A run in another thread, with progress; it ends early if nobody listens:
///
/// ```
/// use planarium::run::{self, PrmOptions, Status};
/// use std::sync::mpsc;
///
/// let scenario = planarium::worlds::generate("discs", &serde_json::json!({ "seed": 3 }))?;
/// let mut run = run::start(&scenario, PrmOptions { samples: Some(400), ..PrmOptions::default() })?;
/// let (send, receive) = mpsc::channel();
/// let worker = std::thread::spawn(move || {
///     while run.step(100) == Status::Running && send.send(run.vertex_count()).is_ok() {}
///     run
/// });
/// for vertices in receive {
///     println!("{vertices} vertices");
/// }
/// let run = worker.join().expect("the thread does not panic");
/// assert_eq!(run.status(), Status::Solved);
/// # Ok::<(), planarium::Error>(())
/// ```
pub trait Run: MaybeSend + sealed::Sealed {
    /// Makes at most `iterations` iterations, and nothing once the status is no longer `Running`. A run without a path ends by
    /// itself, by default after 5,000,000 units of work ([`Limits`]), about a microsecond each in a release build; so
    /// `step(u64::MAX)` runs it to its end.
    fn step(&mut self, iterations: u64) -> Status;

    /// Lets the planner use this many threads from now on; 1 at first. The result and all counts are the same with any number.
    /// Roadmaps built in a batch (PRM with `insertion=batch`, PRM*; lazy PRM for its samples) use them.
    #[cfg(feature = "parallel")]
    fn set_threads(&mut self, threads: std::num::NonZeroUsize);

    /// Ends the run with the present path if that is being improved or a tree grows past its goal; else does nothing. This is not
    /// an iteration.
    fn finish(&mut self) -> Status;

    /// The status of the run.
    fn status(&self) -> Status;

    /// Why the run has ended without a path, or with one before it had done what its options ask for (`improve_iterations`,
    /// `vertices`); else `None`.
    fn reason(&self) -> Option<Reason>;

    /// The reason in words, with the limit or the size of the roadmap: "gave up after 1,000 iterations without a path
    /// (max_iterations)".
    fn explanation(&self) -> Option<String>;

    /// The error that a run with the status `Failed` has ended with, and that of a failed [`Run::query`] or [`Run::first_hits`];
    /// the same from then on. Only a custom robot can fail.
    fn failure(&self) -> Option<Error>;

    /// The phase of the run: a planner's, `Improving`, or `Done`.
    fn phase(&self) -> Phase;

    /// Records a row for every iteration, for [`Run::history_since`]; this changes nothing else. Rows are stored until the run is
    /// dropped: 64 bytes per iteration. Calling it again has no effect.
    ///
    /// # Errors
    /// `unsupported` after the first iteration, unless it was called before.
    fn record(&mut self) -> Result<(), Error>;

    /// How many rows are recorded: as many as there are iterations, or 0 if nothing is recorded.
    fn history_count(&self) -> usize;

    /// The rows recorded from row `row` on; empty if nothing is recorded. Row i of the run, from 0, is the state after iteration
    /// i + 1: [`HISTORY_WIDTH`] numbers each, the counts those of [`Run::stats`], the last one the cost of the best path so
    /// far, infinite while there is none: its length, measured as [`Run::length`], and what the nearness of obstacles adds if it
    /// keeps away from them ([`ResultDocument::cost`]). It only ever falls. [`Run::finish`] is not an iteration
    /// and adds no row.
    fn history_since(&self, row: usize) -> Vec<f64>;

    /// Iterations made so far, attempts at improving the path included.
    fn iterations(&self) -> u64;

    /// The limits of the run while it has no path.
    fn limits(&self) -> Limits;

    /// How many numbers a configuration has.
    fn dimension(&self) -> usize;

    /// How many vertices there are.
    fn vertex_count(&self) -> usize;

    /// How many edges there are.
    fn edge_count(&self) -> usize;

    /// How many events are recorded.
    fn event_count(&self) -> usize;

    /// The configuration of a vertex. Panics if there is no such vertex.
    fn vertex(&self, row: usize) -> &[f64];

    /// The two vertices of an edge. Panics if there is no such edge.
    fn edge(&self, row: usize) -> [u32; 2];

    /// An event. Panics if there is no such event.
    fn event(&self, row: usize) -> Event<&[f64]>;

    /// The vertices from row `row` on: `dimension` numbers each.
    fn vertex_rows(&self, row: usize) -> Vec<f64>;

    /// The edges from row `row` on: two vertex numbers each.
    fn edge_rows(&self, row: usize) -> Vec<u32>;

    /// The controlled motions along the edges from row `row` on, of a car: the number of the edge, speed, steering angle and
    /// duration (metres per second, radians, seconds) each; an edge of several motions has as many rows, in the order in which it
    /// is driven.
    fn motion_rows(&self, row: usize) -> Vec<f64>;

    /// The shapes of the curved edges from row `row` on: the number of the edge and a configuration on it each,
    /// from its first vertex to its second, close enough to be connected by straight lines.
    fn trace_rows(&self, row: usize) -> Vec<f64>;

    /// The events from row `row` on: kind, iteration, vertex or -1, other vertex or -1, and a configuration each.
    fn event_rows(&self, row: usize) -> Vec<f64>;

    /// The goal configurations: that of the query, or for a query with a target those that were found to
    /// reach it, in that order. If the planner begins with them as vertices, they are those from 1 on.
    fn goals(&self) -> Vec<Vec<f64>>;

    /// The path from start to goal, with its corners, split so that no step turns a circle joint by more than 3 radians; empty
    /// until solved, also while it is being improved.
    fn path(&self) -> Vec<Vec<f64>>;

    /// The path as the planner found it, before any improvement, split likewise; empty until it is found. Available while
    /// the path is being improved, and after.
    fn raw_path(&self) -> Vec<Vec<f64>>;

    /// The length of the path as [`ResultDocument::length`] states it; 0 until solved. While a planner goes on to shorter paths,
    /// the cost of its best is the last column of [`Run::history_since`], and the path [`Run::raw_path`].
    fn length(&self) -> f64;

    /// The first refused points of motions, in the run's own space and by its own test, proven or sampled: `ends` are rows of two
    /// configurations, from and to; the result has for each the fraction of the motion at which the first interval begins that is
    /// refused, 1 if all of it is free. It is for viewers: its cost is not counted among the run's own work.
    ///
    /// # Errors
    /// With the pointer `/ends`: `wrong-dimension` if the last row is not whole, `not-finite`,
    /// `out-of-range` outside the limits.
    fn first_hits(&mut self, ends: &[f64]) -> Result<Vec<f64>, Error>;

    /// The counters; seconds are 0, as the core reads no clock.
    fn stats(&self) -> Stats;

    /// 64 bits over every vertex, edge and recorded event so far. O(size).
    fn fingerprint(&self) -> u64;

    /// The result document; seconds are 0.
    fn result(&self) -> ResultDocument;

    /// The roadmap as far as it is built, to be saved: see [`resume`] and [`resume_problem`]. `None` for planners that build
    /// none, and for runs of [`start_on`] and [`start_with`]. Vertices that [`Run::query`] has added are part of it; those in
    /// collision since [`Run::reopen`] are not. O(size).
    fn roadmap(&self) -> Option<RoadmapDocument>;

    /// Queries the roadmap again, as far as it is built: connects start and goal to their neighbours and searches. The
    /// roadmap is unchanged, unless `keep` adds the two as its last vertices, which is possible once the run is over.
    /// The document's query is named `asked`, its path is not improved; no scenario has that query, so it is not for
    /// [`verify`](crate::path::verify()). The tolerance of the proofs is that of the run's own query.
    ///
    /// # Errors
    /// `unsupported` if the planner builds none, or is not done yet and `keep` is set; with the pointer `/start` or `/goal`:
    /// `wrong-dimension`, `not-finite`, `out-of-range`, `start-in-collision`, `goal-in-collision`.
    fn query(&mut self, start: &[f64], goal: &[f64], keep: bool) -> Result<ResultDocument, Error>;

    /// Begins a run in a world whose obstacles have moved, with the roadmap of this one, which has to be over: the vertices, and
    /// the edges whose robot cannot meet an obstacle that has changed. It is searched lazily: where an obstacle is new, edges are
    /// proven again, and where one was, refused motions are tried again, if and when the best path wants them. No vertices are
    /// added but start and goals of the query of this name, which may be others. This run stays as it is. O(roadmap).
    ///
    /// # Errors
    /// `unsupported` if the planner builds no roadmap, is not done yet, or was not begun by [`start`] or [`resume`];
    /// `other-scenario` if robot or bounds differ; `unknown-query`; `start-in-collision` or `goal-in-collision` with a pointer
    /// into the scenario.
    fn reopen(&self, world: &PlanningWorld) -> Result<Box<dyn Run>, Error>;
}

/// What is new since a row.
///
/// # Example
/// ```
/// use planarium::run::{RrtOptions, Status, start};
/// use planarium::worlds::generate;
///
/// let scenario = generate("maze", &serde_json::json!({}))?;
/// let mut run = start(&scenario, RrtOptions::default())?;
/// let (mut vertices, mut edges) = (0, 0);
/// loop {
///     let status = run.step(100);
///     for q in run.vertices_since(vertices) {
///         assert_eq!(q.len(), 2);
///     }
///     for [from, to] in run.edges_since(edges) {
///         assert_ne!(from, to);
///     }
///     (vertices, edges) = (run.vertex_count(), run.edge_count());
///     if status != Status::Running {
///         break;
///     }
/// }
/// # Ok::<(), planarium::Error>(())
/// ```
impl dyn Run + '_ {
    /// The configurations of the vertices from row `row` on; none if there are fewer.
    pub fn vertices_since(&self, row: usize) -> impl ExactSizeIterator<Item = &[f64]> {
        (row.min(self.vertex_count())..self.vertex_count()).map(|row| self.vertex(row))
    }

    /// The edges from row `row` on, each by its two vertices.
    pub fn edges_since(&self, row: usize) -> impl ExactSizeIterator<Item = [u32; 2]> {
        (row.min(self.edge_count())..self.edge_count()).map(|row| self.edge(row))
    }

    /// The events from row `row` on.
    pub fn events_since(&self, row: usize) -> impl ExactSizeIterator<Item = Event<&[f64]>> {
        (row.min(self.event_count())..self.event_count()).map(|row| self.event(row))
    }
}

impl Stepped for Box<dyn Run> {
    fn iterate(&mut self) {
        Run::step(&mut **self, 1);
    }

    fn status(&self) -> Status {
        Run::status(&**self)
    }

    fn iterations(&self) -> u64 {
        Run::iterations(&**self)
    }

    fn phase(&self) -> Phase {
        Run::phase(&**self)
    }

    fn failure(&self) -> Option<Error> {
        Run::failure(&**self)
    }

    fn step(&mut self, iterations: u64) -> Status {
        Run::step(&mut **self, iterations)
    }
}
