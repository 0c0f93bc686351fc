/** Changes by keys and fields: small moves, new vertices, new obstacles. */
import { contained, coordinatesOf } from "../../domain/coordinates.js";
import { ANGLE } from "./gestures.js";
import { isTip, followTip, tipOf } from "./end-effector.js";
import { moved, obstacleOf, poseOf, rectangle, rounded, targetOf, withObstacle, withPose, withTarget, withVertex } from "./objects.js";

/** @import { EditTool, Obstacle, ScenarioDocument } from "../../domain/types.js" */
/** @import { Shown } from "../lane.js" */
/** @import { Point, EditorObject } from "./objects.js" */

/** Radii around the middle at which new obstacles are tried, as parts of the world, and directions in which copies are. */
const RINGS = [0, 0.12, 0.24, 0.36, 0.46];
const BESIDE = [[1, -1], [1, 1], [-1, 1], [-1, -1], [2, 0], [-2, 0], [0, 2], [0, -2]];

/** Moves an object by a hundred units, or a joint or heading by a degree. @param {Shown} shown @param {EditorObject} object @param {number | null} part @param {number} dx @param {number} dy @param {number} unit @returns {ScenarioDocument} */
export function nudged(shown, object, part, dx, dy, unit) {
  const { document, scenario } = shown;
  const step = 100 * unit;
  const pose = poseOf(document, object);
  const target = targetOf(document, object);
  if (target) {
    const [x, y] = target.point;
    return withTarget(document, object, { ...target, point: [rounded(x + dx * step, unit), rounded(y + dy * step, unit)] });
  }
  if (pose && isTip(scenario, object, part)) {
    const [x, y] = tipOf(scenario, pose);
    return followTip(shown, object, pose)([x + dx * step, y + dy * step]);
  }
  if (pose) {
    const angle = scenario.robot === "arm" ? part ?? 0 : part === null ? -1 : 2;
    const next = angle < 0 || scenario.robot === "disc"
      ? [rounded(pose[0] + dx * step, unit), rounded(pose[1] + dy * step, unit), ...pose.slice(2)]
      : pose.with(angle, rounded(pose[angle] + ((dx + dy) * Math.PI) / 180, ANGLE));
    return withPose(document, object, contained(Float64Array.from(next), coordinatesOf(shown)));
  }
  const obstacle = obstacleOf(document, object);
  if (!obstacle) return document;
  const all = moved(obstacle, dx * step, dy * step, unit);
  const one = obstacle.type === "polygon" && all.type === "polygon" && part !== null ? withVertex(obstacle, part, all.vertices[part]) : all;
  return withObstacle(document, object.index, one);
}

/** The middle of the edge after a vertex. @param {Point[]} vertices @param {number} index @param {number} unit @returns {Point} */
export function middle(vertices, index, unit) {
  const [x, y] = vertices[index];
  const [nx, ny] = vertices[(index + 1) % vertices.length];
  return [rounded((x + nx) / 2, unit), rounded((y + ny) / 2, unit)];
}

/** Copies of an obstacle beside it. @param {Obstacle} obstacle @param {number} size  of the world @param {number} unit @returns {Obstacle[]} */
export function copies(obstacle, size, unit) {
  return BESIDE.map(([x, y]) => moved(obstacle, (x * size) / 16, (y * size) / 16, unit));
}

/** The obstacle that a tool adds without a drag. @param {EditTool} tool @param {Point} at @param {number} size @param {number} unit @returns {Obstacle} */
export function simple(tool, [x, y], size, unit) {
  const side = rounded(size / 12, unit);
  const half = rounded(side / 2, unit);
  if (tool === "disc") return moved({ type: "disc", center: [0, 0], radius: half }, x, y, unit);
  return moved(tool === "rectangle" ? rectangle([0, 0], side, side) : { type: "polygon", vertices: [[-half, -half], [half, -half], [0, half]] }, x, y, unit);
}

/** Positions for a new obstacle, from the middle of the world outwards. @param {Shown} shown @param {number} size @returns {Point[]} */
export function places({ scenario }, size) {
  const { min, max } = scenario.extent();
  return RINGS.flatMap((part) => [1, 3, 5, 7].map((turn) => /** @type {Point} */ ([
    (min[0] + max[0]) / 2 + part * size * Math.cos((turn * Math.PI) / 4),
    (min[1] + max[1]) / 2 + part * size * Math.sin((turn * Math.PI) / 4),
  ])));
}
