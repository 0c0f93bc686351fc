/**
 * Planarium for browsers, workers and bundlers: `await init()` fetches `planarium_bg.wasm` from beside this file.
 * Importing it does nothing else.
 */
import { isWithinCall } from "./callback.js";
import { PlanariumError } from "./error.js";
import { isSound, load, loadSync } from "./runtime.js";

export * from "./core.js";
export { PlanariumError } from "./error.js";
export { generators, neighbourIndexes, planners, solve } from "./functions.js";
export { eventKinds, historyColumns, phases } from "./tables.js";
export { version } from "./version.js";

/** @import { InitInput, InitOptions, InitSyncInput, InitSyncOptions } from "./core.js" */

/**
 * Loads Planarium. Call it once before anything else; concurrent and later calls share the first load. In Node the
 * package is ready on import, and this resolves at once. After an error with the code `internal` the core is lost;
 * `init` makes a fresh one.
 * @param {InitInput | Promise<InitInput> | InitOptions} [input]  `planarium_bg.wasm`; by default the file beside this
 *   one
 * @returns {Promise<void>}
 * @throws {PlanariumError} rejects with the code `no-simd` or `init-failed`; the next call tries again; `in-use` in a
 *   function that a lost core has called
 */
export default async function init(input) {
  refuseWithin();
  await load(input ?? new URL("./planarium_bg.wasm", import.meta.url));
}

/**
 * Loads Planarium synchronously, from bytes or a compiled module.
 * @param {InitSyncInput | InitSyncOptions} module
 * @returns {void}
 * @throws {PlanariumError} `no-simd`, `init-failed`, `in-use`
 */
export function initSync(module) {
  refuseWithin();
  loadSync(module);
}

/** Refuses to replace a lost core while calls of it are under way. */
function refuseWithin() {
  if (!isWithinCall() || isSound()) return;
  throw new PlanariumError(
    "in-use",
    "The core was lost in a call that is still under way: call init() once that has ended.",
  );
}
