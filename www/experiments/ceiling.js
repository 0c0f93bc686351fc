/**
 * The ceiling of a share of trials solved: how many worlds have a path at all. A path of a trial whose motions are
 * proven shows that there is one; elsewhere a certificate may show it, or that there is none.
 */
import { counted } from "../app/dom.js";
import { TASK, pairsOf } from "./common.js";
import { nameOf } from "./factors.js";
import { SOLVED } from "./measures.js";
import { sampleOf } from "./tables.js";

/** @import { ExperimentDocument } from "planarium/full" */
/** @import { Rows } from "./rows.js" */

/** @typedef {import("./commands.js").Verdict} Verdict */
/** Trials with the same world and query. @typedef {{ key: number, trials: number[], hasPath: boolean }} Task */

/** Settings under which a path is proven to be free. @type {[name: string, proven: string][]} */
const PROVEN = [
  ["edge_check", "proven"],
  ["integration", "exact"],
];

/** @param {Rows} rows @param {ExperimentDocument} document @returns {Task[]} */
export function tasksOf(rows, document) {
  const planners = new Map(document.planners.map((entry) => [nameOf(entry), entry]));
  const isProven = (/** @type {number} */ trial) =>
    rows.cell(trial, "valid") === true ||
    PROVEN.every(([name, proven]) => {
      const set = planners.get(rows.cell(trial, "planner"))?.set;
      return (rows.cell(trial, `planner.${name}`) ?? set?.[name] ?? proven) === proven;
    });
  return Array.from(pairsOf(rows, Array.from(rows.ended()), TASK), ([key, trials]) => {
    const solved = sampleOf(rows, trials, SOLVED);
    return { key, trials, hasPath: trials.some((trial, i) => solved[i] === 1 && isProven(trial)) };
  });
}

/**
 * @typedef {object} Ceiling
 * @property {number} most   per cent of the trials that can be solved, at most
 * @property {string} words
 */

/**
 * @param {Task[]} tasks
 * @param {Map<number, Verdict>} verdicts  of those without a path, by their keys
 * @returns {Ceiling}
 */
export function ceilingOf(tasks, verdicts) {
  const verdict = (/** @type {Task} */ { key, hasPath }) => (hasPath ? "connected" : (verdicts.get(key) ?? "unknown"));
  const count = (/** @type {Verdict[]} */ ...wanted) => tasks.filter((task) => wanted.includes(verdict(task))).length;
  const trials = tasks.reduce((sum, task) => sum + task.trials.length, 0);
  const closed = tasks.reduce((sum, task) => sum + (verdict(task) === "infeasible" ? task.trials.length : 0), 0);
  const [open, none, unsupported] = [count("connected"), count("infeasible"), count("unsupported")];
  const unknown = count("unknown") + unsupported;
  const most = (100 * (trials - closed)) / Math.max(1, trials);
  const all = counted(tasks.length, "world");
  const limit = `no planner can solve more than ${Number(most.toFixed(1))} % of these trials`;
  const why = unsupported > 0 ? " (certificates are for discs and arms with two links)" : "";
  const maybe = `${unknown} may have one or not${why}`;
  if (tasks.length === 1) {
    if (none) return { most, words: "The world is proven to have no path." };
    return { most, words: open ? "The world has a path." : `Whether the world has a path is unknown${why}.` };
  }
  if (none === tasks.length) return { most, words: `All ${all} are proven to have no path.` };
  if (none + unknown === 0) return { most, words: `All ${all} have a path.` };
  const parts = [
    ...(open > 0 ? [`${open} ${open === 1 ? "has" : "have"} a path`] : []),
    ...(none > 0 ? [`${none} ${none === 1 ? "is" : "are"} proven to have none`] : []),
    ...(unknown > 0 ? [maybe] : []),
  ];
  const listed = parts.length > 1 ? `${parts.slice(0, -1).join(", ")} and ${parts[parts.length - 1]}` : parts[0];
  return { most, words: `Of ${all} ${listed}${none > 0 ? `: ${limit}` : ""}.` };
}
