/** A list of configurations from a file: a JSON array of arrays of numbers, or a NumPy array with a row for each. */
import { isArray } from "../app/read-files.js";
import { readNpy } from "../formats/npy.js";

/** Configurations at most. */
const MOST = 100_000;

/**
 * @param {string} name @param {Uint8Array} bytes @param {number} dimension  numbers in a configuration
 * @returns {Float64Array} one after the other
 * @throws {Error} with `code` and `pointer`
 */
export function readList(name, bytes, dimension) {
  return isArray(name, bytes) ? readArray(bytes, dimension) : readJson(bytes, dimension);
}

/** @param {string} code @param {string} sentence @param {string} [pointer] @returns {never} */
function refuse(code, sentence, pointer = "") {
  throw Object.assign(new Error(sentence), { code, pointer });
}

/** @param {number} count */
function checkCount(count) {
  if (count > MOST) refuse("too-large", `The list has ${count} configurations; the limit is ${MOST}.`);
  if (count === 0) refuse("out-of-range", "The list has no configuration.");
}

/** @param {Uint8Array} bytes @param {number} dimension */
function readArray(bytes, dimension) {
  const { shape, data } = readNpy(bytes);
  if (shape.length !== 2)
    refuse(
      "wrong-dimension",
      `The array must have two dimensions, rows and columns; its shape is (${shape.join(", ")}).`,
    );
  if (shape[1] !== dimension)
    refuse(
      "wrong-dimension",
      `A configuration of this robot has ${dimension} numbers; the rows of this array have ${shape[1]}.`,
    );
  checkCount(shape[0]);
  return data;
}

/** @param {Uint8Array} bytes @param {number} dimension */
function readJson(bytes, dimension) {
  /** @type {unknown} */
  let value;
  try {
    value = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
  } catch (error) {
    return refuse(
      "invalid-json",
      `The file is neither JSON nor a NumPy array: ${error instanceof Error ? error.message : String(error)}.`,
    );
  }
  if (!Array.isArray(value))
    return refuse("wrong-type", "A list of configurations must be an array of arrays of numbers.");
  checkCount(value.length);
  return Float64Array.from(
    value.flatMap((row, i) => {
      if (!Array.isArray(row)) refuse("wrong-type", `Configuration ${i} must be an array of numbers.`, `/rows/${i}`);
      if (row.length !== dimension)
        refuse(
          "wrong-dimension",
          `A configuration of this robot has ${dimension} numbers; configuration ${i} has ${row.length}.`,
          `/rows/${i}`,
        );
      const j = row.findIndex((/** @type {unknown} */ number) => typeof number !== "number");
      if (j >= 0) refuse("wrong-type", `Number ${j} of configuration ${i} is not a number.`, `/rows/${i}/${j}`);
      return row;
    }),
  );
}
