/** The obstacles of a configuration space as outlines, sharp at any size. */
import { soften } from "./mask.js";

/** @import { Palette } from "../app/palette.js" */
/** Closed lines, as parts of the square: x and y in turn, 0 to 1, y upwards. @typedef {number[][]} Contours */

/** Depth of the outline in the softened mask. */
const LEVEL = 0.42;
/** The corners of a cell, counter-clockwise from the lower left; the side after each: bottom, right, top, left. */
const CORNERS = /** @type {const} */ ([
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
]);

/**
 * The outlines of a mask, with the inside on one hand, so that a fill leaves holes empty (marching squares: Lorensen and
 * Cline 1987, in the plane).
 * @param {Uint8Array} bytes  1 is collision; rows from the lowest angles
 * @param {number} side  cells
 * @returns {Contours}
 */
export function contoursOf(bytes, side) {
  const mask = soften(bytes, side);
  const valueAt = (/** @type {number} */ i, /** @type {number} */ j) =>
    i < 0 || j < 0 || i >= side || j >= side ? 0 : mask[j * side + i];
  /** Of a point between the middles of cells. @param {number} at */
  const partOf = (at) => Math.min(1, Math.max(0, (at + 0.5) / side));
  /** A name for each side of a cell. @param {number} i @param {number} j @param {number} s */
  const nameOf = (i, j, s) => 2 * ((j + 1 + Number(s === 2)) * (side + 2) + i + 1 + Number(s === 1)) + (s % 2);
  /**
   * Where an outline leaves each side of a cell, by where it enters.
   * @type {Map<number, [x: number, y: number, next: number]>}
   */
  const pieces = new Map();
  for (let j = -1; j < side; j++) {
    for (let i = -1; i < side; i++) {
      const isHigh = valueAt(i, j) > LEVEL;
      const isCrossed =
        isHigh !== valueAt(i + 1, j) > LEVEL ||
        isHigh !== valueAt(i, j + 1) > LEVEL ||
        isHigh !== valueAt(i + 1, j + 1) > LEVEL;
      if (!isCrossed) continue;
      const corners = CORNERS.map(([dx, dy]) => valueAt(i + dx, j + dy));
      const isIn = corners.map((value) => value > LEVEL);
      // An outline enters through a side that leads into the obstacle and leaves through the next that leads out of it.
      for (let enter = 0; enter < 4; enter++) {
        const next = (enter + 1) % 4;
        if (isIn[enter] || !isIn[next]) continue;
        let leave = next;
        while (!isIn[leave] || isIn[(leave + 1) % 4]) leave = (leave + 1) % 4;
        const part = (LEVEL - corners[enter]) / (corners[next] - corners[enter]);
        const [from, to] = [CORNERS[enter], CORNERS[next]];
        pieces.set(nameOf(i, j, enter), [
          partOf(i + from[0] + part * (to[0] - from[0])),
          partOf(j + from[1] + part * (to[1] - from[1])),
          nameOf(i, j, leave),
        ]);
      }
    }
  }
  /** @type {Contours} */
  const lines = [];
  for (const first of pieces.keys()) {
    /** @type {number[]} */
    const line = [];
    let name = first;
    for (let piece = pieces.get(name); piece; piece = pieces.get(name)) {
      pieces.delete(name);
      line.push(piece[0], piece[1]);
      name = piece[2];
    }
    lines.push(line);
  }
  return lines;
}

/**
 * Fills obstacles in a square.
 * @param {CanvasRenderingContext2D} context
 * @param {Contours} contours
 * @param {{ x: number, y: number, width: number, height: number }} square
 * @param {Palette} palette
 */
export function fillContours(context, contours, { x, y, width, height }, palette) {
  context.save();
  context.fillStyle = palette.obstacle;
  context.strokeStyle = palette.obstacleEdge;
  context.lineWidth = 1;
  context.lineJoin = "round";
  context.beginPath();
  for (const line of contours) {
    for (let i = 0; i < line.length; i += 2)
      context[i === 0 ? "moveTo" : "lineTo"](x + line[i] * width, y + (1 - line[i + 1]) * height);
    context.closePath();
  }
  context.fill();
  context.stroke();
  context.restore();
}
