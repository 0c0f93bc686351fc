/** What stands on its own: the lists of planners, of generators, of methods, of indexes and of phases, and a fresh seed. */
import { call } from "./runtime.js";

/** @import { GeneratorInfo, IndexInfo, Phase, PlannerInfo, ReachMethodInfo } from "./types.js" */

/**
 * The names of phases: a row of `planner.takeHistory()` holds the place of one in this list.
 * @type {readonly Phase[]}
 */
export const phases = Object.freeze(["sampling", "connecting", "guarding", "searching", "growing", "improving", "done"]);

/**
 * The planners: their pseudo-code, and their parameters with title, meaning, unit, range and default of each.
 * @returns {PlannerInfo[]}
 */
export function planners() {
  return JSON.parse(call((core) => core.planners()));
}

/**
 * The generators and their options, with title, meaning, unit, range and default of each. All take `seed` as well, an integer
 * from 0 (default) to 2^53 - 1.
 * @returns {GeneratorInfo[]}
 */
export function generators() {
  return JSON.parse(call((core) => core.generators()));
}

/**
 * The methods of inverse kinematics: their parameters with title, meaning, unit, range and default of each.
 * @returns {ReachMethodInfo[]}
 */
export function reachMethods() {
  return JSON.parse(call((core) => core.reach_methods()));
}

/**
 * The indexes of configurations that `scenario.neighbours` makes, and their parameters, with title, meaning, unit, range and
 * default of each.
 * @returns {IndexInfo[]}
 */
export function neighbourIndexes() {
  return JSON.parse(call((core) => core.neighbour_indexes()));
}

/**
 * A seed from the platform's entropy: an integer from 0 to 2^53 - 1.
 * @returns {number}
 */
export function freshSeed() {
  return call(() => {
    const [high, low] = crypto.getRandomValues(new Uint32Array(2));
    return (high >>> 11) * 2 ** 32 + low;
  });
}
