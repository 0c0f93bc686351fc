/** NumPy arrays as stored in files: bytes with a shape and a type. */

/** Vertices of all polygons of a file, at most. */
export const MOST_VERTICES = 5000;

export class NpyError extends Error {
  code = "invalid-npy";
}

/** @param {unknown} holds @param {string} [sentence] @returns {asserts holds} */
export function must(holds, sentence = "The file is damaged.") {
  if (!holds) throw new NpyError(sentence);
}

/** A value that must be there. @template T @param {T | undefined} value @returns {T} */
export function existing(value) {
  must(value !== undefined);
  return value;
}

/** The number of elements. @param {readonly number[]} shape */
export const countOf = (shape) => shape.reduce((product, n) => product * n, 1);

/** The types, as a `DataView` calls them. */
const NAMES = /** @type {const} */ ({
  b1: "Uint8",
  i1: "Int8",
  i2: "Int16",
  i4: "Int32",
  i8: "BigInt64",
  u1: "Uint8",
  u2: "Uint16",
  u4: "Uint32",
  u8: "BigUint64",
  f4: "Float32",
  f8: "Float64",
});

/** An array in a file; its numbers are read on demand. */
export class NdArray {
  /**
   * @param {number[]} shape
   * @param {string} type      byte order and type, such as `<f8`; `|O` for objects
   * @param {boolean} fortran  the first index runs fastest
   * @param {unknown} bytes    bytes, text of which each character is a byte, or a list of objects in C order
   */
  constructor(shape, type, fortran, bytes) {
    this.shape = shape;
    this.type = type;
    this.fortran = fortran;
    this.bytes = bytes;
  }

  /** The numbers in C order. @returns {Float64Array} */
  numbers() {
    const { shape, type } = this;
    const count = countOf(shape);
    const key = /** @type {keyof typeof NAMES} */ (type.slice(1));
    must(
      Object.hasOwn(NAMES, key) && /[<>]|1$/.test(type),
      `Numbers of type ${type.slice(0, 40)} are not read; use <f8.`,
    );
    const size = Number(key[1]);
    const bytes = typeof this.bytes === "string" ? Uint8Array.from(this.bytes, (c) => c.charCodeAt(0)) : this.bytes;
    must(bytes instanceof Uint8Array && bytes.length === count * size, `Shape (${shape}) needs ${count * size} bytes.`);
    const view = new DataView(bytes.buffer, bytes.byteOffset);
    return Float64Array.from({ length: count }, (_, i) => {
      const value = view[`get${NAMES[key]}`](size * (this.fortran ? this.fortranIndex(i) : i), type[0] === "<");
      const number = Number(value);
      must(typeof value === "number" || Number.isSafeInteger(number), "A whole number is too large.");
      return number;
    });
  }

  /** The place in Fortran order of an element in C order. @param {number} i */
  fortranIndex(i) {
    let stride = countOf(this.shape);
    return this.shape.reduceRight((at, n) => {
      const digit = i % n;
      i = (i - digit) / n;
      return at + digit * (stride /= n);
    }, 0);
  }

  /** The values as nested lists, at most two a vertex; a single one where there is no dimension. @returns {unknown} */
  lists() {
    const { shape, type, bytes } = this;
    const count = countOf(shape);
    must(count <= 2 * MOST_VERTICES, "There are more than 5000 vertices.");
    /** @type {unknown[]} */
    let values = type[1] === "O" && Array.isArray(bytes) ? bytes : [...this.numbers()];
    must(values.length === count);
    for (const n of shape.slice(1).reverse())
      values = Array.from({ length: values.length / n }, (_, i) => values.slice(i * n, i * n + n));
    return shape.length > 0 ? values : values[0];
  }
}
