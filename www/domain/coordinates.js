/** The coordinates of a configuration: their names, ranges and units. */
import { difference, wrap } from "planarium/draw";

/** @import { Coordinate, Scenario, ScenarioDocument } from "./types.js" */

/** @param {{ scenario: Scenario, document: ScenarioDocument }} shown @returns {Coordinate[]} */
export function coordinatesOf({ scenario, document: { robot } }) {
  if (robot.type === "arm") {
    return robot.links.map((_, i) => {
      const [low, high] = robot.joint_limits?.[i] ?? [-Math.PI, Math.PI];
      return { name: `joint ${i + 1}`, low, high, unit: "rad", isCircle: !robot.joint_limits };
    });
  }
  const { min, max } = scenario.extent();
  /** @type {Coordinate[]} */
  const plane = ["x", "y"].map((name, i) => ({ name, low: min[i], high: max[i], unit: "m", isCircle: false }));
  return robot.type === "disc" ? plane : [...plane, { name: "theta", low: -Math.PI, high: Math.PI, unit: "rad", isCircle: true }];
}

/** Moves a configuration into the ranges of its coordinates, in place. @template {Float64Array} T @param {T} pose @param {Coordinate[]} coordinates */
export function contained(pose, coordinates) {
  coordinates.forEach(({ low, high, isCircle }, i) => {
    pose[i] = isCircle ? wrap(pose[i]) : Math.min(high, Math.max(low, pose[i]));
  });
  return pose;
}

/** Fits a configuration with more or fewer numbers to coordinates and their ranges. @param {ArrayLike<number>} q @param {Coordinate[]} coordinates */
export function fitted(q, coordinates) { return contained(Float64Array.from(coordinates, (_, i) => q[i] ?? 0), coordinates); }

/** The rows of one flat array. @param {Float64Array} values @param {number} width  numbers in a row */
export function rowsOf(values, width) {
  return Array.from({ length: values.length / width }, (_, i) => values.subarray(i * width, (i + 1) * width));
}

/** How far each coordinate moves from the first row to the last, each step of a circle the short way round. @param {ArrayLike<number>[]} rows @param {boolean[]} circles */
export function turnsAlong(rows, circles) {
  return circles.map((isCircle, i) => rows.slice(1).reduce((sum, row, step) => sum + difference(rows[step][i], row[i], isCircle), 0));
}

/** The longer side of the world, metres. @param {Scenario} scenario */
export function sizeOf(scenario) {
  const { min, max } = scenario.extent();
  return Math.max(max[0] - min[0], max[1] - min[1]);
}
