/** Timing in the worker: trajectories of results, the states that a page shows, and files of them. */
import { writePath } from "planarium/import";

/** @import { Scenario, TimingLimits, Trajectory } from "planarium/full" */
/** @import { PathForm } from "planarium/import" */
/** @import { ResultDocument, ScenarioDocument } from "../domain/types.js" */

/**
 * A trajectory as a page shows it.
 * @typedef {object} Timing
 * @property {number} duration   seconds
 * @property {number} rests      times that the robot rests on the way
 * @property {number} step       seconds between two rows; the last one may come sooner
 * @property {Float64Array} rows   of the time, the configuration, its velocity and its acceleration
 * @property {number} dimension   of a configuration
 */

/** Rows of a trajectory that a page shows, but for the first. */
const ROWS = 4000;
/** The least step of a file, in seconds. */
const LEAST_STEP = 0.01;
/** The most that lines between waypoints are from the path, in metres. */
const DEVIATION = 0.01;
/** The steps of a file are fewer. */
const MOST_STEPS = 100_000;

/** The trajectories that were made last, and the scene of their paths. @type {{ trajectory: Trajectory, document: ScenarioDocument }[]} */
let held = [];

/** Frees the trajectories. */
export function dropTrajectories() {
  for (const { trajectory } of held.splice(0)) trajectory.free();
}

/** After the core was lost with all that it had. */
export function forgetTrajectories() {
  held = [];
}

/**
 * The trajectories of results, in place of those before.
 * @param {{ scenario: Scenario, document: ScenarioDocument }} scene
 * @param {ResultDocument[]} results
 * @param {TimingLimits} limits
 * @returns {Timing[]}
 */
export function timed({ scenario, document }, results, limits) {
  dropTrajectories();
  for (const result of results) {
    // The page says itself whether its paths are proven.
    held.push({ trajectory: scenario.time(result, limits, { verify: false }), document });
  }
  return held.map(({ trajectory }) => {
    const { duration, restCount: rests, dimension } = trajectory;
    const step = duration > 0 ? duration / ROWS : 1;
    return { duration, rests, step, rows: trajectory.sample(step), dimension };
  });
}

/** A trajectory that was made last. @param {number} index */
function made(index) {
  const one = held[index];
  if (!one) throw Object.assign(new Error("The path is no longer timed."), { code: "no-trajectory" });
  return one;
}

/** The document of a trajectory. @param {number} index */
export const documentOf = (index) => made(index).trajectory.toJSON();

/**
 * A trajectory in a form that other programs read. Its step is the least one, or of a long trajectory the least power of
 * ten of these; waypoints are the corners, and what blends and arcs take.
 * @param {number} index
 * @param {PathForm} form
 * @param {string} [query]
 */
export function written(index, form, query) {
  const { trajectory, document: scenario } = made(index);
  let step = LEAST_STEP;
  while (trajectory.duration / step >= MOST_STEPS) step *= 10;
  const states = form === "nav-waypoints" ? trajectory.rows({ deviation: DEVIATION }) : trajectory.sample(step);
  const path = { states, dimension: trajectory.dimension };
  return writePath(path, { scenario, form, ...(query !== undefined && { query }) });
}
