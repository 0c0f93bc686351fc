/**
 * Gestures: functions from the position of the pointer to a document. Shift snaps points to fifths of the grid, joints and directions to
 * 15 degrees, and rectangles to squares.
 */
import { wrap } from "planarium/draw";
import { contained, coordinatesOf } from "../../domain/coordinates.js";
import { isTip, followTip } from "./end-effector.js";
import { moved, obstacleOf, rectangle, rounded, targetOf, withObstacle, withPose, withTarget, withVertex } from "./objects.js";

/** @import { CSpace } from "../stage/cspace-pane.js" */
/** @import { Obstacle, Scenario, ScenarioDocument } from "../../domain/types.js" */
/** @import { Shown } from "../lane.js" */
/** @import { Hit } from "./handles.js" */
/** @import { Point, EditorObject } from "./objects.js" */
/** @typedef {(x: number, y: number, shift: boolean) => ScenarioDocument} Gesture   the pointer in coordinates of the pane's plane */

/**
 * @typedef {object} Scale
 * @property {number} unit   of rounding, metres
 * @property {number} grid   for Shift, metres
 * @property {number} pixels   CSS pixels a metre
 */

/** Units of angles for rounding and for Shift, radians. */
export const ANGLE = 1e-4;
const TURN = Math.PI / 12;

/** @param {number} value @param {number} step @param {number} unit @param {boolean} shift */
function snapped(value, step, unit, shift) {
  return rounded(shift ? Math.round(value / step) * step : value, unit);
}

/** A point, rounded or on the grid. @param {Scale} scale @param {number} x @param {number} y @param {boolean} shift @returns {Point} */
export function pointAt({ unit, grid }, x, y, shift) {
  return [snapped(x, grid, unit, shift), snapped(y, grid, unit, shift)];
}

/** A point, with Shift in a direction from another that is a multiple of 15 degrees. @param {Scale} scale @param {Point | undefined} from @param {number} x @param {number} y @param {boolean} shift @returns {Point} */
export function pointFrom(scale, from, x, y, shift) {
  if (!shift || !from) return pointAt(scale, x, y, shift);
  const angle = Math.round(Math.atan2(y - from[1], x - from[0]) / TURN) * TURN;
  const along = (x - from[0]) * Math.cos(angle) + (y - from[1]) * Math.sin(angle);
  return pointAt(scale, from[0] + along * Math.cos(angle), from[1] + along * Math.sin(angle), false);
}

/** Moves the object under the pointer. @param {Shown} shown @param {Hit} hit @param {Scale} scale @param {CSpace | null} square @param {Point} from @param {() => Scenario} arm   the current one @returns {Gesture} */
export function moveGesture(shown, { object, part, handle }, scale, square, [x0, y0], arm) {
  const { document, scenario, start, goal, placed } = shown;
  const obstacle = obstacleOf(document, object);
  if (obstacle) return reshapeGesture(document, obstacle, object, handle, scale, x0, y0);
  const target = targetOf(document, object);
  if (target) {
    const [tx, ty] = target.point;
    return (x, y, shift) => withTarget(document, object, { ...target, point: pointAt(scale, tx + x - x0, ty + y - y0, shift) });
  }
  const pose = Array.from((object.kind === "start" ? start : goal) ?? []);
  const coordinates = coordinatesOf({ scenario, document });
  /** @param {number[]} next */
  const put = (next) => withPose(document, object, contained(Float64Array.from(next), coordinates));
  if (square) {
    const { axes } = square;
    return (x, y, shift) => put(pose.map((value, i) => {
      const at = axes.indexOf(i);
      if (at < 0) return value;
      return coordinates[i].unit === "m" ? snapped([x, y][at], scale.grid, scale.unit, shift) : snapped([x, y][at], TURN, ANGLE, shift);
    }));
  }
  if (placed && part === 0) {
    // The handle turns the body with the pointer.
    const off = pose[2] - Math.atan2(y0 - pose[1], x0 - pose[0]);
    return (x, y, shift) => put(pose.with(2, snapped(Math.atan2(y - pose[1], x - pose[0]) + off, TURN, ANGLE, shift)));
  }
  if (placed) return (x, y, shift) => put([...pointAt(scale, pose[0] + x - x0, pose[1] + y - y0, shift), pose[2]]);
  if (scenario.robot === "disc") return (x, y, shift) => put(pointAt(scale, pose[0] + x - x0, pose[1] + y - y0, shift));
  if (isTip(scenario, object, part)) {
    const lead = followTip(shown, object, pose, arm);
    return (x, y, shift) => lead(pointAt(scale, x, y, shift));
  }
  const joint = part ?? 0;
  const link = scenario.footprint(pose)[joint];
  if (link.type !== "capsule") return () => document;
  const [bx, by] = link.a;
  let before = Math.atan2(y0 - by, x0 - bx);
  let turned = 0;
  return (x, y, shift) => {
    const now = Math.atan2(y - by, x - bx);
    turned += wrap(now - before);
    before = now;
    return put(pose.with(joint, snapped(pose[joint] + turned, TURN, ANGLE, shift)));
  };
}

/** @param {ScenarioDocument} document @param {Obstacle} obstacle @param {EditorObject} object @param {Hit["handle"]} handle @param {Scale} scale @param {number} x0 @param {number} y0 @returns {Gesture} */
function reshapeGesture(document, obstacle, { index }, handle, scale, x0, y0) {
  /** @param {Obstacle} next */
  const put = (next) => withObstacle(document, index, next);
  if (obstacle.type === "disc" && handle) {
    const [cx, cy] = obstacle.center;
    return (x, y, shift) => put({ ...obstacle, radius: snapped(Math.hypot(x - cx, y - cy), scale.grid, scale.unit, shift) });
  }
  if (obstacle.type === "polygon" && handle) {
    const added = handle.kind === "middle";
    return (x, y, shift) => put(withVertex(obstacle, handle.part + (added ? 1 : 0), pointAt(scale, x, y, shift), added));
  }
  const [ax, ay] = obstacle.type === "disc" ? obstacle.center : obstacle.vertices[0];
  return (x, y, shift) => {
    const [nx, ny] = pointAt(scale, ax + x - x0, ay + y - y0, shift);
    return put(moved(obstacle, nx - ax, ny - ay, scale.unit));
  };
}

/** Draws a disc from its centre, or a rectangle from corner to corner. @param {"disc" | "rectangle"} tool @param {ScenarioDocument} document @param {Scale} scale @param {Point} from @param {boolean} snaps  whether its first point is on the grid @returns {Gesture} */
export function drawGesture(tool, document, scale, from, snaps) {
  const [x0, y0] = pointAt(scale, ...from, snaps && tool === "disc");
  const { length } = document.world.obstacles;
  return (x, y, shift) => {
    if (tool === "disc") return withObstacle(document, length, { type: "disc", center: [x0, y0], radius: snapped(Math.hypot(x - x0, y - y0), scale.grid, scale.unit, shift) });
    let [width, height] = pointAt(scale, x - x0, y - y0, false);
    if (shift) {
      const side = Math.max(Math.abs(width), Math.abs(height));
      [width, height] = [Math.sign(width) * side, Math.sign(height) * side];
    }
    return withObstacle(document, length, moved(rectangle([x0 + width / 2, y0 + height / 2], Math.abs(width), Math.abs(height)), 0, 0, scale.unit));
  };
}
