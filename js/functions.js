/** Functions beside the core: the lists of choices, and a plan in one call. */
import catalogue from "./catalogue.js";
import { Problem, Scenario } from "./core.js";
import { requireCore } from "./runtime.js";

/**
 * @import { GeneratorInfo, IndexInfo, PlannerInfo, PlannerOptions, ResultDocument, ScenarioDocument } from "./core.js"
 */

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
