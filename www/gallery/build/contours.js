/** The obstacles of a configuration space as outlines, for pictures without pixels. */
import { soften } from "../../draw/mask.js";

/** Depth of the outline in the softened mask, as on the pages. */
const LEVEL = 0.42;

/**
 * Adds the outlines of a mask to the path, with the inside on one hand, so that a fill leaves holes empty (marching
 * squares: Lorensen and Cline 1987, in the plane).
 * @param {CanvasRenderingContext2D} context
 * @param {Uint8Array} bytes  1 is collision; rows from the lowest angles @param {number} side  cells
 * @param {(x: number, y: number) => [number, number]} place  from parts of the square, 0 to 1, to the canvas
 */
export function traceContours(context, bytes, side, place) {
  const mask = soften(bytes, side);
  const valueAt = (/** @type {number} */ i, /** @type {number} */ j) =>
    i < 0 || j < 0 || i >= side || j >= side ? 0 : mask[j * side + i];
  /**
   * Where an outline leaves each side of a cell, by where it enters.
   * @type {Map<string, [x: number, y: number, next: string]>}
   */
  const pieces = new Map();
  for (let j = -1; j < side; j++) {
    for (let i = -1; i < side; i++) {
      // Corners counter-clockwise from the lower left, and the sides after them: bottom, right, top, left.
      const corners = [valueAt(i, j), valueAt(i + 1, j), valueAt(i + 1, j + 1), valueAt(i, j + 1)];
      const ends = /** @type {const} */ ([
        [i, j],
        [i + 1, j],
        [i + 1, j + 1],
        [i, j + 1],
      ]);
      const names = [`h${i},${j}`, `v${i + 1},${j}`, `h${i},${j + 1}`, `v${i},${j}`];
      const isIn = corners.map((value) => value > LEVEL);
      // An outline enters through a side that leads into the obstacle and leaves through the next that leads out of it.
      for (let enter = 0; enter < 4; enter++) {
        if (isIn[enter] || !isIn[(enter + 1) % 4]) continue;
        let leave = (enter + 1) % 4;
        while (!isIn[leave] || isIn[(leave + 1) % 4]) leave = (leave + 1) % 4;
        const [a, b] = [corners[enter], corners[(enter + 1) % 4]];
        const part = (LEVEL - a) / (b - a);
        const [from, to] = [ends[enter], ends[(enter + 1) % 4]];
        pieces.set(names[enter], [
          from[0] + part * (to[0] - from[0]),
          from[1] + part * (to[1] - from[1]),
          names[leave],
        ]);
      }
    }
  }
  for (let [first] = pieces.keys(); first !== undefined; [first] = pieces.keys()) {
    let name = first;
    for (let piece = pieces.get(name), isFirst = true; piece; piece = pieces.get(name), isFirst = false) {
      pieces.delete(name);
      const [px, py] = place(...inSquare(piece[0], piece[1], side));
      context[isFirst ? "moveTo" : "lineTo"](px, py);
      name = piece[2];
    }
    context.closePath();
  }
}

/**
 * Parts of the square of a point between the middles of cells.
 * @param {number} x
 * @param {number} y
 * @param {number} side
 * @returns {[number, number]}
 */
function inSquare(x, y, side) {
  return [Math.min(1, Math.max(0, (x + 0.5) / side)), Math.min(1, Math.max(0, (y + 0.5) / side))];
}
