/** The coordinates of a configuration: their names, ranges and units. */
import { difference, wrap } from "planarium/draw";

/** @import { Coordinate, Scenario, ScenarioDocument } from "./types.js" */
/** @typedef {Extract<ScenarioDocument["robot"], { type: "arm" }>} ArmRobot */

/**
 * How each link of an arm moves against the one before: it turns, with limits in radians or without, or it slides,
 * within a range in metres, at a fixed angle.
 * @typedef {{ type: "revolute", limits?: [number, number] } | { type: "prismatic", range: [number, number], angle:
 *   number }} LinkJoint
 */

/** The joints of an arm, one a link. @param {ArmRobot} arm @returns {LinkJoint[]} */
export function jointsOf({ links, joints, joint_limits: limits }) {
  return links.map((_, i) => {
    const joint = joints?.[i] ?? "revolute";
    if (joint === "revolute") return { type: "revolute", limits: limits?.[i] };
    return joint.type === "prismatic"
      ? { type: "prismatic", range: joint.range, angle: joint.angle ?? 0 }
      : { type: "revolute", limits: joint.limits };
  });
}

/**
 * The arm with these joints, written as briefly as its document allows.
 * @param {ArmRobot} arm
 * @param {LinkJoint[]} joints
 * @returns {ArmRobot}
 */
export function withJoints({ joints: _, joint_limits: __, ...arm }, joints) {
  const limits = joints.flatMap((joint) => (joint.type === "revolute" && joint.limits ? [joint.limits] : []));
  if (limits.length === joints.length) return { ...arm, joint_limits: limits };
  if (limits.length === 0 && joints.every(({ type }) => type === "revolute")) return arm;
  return { ...arm, joints: joints.map((joint) => (joint.type === "revolute" && !joint.limits ? "revolute" : joint)) };
}

/** The greatest length of each link, metres. @param {ArmRobot} arm */
export function longestOf(arm) {
  return jointsOf(arm).map((joint, i) => arm.links[i] + (joint.type === "prismatic" ? joint.range[1] : 0));
}

/**
 * The direction of each link at a configuration, radians, not wrapped.
 * @param {ArmRobot} arm
 * @param {ArrayLike<number>} q
 * @param {LinkJoint[]} [joints]  of the arm
 */
export function directionsOf(arm, q, joints = jointsOf(arm)) {
  let angle = 0;
  return joints.map((joint, i) => (angle += joint.type === "prismatic" ? joint.angle : q[i]));
}

/** Whether a link of an arm slides. @param {ArmRobot} arm */
export function hasSlide(arm) {
  return jointsOf(arm).some(({ type }) => type === "prismatic");
}

/**
 * The direction of each link that slides at a configuration, radians; null for one that turns.
 * @param {ArmRobot} arm
 * @param {ArrayLike<number>} q
 */
export function slidesOf(arm, q) {
  const joints = jointsOf(arm);
  return directionsOf(arm, q, joints).map((direction, i) => (joints[i].type === "prismatic" ? direction : null));
}

/** @param {{ scenario: Scenario, document: ScenarioDocument }} shown @returns {Coordinate[]} */
export function coordinatesOf({ scenario, document: { robot } }) {
  if (robot.type === "arm") {
    return jointsOf(robot).map((joint, i) => {
      const isSlide = joint.type === "prismatic";
      const range = isSlide ? joint.range : joint.limits;
      const [low, high] = range ?? [-Math.PI, Math.PI];
      return { name: `joint ${i + 1}`, low, high, unit: isSlide ? "m" : "rad", isCircle: !range };
    });
  }
  const { min, max } = scenario.extent();
  /** @type {Coordinate[]} */
  const plane = ["x", "y"].map((name, i) => ({ name, low: min[i], high: max[i], unit: "m", isCircle: false }));
  return robot.type === "disc"
    ? plane
    : [...plane, { name: "theta", low: -Math.PI, high: Math.PI, unit: "rad", isCircle: true }];
}

/**
 * Moves a configuration into the ranges of its coordinates, in place.
 * @template {Float64Array} T
 * @param {T} pose
 * @param {Coordinate[]} coordinates
 */
export function contained(pose, coordinates) {
  coordinates.forEach(({ low, high, isCircle }, i) => {
    pose[i] = isCircle ? wrap(pose[i]) : Math.min(high, Math.max(low, pose[i]));
  });
  return pose;
}

/**
 * Fits a configuration with more or fewer numbers to coordinates and their ranges.
 * @param {ArrayLike<number>} q
 * @param {Coordinate[]} coordinates
 */
export function fitted(q, coordinates) {
  return contained(
    Float64Array.from(coordinates, (_, i) => q[i] ?? 0),
    coordinates,
  );
}

/** The rows of one flat array. @param {Float64Array} values @param {number} width  numbers in a row */
export function rowsOf(values, width) {
  return Array.from({ length: values.length / width }, (_, i) => values.subarray(i * width, (i + 1) * width));
}

/**
 * How far each coordinate moves from the first row to the last, each step of a circle the short way round.
 * @param {ArrayLike<number>[]} rows
 * @param {boolean[]} circles
 */
export function turnsAlong(rows, circles) {
  return circles.map((isCircle, i) =>
    rows.slice(1).reduce((sum, row, step) => sum + difference(rows[step][i], row[i], isCircle), 0),
  );
}

/** The longer side of the world, metres. @param {Scenario} scenario */
export function sizeOf(scenario) {
  const { min, max } = scenario.extent();
  return Math.max(max[0] - min[0], max[1] - min[1]);
}
