/// <reference lib="esnext.disposable" preserve="true" />
/** A planning run that is stepped from outside, and read by cursors. */
import * as argument from "./arguments.js";
import { PlanariumError } from "./error.js";
import { phases } from "./functions.js";
import { Handle, key } from "./handle.js";

/** @import { RawPlanner } from "./planarium_glue.js" */
/** @import { Configuration, Phase, QueryOptions, ResultDocument, RoadmapFormat, Stats, Status } from "./types.js" */

/** The core counts them. @type {readonly Status[]} */
const STATUSES = ["running", "solved", "exhausted"];

/**
 * Makes the handle of a run.
 * @param {RawPlanner} raw
 * @returns {Planner}
 * @internal
 */
export function makePlanner(raw) {
  // The constructor is private to callers, not to the package.
  const Construct = /** @type {new (secret: symbol, raw: RawPlanner) => Planner} */ (
    /** @type {unknown} */ (Planner)
  );
  return new Construct(key, raw);
}

/**
 * One run of one planner. It does nothing by itself: each `step` makes some iterations, and whoever watches asks for
 * what is new since a cursor. How the iterations are cut into steps never changes the result.
 *
 * Vertices, edges and events are only ever added; what leaves a tree is told by an event. Vertex 0 is the start, vertex 1 the
 * goal (of `rrt` too, whose tree it joins only when it is reached); where a car is driven by controls, the goal is no vertex.
 */
export class Planner {
  /** @type {Handle<RawPlanner>} */
  #handle;

  /**
   * @param {symbol} secret
   * @param {RawPlanner} raw
   * @private
   */
  constructor(secret, raw) {
    if (secret !== key) {
      throw new PlanariumError("illegal-constructor", "A Planner comes from scenario.planner(options) or scenario.resume(roadmap, options).");
    }
    this.#handle = new Handle(raw, "Planner");
  }

  /**
   * Makes at most `n` iterations. Once solved or exhausted it does nothing more.
   * @param {number} n  an integer from 0 to 2^53 - 1
   * @returns {Status}
   */
  step(n) {
    return STATUSES[this.#handle.call((raw) => raw.step(argument.count(n, "n")))];
  }

  /**
   * Makes iterations for about `ms` milliseconds, and one at least. The clock is read after slices that are kept
   * below a quarter of the budget, so the overrun stays below that too.
   * @param {number} ms  0 or more
   * @returns {Status}
   */
  stepFor(ms) {
    return STATUSES[this.#handle.call((raw) => {
      if (argument.finite(ms, "/ms") < 0) {
        throw new PlanariumError("out-of-range", `\`ms\` must be 0 or more, not ${ms}.`, "/ms");
      }
      return raw.step_for(ms);
    })];
  }

  /**
   * Takes the path as it is while it is being improved (phase `improving`), and so ends the run; else does nothing.
   * @returns {Status}
   */
  finish() {
    return this.#handle.call((raw) => {
      raw.finish();
      return STATUSES[raw.status()];
    });
  }

  /**
   * Has every iteration leave a row behind for `takeHistory`, to draw how the run went. Nothing else changes. To be called
   * before the first step; twice is as good as once.
   * @returns {void}
   * @throws {PlanariumError} `unsupported` once there are iterations that were not recorded
   */
  record() {
    this.#handle.call((raw) => raw.record());
  }

  /**
   * The rows that iterations have left behind since the last call, and forgets them; until then they take 64 bytes each. Empty
   * unless `record` was called. Row i of the run, counted from 0, says how things stood after iteration i + 1, in `historyWidth`
   * numbers: vertices, edges, events, phase (its place in `phases`), configuration checks, motion checks, clearance evaluations
   * (as in `stats`), and the length of the best path so far in the metric of the run, which only ever falls and is `Infinity`
   * while there is none. `finish` is no iteration and leaves no row: then the last one still says `improving`.
   * @returns {Float64Array}
   */
  takeHistory() {
    return this.#handle.call((raw) => raw.take_history());
  }

  /** Numbers in a row of `takeHistory`. @returns {number} */
  get historyWidth() {
    return this.#handle.call((raw) => raw.history_width());
  }

  /**
   * Asks the roadmap of `prm`, `prm-star` or `visibility-prm`, as far as it is built, for another path: start and goal are
   * joined to their neighbours where motions are proven free, and the roadmap is searched. It stays as it was, unless the
   * two are to be kept as its last vertices, which can be asked for once the run is over. The path is not improved.
   * @param {Configuration} start
   * @param {Configuration} goal
   * @param {QueryOptions} [options]
   * @returns {ResultDocument} its query is named `asked`
   * @throws {PlanariumError} `unsupported` where the planner builds no roadmap, or is to keep the two before it is done; `start-in-collision`, `goal-in-collision`,
   *   `wrong-dimension`, `not-finite`, `out-of-range`
   */
  query(start, goal, options = {}) {
    /** @returns {[Float64Array, Float64Array, boolean]} */
    const read = () => {
      const { keep = false, ...rest } = argument.options(options);
      const [unknown] = Object.keys(rest);
      if (unknown !== undefined) throw new PlanariumError("unknown-field", `There is no option \`${unknown}\`; there is keep.`, `/${unknown}`);
      if (typeof keep !== "boolean") throw new PlanariumError("wrong-type", "`keep` must be true or false.", "/keep");
      const { dimension } = this;
      return [argument.configuration(start, dimension, "start"), argument.configuration(goal, dimension, "goal"), keep];
    };
    return this.#handle.callWith(read, (raw, from, to, isKept) => raw.query(from, to, isKept));
  }

  /**
   * The roadmap of `prm`, `prm-star` or `visibility-prm`, as far as it is built, to be kept: `scenario.resume` goes on with it.
   * @template {RoadmapFormat} F
   * @param {F} format  `"json"` for text, `"binary"` for bytes, much fewer; `"graphml"` is text for other programs, which
   *   `resume` does not read
   * @returns {F extends "binary" ? Uint8Array : string}
   * @throws {PlanariumError} `unsupported` where the planner builds no roadmap; `out-of-range` for another format
   */
  roadmap(format) {
    const kept = this.#handle.call((raw) => {
      const wanted = argument.text(format, "format");
      if (wanted === "binary") return raw.roadmap_bytes();
      if (wanted === "json") return raw.roadmap_text();
      if (wanted === "graphml") return raw.roadmap_graphml();
      throw new PlanariumError("out-of-range", "`format` must be \"json\", \"binary\" or \"graphml\".", "/format");
    });
    return /** @type {F extends "binary" ? Uint8Array : string} */ (kept);
  }

  /** Where the run stands. @returns {Status} */
  get status() {
    return STATUSES[this.#handle.call((raw) => raw.status())];
  }

  /** What the planner is at: see `Phase`. @returns {Phase} */
  get phase() {
    return phases[this.#handle.call((raw) => raw.phase())];
  }

  /** Iterations made so far. @returns {number} */
  get iterations() {
    return this.#handle.call((raw) => raw.iterations());
  }

  /** Degrees of freedom: numbers in a row of `verticesSince` and `path`. @returns {number} */
  get dimension() {
    return this.#handle.call((raw) => raw.dimension());
  }

  /** Numbers in a row of `eventsSince`: 4 + `dimension`. @returns {number} */
  get eventWidth() {
    return this.#handle.call((raw) => raw.event_width());
  }

  /** Vertices so far. @returns {number} */
  get vertexCount() {
    return this.#handle.call((raw) => raw.vertex_count());
  }

  /** Edges so far. @returns {number} */
  get edgeCount() {
    return this.#handle.call((raw) => raw.edge_count());
  }

  /** Events so far. @returns {number} */
  get eventCount() {
    return this.#handle.call((raw) => raw.event_count());
  }

  /**
   * The vertices from a row on: configurations, rows of `dimension` numbers. A fresh copy, yours to keep.
   * @param {number} row  an integer from 0 to `vertexCount`
   * @returns {Float64Array}
   */
  verticesSince(row) {
    return this.#handle.call((raw) => raw.vertices_since(argument.count(row, "row")));
  }

  /**
   * The edges from a row on: rows of two vertex numbers, (parent, child) in trees; where a car drives forwards only
   * (`steering: "dubins"`), in the direction of the drive. A fresh copy, yours to keep.
   * @param {number} row  an integer from 0 to `edgeCount`
   * @returns {Uint32Array}
   */
  edgesSince(row) {
    return this.#handle.call((raw) => raw.edges_since(argument.count(row, "row")));
  }

  /**
   * What a car does along the edges from a row on: rows of four numbers (edge, speed, steering angle, seconds); an edge of several
   * motions has as many rows, in the order in which it is driven. Empty for other robots. A fresh copy, yours to keep.
   * @param {number} row  an integer from 0 to `edgeCount`
   * @returns {Float64Array}
   */
  motionsSince(row) {
    return this.#handle.call((raw) => raw.motions_since(argument.count(row, "row")));
  }

  /**
   * What the edges from a row on look like that are not straight: rows of 1 + `dimension` numbers, the edge and a configuration
   * on it, from its first vertex to its second, close enough to be joined by straight lines. A fresh copy, yours to keep.
   * @param {number} row  an integer from 0 to `edgeCount`
   * @returns {Float64Array}
   */
  tracesSince(row) {
    return this.#handle.call((raw) => raw.traces_since(argument.count(row, "row")));
  }

  /**
   * The events from a row on: rows of `eventWidth` numbers (kind, iteration, vertex or -1, other vertex or -1,
   * configuration). A fresh copy, yours to keep. Kinds:
   *
   * - 0: a sample was rejected; the configuration is the sample
   * - 1: an edge was refused, from the vertex to the other vertex or, where that is -1, to the configuration
   * - 2: the search expanded the vertex
   * - 3: a solution was found; the vertex is where
   * - 4: a free sample was thrown away, as it connects to nothing, or to nothing new
   * - 5: the vertex became a guard of a visibility roadmap
   * - 6: the vertex and the edge that leads to it were taken out of the tree (`sst`); its number is not used again
   * @param {number} row  an integer from 0 to `eventCount`
   * @returns {Float64Array}
   */
  eventsSince(row) {
    return this.#handle.call((raw) => raw.events_since(argument.count(row, "row")));
  }

  /**
   * The configurations that the run may end at: the goal of its query, or of a query with a `target` those free ones that were
   * found to reach it. A car may end near its goal.
   * @returns {Float64Array} rows of `dimension` numbers, one at least
   */
  goals() {
    return this.#handle.call((raw) => raw.goals());
  }

  /**
   * The path: rows of `dimension` numbers, empty until solved. Between rows motion is linear, circles the short way
   * round, and no step turns a joint by more than 3 rad; a car drives the `motions` of `result()`, one from each row to the next.
   * @returns {Float64Array}
   */
  path() {
    return this.#handle.call((raw) => raw.path());
  }

  /**
   * The path as the planner found it, before it was reduced and shortened: rows as of `path`, empty until it is found, there
   * while it is being improved and after.
   * @returns {Float64Array}
   */
  rawPath() {
    return this.#handle.call((raw) => raw.raw_path());
  }

  /**
   * Where motions are first refused, each in the space, in the metric and by the test of this run, proven or sampled: the
   * fraction at which the first stretch begins that is refused, all before it is free; 1 where the whole motion is free. For
   * the refused edges of `eventsSince`. It is not counted in `stats`.
   * @param {Float64Array | readonly number[]} ends  rows of two configurations, from and to: 2 `dimension` numbers
   * @returns {Float64Array} one number from 0 to 1 a row
   * @throws {PlanariumError} `wrong-dimension`, `wrong-type`, `not-finite`; `out-of-range` outside the limits
   */
  firstHits(ends) {
    const width = 2 * this.dimension;
    return this.#handle.callWith(() => [argument.rows(ends, width, "ends")], (raw, given) => {
      const hits = new Float64Array(given.length / width);
      argument.blocks(given, width, (block, row) => hits.set(raw.first_hits(block), row));
      return hits;
    });
  }

  /**
   * What was counted, and the time spent in `step` and `stepFor`.
   * @returns {Stats}
   */
  stats() {
    return this.#handle.call((raw) => raw.stats());
  }

  /**
   * The result document, the same as the command line prints.
   * @returns {ResultDocument}
   */
  result() {
    return this.#handle.call((raw) => raw.result());
  }

  /**
   * 16 hexadecimal digits over every vertex, edge and event in order: equal runs have equal fingerprints, on every
   * platform.
   * @returns {string}
   */
  fingerprint() {
    return this.#handle.call((raw) => raw.fingerprint());
  }

  /** Gives the memory back. Any use afterwards throws `freed`; freeing twice does nothing. @returns {void} */
  free() {
    this.#handle.free();
  }

  /** The same as `free`, for `using`. @returns {void} */
  [Symbol.dispose]() {
    this.#handle.free();
  }
}
