/**
 * A robot that the pointer moves, by hand and in the editor: as a point of the configuration space; an arm by a link,
 * which turns or slides, or by its end effector, which it follows; a disc; a body, or its heading.
 */
import { wrap } from "planarium/draw";
import { distanceToSegment } from "../../draw/trace.js";
import { contained, coordinatesOf, directionsOf } from "../../domain/coordinates.js";
import { coreOf, encloses } from "../../domain/obstacles.js";

/** @import { View } from "planarium/draw" */
/** @import { CSpace } from "./cspace-pane.js" */
/** @import { Pane } from "./pane.js" */
/** @import { Coordinate, Obstacle, Part, Scenario } from "../../domain/types.js" */
/** @import { ArmRobot } from "../../domain/coordinates.js" */
/** @import { Shown } from "./lane.js" */
/**
 * @typedef {(x: number, y: number, shift: boolean) => Float64Array} Grip   the configuration for a position of the
 *   pointer in the plane
 */
/** @typedef {(value: number, unit: Coordinate["unit"], shift: boolean) => number} Snap   rounds a coordinate */

/** Radius of the mark of an end effector, CSS pixels. */
export const TIP = 8;

/**
 * Whether a part is the end effector of an arm: it counts as one more joint after the last.
 * @param {Scenario} scenario
 * @param {number | null} part
 */
export function isTip({ robot, dimension }, part) {
  return robot === "arm" && part === dimension;
}

/**
 * The part of a robot at a point of the workspace: a joint, after the last joint the end effector, 0 for the heading of
 * a body, or null for the whole robot.
 * @param {Pane} pane
 * @param {Shown} shown
 * @param {ArrayLike<number>} pose
 * @param {number} px
 * @param {number} py
 * @param {number} reach  CSS pixels
 * @param {number} [tip]   the same of the end effector
 * @returns {{ part: number | null, distance: number } | null}  with its distance in CSS pixels; null: none is within
 *   reach
 */
export function partAt(pane, { scenario, placed }, pose, px, py, reach, tip = Math.max(TIP, reach)) {
  const view = /** @type {View} */ (pane.view);
  const q = Float64Array.from(pose);
  const isNear = (/** @type {ArrayLike<number>} */ at, /** @type {number} */ within) =>
    Math.hypot(at[0] - px, at[1] - py) <= within;
  // The end effector is preferred to its link, and the handle to the body.
  if (scenario.robot === "arm" && isNear(pane.pixels(q), tip)) return { part: scenario.dimension, distance: 0 };
  if (placed && isNear(placed.handle(pose, view), reach)) return { part: 0, distance: 0 };
  const [x, y] = view.toPlane(px, py);
  // Where parts overlap, that counts in which the point is deepest.
  const distances = scenario.footprint(q).map((part) => distanceToShape(part, x, y) * view.scaleX);
  const distance = Math.min(...distances);
  return distance <= reach
    ? { part: placed ? null : distances.indexOf(distance), distance: Math.max(0, distance) }
    : null;
}

/**
 * Takes hold of a part of a robot.
 * @param {Shown} shown @param {ArrayLike<number>} pose @param {number | null} part
 * @param {CSpace | null} square   the pane, where it shows the configuration space
 * @param {ArrayLike<number>} from   the position of the pointer in the plane
 * @param {Snap} [snap]
 * @param {() => Scenario} [arm]   the current scenario, where each change frees the previous one
 * @returns {Grip}
 */
export function gripOf(
  shown,
  pose,
  part,
  square,
  { 0: x0, 1: y0 },
  snap = (value) => value,
  arm = () => shown.scenario,
) {
  const { scenario } = shown;
  const coordinates = coordinatesOf(shown);
  if (square) {
    return (x, y, shift) =>
      Float64Array.from(pose, (value, i) => {
        const { low, high, unit } = coordinates[i];
        const at = square.axes.indexOf(i);
        return at < 0 ? value : Math.min(high, Math.max(low, snap([x, y][at], unit, shift)));
      });
  }
  const start = Float64Array.from(pose);
  if (isTip(scenario, part)) {
    const [tx, ty] = scenario.endEffector(start);
    let now = start;
    return (x, y, shift) => {
      const { configuration } = arm().follow(now, [snap(tx + x - x0, "m", shift), snap(ty + y - y0, "m", shift)]);
      return (now = Float64Array.from(configuration));
    };
  }
  const link = scenario.robot === "arm" ? scenario.footprint(start)[part ?? 0] : null;
  if (link?.type !== "capsule" && !(shown.placed && part === 0)) {
    return (x, y, shift) => {
      const moved = [snap(start[0] + x - x0, "m", shift), snap(start[1] + y - y0, "m", shift)];
      return contained(Float64Array.of(...moved, ...start.slice(2)), coordinates);
    };
  }
  const slide = coordinates[part ?? 0];
  if (link?.type === "capsule" && slide.unit === "m") {
    // A link that slides follows the pointer along its direction.
    const directions = directionsOf(/** @type {ArmRobot} */ (shown.document.robot), start);
    const [c, s] = [Math.cos(directions[part ?? 0]), Math.sin(directions[part ?? 0])];
    return (x, y, shift) =>
      contained(start.with(part ?? 0, snap(start[part ?? 0] + (x - x0) * c + (y - y0) * s, "m", shift)), coordinates);
  }
  // A joint or a heading turns with the pointer.
  const [turning, [cx, cy]] = link?.type === "capsule" ? [part ?? 0, link.a] : [2, start];
  let before = Math.atan2(y0 - cy, x0 - cx);
  let angle = start[turning];
  return (x, y, shift) => {
    const now = Math.atan2(y - cy, x - cx);
    angle += wrap(now - before);
    before = now;
    return contained(start.with(turning, snap(angle, "rad", shift)), coordinates);
  };
}

/**
 * The distance from a point to an obstacle or a part of a robot, 0 or less inside.
 * @param {Obstacle | Part} shape
 * @param {number} x
 * @param {number} y
 */
export function distanceToShape(shape, x, y) {
  if (shape.type === "polygon" && encloses(shape, x, y)) return 0;
  const { segments, radius } = coreOf(shape);
  return segments.reduce((least, [a, b]) => Math.min(least, distanceToSegment(x, y, a, b)), Infinity) - radius;
}
