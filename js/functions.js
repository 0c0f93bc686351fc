/** What stands on its own: the lists of planners, of generators, of methods, of indexes and of phases, and a fresh seed. */
import catalogue from "./catalogue.js";
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
  return call(() => catalogue().planners);
}

/**
 * The generators and their options, with title, meaning, unit, range and default of each. All take `seed` as well, an integer
 * from 0 (default) to 2^53 - 1.
 * @returns {GeneratorInfo[]}
 */
export function generators() {
  return call(() => catalogue().generators);
}

/**
 * The methods of inverse kinematics: their parameters with title, meaning, unit, range and default of each.
 * @returns {ReachMethodInfo[]}
 */
export function reachMethods() {
  return call(() => catalogue().reach_methods);
}

/**
 * The indexes of configurations that `scenario.neighbours` makes, and their parameters, with title, meaning, unit, range and
 * default of each.
 * @returns {IndexInfo[]}
 */
export function neighbourIndexes() {
  return call(() => catalogue().indexes);
}

/**
 * A fresh seed, from the entropy of the platform: an integer from 0 to 2^53 - 1.
 * @returns {number}
 */
export function randomSeed() {
  return call((core) => core.random_seed());
}
