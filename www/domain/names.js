/**
 * Names of robots, parts, obstacles and lengths. Links are counted from 1, obstacles from 0 as in the scenario
 * document.
 */

import { hasSlide } from "./coordinates.js";

/** @import { Check, Scenario, ScenarioDocument } from "./types.js" */

/** Begins the name of a scene that is generated and not a built-in one; the name of its generator follows. */
export const MADE = "make-";

/** @param {Scenario["robot"]} robot */
export function robotName(robot) {
  return robot === "rigid_body" ? "body" : robot;
}

/** Whether the coordinates of a robot are x, y and theta. @param {Scenario["robot"]} robot */
export function isPlaced(robot) {
  return robot === "rigid_body" || robot === "car";
}

/**
 * The usual axes of the configuration space: for a body x and theta, since the workspace shows x and y.
 * @param {Scenario["robot"]} robot
 * @returns {[number, number]}
 */
export function axesOf(robot) {
  return [0, isPlaced(robot) ? 2 : 1];
}

/**
 * The unit of path lengths; empty for a body and for an arm whose links slide, whose metres and radians are added.
 * @param {ScenarioDocument["robot"]} robot
 */
export function unitOf(robot) {
  return robot.type === "arm" ? (hasSlide(robot) ? "" : "rad") : robot.type === "rigid_body" ? "" : "m";
}

/** The units, by scenario. @type {WeakMap<Scenario, string>} */
const units = new WeakMap();

/** A length of a path, in words. @param {number} length @param {Scenario} scenario */
export function lengthText(length, scenario) {
  let unit = units.get(scenario);
  if (unit === undefined) units.set(scenario, (unit = unitOf(scenario.document().robot)));
  return `${length.toFixed(2)} ${unit}`.trim();
}

/** The weights of metres and radians in words, by scenario. @type {WeakMap<Scenario, string>} */
const weights = new WeakMap();

/**
 * A path's length in words; of a body, whose metres and radians are weighted together, a cost.
 * @param {number} length
 * @param {Scenario} scenario
 */
export function costText(length, scenario) {
  return scenario.robot === "rigid_body"
    ? `cost ${weightedText(length, scenario)}`
    : `length ${lengthText(length, scenario)}`;
}

/** A distance in the metric of a body or a car, in words. @param {number} distance @param {Scenario} scenario */
export function weightedText(distance, scenario) {
  let sum = weights.get(scenario);
  if (sum === undefined) {
    const { robot } = scenario.document();
    const { translation = 0.7, rotation = 0.3 } = ("metric" in robot && robot.metric) || {};
    sum = `${translation} \u00d7 metres + ${rotation} \u00d7 radians`;
    weights.set(scenario, sum);
  }
  return `${distance.toFixed(2)} (${sum})`;
}

/** Why a run has no path, in two words. @param {string | null | undefined} reason  of its result */
export function endText(reason) {
  if (reason === "not-connected") return "not connected";
  return reason === "nothing-to-extend" ? "nothing to extend" : "gave up";
}

/** @param {Scenario} scenario @param {number} part */
export function partName(scenario, part) {
  return scenario.robot === "arm" ? `link ${part + 1}` : robotName(scenario.robot);
}

/** @param {number} obstacle */
export function obstacleName(obstacle) {
  return `obstacle ${obstacle}`;
}

/** The collisions of a check in words, without a full stop. @param {Scenario} scenario @param {Check} check */
export function touchingSentence(scenario, check) {
  const pairs = check.touching.map(({ part, obstacle }) => {
    const name = scenario.robot === "arm" ? partName(scenario, part) : `the ${partName(scenario, part)}`;
    return obstacle === "bounds" ? `${name} leaves the bounds` : `${name} touches ${obstacleName(obstacle)}`;
  });
  if (pairs.length > 3) return `${pairs.slice(0, 3).join(", ")} and ${pairs.length - 3} more`;
  return pairs.join(", ");
}
