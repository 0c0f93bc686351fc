//! A planning run for JavaScript.

use super::arguments::{choice, document, fields, row, rows};
use super::clock::{Thrown, Timed, stepped};
use super::digits;
use super::records::record;
use super::types::{JsConfiguration, JsText, Phase, QueryOptions, Reason, Rows, ScenarioInput, Status};
use crate::error::{Code, Error};
use crate::path::ResultDocument;
use crate::problem::Stats;
use crate::run::{EVENT_HEAD, HISTORY_WIDTH, Run};
use crate::world::PlanningWorld;
use std::cell::RefCell;
use tsify::Ts;
use wasm_bindgen::prelude::*;

/// A run of a planner; `scenario.planner`, `scenario.resume` and `problem.planner` make it. Each `step` makes some iterations;
/// how they are divided into steps does not change the result.
///
/// What grows is read by cursors: a cursor is a number of rows (vertices, edges, events, iterations), not of array elements. Rows
/// are only ever appended; an event tells what leaves a tree. Vertex 0 is the start, vertex 1 the goal (also of `rrt`, whose tree
/// contains it only once it is reached); if a car is driven by controls, the goal is no vertex.
#[wasm_bindgen]
pub struct Planner(RefCell<Timed<Box<dyn Run>>>);

impl Planner {
    pub(super) fn new(run: Box<dyn Run>) -> Self {
        Self::of(run, Thrown::default())
    }

    /// The planner of a problem whose function may throw.
    pub(super) fn of(run: Box<dyn Run>, thrown: Thrown) -> Self {
        let mut timed = Timed::new(run);
        timed.thrown = thrown;
        Self(RefCell::new(timed))
    }

    /// What to throw for an error.
    fn thrown(&self, error: Error) -> JsValue {
        self.0.borrow().thrown.or(error)
    }

    fn read<T>(&self, read: impl FnOnce(&dyn Run) -> T) -> T {
        read(&*self.0.borrow().run)
    }

    /// The counts with the time spent.
    fn timed(&self, stats: Stats) -> Stats {
        let [build_seconds, search_seconds] = self.0.borrow().seconds();
        Stats { build_seconds, search_seconds, ..stats }
    }
}

#[wasm_bindgen]
impl Planner {
    /// Records a row for every iteration, for `historySince`. Nothing else changes. Rows take 64 bytes each until the planner is
    /// freed. A second call has no effect.
    /// @throws {PlanariumError} `unsupported` once iterations were made that are not recorded
    pub fn record(&self) -> Result<(), Error> {
        self.0.borrow_mut().run.record()
    }

    /// Queries the roadmap of a planner that builds one (`prm`, `lazy-prm`, ...), as far as it is built, for another path: start
    /// and goal are connected to their neighbours by motions that are proven free, and the roadmap is searched. The path is not
    /// improved. The roadmap does not change, unless the two are to stay in it (`keep`), which requires that the run is over. The
    /// query of the result is named `asked`.
    /// @throws {PlanariumError} `unsupported` if the planner builds no roadmap, or with `keep` before it is done;
    /// `start-in-collision`, `goal-in-collision`, `wrong-dimension`, `not-finite`, `out-of-range`
    pub fn query(
        &self,
        start: &JsConfiguration,
        goal: &JsConfiguration,
        options: Option<QueryOptions>,
    ) -> Result<Ts<ResultDocument>, JsValue> {
        let mut fields = fields(options)?;
        let keep = fields.take("keep")?.unwrap_or(false);
        fields.finish("keep")?;
        let dimension = self.dimension();
        let [start, goal] = [(start, "start"), (goal, "goal")].map(|(q, name)| row(q, dimension, name));
        let found = self.0.borrow_mut().run.query(&start?, &goal?, keep);
        found.map(|result| record(&result)).map_err(|error| self.thrown(error))
    }

    /// Begins a run with the roadmap of this one, which is over, in a scenario whose obstacles have moved: robot and bounds are
    /// the same, start and goal of the query may be others. All vertices stay, and the edges that no changed obstacle can meet;
    /// of the others those are proven again that the best path wants. No vertices are added but start and goals. This planner
    /// stays as it is. For dragging: reopen the last planner whenever an obstacle moves, and free it.
    /// @throws {PlanariumError} `unsupported` if the planner builds no roadmap, or before it is done; `other-scenario` if robot
    /// or bounds differ; `unknown-query`, `start-in-collision`, `goal-in-collision`; and those of `Scenario.parse`
    pub fn reopen(&self, scenario: &ScenarioInput) -> Result<Planner, Error> {
        let world = PlanningWorld::new(document(scenario)?);
        self.read(|run| run.reopen(&world)).map(Self::new)
    }

    /// The roadmap in a format.
    #[wasm_bindgen(skip_typescript)]
    pub fn roadmap(&self, format: &JsText) -> Result<JsValue, Error> {
        let format = choice(format, "format", &["json", "binary", "graphml"])?;
        let missing = || {
            Error::new(
                Code::Unsupported,
                "",
                "there is no roadmap to save: the planner builds none, or its edges are rollouts of a policy",
            )
        };
        let document = self.read(|run| run.roadmap()).ok_or_else(missing)?;
        Ok(match format {
            0 => document.to_json().into(),
            1 => js_sys::Uint8Array::from(document.to_bytes().as_slice()).into(),
            _ => document.to_graphml().into(),
        })
    }

    /// The first refused points of motions, in the space, the metric and by the test of this run, proven or sampled: for each row
    /// of `ends`, two configurations (2 `dimension` numbers), the fraction at which the first interval begins that is refused; 1
    /// if all of it is free. For the refused edges of `eventsSince`. It is not counted in `stats`.
    /// @throws {PlanariumError} `wrong-dimension`, `wrong-type`, `not-finite`; `out-of-range` outside the limits
    #[wasm_bindgen(js_name = firstHits)]
    pub fn first_hits(&self, ends: &Rows) -> Result<Vec<f64>, JsValue> {
        let ends = rows(ends, 2 * self.dimension(), "ends")?;
        let hits = self.0.borrow_mut().run.first_hits(&ends);
        hits.map_err(|error| self.thrown(error))
    }
}

stepped!(Planner);

members! { Planner(self): wasm_bindgen(getter);
    /// The status of the run.
    status: Status = self.read(|run| run.status()).into();
    /// Why the run has ended without a path, or with one before it had done what its options ask for (`improveIterations`,
    /// `vertices`); else undefined.
    reason: Option<Reason> = self.read(|run| run.reason()).map(Reason::from);
    /// The reason in words, with the limit or the size of the roadmap: `gave up after 1,000 iterations without a path
    /// (max_iterations)`.
    explanation: Option<String> = self.read(|run| run.explanation());
    /// The phase of the run.
    phase: Phase = self.read(|run| run.phase()).into();
    /// The number of iterations made so far.
    iterations: f64 = self.read(|run| run.iterations()) as f64;
    /// The degrees of freedom: numbers per row of `verticesSince` and `path`.
    dimension: usize = self.read(|run| run.dimension());
    /// The number of vertices.
    vertexCount: usize = self.read(|run| run.vertex_count());
    /// The number of edges.
    edgeCount: usize = self.read(|run| run.edge_count());
    /// The number of events.
    eventCount: usize = self.read(|run| run.event_count());
    /// The number of rows of the history: that of iterations if `record` was called, else 0.
    historyCount: usize = self.read(|run| run.history_count());
    /// Numbers per row of `eventsSince`: 4 + `dimension`.
    eventWidth: usize = EVENT_HEAD + self.dimension();
    /// Numbers per row of `historySince`: one for each of `historyColumns`.
    historyWidth: usize = HISTORY_WIDTH;
}

members! { Planner(self): wasm_bindgen;
    /// Ends the run with the present path if that is being improved (phase `improving`); else does nothing.
    finish: Status = self.0.borrow_mut().run.finish().into();
    /// The configurations at which the run may end, in rows of `dimension` numbers, one at least: the goal of its query, or for a
    /// query with a `target` the free ones that were found to reach it. A car may end near its goal.
    goals: Vec<f64> = self.read(|run| run.goals()).concat();
    /// The path in rows of `dimension` numbers; empty until solved. Between rows motion is linear, circles the short way round,
    /// and no step turns a joint by more than 3 rad; a car drives the `motions` of `result()`, one from each row to the next.
    path: Vec<f64> = self.read(|run| run.path()).concat();
    /// The path as the planner found it, before it is reduced and shortened, in the same form; empty until it is found.
    rawPath: Vec<f64> = self.read(|run| run.raw_path()).concat();
    /// The counts of work, and the time spent in `step` and `stepFor`.
    stats: Ts<Stats> = record(&self.timed(self.read(|run| run.stats())));
    /// The result document, the one that the command line prints.
    result: Ts<ResultDocument> = {
        let result = self.read(|run| run.result());
        record(&ResultDocument { stats: self.timed(result.stats), ..result })
    };
    /// 16 hexadecimal digits over every vertex, edge and event in order: equal runs have equal fingerprints, on every platform.
    fingerprint: String = digits(self.read(|run| run.fingerprint()));
}

tables! { Planner(self, row)
    /// The vertices from vertex `row` (0 to `vertexCount`) on: configurations, in rows of `dimension` numbers. A copy.
    verticesSince: Vec<f64> = self.read(|run| run.vertex_count()) => self.read(|run| run.vertex_rows(row));
    /// The edges from edge `row` (0 to `edgeCount`) on, in rows of two vertex numbers: parent and child in trees; if a car drives
    /// forwards only (`steering` is `dubins`), in the direction of the drive. A copy.
    edgesSince: Vec<u32> = self.read(|run| run.edge_count()) => self.read(|run| run.edge_rows(row));
    /// The motions of a car along the edges from edge `row` (0 to `edgeCount`) on, in rows of edge, speed, steering angle,
    /// seconds; an edge of several motions has as many rows, in the order in which it is driven. Empty for other robots. A copy.
    motionsSince: Vec<f64> = self.read(|run| run.edge_count()) => self.read(|run| run.motion_rows(row));
    /// The shapes of the curved edges from edge `row` (0 to `edgeCount`) on, in rows of 1 + `dimension` numbers: the edge and a
    /// configuration on it, from its first vertex to its second, close enough to be connected by straight lines. A copy.
    tracesSince: Vec<f64> = self.read(|run| run.edge_count()) => self.read(|run| run.trace_rows(row));
    /// The events from event `row` (0 to `eventCount`) on, in rows of `eventWidth` numbers: kind, iteration, vertex or -1, other
    /// vertex or -1, configuration. A copy. The kind is an index into `eventKinds`:
    ///
    /// - 0, `rejected`: a sample was in collision; the configuration is the sample
    /// - 1, `refused`: an edge was refused, from the vertex to the other vertex or, if that is -1, to the configuration
    /// - 2, `expanded`: the search expanded the vertex
    /// - 3, `solved`: a solution was found at the vertex
    /// - 4, `discarded`: a free sample was discarded, as it connects to nothing, or to nothing new
    /// - 5, `guard`: the vertex became a guard of a visibility roadmap
    /// - 6, `removed`: the vertex and the edge that leads to it were removed from the tree (`sst`, `bit-star`, `aorrtc`); its
    ///   number is not used again
    eventsSince: Vec<f64> = self.read(|run| run.event_count()) => self.read(|run| run.event_rows(row));
    /// The recorded rows from row `row` (0 to `historyCount`) on, in rows of `historyWidth` numbers; empty unless `record` was
    /// called. A copy. Row i is the state after iteration i + 1, as `historyColumns` names it: vertices, edges, events, phase
    /// (its index in `phases`), configuration checks, motion checks, clearance evaluations (as in `stats`), and the length of the
    /// best path so far, or its cost with `clearanceWeight`, as in the result. It only ever falls and is `Infinity` while there
    /// is no path. `finish` is no iteration and adds no row.
    historySince: Vec<f64> = self.read(|run| run.history_count()) => self.read(|run| run.history_since(row));
}
