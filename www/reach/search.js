/** One run of inverse kinematics, as far as it has come: iterates, solutions, what is to be drawn of them. */

import { withOptions } from "../option-names.js";

/** @import { Arm } from "./arm.js" */
/** @import { Point } from "./types.js" */
/** @typedef {Record<string, number | string | boolean>} Settings */
/** @typedef {{ restart: number, error: number, q: Float64Array }} Iterate */
/** @typedef {{ q: Float64Array, isFree: boolean }} Solution */

export class Search {
  /**
   * @param {Arm} arm
   * @param {{ target: Point, orientation: number | null, start: ArrayLike<number>, method: string, settings: Settings }} wish
   * @throws {Error} with `code` and `pointer`, where the core refuses it
   */
  constructor(arm, { target, orientation, start, method, settings }) {
    this.arm = arm;
    const wish = { ...settings, method, target, start: Array.from(start), ...(orientation === null ? {} : { orientation }) };
    this.run = withOptions(wish, (options) => arm.scenario.reach(options));
    /** @type {Iterate[]} */
    this.iterates = [];
    /** @type {Solution[]} */
    this.solutions = [];
    this.status = this.run.status;
    this.follow();
  }

  /** @param {number} count  iterations at most @returns {boolean} whether it goes on */
  step(count) {
    this.status = this.run.step(count);
    this.follow();
    return this.status === "running";
  }

  /** Takes in what is new. */
  follow() {
    const { arm, run, iterates, solutions } = this;
    const n = arm.dimension;
    const rows = run.iteratesSince(iterates.length);
    for (let i = 0; i < rows.length; i += n + 2) iterates.push({ restart: rows[i], error: rows[i + 1], q: rows.slice(i + 2, i + 2 + n) });
    const found = run.solutionsSince(solutions.length);
    for (let i = 0; i < found.length; i += n) {
      const q = found.slice(i, i + n);
      solutions.push({ q, isFree: arm.isFree(q) });
    }
  }

  /** The newest iterate. */
  get last() { return this.iterates[this.iterates.length - 1]; }

  /** The iterates since the last start was drawn, the newest last. @param {number} most */
  recent(most) {
    const { restart } = this.last;
    return this.iterates.slice(-most).filter((iterate) => iterate.restart === restart);
  }

  free() { this.run.free(); }
}
