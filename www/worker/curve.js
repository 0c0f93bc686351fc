/** How a run went, in few points: as many however long it gets. */
import { PAST } from "./run.js";

/** @import { Run } from "./run.js" */

/** Points of a curve at most, the first path and the end among them. */
const POINTS = 300;

/**
 * Rows of time, vertices and cost: how things stood at that time. Times rise from 0, are alike for all runs, and end with the
 * run; the time of the first path is among them. Cost is Infinity while there is no path.
 * @param {Run} run
 * @param {number} column  of the history, -1 for iterations
 * @param {number} head    the latest time to be told
 * @returns {Float64Array}
 */
export function thinned(run, column, head) {
  const end = Math.min(head, run.clock(column));
  const found = run.foundBy(run.iterationAt(column, end));
  const times = new Set([end]);
  if (found >= 0) times.add(run.clockAt(column, found));
  for (let i = 0; i < POINTS - 2; i++) {
    const time = Math.round((head * i) / (POINTS - 3));
    if (time <= end) times.add(time);
  }
  return Float64Array.from([...times].sort((a, b) => a - b).flatMap((time) => {
    const row = run.history.row(run.iterationAt(column, time));
    return [time, row[PAST.vertices], row[PAST.cost]];
  }));
}
