/**
 * The page's own scenes, in the order of a first lesson. A scene is read from `scenes/ID.json`, or made by a generator of the core,
 * whose options its sliders move.
 */

/** @import { SceneEntry } from "../../domain/types.js" */

/** @type {SceneEntry[]} */
export const SCENES = [
  {
    id: "stones", title: "Two links among stones", algorithm: "prm", pace: 130, settings: { samples: 260, k: 9, seed: 0 },
    story: "Nearby configurations are now connected. Each line is a motion proven to be collision-free.",
  },
  {
    id: "open", title: "Nothing in the way", algorithm: "rrt", pace: 30, settings: { step: 0.14, goal_bias: 0, seed: 3 },
    story: "Without obstacles the tree first spreads into the largest empty regions, then fills in.",
  },
  {
    id: "pillar", title: "One disc in the middle", algorithm: "rrt", pace: 35, settings: { step: 0.3, seed: 15 },
    story: "One disc in the workspace is an island in configuration space: the tree grows round it.",
  },
  {
    id: "slot", title: "Through a slot", algorithm: "prm", pace: 110, settings: { samples: 260, k: 8, seed: 1 },
    story: "The arm must fold to get through the slot: in configuration space, a thin channel.",
  },
  {
    id: "firs", title: "A forest of triangles", algorithm: "rrt-connect", pace: 14, settings: { step: 0.35, seed: 7 },
    story: "Two trees, rooted at start and goal, grow towards each other until they meet.",
  },
  {
    id: "passage", title: "A narrow passage", algorithm: "prm", pace: 100, settings: { samples: 260, k: 8, seed: 1 },
    story: "Few samples fall into the passage: make it narrower, and the roadmap is disconnected.",
    generate: { kind: "gap", options: { radius: 0.05, width: 0.2, thickness: 0.3, seed: 1 } },
    sliders: [{ option: "width", title: "Width of the passage", min: 0.08, max: 0.5, step: 0.02, unit: "m" }],
  },
  {
    id: "trap", title: "A bug trap", algorithm: "rrt", pace: 120, settings: { step: 0.1, seed: 5 },
    story: "The tree fills the trap long before it finds the mouth, which is turned inwards.",
    generate: { kind: "bug-trap", options: { radius: 0.03, mouth: 0.12, turn: "quarter", seed: 2 } },
    sliders: [{ option: "mouth", title: "Width of the mouth", min: 0.08, max: 0.3, step: 0.02, unit: "m" }],
  },
  {
    id: "maze", title: "A maze", algorithm: "rrt-connect", pace: 80, settings: { step: 0.1, seed: 4 },
    story: "Two trees explore the maze from both ends until they meet.",
    generate: { kind: "maze", options: { difficulty: "medium", radius: 0.05, seed: 3 } },
    sliders: [
      { option: "difficulty", title: "Difficulty", min: 0, max: 2, step: 1, unit: "", words: ["easy", "medium", "hard"] },
      { option: "seed", title: "Seed", min: 0, max: 30, step: 1, unit: "" },
    ],
  },
  {
    id: "pebbles", title: "Among pebbles", algorithm: "prm-star", pace: 70, settings: { samples: 200, sampler: "halton", seed: 0 },
    story: "PRM* uses enough neighbours for the path to approach the shortest.",
    generate: { kind: "discs", options: { count: 90, smallest: 0.025, largest: 0.05, gap: 0.07, radius: 0.03, seed: 2 } },
    sliders: [
      { option: "count", title: "Obstacles", min: 0, max: 110, step: 1, unit: "" },
      { option: "seed", title: "Seed", min: 0, max: 30, step: 1, unit: "" },
    ],
  },
  {
    id: "museum", title: "Guards in a museum", algorithm: "visibility-prm", pace: 32, settings: { failures: 150, shortcut: 60, seed: 2 },
    story: "Guards cover what no other guard sees; connectors join them. A dozen map every room.",
  },
  {
    id: "veil", title: "A wall thin as paper", algorithm: "prm", pace: 60,
    settings: { samples: 150, k: 8, edge_check: "sampled", edge_samples: 3, seed: 1 },
    story: "Checked at only three points, edges jump the thin wall. Set \u201cCollision checking\u201d to \u201cproven\u201d.",
  },
  {
    id: "shelf", title: "Into the shelf", algorithm: "rrt-connect", pace: 30, settings: { step: 0.2, seed: 8 },
    story: "The three-link arm must withdraw from one compartment before entering the next.",
  },
  {
    id: "thicket", title: "Four links in a thicket", algorithm: "rrt-connect", pace: 22, settings: { step: 0.5, seed: 1 },
    story: "The configuration space has four dimensions; the square shows two of them.",
  },
  {
    id: "tentacle", title: "Six links, two doors", algorithm: "rrt-connect", pace: 45, settings: { step: 1, shortcut: 120, seed: 1 },
    story: "Two trees thread six links through both doors; shortcutting then smooths the path.",
  },
  {
    id: "pick", title: "Pick from the shelf", algorithm: "rrt-connect", pace: 25, settings: { step: 0.3, seed: 3 },
    story: "The goal is a point for the tip: any of the faint configurations reaches it.",
  },
  {
    id: "rings", title: "A disc in the rings", algorithm: "prm", pace: 300, settings: { samples: 900, k: 9, seed: 14 },
    story: "Every line is a path wide enough for the disc; one leads inwards, gate by gate.",
  },
  {
    id: "locked", title: "No way round", algorithm: "prm", pace: 150, settings: { samples: 300, k: 9, seed: 1 },
    story: "Joint limits block the way round: no motion connects the two large components.",
  },
  {
    id: "crates", title: "A body among stones", algorithm: "prm", pace: 110, settings: { samples: 300, k: 9, seed: 2 },
    story: "A rigid body translates and rotates. Each dot is a configuration (x, y, theta).",
    generate: { kind: "clutter", options: { robot: "rigid_body", count: 16, seed: 2 } },
    sliders: [{ option: "count", title: "Obstacles", min: 0, max: 20, step: 1, unit: "" }, { option: "seed", title: "Seed", min: 0, max: 30, step: 1, unit: "" }],
  },
  {
    id: "corner", title: "An L through a gap", algorithm: "rrt-connect", pace: 100, settings: { step: 0.15, seed: 1 },
    story: "Both legs of the L do not fit at once: it must rotate as it passes.",
  },
  {
    id: "blossom", title: "A kinodynamic RRT", algorithm: "rrt-control", pace: 22,
    settings: { blossom: 3, duration_steps: 250, goal_bias: 0.05, goal_test: "ends", max_iterations: 10000, seed: 1 },
    story: "At each vertex {controls}.",
    generate: { kind: "clutter", options: { robot: "car", count: 10, seed: 1 } },
    sliders: [{ option: "count", title: "Obstacles", min: 0, max: 14, step: 1, unit: "" }, { option: "seed", title: "Seed", min: 0, max: 30, step: 1, unit: "" }],
  },
  {
    id: "witness", title: "SST: a sparse tree", algorithm: "sst", pace: 140, settings: { seed: 2 },
    story: "Of vertices near each other only the one with the cheapest path is kept; the others are pruned.",
    generate: { kind: "clutter", options: { robot: "car", count: 10, seed: 3 } },
    sliders: [{ option: "count", title: "Obstacles", min: 0, max: 14, step: 1, unit: "" }, { option: "seed", title: "Seed", min: 0, max: 30, step: 1, unit: "" }],
  },
  {
    id: "parking", title: "Parking", algorithm: "rrt", pace: 12, settings: { step: 0.1, seed: 0 },
    story: "Each edge is a curve that the car can drive; to park, it has to reverse.",
  },
  {
    id: "turn", title: "A three-point turn", algorithm: "rrt", pace: 10, settings: { step: 0.1, seed: 0 },
    story: "The road is too narrow to turn in one go: forward, back and forward again.",
  },
  {
    id: "lanes", title: "A car in a maze", algorithm: "rrt-connect", pace: 45, settings: { step: 0.25, seed: 4 },
    story: "Two trees of curves grow from both ends; the car reverses where a corner is too tight.",
  },
];

/**
 * The options of a scene's generator with its sliders where they are put.
 * @param {SceneEntry} entry
 * @param {Record<string, number>} [positions]  of sliders, by option
 * @returns {Record<string, number | string | boolean>}
 */
export function optionsAt({ generate, sliders = [] }, positions = {}) {
  const moved = sliders.filter(({ option }) => option in positions);
  return { ...generate?.options, ...Object.fromEntries(moved.map(({ option, words }) => [option, words?.[positions[option]] ?? positions[option]])) };
}
