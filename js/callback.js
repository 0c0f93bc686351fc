/** Functions of the caller's that the core calls while it plans. */
import * as glue from "./planarium_glue.js";
import { PlanariumError } from "./error.js";
import { requireCore } from "./runtime.js";

/** What such a function has thrown: it goes through the core and comes out as it is. */
export class Thrown {
  /** @param {unknown} value */
  constructor(value) {
    this.value = value;
  }
}

/**
 * Calls under way at most, each from a function that the one before it has called: in every engine a few hundred fill
 * the stack.
 */
const DEEPEST = 32;

/** Objects whose methods are under way, the innermost last. @type {unknown[]} */
const entered = [];
/** Whether each of them waits for a function to return. @type {boolean[]} */
const waits = [];

/** Calls a method, and notes for how long. @template T @param {unknown} self @param {() => T} call @returns {T} */
export function during(self, call) {
  entered.push(self);
  try {
    return call();
  } finally {
    entered.pop();
  }
}

/** Whether a call is under way, so that what runs is a function that it has called. */
export function isWithinCall() {
  return entered.length > 0;
}

/** Refuses a call within too many others. */
export function refuseDepth() {
  if (entered.length < DEEPEST) return;
  throw new PlanariumError(
    "too-deep",
    `A function of a problem may call Planarium, whose call may call a function again, and so on ${DEEPEST} deep; this call is deeper.`,
  );
}

/** Refuses an object in the middle of a call. @param {unknown} self @param {string} name */
export function refuseWaiting(self, name) {
  if (!entered.some((one, i) => one === self && waits[i])) return;
  throw new PlanariumError("in-use", `This ${name} waits for the function that is running, which cannot use it.`);
}

/**
 * The functions of a problem, to be called by the core. Reading them may run the caller's own code; what it throws is
 * left to the copy of the description.
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

/**
 * How a batch has ended: evaluated; the function has returned something, or moved the arrays away; it has thrown; a
 * result is NaN, or was not written.
 */
const DONE = 0,
  UNSOUND = 1,
  THROWN = 2,
  NO_NUMBER = 3;

/** A function of the caller's, and the arrays that it gets. */
class Batches {
  #given;
  #owner;
  /** What the function has thrown last. @type {Thrown | undefined} */
  #thrown;
  /** The memory of the core, and all of it as numbers: empty after it has grown. @type {WebAssembly.Memory} */
  #memory = glue.initSync({ module: new ArrayBuffer(0) }).memory;
  #numbers = new Float64Array(0);
  /**
   * Rows and results for each number of configurations that has occurred; none while they are in use.
   * @type {([Float64Array, Float64Array] | undefined)[]}
   */
  #arrays = [];

  /** @param {Function} given @param {unknown} owner */
  constructor(given, owner) {
    this.#given = given;
    this.#owner = owner;
  }

  /**
   * Evaluates configurations: the core calls it with the places of rows and results in its memory. Copies, since that
   * may grow meanwhile. Throws nothing while the core is sound: the glue is faster for a function that does not.
   * @param {number} rowsAt  bytes
   * @param {number} resultsAt  bytes
   * @param {number} count
   * @param {number} dimension
   * @returns {number} how it has ended
   */
  evaluate(rowsAt, resultsAt, count, dimension) {
    const top = entered.length - 1;
    waits[top] = true;
    try {
      // The caller may have given the memory of an array away: then it is empty.
      const known = this.#arrays[count];
      /** @type {[Float64Array, Float64Array]} */
      const pair =
        known !== undefined && known[0].length === count * dimension && known[1].length === count
          ? known
          : [new Float64Array(count * dimension), new Float64Array(count)];
      const rows = pair[0],
        results = pair[1];
      this.#arrays[count] = undefined;
      const from = this.#view();
      for (let i = 0, at = rowsAt / 8; i < rows.length; i += 1) rows[i] = from[at + i];
      for (let i = 0; i < count; i += 1) results[i] = NaN;
      const returned = this.#given.call(this.#owner, rows, results);
      requireCore();
      if (
        (typeof returned === "object" && returned !== null) ||
        typeof returned === "function" ||
        results.length !== count
      )
        return UNSOUND;
      const to = this.#view();
      let end = DONE;
      for (let i = 0, at = resultsAt / 8; i < count; i += 1) {
        const result = results[i];
        if (result !== result) end = NO_NUMBER;
        to[at + i] = result;
      }
      this.#arrays[count] = pair;
      return end;
    } catch (error) {
      // If a call within the function has lost the core, nothing goes on in it: this leaves all calls under way.
      requireCore();
      this.#thrown = new Thrown(error);
      return THROWN;
    } finally {
      waits[top] = false;
    }
  }

  /** What the function has thrown last. */
  get thrown() {
    return this.#thrown;
  }

  #view() {
    if (this.#numbers.length === 0) this.#numbers = new Float64Array(this.#memory.buffer);
    return this.#numbers;
  }
}
