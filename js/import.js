/**
 * `planarium/import` for browsers, workers and bundlers: maps, grids, pictures and files of benchmarks as scenarios, and
 * paths of other programs, read and written. It has a WebAssembly module of its own, `import_bg.wasm`, which the first
 * `readWorld`, `readPath` or `writePath` fetches from beside this file.
 */
import { readFiles, readPathFile, writePathFile, __wbg_reset_state as renew } from "./import_glue.js";
import { PlanariumError } from "./error.js";
import { copyOf, kindOf, readable, token } from "./plain.js";
import { asOwn, isSound, load, loadSync } from "./runtime.js";

export { PlanariumError } from "./error.js";

/** @import { InitInput, InitOptions, InitSyncInput, InitSyncOptions } from "./core.js" */

/**
 * @typedef {import("./world.js").PathForm} PathForm
 * @typedef {import("./world.js").PathOptions} PathOptions
 * @typedef {import("./world.js").PathRead} PathRead
 * @typedef {import("./world.js").PathReport} PathReport
 * @typedef {import("./world.js").PathToWrite} PathToWrite
 * @typedef {import("./world.js").PathWriteOptions} PathWriteOptions
 * @typedef {import("./world.js").World} World
 * @typedef {import("./world.js").WorldFile} WorldFile
 * @typedef {import("./world.js").WorldGrid} WorldGrid
 * @typedef {import("./world.js").WorldOptions} WorldOptions
 * @typedef {import("./world.js").WorldReport} WorldReport
 * @typedef {import("./world.js").WorldRobot} WorldRobot
 */

/** The class of a typed array, whatever properties it has. */
const CLASS = Object.getOwnPropertyDescriptor(Object.getPrototypeOf(Uint8Array.prototype), Symbol.toStringTag)?.get;

/**
 * Loads the module that reads worlds and paths, before `readWorld`, `readPath` or `writePath` does so or from another place;
 * concurrent and later calls share the first load.
 * @param {InitInput | Promise<InitInput> | InitOptions} [input]  `import_bg.wasm`; by default the file beside this one
 * @returns {Promise<void>}
 * @throws {PlanariumError} rejects with the code `no-simd` or `init-failed`; the next call tries again
 */
export default async function init(input) {
  await load(input ?? new URL("./import_bg.wasm", import.meta.url));
}

/**
 * Loads the module synchronously, from bytes or a compiled module.
 * @param {InitSyncInput | InitSyncOptions} module
 * @returns {void}
 * @throws {PlanariumError} `no-simd`, `init-failed`
 */
export function initSync(module) {
  loadSync(module);
}

/**
 * Reads the files of one world, in any order: a map of ROS with its picture, a map of MovingAI, a grid, a picture, and
 * the other formats that docs/worlds.md lists. Their content decides the format. The first call loads the module. Do not
 * change the bytes before the promise has settled.
 * @param {readonly WorldFile[]} files  their names and contents
 * @param {WorldOptions} [options]  what the files do not say
 * @returns {Promise<World>} the scenario's document, a report of what was read, dropped, merged, moved and grown, and of
 *   maps and pictures the cells
 * @throws {PlanariumError} rejects with a code of docs/worlds.md, such as `unknown-world`, and with `file` and `place`
 *   where they are known; `missing-file` says in `wanted` which file is needed as well. Arguments of another form:
 *   `wrong-type`, `missing-field`, `unknown-field`, `out-of-range`. Those of `init`
 */
export async function readWorld(files, options) {
  return readWith(init, files, options);
}

/**
 * Reads a world once the module is there.
 * @param {() => Promise<void>} ready
 * @param {readonly WorldFile[]} files
 * @param {WorldOptions} [options]
 * @returns {Promise<World>} @internal
 */
export async function readWith(ready, files, options) {
  const given = filesOf(files);
  const settings = optionsOf(options);
  // Without a pause where there is nothing to load: the bytes are those of the call.
  if (!isSound()) await ready();
  const names = given.map(({ name }) => name);
  const contents = given.map(({ bytes }) => bytes);
  const [text, cells] = called(() => readFiles(names, contents, settings));
  const world = JSON.parse(text);
  if (cells !== null) world.grid.cells = cells;
  return world;
}

/**
 * Reads a path that anybody has made: a table such as CSV, an array of NumPy, a line or points of GeoJSON, poses of ROS,
 * or rows as JSON. Its content decides its form. `scenario.judge` of `planarium/full` judges it. The first call loads the
 * module. Do not change the bytes before the promise has settled.
 * @param {WorldFile} file  its name and content
 * @param {PathOptions} options  the scenario, in the coordinates of whose map the path is
 * @returns {Promise<PathRead>} the waypoints in the coordinates of the scenario, and what was read and left out
 * @throws {PlanariumError} rejects with a code of docs/worlds.md, such as `wrong-columns`, and with `file` and `place`
 *   where they are known. Arguments of another form: `wrong-type`, `missing-field`, `unknown-field`, `out-of-range`, and
 *   below `/scenario` the codes of scenarios. Those of `init`
 */
export async function readPath(file, options) {
  return readPathWith(init, file, options);
}

/**
 * Reads a path once the module is there.
 * @param {() => Promise<void>} ready
 * @param {WorldFile} file
 * @param {PathOptions} options
 * @returns {Promise<PathRead>} @internal
 */
export async function readPathWith(ready, file, options) {
  const { name, bytes } = readable("the file", "/file", () => fileOf(file, "/file"));
  const settings = optionsOf(options);
  if (!isSound()) await ready();
  const [text, waypoints] = called(() => readPathFile(name, bytes, settings));
  return { waypoints, ...JSON.parse(text) };
}

/**
 * Writes a path in a form that other programs read, in the coordinates of the map that the scenario was read from: a table
 * as `csv` or `json`, an array of NumPy (`npy`), `geojson`, a drawing (`svg`), and poses of ROS as YAML (`nav-path`,
 * `nav-waypoints`). The command line writes the same bytes (`planarium convert`). The first call loads the module. Do not
 * change the numbers before the promise has settled.
 * @param {PathToWrite} path  its rows, with or without times
 * @param {PathWriteOptions} options  the scenario and the form
 * @returns {Promise<Uint8Array>} the content of the file
 * @throws {PlanariumError} rejects with a code of docs/worlds.md: `truncated` without rows, `invalid-number`,
 *   `invalid-option` for a form that the robot does not have; `wrong-dimension`, `too-large`. Arguments of another form:
 *   `wrong-type`, `missing-field`, `unknown-field`, `out-of-range`, and below `/scenario` the codes of scenarios. Those of
 *   `init`
 */
export async function writePath(path, options) {
  return writePathWith(init, path, options);
}

/**
 * Writes a path once the module is there.
 * @param {() => Promise<void>} ready
 * @param {PathToWrite} path
 * @param {PathWriteOptions} options
 * @returns {Promise<Uint8Array>} @internal
 */
export async function writePathWith(ready, path, options) {
  const { numbers, isTimed, dimension } = readable("the path", "/path", () => rowsOf(path));
  const settings = optionsOf(options);
  if (!isSound()) await ready();
  return called(() => writePathFile(numbers, isTimed, dimension, settings));
}

/** The rows of a path: a view of the same numbers. @param {unknown} path */
function rowsOf(path) {
  if (typeof path !== "object" || path === null)
    throw new PlanariumError(
      "wrong-type",
      `path must be an object with configurations or states, not ${kindOf(path)}`,
      "/path",
    );
  const { configurations, states, dimension } = /** @type {Record<string, unknown>} */ (path);
  if (configurations === undefined && states === undefined)
    throw new PlanariumError("missing-field", "path must have configurations or states", "/path");
  if (configurations !== undefined && states !== undefined)
    throw new PlanariumError(
      "unknown-field",
      "path must have either configurations or states, not both",
      "/path/states",
    );
  const isTimed = states !== undefined;
  const [name, given] = isTimed ? ["states", states] : ["configurations", configurations];
  if (!ArrayBuffer.isView(given) || CLASS?.call(given) !== "Float64Array")
    throw new PlanariumError("wrong-type", `${name} must be a Float64Array, not ${kindOf(given)}`, `/path/${name}`);
  if (dimension !== undefined && !Number.isInteger(dimension))
    throw new PlanariumError("wrong-type", `dimension must be an integer, not ${kindOf(dimension)}`, "/path/dimension");
  const length = given.byteLength / Float64Array.BYTES_PER_ELEMENT;
  const numbers = new Float64Array(given.buffer, given.byteOffset, length);
  return { numbers, isTimed, dimension: /** @type {number | undefined} */ (dimension) };
}

/**
 * What one call of the module makes; what it took of memory is given back.
 * @template T
 * @param {() => T} call
 * @returns {T}
 */
function called(call) {
  try {
    const made = call();
    giveBack();
    return made;
  } catch (error) {
    if (typeof error !== "string") throw asOwn(error);
    giveBack();
    const { code, message, pointer, ...place } = JSON.parse(error);
    throw new PlanariumError(code, message, pointer, place);
  }
}

/** A fresh instance: the memory of one never shrinks. Where none can be made, the old one reads on. */
function giveBack() {
  try {
    renew();
  } catch {}
}

/** The options as JSON. @param {unknown} options */
function optionsOf(options) {
  const copy = copyOf(options ?? {}, "options");
  if (typeof copy !== "object" || Array.isArray(copy) || ArrayBuffer.isView(copy))
    throw new PlanariumError("wrong-type", `options must be an object, not ${kindOf(options)}`);
  return readable("the options", "", () => {
    requireFinite(copy, "");
    return JSON.stringify(copy);
  });
}

/** Refuses numbers that JSON does not have. @param {unknown} value @param {string} pointer */
function requireFinite(value, pointer) {
  if (typeof value === "number" && !Number.isFinite(value))
    throw new PlanariumError("not-finite", `a number of the options is ${value}`, pointer);
  if (typeof value !== "object" || value === null) return;
  for (const [key, inner] of Object.entries(value)) requireFinite(inner, `${pointer}/${token(key)}`);
}

/**
 * The files as they are read: names, and views of the same bytes.
 * @param {unknown} files
 */
function filesOf(files) {
  if (!Array.isArray(files)) {
    const wanted = "files must be an array of objects with name and bytes";
    throw new PlanariumError("wrong-type", `${wanted}, not ${kindOf(files)}`, "/files");
  }
  if (files.length === 0) throw new PlanariumError("out-of-range", "files is empty: there is no world", "/files");
  return readable("the files", "/files", () => Array.from(files, (file, i) => fileOf(file, `/files/${i}`)));
}

/** @param {unknown} file @param {string} place */
function fileOf(file, place) {
  if (typeof file !== "object" || file === null) {
    throw new PlanariumError("wrong-type", `a file must be an object with name and bytes, not ${kindOf(file)}`, place);
  }
  const { name, bytes } = /** @type {Record<string, unknown>} */ (file);
  if (name === undefined) throw new PlanariumError("missing-field", "the name of a file is missing", `${place}/name`);
  if (typeof name !== "string") {
    throw new PlanariumError("wrong-type", `the name of a file must be a text, not ${kindOf(name)}`, `${place}/name`);
  }
  if (bytes === undefined) {
    throw new PlanariumError("missing-field", `the bytes of ${JSON.stringify(name)} are missing`, `${place}/bytes`);
  }
  if (!ArrayBuffer.isView(bytes) || CLASS?.call(bytes) !== "Uint8Array") {
    const sentence = `the bytes of ${JSON.stringify(name)} must be a Uint8Array, not ${kindOf(bytes)}`;
    throw new PlanariumError("wrong-type", sentence, `${place}/bytes`);
  }
  // Of its own: an array may have properties that hide its length.
  return { name, bytes: new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength) };
}
