/** Obstacles of built-in scenes. */

/** @import { Obstacle } from "./types.js" */

/** @param {number} x @param {number} y @param {number} width @param {number} height @returns {Obstacle} */
export function box(x, y, width, height) {
  return {
    type: "polygon",
    vertices: [
      [x, y],
      [x + width, y],
      [x + width, y + height],
      [x, y + height],
    ],
  };
}

/** @param {number} x @param {number} y @param {number} radius @returns {Obstacle} */
export function disc(x, y, radius) {
  return { type: "disc", center: [x, y], radius };
}
