/** What is measured of a trial: the titles and units of the core's measures. */

import { measuresOf } from "./rows.js";

/** @typedef {{ id: string, title: string, unit: string }} MeasureInfo */

/** The share of trials with a path, and the share of paths that the verifier accepts. */
export const SOLVED = "solved";
const VALID = "valid";

/** Whether a measure is a share. @param {string} id */
export function isShare(id) {
  return id === SOLVED || id === VALID;
}

/** All measures of rows with these columns, shares first. @param {string[]} columns */
export function allMeasures(columns) {
  return [SOLVED, ...columns.filter((column) => column === VALID), ...measuresOf(columns)];
}

/** @type {Record<string, [title: string, unit: string]>} */
const TITLES = {
  [SOLVED]: ["trials solved", "%"],
  [VALID]: ["valid paths", "%"],
  iterations: ["iterations", ""],
  vertices: ["vertices", ""],
  edges: ["edges", ""],
  waypoints: ["waypoints of the path", ""],
  length: ["path length", ""],
  cost: ["path cost", ""],
  chord_length: ["weighted length by chords", ""],
  rejected_samples: ["samples in collision", ""],
  goal_samples: ["samples at the goal", ""],
  configuration_checks: ["configurations tested", ""],
  motion_checks: ["motions tested", ""],
  unchecked_edges: ["edges never tested", ""],
  nearest_queries: ["queries of neighbours", ""],
  visited: ["vertices visited by the search", ""],
  reopened: ["vertices expanded again", ""],
  clearance_evaluations: ["clearance evaluations", ""],
  unproven_motions: ["motions without a proof", ""],
  work: ["work", ""],
  build_seconds: ["time to build", "ms"],
  search_seconds: ["time to search", "ms"],
};

/** Measures of a path, not of work. */
export const OF_PATHS = ["length", "cost", "chord_length", "waypoints"];
/** The measures of documents that say none. */
export const USUAL = ["length", "iterations", "clearance_evaluations"];

/**
 * The unit that the lengths of all worlds have: empty where they have none, null where they differ.
 * @param {Map<string, string>} units  by the names of worlds
 */
export function commonUnit(units) {
  const several = new Set(units.values());
  return several.size > 1 ? null : ([...several][0] ?? "");
}

/** Whether a measure is in the unit of paths, which robots differ in. @param {string} id */
export function inUnit(id) {
  return id === "length" || id === "cost";
}

/** @param {string} id @param {string} lengthUnit  of paths; empty where they are costs @returns {MeasureInfo} */
export function measureInfo(id, lengthUnit) {
  const [title, unit] = TITLES[id] ?? [id, ""];
  return { id, title, unit: inUnit(id) ? lengthUnit : unit };
}

/** A measure with its article left out, as the subject of a sentence in the singular. @param {string} id */
export function nounOf(id) {
  const { title } = measureInfo(id, "");
  return ["length", "cost", "chord_length", "work"].includes(id) || id.endsWith("_seconds")
    ? title
    : `number of ${title}`;
}

/** The factor from the core's unit to the one shown: milliseconds, percent. @param {string} id */
export function scaleOf(id) {
  return id.endsWith("_seconds") ? 1000 : isShare(id) ? 100 : 1;
}

/** A title with its unit, for an axis. @param {{ title: string, unit: string }} info */
export function titled({ title, unit }) {
  return unit ? `${title}, ${unit}` : title;
}
