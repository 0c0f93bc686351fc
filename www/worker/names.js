/** What the page calls the things that can touch, counted from 0 as in the scenario document. */

/** @import { Check, Scenario } from "../types.js" */

/** @param {Scenario} scenario @param {number} part */
export function partName(scenario, part) {
  return scenario.robot === "arm" ? `link ${part}` : "disc";
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
