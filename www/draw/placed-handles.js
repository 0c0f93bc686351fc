/** The handles of a body or a car: one at its reference point to move it, one in front of it to turn it. */

/** @import { View } from "planarium/draw" */
/** @import { Part } from "../domain/types.js" */

/** The distance of the second handle, as a part of the farthest vertex's. */
const AHEAD = 1.5;
/** The radius of a handle, CSS pixels. */
const RADIUS = 8;

/**
 * The place of a handle in front of something: nearer where the canvas ends.
 * @param {View} view
 * @param {ArrayLike<number>} placement  x, y and theta
 * @param {number} distance  CSS pixels
 * @returns {[x: number, y: number]}  CSS pixels
 */
export function handleAhead(view, placement, distance) {
  const from = view.place(placement);
  const direction = [Math.cos(placement[2]), -Math.sin(placement[2])];
  const rooms = [view.width, view.height].map((size, i) =>
    direction[i] === 0 ? Infinity : ((direction[i] > 0 ? size - RADIUS : RADIUS) - from[i]) / direction[i],
  );
  const near = Math.max(0, Math.min(distance, ...rooms));
  return [from[0] + near * direction[0], from[1] + near * direction[1]];
}

/**
 * @param {View} view
 * @param {Part[]} parts  at the placement
 * @param {ArrayLike<number>} placement  x, y and theta
 * @returns {[middle: [number, number], front: [number, number]]}  CSS pixels
 */
export function placedHandles(view, parts, placement) {
  const { 0: x, 1: y } = placement;
  const reach = Math.max(
    ...parts.flatMap((part) =>
      part.type === "polygon" ? part.vertices.map(([a, b]) => Math.hypot(a - x, b - y)) : [],
    ),
  );
  return [view.place(placement), handleAhead(view, placement, AHEAD * reach * view.scaleX)];
}
