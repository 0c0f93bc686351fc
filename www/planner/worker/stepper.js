/**
 * A planner in the worker, as the package has it (`planarium/worker`), with what the page needs besides: several clocks,
 * blocks that a frame can draw, and repairs.
 */
import { PlannerHost, countsOf } from "../../../dist/package/planner-host.js";
import { planned } from "../../domain/page-defaults.js";
import { withOptions } from "../../domain/option-names.js";

/** @import { WorkerGrowth } from "planarium/worker" */
/** @import { Scenario, ScenarioDocument, Settings, Stats } from "../../domain/types.js" */

/**
 * @typedef {object} Present   the state of a run after a block
 * @property {string} phase
 * @property {Stats} stats
 * @property {Float64Array | null} path       once the run has ended
 * @property {Float64Array | null} rawPath
 */

/**
 * What a run has grown since the last block; the result on request too, and a row of history for each iteration.
 * @typedef {WorkerGrowth & Present} Growth
 */

/**
 * @typedef {ReturnType<Stepper["ask"]>} Answer   of a roadmap: the result, the seconds that it took, the number of
 *   vertices that the search visited
 */

/** Most vertices and edges of one block: as many as a frame can draw. */
const BURST = { vertices: 400, edges: 240 };
/** Blocks at once on the way to the end, where fewer frames show all that has grown. */
const RUSH = 4;

/**
 * Steps one planner. `column` selects the clock: a column of the history, such as clearance evaluations, or -1 for
 * iterations.
 */
export class Stepper extends PlannerHost {
  /**
   * @param {Scenario} scenario
   * @param {string} algorithm
   * @param {Settings} settings  the query's name, the seed and the planner's parameters
   */
  constructor(scenario, algorithm, settings) {
    super(withOptions({ ...planned(algorithm, settings), algorithm }, (options) => scenario.planner(options)));
    this.planner.record();
    // The page makes the rows before the first iteration itself.
    this.sent = countsOf(this.planner);
  }

  /** Iterations made. */
  get made() {
    return this.planner.iterations;
  }

  get ended() {
    return this.planner.status !== "running";
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
    // The page makes start and goals itself.
    const vertices = 1 + this.planner.goals().length / this.planner.dimension;
    this.sent = { vertices, edges: 0, events: 0, history: 0 };
    return this.growth(true);
  }

  /** The counts at which a block is full. @param {number} wanted  the time to reach */
  burst(wanted) {
    const blocks = wanted === Infinity ? RUSH : 1;
    const { vertexCount, edgeCount } = this.planner;
    return { vertices: vertexCount + blocks * BURST.vertices, edges: edgeCount + blocks * BURST.edges };
  }

  /**
   * Plans until it has passed the time `wanted`, the run ends, the clock passes `until`, or the block is full.
   * @param {number} column  of the history, -1 for iterations
   * @param {number} wanted  may be Infinity
   * @param {number} until   on the clock of performance.now(), milliseconds
   * @param {{ vertices: number, edges: number }} [most]  counts at which to stop
   * @returns {boolean} whether it has passed that time, or ended
   */
  advance(column, wanted, until, most = this.burst(wanted)) {
    const { planner } = this;
    let isFull = false;
    const left = () => {
      if (this.hasPassed(column, wanted)) return 0;
      isFull = planner.vertexCount >= most.vertices || planner.edgeCount >= most.edges;
      if (isFull) return 0;
      return column < 0 ? wanted - this.made : Infinity;
    };
    return this.stepUntil(left, until) && !isFull;
  }

  /** What has grown since the last block. @param {boolean} isResult   with the current result @returns {Growth} */
  growth(isResult) {
    const { planner, ended } = this;
    const grown = this.grown();
    return {
      ...grown,
      phase: planner.phase,
      stats: planner.stats(),
      result: grown.result ?? (isResult ? planner.result() : null),
      path: ended ? planner.path() : null,
      rawPath: ended ? planner.rawPath() : null,
    };
  }
}
