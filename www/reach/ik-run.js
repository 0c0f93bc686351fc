/** A run of inverse kinematics with its iterates and solutions so far. */
import { rowsOf } from "../domain/coordinates.js";
import { withOptions } from "../domain/option-names.js";

/** @import { ReachMethodInfo, ReachVerdict } from "planarium/full" */
/** @import { Point, Settings } from "../domain/types.js" */
/** @import { Robot } from "./robot.js" */

/** The page's defaults where the core's are others. @type {Settings} */
export const DEFAULTS = { solutions: 8, restarts: 40 };
/** Solutions drawn and listed, at most. */
const MOST_SHOWN = 24;

export class IkRun {
  /**
   * @param {Robot} robot
   * @param {{ target: Point, orientation: number | null, start: Float64Array, method: ReachMethodInfo, settings:
   *   Settings }} problem
   * @throws {Error} with `code` and `pointer`, if the core refuses it
   */
  constructor(robot, problem) {
    const { target, orientation, start, method, settings } = (this.problem = problem);
    this.robot = robot;
    this.method = method;
    const wish = {
      ...settings,
      method: method.id,
      target,
      start: Array.from(start),
      ...(orientation === null ? {} : { orientation }),
    };
    this.run = withOptions(wish, (options) => robot.scenario.reach(options));
    /** @type {{ restart: number, error: number, q: Float64Array }[]} */
    this.iterates = [];
    /** @type {{ q: Float64Array, isFree: boolean }[]} */
    this.solutions = [];
    /** Null while nothing is found. @type {ReachVerdict | null} */
    this.verdict = null;
    this.step(0);
  }

  get isRunning() {
    return this.run.status === "running";
  }
  /** The nearest point, if the target is out of reach. */
  get nearest() {
    return this.verdict?.nearest ?? null;
  }
  get freeCount() {
    return this.solutions.filter(({ isFree }) => isFree).length;
  }
  get shown() {
    return this.solutions.slice(0, MOST_SHOWN);
  }

  /** The newest iterate. */
  get last() {
    return this.iterates[this.iterates.length - 1];
  }

  /** Makes iterations and fetches what is new. @param {number} count  at most */
  step(count) {
    const { robot, run, iterates, solutions } = this;
    const n = robot.dimension;
    if (count > 0) run.step(count);
    for (const row of rowsOf(run.iteratesSince(iterates.length), n + 2))
      iterates.push({ restart: row[0], error: row[1], q: row.subarray(2) });
    for (const q of rowsOf(run.solutionsSince(solutions.length), n)) solutions.push({ q, isFree: robot.isFree(q) });
    if (!this.isRunning || solutions.length > 0) this.verdict = run.verdict();
  }

  /**
   * What the arm shows: the newest iterate; at the end a solution, a collision-free one if there is any.
   * @returns {{ index: number, q: Float64Array }}  -1: no solution
   */
  get pose() {
    const { solutions, isRunning, last } = this;
    const index =
      isRunning || solutions.length === 0
        ? -1
        : Math.max(
            0,
            solutions.findIndex(({ isFree }) => isFree),
          );
    return { index, q: solutions[index]?.q ?? last.q };
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

  free() {
    this.run.free();
  }
}
