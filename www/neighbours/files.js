/** A list of configurations from a file: JSON, an array of arrays of numbers, or an array of NumPy's with a row for each. */
import { isArray } from "../app/drop.js";
import { readNpy } from "../formats/npy.js";

/** The most configurations of a file. */
const MOST = 100_000;

/**
 * @param {string} name @param {Uint8Array} bytes @param {number} dimension  numbers in a configuration
 * @returns {Float64Array} one after the other
 * @throws {Error} with `code`: what is wrong with it
 */
export function rowsOf(name, bytes, dimension) {
  return isArray(name, bytes) ? ofNpy(bytes, dimension) : ofJson(bytes, dimension);
}

/** @param {string} code @param {string} sentence @param {string} [pointer] @returns {never} */
function refuse(code, sentence, pointer = "") { throw Object.assign(new Error(sentence), { code, pointer }); }

/** @param {number} count */
function mustFit(count) {
  if (count > MOST) refuse("too-large", `There are ${count} configurations; at most ${MOST} are read.`);
  if (count === 0) refuse("out-of-range", "There is no configuration in it.");
}

/** @param {Uint8Array} bytes @param {number} dimension */
function ofNpy(bytes, dimension) {
  const { shape, data } = readNpy(bytes);
  if (shape.length !== 2) refuse("wrong-dimension", `An array of configurations has two dimensions, rows and columns; this one has the shape (${shape.join(", ")}).`);
  if (shape[1] !== dimension) refuse("wrong-dimension", `A configuration of this robot has ${dimension} numbers; the rows of this array have ${shape[1]}.`);
  mustFit(shape[0]);
  return data;
}

/** @param {Uint8Array} bytes @param {number} dimension */
function ofJson(bytes, dimension) {
  /** @type {unknown} */
  let value;
  try {
    value = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
  } catch (error) {
    return refuse("invalid-json", `It is neither JSON nor an array of NumPy's: ${error instanceof Error ? error.message : String(error)}.`);
  }
  if (!Array.isArray(value)) return refuse("wrong-type", "A list of configurations is an array of arrays of numbers.");
  mustFit(value.length);
  const rows = new Float64Array(value.length * dimension);
  value.forEach((row, i) => {
    if (!Array.isArray(row)) refuse("wrong-type", `Configuration ${i} must be an array of numbers.`, `/rows/${i}`);
    if (row.length !== dimension) refuse("wrong-dimension", `A configuration of this robot has ${dimension} numbers; configuration ${i} has ${row.length}.`, `/rows/${i}`);
    row.forEach((/** @type {unknown} */ number, /** @type {number} */ j) => {
      if (typeof number !== "number") refuse("wrong-type", `Number ${j} of configuration ${i} is not a number.`, `/rows/${i}/${j}`);
      rows[i * dimension + j] = /** @type {number} */ (number);
    });
  });
  return rows;
}
