/**
 * The words that the page's modules share. Types only: nothing here exists at run time.
 *
 * @typedef {import("./planarium/planarium.js").Scenario} Scenario
 * @typedef {import("./planarium/planarium.js").Planner} Planner
 * @typedef {import("./planarium/planarium.js").Status} Status
 * @typedef {ReturnType<Scenario["footprint"]>[number]} Part   one moving part, in world coordinates
 * @typedef {ReturnType<Scenario["document"]>} ScenarioDocument
 * @typedef {ScenarioDocument["world"]["obstacles"][number]} Obstacle
 * @typedef {readonly number[] | Float64Array} Configuration   one number a degree of freedom
 * @typedef {ReturnType<Scenario["check"]>} Check               which part touches what
 * @typedef {ReturnType<typeof import("./planarium/planarium.js").planners>[number]} PlannerInfo
 * @typedef {PlannerInfo["parameters"][number]} ParameterInfo
 * @typedef {typeof import("./planarium/planarium.js")} Library  the package, handed to the modules that need it
 *
 * @typedef {Record<string, number | string | boolean>} Settings  what a planner is started with, by parameter name
 *
 * @typedef {object} Box   an axis-aligned box
 * @property {[number, number]} min
 * @property {[number, number]} max
 *
 * @typedef {object} SceneEntry   one of the page's own scenes
 * @property {string} id          file name in `scenes/`, without its ending
 * @property {string} title
 * @property {string} story       one sentence: what to watch for
 * @property {string} algorithm
 * @property {number} pace        iterations per second at which it is good to watch
 * @property {Settings} settings  parameters that differ from the planner's defaults
 */
export {};
