/** The clearance along a path, in the worker. */

/** @import { Scenario } from "planarium/full" */
/** @import { Box, Part } from "../domain/types.js" */

/**
 * The clearance along a path.
 * @typedef {object} Clearances
 * @property {Float64Array} distances   at each configuration, metres; none: there is nothing to keep clear of
 * @property {{ index: number, distance: number, pose: Float64Array } | null} least   `index`: of the configuration, and a
 *   fraction towards the next one
 */

/** The golden section. */
const SECTION = (Math.sqrt(5) - 1) / 2;
/** How often the interval around the least clearance is cut. */
const CUTS = 40;

/**
 * The distance of the robot, its margin included, from obstacles and bounds.
 * @param {Scenario} scenario
 * @param {Float64Array} rows   of configurations
 * @returns {Clearances}
 */
export function clearances(scenario, rows) {
  const { dimension } = scenario;
  const { world, robot } = scenario.document();
  const at = (/** @type {Float64Array} */ pose) =>
    Math.min(
      nearest(scenario, pose, world.obstacles.length > 0),
      toBounds(scenario.footprint(pose), world.bounds, robot.margin ?? 0),
    );
  const count = rows.length / dimension;
  const row = (/** @type {number} */ i) => rows.subarray(i * dimension, (i + 1) * dimension);
  const distances = Float64Array.from({ length: count }, (_, i) => at(row(i)));
  let first = 0;
  for (let i = 1; i < count; i++) if (distances[i] < distances[first]) first = i;
  if (!(distances[first] < Infinity)) return { distances: new Float64Array(), least: null };
  const poseAt = (/** @type {number} */ index) => {
    const i = Math.min(count - 1, Math.floor(index));
    return i + 1 < count ? scenario.interpolate(row(i), row(i + 1), index - i) : row(i).slice();
  };
  const refined = minimum((index) => at(poseAt(index)), Math.max(0, first - 1), Math.min(count - 1, first + 1));
  const [index, distance] = refined[1] < distances[first] ? refined : [first, distances[first]];
  return { distances, least: { index, distance, pose: poseAt(index) } };
}

/**
 * How far the nearest obstacle is; 0 in contact.
 * @param {Scenario} scenario
 * @param {Float64Array} pose
 * @param {boolean} hasObstacles
 */
function nearest(scenario, pose, hasObstacles) {
  if (!hasObstacles) return Infinity;
  return scenario.clearance(pose)?.distance ?? 0;
}

/** How far the bounds are. @param {Part[]} parts @param {Box | undefined} bounds @param {number} margin */
function toBounds(parts, bounds, margin) {
  if (!bounds) return Infinity;
  const { min, max } = bounds;
  const of = ([x, y] = [0, 0], radius = 0) => Math.min(x - min[0], max[0] - x, y - min[1], max[1] - y) - radius;
  const all = parts.map((part) => {
    if (part.type === "disc") return of(part.center, part.radius);
    if (part.type === "capsule") return Math.min(of(part.a, part.radius), of(part.b, part.radius));
    return Math.min(...part.vertices.map((vertex) => of(vertex)));
  });
  return Math.max(0, Math.min(...all) - margin);
}

/**
 * The least value of a function with one minimum in an interval, by golden sections (Kiefer 1953).
 * @param {(x: number) => number} of @param {number} low @param {number} high @returns {[number, number]}   where, and the value
 */
function minimum(of, low, high) {
  let [a, b] = [high - SECTION * (high - low), low + SECTION * (high - low)];
  let [atA, atB] = [of(a), of(b)];
  for (let i = 0; i < CUTS; i++) {
    if (atA <= atB) {
      [high, b, atB] = [b, a, atA];
      a = high - SECTION * (high - low);
      atA = of(a);
    } else {
      [low, a, atA] = [a, b, atB];
      b = low + SECTION * (high - low);
      atB = of(b);
    }
  }
  return atA <= atB ? [a, atA] : [b, atB];
}
