/**
 * The words that this page's modules share. Types only.
 *
 * @typedef {import("planarium").ScenarioDocument} ScenarioDocument
 * @typedef {import("planarium").Scenario} Scenario
 * @typedef {import("planarium").IndexInfo["id"]} IndexId
 * @typedef {import("planarium").NeighboursFound} Found
 * @typedef {Record<string, number | string | boolean>} Settings
 * @typedef {[number, number]} Point
 *
 * @typedef {object} RobotEntry   one of the page's own robots
 * @property {string} id
 * @property {string} title
 * @property {ScenarioDocument} document
 * @property {number[]} q    the target to begin with
 * @property {number} k
 * @property {Preset[]} presets
 *
 * @typedef {object} Preset   a question with a name
 * @property {number[]} q
 * @property {number} k
 *
 * @typedef {{ n: number, seed: number, free: boolean }} Draw   configurations drawn by seed
 *
 * @typedef {object} List   the configurations, as the worker hands them over
 * @property {number} version   that of the list; answers are for one
 * @property {Float64Array} rows
 * @property {Float64Array} tips   of each the point that the workspace plots, x and y
 *
 * @typedef {object} Question
 * @property {number} version   of the list
 * @property {Float64Array} q
 * @property {number} k
 * @property {IndexId} index
 * @property {Settings} given   the index's parameters
 *
 * @typedef {object} Reply
 * @property {Found} found
 * @property {Found} exact   by the metric that is meant: exact, and angles wrapped
 *
 * @typedef {object} Measured   one index with so many configurations
 * @property {IndexId} index
 * @property {number} n
 * @property {number} build     seconds
 * @property {number} query     seconds, in the middle of several batches
 * @property {number} visited   on average
 * @property {number} recall    part of the true nearest, on average
 */
export {};
