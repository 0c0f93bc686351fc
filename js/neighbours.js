/// <reference lib="esnext.disposable" preserve="true" />
/** An index of configurations, which finds the nearest of many. */
import * as argument from "./arguments.js";
import { PlanariumError } from "./error.js";
import { Handle, key } from "./handle.js";

/** @import { RawNeighbours } from "./planarium_glue.js" */
/** @import { Configuration, NeighboursFound } from "./types.js" */

/**
 * Makes the handle of an index.
 * @param {RawNeighbours} raw
 * @param {number} dimension  of a configuration
 * @returns {Neighbours}
 * @internal
 */
export function makeNeighbours(raw, dimension) {
  // The constructor is private to callers, not to the package.
  const Construct = /** @type {new (secret: symbol, raw: RawNeighbours, dimension: number) => Neighbours} */ (/** @type {unknown} */ (Neighbours));
  return new Construct(key, raw, dimension);
}

/**
 * An index of configurations that grows. Configurations are numbered from 0 in the order in which they are added; neighbours
 * come nearest first, and ties go to the lower number. A linear scan and a kd-tree give the same answer, bit for bit, in every
 * metric; a forest may miss some of the nearest.
 */
export class Neighbours {
  /** @type {Handle<RawNeighbours>} */
  #handle;
  /** @type {number} */
  #dimension;

  /**
   * @param {symbol} secret
   * @param {RawNeighbours} raw
   * @param {number} dimension
   * @private
   */
  constructor(secret, raw, dimension) {
    if (secret !== key) throw new PlanariumError("illegal-constructor", "Neighbours come from scenario.neighbours(options).");
    this.#handle = new Handle(raw, "Neighbours");
    this.#dimension = dimension;
  }

  /**
   * Adds configurations: all of them, or where one is refused none.
   * @param {Float64Array | readonly number[] | readonly Configuration[]} rows  one after the other in one array, or an array of arrays
   * @returns {void}
   * @throws {PlanariumError} `wrong-dimension`; `not-finite`, `out-of-range` (also outside joint limits) with a pointer of row and
   *   number, such as `/rows/2/0`; `too-large` beyond 1,000,000 configurations, or in a forest 10,000,000 divided by its trees
   */
  add(rows) {
    this.#handle.callWith(() => [argument.matrix(rows, this.#dimension, "rows")], (raw, given) => raw.add(given));
  }

  /** How many configurations there are. @returns {number} */
  get size() {
    return this.#handle.call((raw) => raw.size());
  }

  /**
   * The `k` configurations nearest to `q`; all, where there are fewer.
   * @param {Configuration} q
   * @param {number} k
   * @returns {NeighboursFound}
   * @throws {PlanariumError} `wrong-dimension`, `not-finite`, `out-of-range`
   */
  nearest(q, k) {
    return this.#handle.callWith(
      () => [argument.configuration(q, this.#dimension, "q"), argument.count(k, "k")],
      (raw, at, count) => foundIn(raw.nearest(at, count)));
  }

  /**
   * The configurations no farther from `q` than `radius`, in the unit of the metric; of a forest those among its candidates.
   * @param {Configuration} q
   * @param {number} radius  finite, 0 or more
   * @returns {NeighboursFound}
   * @throws {PlanariumError} `wrong-dimension`, `not-finite`, `out-of-range`
   */
  within(q, radius) {
    return this.#handle.callWith(
      () => [argument.configuration(q, this.#dimension, "q"), argument.finite(radius, "/radius")],
      (raw, at, within) => foundIn(raw.within(at, within)));
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

/** An answer of the core: visited, and number and distance of each neighbour. @param {Float64Array} told @returns {NeighboursFound} */
function foundIn(told) {
  const count = (told.length - 1) / 2;
  const [indices, distances] = [new Uint32Array(count), new Float64Array(count)];
  for (let i = 0; i < count; i += 1) {
    indices[i] = told[1 + 2 * i];
    distances[i] = told[2 + 2 * i];
  }
  return { indices, distances, visited: told[0] };
}
