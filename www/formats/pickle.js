/**
 * Reads what NumPy pickles when it saves an array of objects: arrays, lists, tuples and numbers, in protocols 2 to 5. A
 * pickle is a program for a stack machine that may call any Python function. This machine replaces the few functions
 * that make arrays by its own; any other function or instruction is refused.
 */
import { existing, must, NdArray } from "./dtype.js";

/** Instructions run at most: 5000 vertices of the wordiest kind need a fifth. */
const MOST_STEPS = 1e6;

/** @param {unknown} value */
function textOf(value) {
  must(typeof value === "string");
  return value;
}

/**
 * @param {unknown} shape
 * @param {unknown} dtype  a list of byte order and type
 * @param {unknown} fortran
 * @param {unknown} bytes
 */
function arrayOf(shape, dtype, fortran, bytes) {
  must(
    Array.isArray(shape) &&
      shape.length <= 32 &&
      shape.every((n) => Number.isInteger(n) && n >= 0) &&
      Array.isArray(dtype),
  );
  return new NdArray(shape, textOf(dtype[0]) + textOf(dtype[1]), fortran === true, bytes);
}

/** The functions, by their names in NumPy 1. @type {Record<string, (args: unknown[]) => unknown>} */
const FUNCTIONS = {
  "numpy.ndarray": () => must(false),
  "numpy.dtype": ([type]) => ["|", type],
  "numpy.core.multiarray._reconstruct": () => new NdArray([0], "", false, null),
  "numpy.core.multiarray.scalar": ([dtype, bytes]) => arrayOf([], dtype, false, bytes),
  "numpy.core.numeric._frombuffer": ([bytes, dtype, shape, order]) => arrayOf(shape, dtype, order === "F", bytes),
  // Protocol 2 has no bytes, but text whose characters are bytes. It stays text until it is used: much may refer to it.
  "_codecs.encode": ([text]) => text,
};

/** A function by its module and name. @param {...unknown} path */
function find(...path) {
  const full = path.map(textOf).join(".");
  const known = FUNCTIONS[full.replace("numpy._core", "numpy.core")];
  must(known, `The file asks for ${full.slice(0, 80)}, which is refused.`);
  return known;
}

/**
 * @param {Uint8Array} bytes
 * @returns {unknown}  numbers (some as arrays without a dimension), text, true, false, null, bytes, lists (also for
 *   tuples) and arrays, which may refer to one another
 * @throws {NpyError} code `invalid-npy`
 */
export function readPickle(bytes) {
  let at = 0;
  /** @type {unknown[]} */
  let stack = [];
  /** The stacks below the marks. @type {unknown[][]} */
  const below = [];
  /** @type {Map<number, unknown>} */
  const memo = new Map();

  const raw = (/** @type {number} */ length) => {
    must(length >= 0 && at + length <= bytes.length);
    return bytes.subarray(at, (at += length));
  };
  const uint = (/** @type {number} */ size) => raw(size).reduceRight((value, byte) => 256 * value + byte, 0);
  /** In two's complement. @param {number} size  bytes, at most 6 to be exact */
  const int = (size) => {
    const value = uint(size);
    return value < 2 ** (8 * size - 1) ? value : value - 2 ** (8 * size);
  };
  /** Bytes after their length. @param {number} size  of the length */
  const sized = (size) => raw(uint(size));
  /** Text after its length. @param {number} size  of the length */
  const text = (size) => new TextDecoder().decode(sized(size));
  /** Text up to the end of its line. */
  const line = () => new TextDecoder().decode(raw(bytes.indexOf(10, at) + 1 - at).subarray(0, -1));
  const pop = (/** @type {number} */ count) => {
    must(stack.length >= count);
    return stack.splice(stack.length - count);
  };
  const popToMark = () => {
    const items = stack;
    stack = existing(below.pop());
    return items;
  };
  const top = () => existing(stack.at(-1));
  const append = (/** @type {unknown[]} */ items) => {
    const list = top();
    must(Array.isArray(list));
    for (const item of items) list.push(item);
  };
  const put = (/** @type {number} */ key) => {
    memo.set(key, top());
  };
  const get = (/** @type {number} */ key) => existing(memo.get(key));

  /** The instructions; what one returns is pushed. @type {Record<string, () => unknown>} */
  const instructions = {
    "\x80": () => must(uint(1) < 6), // PROTO
    "\x95": () => {
      raw(8);
    }, // FRAME
    N: () => null,
    "\x88": () => true,
    "\x89": () => false,
    G: () => new NdArray([], ">f8", false, raw(8)), // BINFLOAT
    J: () => int(4), // BININT
    K: () => uint(1), // BININT1
    M: () => uint(2), // BININT2
    "\x8a": () => int(uint(1)), // LONG1
    X: () => text(4), // BINUNICODE
    "\x8c": () => text(1), // SHORT_BINUNICODE
    B: () => sized(4), // BINBYTES
    C: () => sized(1), // SHORT_BINBYTES
    "\x96": () => sized(8), // BYTEARRAY8
    "]": () => [],
    ")": () => [],
    "(": () => {
      below.push(stack);
      stack = [];
    }, // MARK
    t: popToMark, // TUPLE
    "\x85": () => pop(1),
    "\x86": () => pop(2),
    "\x87": () => pop(3),
    a: () => append(pop(1)),
    e: () => append(popToMark()),
    q: () => put(uint(1)),
    r: () => put(uint(4)),
    "\x94": () => put(memo.size), // MEMOIZE
    h: () => get(uint(1)),
    j: () => get(uint(4)),
    c: () => find(line(), line()), // GLOBAL
    "\x93": () => find(...pop(2)), // STACK_GLOBAL
    R: () => {
      // REDUCE
      const [callee, args] = pop(2);
      must(typeof callee === "function" && Array.isArray(args));
      return callee(args);
    },
    b: () => {
      // BUILD
      const [state] = pop(1);
      const object = top();
      must(Array.isArray(state));
      if (Array.isArray(object)) object[0] = state[1];
      else {
        must(object instanceof NdArray);
        Object.assign(object, arrayOf(state[1], state[2], state[3], state[4]));
      }
    },
  };
  for (let steps = 0; ; steps++) {
    must(steps < MOST_STEPS);
    const op = String.fromCharCode(uint(1));
    if (op === ".") return top();
    const run = instructions[op];
    must(run, `The file asks for instruction ${op.charCodeAt(0)}, which is refused.`);
    const value = run();
    if (value !== undefined) stack.push(value);
  }
}
