/** Hit testing: handles of the selection, start, goal and obstacles. */
import { distanceToSegment } from "../../draw/trace.js";
import { contains } from "../../draw/shapes.js";
import { obstacleOf, same, targetOf, objectsOf } from "./objects.js";

/** @import { Pane } from "../stage/pane.js" */
/** @import { View } from "planarium/draw" */
/** @import { Obstacle, Part } from "../../domain/types.js" */
/** @import { Shown } from "../lane.js" */
/** @import { Point, EditorObject } from "./objects.js" */
/** @typedef {{ kind: "vertex" | "middle" | "radius", part: number, at: Point }} Handle   `part`: the vertex, or the one before a middle */
/** @typedef {{ object: EditorObject, part: number | null, handle: Handle | null }} Hit   `part`: the vertex, the joint, or after the last joint the end effector */

/** Reach of a pointer, CSS pixels. */
export const REACH = { mouse: 9, touch: 22 };
/** Radius of the mark of an end effector, CSS pixels. */
const TIP = 8;
/** Least length of an edge with a handle in its middle, CSS pixels. */
const ROOM = 40;

/** @param {Obstacle} obstacle @param {View} view @returns {Handle[]} */
export function handlesOf(obstacle, view) {
  if (obstacle.type === "disc") return [{ kind: "radius", part: 0, at: [obstacle.center[0] + obstacle.radius, obstacle.center[1]] }];
  const { vertices } = obstacle;
  /** @type {Handle[]} */
  const handles = vertices.map((at, part) => ({ kind: "vertex", part, at }));
  vertices.forEach(([x, y], part) => {
    const [nx, ny] = vertices[(part + 1) % vertices.length];
    if (Math.hypot(nx - x, ny - y) * view.scaleX > ROOM) handles.push({ kind: "middle", part, at: [(x + nx) / 2, (y + ny) / 2] });
  });
  return handles;
}

/**
 * @param {Pane} pane @param {boolean} isSquare  whether it shows the configuration space
 * @param {Shown} shown @param {string | undefined} query @param {EditorObject | null} selected
 * @param {number} px @param {number} py @param {number} reach  CSS pixels
 * @returns {Hit | null}
 */
export function hitAt(pane, isSquare, shown, query, selected, px, py, reach) {
  const view = /** @type {View} */ (pane.view);
  const { document, scenario } = shown;
  /** @type {Hit | null} */
  let best = null;
  let least = reach;
  /** @param {number} distance @param {Hit} hit  of several equally near the last one is taken */
  const offer = (distance, hit) => {
    if (distance > least) return;
    least = distance;
    best = hit;
  };
  const chosen = obstacleOf(document, selected);
  if (chosen && selected && !isSquare) {
    for (const handle of handlesOf(chosen, view)) {
      const distance = Math.hypot(view.x(handle.at[0]) - px, view.y(handle.at[1]) - py);
      // A vertex is preferred to a middle.
      offer(distance + (handle.kind === "middle" ? 3 : 0), { object: selected, part: handle.kind === "radius" ? null : handle.part, handle });
    }
    if (best) return best;
  }
  const objects = objectsOf(document, query);
  // Robots are above obstacles, the start is above the goal, and the selection is above all.
  const order = [...objects.filter(({ kind }) => kind === "obstacle"), ...objects.filter(({ kind }) => kind !== "obstacle").reverse()];
  const at = order.findIndex((object) => same(object, selected));
  if (at >= 0) order.push(...order.splice(at, 1));
  const [x, y] = view.toPlane(px, py);
  for (const object of order) {
    const obstacle = obstacleOf(document, object);
    if (obstacle) {
      if (!isSquare) offer(distanceTo(obstacle, x, y) * view.scaleX, { object, part: null, handle: null });
      continue;
    }
    const target = targetOf(document, object);
    if (target && !isSquare) offer(Math.max(0, Math.hypot(view.x(target.point[0]) - px, view.y(target.point[1]) - py) - TIP), { object, part: null, handle: null });
    const pose = object.kind === "start" ? shown.start : shown.goal;
    if (!pose) continue;
    if (isSquare) {
      const [ex, ey] = pane.pixels(Float64Array.from(pose));
      offer(Math.max(0, Math.hypot(ex - px, ey - py) - 7), { object, part: null, handle: null });
    } else {
      const { placed } = shown;
      scenario.footprint(pose).forEach((part, i) => offer(Math.max(0, toPart(part, x, y) * view.scaleX), { object, part: placed ? null : i, handle: null }));
      if (scenario.robot === "arm") {
        const [ex, ey] = pane.pixels(Float64Array.from(pose));
        // The end effector is preferred to its link.
        if (Math.hypot(ex - px, ey - py) <= Math.max(TIP, reach)) offer(0, { object, part: scenario.dimension, handle: null });
      }
      if (!placed) continue;
      const [hx, hy] = placed.handle(pose, view);
      // The handle is preferred to the body.
      if (Math.hypot(hx - px, hy - py) <= reach) offer(0, { object, part: 0, handle: null });
    }
  }
  return best;
}

/** The distance from a point to a filled obstacle, 0 inside. @param {Obstacle} obstacle @param {number} x @param {number} y */
function distanceTo(obstacle, x, y) {
  if (obstacle.type === "disc") return Math.max(0, Math.hypot(x - obstacle.center[0], y - obstacle.center[1]) - obstacle.radius);
  const { vertices } = obstacle;
  return contains(vertices, x, y) ? 0 : Math.min(...vertices.map((vertex, i) => distanceToSegment(x, y, vertex, vertices[(i + 1) % vertices.length])));
}

/** @param {Part} part @param {number} x @param {number} y */
function toPart(part, x, y) {
  if (part.type === "polygon") return distanceTo(part, x, y);
  return (part.type === "disc" ? Math.hypot(x - part.center[0], y - part.center[1]) : distanceToSegment(x, y, part.a, part.b)) - part.radius;
}
