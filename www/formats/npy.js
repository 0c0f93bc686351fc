/**
 * NumPy array files, `.npy`: a magic string, a header (a literal of a Python dictionary), and the numbers. Versions
 * 1.0, 2.0 and 3.0 are read, 1.0 is written. Polygons may also be an array of objects, which NumPy pickles; `pickle.js`
 * reads it without running code.
 */
import { countOf, MOST_VERTICES, must, NdArray } from "./dtype.js";
import { readPickle } from "./pickle.js";

const MOST_BYTES = 10 * 2 ** 20;
const MAGIC = "\x93NUMPY";

/**
 * Reads real numbers: f4, f8, i1 to i8, u1 to u8 and b1 (as 0 and 1), of either byte order, in C or Fortran order.
 * NaN and infinities are returned.
 * @param {Uint8Array} bytes  at most 10 MB
 * @returns {{ shape: number[], data: Float64Array }}  in C order: the last index runs fastest
 * @throws {NpyError} code `invalid-npy`
 */
export function readNpy(bytes) {
  const array = open(bytes);
  return { shape: array.shape, data: array.numbers() };
}

/**
 * Reads polygons: numbers of shape (n, m, 2) or (m, 2), or an array of objects that are arrays or lists of vertices.
 * @param {Uint8Array} bytes  at most 10 MB and 5000 vertices
 * @returns {number[][][]}  for each polygon its vertices [x, y], at least three
 * @throws {NpyError} code `invalid-npy`
 */
export function readNpyPolygons(bytes) {
  const array = open(bytes);
  let vertices = 0;
  /** @param {unknown} value */
  const values = (value) => (value instanceof NdArray ? value.lists() : value);
  /** @param {unknown} value @param {number} least @param {number} most @param {string} sentence @returns {unknown[]} */
  const list = (value, least, most, sentence) => {
    const items = values(value);
    must(Array.isArray(items) && items.length >= least && items.length <= most, sentence);
    return items;
  };
  const all = list(
    array.type === "|O" ? readPickle(/** @type {Uint8Array} */ (array.bytes)) : array,
    1,
    MOST_VERTICES,
    "There is no list of polygons.",
  );
  const isOne = typeof values(list(all[0], 1, MOST_VERTICES, "There is no list of vertices.")[0]) === "number";
  return (isOne ? [all] : all).map((entry, p) => {
    const polygon = list(entry, 3, MOST_VERTICES, `Polygon ${p} must be three vertices or more.`);
    vertices += polygon.length;
    must(vertices <= MOST_VERTICES, "There are more than 5000 vertices.");
    return polygon.map((vertex, v) => {
      const sentence = `Vertex ${v} of polygon ${p} must be two finite numbers.`;
      return list(vertex, 2, 2, sentence).map((coordinate) => {
        const number = values(coordinate);
        must(typeof number === "number" && Number.isFinite(number), sentence);
        return number;
      });
    });
  });
}

/**
 * @param {Float64Array} data  in C order
 * @param {readonly number[]} shape
 * @returns {Uint8Array<ArrayBuffer>}  a file of version 1.0 with type `<f8`
 */
export function writeNpy(data, shape) {
  if (countOf(shape) !== data.length) throw new RangeError(`Shape (${shape}) does not have ${data.length} numbers.`);
  const literal = `{'descr': '<f8', 'fortran_order': False, 'shape': (${shape.join(", ")}${shape.length === 1 ? "," : ""}), }`;
  const start = Math.ceil((literal.length + 11) / 64) * 64;
  const head = `${MAGIC}\x01\0${String.fromCharCode((start - 10) & 255, (start - 10) >> 8)}${literal}`.padEnd(
    start - 1,
  );
  const bytes = new Uint8Array(start + 8 * data.length);
  bytes.set(Array.from(`${head}\n`, (c) => c.charCodeAt(0)));
  const view = new DataView(bytes.buffer, start);
  data.forEach((value, i) => view.setFloat64(8 * i, value, true));
  return bytes;
}

/** @param {Uint8Array} bytes */
function open(bytes) {
  must(bytes.length <= MOST_BYTES, "The file has more than 10 MB.");
  const version = bytes[6];
  must(
    version > 0 && version < 4 && [...MAGIC].every((c, i) => c.charCodeAt(0) === bytes[i]),
    "The file is not a NumPy array.",
  );
  const start = version > 1 ? 12 : 10;
  const end = start + bytes.subarray(8, start).reduceRight((value, byte) => 256 * value + byte, 0);
  const header = new TextDecoder().decode(bytes.subarray(start, Math.min(end, start + 10000)));
  /** @param {string} key @param {string} form */
  const entry = (key, form) => new RegExp(`['"]${key}['"]\\s*:\\s*${form}`).exec(header)?.[1];
  const type = entry("descr", `['"]([^'"]+)['"]`);
  const fortran = entry("fortran_order", "(True|False)");
  const shape = entry("shape", "\\(([\\dL, ]*)\\)");
  must(type && fortran && shape !== undefined && end <= bytes.length, "The file is not of one plain array.");
  return new NdArray((shape.match(/\d+/g) ?? []).map(Number), type, fortran === "True", bytes.subarray(end));
}
