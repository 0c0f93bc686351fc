/**
 * Gestures: functions from the position of the pointer to a document. Shift snaps points to fifths of the grid, joints
 * and directions to 15 degrees, and rectangles to squares.
 */
import { gripOf, isTip } from "../stage/grip.js";
import { rectangle } from "./additions.js";
import { edgesOf, withEdges } from "./bounds.js";
import { boundsOf, obstacleOf, poseOf, targetOf, withObstacle, withPose, withTarget } from "./objects.js";
import { anchorOf, moved, withPoint } from "./parts.js";
import { ANGLE, fine, rounded } from "./units.js";

/** @import { Snap } from "../stage/grip.js" */
/** @import { CSpace } from "../stage/cspace-pane.js" */
/** @import { Obstacle, Point, Scenario, ScenarioDocument } from "../../domain/types.js" */
/** @import { Shown } from "../stage/lane.js" */
/** @import { Hit } from "./handles.js" */
/**
 * @typedef {(x: number, y: number, shift: boolean) => ScenarioDocument} Gesture   the pointer in coordinates of the
 *   pane's plane
 */

/**
 * @typedef {object} Scale
 * @property {number} unit   of rounding, metres
 * @property {number} grid   for Shift, metres
 * @property {number} pixels   CSS pixels a metre
 */

/** The unit of angles for Shift, radians. */
const TURN = Math.PI / 12;

/** @param {number} value @param {number} step @param {number} unit @param {boolean} shift */
function snapped(value, step, unit, shift) {
  return rounded(shift ? Math.round(value / step) * step : value, unit);
}

/**
 * A point, rounded or on the grid.
 * @param {Scale} scale
 * @param {number} x
 * @param {number} y
 * @param {boolean} shift
 * @returns {Point}
 */
export function pointAt({ unit, grid }, x, y, shift) {
  return [snapped(x, grid, unit, shift), snapped(y, grid, unit, shift)];
}

/**
 * A point, with Shift in a direction from another that is a multiple of 15 degrees.
 * @param {Scale} scale
 * @param {Point | undefined} from
 * @param {number} x
 * @param {number} y
 * @param {boolean} shift
 * @returns {Point}
 */
export function pointFrom(scale, from, x, y, shift) {
  if (!shift || !from) return pointAt(scale, x, y, shift);
  const angle = Math.round(Math.atan2(y - from[1], x - from[0]) / TURN) * TURN;
  const along = (x - from[0]) * Math.cos(angle) + (y - from[1]) * Math.sin(angle);
  return pointAt(scale, from[0] + along * Math.cos(angle), from[1] + along * Math.sin(angle), false);
}

/**
 * Moves the object under the pointer.
 * @param {Shown} shown
 * @param {Hit} hit
 * @param {Scale} scale
 * @param {CSpace | null} square
 * @param {Point} from
 * @param {() => Scenario} arm   the current one
 * @returns {Gesture}
 */
export function moveGesture(shown, { object, part, handle }, scale, square, [x0, y0], arm) {
  const { document, scenario } = shown;
  const obstacle = obstacleOf(document, object);
  const replace = (/** @type {Obstacle} */ next) => withObstacle(document, object.index, next);
  if (obstacle?.type === "disc" && handle) {
    const [cx, cy] = obstacle.center;
    return (x, y, shift) =>
      replace({ ...obstacle, radius: snapped(Math.hypot(x - cx, y - cy), scale.grid, scale.unit, shift) });
  }
  /**
   * Moves a point with the pointer.
   * @param {ArrayLike<number>} anchor
   * @param {(point: Point) => ScenarioDocument} put
   * @returns {Gesture}
   */
  const carry = (anchor, put) => (x, y, shift) => put(pointAt(scale, anchor[0] + x - x0, anchor[1] + y - y0, shift));
  if (obstacle && handle) {
    const isAdded = handle.kind === "middle";
    return carry(handle.at, (point) => replace(withPoint(obstacle, handle.part + Number(isAdded), point, isAdded)));
  }
  if (obstacle) {
    const [ax, ay] = anchorOf(obstacle);
    return carry([ax, ay], ([x, y]) => replace(moved(obstacle, x - ax, y - ay, scale.unit)));
  }
  const bounds = boundsOf(document, object);
  if (bounds) {
    const edges = edgesOf(bounds);
    return carry(handle?.at ?? [x0, y0], (point) =>
      withEdges(
        document,
        edges.map((value, i) => (handle?.edges?.includes(i) ? point[i % 2] : value)),
      ),
    );
  }
  const target = targetOf(document, object);
  if (target) return carry(target.point, (point) => withTarget(document, object, { ...target, point }));
  const pose = /** @type {number[]} */ (poseOf(document, object));
  /** @type {Snap} */
  const snap = (value, unit, shift) =>
    unit === "m" ? snapped(value, scale.grid, scale.unit, shift) : snapped(value, TURN, ANGLE, shift);
  const hold = gripOf(shown, pose, part, square, [x0, y0], snap, arm);
  const roundTip = isTip(scenario, part) ? fine : (/** @type {Float64Array} */ q) => q;
  return (x, y, shift) => withPose(document, object, roundTip(hold(x, y, shift)));
}

/**
 * Draws a disc from its centre, or a rectangle from corner to corner.
 * @param {"disc" | "rectangle"} tool
 * @param {ScenarioDocument} document
 * @param {Scale} scale
 * @param {Point} from
 * @param {boolean} snaps  whether its first point is on the grid
 * @returns {Gesture}
 */
export function drawGesture(tool, document, scale, from, snaps) {
  const [x0, y0] = pointAt(scale, ...from, snaps && tool === "disc");
  const { length } = document.world.obstacles;
  return (x, y, shift) => {
    if (tool === "disc")
      return withObstacle(document, length, {
        type: "disc",
        center: [x0, y0],
        radius: snapped(Math.hypot(x - x0, y - y0), scale.grid, scale.unit, shift),
      });
    let [width, height] = pointAt(scale, x - x0, y - y0, false);
    if (shift) {
      const side = Math.max(Math.abs(width), Math.abs(height));
      [width, height] = [Math.sign(width) * side, Math.sign(height) * side];
    }
    return withObstacle(
      document,
      length,
      moved(rectangle([x0 + width / 2, y0 + height / 2], Math.abs(width), Math.abs(height)), 0, 0, scale.unit),
    );
  };
}
