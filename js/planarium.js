/**
 * Planarium for browsers, workers and bundlers: `await init()` fetches `planarium_bg.wasm` from beside this file.
 * Importing it does nothing else.
 */
import { load, loadSync } from "./runtime.js";

export * from "./core.js";
export { PlanariumError } from "./error.js";
export {
  comparisonOptions, eventKinds, fleetGenerators, fleetPlanners, generators, historyColumns, navigationGenerators, neighbourIndexes, phases, planners, reachMethods, rolloutOptions, solve, trainingOptions, trajectoryOptions,
} from "./functions.js";
export { version } from "./version.js";

/** @import { InitInput, InitOptions, InitSyncInput, InitSyncOptions } from "./core.js" */

/**
 * Loads Planarium. Call it once before anything else; concurrent and later calls share the first load. In Node the package is ready on
 * import, and this resolves at once. After an error with the code `internal` the core is lost; `init` makes a fresh one.
 * @param {InitInput | Promise<InitInput> | InitOptions} [input]  `planarium_bg.wasm`; by default the file beside this one
 * @returns {Promise<void>}
 * @throws {PlanariumError} rejects with the code `no-simd` or `init-failed`; the next call tries again
 */
export default async function init(input) {
  await load(input ?? new URL("./planarium_bg.wasm", import.meta.url));
}

/**
 * Loads Planarium synchronously, from bytes or a compiled module.
 * @param {InitSyncInput | InitSyncOptions} module
 * @returns {void}
 * @throws {PlanariumError} `no-simd`, `init-failed`
 */
export function initSync(module) {
  loadSync(module);
}
