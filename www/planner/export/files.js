/** The names of exported files, and the counters as CSV. */
import { toCsv } from "../../formats/csv.js";
import { letter } from "../race/standings.js";

/** @import { Cell } from "../../formats/csv.js" */
/** @import { Plan } from "../../domain/types.js" */
/** @import { RunLog } from "../run-log/run-log.js" */

/** Columns of a row of history, in the order of the package. */
const COLUMNS = [
  "vertices",
  "edges",
  "events",
  "phase",
  "configuration_checks",
  "motion_checks",
  "clearance_evaluations",
  "cost",
];
const PHASE = COLUMNS.indexOf("phase");

/**
 * A name made of scene, planner, seed and time.
 * @param {string} scene
 * @param {Plan[]} plans  several in a race
 * @param {number} time
 */
export function nameOf(scene, plans, time) {
  const [{ algorithm, settings }] = plans;
  const planner = plans.length > 1 ? ["race"] : [algorithm, `seed${settings.seed ?? 0}`];
  return [scene, ...planner, time].join("-").replace(/[^\w.-]+/g, "-");
}

/**
 * A row for each iteration of each run, from the state before the first on; in a race each row begins with the planner.
 * @param {RunLog[]} runs
 */
export function countersCsv(runs) {
  const isRace = runs.length > 1;
  /** @type {Cell[][]} */
  const rows = runs.flatMap(({ history, phases, algorithm }, lane) =>
    Array.from({ length: history.count }, (_, i) => [
      ...(isRace ? [`${letter(lane)} ${algorithm}`] : []),
      i,
      ...Array.from(history.row(i), (value, j) => (j === PHASE ? phases[value] : value)),
    ]),
  );
  return new Blob([toCsv([...(isRace ? ["planner"] : []), "iteration", ...COLUMNS], rows)], { type: "text/csv" });
}
