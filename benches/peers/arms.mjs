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

/**
 * The same for a body, in its metric, a step of a tree that is shorter than the default of OMPL, and the extent of its
 * space: the distance between opposite corners of the world, turned by half a turn.
 */
const BODY = { resolution: 0.01, range: 0.3, extent: 0.7 * Math.hypot(2, 2) + 0.3 * Math.PI };

/** OMPL's default step of a tree, as a part of the extent of the space. */
const STEP = 0.2;

/** Seconds after which a body or a car is given up. */
const PLACED_LIMIT = 5;

/**
 * Durations of a control in steps of 0.01 s: constant as in the reports, and random up to Planarium's default or less.
 */
const HELD = { fixed: [250, 250], drawn: [1, 250], short: [1, 50] };

/** The neighbours of the reports' roadmaps. */
const K = 30;

/**
 * Makes the arms of Planarium.
 * @param {Row["planner"]} planner
 * @param {number} limit  seconds after which a query is given up
 * @param {string} [options]  of all of them
 * @returns {(side: SideName, name: string, more?: string) => Arm}  `more`: further options
 */
function planarium(planner, limit, options = "") {
  return (side, name, more = "") => ({
    name,
    side,
    job: (world, seed, runs) => `${world.json} ${planner} ${seed} ${runs} ${limit}${options}${more}`,
  });
}

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
  const ours = planarium("prm", 60, ` samples=${n} k=${K}`);
  const peer = (/** @type {SideName} */ side, /** @type {string} */ name, space = "flat") => ({
    name,
    side,
    job: (/** @type {World} */ world, /** @type {number} */ seed, /** @type {number} */ runs) =>
      `${world.text} prm ${seed} ${runs} ${n} ${K} ${space}`,
  });
  return [
    ours("native", "native, equal motions", " insertion=one-by-one"),
    ours("native", "native, batch"),
    ours("native", "native, batch, sampled", " edge_check=sampled"),
    ours("node", "Node, equal motions", " insertion=one-by-one"),
    ours("node", "Node, batch"),
    ours("node", "Node, batch, sampled", " edge_check=sampled"),
    peer("ompl", "OMPL"),
    peer("ompl", "OMPL, plain", "plain"),
    peer("ompl", "OMPL, compound", "compound"),
    peer("oxmpl", "OxMPL"),
  ];
}

/**
 * Planarium with steps of a fifth of the extent of the space, as OMPL's, and with its default, steps that adapt.
 * @param {Row} row
 * @returns {Arm[]}
 */
function trees({ links }) {
  const extent = Math.PI * links;
  const ours = planarium("rrt-connect", LIMIT);
  const equal = ` step=${STEP * extent}`;
  const peer = (
    /** @type {SideName} */ side,
    /** @type {string} */ name,
    range = STEP * extent,
    resolution = RESOLUTION,
    space = "flat",
  ) => ({
    name,
    side,
    job: (/** @type {World} */ world, /** @type {number} */ seed, /** @type {number} */ runs) =>
      `${world.text} rrt-connect ${seed} ${runs} ${range} ${resolution} ${LIMIT} ${space}`,
  });
  return [
    ours("native", "native", equal),
    ours("native", "native, adapting"),
    ours("node", "Node", equal),
    ours("node", "Node, adapting"),
    peer("ompl", "OMPL"),
    peer("ompl", "OMPL, plain", STEP * extent, RESOLUTION, "plain"),
    peer("ompl", "OMPL, compound", STEP * extent, RESOLUTION, "compound"),
    peer("ompl", "OMPL, range 0.5", 0.5),
    // OMPL's default: a hundredth of the extent.
    peer("ompl", "OMPL, coarse", STEP * extent, 0.01 * extent),
    peer("oxmpl", "OxMPL"),
  ];
}

/** All with a fifth of the extent, OMPL's default, and with steps of 0.3; ours with its default, too. @returns {Arm[]} */
function bodies() {
  const ours = planarium("rrt-connect", PLACED_LIMIT);
  const equal = ` step=${STEP * BODY.extent}`;
  const peer = (/** @type {string} */ name, range = 0, checker = "boxes") => ({
    name,
    side: /** @type {const} */ ("ompl"),
    job: (/** @type {World} */ world, /** @type {number} */ seed, /** @type {number} */ runs) =>
      `${world.text} body ${seed} ${runs} ${range} ${BODY.resolution} ${PLACED_LIMIT} ${checker}`,
  });
  return [
    ours("native", "native", equal),
    ours("native", "native, short steps", ` step=${BODY.range}`),
    ours("native", "native, adapting"),
    ours("node", "Node", equal),
    ours("node", "Node, short steps", ` step=${BODY.range}`),
    ours("node", "Node, adapting"),
    peer("OMPL"),
    peer("OMPL, plain", 0, "plain"),
    peer("OMPL, short steps", BODY.range),
  ];
}

/**
 * Planarium with default options, and with the controls of the reports: held for 2.5 s, one per extension, the goal
 * tested at their ends.
 * @param {"rrt-control" | "sst"} planner
 * @returns {Arm[]}
 */
function cars(planner) {
  const ours = planarium(planner, PLACED_LIMIT);
  const peer = (/** @type {string} */ name, /** @type {number[]} */ [least, most], checker = "boxes") => ({
    name,
    side: /** @type {const} */ ("ompl"),
    job: (/** @type {World} */ world, /** @type {number} */ seed, /** @type {number} */ runs) =>
      `${world.text} ${planner === "sst" ? "sst" : "control"} ${seed} ${runs} ${least} ${most} ${PLACED_LIMIT} ${checker}`,
  });
  const both = [ours("native", "native"), ours("node", "Node")];
  if (planner === "sst")
    return [
      ...both,
      peer("OMPL", HELD.drawn),
      peer("OMPL, plain", HELD.drawn, "plain"),
      peer("OMPL, short controls", HELD.short),
    ];
  const preset = " duration_steps=250 shortest_steps=250 blossom=1 goal_test=ends";
  return [
    ...both,
    ours("native", "native, the reports'", preset),
    ours("node", "Node, the reports'", preset),
    peer("OMPL", HELD.fixed),
    peer("OMPL, plain", HELD.fixed, "plain"),
    peer("OMPL, drawn", HELD.drawn),
  ];
}

/**
 * The lines of a row in docs/benchmarks.md: what to call each, and what the names of our arms and of OMPL's end with.
 * @param {Row} row
 * @returns {{ title: string, ours: string, peer: string }[]}
 */
export function lines({ planner, links }) {
  const line = (title = "", ours = "", peer = "") => ({ title, ours, peer });
  if (planner === "prm") return [line(", equal motions", ", equal motions"), line(", batch", ", batch")];
  if (planner === "sst") return [line(), line(", OMPL's controls held for up to 0.5 s", "", ", short controls")];
  if (planner === "rrt-control") return [line(), line(", the reports' controls", ", the reports'")];
  const adapting = line(", steps that adapt", ", adapting");
  return links > 0 ? [line(), adapting] : [line(), line(", steps of 0.3", ", short steps", ", short steps"), adapting];
}

/**
 * The ratios besides those of the lines: the times of one arm over those of another.
 * @type {Record<Row["planner"], [string, string][]>}
 */
const further = {
  prm: [
    ["OMPL, compound", "native, equal motions"],
    ["OxMPL", "native, equal motions"],
    ["native, batch, sampled", "native, batch"],
    ["Node, batch, sampled", "Node, batch"],
    ["Node, batch", "native, batch"],
  ],
  "rrt-connect": [
    ["OMPL, compound", "native"],
    ["OMPL, range 0.5", "native"],
    ["OMPL, coarse", "native"],
    ["OxMPL", "native"],
    ["native, adapting", "native"],
    ["Node", "native"],
  ],
  "rrt-control": [
    ["OMPL, drawn", "native"],
    ["Node", "native"],
  ],
  sst: [["Node", "native"]],
};

/**
 * The ratios of a row; those whose arms do not take part have no value.
 * @param {Row} row
 * @returns {[over: string, under: string][]}
 */
export function comparisons(row) {
  const ofLines = lines(row).flatMap(({ ours, peer }) =>
    (peer === "" ? ["OMPL, plain", "OMPL"] : [`OMPL${peer}`]).flatMap((over) =>
      ["native", "Node"].map((side) => /** @type {[string, string]} */ ([over, `${side}${ours}`])),
    ),
  );
  return [...ofLines, ...further[row.planner]];
}
