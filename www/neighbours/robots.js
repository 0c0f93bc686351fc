/**
 * The built-in robots: small worlds, each with a target and the queries of the course reports. And what any other
 * scenario opens with.
 */
import { Scenario } from "planarium";
import { box, disc, rectangleBetween } from "../domain/obstacles.js";

/** @import { Obstacle, ScenarioDocument } from "../domain/types.js" */

/**
 * @typedef {{ id: string, title: string, document: ScenarioDocument, q: number[], k: number, presets: [q: number[], k:
 *   number][] }} RobotEntry   an empty target is the middle
 */

const BOUNDS = { min: /** @type {[number, number]} */ ([0, 0]), max: /** @type {[number, number]} */ ([2, 2]) };

/**
 * @param {string} name
 * @param {string} title
 * @param {number[]} links
 * @param {Obstacle[]} obstacles
 * @returns {ScenarioDocument}
 */
function arm(name, title, links, obstacles) {
  return {
    format: "planarium-scenario-1",
    name,
    title,
    world: { obstacles },
    robot: { type: "arm", base: [0, 0], links, radius: 0.03 },
    queries: [],
  };
}

/** @type {RobotEntry[]} */
export const ROBOTS = [
  {
    id: "two",
    title: "Two joints",
    document: arm(
      "two-joints",
      "Two joints",
      [0.6, 0.45],
      [disc(0.62, 0.62, 0.18), box(-0.85, 0.45, 0.3, 0.2), disc(-0.35, -0.7, 0.16)],
    ),
    // Near both ends of the circle of one joint, and near 0, where the naive metric cuts, of the other.
    q: [3.1, 0.05],
    k: 6,
    presets: [
      [[0, 0], 3],
      [[3.14, 1.5], 6],
      [[4, 5.2], 4],
      [[1.5, 1.1], 10],
      [[5.8, -1.5], 5],
      [[3.14, 0], 20],
    ],
  },
  {
    id: "three",
    title: "Three joints",
    document: arm(
      "three-joints",
      "Three joints",
      [0.45, 0.38, 0.28],
      [disc(0.7, 0.5, 0.17), box(-0.9, 0.1, 0.28, 0.24)],
    ),
    q: [3, 0.6, -0.5],
    k: 5,
    presets: [
      [[3, 0.6, -0.5], 5],
      [[0, 0, 3.14], 5],
    ],
  },
  {
    id: "four",
    title: "Four joints",
    document: arm(
      "four-joints",
      "Four joints",
      [0.35, 0.3, 0.25, 0.2],
      [disc(0.65, 0.55, 0.15), box(-0.8, -0.5, 0.25, 0.25)],
    ),
    q: [3, 0.5, 0.4, -0.6],
    k: 5,
    presets: [
      [[3, 0.5, 0.4, -0.6], 5],
      [[0, 3.1, 0, -3.1], 5],
    ],
  },
  {
    id: "body",
    title: "Rotating body",
    document: {
      format: "planarium-scenario-1",
      name: "body",
      title: "Rotating body",
      world: { bounds: BOUNDS, obstacles: [disc(1.35, 0.6, 0.17), box(0.25, 1.2, 0.3, 0.22)] },
      robot: {
        type: "rigid_body",
        shape: rectangleBetween([-0.1, -0.05], [0.1, 0.05]),
        metric: { translation: 0.7, rotation: 0.3 },
      },
      queries: [],
    },
    q: [1, 1, 0],
    k: 3,
    presets: [
      [[1, 1, 0], 3],
      [[0.5, 0.5, 0], 4],
      [[0.75, 0.5, 0.2], 4],
      [[1, 1.5, -0.2], 4],
      [[0.4, 0.5, -0.3], 5],
      [[0.5, 0.5, 1], 4],
      [[1.75, 1.75, 0], 4],
      [[1.75, 1.75, 0], 20],
    ],
  },
  {
    id: "point",
    title: "Point",
    document: {
      format: "planarium-scenario-1",
      name: "point",
      title: "Point",
      world: { bounds: BOUNDS, obstacles: [disc(1.3, 1.3, 0.3), box(0.3, 0.5, 0.5, 0.2)] },
      robot: { type: "disc", radius: 0 },
      queries: [],
    },
    q: [1, 0.9],
    k: 8,
    presets: [
      [[1, 0.9], 8],
      [[0.25, 1.75], 5],
    ],
  },
];

/** Neighbours of a target in a scenario that says nothing of them. */
const USUAL = 5;

/**
 * Targets are the starts and goals of the scenario's queries.
 * @param {ScenarioDocument | string} text  or its document
 * @param {string} id  of a scene, or "file"
 * @returns {RobotEntry}
 * @throws {Error} the core refuses it
 */
export function entryOf(text, id) {
  const scenario = Scenario.parse(text);
  const document = scenario.document();
  scenario.free();
  const targets = document.queries
    .flatMap(({ start, goal = [] }) => [Array.from(start), Array.from(goal)])
    .filter(({ length }) => length > 0);
  return {
    id,
    title: document.title ?? document.name,
    document,
    q: targets[0] ?? [],
    k: USUAL,
    presets: targets.map((q) => [q, USUAL]),
  };
}
