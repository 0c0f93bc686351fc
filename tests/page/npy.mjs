/** Files of NumPy for tests: those that NumPy wrote, and such as are made by hand. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { root } from "../../scripts/run.mjs";

export const FIXTURES = join(root, "tests", "page", "fixtures");

/** A file that NumPy wrote. @param {string} name */
export const fixture = (name) => new Uint8Array(readFileSync(join(FIXTURES, `${name}.npy`)));

/** A file of version 1.0. @param {string} literal @param {ArrayLike<number>} body */
export function file(literal, body = []) {
  const head = `\x93NUMPY\x01\0${String.fromCharCode(literal.length & 255, literal.length >> 8)}${literal}`;
  return Uint8Array.from([...Array.from(head, (c) => c.charCodeAt(0)), ...Array.from(body)]);
}

/** A pickled array of objects; text is written byte by byte. @param {...(string | number[])} parts */
export function pickled(...parts) {
  const body = parts.flatMap((part) => (typeof part === "string" ? Array.from(part, (c) => c.charCodeAt(0)) : part));
  return file("{'descr': '|O', 'fortran_order': False, 'shape': (1,), }\n", body);
}
