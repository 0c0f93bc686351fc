/// <reference lib="esnext.disposable" preserve="true" />
/** A car under a driver's hand. */
import * as argument from "./arguments.js";
import { PlanariumError } from "./error.js";
import { Handle, key } from "./handle.js";

/** @import { RawDrive } from "./planarium_glue.js" */
/** @import { DriveKey, DriveState, KeyPress, Obstructed } from "./types.js" */

/** The core counts them. @type {readonly DriveKey[]} */
const KEYS = ["faster", "slower", "left", "right", "keep"];

/**
 * Makes the handle of a drive.
 * @param {RawDrive} raw
 * @returns {Drive}
 * @internal
 */
export function makeDrive(raw) {
  // The constructor is private to callers, not to the package.
  const Construct = /** @type {new (secret: symbol, raw: RawDrive) => Drive} */ (/** @type {unknown} */ (Drive));
  return new Construct(key, raw);
}

/**
 * What stopped a car, as the core tells it.
 * @param {number} told
 * @returns {Obstructed | null}
 * @internal
 */
export function obstructed(told) {
  if (told === -3) return null;
  return told === -2 ? "near" : told === -1 ? "bounds" : told;
}

/**
 * A car that starts at rest and is driven by keys. Time goes by in steps of fixed length (`stepSeconds`), as many as `tick` is
 * told, so the same keys at the same steps lead to the same pose, bit for bit, however often pictures are drawn. Each step is an
 * exact arc that is proven free before it is taken; where it is not, the car stands still and says at what.
 */
export class Drive {
  /** @type {Handle<RawDrive>} */
  #handle;

  /**
   * @param {symbol} secret
   * @param {RawDrive} raw
   * @private
   */
  constructor(secret, raw) {
    if (secret !== key) throw new PlanariumError("illegal-constructor", "A Drive comes from scenario.drive(q).");
    this.#handle = new Handle(raw, "Drive");
  }

  /**
   * Presses a key, and records it: `faster` and `slower` change v by 0.1 m/s, `left` and `right` turn the front wheels by
   * pi / 12 to that side, within the limits of the car; `keep` changes nothing.
   * @param {DriveKey} name
   * @returns {void}
   * @throws {PlanariumError} `out-of-range` for another word; `too-large` after a million keys
   */
  press(name) {
    this.#handle.callWith(() => [numberOf(name, "/key")], (raw, number) => raw.press(number));
  }

  /**
   * Lets `n` steps go by. A step that cannot be proven free is not taken: v becomes 0, and `blocked` says why.
   * @param {number} n  an integer from 0 to 1,000,000
   * @returns {DriveState}
   * @throws {PlanariumError} `out-of-range`; `too-large` after a million steps in motion: begin another drive
   */
  tick(n) {
    return this.#handle.callWith(() => [argument.count(n, "n")], (raw, count) => {
      raw.tick(count);
      return stateOf(raw);
    });
  }

  /** Where the car is, what it does, and what stopped it. @returns {DriveState} */
  get state() {
    return this.#handle.call(stateOf);
  }

  /** The length of a step, in seconds: the `integration_step` of the scenario's car. @returns {number} */
  get stepSeconds() {
    return this.#handle.call((raw) => raw.step());
  }

  /**
   * Where the car has been, from a row on: the start, and the pose after each step that moved it. A fresh copy, yours to keep.
   * @param {number} row  an integer from 0 to `state.traceCount`
   * @returns {Float64Array} rows of x, y, theta
   */
  traceSince(row) {
    return this.#handle.call((raw) => raw.trace_since(argument.count(row, "row")));
  }

  /** The keys pressed so far: what `replay` takes. @returns {KeyPress[]} */
  record() {
    const numbers = this.#handle.call((raw) => raw.record());
    return Array.from({ length: numbers.length / 2 }, (_, i) => ({ step: numbers[2 * i], key: KEYS[numbers[2 * i + 1]] }));
  }

  /**
   * Begins anew at the start and drives as recorded until `steps` have gone by: the same bits again. Presses after that are
   * not made.
   * @param {readonly KeyPress[]} record  in the order of their steps
   * @param {number} steps
   * @returns {DriveState}
   * @throws {PlanariumError} `wrong-type`, `out-of-range` with a pointer below `/record`, or of `steps`
   */
  replay(record, steps) {
    return this.#handle.callWith(() => [rowsOf(record), argument.count(steps, "steps")], (raw, rows, count) => {
      raw.replay(rows, count);
      return stateOf(raw);
    });
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

/** @param {RawDrive} raw @returns {DriveState} */
function stateOf(raw) {
  const [x, y, theta, v, phi, steps, told, traceCount, keyCount] = raw.state();
  return { pose: [x, y, theta], v, phi, steps, seconds: steps * raw.step(), blocked: obstructed(told), traceCount, keyCount };
}

/** @param {unknown} name @param {string} pointer */
function numberOf(name, pointer) {
  const number = KEYS.findIndex((known) => known === argument.text(name, pointer.slice(1)));
  if (number < 0) throw new PlanariumError("out-of-range", `A key is one of ${KEYS.join(", ")}.`, pointer);
  return number;
}

/** A record as rows of numbers. @param {unknown} given */
function rowsOf(given) {
  // By way of JSON, so that nothing of the caller's own runs while it is read.
  const { record } = /** @type {{ record?: ({ step?: unknown, key?: unknown } | null)[] }} */ (argument.options({ record: given }));
  if (!Array.isArray(record)) throw new PlanariumError("wrong-type", "`record` must be an array of { step, key }.", "/record");
  const rows = new Float64Array(2 * record.length);
  record.forEach((press, i) => {
    rows[2 * i] = argument.count(press?.step, `record/${i}/step`);
    rows[2 * i + 1] = numberOf(press?.key, `/record/${i}/key`);
  });
  return rows;
}
