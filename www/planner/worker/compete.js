/**
 * Steps several planners with equal work: the one that has done least is stepped next. So a block that ends early
 * leaves them nearly level, whatever their iterations cost.
 */

/** @import { Stepper } from "./stepper.js" */

/** How far a planner may get ahead of the next one; what is ahead is not shown. */
const LEAD = 1000;

/**
 * Plans until every run has passed a time or ended, or the block is full.
 * @param {Stepper[]} runs
 * @param {number} column  of the history: the clock of all runs
 * @param {number} wanted  may be Infinity
 * @param {number} until   on the clock of performance.now(), milliseconds
 * @returns {boolean} whether all have reached that time or ended
 */
export function compete(runs, column, wanted, until) {
  const bursts = new Map(runs.map((run) => [run, run.burst(wanted)]));
  for (;;) {
    const behind = runs
      .filter((run) => !run.hasPassed(column, wanted))
      .sort((a, b) => a.clock(column) - b.clock(column));
    if (behind.length === 0) return true;
    const [last, next = last] = behind;
    if (!last.advance(column, Math.min(wanted, next.clock(column) + LEAD), until, bursts.get(last))) return false;
  }
}
