/** The names of planners in a race: a letter, the title, and the settings that differ from the others'. */
import { letter } from "./standings.js";

/** @import { Plan } from "../../domain/types.js" */

/** Differences in a name at most. */
const NAMED = 3;

/** @param {Plan[]} plans @param {(algorithm: string) => string} titleOf @returns {string[]} */
export function nameAll(plans, titleOf) {
  if (plans.length === 1) return [titleOf(plans[0].algorithm)];
  return plans.map(({ algorithm, settings }, lane) => {
    const names = new Set(
      plans.flatMap((plan) => (plan.algorithm === algorithm ? Object.keys(plan.settings) : ["seed"])),
    );
    const differing = [...names].filter((name) =>
      plans.some((plan) => {
        return (name === "seed" || plan.algorithm === algorithm) && plan.settings[name] !== settings[name];
      }),
    );
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
