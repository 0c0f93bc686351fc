/** The handles of a body or a car: one at its reference point to move it, one in front of it to turn it. */

/** @import { Part, Point } from "../domain/types.js" */

/** The distance of the second handle, as a part of the farthest vertex's. */
const AHEAD = 1.5;

/**
 * @param {Part[]} parts  at the placement
 * @param {ArrayLike<number>} placement  x, y and theta
 * @returns {[Point, Point]}  metres
 */
export function placedHandles(parts, { 0: x, 1: y, 2: theta }) {
  const reach = Math.max(
    ...parts.flatMap((part) =>
      part.type === "polygon" ? part.vertices.map(([a, b]) => Math.hypot(a - x, b - y)) : [],
    ),
  );
  return [
    [x, y],
    [x + AHEAD * reach * Math.cos(theta), y + AHEAD * reach * Math.sin(theta)],
  ];
}
