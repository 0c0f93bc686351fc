/**
 * Planarium for browsers, workers and bundlers: `await init()` fetches `planarium_bg.wasm` from beside this file.
 * Importing it does nothing else.
 */
import { load, loadSync } from "./runtime.js";

export { PlanariumError } from "./error.js";
export { freshSeed, planners } from "./functions.js";
export { Planner } from "./planner.js";
export { Scenario } from "./scenario.js";
export { version } from "./version.js";

/** @typedef {import("./types.d.ts").Status} Status */
/** @typedef {import("./types.d.ts").Phase} Phase */
/** @typedef {import("./types.d.ts").Point} Point */
/** @typedef {import("./types.d.ts").Configuration} Configuration */
/** @typedef {import("./types.d.ts").Box} Box */
/** @typedef {import("./types.d.ts").Part} Part */
/** @typedef {import("./types.d.ts").Touching} Touching */
/** @typedef {import("./types.d.ts").Check} Check */
/** @typedef {import("./types.d.ts").Obstacle} Obstacle */
/** @typedef {import("./types.d.ts").World} World */
/** @typedef {import("./types.d.ts").Robot} Robot */
/** @typedef {import("./types.d.ts").Query} Query */
/** @typedef {import("./types.d.ts").ScenarioDocument} ScenarioDocument */
/** @typedef {import("./types.d.ts").PlannerInfo} PlannerInfo */
/** @typedef {import("./types.d.ts").ParameterInfo} ParameterInfo */
/** @typedef {import("./types.d.ts").PlannerOptions} PlannerOptions */
/** @typedef {import("./types.d.ts").GenerateOptions} GenerateOptions */
/** @typedef {import("./types.d.ts").CspaceOptions} CspaceOptions */
/** @typedef {import("./types.d.ts").Stats} Stats */
/** @typedef {import("./types.d.ts").ResultDocument} ResultDocument */
/** @typedef {import("./types.d.ts").InitInput} InitInput */
/** @typedef {import("./types.d.ts").InitSyncInput} InitSyncInput */

/**
 * Loads Planarium. Call it once before anything else; further calls, also meanwhile, share the first load.
 * In Node the package is ready on import and this resolves at once.
 *
 * After an error with the code `internal` the core is lost; calling `init` again makes a fresh one.
 *
 * @param {InitInput | Promise<InitInput> | { module_or_path: InitInput | Promise<InitInput> }} [input]
 *   where `planarium_bg.wasm` is: a URL, a Request, a Response, its bytes, or the compiled module.
 *   By default the file beside this one.
 * @returns {Promise<void>}
 * @throws {PlanariumError} rejects with the code `init-failed`; the next call tries again
 */
export default async function init(input) {
  await load(input ?? new URL("./planarium_bg.wasm", import.meta.url));
}

/**
 * Loads Planarium at once from bytes or a compiled module, where nothing can be awaited.
 * @param {InitSyncInput | { module: InitSyncInput }} module
 * @returns {void}
 * @throws {PlanariumError} `init-failed`
 */
export function initSync(module) {
  loadSync(module);
}
