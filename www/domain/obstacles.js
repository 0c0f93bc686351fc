/** Obstacles: those of built-in scenes, and the lines that all are made of. */

/** @import { Obstacle, Part, Point } from "./types.js" */
/** @typedef {{ points: Point[], isClosed: boolean }} Line */
/** @typedef {Obstacle | Exclude<Part, { type: "capsule" }>} Outlined   polygons of robots have no holes */

/** @param {number} x @param {number} y @param {number} width @param {number} height */
export const box = (x, y, width, height) => rectangleBetween([x, y], [x + width, y + height]);

/** @param {Point} low @param {Point} high @returns {{ type: "polygon", vertices: Point[] }} */
export function rectangleBetween([a, b], [c, d]) {
  return {
    type: "polygon",
    vertices: [
      [a, b],
      [c, b],
      [c, d],
      [a, d],
    ],
  };
}

/** @param {number} x @param {number} y @param {number} radius @returns {Obstacle} */
export function disc(x, y, radius) {
  return { type: "disc", center: [x, y], radius };
}

/**
 * The lines of an obstacle: the outline of a polygon and then its holes, the middle line of a wall; none of a disc.
 * @param {Outlined} obstacle
 * @returns {Line[]}
 */
export function linesOf(obstacle) {
  if (obstacle.type === "disc") return [];
  if (obstacle.type === "wall") return [{ points: obstacle.points, isClosed: obstacle.closed ?? false }];
  const holes = ("holes" in obstacle && obstacle.holes) || [];
  return [obstacle.vertices, ...holes].map((points) => ({ points, isClosed: true }));
}

/**
 * The segments of an obstacle or of a part of a robot, and its radius: it is all within that radius of them, and what a
 * polygon encloses.
 * @param {Obstacle | Part} shape
 * @returns {{ segments: [Point, Point][], radius: number }}
 */
export function coreOf(shape) {
  if (shape.type === "disc") return { segments: [[shape.center, shape.center]], radius: shape.radius };
  if (shape.type === "capsule") return { segments: [[shape.a, shape.b]], radius: shape.radius };
  /** @type {[Point, Point][]} */
  const segments = [];
  for (const { points, isClosed } of linesOf(shape))
    points.forEach((point, i) => {
      if (isClosed || i > 0) segments.push([points.at(i - 1) ?? point, point]);
    });
  return { segments, radius: shape.type === "wall" ? shape.width / 2 : 0 };
}

/** Whether a ring encloses a point. @param {Point[]} ring @param {number} x @param {number} y */
export function contains(ring, x, y) {
  let inside = false;
  ring.forEach(([ax, ay], i) => {
    const [bx, by] = ring[(i + 1) % ring.length];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
  });
  return inside;
}

/** Whether a polygon has a point inside, in none of its holes. @param {Outlined} shape @param {number} x @param {number} y */
export function encloses(shape, x, y) {
  return shape.type === "polygon" && linesOf(shape).filter(({ points }) => contains(points, x, y)).length % 2 === 1;
}

/**
 * A place in the middle of an obstacle: of its box, or of a wall on its middle segment.
 * @param {Outlined} obstacle
 * @returns {Point}
 */
export function middleOf(obstacle) {
  if (obstacle.type === "disc") return obstacle.center;
  const [{ points }] = linesOf(obstacle);
  const first = (points.length >> 1) - 1;
  const [low, high] = boxOf(obstacle.type === "wall" ? points.slice(first, first + 2) : points);
  return [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
}

/** The least and the greatest coordinates of points. @param {Point[]} points @returns {[Point, Point]} */
export function boxOf(points) {
  /** @type {Point} */
  const low = [Infinity, Infinity];
  /** @type {Point} */
  const high = [-Infinity, -Infinity];
  for (const point of points)
    for (const i of [0, 1]) {
      low[i] = Math.min(low[i], point[i]);
      high[i] = Math.max(high[i], point[i]);
    }
  return [low, high];
}
