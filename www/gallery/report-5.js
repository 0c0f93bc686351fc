/** Report 5: probabilistic roadmaps of arms whose edges are never checked. See format.js. */

/** @import { EntryOn, Report } from "./format.js" */

const WORLD = "The obstacles, start and goal; the report has them in its pictures only.";

/**
 * A roadmap whose edges are not checked beside one whose edges are proven.
 * @param {string} name
 * @param {string} world
 * @param {string} title
 * @param {number} samples
 * @param {number} k
 * @param {number} seed
 * @param {Pick<EntryOn<"planner">, "shows" | "see" | "report" | "why">} texts
 * @returns {EntryOn<"planner">}
 */
const beside = (name, world, title, samples, k, seed, texts) => ({
  id: `5-${name}`,
  title,
  name: `${name.toUpperCase()}_test`,
  kind: "figure",
  robot: "arm",
  page: "planner",
  world,
  state: {
    view: { strobe: true, poses: 12 },
    lanes: [
      { algorithm: "prm", settings: { samples, k, edge_check: "none", seed } },
      { algorithm: "prm", settings: { samples, k, seed } },
    ],
  },
  expect: "solved",
  try: "Change the seed, or `k`: with proven edges no path collides.",
  holds: "unclear",
  chosen: WORLD,
  ...texts,
});

/** @type {Report} */
export const REPORT_5 = {
  number: 5,
  about:
    "Probabilistic roadmaps for arms of two to four links among a few obstacles. Vertices are checked for collision, edges never.",
  rows: [
    {
      row: 149,
      kind: "system",
      name: "",
      shows: "Arms of 2, 3 and 4 links of length 1, their joints\u2019 positions, and the angular distance.",
      verdict: "yes",
      where: "As in report 1.",
      entries: ["5-2r"],
      holds: "yes",
    },
    {
      row: 150,
      kind: "algorithm",
      name: "sample_configurations",
      shows: "num_samples random configurations; those in collision are dropped.",
      verdict: "yes",
      where: "`samples` of `prm` counts the free ones; a counter shows how many were drawn.",
      entries: [],
      holds: "partly",
      why: "Fewer than num_samples vertices remain.",
    },
    {
      row: 151,
      kind: "algorithm",
      name: "connect_vertices",
      shows: "The k nearest by the sum of angular distances; k * num_samples undirected edges.",
      verdict: "yes",
      where: "`prm k=... metric=sum`.",
      entries: ["5-2r"],
      holds: "partly",
      why: "Mutual neighbours are counted twice: there are fewer edges.",
    },
    {
      row: 152,
      kind: "algorithm",
      name: "",
      shows: "Edges are never checked for collision.",
      verdict: "yes",
      where:
        "`edge_check=none`, with `direct=false`; presets `unchecked-1000-4`, `unchecked-2000-4`, `unchecked-2000-6`.",
      entries: ["5-k-jumps"],
      holds: "no",
      why: "The arm jumps over obstacles.",
    },
    {
      row: 153,
      kind: "algorithm",
      name: "A*",
      shows: "A* with the same sum as its heuristic.",
      verdict: "yes",
      where: "`search=a-star`, the default.",
      entries: ["5-end-effector"],
      holds: "yes",
    },
    {
      row: 154,
      kind: "figure",
      name: "3R_test",
      shows: "Three links and two rectangles, 1000 samples, k = 4.",
      verdict: "yes",
      where: "",
      entries: ["5-3r"],
      holds: "unclear",
      why: "The rectangles are in the picture only. In ours 49 of 50 such paths collide.",
    },
    {
      row: 155,
      kind: "figure",
      name: "4R_test",
      shows: "Four links and a small circle, 2000 samples, k = 4.",
      verdict: "yes",
      where: "",
      entries: ["5-4r"],
      holds: "unclear",
      why: "The circle is in the picture only. With ours 47 of 50 such paths collide.",
    },
    {
      row: 156,
      kind: "figure",
      name: "2R_test",
      shows: "Two links and a rectangle, 2000 samples, k = 6.",
      verdict: "yes",
      where: "",
      entries: ["5-2r"],
      holds: "unclear",
      why: "The rectangle is in the picture only. With ours 29 of 50 such paths collide.",
    },
    {
      row: 157,
      kind: "figure",
      name: "",
      shows: "All configurations of a path in one picture, the start blue, the goal green.",
      verdict: "yes",
      where: "View: poses along the path, up to 24.",
      entries: ["5-3r"],
      holds: "yes",
    },
    {
      row: 158,
      kind: "claim",
      name: "",
      shows: "A heuristic by the distance of the end effector is useful where the way is straight.",
      verdict: "yes",
      where: "`heuristic=end-effector`, scaled to stay admissible.",
      entries: ["5-end-effector"],
      holds: "yes",
    },
    {
      row: 159,
      kind: "claim",
      name: "num_samples",
      shows: "More samples: denser, better and slower.",
      verdict: "yes",
      where: "`vary: { samples: [...] }` in an experiment.",
      entries: ["5-k-jumps"],
      holds: "yes",
    },
    {
      row: 160,
      kind: "claim",
      name: "k",
      shows:
        "At low density k must be low, else the arm jumps over an obstacle; a larger k improves paths at the cost of accuracy.",
      verdict: "yes",
      where: "Experiments: `arm-edge-checks`.",
      entries: ["5-k-jumps"],
      holds: "partly",
      why: "With unchecked edges, at any density. The missing check is the cause: with proven edges no k costs accuracy.",
    },
    {
      row: 161,
      kind: "claim",
      name: "",
      shows: "Not all runs generate an accurate solution; a majority does.",
      verdict: "yes",
      where: "Experiments: the share of paths that the verifier accepts.",
      entries: ["5-majority", "5-k-jumps"],
      holds: "unclear",
      why: "Its obstacles decide it, and they are in its pictures only. In our three worlds 1, 3 and 21 of 50 paths are free.",
    },
  ],
  entries: [
    beside("3r", "two-boxes-3r", "Three links and two rectangles", 1000, 4, 0, {
      shows: { waypoints: [12, 24] },
      see: "In A edges are not checked, and a path of {waypoints A} vertices goes through a rectangle; in B they are proven, and it has {waypoints B}.",
      report: "The arm finds out that it has to squeeze through clockwise.",
      why: "The rectangles are in its picture only. Among ours the arm turns clockwise, too, but 49 of 50 paths cut through one.",
    }),
    beside("4r", "disc-4r", "Four links and a disc", 2000, 4, 0, {
      shows: { waypoints: [8, 11] },
      see: "In A a path of {waypoints A} vertices leads through the disc in large steps; in B, with proven edges, one of {waypoints B} leads round it.",
      report: "Fewer configurations, as it was easier to find the solution.",
      why: "The circle is in its picture only. With ours 47 of 50 paths collide: few configurations mean long edges, and nothing looks at them.",
    }),
    beside("2r", "one-box-2r", "Two links and a rectangle", 2000, 6, 0, {
      shows: { waypoints: [19, 22] },
      see: "In A the tip cuts a corner of the rectangle, on a path of {waypoints A} vertices; in B, with proven edges, the arm folds a little more, on one of {waypoints B}.",
      report: "A tight rotation in front of the rectangle to reach the bottom.",
      why: "The rectangle is in its picture only. With ours 21 of 50 paths are free, as 2000 samples are dense in two dimensions.",
    }),
    {
      id: "5-end-effector",
      title: "Two heuristics",
      name: "",
      kind: "claim",
      robot: "arm",
      page: "planner",
      world: "one-box-2r",
      state: {
        lanes: [
          { algorithm: "prm", settings: { samples: 2000, k: 6, heuristic: "end-effector", seed: 0 } },
          { algorithm: "prm", settings: { samples: 2000, k: 6, seed: 0 } },
        ],
      },
      expect: "solved",
      shows: { visited: [870, 230] },
      see: "The same path. By the distance of the end effector, in A, the search visits {visited A} vertices; by that of the angles, in B, {visited B}.",
      try: "Set `heuristic` to none: Dijkstra\u2019s algorithm.",
      report: "The distance of angles works for more scenarios.",
      holds: "yes",
      chosen: WORLD,
    },
    {
      id: "5-majority",
      title: "How many unchecked paths are free",
      name: "Testing",
      kind: "claim",
      robot: "arm",
      page: "experiments",
      state: { document: "arm-unchecked", view: { chart: "success", measure: "valid", axis: "world" } },
      expect: "open",
      see: "The share of paths that the verifier accepts, in three worlds of ours and with the three settings of the report, 50 seeds each.",
      try: "Set `edge_check` to proven: then all paths are free.",
      report: "A majority of the runs generates a correct solution.",
      holds: "unclear",
      why: "The obstacles decide it, and they are in its pictures only. In our worlds 1, 3 and 21 of 50 paths are free, each with the settings of its test.",
      chosen: WORLD,
    },
    {
      id: "5-k-jumps",
      title: "How often the arm jumps",
      name: "k and num_samples",
      kind: "experiment",
      robot: "arm",
      page: "experiments",
      state: {
        document: "arm-edge-checks",
        view: { chart: "heat", measure: "valid", axis: "planner.k", second: "planner.edge_check" },
      },
      expect: "open",
      see: "The share of paths that the verifier accepts, over k and the check of edges.",
      try: "Put the number of samples on an axis.",
      report: "Keep k low at low density, or the arm jumps over obstacles; k improves paths at the cost of accuracy.",
      holds: "partly",
      why: "With unchecked edges, at any density: of 50 paths through 1000 samples 17, 39, 49 and 50 collide for k = 4, 6, 10 and 30. But the cause is the missing check: with proven edges none of 818 paths collides, for any k.",
      chosen: WORLD,
    },
  ],
};
