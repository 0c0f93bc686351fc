/**
 * Types of worlds that are opened.
 *
 * @typedef {import("planarium/import").WorldOptions} Options
 * @typedef {import("planarium/import").WorldReport} Report
 * @typedef {NonNullable<Report["layers"]>[number]} Layer
 * @typedef {import("planarium/import").World} ReadWorld
 * @typedef {import("planarium/import").WorldGrid} Grid
 *
 * @typedef {object} Places   a start and a goal between which straight motions were proven free, one after the other
 * @property {number[]} start
 * @property {number[]} goal
 *
 * @typedef {object} Fault   why files could not be read
 * @property {string} code
 * @property {string} message
 * @property {string} file
 * @property {{ line?: number, byte?: number, element?: string } | null} place
 * @property {string} wanted   the name of a missing file, or empty
 *
 * @typedef {{ world: ReadWorld, places: Places | null, suggested: Partial<import("./choices.js").Choices> | null }} Reading
 */
export {};
