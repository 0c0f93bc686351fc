/// <reference lib="esnext.disposable" preserve="true" />
/** Trajectories of particles, and many of them of which no two cross. */
import * as argument from "./arguments.js";
import catalogue from "./catalogue.js";
import { Handle } from "./handle.js";
import { call, callWith } from "./runtime.js";

/** @import { RawTrajectories } from "./planarium_glue.js" */
/** @import { ParameterInfo, ParticleMotion, Status, TrajectoriesResult, TrajectoryOptions } from "./types.js" */

/** The core counts them. @type {readonly Status[]} */
const STATUSES = ["running", "solved", "exhausted"];

/**
 * Random trajectories of particles, added one by one: one that crosses none of the earlier ones is accepted, the others are
 * refused. Contact is crossing, and those accepted are proven apart. It does nothing by itself: each `step` tries some
 * trajectories, and how they are cut into steps never changes the result. Both lists are only ever added to; whoever watches asks
 * for what is new since a cursor.
 */
export class Trajectories {
  /** @type {Handle<RawTrajectories>} */
  #handle;

  /**
   * @param {TrajectoryOptions} [options]  those of `trajectoryOptions()`, and `seed`
   * @throws {import("./error.js").PlanariumError} `unknown-parameter`, `wrong-type`, `not-finite` or `out-of-range`, with the pointer of the option
   */
  constructor(options) {
    const raw = callWith(() => [argument.options(options)], (core, text) => core.RawTrajectories.begin(text));
    this.#handle = new Handle(raw, "Trajectories");
  }

  /**
   * Tries at most `n` trajectories. Once solved or exhausted it does nothing more.
   * @param {number} n  an integer from 0 to 2^53 - 1
   * @returns {Status}
   */
  step(n) {
    return this.#handle.call((raw) => {
      raw.advance(argument.count(n, "n"));
      return STATUSES[raw.status()];
    });
  }

  /** `solved` once `count` are accepted, `exhausted` once `max_iterations` are tried before. @returns {Status} */
  get status() {
    return this.#handle.call((raw) => STATUSES[raw.status()]);
  }

  /** Trajectories tried so far. @returns {number} */
  get iterations() {
    return this.#handle.call((raw) => raw.counts()[0]);
  }

  /** Trajectories accepted so far. @returns {number} */
  get acceptedCount() {
    return this.#handle.call((raw) => raw.counts()[1]);
  }

  /** Trajectories refused so far. @returns {number} */
  get refusedCount() {
    return this.#handle.call((raw) => raw.counts()[2]);
  }

  /**
   * The accepted ones, from a row on. A fresh copy, yours to keep.
   * @param {number} row  an integer from 0 to `acceptedCount`
   * @returns {Float64Array} rows of x, y, theta, v, w, duration
   */
  acceptedSince(row) {
    return this.#handle.call((raw) => raw.accepted_since(argument.count(row, "row")));
  }

  /**
   * The refused ones, from a row on. A fresh copy, yours to keep.
   * @param {number} row  an integer from 0 to `refusedCount`
   * @returns {Float64Array} rows of x, y, theta, v, w, duration, the number of the first accepted one that it crosses, and x and y
   *   of a place where it does
   */
  refusedSince(row) {
    return this.#handle.call((raw) => raw.refused_since(argument.count(row, "row")));
  }

  /** Of every accepted one: how many were tried for it, itself included. A fresh copy. @returns {Uint32Array} */
  tries() {
    return this.#handle.call((raw) => raw.tries());
  }

  /** The result document, the same as the command line prints, but for its seconds. @returns {TrajectoriesResult} */
  result() {
    return this.#handle.call((raw) => raw.result());
  }

  /** 16 hexadecimal digits over all that was tried, in its order; `index` does not change it. @returns {string} */
  get fingerprint() {
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

/**
 * The options of `new Trajectories`, with title, meaning, unit, range and default of each. It takes `seed` as well, an integer
 * from 0 (default) to 2^53 - 1.
 * @returns {ParameterInfo[]}
 */
export function trajectoryOptions() {
  return call(() => catalogue().trajectories);
}

/**
 * Where a particle is at some times: on a circular arc, or on the spiral x + v t cos(theta + w t), y + v t sin(theta + w t).
 * @param {ParticleMotion} particle
 * @param {ArrayLike<number>} times  seconds from 0 to a million
 * @returns {Float64Array} x and y for each time
 * @throws {import("./error.js").PlanariumError} `unknown-parameter`, `wrong-type`, `not-finite` or `out-of-range`, with the pointer of the field
 */
export function particlePoints(particle, times) {
  return callWith(
    () => [argument.options(particle), argument.rows(times, 1, "times")],
    (core, told, seconds) => core.particle_points(told, seconds));
}
