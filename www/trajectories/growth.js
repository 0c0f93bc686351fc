/**
 * What has grown so far, as the page knows it: it asks the worker for more and keeps what comes. What belongs to an experiment that
 * was given up meanwhile is dropped.
 */

/** @import { TrajectoriesResult, TrajectoryOptions } from "planarium" */
/** @import { Asker } from "../room/ask.js" */
/** @import { Commands, News } from "./worker.js" */

/** @typedef {{ line: Float32Array, other: number, place: [number, number] }} Refused   one that crosses an earlier one, and where */

export class Growth {
  /** @param {Asker<Commands>} asker */
  constructor(asker) {
    this.asker = asker;
    /** How often it has begun. */
    this.epoch = 0;
    /** @type {TrajectoryOptions} */
    this.options = {};
    /** @type {TrajectoriesResult | null} */
    this.result = null;
    /** Rows of x, y, theta, v, w, duration, one after the other. @type {number[]} */
    this.rows = [];
    /** Points of each accepted one at equal times, metres. @type {Float32Array[]} */
    this.lines = [];
    /** When each was told of, as of performance.now(). @type {number[]} */
    this.born = [];
    /** @type {number[]} */
    this.tries = [];
    /** @type {number[]} */
    this.milliseconds = [];
    /** The last one refused. @type {Refused | null} */
    this.refused = null;
    /** When it was told of. */
    this.refusedAt = -Infinity;
    this.isLastRefused = false;
  }

  clear() {
    for (const list of [this.rows, this.lines, this.born, this.tries, this.milliseconds]) list.length = 0;
    Object.assign(this, { refused: null, refusedAt: -Infinity, isLastRefused: false });
  }

  get isRunning() { return this.result?.status === "running"; }

  /** Begins anew. @param {TrajectoryOptions} options @returns {Promise<boolean>}  false: given up for another meanwhile @throws {Error} they are refused */
  async begin(options) {
    const epoch = ++this.epoch;
    const result = await this.asker.ask("begin", options);
    if (epoch !== this.epoch) return false;
    this.clear();
    this.options = options;
    this.result = result;
    return true;
  }

  /** Tries so many more; calls back after each answer. @param {number} count @param {() => void} onNews @returns {Promise<boolean>} whether there is more to try */
  async advance(count, onNews) {
    const { epoch } = this;
    for (let left = count; left > 0 && this.isRunning && epoch === this.epoch;) {
      const news = await this.asker.ask("advance", left);
      if (epoch !== this.epoch) return false;
      left -= news.done;
      this.take(news);
      onNews();
    }
    return this.isRunning && epoch === this.epoch;
  }

  /** @param {News} news */
  take({ accepted, refused, milliseconds, tries, lines, isLastRefused, result }) {
    const now = performance.now();
    const count = tries.length;
    for (const value of accepted) this.rows.push(value);
    for (let i = 0; i < count; i++) {
      this.lines.push(lines[i]);
      this.born.push(now);
      this.tries.push(tries[i]);
      this.milliseconds.push(milliseconds[i]);
    }
    if (refused.length > 0) {
      this.refused = { line: lines[count], other: refused[6], place: [refused[7], refused[8]] };
      this.refusedAt = now;
    }
    this.isLastRefused = isLastRefused;
    this.result = result;
  }
}

/** Means over so many values, each with the number of its last one, counted from 1. @param {number[]} values @param {number} window @returns {[number, number][]} */
export function movingAverage(values, window) {
  /** @type {[number, number][]} */
  const means = [];
  let sum = 0;
  values.forEach((value, i) => {
    sum += value - (values[i - window] ?? 0);
    if (i >= window - 1) means.push([i + 1, Math.max(0, sum / window)]);
  });
  return means;
}
