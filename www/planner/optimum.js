/**
 * The shortest path of the query, beside the runs: it is asked for once something shows it, in a worker of its own, so
 * that no planner waits for it.
 */
import { errorInfo } from "../app/error-info.js";
import { hasOptimum } from "./stage/lane.js";

/** @import { App } from "../app/app.js" */
/** @import { ScenarioDocument } from "../domain/types.js" */
/** @import { Lane, Metric, Optimum } from "./stage/lane.js" */
/** @import { PlannerWorker } from "./worker/worker.js" */

/**
 * By how much a path is longer, in percent; null if either is unknown.
 * @param {number} cost
 * @param {Optimum | null} optimum
 */
export function gapOf(cost, optimum) {
  return optimum && optimum.length > 0 && cost < Infinity ? 100 * (cost / optimum.length - 1) : null;
}

export class Optima {
  /** @param {App} app @param {() => void} onFound */
  constructor(app, onFound) {
    this.app = app;
    this.onFound = onFound;
    /** Whether one is shown, by each that may show it. @type {(() => boolean)[]} */
    this.viewers = [];
    /** @type {PlannerWorker | null} */
    this.worker = null;
    /** The scenario and the query of those found. @type {ScenarioDocument | null} */
    this.document = null;
    /** @type {string | undefined} */
    this.query = undefined;
    /** By metric; null while it is awaited, and if there is none. @type {Map<Metric, Optimum | null>} */
    this.found = new Map();
  }

  /** That of a lane, if it is shown and known. @param {Lane} lane @returns {Optimum | null} */
  of({ shown, scenario, metric, asked }) {
    if (asked || shown.rough || !hasOptimum(scenario) || !this.viewers.some((isShown) => isShown())) return null;
    if (this.document !== shown.document || this.query !== shown.query) {
      [this.document, this.query, this.found] = [shown.document, shown.query, new Map()];
    }
    if (!this.found.has(metric)) {
      this.found.set(metric, null);
      void this.app.track(this.ask(shown.document, metric), "The shortest path could not be computed.");
    }
    return this.found.get(metric) ?? null;
  }

  /** @param {ScenarioDocument} document @param {Metric} metric */
  async ask(document, metric) {
    const { found, query } = this;
    this.worker ??= /** @type {PlannerWorker} */ (this.app.hire());
    try {
      const { length, path, exact } = await this.worker.optimum(document, { query, metric });
      if (length !== null) found.set(metric, { length, rows: Float64Array.from(path.flat()), isExact: exact });
      this.onFound();
    } catch (error) {
      // A query with a target has none, nor has one whose start or goal is in collision.
      if (["", "internal"].includes(errorInfo(error).code)) throw error;
    }
  }
}
