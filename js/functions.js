/**
 * Functions beside the core: the lists of what there is to choose from, the names of numbers in tables, and a plan in
 * one call.
 */
import catalogue from "./catalogue.js";
import { Problem, Scenario } from "./core.js";
import { requireCore } from "./runtime.js";

/**
 * @import { GeneratorInfo, IndexInfo, PlannerInfo, PlannerOptions, ResultDocument, ScenarioDocument } from "./core.js"
 */

/** The phases: a row of `planner.historySince` holds an index into this list. */
export const phases = Object.freeze(
  /** @type {const} */ (["sampling", "connecting", "guarding", "searching", "growing", "improving", "done"]),
);

/** The kinds of events: a row of `planner.eventsSince` begins with an index into this list. */
export const eventKinds = Object.freeze(
  /** @type {const} */ (["rejected", "refused", "expanded", "solved", "discarded", "guard", "removed", "rewired"]),
);

/** The columns of `planner.historySince`; `length` is that of the best path so far. */
export const historyColumns = Object.freeze(
  /** @type {const} */ ([
    "vertices",
    "edges",
    "events",
    "phase",
    "configurationChecks",
    "motionChecks",
    "clearanceEvaluations",
    "length",
  ]),
);

/** The lists, of which callers get copies of their own. @internal */
export function chosen() {
  requireCore();
  return catalogue();
}

/** The planners: their pseudo-code, presets, and parameters. @returns {PlannerInfo[]} */
export function planners() {
  return chosen().planners;
}

/**
 * The generators of scenarios and their options. All take `seed` as well, a whole number from 0 (default) to 2^53 - 1.
 * @returns {GeneratorInfo[]}
 */
export function generators() {
  return chosen().generators;
}

/** The indexes that `scenario.neighbours` makes, and their parameters. @returns {IndexInfo[]} */
export function neighbourIndexes() {
  return chosen().indexes;
}

/**
 * Plans in one call: starts a planner, steps it to its end, and frees it.
 * @param {Scenario | Problem | ScenarioDocument | string} scenario
 * @param {PlannerOptions} [options]
 * @returns {ResultDocument}
 * @throws {import("./error.js").PlanariumError} those of `Scenario.parse` and `planner`; what a function of a problem
 *   throws
 */
export function solve(scenario, options) {
  const parsed = scenario instanceof Scenario || scenario instanceof Problem ? scenario : Scenario.parse(scenario);
  try {
    const planner = parsed.planner(options);
    try {
      planner.step(Number.MAX_SAFE_INTEGER);
      return planner.result();
    } finally {
      planner.free();
    }
  } finally {
    if (parsed !== scenario) parsed.free();
  }
}
