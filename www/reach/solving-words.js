/** What is said of a run of inverse kinematics. */
import { touchingSentence } from "../domain/names.js";
import { num, pointText } from "./words.js";

/** @import { Bench } from "./bench.js" */
/** @import { Search } from "./search.js" */
/** @typedef {import("planarium").ReachVerdict} Verdict */

/** Why a target is out of reach. */
const REASONS = {
  "too-far": "it is too far away", "too-near": "it is too near to the base", limits: "the stops keep the tip away",
  orientation: "the stops do not allow this direction",
};

/**
 * The sentence over the stage.
 * @param {Bench} bench @param {Search} search @param {Verdict | null} verdict   null while nothing is found
 * @param {{ title: string, wanted: number }} asked   the method's title, and how many solutions are wanted
 * @returns {{ text: string, isBad: boolean }}
 */
export function solvingSentence(bench, search, verdict, { title, wanted }) {
  if (search.status === "running") return { text: goingSentence(bench, search, title), isBad: false };
  const found = search.solutions.length;
  const free = search.solutions.filter(({ isFree }) => isFree).length;
  switch (verdict?.verdict) {
    case "out-of-reach": {
      const { reason, nearest } = verdict;
      const digits = nearest && nearest.distance < 0.005 ? 6 : 2;
      const near = nearest ? ` The nearest point is ${pointText(nearest.point, digits)}, ${num(nearest.distance, digits)} m away.` : "";
      return { text: `${pointText(bench.target, digits)} is out of reach: ${REASONS[reason ?? "too-far"]}.${near}`, isBad: false };
    }
    case "in-collision": {
      const { touching } = verdict;
      const what = touching ? `: ${touchingSentence(bench.arm.scenario, { free: false, touching })}` : "";
      return { text: `Every pose found that reaches the target touches something${what}.`, isBad: true };
    }
    case "not-found": return { text: `The target can be reached, and ${title} did not find how.`, isBad: false };
    default: {
      const rest = found < wanted ? ", and no more within its budget" : "";
      const which = free === found ? "none touches anything" : free === 0 ? "all of them touch something" : `${free} of them ${free === 1 ? "is" : "are"} free`;
      return { text: `${found === 1 ? "One pose reaches" : `${found} poses reach`} the target${rest}: ${found === 1 ? (free === 1 ? "it touches nothing" : "it touches something") : which}.`, isBad: free === 0 };
    }
  }
}

/** While it goes on. @param {Bench} bench @param {Search} search @param {string} title */
function goingSentence({ lock }, { run, last }, title) {
  if (run.iterations === 0) return `Drag the target, then play: ${title} turns the joints until the tip is there.`;
  const start = run.restarts === 0 ? "from where the arm was" : `from start ${run.restarts + 1}`;
  return `${title}, ${start}: the tip is ${small(last.error)} ${lock === null ? "m" : "m or rad"} off.`;
}

/** An error in few characters. @param {number} value */
export function small(value) {
  if (value === 0) return "0";
  return value >= 0.001 ? num(value, 3) : value.toExponential(1).replace("e-", "\u00b710\u207b").replace(/\u207b(\d+)$/, (_, digits) => `\u207b${[...digits].map((d) => "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[Number(d)]).join("")}`);
}
