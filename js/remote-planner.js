/** A planner in a worker, whose methods return promises. */
import { PlanariumError } from "./error.js";
import { budgetOf, copyOf, fieldsOf } from "./plain.js";

/** @import { Configuration, QueryOptions, ResultDocument, Stats } from "./core.js" */
/** @import { Run } from "./planning-worker.js" */
/** @import { WorkerGrowth } from "./worker.js" */

/**
 * A planner in a worker of a `PlannerPool`. It has the bits of `scenario.planner`, however it is stepped. Calls are
 * answered in their order, and reject with the errors of the same method of `Planner`; with the signal's reason once
 * that is aborted, `freed` after `free`, `internal` once the worker is lost.
 */
export class RemotePlanner {
  #run;
  #widths;

  /**
   * @private
   * @param {Run} run
   * @param {{ dimension: number, eventWidth: number, historyWidth: number }} widths
   */
  constructor(run, widths) {
    this.#run = run;
    this.#widths = widths;
  }

  /** @param {Run} run @internal */
  static async of(run) {
    return new RemotePlanner(run, await run.call("widths"));
  }

  /** Numbers per row of `vertices`. */
  get dimension() {
    return this.#widths.dimension;
  }

  /** Numbers per row of `events`. */
  get eventWidth() {
    return this.#widths.eventWidth;
  }

  /** Numbers per row of `history`. */
  get historyWidth() {
    return this.#widths.historyWidth;
  }

  /**
   * Makes at most `iterations` iterations, and none once the run has ended. Other planners of the worker have their
   * turn meanwhile.
   * @param {number} iterations
   * @param {{ budget?: number }} [options]  `budget`: milliseconds after which it makes no more, one at least
   * @returns {Promise<WorkerGrowth>}  what has grown since the last `step`; the arrays are transferred
   */
  async step(iterations, options) {
    const { budget } = fieldsOf(options, "options", "budget");
    return RemotePlanner.#call(this, "step", iterations, budget === undefined ? Infinity : budgetOf(budget));
  }

  /**
   * Records a row of history for every iteration: see `planner.record`.
   * @returns {Promise<void>}
   */
  record() {
    return RemotePlanner.#call(this, "record");
  }

  /**
   * The rows of history from a row on: see `planner.historySince`.
   * @param {number} row
   * @returns {Promise<Float64Array>}
   */
  historySince(row) {
    return RemotePlanner.#call(this, "historySince", row);
  }

  /**
   * Asks the roadmap for another path: see `planner.query`.
   * @param {Configuration} start
   * @param {Configuration} goal
   * @param {QueryOptions | null} [options]
   * @returns {Promise<ResultDocument>}
   */
  query(start, goal, options) {
    return RemotePlanner.#call(this, "query", start, goal, options);
  }

  /** The path, in rows of `dimension` numbers: see `planner.path`. @returns {Promise<Float64Array>} */
  path() {
    return RemotePlanner.#call(this, "path");
  }

  /** The result document. @returns {Promise<ResultDocument>} */
  result() {
    return RemotePlanner.#call(this, "result");
  }

  /** The counts of work. @returns {Promise<Stats>} */
  stats() {
    return RemotePlanner.#call(this, "stats");
  }

  /** The fingerprint of the run so far: see `planner.fingerprint`. @returns {Promise<string>} */
  fingerprint() {
    return RemotePlanner.#call(this, "fingerprint");
  }

  /** Frees the planner, in the middle of a step too. Calls that wait, and later ones, reject with the code `freed`. */
  free() {
    RemotePlanner.#runOf(this, "free").end(new PlanariumError("freed", "This RemotePlanner has been freed."));
  }

  /** The same as `free`, for `using`. */
  [Symbol.dispose]() {
    this.free();
  }

  /** @param {RemotePlanner} self @param {string} method @param {unknown[]} args */
  static async #call(self, method, ...args) {
    const run = RemotePlanner.#runOf(self, method);
    return run.call(method, ...args.map((argument) => copyOf(argument, `argument of ${method}`)));
  }

  /** Refuses a receiver that is no remote planner. @param {unknown} self @param {string} method */
  static #runOf(self, method) {
    if (#run in Object(self)) return /** @type {RemotePlanner} */ (self).#run;
    throw new PlanariumError(
      "illegal-invocation",
      `${method} belongs to a RemotePlanner, and was called on something else.`,
    );
  }
}
