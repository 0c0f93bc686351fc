/** What the planners of a race are called: a letter, the planner, and what sets it apart from the others. */
import { letter } from "./standings.js";

/** @import { Plan } from "../../domain/types.js" */

/** Differences told at most. */
const NAMED = 3;

/** The planners' names, each with what sets it apart from the others. @param {Plan[]} plans @param {(algorithm: string) => string} titleOf @returns {string[]} */
export function nameAll(plans, titleOf) {
  if (plans.length === 1) return [titleOf(plans[0].algorithm)];
  return plans.map(({ algorithm, settings }, lane) => {
    const names = new Set(plans.flatMap((plan) => (plan.algorithm === algorithm ? Object.keys(plan.settings) : ["seed"])));
    const differing = [...names].filter((name) => plans.some((plan) => {
      return (name === "seed" || plan.algorithm === algorithm) && plan.settings[name] !== settings[name];
    }));
    const words = differing.slice(0, NAMED).map((name) => `${name.replaceAll("_", " ")} ${valueOf(settings[name])}`);
    if (differing.length > NAMED) words.push("\u2026");
    return [`${letter(lane)} ${titleOf(algorithm)}`, ...words].join(", ");
  });
}

/** @param {number | string | boolean | undefined} value */
function valueOf(value) {
  if (typeof value === "boolean") return value ? "on" : "off";
  return value === undefined ? "automatic" : String(value);
}
