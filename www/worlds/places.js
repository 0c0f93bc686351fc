/**
 * Places for robots in a world that names none. On a lattice of places, those that the core finds free are connected
 * where it proves the straight motion between neighbours. Start and goal are the two ends of a longest way in the
 * largest connected component; what surrounds a building is passed over if a component inside of it is a fifth as
 * large.
 */

import { boxOf } from "../domain/obstacles.js";

/** @import { Scenario } from "../domain/types.js" */
/** @import { Places } from "./types.js" */

/** The part of the largest component that one inside of it must have to be chosen. */
const INSIDE = 0.2;

/** Places along the longer side, at first, and where none are connected. */
const SIDES = [72, 216];

/**
 * Places and what is connected to each, those of the chosen component, nearest to the first of them first, and those
 * of it that are in the open rather than in a corner.
 * @typedef {object} Lattice
 * @property {number[][]} poses
 * @property {(place: number) => number[]} neighbours
 * @property {number[]} chosen
 * @property {number[]} open
 */

/** @param {Scenario} scenario @returns {Places | null} null: the robot fits nowhere on the lattice */
export function placesIn(scenario) {
  const lattice = latticeOf(scenario);
  if (!lattice) return null;
  const { poses, neighbours, chosen } = lattice;
  const farthest = (/** @type {number[]} */ order, /** @type {number} */ from) =>
    order.findLast((one) => one !== from && neighbours(one).length === 4) ?? /** @type {number} */ (order.at(-1));
  const start = farthest(chosen, chosen[0]);
  const goal = farthest(reached(start, neighbours), start);
  return { start: poses[start], goal: poses[goal] };
}

/**
 * Connected places, each as far as possible from those before it.
 * @param {Scenario} scenario
 * @param {number} count   at most
 * @returns {number[][]}
 */
export function spreadIn(scenario, count) {
  const lattice = latticeOf(scenario);
  if (!lattice) return [];
  const { poses, open } = lattice;
  const spread = [poses[open[0]]];
  const distances = open.map(() => Infinity);
  while (spread.length < Math.min(count, open.length)) {
    const [x, y] = spread[spread.length - 1];
    for (const [i, place] of open.entries())
      distances[i] = Math.min(distances[i], Math.hypot(poses[place][0] - x, poses[place][1] - y));
    spread.push(poses[open[distances.indexOf(Math.max(...distances))]]);
  }
  return spread;
}

/** @param {Scenario} scenario @returns {Lattice | null} null: no two places are connected */
function latticeOf(scenario) {
  for (const side of SIDES) {
    const lattice = latticeWith(scenario, side);
    if (lattice.chosen.length > 1) return lattice;
  }
  return null;
}

/** @param {Scenario} scenario @param {number} side   places along the longer side @returns {Lattice} */
function latticeWith(scenario, side) {
  const { min, max } = scenario.extent();
  const [width, height] = [max[0] - min[0], max[1] - min[1]];
  const pitch = Math.max(width, height) / side;
  const columns = Math.max(1, Math.round(width / pitch));
  const rows = Math.max(1, Math.round(height / pitch));
  const poses = Array.from({ length: columns * rows }, (_, i) => [
    min[0] + (((i % columns) + 0.5) / columns) * width,
    min[1] + ((Math.floor(i / columns) + 0.5) / rows) * height,
    ...(scenario.dimension > 2 ? [0] : []),
  ]);
  const isFree = poses.map((pose) => scenario.check(pose).free);
  const joins = (/** @type {number} */ a, /** @type {number} */ b) =>
    isFree[a] && isFree[b] && scenario.firstHit(poses[a], poses[b]) === null;
  const right = poses.map((_, i) => i % columns < columns - 1 && joins(i, i + 1));
  const up = poses.map((_, i) => i + columns < poses.length && joins(i, i + columns));
  const neighbours = (/** @type {number} */ i) => [
    ...(right[i] ? [i + 1] : []),
    ...(i % columns > 0 && right[i - 1] ? [i - 1] : []),
    ...(up[i] ? [i + columns] : []),
    ...(i >= columns && up[i - columns] ? [i - columns] : []),
  ];
  const seen = new Set();
  /** @type {number[][]} */
  const components = [];
  for (const [i, free] of isFree.entries()) {
    if (!free || seen.has(i)) continue;
    const order = reached(i, neighbours);
    for (const one of order) seen.add(one);
    components.push(order);
  }
  const largest = largestOf(components);
  const extentOf = (/** @type {number[]} */ places) => boxOf(places.map((i) => [i % columns, Math.floor(i / columns)]));
  const [low, high] = extentOf(largest);
  const surrounded = components.filter((one) => {
    const [first, last] = extentOf(one);
    return [0, 1].every((axis) => first[axis] > low[axis] && last[axis] < high[axis]);
  });
  const inside = largestOf(surrounded);
  const chosen = inside.length >= INSIDE * largest.length ? inside : largest;
  const inTheOpen = chosen.filter((one) => neighbours(one).length === 4);
  return { poses, neighbours, chosen, open: inTheOpen.length > 1 ? inTheOpen : chosen };
}

/** The one with the most places. @param {number[][]} components @returns {number[]} */
const largestOf = (components) => components.reduce((most, one) => (one.length > most.length ? one : most), []);

/**
 * What is connected to a place, nearest first.
 * @param {number} from
 * @param {(place: number) => number[]} neighbours
 */
function reached(from, neighbours) {
  const order = new Set([from]);
  for (const one of order) for (const next of neighbours(one)) order.add(next);
  return [...order];
}
