/**
 * Copies of what callers hand over. Reading an argument may run the caller's own code (getters, proxies, `toJSON`), so it is read once,
 * before the core is entered. The core checks the copies.
 */
import { reasonOf } from "./error.js";

/** The most items that are read from an array. */
const LONGEST = 10_000_000;

/**
 * A copy of an argument that is an object: a `Float64Array` for numbers, plain values for objects. If the argument cannot be read, an `Error` that says
 * why, which the core reports by the name of the argument.
 * @param {object} value
 * @returns {unknown}
 */
export function plain(value) {
  try {
    return copy(value, 0);
  } catch (error) {
    // A `RangeError` is about the length; a caller's own error is not.
    return own.has(/** @type {RangeError} */ (error)) ? error : new TypeError(reasonOf(error), { cause: error });
  }
}

/** Errors of this module: callers may throw any value, also a proxy that throws when it is inspected. @type {WeakSet<object>} */
const own = new WeakSet();

/** @param {number} length */
function tooLong(length) {
  const error = new RangeError(`its length is ${length}; at most ${LONGEST} items are read`);
  own.add(error);
  return error;
}

/** @param {unknown} value @param {number} depth  0 for an argument, 1 for an item of a list, more within objects @returns {unknown} */
function copy(value, depth) {
  switch (typeof value) {
    case "bigint": throw new TypeError("a bigint is no JSON value");
    case "function": case "symbol": return undefined;
    case "object": break;
    default: return value;
  }
  if (value === null) return null;
  if (ArrayBuffer.isView(value) && !(value instanceof DataView)) {
    if (depth === 0 && value instanceof Uint8Array) return new Uint8Array(value);
    const numbers = new Float64Array(/** @type {Float64Array} */ (value));
    return depth < 2 ? numbers : Array.from(numbers);
  }
  if (Array.isArray(value)) return copyOfList(value, depth);
  const object = /** @type {Record<string, unknown>} */ (value);
  const { toJSON } = object;
  if (typeof toJSON === "function") return copy(toJSON.call(value), 2);
  // As in JSON, what has no JSON form is absent.
  return Object.fromEntries(Object.keys(object).map((key) => [key, copy(object[key], 2)]).filter(([, inner]) => inner !== undefined));
}

/** @param {readonly unknown[]} list @param {number} depth */
function copyOfList(list, depth) {
  const { length } = list;
  if (!Number.isInteger(length) || length < 0) throw new TypeError("its length is not a count");
  if (length > LONGEST) throw tooLong(length);
  const items = new Array(length);
  let isOfNumbers = depth < 2;
  for (let i = 0; i < length; i += 1) {
    const item = list[i];
    if (typeof item === "number") {
      items[i] = item;
    } else {
      isOfNumbers = false;
      items[i] = copy(item, depth + 1);
    }
  }
  return isOfNumbers ? new Float64Array(items) : items;
}
