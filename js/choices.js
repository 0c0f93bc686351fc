/** The lists that only `planarium/full` has. */
import { chosen } from "./functions.js";

/**
 * @import { FleetGeneratorInfo, FleetPlannerInfo, NavigationGeneratorInfo, ParameterInfo,
 *   ReachMethodInfo } from "./core.js"
 */

/** The methods of inverse kinematics and their parameters. @returns {ReachMethodInfo[]} */
export function reachMethods() {
  return chosen().reach_methods;
}

/**
 * The generators of fleets and their options. All take `seed` as well, a whole number from 0 (default) to 2^53 - 1.
 * @returns {FleetGeneratorInfo[]}
 */
export function fleetGenerators() {
  return chosen().fleet_generators;
}

/**
 * The generators of navigation tasks and their options. All take `seed` as well, a whole number from 0 (default) to
 * 2^53 - 1.
 * @returns {NavigationGeneratorInfo[]}
 */
export function navigationGenerators() {
  return chosen().navigation_generators;
}

/** The options of `navigation.training`. All take `seed` as well. @returns {ParameterInfo[]} */
export function trainingOptions() {
  return chosen().training;
}

/** The options of `navigation.comparison`. All take `seed` as well. @returns {ParameterInfo[]} */
export function comparisonOptions() {
  return chosen().comparison;
}

/** The options of `navigation.planner` and `navigation.edgeRollouts` about edges. @returns {ParameterInfo[]} */
export function rolloutOptions() {
  return chosen().rollouts;
}

/** The planners of fleets and their options. @returns {FleetPlannerInfo[]} */
export function fleetPlanners() {
  return chosen().fleet_planners;
}

/**
 * The options of `new Trajectories`. It takes `seed` as well, a whole number from 0 (default) to 2^53 - 1.
 * @returns {ParameterInfo[]}
 */
export function trajectoryOptions() {
  return chosen().trajectories;
}
