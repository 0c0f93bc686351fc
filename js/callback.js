/** Functions of the caller's that the core calls while it plans. */
import * as glue from "./planarium_glue.js";
import { PlanariumError } from "./error.js";

/** What such a function has thrown: it goes through the core and comes out as it is. */
export class Thrown {
  /** @param {unknown} value */
  constructor(value) {
    this.value = value;
  }
}

/** Objects whose methods are under way, the innermost last. @type {unknown[]} */
const entered = [];
/** Those that wait for a function to return. @type {Set<unknown>} */
const waiting = new Set();

/** Calls a method, and notes for how long. @template T @param {unknown} self @param {() => T} call @returns {T} */
export function during(self, call) {
  entered.push(self);
  try {
    return call();
  } finally {
    entered.pop();
  }
}

/** Refuses an object in the middle of a call. @param {unknown} self @param {string} name */
export function refuseWaiting(self, name) {
  if (!waiting.has(self)) return;
  throw new PlanariumError("in-use", `This ${name} waits for the function that is running, which cannot use it.`);
}

/**
 * The functions of a problem, to be called by the core. Reading them may run the caller's own code; what it throws is left to the copy of the
 * description.
 * @param {unknown} description
 * @returns {Record<string, Batches>}
 */
export function functionsOf(description) {
  /** @type {Record<string, Batches>} */
  const functions = {};
  for (const name of ["clearance", "isFree"]) {
    try {
      const given = Reflect.get(Object(description), name);
      if (typeof given === "function") functions[name] = new Batches(given, description);
    } catch {
      return {};
    }
  }
  return functions;
}

/** A function of the caller's, and the arrays that it gets. */
class Batches {
  #given;
  #owner;
  /** The memory of the core, and all of it as numbers: empty after it has grown. @type {WebAssembly.Memory} */
  #memory = glue.initSync({ module: new ArrayBuffer(0) }).memory;
  #numbers = new Float64Array(0);
  /** Rows and results for each number of configurations that has occurred; none while they are in use. @type {([Float64Array, Float64Array] | undefined)[]} */
  #arrays = [];

  /** @param {Function} given @param {unknown} owner */
  constructor(given, owner) {
    this.#given = given;
    this.#owner = owner;
  }

  /**
   * Evaluates configurations: the core calls it with the places of rows and results in its memory. Copies, since that may grow meanwhile.
   * @param {number} rowsAt  bytes
   * @param {number} resultsAt  bytes
   * @param {number} count
   * @param {number} dimension
   * @returns {boolean} whether the function has returned nothing, and left the arrays in their place
   */
  evaluate(rowsAt, resultsAt, count, dimension) {
    // The caller may have given the memory of an array away: then it is empty.
    const known = this.#arrays[count];
    const [rows, results] = known?.[0].length === count * dimension && known[1].length === count
      ? known : [new Float64Array(count * dimension), new Float64Array(count)];
    this.#arrays[count] = undefined;
    const from = this.#view();
    for (let i = 0, at = rowsAt / 8; i < rows.length; i += 1) rows[i] = from[at + i];
    results.fill(NaN);
    const returned = this.#call(rows, results);
    if ((typeof returned === "object" && returned !== null) || typeof returned === "function" || results.length !== count) return false;
    const to = this.#view();
    for (let i = 0, at = resultsAt / 8; i < count; i += 1) to[at + i] = results[i];
    this.#arrays[count] = [rows, results];
    return true;
  }

  #view() {
    if (this.#numbers.length === 0) this.#numbers = new Float64Array(this.#memory.buffer);
    return this.#numbers;
  }

  /** @param {Float64Array} rows @param {Float64Array} results */
  #call(rows, results) {
    const self = entered.at(-1);
    const isFirst = !waiting.has(self);
    waiting.add(self);
    try {
      return this.#given.call(this.#owner, rows, results);
    } catch (error) {
      throw new Thrown(error);
    } finally {
      if (isFirst) waiting.delete(self);
    }
  }
}
