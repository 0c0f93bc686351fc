/**
 * A planner in the worker: it is stepped in slices, and what has grown is sent as typed arrays that are transferred,
 * not copied.
 */
import { planned } from "../../domain/page-defaults.js";
import { withOptions } from "../../domain/option-names.js";

/**
 * @import { Planner, ResultDocument, Scenario, ScenarioDocument, Settings, Stats, Status } from "../../domain/types.js"
 */

/**
 * @typedef {object} Growth   what a run has grown since the last block; rows as in the package
 * @property {Float64Array} history    a row for each iteration
 * @property {Float64Array} vertices
 * @property {Uint32Array} edges
 * @property {Float64Array} traces
 * @property {Float64Array} motions
 * @property {Float64Array} events
 * @property {Status} status
 * @property {string} phase
 * @property {Stats} stats
 * @property {ResultDocument | null} result   on request, and once the run has ended
 * @property {Float64Array | null} path       once the run has ended
 * @property {Float64Array | null} rawPath
 */

/**
 * @typedef {ReturnType<Stepper["ask"]>} Answer   of a roadmap: the result, the seconds that it took, the number of
 *   vertices that the search visited
 */

/** Iterations in one slice at most. */
const LONGEST = 64;

/** Most vertices and edges of one block: as many as a frame can draw. */
const BURST = { vertices: 400, edges: 240 };

/**
 * Steps one planner. `column` selects the clock: a column of the history, such as clearance evaluations, or -1 for
 * iterations.
 */
export class Stepper {
  /**
   * @param {Scenario} scenario
   * @param {string} algorithm
   * @param {Settings} settings  the query's name, the seed and the planner's parameters
   */
  constructor(scenario, algorithm, settings) {
    this.planner = withOptions({ ...planned(algorithm, settings), algorithm }, (options) => scenario.planner(options));
    this.planner.record();
    this.ended = false;
    /** Rows that were sent. The page makes those before the first iteration itself. */
    this.sent = this.counts;
  }

  /** Iterations made. */
  get made() {
    return this.planner.iterations;
  }

  get counts() {
    return {
      iterations: this.made,
      vertices: this.planner.vertexCount,
      edges: this.planner.edgeCount,
      events: this.planner.eventCount,
    };
  }

  /** The time of the last iteration; 0 before the first. @param {number} column */
  clock(column) {
    const { planner, made } = this;
    return column < 0 || made === 0 ? made : Math.max(1, planner.historySince(made - 1)[column]);
  }

  /**
   * Whether all iterations up to a time are made. Several may have the same time on a clock that does not count
   * iterations: then only a later time shows it.
   * @param {number} column @param {number} wanted
   */
  hasPassed(column, wanted) {
    return this.ended || (column < 0 ? this.made >= wanted : this.clock(column) > wanted);
  }

  /**
   * Queries the roadmap as it stands for another path; the run does not change.
   * @param {number[]} start @param {number[]} goal
   * @throws {Error} with `code` and `pointer`: `start-in-collision`, `goal-in-collision`
   */
  ask(start, goal) {
    const { planner } = this;
    const { visited } = planner.stats();
    const began = performance.now();
    const result = planner.query(start, goal);
    return { result, seconds: (performance.now() - began) / 1000, visited: planner.stats().visited - visited };
  }

  /**
   * Plans on the roadmap that stands in an edited scenario, to the end.
   * @param {ScenarioDocument} document
   * @returns {Growth} all of it
   * @throws {Error} with `code` and `pointer`: `start-in-collision`, `goal-in-collision`
   */
  reopen(document) {
    const { planner } = this;
    this.planner = planner.reopen(document);
    planner.free();
    this.planner.record();
    this.planner.step(Number.MAX_SAFE_INTEGER);
    this.ended = true;
    // The page makes start and goals itself.
    this.sent = {
      iterations: 0,
      vertices: 1 + this.planner.goals().length / this.planner.dimension,
      edges: 0,
      events: 0,
    };
    return this.growth(true);
  }

  /** The counts at which a block is full. */
  burst() {
    return { vertices: this.planner.vertexCount + BURST.vertices, edges: this.planner.edgeCount + BURST.edges };
  }

  /**
   * Plans until it has passed the time `wanted`, the run ends, the clock passes `until`, or the block is full. Slices
   * are short at first and grow while they are cheap, so that no slice is long.
   * @param {number} column  of the history, -1 for iterations
   * @param {number} wanted  may be Infinity
   * @param {number} until   on the clock of performance.now(), milliseconds
   * @param {{ vertices: number, edges: number }} [most]  counts at which to stop
   * @returns {boolean} whether it has passed that time, or ended
   */
  advance(column, wanted, until, most = this.burst()) {
    const { planner } = this;
    let slice = 1;
    while (!this.hasPassed(column, wanted)) {
      if (planner.vertexCount >= most.vertices || planner.edgeCount >= most.edges) return false;
      const began = performance.now();
      if (began >= until) return false;
      const left = column < 0 ? wanted - this.made : slice;
      const { made } = this;
      const status = planner.step(Math.min(slice, Math.ceil(left)));
      this.ended = status !== "running";
      const ended = performance.now();
      const room = (until - ended) / (2 * Math.max((ended - began) / Math.max(1, this.made - made), 1e-4));
      slice = Math.max(1, Math.min(2 * slice, LONGEST, Math.floor(room)));
    }
    return true;
  }

  /** What has grown since the last block. @param {boolean} isResult   with the current result @returns {Growth} */
  growth(isResult) {
    const { planner, sent, ended } = this;
    this.sent = this.counts;
    return {
      history: planner.historySince(sent.iterations),
      ...grownSince(planner, sent),
      status: planner.status,
      phase: planner.phase,
      stats: planner.stats(),
      result: isResult || ended ? planner.result() : null,
      path: ended ? planner.path() : null,
      rawPath: ended ? planner.rawPath() : null,
    };
  }

  free() {
    this.planner.free();
  }
}

/**
 * The rows of a planner since these counts.
 * @param {Planner} planner
 * @param {{ vertices: number, edges: number, events: number }} counts
 */
export function grownSince(planner, { vertices, edges, events }) {
  return {
    vertices: planner.verticesSince(vertices),
    edges: planner.edgesSince(edges),
    events: planner.eventsSince(events),
    traces: planner.tracesSince(edges),
    motions: planner.motionsSince(edges),
  };
}
