/**
 * Copies of what callers hand over. Reading an argument may run the caller's own code (getters, proxies, `toJSON`), so
 * it is read once, before the core is entered. The core checks the copies.
 */
import { PlanariumError, isOwn, reasonOf } from "./error.js";
import { classOf } from "./handle.js";

/** The most items that are read from an array. */
const LONGEST = 10_000_000;

/**
 * A copy of an argument that is an object: a `Float64Array` for numbers, plain values for objects. As in JSON, a field
 * that is undefined is absent, and an object with a `toJSON` counts as what that returns; a function, a symbol, and an
 * object that keeps its content to itself (a `Map`, a `Promise`) are refused. If the argument cannot be copied, an
 * `Error` that says why, which the core reports by the name of the argument; its `pointer` says where, unless the
 * caller's own code has thrown.
 * @param {object} value
 * @param {readonly string[]} [functions]  fields of the argument that may be functions, and are left out
 * @returns {unknown}
 */
export function plain(value, functions = []) {
  try {
    return copy(value, 0, functions);
  } catch (error) {
    // A `RangeError` is about the length; a caller's own error is not.
    return own.has(/** @type {Refusal} */ (error)) ? error : new TypeError(reasonOf(error), { cause: error });
  }
}

/**
 * The fields of an object of options that is read in JavaScript alone; none if it is undefined or null.
 * @param {unknown} options
 * @param {string} name  of the argument
 * @param {string} known  the options, with commas between
 * @returns {Record<string, unknown>}
 * @throws {PlanariumError} `wrong-type`, `unknown-field`
 */
export function fieldsOf(options, name, known) {
  const wanted = `${name} must be an object with the fields ${known}`;
  if (options instanceof Error)
    throw new PlanariumError(
      "wrong-type",
      `${wanted}: ${options.message}`,
      String(Reflect.get(options, "pointer") ?? ""),
      { cause: options.cause },
    );
  const given = options ?? {};
  if (typeof given !== "object" || (Object.keys(given).length === 0 && !isEmpty(given)))
    throw new PlanariumError("wrong-type", `${wanted}, not ${kindOf(given)}`);
  const unknown = Object.keys(given).find((field) => !known.split(", ").includes(field));
  if (unknown !== undefined)
    throw new PlanariumError(
      "unknown-field",
      `unknown option ${JSON.stringify(unknown)}; known options are ${known}`,
      `/${unknown}`,
    );
  return /** @type {Record<string, unknown>} */ (given);
}

/**
 * What is read of an argument, of which the caller's own code may throw.
 * @template T
 * @param {string} what  the argument in words
 * @param {string} pointer  of the argument
 * @param {() => T} read
 * @returns {T}
 * @throws {PlanariumError} `wrong-type`, and what `read` throws
 */
export function readable(what, pointer, read) {
  try {
    return read();
  } catch (error) {
    if (isOwn(error)) throw error;
    throw new PlanariumError("wrong-type", `${what} cannot be read: ${reasonOf(error)}`, pointer, { cause: error });
  }
}

/** A time of slices in milliseconds. @param {unknown} budget @returns {number} @throws {PlanariumError} */
export function budgetOf(budget) {
  const [code, wanted] =
    typeof budget !== "number"
      ? ["wrong-type", "a number"]
      : !Number.isFinite(budget)
        ? ["not-finite", "finite"]
        : ["out-of-range", "at least 0"];
  if (typeof budget === "number" && budget >= 0 && budget < Infinity) return budget;
  throw new PlanariumError(
    code,
    `budget must be ${wanted}, not ${typeof budget === "number" ? budget : kindOf(budget)}`,
    "/budget",
  );
}

/** A copy that can be sent to a worker. @param {unknown} value @param {string} name @throws {PlanariumError} `wrong-type` */
export function copyOf(value, name) {
  const copy = typeof value === "object" && value !== null ? plain(value) : value;
  if (copy instanceof Error)
    throw new PlanariumError(
      "wrong-type",
      `the ${name} cannot be read: ${copy.message}`,
      String(Reflect.get(copy, "pointer") ?? ""),
      { cause: copy.cause },
    );
  if (typeof copy === "function" || typeof copy === "symbol")
    throw new PlanariumError("wrong-type", `the ${name} is a ${typeof copy}`);
  return copy;
}

/**
 * Why a value is refused, where it stands, and its kind if it has no JSON form.
 * @typedef {Error & { pointer: string, kind?: string }} Refusal
 */

/**
 * Errors of this module: callers may throw any value, also a proxy that throws when it is inspected.
 * @type {WeakSet<Refusal>}
 */
const own = new WeakSet();

/** @param {Error} error @param {string} [kind] @returns {Refusal} */
function refusal(error, kind) {
  const refused = Object.assign(error, { pointer: "", kind });
  own.add(refused);
  return refused;
}

/** @param {unknown} value */
const noValue = (value) => refusal(new TypeError(`${kindOf(value)} is no JSON value`), kindOf(value));

/** @param {number} length */
const tooLong = (length) => refusal(new RangeError(`its length is ${length}; at most ${LONGEST} items are read`));

/** The kind of a value in words: `a function`, `a Map`, `the text "prm"`. @param {unknown} value */
export function kindOf(value) {
  if (value === undefined || value === null) return String(value);
  if (typeof value === "string") return `the text ${JSON.stringify(value.slice(0, 60))}`;
  if (typeof value !== "object") return typeof value === "number" ? `the number ${value}` : `a ${typeof value}`;
  const tag = Object.prototype.toString.call(value).slice(8, -1);
  const name = tag === "Object" ? String(value.constructor?.name || tag) : tag;
  return `${/^[AEIO]/.test(name) ? "an" : "a"} ${name}`;
}

/** Whether an object without fields has no content: `{}`, from whatever realm. @param {object} value */
function isEmpty(value) {
  const prototype = Object.getPrototypeOf(value);
  return (
    Object.prototype.toString.call(value) === "[object Object]" &&
    (prototype === null || Object.getPrototypeOf(prototype) === null)
  );
}

/**
 * @param {unknown} value
 * @param {number} depth  0 for an argument, 1 for an item of a list, more within objects
 * @param {readonly string[]} [functions]
 * @returns {unknown}
 */
function copy(value, depth, functions) {
  switch (typeof value) {
    case "bigint":
    case "function":
    case "symbol":
      throw noValue(value);
    case "object":
      break;
    default:
      return value;
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
  const keys = Object.keys(object);
  if (classOf(object) !== undefined || (keys.length === 0 && !isEmpty(object))) throw noValue(value);
  /** @type {[string, unknown][]} */
  const fields = [];
  for (const key of keys) {
    const inner = object[key];
    if (inner === undefined || (typeof inner === "function" && functions?.includes(key))) continue;
    fields.push([key, copyOfPart(key, inner, 2)]);
  }
  return Object.fromEntries(fields);
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
      items[i] = copyOfPart(i, item, depth + 1);
    }
  }
  return isOfNumbers ? new Float64Array(items) : items;
}

/** A key as a token of a JSON pointer. @param {string | number} key */
export function token(key) {
  return String(key).replaceAll("~", "~0").replaceAll("/", "~1");
}

/**
 * A copy of a field or an item; a refusal gets its place.
 * @param {string | number} key
 * @param {unknown} value
 * @param {number} depth
 */
function copyOfPart(key, value, depth) {
  try {
    return copy(value, depth);
  } catch (error) {
    const refused = /** @type {Refusal} */ (error);
    if (own.has(refused)) refused.pointer = `/${token(key)}${refused.pointer}`;
    throw error;
  }
}
