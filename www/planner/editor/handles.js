/** Hit testing: handles of the selection, start, goal and obstacles. */
import { TIP, distanceToShape, partAt } from "../stage/grip.js";
import { middle, objectsOf, obstacleOf, poseOf, same, targetOf } from "./objects.js";

/** @import { Pane } from "../stage/pane.js" */
/** @import { View } from "planarium/draw" */
/** @import { Obstacle, Point } from "../../domain/types.js" */
/** @import { Shown } from "../stage/lane.js" */
/** @import { EditorObject } from "./objects.js" */
/**
 * @typedef {{ kind: "vertex" | "middle" | "radius", part: number, at: Point }} Handle   `part`: the vertex, or the one
 *   before a middle
 */
/**
 * @typedef {{ object: EditorObject, part: number | null, handle: Handle | null }} Hit   `part`: the vertex, the joint,
 *   after the last joint the end effector, or the heading of a body
 */

/** Reach of a pointer, CSS pixels. */
export const REACH = { mouse: 9, touch: 22 };
/** Least length of an edge with a handle in its middle, CSS pixels. */
const ROOM = 40;

/** @param {Obstacle} obstacle @param {View} view @returns {Handle[]} */
export function handlesOf(obstacle, view) {
  if (obstacle.type === "disc")
    return [{ kind: "radius", part: 0, at: [obstacle.center[0] + obstacle.radius, obstacle.center[1]] }];
  const { vertices } = obstacle;
  const middles = vertices.map((_, part) => ({
    kind: /** @type {const} */ ("middle"),
    part,
    at: middle(vertices, part),
  }));
  return [
    ...vertices.map((at, part) => ({ kind: /** @type {const} */ ("vertex"), part, at })),
    ...middles.filter(
      ({ part, at }) => 2 * Math.hypot(at[0] - vertices[part][0], at[1] - vertices[part][1]) * view.scaleX > ROOM,
    ),
  ];
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
  const chosen = obstacleOf(document, selected);
  if (chosen && selected && !isSquare) {
    for (const handle of handlesOf(chosen, view)) {
      const { kind, part, at } = handle;
      // A vertex is preferred to a middle.
      offer(
        selected,
        distanceTo(view.place(at)) + (kind === "middle" ? 3 : 0),
        kind === "vertex" ? part : null,
        handle,
      );
    }
    if (best) return best;
  }
  // Robots are above obstacles, the start is above the goal, and the selection is above all.
  const rank = (/** @type {EditorObject} */ object) =>
    same(object, selected) ? 3 : ["obstacle", "goal", "start"].indexOf(object.kind);
  for (const object of objectsOf(document, query).sort((a, b) => rank(a) - rank(b))) {
    const obstacle = obstacleOf(document, object);
    const target = targetOf(document, object);
    const pose = poseOf(document, object);
    if (isSquare) {
      if (pose) offer(object, distanceTo(pane.pixels(Float64Array.from(pose))) - 7);
      continue;
    }
    if (obstacle) offer(object, distanceToShape(obstacle, x, y) * view.scaleX);
    if (target) offer(object, distanceTo(view.place(target.point)) - TIP);
    const hit = pose && partAt(pane, shown, pose, px, py, reach);
    if (hit) offer(object, hit.distance, hit.part);
  }
  return best;
}
