/** Runs whose planners are stepped in the test's own thread, as the worker steps the page's. */
import { phases, planners } from "planarium";
import { RunLog } from "../../www/planner/run-log/run-log.js";
import { load } from "./library.mjs";
import { Stepper } from "../../www/planner/worker/stepper.js";

/** @import { Scenario, Settings } from "../../www/domain/types.js" */

export class LocalRun extends RunLog {
  /** @param {import("planarium").Scenario} scenario @param {string} algorithm @param {Settings} settings */
  constructor(scenario, algorithm, settings) {
    const own = /** @type {Scenario} */ (/** @type {unknown} */ (scenario));
    super(own, algorithm, settings, { phases, planners: planners() });
    this.stepper = new Stepper(own, algorithm, settings);
  }

  /**
   * Plans until a clock has passed `wanted`, the run ends, or the time passes `until`.
   * @param {number} column
   * @param {number} wanted
   * @param {number} [until]
   */
  advance(column, wanted, until = Infinity) {
    const isThere = this.stepper.advance(column, wanted, until);
    this.fetch();
    return isThere;
  }

  /** Takes in what has grown. */
  fetch() {
    this.take(this.stepper.growth(true));
  }

  /** @override */
  free() {
    this.stepper.free();
    super.free();
  }
}

/** Plans a run to its end. @template {LocalRun} R @param {R} run @returns {R} */
export function ended(run) {
  while (!run.ended) run.advance(-1, Infinity);
  return run;
}

/**
 * A scene's run, planned to its end and shown there.
 * @param {string} id
 * @param {string} algorithm
 * @param {Settings} settings
 */
export function runOf(id, algorithm, settings) {
  const scenario = load(id);
  const run = ended(new LocalRun(scenario, algorithm, settings));
  run.shown = run.made;
  return { scenario, run };
}
