/** What the page calls the things that can touch, links counted from 1, and obstacles from 0 as in the scenario document. */

/** @import { Check, Scenario } from "./types.js" */

/** What the robot is called. @param {Scenario["robot"]} robot */
export function robotName(robot) { return robot === "rigid_body" ? "body" : robot; }

/** Is it placed by x, y and theta? @param {Scenario["robot"]} robot */
export function isPlaced(robot) { return robot === "rigid_body" || robot === "car"; }

/** Which coordinates a square shows unless others are wanted: of a body x and theta say more than x and y, which the workspace shows as well. @param {Scenario["robot"]} robot @returns {[number, number]} */
export function axesOf(robot) { return [0, isPlaced(robot) ? 2 : 1]; }

/** What lengths of paths are measured in; nothing where metres and radians are weighted together. @param {Scenario["robot"]} robot */
export function unitOf(robot) { return robot === "arm" ? "rad" : robot === "disc" ? "m" : ""; }

/** A length of a path, in words. @param {number} length @param {Scenario["robot"]} robot */
export function lengthText(length, robot) { return `${length.toFixed(2)} ${unitOf(robot)}`.trim(); }

/** What the metres and radians of a placed robot's paths are weighted with, as text, by scenario. @type {WeakMap<Scenario, string>} */
const weights = new WeakMap();

/** A path's length with its name and unit; where metres and radians are weighted together, it is a cost. @param {number} length @param {Scenario} scenario */
export function costText(length, scenario) {
  if (!isPlaced(scenario.robot)) return `length ${lengthText(length, scenario.robot)}`;
  let sum = weights.get(scenario);
  if (sum === undefined) {
    const { robot } = scenario.document();
    const { translation = 0.7, rotation = 0.3 } = ("metric" in robot && robot.metric) || {};
    sum = `${translation} \u00d7 metres + ${rotation} \u00d7 radians`;
    weights.set(scenario, sum);
  }
  return `cost ${length.toFixed(2)} (${sum})`;
}

/** @param {Scenario} scenario @param {number} part */
export function partName(scenario, part) {
  return scenario.robot === "arm" ? `link ${part + 1}` : robotName(scenario.robot);
}

/** @param {number} obstacle */
export function obstacleName(obstacle) {
  return `obstacle ${obstacle}`;
}

/** A sentence for a check, without its full stop. @param {Scenario} scenario @param {Check} check */
export function touchingSentence(scenario, check) {
  const pairs = check.touching.map(({ part, obstacle }) => {
    const name = partName(scenario, part);
    return obstacle === "bounds" ? `${name} leaves the bounds` : `${name} touches ${obstacleName(obstacle)}`;
  });
  if (pairs.length > 3) return `${pairs.slice(0, 3).join(", ")} and ${pairs.length - 3} more`;
  return pairs.join(", ");
}
