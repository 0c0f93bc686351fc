/// <reference lib="esnext.disposable" preserve="true" />
/** Inverse kinematics: a run that is stepped from outside, and read by cursors. */
import * as argument from "./arguments.js";
import { PlanariumError } from "./error.js";
import { Handle, key } from "./handle.js";

/** @import { RawReach } from "./planarium_glue.js" */
/** @import { Followed, NearestPoint, ReachResult, ReachVerdict, Status } from "./types.js" */

/** The core counts them. @type {readonly Status[]} */
const STATUSES = ["running", "solved", "exhausted"];

/**
 * Makes the handle of a run.
 * @param {RawReach} raw
 * @returns {Reach}
 * @internal
 */
export function makeReach(raw) {
  // The constructor is private to callers, not to the package.
  const Construct = /** @type {new (secret: symbol, raw: RawReach) => Reach} */ (/** @type {unknown} */ (Reach));
  return new Construct(key, raw);
}

/**
 * An arm that has followed a hand, as the core tells it.
 * @param {Float64Array} numbers
 * @returns {Followed}
 * @internal
 */
export function followedOf(numbers) {
  const [x, y, distance, turn, reached, manipulability] = numbers;
  return { configuration: numbers.slice(6), point: [x, y], distance, turn, reached: reached === 1, manipulability };
}

/**
 * How near an arm can come, as the core tells it.
 * @param {Float64Array} numbers
 * @returns {NearestPoint}
 * @internal
 */
export function nearestOf(numbers) {
  const [x, y, distance, turn] = numbers;
  return { configuration: numbers.slice(4), point: [x, y], distance, turn };
}

/**
 * A search for joint angles that bring the tip of an arm to a target. It does nothing by itself: each `step` makes some
 * iterations (an update of the joints, or the drawing of a new start), and how they are cut into steps never changes the result.
 * Iterates and solutions are only ever added; whoever watches asks for those since a cursor.
 */
export class Reach {
  /** @type {Handle<RawReach>} */
  #handle;

  /**
   * @param {symbol} secret
   * @param {RawReach} raw
   * @private
   */
  constructor(secret, raw) {
    if (secret !== key) throw new PlanariumError("illegal-constructor", "A Reach comes from scenario.reach(options).");
    this.#handle = new Handle(raw, "Reach");
  }

  /**
   * Makes at most `n` iterations. Once solved or exhausted it does nothing more.
   * @param {number} n  an integer from 0 to 2^53 - 1
   * @returns {Status}
   */
  step(n) {
    return this.#handle.call((raw) => {
      raw.advance(argument.count(n, "n"));
      return STATUSES[raw.status()];
    });
  }

  /**
   * Where the run stands: `solved` once as many distinct solutions are found as were wanted, or any when the budget is spent.
   * @returns {Status}
   */
  get status() {
    return this.#handle.call((raw) => STATUSES[raw.status()]);
  }

  /** Where the run is: its last iterate. A fresh copy. @returns {Float64Array} */
  configuration() {
    return this.#handle.call((raw) => raw.configuration());
  }

  /**
   * The configurations so far, from a row on: the start, and one after each iteration.
   * @param {number} row  an integer from 0 to `iterateCount`
   * @returns {Float64Array} rows of restart (how many starts were drawn before), error, and the configuration
   */
  iteratesSince(row) {
    return this.#handle.call((raw) => raw.iterates_since(argument.count(row, "row")));
  }

  /**
   * The distinct solutions, from a row on, in the order in which they were found.
   * @param {number} row  an integer from 0 to `solutionCount`
   * @returns {Float64Array} rows of configurations
   */
  solutionsSince(row) {
    return this.#handle.call((raw) => raw.solutions_since(argument.count(row, "row")));
  }

  /** Rows of `iteratesSince(0)`. @returns {number} */
  get iterateCount() {
    return this.#handle.call((raw) => raw.state()[4]);
  }

  /** Rows of `solutionsSince(0)`. @returns {number} */
  get solutionCount() {
    return this.#handle.call((raw) => raw.state()[5]);
  }

  /** Configurations that reach the target in collision, where `free_only` is set; `result()` tells them. @returns {number} */
  get rejectedCount() {
    return this.#handle.call((raw) => raw.state()[6]);
  }

  /** Iterations made so far. @returns {number} */
  get iterations() {
    return this.#handle.call((raw) => raw.state()[2]);
  }

  /** Starts drawn so far. @returns {number} */
  get restarts() {
    return this.#handle.call((raw) => raw.state()[3]);
  }

  /**
   * How far the last iterate is from the target: metres of the point, or radians of the orientation, whichever is larger.
   * @returns {number}
   */
  get error() {
    return this.#handle.call((raw) => raw.state()[0]);
  }

  /**
   * Yoshikawa's manipulability at the last iterate, in square metres: 0 where the arm is singular.
   * @returns {number}
   */
  get manipulability() {
    return this.#handle.call((raw) => raw.state()[1]);
  }

  /**
   * What has come of the run. While nothing has been found this works out how near the arm can come: up to some milliseconds
   * for eight links with limits.
   * @returns {ReachVerdict}
   */
  verdict() {
    return this.#handle.call((raw) => raw.verdict());
  }

  /** The result document, the same as the command line prints. @returns {ReachResult} */
  result() {
    return this.#handle.call((raw) => raw.result());
  }

  /** 16 hexadecimal digits over every iterate and solution. @returns {string} */
  fingerprint() {
    return this.#handle.call((raw) => raw.fingerprint());
  }

  /** Gives the memory back. Any use afterwards throws `freed`; freeing twice does nothing. @returns {void} */
  free() {
    this.#handle.free();
  }

  /** The same as `free`, for `using`. @returns {void} */
  [Symbol.dispose]() {
    this.#handle.free();
  }
}
