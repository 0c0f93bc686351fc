/** New obstacles: those that a tool adds without a drag, and copies. */
import { rectangleBetween } from "../../domain/obstacles.js";
import { moved } from "./parts.js";
import { rounded } from "./units.js";

/** @import { EditTool, Obstacle, Point } from "../../domain/types.js" */

/** Distances at which a new obstacle is tried, as parts of the world, and directions, as eighths of a turn. */
const RINGS = [0.09, 0.18, 0.28, 0.38, 0.46];
const DIRECTIONS = [7, 1, 3, 5];
/** The width of a new wall, as a part of the world. */
const THICKNESS = 1 / 80;

/** @param {Point} center @param {number} width @param {number} height @returns {Obstacle} */
export function rectangle([x, y], width, height) {
  return rectangleBetween([x - width / 2, y - height / 2], [x + width / 2, y + height / 2]);
}

/** A wall along points, which is closed if it ends where it begins. @param {Point[]} points @param {boolean} closed @param {number} size  of the world @returns {Obstacle} */
export function wall(points, closed, size) {
  const width = size * THICKNESS;
  return {
    type: "wall",
    points: [...points],
    width: rounded(width, 10 ** Math.floor(Math.log10(width))),
    ...(closed ? { closed } : {}),
  };
}

/**
 * Copies of an obstacle around it, from near to far.
 * @param {Obstacle} obstacle
 * @param {number} size  of the world
 * @param {number} unit
 */
export function around(obstacle, size, unit) {
  return RINGS.flatMap((part) =>
    DIRECTIONS.map((turn) => {
      const angle = (turn * Math.PI) / 4;
      return moved(obstacle, part * size * Math.cos(angle), part * size * Math.sin(angle), unit);
    }),
  );
}

/**
 * The obstacle that a tool adds without a drag.
 * @param {EditTool} tool
 * @param {Point} at
 * @param {number} size
 * @param {number} unit
 * @returns {Obstacle}
 */
export function simple(tool, [x, y], size, unit) {
  const side = rounded(size / 12, unit);
  const half = rounded(side / 2, unit);
  return moved(plain(tool, side, half, size), x, y, unit);
}

/** @param {EditTool} tool @param {number} side @param {number} half @param {number} size @returns {Obstacle} */
function plain(tool, side, half, size) {
  if (tool === "disc") return { type: "disc", center: [0, 0], radius: half };
  if (tool === "rectangle") return rectangle([0, 0], side, side);
  if (tool === "wall")
    return wall(
      [
        [-side, 0],
        [side, 0],
      ],
      false,
      size,
    );
  return {
    type: "polygon",
    vertices: [
      [-half, -half],
      [half, -half],
      [0, half],
    ],
  };
}
