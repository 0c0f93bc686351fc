/** How a run went, in few points: as many however long it gets. */
import { PAST } from "./run.js";

/** @import { Run } from "./run.js" */

/** Points of a curve at most, the first path and the end among them. */
const POINTS = 300;

/**
 * Rows of time, vertices and cost: how things stood at that time. Times rise from 0 to `head`; that of the first path is among
 * them. Cost is Infinity while there is no path.
 * @param {Run} run
 * @param {number} column  of the history, -1 for iterations
 * @param {number} head    the latest time to be told
 * @returns {Float64Array}
 */
export function thinned(run, column, head) {
  const times = new Set(Array.from({ length: POINTS - 1 }, (_, i) => Math.round((head * i) / (POINTS - 2))));
  const found = run.foundBy(run.iterationAt(column, head));
  if (found >= 0) times.add(run.clockAt(column, found));
  return Float64Array.from([...times].sort((a, b) => a - b).flatMap((time) => {
    const row = run.history.row(run.iterationAt(column, time));
    return [time, row[PAST.vertices], row[PAST.cost]];
  }));
}
