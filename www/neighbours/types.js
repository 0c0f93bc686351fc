/**
 * Types that this page's modules share.
 *
 * @typedef {import("../domain/types.js").ScenarioDocument} ScenarioDocument
 * @typedef {import("planarium").IndexInfo["id"]} IndexId
 * @typedef {import("planarium").NeighboursFound} Found
 * @typedef {import("../domain/types.js").Settings} Settings
 * @typedef {[number, number]} Point
 * @typedef {{ q: number[], k: number }} Preset   a query
 *
 * @typedef {object} RobotEntry   a built-in robot
 * @property {string} id
 * @property {string} title
 * @property {ScenarioDocument} document
 * @property {number[]} q    the target at first
 * @property {number} k
 * @property {Preset[]} presets
 *
 * @typedef {{ n: number, seed: number, free: boolean }} Sampling
 *
 * @typedef {object} List   configurations
 * @property {number} version   another for each list
 * @property {Float64Array} rows
 * @property {Float64Array} tips   for each the end effector, or the middle of a body, x and y
 *
 * @typedef {{ version: number, q: Float64Array, k: number, index: IndexId, given: Settings }} Query   `version`: of the list; `given`: options of the index
 * @typedef {{ found: Found, exact: Found }} Result   `exact`: by exact search, with angles that wrap
 *
 * @typedef {object} Measured   an index on n configurations
 * @property {IndexId} index
 * @property {number} n
 * @property {number} build     seconds
 * @property {number} query     seconds, the median of several batches
 * @property {number} visited   mean
 * @property {number} recall    mean part of the true nearest neighbours that were found
 */
export {};
