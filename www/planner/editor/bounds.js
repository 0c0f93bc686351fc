/** The bounds of the world as an object of the editor: four edges, which are dragged alone or two at a corner. */

/** @import { Box, Point, ScenarioDocument } from "../../domain/types.js" */
/** @typedef {[left: number, bottom: number, right: number, top: number]} Edges   metres */
/** @typedef {{ edges: number[], at: Point }} Grip   the edges that move with a point */

/** The names of the edges, in the order of their numbers. */
export const EDGES = ["left", "bottom", "right", "top"];

/** Handles: the edges that each moves. @type {number[][]} */
const GRIPS = [[0], [1], [2], [3], [0, 1], [1, 2], [2, 3], [3, 0]];

/** @param {Box} bounds @returns {Edges} */
export function edgesOf({ min, max }) {
  return [min[0], min[1], max[0], max[1]];
}

/**
 * The document with other bounds.
 * @param {ScenarioDocument} document
 * @param {ArrayLike<number> | null} edges  null: none
 * @returns {ScenarioDocument}
 */
export function withEdges(document, edges) {
  const { bounds: _, ...world } = document.world;
  if (!edges) return { ...document, world };
  const { 0: left, 1: bottom, 2: right, 3: top } = edges;
  return { ...document, world: { bounds: { min: [left, bottom], max: [right, top] }, ...world } };
}

/** Where edges are grabbed: on them, and else at a place. @param {Edges} numbers @param {number[]} edges @param {Point} place @returns {Grip} */
function grip(numbers, edges, place) {
  const at = place.map((value, i) => edges.filter((edge) => edge % 2 === i).map((edge) => numbers[edge])[0] ?? value);
  return { edges, at: [at[0], at[1]] };
}

/** The handles, the corners last. @param {Box} bounds @returns {Grip[]} */
export function gripsOf(bounds) {
  const numbers = edgesOf(bounds);
  const [left, bottom, right, top] = numbers;
  return GRIPS.map((edges) => grip(numbers, edges, [(left + right) / 2, (bottom + top) / 2]));
}

/**
 * The edge of bounds at a point, or two at a corner.
 * @param {Box} bounds
 * @param {Point} point
 * @param {number} reach  metres
 * @returns {Grip | null}
 */
export function gripAt(bounds, [x, y], reach) {
  const numbers = edgesOf(bounds);
  const [left, bottom, right, top] = numbers;
  if (x < left - reach || x > right + reach || y < bottom - reach || y > top + reach) return null;
  const edges = [x - left, y - bottom, right - x, top - y].flatMap((distance, i) =>
    Math.abs(distance) <= reach ? [i] : [],
  );
  return edges.length > 0 ? grip(numbers, edges, [x, y]) : null;
}
