/** The coordinates of a configuration: what they are called, how far they go, what they are measured in. */

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

/** A configuration brought into its coordinates' ranges, in place. @param {Float64Array} pose @param {Coordinate[]} coordinates */
export function contained(pose, coordinates) {
  coordinates.forEach(({ low, high, isCircle }, i) => {
    pose[i] = isCircle ? wrap(pose[i]) : Math.min(high, Math.max(low, pose[i]));
  });
  return pose;
}

/** A configuration from one with more or fewer numbers, brought into its coordinates' ranges. @param {ArrayLike<number>} q @param {Coordinate[]} coordinates */
export function fitted(q, coordinates) { return contained(Float64Array.from(coordinates, (_, i) => q[i] ?? 0), coordinates); }

/** An angle brought between -pi (without it) and pi. @param {number} angle */
export function wrap(angle) {
  const turn = angle % (2 * Math.PI);
  if (turn > Math.PI) return turn - 2 * Math.PI;
  return turn <= -Math.PI ? turn + 2 * Math.PI : turn;
}
