/** The history of runs, in a limited number of points. */
import { PAST } from "./columns.js";

/** @import { RunLog } from "./run-log.js" */

/** Points of a curve at most, for up to four runs. */
const POINTS = 300;

/**
 * For each run rows of time, vertices and cost, which is Infinity without a path. The times, from 0 to `head`, are the
 * same for all runs and include those of the first paths; from 1 on their ratios are even if `isLog`, else their
 * differences.
 * @param {RunLog[]} runs
 * @param {number} column  of the history, -1 for iterations
 * @param {number} head    the latest time
 * @param {boolean} [isLog]
 * @returns {Float64Array[]}
 */
export function thinned(runs, column, head, isLog = false) {
  const at = (/** @type {number} */ share) => Math.round(isLog ? head ** share : head * share);
  const times = new Set(Array.from({ length: POINTS - 4 }, (_, i) => at(i / (POINTS - 5))));
  for (const run of runs) {
    const found = run.foundBy(run.iterationAt(column, head));
    if (found >= 0) times.add(run.clockAt(column, found));
  }
  const sorted = [...times].sort((a, b) => a - b);
  return runs.map((run) =>
    Float64Array.from(
      sorted.flatMap((time) => {
        const row = run.history.row(run.iterationAt(column, time));
        return [time, row[PAST.vertices], row[PAST.length]];
      }),
    ),
  );
}
