/** New obstacles without a drag. */
import { moved, rectangle, rounded } from "./objects.js";

/** @import { EditTool, Obstacle } from "../../domain/types.js" */
/** @import { Point } from "./objects.js" */

/** Distances at which a new obstacle is tried, as parts of the world, and directions, as eighths of a turn. */
const RINGS = [0.09, 0.18, 0.28, 0.38, 0.46];
const DIRECTIONS = [7, 1, 3, 5];

/** Copies of an obstacle around it, from near to far. @param {Obstacle} obstacle @param {number} size  of the world @param {number} unit */
export function around(obstacle, size, unit) {
  return RINGS.flatMap((part) => DIRECTIONS.map((turn) => {
    const angle = (turn * Math.PI) / 4;
    return moved(obstacle, part * size * Math.cos(angle), part * size * Math.sin(angle), unit);
  }));
}

/** The obstacle that a tool adds without a drag. @param {EditTool} tool @param {Point} at @param {number} size @param {number} unit @returns {Obstacle} */
export function simple(tool, [x, y], size, unit) {
  const side = rounded(size / 12, unit);
  const half = rounded(side / 2, unit);
  if (tool === "disc") return moved({ type: "disc", center: [0, 0], radius: half }, x, y, unit);
  return moved(tool === "rectangle" ? rectangle([0, 0], side, side) : { type: "polygon", vertices: [[-half, -half], [half, -half], [0, half]] }, x, y, unit);
}
