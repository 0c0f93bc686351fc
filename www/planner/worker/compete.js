/**
 * Several planners side by side, each given as much of the same work as the others: whoever has done least goes next. So a
 * frame that is too short for all stops with all of them nearly level, whatever their iterations cost.
 */

/** @import { Stepper } from "./stepper.js" */

/** How far ahead of the next one a planner may plan before it is that one's turn; what is ahead is not shown. */
const LEAD = 1000;

/**
 * Plans until every run has passed a time or ended, or the frame is full.
 * @param {Stepper[]} runs
 * @param {number} column  of the history: the clock that all go by
 * @param {number} wanted  may be Infinity
 * @param {number} until   on the clock of performance.now(), milliseconds
 * @returns {boolean} whether all have come that far
 */
export function compete(runs, column, wanted, until) {
  const bursts = new Map(runs.map((run) => [run, run.burst()]));
  for (;;) {
    const behind = runs.filter((run) => !run.hasPassed(column, wanted)).sort((a, b) => a.clock(column) - b.clock(column));
    if (behind.length === 0) return true;
    const [last, next = last] = behind;
    if (!last.advance(column, Math.min(wanted, next.clock(column) + LEAD), until, bursts.get(last))) return false;
  }
}
