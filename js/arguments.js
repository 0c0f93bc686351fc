/**
 * What callers hand over, made safe before it reaches the core: right type, right length, finite.
 * Each function returns a fresh value, so nothing a caller holds is ever shared with the core.
 */
import { PlanariumError, isOwn, reasonOf } from "./error.js";

/** Longest scenario text that is read, in characters. */
const LONGEST_TEXT = 32 * 1024 * 1024;

/** Rows handed over to the core at once. */
const ROWS_AT_ONCE = 16384;

/** Most configurations that are read as an array of arrays. */
const MOST_ROWS = 1_000_000;

/** Longest roadmap that is read, in bytes or characters. */
const LONGEST_FILE = 256 * 1024 * 1024;

/**
 * A count: an integer from 0 to 2^53 - 1.
 * @param {unknown} value
 * @param {string} name  of the argument, for the message and the pointer
 * @returns {number}
 */
export function count(value, name) {
  const number = finite(value, `/${name}`);
  if (!Number.isSafeInteger(number) || number < 0) {
    throw new PlanariumError("out-of-range", `\`${name}\` must be an integer from 0 to 2^53 - 1, not ${number}.`, `/${name}`);
  }
  return number;
}

/**
 * A finite number.
 * @param {unknown} value
 * @param {string} pointer
 * @returns {number}
 */
export function finite(value, pointer) {
  if (typeof value !== "number") {
    throw new PlanariumError("wrong-type", `A number is wanted at ${pointer}, not ${show(value)}.`, pointer);
  }
  if (!Number.isFinite(value)) {
    throw new PlanariumError("not-finite", `The number at ${pointer} must be finite, not ${value}.`, pointer);
  }
  return value;
}

/**
 * One configuration: an array of `dimension` finite numbers.
 * @param {unknown} value
 * @param {number} dimension
 * @param {string} name
 * @returns {Float64Array}
 */
export function configuration(value, dimension, name) {
  return numbers(value, name, (length) => {
    if (length === dimension) return;
    const wanted = `${dimension} ${dimension === 1 ? "number" : "numbers"}, one per degree of freedom`;
    throw new PlanariumError("wrong-dimension", `\`${name}\` must have ${wanted}, not ${length}.`, `/${name}`);
  });
}

/**
 * A point: two finite numbers.
 * @param {unknown} value
 * @param {string} name
 * @returns {Float64Array}
 */
export function point(value, name) {
  return numbers(value, name, (length) => {
    if (length === 2) return;
    throw new PlanariumError("wrong-dimension", `\`${name}\` must have two numbers, x and y, not ${length}.`, `/${name}`);
  });
}

/**
 * Rows of `dimension` finite numbers, one after the other.
 * @param {unknown} value
 * @param {number} dimension
 * @param {string} name
 * @param {(index: number) => number | string} [place]  how the pointer to a number goes on
 * @returns {Float64Array}
 */
export function rows(value, dimension, name, place) {
  return numbers(value, name, (length) => {
    if (length % dimension === 0) return;
    const sentence = `\`${name}\` must have whole rows of ${dimension} numbers; ${length} numbers are not.`;
    throw new PlanariumError("wrong-dimension", sentence, `/${name}`);
  }, place);
}

/**
 * Configurations, one after the other in one array of numbers, or an array of arrays of them; pointers name row and number.
 * @param {unknown} value
 * @param {number} dimension
 * @param {string} name
 * @returns {Float64Array}
 */
export function matrix(value, dimension, name) {
  return guarded(name, () => {
    if (!Array.isArray(value) || !(value[0] instanceof Object)) {
      return rows(value, dimension, name, (i) => `${Math.floor(i / dimension)}/${i % dimension}`);
    }
    const count = value.length;
    if (count > MOST_ROWS) {
      throw new PlanariumError("too-large", `\`${name}\` has ${count} rows; ${MOST_ROWS} are read at most.`, `/${name}`);
    }
    const copy = new Float64Array(count * dimension);
    for (let row = 0; row < count; row += 1) copy.set(configuration(value[row], dimension, `${name}/${row}`), row * dimension);
    return copy;
  });
}

/**
 * A truth value.
 * @param {unknown} value
 * @param {string} name
 * @returns {boolean}
 */
export function truth(value, name) {
  if (typeof value !== "boolean") {
    throw new PlanariumError("wrong-type", `\`${name}\` must be true or false, not ${show(value)}.`, `/${name}`);
  }
  return value;
}

/**
 * Hands over rows a block at a time, so that a long list does not make the core's memory grow.
 * @param {Float64Array} rows
 * @param {number} width  numbers in a row
 * @param {(block: Float64Array, row: number) => void} use  a block and the number of its first row
 */
export function blocks(rows, width, use) {
  for (let row = 0; row * width < rows.length; row += ROWS_AT_ONCE) {
    use(rows.subarray(row * width, (row + ROWS_AT_ONCE) * width), row);
  }
}

/**
 * A short string, a name.
 * @param {unknown} value
 * @param {string} name
 * @returns {string}
 */
export function text(value, name) {
  if (typeof value !== "string") {
    throw new PlanariumError("wrong-type", `\`${name}\` must be a string, not ${show(value)}.`, `/${name}`);
  }
  return value;
}

/**
 * A document as JSON text: as it is, or written from an object.
 * @param {unknown} value
 * @returns {string}
 */
export function documentText(value) {
  const written = typeof value === "string" ? value : json(value);
  if (written.length > LONGEST_TEXT) {
    throw new PlanariumError("too-large", `A scenario of ${written.length} characters is too large; ${LONGEST_TEXT} are read at most.`);
  }
  return written;
}

/**
 * Text or bytes, as bytes.
 * @param {unknown} value
 * @param {string} name
 * @returns {Uint8Array}
 */
export function textOrBytes(value, name) {
  return guarded(name, () => {
    if (typeof value !== "string" && !(value instanceof Uint8Array)) {
      throw new PlanariumError("wrong-type", `\`${name}\` must be a string or a Uint8Array, not ${show(value)}.`, `/${name}`);
    }
    if (value.length > LONGEST_FILE) {
      throw new PlanariumError("too-large", `\`${name}\` is ${value.length} long; ${LONGEST_FILE} are read at most.`, `/${name}`);
    }
    // A detached array cannot be copied, which throws.
    return typeof value === "string" ? new TextEncoder().encode(value) : new Uint8Array(value);
  });
}

/**
 * Options: a plain copy of an object of JSON values, so that nothing of the caller's own runs while the core reads it; nothing at
 * all means none.
 * @param {unknown} value
 * @returns {Record<string, unknown>}
 */
export function options(value) {
  if (value === undefined) return {};
  const written = json(value);
  if (!written.startsWith("{")) {
    throw new PlanariumError("wrong-type", `Options are an object, not ${show(value)}.`);
  }
  return JSON.parse(written);
}

/**
 * A value as JSON text. JSON has no word for NaN and infinity, so they are refused by name instead of turning into null.
 * Fields that are `undefined` count as absent, as everywhere in JSON.
 * @param {unknown} value
 * @returns {string}
 */
function json(value) {
  let written;
  try {
    written = JSON.stringify(value);
    // Every number that is not finite has become a null; look for them only where there is one.
    if (written?.includes("null")) refuseNonFinite(value, "");
  } catch (error) {
    if (isOwn(error)) throw error;
    throw new PlanariumError("invalid-json", `This object cannot be written as JSON: ${reasonOf(error)}`, "", { cause: error });
  }
  if (written === undefined) {
    throw new PlanariumError("wrong-type", `An object is wanted, not ${show(value)}.`);
  }
  return written;
}

/**
 * @param {unknown} value
 * @param {string} pointer
 */
function refuseNonFinite(value, pointer) {
  if (typeof value === "number") finite(value, pointer);
  if (typeof value !== "object" || value === null) return;
  for (const [key, inner] of Object.entries(value)) {
    refuseNonFinite(inner, `${pointer}/${key.replaceAll("~", "~0").replaceAll("/", "~1")}`);
  }
}

/**
 * A copy of an array of finite numbers.
 * @param {unknown} value
 * @param {string} name
 * @param {(length: number) => void} checkLength  throws before anything is read
 * @param {(index: number) => number | string} [place]  how the pointer to a number goes on
 * @returns {Float64Array}
 */
function numbers(value, name, checkLength, place = (i) => i) {
  return guarded(name, () => {
    const isList = Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
    if (!isList) {
      throw new PlanariumError("wrong-type", `\`${name}\` must be an array of numbers, not ${show(value)}.`, `/${name}`);
    }
    const list = /** @type {ArrayLike<unknown>} */ (/** @type {unknown} */ (value));
    const { length } = list;
    checkLength(length);
    const copy = new Float64Array(length);
    for (let i = 0; i < copy.length; i += 1) {
      const number = list[i];
      // The pointer costs more than the number: it is made where it is needed.
      copy[i] = typeof number === "number" && Number.isFinite(number) ? number : finite(number, `/${name}/${place(i)}`);
    }
    return copy;
  });
}

/**
 * Reads what a caller holds. Whatever the caller's own getters and proxies throw is wrapped.
 * @template T
 * @param {string} name
 * @param {() => T} read
 * @returns {T}
 */
function guarded(name, read) {
  try {
    return read();
  } catch (error) {
    if (isOwn(error)) throw error;
    throw new PlanariumError("wrong-type", `\`${name}\` cannot be read: ${reasonOf(error)}`, `/${name}`, { cause: error });
  }
}

/** A value for a message: short, and never by way of the caller's own code. @param {unknown} value */
function show(value) {
  if (typeof value === "string") return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}...` : value);
  if (typeof value === "function") return "a function";
  if (typeof value === "object" && value !== null) return "an object";
  return typeof value === "bigint" ? `${value}n` : String(value);
}
