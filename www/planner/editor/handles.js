/** Hit testing: handles of the selection, start, goal, obstacles and the bounds. */
import { TIP, distanceToShape, partAt } from "../stage/grip.js";
import { linesOf } from "../../domain/obstacles.js";
import { gripAt, gripsOf } from "./bounds.js";
import { boundsOf, objectsOf, obstacleOf, poseOf, same, targetOf } from "./objects.js";
import { hasEdge, middle } from "./parts.js";

/** @import { Pane } from "../stage/pane.js" */
/** @import { View } from "planarium/draw" */
/** @import { Obstacle, Point, ScenarioDocument } from "../../domain/types.js" */
/** @import { Shown } from "../stage/lane.js" */
/** @import { Grip } from "./bounds.js" */
/** @import { EditorObject } from "./objects.js" */
/**
 * @typedef {object} Handle
 * @property {"vertex" | "middle" | "radius" | "edges"} kind
 * @property {number} part       the vertex, or the one before a middle
 * @property {Point} at
 * @property {number[]} [edges]  of the bounds
 */
/**
 * @typedef {{ object: EditorObject, part: number | null, handle: Handle | null }} Hit   `part`: the vertex, the joint,
 *   after the last joint the end effector, the heading of a body, or the edge of the bounds
 */

/** Reach of a pointer, CSS pixels. */
export const REACH = { mouse: 9, touch: 22 };
/** Least length of an edge with a handle in its middle, CSS pixels. */
const ROOM = 40;

/**
 * The handles of an obstacle or of the bounds; none of anything else.
 * @param {ScenarioDocument} document @param {EditorObject | null} object @param {View} view
 * @returns {Handle[]}
 */
export function handlesFor(document, object, view) {
  const obstacle = obstacleOf(document, object);
  if (obstacle) return handlesOf(obstacle, view);
  const bounds = boundsOf(document, object);
  return bounds ? gripsOf(bounds).map(edgesHandle) : [];
}

/** @param {Obstacle} obstacle @param {View} view @returns {Handle[]} */
function handlesOf(obstacle, view) {
  if (obstacle.type === "disc")
    return [{ kind: "radius", part: 0, at: [obstacle.center[0] + obstacle.radius, obstacle.center[1]] }];
  /** @type {Handle[]} */
  const vertices = [];
  /** @type {Handle[]} */
  const middles = [];
  let first = 0;
  for (const { points, isClosed } of linesOf(obstacle)) {
    for (const [i, point] of points.entries()) {
      const place = { points, isClosed, line: 0, at: i };
      const at = middle(place);
      const length = 2 * Math.hypot(at[0] - point[0], at[1] - point[1]) * view.scaleX;
      vertices.push({ kind: "vertex", part: first + i, at: point });
      if (hasEdge(place) && length > ROOM) middles.push({ kind: "middle", part: first + i, at });
    }
    first += points.length;
  }
  return [...vertices, ...middles];
}

/** @param {Grip} grip @returns {Handle} */
function edgesHandle({ edges, at }) {
  return { kind: "edges", part: 0, at, edges };
}

/** The part that an object has under a handle. @param {Handle} handle */
export function partOf({ kind, part, edges }) {
  if (kind === "edges") return edges?.length === 1 ? edges[0] : null;
  return kind === "vertex" ? part : null;
}

/**
 * @param {Pane} pane @param {boolean} isSquare  whether it shows the configuration space
 * @param {Shown} shown @param {string | undefined} query @param {EditorObject | null} selected
 * @param {number} px @param {number} py @param {number} reach  CSS pixels
 * @returns {Hit | null}
 */
export function hitAt(pane, isSquare, shown, query, selected, px, py, reach) {
  const view = /** @type {View} */ (pane.view);
  const { document } = shown;
  const [x, y] = view.toPlane(px, py);
  const distanceTo = (/** @type {ArrayLike<number>} */ at) => Math.hypot(at[0] - px, at[1] - py);
  /** @type {Hit | null} */
  let best = null;
  let least = reach;
  /**
   * Of several equally near objects the last one is taken.
   * @param {EditorObject} object
   * @param {number} distance  0 or less inside
   * @param {number | null} [part]
   * @param {Handle | null} [handle]
   */
  const offer = (object, distance, part = null, handle = null) => {
    if (distance > least) return;
    least = Math.max(0, distance);
    best = { object, part, handle };
  };
  if (selected && !isSquare) {
    for (const handle of handlesFor(document, selected, view)) {
      // A vertex is preferred to a middle.
      offer(selected, distanceTo(view.place(handle.at)) + (handle.kind === "middle" ? 3 : 0), partOf(handle), handle);
    }
    if (best) return best;
  }
  // Robots are above obstacles, the start is above the goal, and the selection is above all.
  const rank = (/** @type {EditorObject} */ object) =>
    same(object, selected) ? 4 : ["bounds", "obstacle", "goal", "start"].indexOf(object.kind);
  for (const object of objectsOf(document, query).sort((a, b) => rank(a) - rank(b))) {
    const obstacle = obstacleOf(document, object);
    const target = targetOf(document, object);
    const pose = poseOf(document, object);
    const bounds = boundsOf(document, object);
    if (isSquare) {
      if (pose) offer(object, distanceTo(pane.pixels(Float64Array.from(pose))) - 7);
      continue;
    }
    if (bounds) {
      const grip = gripAt(bounds, [x, y], reach / view.scaleX);
      const handle = grip && edgesHandle(grip);
      if (handle) offer(object, reach, partOf(handle), handle);
    }
    if (obstacle) offer(object, distanceToShape(obstacle, x, y) * view.scaleX);
    if (target) offer(object, distanceTo(view.place(target.point)) - TIP);
    const hit = pose && partAt(pane, shown, pose, px, py, reach);
    if (hit) offer(object, hit.distance, hit.part);
  }
  return best;
}
