/** The experiment as the page has received it. */
import { latest } from "../app/work.js";
import { rowsOf } from "../domain/coordinates.js";

/** @import { TrajectoriesResult, TrajectoryOptions } from "planarium/full" */
/** @import { Remote } from "../app/worker-client.js" */
/** @import { Commands, Progress } from "./commands.js" */

/**
 * An accepted trajectory: x, y, theta, v, w, duration; points at equal times, metres; when it was received, as of
 * performance.now().
 * @typedef {{ row: Float64Array, line: Float32Array, born: number, tries: number, milliseconds: number }} Accepted
 */

/** Values in a moving average. */
export const WINDOW = 20;

export class Experiment {
  /** @param {Remote<Commands>} worker */
  constructor(worker) {
    this.worker = worker;
    /** Another number for each experiment. */
    this.epoch = 0;
    /** Whether the experiment was given up. */
    this.signal = new AbortController().signal;
    /** @type {TrajectoryOptions} */
    this.options = {};
    /** @type {TrajectoriesResult | null} */
    this.result = null;
    /** @type {Accepted[]} */
    this.accepted = [];
    /**
     * The last one rejected: the number of the one it crosses, where, and when it was received.
     * @type {{ line: Float32Array, other: number, place: [number, number], born: number } | null}
     */
    this.rejected = null;
    this.isLastRejected = false;
  }

  get isRunning() {
    return this.result?.status === "running";
  }

  /** Begins another experiment, unless its options are refused. */
  begin = latest(async (signal, /** @type {TrajectoryOptions} */ options) => {
    const result = await this.worker.begin(options, signal);
    this.epoch++;
    Object.assign(this, { options, result, accepted: [], rejected: null, isLastRejected: false, signal });
  });

  /**
   * @param {number} count  tries
   * @param {() => void} onProgress
   * @returns {Promise<boolean>} whether more tries can be made
   */
  async advance(count, onProgress) {
    const { signal } = this;
    for (let left = count; left > 0 && this.isRunning;) {
      const progress = await this.worker.advance(left, signal);
      left -= progress.done;
      this.add(progress);
      onProgress();
    }
    return this.isRunning;
  }

  /** @param {Progress} progress */
  add({ accepted, rejected, milliseconds, tries, lines, isLastRejected, result }) {
    const born = performance.now();
    rowsOf(accepted, 6).forEach((row, i) =>
      this.accepted.push({ row, line: lines[i], born, tries: tries[i], milliseconds: milliseconds[i] }),
    );
    if (rejected.length > 0)
      this.rejected = { line: lines[tries.length], other: rejected[6], place: [rejected[7], rejected[8]], born };
    Object.assign(this, { isLastRejected, result });
  }
}

/**
 * Means of the last WINDOW values, each with the number of the last one, counted from 1.
 * @param {number[]} values
 * @returns {[number, number][]}
 */
export function movingAverage(values) {
  let sum = 0;
  return values
    .map((value, i) => {
      sum += value - (values[i - WINDOW] ?? 0);
      return /** @type {[number, number]} */ ([i + 1, Math.max(0, sum / WINDOW)]);
    })
    .slice(WINDOW - 1);
}
