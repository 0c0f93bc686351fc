/** Robots of other types, sizes and shapes: every change returns a new robot or a new document. */
import { coordinatesOf, fitted, jointsOf, withJoints } from "../../domain/coordinates.js";
import { isPlaced } from "../../domain/names.js";
import { boxOf, rectangleBetween } from "../../domain/obstacles.js";
import { changed } from "./objects.js";
import { rounded } from "./units.js";

/** @import { Box, Point, Query, Scenario, ScenarioDocument } from "../../domain/types.js" */
/** @import { LinkJoint } from "../../domain/coordinates.js" */
/** @typedef {ScenarioDocument["robot"]} Robot */
/** @typedef {Extract<Robot, { type: "arm" }>} Arm */
/** @typedef {Extract<Robot, { type: "rigid_body" | "car" }>} Shaped */
/** @typedef {{ document: ScenarioDocument, scenario: Scenario }} Open   what is on the stage */

/** The types with their names, the simplest first. @type {[Robot["type"], string][]} */
export const TYPES = [
  ["disc", "Disc or point"],
  ["rigid_body", "Rigid body"],
  ["car", "Car"],
  ["arm", "Arm"],
];

/** Links at most, as in the core. */
export const MOST_LINKS = 8;
/** Steering angles of a new car, radians. */
const STEERING = 0.785;
/** The goal region of a car, which planners by controls need: a part of the world, and radians. */
const TOLERANCE = { translation: 1 / 20, rotation: 0.3 };

/** The robot if it has a shape, else null. @param {Robot} robot @returns {Shaped | null} */
export const shapedOf = (robot) => (robot.type === "rigid_body" || robot.type === "car" ? robot : null);

/** Length and width of a shape: of its box. @param {Shaped["shape"]} shape */
export function footprintOf({ vertices }) {
  const [low, high] = boxOf(vertices);
  return { length: high[0] - low[0], width: high[1] - low[1] };
}

/** The shape with another length and width. @param {Shaped["shape"]} shape @param {number} length @param {number} width @param {number} unit @returns {Shaped["shape"]} */
export function sized(shape, length, width, unit) {
  const now = footprintOf(shape);
  return {
    ...shape,
    vertices: shape.vertices.map(([x, y]) => [
      rounded((x * length) / now.length, unit),
      rounded((y * width) / now.width, unit),
    ]),
  };
}

/** The box of a shape. @param {Shaped["shape"]} shape @returns {Shaped["shape"]} */
export function boxed({ vertices }) {
  return rectangleBetween(...boxOf(vertices));
}

/** A rectangle about the origin. @param {number} length @param {number} width @returns {Shaped["shape"]} */
export function rectangular(length, width) {
  return rectangleBetween([-length / 2, -width / 2], [length / 2, width / 2]);
}

/** Length and width of a robot, metres; of an arm, those of a body beside it. @param {Robot} robot @param {number} size  of the world */
function extentOf(robot, size) {
  const shaped = shapedOf(robot);
  if (shaped) return footprintOf(shaped.shape);
  const length = robot.type === "disc" && robot.radius > 0 ? 2 * robot.radius : size / 15;
  return { length, width: 0.6 * length };
}

/**
 * A robot of another type, about as large.
 * @param {Robot} robot
 * @param {Robot["type"]} type
 * @param {number} size  of the world
 * @param {number} unit
 * @param {Point} base  of an arm
 * @returns {Robot}
 */
function robotOf(robot, type, size, unit, base) {
  const { length, width } = extentOf(robot, size);
  const round = (/** @type {number} */ value) => rounded(value, unit);
  const shaped = shapedOf(robot);
  const shape = shaped?.shape ?? rectangular(round(length), round(width));
  const margin = marginOf(robot) > 0 ? { margin: marginOf(robot) } : {};
  const metric = shaped?.metric ? { metric: shaped.metric } : {};
  switch (type) {
    case "disc":
      return { type, radius: round(shaped ? reachOf(shaped) : length / 2), ...margin };
    case "rigid_body":
      return { type, shape, ...metric, ...margin };
    case "car":
      return {
        type,
        shape,
        wheelbase: round(0.6 * length),
        speed: [-1, 1],
        steering: [-STEERING, STEERING],
        ...metric,
        ...margin,
      };
    default:
      return { type, base, links: [0.25, 0.2].map((part) => round(part * size)), radius: round(size / 100), ...margin };
  }
}

/** How far a shape extends from its origin. @param {Shaped} robot */
function reachOf({ shape }) {
  return Math.max(...shape.vertices.map(([x, y]) => Math.hypot(x, y)));
}

/** The margin of a robot, metres. @param {Robot} robot */
export function marginOf(robot) {
  return robot.margin ?? 0;
}

/** The robot with another margin. @param {Robot} robot @param {number} margin @returns {Robot} */
export function withMargin(robot, margin) {
  const { margin: _, ...bare } = robot;
  return margin === 0 ? bare : { ...bare, margin };
}

/**
 * The document with a robot of another type, once for each place where the base of an arm may be. Start and goal of its
 * queries keep x and y, those of an arm become 0.
 * @param {Open} shown
 * @param {Robot["type"]} type
 * @param {number} size  of the world
 * @param {number} unit
 * @returns {{ documents: ScenarioDocument[], text: string }}  with what becomes of start and goal, in words
 */
export function withType({ document, scenario }, type, size, unit) {
  const bounds = document.world.bounds ?? roundedBox(scenario.extent(), unit);
  const world = type === "arm" ? document.world : { ...document.world, bounds };
  const documents = (type === "arm" ? basesOf(bounds, unit) : [bounds.min]).map((base) => {
    const robot = robotOf(document.robot, type, size, unit, base);
    const queries = document.queries.map((query) => carried(query, { document, scenario }, robot, size, unit));
    return { ...document, world, robot, queries };
  });
  return { documents, text: carriedText(document, type) };
}

/** Places for the base of an arm, the middle first. @param {Box} bounds @param {number} unit @returns {Point[]} */
function basesOf({ min, max }, unit) {
  const parts = [0.5, 0.35, 0.65, 0.2, 0.8];
  const at = (/** @type {number} */ part, /** @type {0 | 1} */ i) => rounded(min[i] + part * (max[i] - min[i]), unit);
  return parts.flatMap((across) => parts.map((up) => /** @type {Point} */ ([at(across, 0), at(up, 1)])));
}

/** A box that contains another, in whole units. @param {Box} box @param {number} unit @returns {Box} */
function roundedBox({ min, max }, unit) {
  const low = (/** @type {number} */ value) => rounded(Math.floor(value / unit) * unit, unit);
  const high = (/** @type {number} */ value) => rounded(Math.ceil(value / unit) * unit, unit);
  return { min: [low(min[0]), low(min[1])], max: [high(max[0]), high(max[1])] };
}

/**
 * A query for another robot.
 * @param {Query} query
 * @param {Open} shown
 * @param {Robot} robot
 * @param {number} size
 * @param {number} unit
 * @returns {Query}
 */
function carried(query, { document, scenario }, robot, size, unit) {
  const isArm = document.robot.type === "arm";
  const placeOf = (/** @type {number[]} */ pose) => (isArm ? [...scenario.endEffector(pose)] : pose);
  /** @param {number[]} place */
  const poseOf = (place) => {
    if (robot.type === "arm") return robot.links.map(() => 0);
    const plane = place.slice(0, 2).map((value) => (isArm ? rounded(value, unit) : value));
    return isPlaced(robot.type) ? [...plane, isArm ? 0 : (place[2] ?? 0)] : plane;
  };
  return changed(query, {
    start: poseOf(placeOf(query.start)),
    goal: poseOf(query.goal ? placeOf(query.goal) : (query.target?.point ?? [])),
    target: undefined,
    goal_tolerance: toleranceFor(query.goal_tolerance, robot, size, unit),
  });
}

/** @param {Query["goal_tolerance"]} tolerance @param {Robot} robot @param {number} size @param {number} unit @returns {Query["goal_tolerance"]} */
function toleranceFor(tolerance, { type }, size, unit) {
  if (type === "arm") return undefined;
  const { translation, rotation } = tolerance ?? {};
  if (type === "disc") return translation === undefined ? undefined : { translation };
  if (translation !== undefined && rotation !== undefined) return tolerance;
  if (type !== "car") return undefined;
  return {
    translation: translation ?? rounded(TOLERANCE.translation * size, unit),
    rotation: rotation ?? TOLERANCE.rotation,
  };
}

/** What becomes of start and goal, in words. @param {ScenarioDocument} document @param {Robot["type"]} type */
function carriedText({ robot }, type) {
  if (type === "arm") return "All joints of start and goal are 0.";
  const angle = isPlaced(type) && !isPlaced(robot.type) ? "; their theta is 0" : "";
  const place = robot.type === "arm" ? "are where the end effector was" : "keep x and y";
  return `Start and goal ${place}${angle}.`;
}

/**
 * The document with another arm: configurations get zeros for new links, and are moved into the ranges of the joints.
 * @param {Open} shown
 * @param {Arm} arm
 * @param {LinkJoint[]} [joints]
 * @returns {{ document: ScenarioDocument, text: string }}  with what becomes of start and goal, in words
 */
export function withArm({ document, scenario }, arm, joints = jointsOf(arm)) {
  const robot = withJoints(arm, joints);
  const coordinates = coordinatesOf({ scenario, document: { ...document, robot } });
  let isMoved = false;
  const fit = (/** @type {number[]} */ pose) => {
    const inside = fitted(pose, coordinates);
    return coordinates.map(({ isCircle }, i) => {
      const value = pose[i] ?? 0;
      if (isCircle) return value;
      isMoved ||= inside[i] !== value;
      return inside[i];
    });
  };
  const queries = document.queries.map((query) => {
    const { translation, rotation } = query.goal_tolerance ?? {};
    const kept = {
      ...(translation !== undefined && joints.some(({ type }) => type === "prismatic") ? { translation } : {}),
      ...(rotation !== undefined && joints.some(({ type }) => type === "revolute") ? { rotation } : {}),
    };
    const goal_tolerance = Object.keys(kept).length > 0 ? kept : undefined;
    return changed(query, { start: fit(query.start), goal: query.goal && fit(query.goal), goal_tolerance });
  });
  const isLonger = document.robot.type === "arm" && arm.links.length > document.robot.links.length;
  const texts = [
    isLonger ? "New joints of start and goal are 0." : "",
    isMoved ? "Start and goal were moved into the range of the joint." : "",
  ];
  return { document: { ...document, robot, queries }, text: texts.filter(Boolean).join(" ") };
}

/** The arm with another number of links: new ones are as long as the last. @param {Arm} arm @param {number} count */
export function linked(arm, count) {
  const joints = jointsOf(arm);
  const links = Array.from({ length: count }, (_, i) => arm.links[i] ?? arm.links[arm.links.length - 1]);
  return {
    arm: { ...arm, links },
    joints: links.map((_, i) => joints[i] ?? { type: /** @type {const} */ ("revolute") }),
  };
}
