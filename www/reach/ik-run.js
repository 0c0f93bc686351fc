/** A run of inverse kinematics with its iterates and solutions so far. */

import { withOptions } from "../domain/option-names.js";

/** @import { Arm } from "./arm.js" */
/** @import { Point } from "./types.js" */
/** @typedef {Record<string, number | string | boolean>} Settings */
/** @typedef {{ restart: number, error: number, q: Float64Array }} Iterate */
/** @typedef {{ q: Float64Array, isFree: boolean }} Solution */

/** Solutions drawn and listed, at most. */
const MOST_SHOWN = 24;

export class IkRun {
  /**
   * @param {Arm} arm
   * @param {{ target: Point, orientation: number | null, start: ArrayLike<number>, method: string, settings: Settings }} problem
   * @throws {Error} with `code` and `pointer`, if the core refuses it
   */
  constructor(arm, { target, orientation, start, method, settings }) {
    this.arm = arm;
    const wish = { ...settings, method, target, start: Array.from(start), ...(orientation === null ? {} : { orientation }) };
    this.run = withOptions(wish, (options) => arm.scenario.reach(options));
    /** @type {Iterate[]} */
    this.iterates = [];
    /** @type {Solution[]} */
    this.solutions = [];
    this.update();
  }

  get status() { return this.run.status; }
  get isRunning() { return this.status === "running"; }
  get freeCount() { return this.solutions.filter(({ isFree }) => isFree).length; }
  get shown() { return this.solutions.slice(0, MOST_SHOWN); }

  /** The newest iterate. */
  get last() { return this.iterates[this.iterates.length - 1]; }

  /** @param {number} count  iterations at most */
  step(count) {
    this.run.step(count);
    this.update();
  }

  /** Fetches what is new. */
  update() {
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

  /** The newest iterates from the same start, the newest last and of strength 1. @param {number} most */
  recent(most) {
    const { restart } = this.last;
    const recent = this.iterates.slice(-most).filter((iterate) => iterate.restart === restart);
    return recent.map(({ q }, i) => ({ q, strength: (i + 1) / recent.length }));
  }

  /** The error at each iteration, for each start. @returns {[number, number][][]} */
  curves() {
    /** @type {[number, number][][]} */
    const curves = [];
    this.iterates.forEach(({ restart, error }, i) => (curves[restart] ??= []).push([i, error]));
    return curves;
  }

  free() { this.run.free(); }
}
