/** What is taken away as a file: its name, its content, and how it is handed over. */
import { toCsv } from "../../formats/csv.js";
import { letter } from "../race/standings.js";

/** @import { Cell } from "../../formats/csv.js" */
/** @import { LaneLog, Plan } from "../../domain/types.js" */

/** Columns of a row of history, as the package orders them. */
const COLUMNS = ["vertices", "edges", "events", "phase", "configuration_checks", "motion_checks", "clearance_evaluations", "cost"];
const PHASE = COLUMNS.indexOf("phase");

/** What a file is about: scene, planner, seed and time. @param {string} scene @param {Plan[]} plans  more than one race @param {number} time */
export function nameOf(scene, plans, time) {
  const [{ algorithm, settings }] = plans;
  const who = plans.length > 1 ? ["race"] : [algorithm, `seed${settings.seed ?? 0}`];
  return [scene, ...who, time].join("-").replace(/[^\w.-]+/g, "-");
}

/** A row for each iteration of each run, from before the first; of a race the planner goes before. @param {LaneLog[]} logs @param {Plan[]} plans */
export function countersCsv(logs, plans) {
  const isRace = logs.length > 1;
  /** @type {Cell[][]} */
  const rows = logs.flatMap(({ history, width, phases }, lane) => Array.from({ length: history.length / width }, (_, i) => [
    ...(isRace ? [`${letter(lane)} ${plans[lane].algorithm}`] : []), i,
    ...COLUMNS.map((_name, j) => (j === PHASE ? phases[history[i * width + j]] : history[i * width + j])),
  ]));
  return new Blob([toCsv([...(isRace ? ["planner"] : []), "iteration", ...COLUMNS], rows)], { type: "text/csv" });
}
