/** `planarium/import` for Node: the first call of a reader or writer reads the module from beside this file. */
import { readFileSync } from "node:fs";
import initElsewhere, { initSync, readPathWith, readWith, writePathWith } from "./import.js";
import { isSound } from "./runtime.js";

export { PlanariumError, initSync } from "./import.js";

/** @type {typeof initElsewhere} */
export default async function init(input) {
  if (input === undefined && !isSound()) initSync(readFileSync(new URL("./import_bg.wasm", import.meta.url)));
  else await initElsewhere(input);
}

/** @type {typeof import("./import.js").readWorld} */
export async function readWorld(files, options) {
  return readWith(init, files, options);
}

/** @type {typeof import("./import.js").readPath} */
export async function readPath(file, options) {
  return readPathWith(init, file, options);
}

/** @type {typeof import("./import.js").writePath} */
export async function writePath(path, options) {
  return writePathWith(init, path, options);
}
