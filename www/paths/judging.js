/** Paths of other programs in the worker: they are read, held, and judged in the scene. */
import { readPath } from "planarium/import";
import { faultOf } from "../worlds/fault.js";

/** @import { PathJudgement, Scenario } from "planarium/full" */
/** @import { PathRead } from "planarium/import" */
/** @import { Content } from "../app/read-files.js" */
/** @import { ScenarioDocument } from "../domain/types.js" */
/** @import { Fault } from "../worlds/types.js" */

/**
 * A path that was read, as a page draws it.
 * @typedef {object} DrawnPath
 * @property {number} id            its number in the worker
 * @property {number} count         waypoints
 * @property {Float64Array} rows    the configurations of those that are drawn
 * @property {Uint32Array} indices  their numbers, from 0
 * @property {PathRead["report"]} report
 */
/** @typedef {PathJudgement} Judgement */
/** @typedef {"degrees" | "radians"} Angles */

/** About how many waypoints of a long path are drawn. */
const DRAWN = 5000;

/** The waypoints of the paths that were read, by their numbers. @type {Map<number, Float64Array>} */
const paths = new Map();
let readCount = 0;

/**
 * Reads a path. Those before stay until one of them is kept.
 * @param {Content} file
 * @param {ScenarioDocument} scenario   the path is in the coordinates of its map, if it has one
 * @param {Angles | undefined} angles   what its angles are where the file does not say it
 * @returns {Promise<DrawnPath | { fault: Fault }>}
 */
export async function read(file, scenario, angles) {
  try {
    return drawn(await readPath(file, { scenario, ...(angles && { angles }) }));
  } catch (error) {
    return { fault: faultOf(error) };
  }
}

/** @param {PathRead} path @returns {DrawnPath} */
function drawn(path) {
  const { dimension, waypoints } = path;
  const id = ++readCount;
  paths.set(id, waypoints);
  const count = waypoints.length / dimension;
  const each = Math.ceil(count / DRAWN);
  const indices = Uint32Array.from({ length: Math.ceil((count - 1) / each) + 1 }, (_, i) =>
    Math.min(count - 1, i * each),
  );
  const rows = new Float64Array(indices.length * dimension);
  indices.forEach((index, i) => {
    rows.set(waypoints.subarray(index * dimension, (index + 1) * dimension), i * dimension);
  });
  return { id, count, rows, indices, report: path.report };
}

/** Forgets all paths but one. @param {number | null} kept   null: all */
export function keep(kept) {
  for (const id of paths.keys()) if (id !== kept) paths.delete(id);
}

/** Judges a path. @param {Scenario} scenario @param {number} id @param {boolean} arcs @returns {Judgement} */
export function judge(scenario, id, arcs) {
  const waypoints = paths.get(id);
  if (!waypoints)
    throw Object.assign(new Error("The path is no longer there; open its file again."), { code: "no-path" });
  return scenario.judge(waypoints, { arcs });
}
