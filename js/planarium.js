/**
 * Planarium for browsers, workers and bundlers: `await init()` fetches `planarium_bg.wasm` from beside this file.
 * Importing it does nothing else.
 */
import { load, loadSync } from "./runtime.js";

export { Drive } from "./drive.js";
export { PlanariumError } from "./error.js";
export { generators, neighbourIndexes, phases, planners, randomSeed, reachMethods } from "./functions.js";
export { Neighbours } from "./neighbours.js";
export { Planner } from "./planner.js";
export { Reach } from "./reach.js";
export { Scenario } from "./scenario.js";
export { Trajectories, particlePoints, trajectoryOptions } from "./trajectories.js";
export { version } from "./version.js";

/** @typedef {import("./types.js").Status} Status */
/** @typedef {import("./types.js").Phase} Phase */
/** @typedef {import("./types.js").Point} Point */
/** @typedef {import("./types.js").Configuration} Configuration */
/** @typedef {import("./types.js").Box} Box */
/** @typedef {import("./types.js").Part} Part */
/** @typedef {import("./types.js").Touching} Touching */
/** @typedef {import("./types.js").Check} Check */
/** @typedef {import("./types.js").Clearance} Clearance */
/** @typedef {import("./types.js").Obstacle} Obstacle */
/** @typedef {import("./types.js").World} World */
/** @typedef {import("./types.js").Robot} Robot */
/** @typedef {import("./types.js").Shape} Shape */
/** @typedef {import("./types.js").Weights} Weights */
/** @typedef {import("./types.js").Query} Query */
/** @typedef {import("./types.js").Target} Target */
/** @typedef {import("./types.js").ScenarioDocument} ScenarioDocument */
/** @typedef {import("./types.js").PlannerInfo} PlannerInfo */
/** @typedef {import("./types.js").Motion} Motion */
/** @typedef {import("./types.js").ParameterInfo} ParameterInfo */
/** @typedef {import("./types.js").PresetInfo} PresetInfo */
/** @typedef {import("./types.js").GeneratorInfo} GeneratorInfo */
/** @typedef {import("./types.js").OptionInfo} OptionInfo */
/** @typedef {import("./types.js").PlannerOptions} PlannerOptions */
/** @typedef {import("./types.js").PseudocodeLine} PseudocodeLine */
/** @typedef {import("./types.js").PseudocodeMark} PseudocodeMark */
/** @typedef {import("./types.js").QueryOptions} QueryOptions */
/** @typedef {import("./types.js").RoadmapFormat} RoadmapFormat */
/** @typedef {import("./types.js").Approximate} Approximate */
/** @typedef {import("./types.js").DriveKey} DriveKey */
/** @typedef {import("./types.js").DriveState} DriveState */
/** @typedef {import("./types.js").KeyPress} KeyPress */
/** @typedef {import("./types.js").Obstructed} Obstructed */
/** @typedef {import("./types.js").Rollout} Rollout */
/** @typedef {import("./types.js").ReachMethodInfo} ReachMethodInfo */
/** @typedef {import("./types.js").ReachOptions} ReachOptions */
/** @typedef {import("./types.js").ReachVerdict} ReachVerdict */
/** @typedef {import("./types.js").ReachResult} ReachResult */
/** @typedef {import("./types.js").TrajectoryOptions} TrajectoryOptions */
/** @typedef {import("./types.js").TrajectoriesResult} TrajectoriesResult */
/** @typedef {import("./types.js").ParticleMotion} ParticleMotion */
/** @typedef {import("./types.js").ParticleModel} ParticleModel */
/** @typedef {import("./types.js").Followed} Followed */
/** @typedef {import("./types.js").NearestPoint} NearestPoint */
/** @typedef {import("./types.js").IndexInfo} IndexInfo */
/** @typedef {import("./types.js").NeighboursOptions} NeighboursOptions */
/** @typedef {import("./types.js").NeighboursFound} NeighboursFound */
/** @typedef {import("./types.js").SampleOptions} SampleOptions */
/** @typedef {import("./types.js").GenerateOptions} GenerateOptions */
/** @typedef {import("./types.js").GeneratorId} GeneratorId */
/** @typedef {import("./types.js").CspaceOptions} CspaceOptions */
/** @typedef {import("./types.js").Stats} Stats */
/** @typedef {import("./types.js").ResultDocument} ResultDocument */
/** @typedef {import("./types.js").InitInput} InitInput */
/** @typedef {import("./types.js").InitOptions} InitOptions */
/** @typedef {import("./types.js").InitSyncInput} InitSyncInput */
/** @typedef {import("./types.js").InitSyncOptions} InitSyncOptions */

/**
 * Loads Planarium. Call it once before anything else; further calls, also meanwhile, share the first load.
 * In Node the package is ready on import and this resolves at once.
 *
 * After an error with the code `internal` the core is lost; calling `init` again makes a fresh one.
 *
 * @param {InitInput | Promise<InitInput> | InitOptions} [input]
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
 * @param {InitSyncInput | InitSyncOptions} module
 * @returns {void}
 * @throws {PlanariumError} `init-failed`
 */
export function initSync(module) {
  loadSync(module);
}
