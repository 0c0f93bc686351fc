/** The arms of the comparison: what each side runs in a row, with its parameters. */
import { samples } from "./worlds.mjs";

/** @typedef {import("./worlds.mjs").Row} Row */
/** @typedef {import("./worlds.mjs").World} World */
/** @typedef {import("./sides.mjs").SideName} SideName */
/** @typedef {{ name: string, side: SideName, job: (world: World, seed: number, runs: number) => string }} Arm */

/** Seconds after which a query is given up: hundreds of times the usual. */
const LIMIT = 0.1;

/** Radians in the sum metric between two configurations that a peer checks on an edge of its trees. */
const RESOLUTION = 0.05;

/** The same for a body, in its metric, and the step of a peer's tree. */
const BODY = { resolution: 0.01, range: 0.3 };

/** Seconds after which a car is given up. */
const CAR_LIMIT = 5;

/** Durations of a control in steps of 0.01 s: constant as in the reports, and random up to a bound. */
const HELD = { fixed: [250, 250], drawn: [1, 250], short: [1, 50] };

/** The neighbours of the reports' roadmaps. */
const K = 30;

/**
 * The arms of a row.
 * @param {Row} row
 * @returns {Arm[]}
 */
export function arms(row) {
  if (row.planner === "prm") return roadmaps(row);
  if (row.planner === "rrt-connect") return row.links > 0 ? trees(row) : bodies();
  return cars(row.planner);
}

/**
 * Planarium in both orders: in a batch, each pair is tested once; one by one, k motions per sample, as in OMPL.
 * @param {Row} row
 * @returns {Arm[]}
 */
function roadmaps({ links }) {
  const n = samples(links);
  const ours = (/** @type {SideName} */ side, /** @type {string} */ name, more = "") => ({
    name, side,
    job: (/** @type {World} */ world, /** @type {number} */ seed, /** @type {number} */ runs) => `${world.json} prm ${seed} ${runs} 60 samples=${n} k=${K}${more}`,
  });
  const peer = (/** @type {SideName} */ side, /** @type {string} */ name, space = "flat") => ({
    name, side,
    job: (/** @type {World} */ world, /** @type {number} */ seed, /** @type {number} */ runs) => `${world.text} prm ${seed} ${runs} ${n} ${K} ${space}`,
  });
  return [
    ours("native", "native, equal motions", " insertion=one-by-one"),
    ours("native", "native, batch"),
    ours("native", "native, batch, sampled", " edge_check=sampled"),
    ours("node", "Node, equal motions", " insertion=one-by-one"),
    ours("node", "Node, batch"),
    peer("ompl", "OMPL"),
    peer("ompl", "OMPL, plain", "plain"),
    peer("ompl", "OMPL, compound", "compound"),
    peer("oxmpl", "OxMPL"),
  ];
}

/**
 * Planarium with default options, which are OMPL's: steps of a fifth of the extent of the space.
 * @param {Row} row
 * @returns {Arm[]}
 */
function trees({ links }) {
  const extent = Math.PI * links;
  const ours = (/** @type {SideName} */ side, /** @type {string} */ name) => ({
    name, side,
    job: (/** @type {World} */ world, /** @type {number} */ seed, /** @type {number} */ runs) => `${world.json} rrt-connect ${seed} ${runs} ${LIMIT}`,
  });
  const peer = (/** @type {SideName} */ side, /** @type {string} */ name, range = 0.2 * extent, resolution = RESOLUTION, space = "flat") => ({
    name, side,
    job: (/** @type {World} */ world, /** @type {number} */ seed, /** @type {number} */ runs) => `${world.text} rrt-connect ${seed} ${runs} ${range} ${resolution} ${LIMIT} ${space}`,
  });
  return [
    ours("native", "native"),
    ours("node", "Node"),
    peer("ompl", "OMPL"),
    peer("ompl", "OMPL, plain", 0.2 * extent, RESOLUTION, "plain"),
    peer("ompl", "OMPL, compound", 0.2 * extent, RESOLUTION, "compound"),
    peer("ompl", "OMPL, range 0.5", 0.5),
    // OMPL's default: a hundredth of the extent.
    peer("ompl", "OMPL, coarse", 0.2 * extent, 0.01 * extent),
    peer("oxmpl", "OxMPL"),
  ];
}

/** Planarium with its default step, and with the peer's. @returns {Arm[]} */
function bodies() {
  const ours = (/** @type {SideName} */ side, /** @type {string} */ name, more = "") => ({
    name, side,
    job: (/** @type {World} */ world, /** @type {number} */ seed, /** @type {number} */ runs) => `${world.json} rrt-connect ${seed} ${runs} ${CAR_LIMIT}${more}`,
  });
  return [
    ours("native", "native"),
    ours("native", "native, equal steps", ` step=${BODY.range}`),
    ours("node", "Node"),
    ours("node", "Node, equal steps", ` step=${BODY.range}`),
    {
      name: "OMPL", side: "ompl",
      job: (world, seed, runs) => `${world.text} body ${seed} ${runs} ${BODY.range} ${BODY.resolution} ${CAR_LIMIT}`,
    },
  ];
}

/**
 * Planarium with default options, and with the controls of the reports: held for 2.5 s, one per extension, the goal tested at their ends.
 * @param {"rrt-control" | "sst"} planner
 * @returns {Arm[]}
 */
function cars(planner) {
  const ours = (/** @type {SideName} */ side, /** @type {string} */ name, more = "") => ({
    name, side,
    job: (/** @type {World} */ world, /** @type {number} */ seed, /** @type {number} */ runs) => `${world.json} ${planner} ${seed} ${runs} ${CAR_LIMIT}${more}`,
  });
  const peer = (/** @type {string} */ name, /** @type {number[]} */ [least, most]) => ({
    name, side: /** @type {const} */ ("ompl"),
    job: (/** @type {World} */ world, /** @type {number} */ seed, /** @type {number} */ runs) =>
      `${world.text} ${planner === "sst" ? "sst" : "control"} ${seed} ${runs} ${least} ${most} ${CAR_LIMIT}`,
  });
  const both = [ours("native", "native"), ours("node", "Node")];
  if (planner === "sst") return [...both, peer("OMPL", HELD.short), peer("OMPL, longer", HELD.drawn)];
  const preset = " duration_steps=250 shortest_steps=250 blossom=1 goal_test=ends";
  return [...both, ours("native", "native, the reports'", preset), ours("node", "Node, the reports'", preset), peer("OMPL", HELD.fixed), peer("OMPL, drawn", HELD.drawn)];
}

/**
 * A ratio of the times of two arms, and its aim.
 * @typedef {{ name: string, over: string, under: string, least?: number, most?: number }} Comparison
 */

/** @type {Record<Row["planner"], Comparison[]>} */
export const comparisons = {
  prm: [
    // The aims were set against OMPL with the checker of the course reports, which has no broad phase.
    { name: "OMPL, plain / native, equal motions", over: "OMPL, plain", under: "native, equal motions", least: 7 },
    { name: "OMPL, plain / Node, equal motions", over: "OMPL, plain", under: "Node, equal motions", least: 4 },
    { name: "OMPL, plain / native, batch", over: "OMPL, plain", under: "native, batch", least: 12 },
    { name: "OMPL, plain / Node, batch", over: "OMPL, plain", under: "Node, batch", least: 8 },
    { name: "OMPL / native, equal motions", over: "OMPL", under: "native, equal motions" },
    { name: "OMPL / Node, equal motions", over: "OMPL", under: "Node, equal motions" },
    { name: "OMPL / native, batch", over: "OMPL", under: "native, batch" },
    { name: "OMPL / Node, batch", over: "OMPL", under: "Node, batch" },
    { name: "OMPL, compound / native, equal motions", over: "OMPL, compound", under: "native, equal motions" },
    { name: "OxMPL / native, equal motions", over: "OxMPL", under: "native, equal motions" },
    { name: "sampled / proven, both native, batch", over: "native, batch, sampled", under: "native, batch", least: 4 },
    { name: "Node / native, batch", over: "Node, batch", under: "native, batch", most: 2 },
  ],
  "rrt-connect": [
    { name: "OMPL, plain / native", over: "OMPL, plain", under: "native", least: 6 },
    { name: "OMPL, plain / Node", over: "OMPL, plain", under: "Node", least: 4 },
    { name: "OMPL / native", over: "OMPL", under: "native" },
    { name: "OMPL / Node", over: "OMPL", under: "Node" },
    { name: "OMPL, compound / native", over: "OMPL, compound", under: "native" },
    { name: "OMPL, range 0.5 / native", over: "OMPL, range 0.5", under: "native" },
    { name: "OMPL, coarse / native", over: "OMPL, coarse", under: "native" },
    { name: "OxMPL / native", over: "OxMPL", under: "native" },
    { name: "OMPL / native, equal steps", over: "OMPL", under: "native, equal steps", least: 1 },
    { name: "Node, equal steps / OMPL", over: "Node, equal steps", under: "OMPL", most: 1.5 },
    { name: "Node / native", over: "Node", under: "native", most: 2 },
  ],
  "rrt-control": [
    { name: "OMPL / native", over: "OMPL", under: "native", least: 1 },
    { name: "OMPL / native, the reports'", over: "OMPL", under: "native, the reports'", least: 1 },
    { name: "OMPL, drawn / native", over: "OMPL, drawn", under: "native" },
    { name: "Node / OMPL", over: "Node", under: "OMPL", most: 1.5 },
    { name: "Node, the reports' / OMPL", over: "Node, the reports'", under: "OMPL", most: 1.5 },
  ],
  sst: [
    { name: "OMPL / native", over: "OMPL", under: "native", least: 1 },
    { name: "OMPL, longer / native", over: "OMPL, longer", under: "native" },
    { name: "Node / OMPL", over: "Node", under: "OMPL", most: 1.5 },
  ],
};
