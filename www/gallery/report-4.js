/** Report 4: neighbours of an arm and a body, RRT, PRM and PRM*, A*, and a car with a blossom of controls. See format.js. */
import { ROWS_4 } from "./report-4-rows.js";

/** @import { EntryOn, Report } from "./format.js" */

const ARM = "The obstacles. The arm is the course\u2019s, not stated by the report: base (1, 1), links of 0.4 and 0.25, 0.1 wide.";
const BODY = "The obstacles; the body of 0.2 by 0.1 is the course\u2019s, not stated by the report.";
const CAR = "The obstacles. The car of 0.2 by 0.1, the limits of its controls and the goal region are the course\u2019s, not stated by the report.";
const LIST = "The list: the report\u2019s came with the course. Here it is random, seed 0.";
const EUCLIDEAN = { metric: "euclidean" };

/** Random free configurations. @param {number} figure @param {string} title @param {string} world @param {"arm" | "body"} robot @param {number} n @param {number} seed @param {string} see @returns {EntryOn<"neighbours">} */
const sampled = (figure, title, world, robot, n, seed, see) => ({
  id: `4-fig-${figure}`, title, name: `Fig. ${figure}`, kind: "figure", robot,
  page: "neighbours", world, state: { draw: { n, seed, free: true }, q: robot === "arm" ? [0, 0] : [1, 1, 0], k: 1, ask: false }, expect: "drawn",
  see, try: "Change the seed, or raise the number.", holds: "yes", chosen: robot === "arm" ? `${ARM} The number.` : BODY,
});

/** Neighbours of the arm. @param {number} figure @param {number[]} q @param {number} k @param {number} n @param {string} see @returns {EntryOn<"neighbours">} */
const ofArm = (figure, q, k, n, see) => ({
  id: `4-fig-${figure}`, title: `${k} of ${n}, nearest to (${q.join(", ")})`, name: `Fig. ${figure}`, kind: "figure", robot: "arm",
  page: "neighbours", world: "arm2-class", state: { draw: { n, seed: 0, free: false }, q, k, given: EUCLIDEAN }, expect: "found",
  see, try: "Drag the target across the border of the square: its neighbours follow.", holds: "yes", chosen: `${ARM} ${LIST}`,
});

/** Neighbours of the body. @param {number} figure @param {number[]} q @param {number} k @param {string} see @returns {EntryOn<"neighbours">} */
const ofBody = (figure, q, k, see) => ({
  id: `4-fig-${figure}`, title: `${k} placements nearest to (${q.join(", ")})`, name: `Fig. ${figure}`, kind: "figure", robot: "body",
  page: "neighbours", state: { robot: "body", draw: { n: 100, seed: 0, free: false }, q, k }, expect: "found",
  see, try: "Drag or rotate the target.", holds: "yes", chosen: `${LIST} 100 placements.`,
});

/**
 * A table of the blossom: solved by b = 1, 3, 5, and the report's trials as points.
 * @param {number} scene @param {[number, number[]][]} trials  b, and the path distance of each trial @param {string} see @param {string} report @param {"yes" | "partly" | "no"} holds @param {string} why
 * @returns {EntryOn<"experiments">}
 */
const blossom = (scene, trials, see, report, holds, why) => ({
  id: `4-table-${scene}`, title: `Controls per extension, scene ${scene}`, name: `Table ${scene}`, kind: "table", robot: "car",
  page: "experiments", state: { document: "car-blossom", worlds: [`car-${scene}`], view: {
    chart: "box", measure: "chord_length", axis: "planner.blossom",
    reported: trials.flatMap(([x, lengths]) => lengths.map((value, trial) => ({ x, value, label: `the report, scene ${scene}, trial ${trial + 1}` }))),
  } }, expect: "open",
  see, try: "Choose another measure: motions tested and clearance evaluations rise with b.", report, holds, why,
  chosen: `${CAR} Lengths are weighted distances between waypoints, as in the report; the metres driven are another measure (path length).`,
});

/** The settings of the blossom. */
const BLOSSOM = { duration_steps: 250, goal_bias: 0.05, goal_test: "ends", max_iterations: 10000, seed: 1 };

/** @type {Report} */
export const REPORT_4 = {
  number: 4,
  about: "Neighbours of an arm and a body, two indexes and their times, RRT, PRM and PRM* compared, A*, and a car whose extensions try several controls.",
  rows: ROWS_4,
  entries: [
    sampled(1, "Ten free configurations", "arm2-class", "arm", 10, 0, "Random configurations of the thick arm that touch nothing, in the workspace and in configuration space."),
    sampled(2, "Ten free configurations elsewhere", "arm2-environment-1", "arm", 10, 0, "The same in another environment."),
    ofArm(3, [0, 0], 3, 100, "The three nearest to the arm stretched out. Where angles run from 0 to 2\u03c0, (0, 0) is a corner: a distance that does not wrap would miss neighbours below 0."),
    ofArm(4, [3.14, 1.5], 6, 100, "Six nearest of 100 configurations."),
    ofArm(5, [4, 5.2], 4, 100, "Four nearest to (4, 5.2): both angles are more than half a turn, so they are negative here."),
    ofArm(6, [1.5, 1.1], 10, 100, "Ten nearest of 100 configurations."),
    ofArm(7, [5.8, -1.5], 5, 100, "Five nearest to (5.8, -1.5). The first angle is almost a whole turn, so it is a little below 0 here."),
    { id: "4-unwrapped", title: "A kd-tree that splits at \u03c0 and does not wrap", name: "1.2.2", kind: "algorithm", robot: "arm",
      page: "neighbours", world: "arm2-class", state: { draw: { n: 100, seed: 0, free: false }, q: [3.14, 0], k: 10, index: "kd-tree-unwrapped", given: EUCLIDEAN }, expect: "found",
      shows: { missed: 4 },
      see: "Of the 10 neighbours {missed} are wrong: nearer ones lie beyond the border of the square, where this tree cuts the circle.", try: "Choose the index kd-tree: nothing is missed.",
      report: "A kd-tree knows the topology, as it splits at \u03c0.", holds: "no", why: "A split orders plain numbers. To find what lies beyond \u03c0, distances to boxes must wrap, too.", chosen: `${ARM} ${LIST}` },
    { id: "4-fig-8", title: "Time of a search against k", name: "Fig. 8", kind: "table", robot: "arm",
      page: "neighbours", world: "arm2-class", state: { draw: { n: 100, seed: 0, free: false }, q: [3.14, 0], k: 20, given: EUCLIDEAN }, expect: "found",
      see: "The twenty nearest of 100. \u201cMeasure\u201d times the scan and the kd-tree.", try: "Press \u201cMeasure\u201d for k = 3, 5, 10 and 20.",
      report: "The scan takes 0.17 to 0.19 ms, the kd-tree 0.21 to 0.23 ms, whatever k is.", holds: "no", why: "Both take microseconds here. Equal and constant times measure the clock and the interpreter, not the search.",
      chosen: `${ARM} ${LIST}` },
    { id: "4-fig-9", title: "Time of a search against n", name: "Fig. 9", kind: "table", robot: "arm",
      page: "neighbours", world: "arm2-class", state: { draw: { n: 2000, seed: 0, free: false }, q: [3.14, 0], k: 3, given: EUCLIDEAN }, expect: "found",
      shows: { visited: 129 },
      see: "The three nearest of 2000. The kd-tree looks at {visited} configurations, a scan at all of them. \u201cMeasure\u201d times both for longer and longer lists.", try: "Press \u201cMeasure\u201d.",
      report: "The scan takes 0.17 ms, the kd-tree 0.20 to 0.24 ms, whatever n is: both are consistent.", holds: "no",
      why: "A scan of 2000 looks at twenty times as many as one of 100. Up to there the clock and the call hide it, also here; at 100,000 nothing does.", chosen: `${ARM} ${LIST}` },
    ofArm(10, [3.14, 0], 3, 100, "Three nearest of 100."), ofArm(11, [3.14, 0], 3, 500, "Three nearest of 500: they come closer."),
    ofArm(12, [3.14, 0], 3, 1000, "Three nearest of 1000."), ofArm(13, [3.14, 0], 3, 2000, "Three nearest of 2000: hard to distinguish from the target."),
    ofArm(14, [3.14, 0], 3, 100, "Of 100 configurations the three nearest."), ofArm(15, [3.14, 0], 5, 100, "Of 100 configurations the five nearest."),
    ofArm(16, [3.14, 0], 10, 100, "Of 100 configurations the ten nearest: half a disc at each border of the square."), ofArm(17, [3.14, 0], 20, 100, "Of 100 configurations the twenty nearest, on both sides of the border."),
    { id: "4-1-3", title: "The direction of the plain difference", name: "1.3", kind: "animation", robot: "arm",
      page: "reach", world: "arm2-class", state: { mode: "between", a: [-3, 0.5], b: [3, 0.5], faulty: [0], along: 1 }, expect: "free",
      shows: { end: -2.72 },
      see: "Joint 1 turns by the short distance, but in the direction of the plain difference: it ends at {end} and not at 3.", try: "Set joint 1 to \u201cshort\u201d.",
      report: "The distance is the short one; the direction is the sign of the difference.", holds: "no", why: "Where angles differ by more than half a turn, the short way goes in the other direction.",
      chosen: `${ARM} The configurations.` },
    { id: "4-rrt", title: "RRT with 1000 vertices", name: "1.4", kind: "algorithm", robot: "arm",
      page: "planner", world: "arm2-class", state: { query: "round", lanes: [{ algorithm: "rrt", settings: {
        extend: "half", goal_bias: 0.05, edge_check: "sampled", edge_samples: 5, vertices: 1000, metric: "euclidean", seed: 1 } }] }, expect: "solved",
      see: "Each extension goes half of the way. The tree grows past the goal until it has 1000 vertices.", try: "Seek back: the path was found early and stays.",
      report: "1000 vertices, half steps, the goal in 5 % of the samples, edges looked at in five steps.", holds: "partly", why: "Five looks miss thin obstacles; set `edge_check` to proven.", chosen: ARM },
    { id: "4-wrap", title: "A tree that wraps around", name: "1.4.2", kind: "figure", robot: "arm",
      page: "planner", world: "arm2-environment-2", state: { lanes: [{ algorithm: "rrt", settings: { extend: "half", goal_bias: 0.05, metric: "euclidean", seed: 2 } }] }, expect: "solved",
      see: "Edges that leave the square at one side come in at the opposite side.", try: "Show the torus of the configuration space with other axes or scenes.", holds: "yes", chosen: ARM },
    { id: "4-prm", title: "PRM one by one, Dijkstra", name: "1.5", kind: "algorithm", robot: "arm",
      page: "planner", world: "arm2-class", state: { query: "round", lanes: [{ algorithm: "prm", settings: { samples: 1000, k: 3, insertion: "one-by-one", search: "dijkstra", metric: "euclidean", seed: 1 } }] }, expect: "solved",
      see: "A roadmap of 1000 configurations, each connected to the three nearest before it; Dijkstra\u2019s algorithm finds the shortest path in it.",
      try: "Set `search` to a-star: the same path for fewer visits.", holds: "yes", chosen: ARM },
    { id: "4-tree1", title: "PRM with 100 nodes", name: "arm1.5-tree1", kind: "animation", robot: "arm",
      page: "planner", world: "arm2-class", state: { query: "pair-3", lanes: [{ algorithm: "prm", settings: { samples: 100, k: 3, insertion: "one-by-one", search: "dijkstra", metric: "euclidean", seed: 1 } }] }, expect: "solved",
      see: "The same with 100 configurations, one after the other.", try: "Play it from the start; export it as a film.", report: "More nodes took too long to animate.", holds: "yes", chosen: ARM },
    { id: "4-prm-star", title: "PRM* with two numbers of neighbours", name: "1.5.2", kind: "algorithm", robot: "arm",
      page: "planner", world: "arm2-class", state: { query: "round", lanes: [
        { algorithm: "prm-star", settings: { samples: 1000, k_rule: "log-n", search: "dijkstra", metric: "euclidean", seed: 1 } },
        { algorithm: "prm-star", settings: { samples: 1000, search: "dijkstra", metric: "euclidean", seed: 1 } }] }, expect: "solved",
      shows: { edges: [4071, 15684] },
      see: "In A k = ln n; in B about four times as much, as Karaman and Frazzoli require: {edges A} and {edges B} edges.", try: "Compare lengths and clearance evaluations in the table of the race.",
      report: "PRM* is PRM with k = log n.", holds: "partly", why: "Only k above e (1 + 1/d) ln n has the proof that paths approach the shortest.", chosen: ARM },
    { id: "4-pair-1", title: "A pair that cannot be asked", name: "1.5.3, pair 1", kind: "experiment", robot: "arm",
      page: "planner", world: "arm2-class", state: { query: "pair-1 (start and goal in collision)", iteration: 0, lanes: [{ algorithm: "prm", settings: { samples: 1000, k: 3, seed: 1 } }] }, expect: "refused",
      see: "Start and goal are in collision. The page names what touches what, and plans nothing.", try: "Choose the query pair-3.",
      report: "PRM and PRM* have very low success rates.", holds: "unclear",
      why: "The report\u2019s environments are not in its text. In this world of ours pair 1 has no path for any planner, and such runs are no failures of PRM.",
      chosen: `${ARM} In the course\u2019s first world four of the five pairs are in collision.` },
    { id: "4-comparison", title: "RRT, PRM and PRM* compared", name: "1.5.3", kind: "experiment", robot: "arm",
      page: "experiments", state: { document: "arm-planners", view: { chart: "box", measure: "length", axis: "world" } }, expect: "open",
      see: "Five environments, each with its own pair of start and goal, three planners, 200 seeds each.", try: "Choose the chart of success: there is hardly a failure.",
      report: "RRT succeeds most often, PRM and PRM* rarely within 1000 nodes; their paths are more direct.", holds: "partly",
      why: "The paths are more direct. Success cannot be told without its environments: in ours all three nearly always succeed.", chosen: `${ARM} The five environments.` },
    { id: "4-race", title: "RRT beside PRM", name: "1.5.3", kind: "claim", robot: "arm",
      page: "planner", world: "arm2-environment-4", state: { lanes: [
        { algorithm: "rrt", settings: { extend: "half", goal_bias: 0.05, metric: "euclidean", max_iterations: 1000, seed: 1 } },
        { algorithm: "prm", settings: { samples: 1000, k: 3, insertion: "one-by-one", search: "dijkstra", metric: "euclidean", seed: 1 } }] }, expect: "solved",
      see: "A: the tree has its path long before B, the roadmap, is built. The path of the roadmap is shorter.", try: "Play both along their paths.",
      report: "PRM takes much longer; RRT moves back and forth.", holds: "yes", chosen: ARM },
    ...[1, 2, 3].flatMap((scene) => [0, 1, 2].map((seed) => sampled(15 + 3 * scene + seed, `Five free placements, environment ${scene}, draw ${seed + 1}`, `rigid-${scene}`, "body", 5, seed, "Five random placements of the body that touch nothing, each with its centre."))),
    ofBody(27, [1, 1, 0], 3, "The three placements nearest to the target."), ofBody(28, [0.5, 0.5, 0], 3, "The three nearest to a target near a corner."),
    ofBody(29, [0.75, 0.5, 0.2], 4, "The four nearest: position counts most."), ofBody(30, [1, 1.5, -0.2], 4, "The four nearest to a target that is slightly turned."),
    ofBody(31, [0.4, 0.5, -0.3], 5, "Five neighbours, numbered by rank, easy to find."),
    { id: "4-2-3", title: "A body along the straight line", name: "2.3", kind: "animation", robot: "body",
      page: "reach", world: "rigid-1", state: { mode: "between", a: [0.25, 0.3, 3], b: [1.6, 0.3, -3], along: 0.5 }, expect: "free",
      shows: { turn: 0.28 },
      see: "The body moves straight and turns by {turn} radians, the short way.", try: "Turn the other way round.", holds: "yes", chosen: `${BODY} Start and goal.` },
    { id: "4-2-4", title: "RRT to the last free point", name: "Algorithm 2", kind: "algorithm", robot: "body",
      page: "planner", world: "rigid-1", state: { query: "1-1", lanes: [{ algorithm: "rrt", settings: { extend: "until-obstacle", goal_bias: 0.05, vertices: 1000, seed: 1 } }] }, expect: "solved",
      see: "Every extension goes on until an obstacle stops it; the tree grows to 1000 vertices, past the goal.", try: "Set `extend` to step.", holds: "yes", chosen: `${BODY} N and the rate of the goal.` },
    { id: "4-approximate", title: "The path to the nearest vertex", name: "Algorithm 2, end", kind: "algorithm", robot: "body",
      page: "planner", world: "rigid-3", state: { query: "3-2", lanes: [{ algorithm: "rrt", settings: { extend: "until-obstacle", goal_bias: 0.05, max_iterations: 150, seed: 17 } }] }, expect: "exhausted",
      see: "After 150 iterations the goal is not reached: the dashed path leads to the vertex nearest to it.", try: "Raise `max_iterations`.",
      report: "If the goal is not in the tree, return the path to the nearest vertex.", holds: "yes", chosen: `${BODY} 150 iterations.` },
    { id: "4-2-5", title: "PRM of a body", name: "Algorithms 3, 4", kind: "algorithm", robot: "body",
      page: "planner", world: "rigid-3", state: { query: "3-1", lanes: [{ algorithm: "prm", settings: { samples: 500, k: 3, insertion: "one-by-one", seed: 1 } }] }, expect: "solved",
      see: "Each placement is connected to its three nearest before it. One roadmap serves many queries.", try: "Choose the query 3-2, or \u201cAsk this roadmap from here\u201d.", holds: "yes", chosen: `${BODY} N = 500 and k = 3.` },
    { id: "4-a-star", title: "A* at work", name: "Algorithm 5", kind: "algorithm", robot: "body",
      page: "planner", world: "rigid-1", state: { query: "1-2", iteration: 1326, lanes: [{ algorithm: "prm", settings: { samples: 500, k: 5, search: "a-star", seed: 1 } }] }, expect: "running",
      see: "The search in its middle: visited vertices, and the frontier that waits.", try: "Step on, and watch which vertex is next. Set \u201cSearch\u201d to \u201ca-star-stale\u201d for the report\u2019s own.",
      report: "A* lowers G of a node that is in the fringe already.", holds: "no", why: "Its place in the heap stays, and no parent is stored: the path may be longer, and cannot be read off.", chosen: `${BODY} 500 samples and k = 5.` },
    { id: "4-consistent", title: "A* and Dijkstra agree", name: "2.5.2", kind: "claim", robot: "body",
      page: "planner", world: "rigid-1", state: { query: "1-2", lanes: [
        { algorithm: "prm", settings: { samples: 500, k: 5, search: "a-star", seed: 1 } }, { algorithm: "prm", settings: { samples: 500, k: 5, search: "dijkstra", seed: 1 } }] }, expect: "solved",
      shows: { length: [1.89, 1.89], visited: [78, 276] },
      see: "The same roadmap, and paths of {length A} and {length B}. A*, in A, visits {visited A} vertices, Dijkstra\u2019s algorithm, in B, {visited B}.", try: "Change the seed: the lengths always agree.",
      report: "A proof that the heuristic is consistent.", holds: "partly", why: "The statement is right. The second case of the proof assumes what it shows.", chosen: BODY },
    { id: "4-drive", title: "A car driven by keys", name: "3.1", kind: "interaction", robot: "car",
      page: "planner", world: "car-1", state: { iteration: 0, lanes: [{ algorithm: "rrt-control", settings: BLOSSOM }], drive: { keys: "", steps: 0 } }, expect: "running",
      see: "The car at its start, at rest.", try: "Up and Down change v by 0.1, Left and Right phi by \u03c0/12, C holds both.",
      report: "Right increases phi.", holds: "partly", why: "By its own equation that turns the car to the left. Here Left does.", chosen: CAR },
    { id: "4-3-2", title: "Euler\u2019s steps beside the arc", name: "3.2", kind: "algorithm", robot: "car",
      page: "planner", world: "car-1", state: { iteration: 0, lanes: [{ algorithm: "rrt-control", settings: BLOSSOM }], roll: [0.5, 0.7, 1.5], euler: 0.25 }, expect: "running", shows: { apart: 0.125 },
      see: "One control held for 1.5 s: the exact arc, and dashed Euler\u2019s steps of 0.25 s, which end {apart} m from its end.",
      try: "Choose steps of 0.01 s, as in the report: half a turn ends 5 mm off. Then hold it for a whole turn, 3 s: both come back to the start.",
      report: "Steps q(t + 0.01) = q(t) + 0.01 q\u2019(t).", holds: "partly",
      why: "Their places lie on another circle, which is larger and turned back by half the turn of a step. The gap is proportional to the step.", chosen: `${CAR} The control; the longer step, for the gap to be seen.` },
    { id: "4-euler-trees", title: "A tree by Euler\u2019s steps, and one by arcs", name: "3.2", kind: "algorithm", robot: "car",
      page: "planner", world: "car-2", state: { lanes: [
        { algorithm: "rrt-control", settings: { ...BLOSSOM, blossom: 3, integration: "euler", seed: 6 } }, { algorithm: "rrt-control", settings: { ...BLOSSOM, blossom: 3, seed: 6 } }] }, expect: "solved",
      see: "In A motions by Euler\u2019s steps, in B exact arcs.", try: "Verify both results: only the arcs are what a car drives.",
      report: "Steps q(t + 0.01) = q(t) + 0.01 q\u2019(t).", holds: "partly", why: "Euler\u2019s steps leave the circle that the car drives, in proportion to the step.", chosen: CAR },
    { id: "4-voronoi", title: "Large regions pull the tree", name: "3.3.4", kind: "claim", robot: "arm",
      page: "planner", state: { scene: "pillar", iteration: 120, view: { regions: true }, lanes: [{ algorithm: "rrt", settings: { step: 0.3, seed: 15 } }] }, expect: "running",
      see: "Each place has the colour of the vertex nearest to it. A sample falls into a large region more often, and so the vertex at the edge of the tree grows.",
      try: "Step on, and watch the largest region become small.", report: "Vertices with large Voronoi regions are extended more often.", holds: "yes",
      chosen: "An arm of two joints, whose regions can be drawn; the scene and the seed." },
    { id: "4-blossom", title: "Three controls per extension", name: "Algorithm 6", kind: "algorithm", robot: "car",
      page: "planner", world: "car-1", state: { iteration: 137, lanes: [{ algorithm: "rrt-control", settings: { ...BLOSSOM, blossom: 3 } }] }, expect: "running",
      see: "At each vertex three random controls are tried, for 250 steps each. The one that ends nearest to the sample is kept.", try: "Step on. Set `blossom` to 1 or 5.",
      report: "With a larger blossom the tree comes closer to where it should.", holds: "yes", chosen: CAR },
    blossom(1, [[1, [8.62, 7.81, 9.39, 4.97, 6.71]], [3, [4.87, 7.37, 3.77, 5.81, 8.81]], [5, [6.32, 5.58, 5.59, 3.44, 4.45]]],
      "Lengths of the paths for b = 1, 3 and 5, 200 seeds each, and the report\u2019s trials of scene 1 as points.", "Path and time fall as b grows: 7.5, 6.1, 5.1 and 144, 128, 92 s.", "partly",
      "The path gets shorter: 6.6, 6.3, 5.6 here. The work does not: 736, 1977 and 2860 motions. Five trials cannot tell their times apart."),
    blossom(2, [[1, [6.83, 8.63, 11.99, 9.11, 6.84]], [3, [5.47, 6.19, 4.43, 8.36, 7.89]], [5, [12.57, 8.6, 8.13, 7.78, 7.4]]],
      "The same with the report\u2019s trials of scene 2.", "Best at b = 3, worse at 5: 8.7, 6.5, 8.9 and 489, 64, 239 s, as the scene is sparse.", "no",
      "In our scene, with 200 seeds, there is no dip: 6.8, 5.9, 5.5. One run of 1256 s makes the mean of the first."),
    blossom(3, [[1, [8.78, 3.82, 3.9, 8.05, 6.61]], [3, [3.95, 7.56, 7, 6.76, 3.56]], [5, [11.13, 6.32, 2.99, 3.65, 3.25]]],
      "The same with the report\u2019s trials of scene 3.", "Both fall: 6.2, 5.8, 5.5 and 170, 151, 146 s.", "partly",
      "The path does: 6.1, 5.5, 5.3. The report\u2019s five trials do not show it, and the work rises: 492, 1017, 1785 motions."),
    { id: "4-success", title: "Do 10,000 iterations suffice?", name: "3.3.3 to 3.3.5", kind: "claim", robot: "car",
      page: "experiments", state: { document: "car-blossom", view: { chart: "ecdf", work: "iterations" } }, expect: "open",
      see: "The share of runs that have a path after each number of iterations.", try: "Choose clearance evaluations as the work.",
      report: "All 45 runs found a path, so 10,000 iterations suffice.", holds: "yes", why: "1796 of 1800 here; 45 of 45 alone shows no more than 92 %.", chosen: CAR },
  ],
};
