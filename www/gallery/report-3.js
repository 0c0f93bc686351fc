/** Report 3: a thick arm, a rigid body and a car: samples, neighbours, straight motions, RRT and PRM. See format.js. */

/** @import { EntryOn, Report } from "./format.js" */

const ARM = "The obstacles. The arm is the course\u2019s, not stated by the report: base (1, 1), links of 0.4 and 0.25, 0.1 wide.";
const BODY = "The obstacles; the body of 0.2 by 0.1 is the course\u2019s, not stated by the report.";
const CAR = "The obstacles, start and goal. The car of 0.2 by 0.1, the limits of its controls and the goal region are the course\u2019s.";
const LIST = "The list: the report\u2019s came with the course. Here it is 100 random placements, seed 0.";

/** The nearest placements of a body. @param {number} number @param {number[]} q @param {number} k @param {string} see @returns {EntryOn<"neighbours">} */
const nearest = (number, q, k, see) => ({
  id: `3-2-2-${number}`, title: `The ${k} placements nearest to (${q.join(", ")})`, name: `2.2, picture ${number}`, kind: "figure", robot: "body",
  page: "neighbours", state: { robot: "body", draw: { n: 100, seed: 0, free: false }, q, k }, expect: "found",
  see, try: "Drag the target: its neighbours follow.", holds: "yes", chosen: LIST,
});

/** @param {number} scene @param {number} query @param {number} seed @returns {EntryOn<"planner">} */
const rrt = (scene, query, seed) => ({
  id: `3-2-4-${2 * scene + query - 2}`, title: `RRT of a body, scene ${scene}, query ${query}`, name: `2.4-${2 * scene + query - 2}`, kind: "animation", robot: "body",
  page: "planner", world: `rigid-${scene}`, state: {
    query: `${scene}-${query}`, lanes: [{ algorithm: "rrt", settings: { goal_every: 5, max_iterations: 2000, seed } }],
  }, expect: "solved",
  see: "A tree grows from the start; every fifth sample is the goal. The first path ends the run, so it has needless bends.",
  try: "Set `shortcut` to 60: the same path without the bends.", report: "RRT finds paths quickly and nearly always, of low quality.",
  holds: "yes", chosen: BODY,
});

/** @param {number} scene @param {number} query @param {number} seed @returns {EntryOn<"planner">} */
const prm = (scene, query, seed) => ({
  id: `3-2-5-${2 * scene + query - 2}`, title: `PRM of a body, scene ${scene}, query ${query}`, name: `2.5-${2 * scene + query - 2}`, kind: "animation", robot: "body",
  page: "planner", world: `rigid-${scene}`, state: {
    query: `${scene}-${query}`, lanes: [{ algorithm: "prm", settings: { samples: 500, k: 3, insertion: "one-by-one", discard: true, seed } }],
  }, expect: "solved",
  see: "500 placements, each connected to some of its three nearest; one that connects to none is discarded. A* finds the path.",
  try: "Move the robot by hand and choose \u201cAsk this roadmap from here\u201d: the answer takes no further iteration.",
  report: "PRM is slow to build; then it answers quickly, and its paths are better than those of RRT.", holds: "yes", chosen: BODY,
});

/** @param {number} scene @param {number} seed @returns {EntryOn<"planner">} */
const schedule = (scene, seed) => ({
  id: `3-3-3-${scene}`, title: `RRT of a car, scene ${scene}`, name: `car${scene + 2}`, kind: "animation", robot: "car",
  page: "planner", world: `car-${scene}`, state: {
    lanes: [{ algorithm: "rrt-control", settings: {
      blocked: "refused", blossom: 30, duration_steps: 200, goal_every: 10, goal_test: "ends", late_duration_steps: 100, late_goal_every: 5, max_iterations: 4000, seed,
    } }],
  }, expect: "solved",
  see: "Of 30 random controls the one that ends nearest to the sample is kept. In the last quarter of the 4000 iterations they last half as long.",
  try: "Set `blossom` to 3: a wider tree for less work.", report: "A path in the vast majority of runs, fewer than for the body, and often late.",
  holds: "yes", chosen: `${CAR} Two steps forward are taken to be 2 s.`,
});

/** @type {Report} */
export const REPORT_3 = {
  number: 3,
  about: "A thick arm of two links, a rigid body and a car: free samples, neighbours, straight motions, RRT, PRM, and driving.",
  rows: [
    { row: 65, kind: "figure", name: "1.1", shows: "Collision-free configurations of the arm, sampled at random.", verdict: "yes",
      where: "Neighbours: any scenario, from one configuration on, with the robots drawn; `sampleConfigurations(n, { free: true })`.", entries: ["3-1-1"], holds: "yes" },
    { row: 66, kind: "function", name: "1.1", shows: "Collision of a thick arm: a rectangle for each link, a disc for each joint.", verdict: "yes",
      where: "`radius` of an arm; links are capsules, discs are not made polygons.", entries: ["3-1-1"], holds: "yes" },
    { row: 67, kind: "interaction", name: "rotate_joint", shows: "A key turns a joint by 5 degrees; a turn that collides is taken back.", verdict: "yes",
      where: "Reach: the digits turn a joint by 5 degrees, with \u201cTake back what collides\u201d.", entries: ["3-keys"], holds: "yes" },
    { row: 68, kind: "function", name: "collides", shows: "Two polygons collide if edges cross or a vertex of one is inside the other.", verdict: "yes",
      where: "`check(q)`; polygons may be concave.", entries: [], holds: "yes" },
    { row: 69, kind: "figure", name: "1.2", shows: "The three nearest by a linear scan, by the Euclidean distance of the angles.", verdict: "yes",
      where: "Neighbours: index `linear`, metric `naive`.", entries: ["3-1-2"], holds: "no", why: "Angles wrap: 0.1 and 6.2 are 0.18 apart, and this distance says 6.1." },
    { row: 70, kind: "claim", name: "1.2", shows: "For large sets use kd-trees or ball trees.", verdict: "yes", where: "Neighbours: \u201cMeasure\u201d.", entries: ["4-fig-9"], holds: "yes" },
    { row: 71, kind: "animation", name: "1.3", shows: "Interpolation by the weighted average of the angles.", verdict: "yes",
      where: "Reach: \u201cFrom A to B\u201d, each joint the short or the long way.", entries: ["3-1-3"], holds: "partly",
      why: "Where two angles differ by more than half a turn, the average goes the long way." },
    { row: 72, kind: "algorithm", name: "1.4", shows: "RRT for the arm, with a rate of goal samples, steps, and a threshold at the goal.", verdict: "yes",
      where: "`rrt` with `goal_bias` or `goal_every`, `step`, `max_iterations`; the threshold is the `goal_tolerance` of a query.", entries: ["3-1-4"], holds: "partly",
      why: "A path that ends near the goal counts as one to the goal. Here that is so only where the query has a tolerance." },
    { row: 73, kind: "algorithm", name: "1.5", shows: "PRM for the arm: neighbours by a kd-tree of the angles, the path by parents.", verdict: "yes",
      where: "`prm` with `insertion=one-by-one neighbour_metric=naive`; the path by parents is `search=parents`.", entries: ["3-1-5"], holds: "no",
      why: "A vertex with several neighbours has one parent, the last: the path is not the shortest and may miss the start." },
    { row: 74, kind: "figure", name: "2.1", shows: "Collision-free placements of a body inside a square of 2 by 2.", verdict: "yes",
      where: "Neighbours: any scenario, from one configuration on.", entries: ["3-2-1"], holds: "yes" },
    { row: 75, kind: "figure", name: "2.2", shows: "Target (1, 1, 0), k = 3.", verdict: "yes", where: "Neighbours: \u201cRotating body\u201d.", entries: ["3-2-2-1"], holds: "yes" },
    { row: 76, kind: "figure", name: "2.2", shows: "Target (0.5, 0.5, 0), k = 4.", verdict: "yes", where: "Neighbours: \u201cRotating body\u201d.", entries: ["3-2-2-2"], holds: "yes" },
    { row: 77, kind: "figure", name: "2.2", shows: "Target (0.5, 0.5, 1), k = 4.", verdict: "yes", where: "Neighbours: \u201cRotating body\u201d.", entries: ["3-2-2-3"], holds: "yes" },
    { row: 78, kind: "figure", name: "2.2", shows: "Target (1.75, 1.75, 0), k = 4.", verdict: "yes", where: "Neighbours: \u201cRotating body\u201d.", entries: ["3-2-2-4"], holds: "yes" },
    { row: 79, kind: "figure", name: "2.2", shows: "Target (1.75, 1.75, 0), k = 20.", verdict: "yes", where: "Neighbours: \u201cRotating body\u201d.", entries: ["3-2-2-5"], holds: "yes" },
    { row: 80, kind: "function", name: "2.2", shows: "Distance 0.7 e + 0.3 r, where r is half the difference of the angles.", verdict: "yes",
      where: "`metric: { translation: 0.7, rotation: 0.15 }` of a body; Neighbours: weights.", entries: ["3-weights"], holds: "partly",
      why: "Half the angle makes the weight of a radian 0.15, not 0.3 as stated." },
    { row: 81, kind: "animation", name: "2.3-1 to 2.3-3", shows: "The body along the straight line in configuration space, the goal in red.", verdict: "yes",
      where: "Reach: \u201cFrom A to B\u201d of a body; `interpolate(a, b, t)`.", entries: ["3-2-3"], holds: "yes" },
    { row: 82, kind: "animation", name: "2.4-1 to 2.4-6", shows: "RRT for the body: at most 2000 samples, every fifth the goal, the first path is returned.", verdict: "yes",
      where: "`rrt`, preset `every-fifth`.", entries: ["3-2-4-1", "3-2-4-2", "3-2-4-3", "3-2-4-4", "3-2-4-5", "3-2-4-6"], holds: "yes" },
    { row: 83, kind: "claim", name: "2.4", shows: "RRT: very high success, quick, paths not of the highest quality.", verdict: "yes",
      where: "Experiments: `body-planners`.", entries: ["3-rrt-prm"], holds: "yes", why: "Here 1192 of 1200 runs, 200 for each of the six queries, found a path." },
    { row: 84, kind: "animation", name: "2.5-1 to 2.5-6", shows: "PRM for the body: 500 nodes, k = 3, a node without an edge is discarded, A*.", verdict: "yes",
      where: "`prm`, preset `three-nearest`.", entries: ["3-2-5-1", "3-2-5-2", "3-2-5-3", "3-2-5-4", "3-2-5-5", "3-2-5-6"], holds: "yes" },
    { row: 85, kind: "claim", name: "2.5", shows: "PRM is slower to build, its queries are fast, its paths better than those of RRT.", verdict: "yes",
      where: "\u201cAsk this roadmap\u201d; `planner.query`.", entries: ["3-rrt-prm", "3-2-5-1"], holds: "yes",
      why: "Median lengths of the six queries: RRT 2.1 to 3.6, PRM 1.8 to 2.9, each over 200 seeds." },
    { row: 86, kind: "interaction", name: "car1", shows: "A car driven by keys.", verdict: "yes", where: "\u201cDrive\u201d of any car scene.", entries: ["3-car1"], holds: "partly",
      why: "It is called a differential drive with changes; such a drive can turn on the spot, and this car cannot." },
    { row: 87, kind: "animation", name: "car2", shows: "The car under one constant control.", verdict: "yes",
      where: "\u201cDrive\u201d: v, phi and seconds; `rollout`.", entries: ["3-car2"], holds: "yes" },
    { row: 88, kind: "algorithm", name: "car3 to car5", shows: "RRT for the car: 30 controls, 4000 samples, shorter motions and more goals in the last quarter.", verdict: "yes",
      where: "`rrt-control`, preset `schedule`.", entries: ["3-3-3-1", "3-3-3-2", "3-3-3-3"], holds: "yes" },
    { row: 89, kind: "claim", name: "3.3", shows: "A path in the vast majority of runs, fewer than for the body, often found slowly.", verdict: "yes",
      where: "Experiments: `car-schedule`.", entries: ["3-late", "3-3-3-1", "3-3-3-2", "3-3-3-3"], holds: "yes", why: "Here 189, 152 and 181 of 200 runs in the three scenes; for the body 1192 of 1200." },
  ],
  entries: [
    { id: "3-1-1", title: "Ten free configurations of a thick arm", name: "1.1", kind: "figure", robot: "arm",
      page: "neighbours", world: "arm2-class", state: { draw: { n: 10, seed: 0, free: true }, q: [0, 0], k: 1, ask: false }, expect: "drawn",
      see: "Ten random configurations that touch nothing, and where they are in configuration space.", try: "Raise the number: the dots leave out the obstacles\u2019 shadows.",
      holds: "yes", chosen: ARM },
    { id: "3-keys", title: "Joints turned by 5 degrees", name: "rotate_joint", kind: "interaction", robot: "arm",
      page: "reach", world: "arm2-class", state: { q: [0.6, 0.4], back: true }, expect: "free",
      see: "Each press turns a joint by five degrees. A turn that would collide is taken back.", try: "Click the stage, then press 1 and 2, with Shift the other way.", holds: "yes", chosen: ARM },
    { id: "3-1-2", title: "Three nearest without wrap-around", name: "1.2", kind: "figure", robot: "arm",
      page: "neighbours", state: { robot: "two", draw: { n: 100, seed: 1, free: false }, q: [0.05, 3.1], k: 3, index: "linear", given: { metric: "naive" } }, expect: "found",
      shows: { missed: 2 },
      see: "Of the 3 neighbours by the plain distance {missed} are wrong: nearer ones lie beyond the dashed line, where it cuts the circle.", try: "Choose another metric: nothing is missed.",
      report: "The Euclidean distance of the angles suits this space.", holds: "no", why: "An angle just below 2\u03c0 is close to one just above 0.", chosen: "The list: the report\u2019s came with the course. Here it is 100 random configurations, seed 1." },
    { id: "3-1-3", title: "The average of two angles", name: "1.3", kind: "animation", robot: "arm",
      page: "reach", world: "arm2-class", state: { mode: "between", a: [-3, 0.5], b: [3, 0.5], long: [0], along: 0.5 }, expect: "free",
      shows: { length: 6 },
      see: "Joint 1 turns by {length} radians and meets an obstacle, though the other way is short.", try: "Set joint 1 to \u201cshort\u201d.",
      report: "A weighted average moves smoothly from one configuration to the other.", holds: "partly", why: "Smoothly, but the long way where angles differ by more than half a turn.",
      chosen: `${ARM} The configurations.` },
    { id: "3-1-4", title: "RRT of a thick arm", name: "1.4", kind: "algorithm", robot: "arm",
      page: "planner", world: "arm2-class", state: { query: "round", lanes: [{ algorithm: "rrt", settings: { goal_bias: 0.05, step: 0.3, metric: "euclidean", seed: 1 } }] }, expect: "solved",
      see: "The tree grows towards random configurations, and towards the goal in one of twenty iterations.", try: "Drag the goal.",
      report: "The run ends when a node is within a threshold of the goal.", holds: "partly", why: "Such a path ends near the goal. Here it ends in the goal, unless the query has a tolerance.",
      chosen: `${ARM} Rate, step and seed.` },
    { id: "3-1-5", title: "PRM by neighbours that do not wrap", name: "1.5", kind: "algorithm", robot: "arm",
      page: "planner", world: "arm2-class", state: {
        query: "round", lanes: [{ algorithm: "prm", settings: { samples: 300, k: 5, insertion: "one-by-one", metric: "euclidean", neighbour_metric: "naive", seed: 0 } }],
      }, expect: "solved",
      shows: { edges: 1399, crossings: 3 },
      see: "Of {edges} edges only {crossings} cross a dashed line at 0, where this distance cuts the circles; many cross the border at \u03c0.",
      try: "Set \u201cMetric of neighbours\u201d to that of the edges: then many cross the lines at 0 as well. Set \u201cSearch\u201d to \u201cparents\u201d: the path misses the start, or is longer.",
      report: "The path follows the parent of each node from the goal to the start.", holds: "no", why: "A node has many neighbours and only its last parent. A search finds the shortest path.",
      chosen: `${ARM} 300 samples and k = 5.` },
    { id: "3-2-1", title: "Free placements of a body", name: "2.1", kind: "figure", robot: "body",
      page: "neighbours", world: "rigid-1", state: { draw: { n: 5, seed: 0, free: true }, q: [1, 1, 0], k: 1, ask: false }, expect: "drawn",
      see: "Five random placements that touch nothing and stay inside the square.", try: "Draw others with another seed.", holds: "yes", chosen: `${BODY} The number.` },
    nearest(1, [1, 1, 0], 3, "The three of 100 placements that are nearest to the target in position and direction."),
    nearest(2, [0.5, 0.5, 0], 4, "The four nearest to a target near a corner."),
    nearest(3, [0.5, 0.5, 1], 4, "The same place, turned by 1 radian: other neighbours."),
    nearest(4, [1.75, 1.75, 0], 4, "The four nearest to a target in the upper right corner."),
    nearest(5, [1.75, 1.75, 0], 20, "Twenty neighbours: among the last are some far away that point the same way."),
    { id: "3-weights", title: "Half the angle", name: "2.2", kind: "function", robot: "body",
      page: "neighbours", state: { robot: "body", draw: { n: 100, seed: 0, free: false }, weights: [0.7, 0.15], q: [1.75, 1.75, 0], k: 4 }, expect: "found",
      see: "With 0.15 for a radian, closer placements win, whatever way they point.", try: "Set the weight of a radian to 0.3.",
      report: "0.7 e + 0.3 r, with r half the difference of the angles.", holds: "partly", why: "That is a weight of 0.15 for a radian.", chosen: LIST },
    { id: "3-2-3", title: "A body along the straight line", name: "2.3-1", kind: "animation", robot: "body",
      page: "reach", world: "rigid-1", state: { mode: "between", a: [0.25, 0.3, 3], b: [1.6, 0.3, -3], along: 0.5 }, expect: "free",
      shows: { turn: 0.28 },
      see: "The body moves straight and turns by {turn} radians, the short way.", try: "Turn the other way round.", holds: "yes", chosen: `${BODY} Start and goal.` },
    rrt(1, 1, 3), rrt(1, 2, 1), rrt(2, 1, 7), rrt(2, 2, 6), rrt(3, 1, 3), rrt(3, 2, 2),
    prm(1, 1, 1), prm(1, 2, 1), prm(2, 1, 1), prm(2, 2, 1), prm(3, 1, 1), prm(3, 2, 1),
    { id: "3-rrt-prm", title: "RRT and PRM of a body compared", name: "2.4, 2.5", kind: "claim", robot: "body",
      page: "experiments", state: { document: "body-planners", view: { chart: "box", measure: "length", axis: "query" } }, expect: "open",
      see: "Lengths of the paths of both planners, six queries in three scenes, 200 seeds each.", try: "Choose the chart of success, then clearance evaluations: RRT needs far fewer.",
      report: "RRT is quick and nearly always successful; the paths of PRM are better, and further queries are fast.", holds: "yes", chosen: BODY },
    { id: "3-car1", title: "A car driven by keys", name: "car1", kind: "interaction", robot: "car",
      page: "planner", world: "car-1", state: {
        iteration: 0, lanes: [{ algorithm: "rrt-control", settings: { seed: 1 } }], drive: { keys: "0w5w5w5w5w150a5a100d5d90s5s5s5s5s", steps: 400 },
      }, expect: "running",
      see: "A recorded drive: forward, to the left, straight on, and to rest.", try: "Drive on with the arrow keys. The car stops before it touches anything.",
      report: "The model is a differential drive with changes.", holds: "partly", why: "A differential drive turns on the spot; this is a car.", chosen: CAR },
    { id: "3-car2", title: "One control held", name: "car2", kind: "animation", robot: "car",
      page: "planner", world: "car-1", state: { iteration: 0, lanes: [{ algorithm: "rrt-control", settings: { seed: 1 } }], roll: [0.5, 0.7, 3] }, expect: "running",
      see: "With v = 0.5 and phi = 0.7 for 3 s: the car drives along a circle and meets its start.", try: "Change v, phi or the seconds.", holds: "yes", chosen: `${CAR} The control.` },
    schedule(1, 4), schedule(2, 6), schedule(3, 11),
    { id: "3-late", title: "Shorter motions late", name: "3.3", kind: "claim", robot: "car",
      page: "experiments", state: { document: "car-schedule", view: { chart: "ecdf", work: "iterations" } }, expect: "open",
      see: "The share of runs with a path after each number of iterations, with the schedule and without it, in three scenes.", try: "Look at the curves beyond 3000 iterations: they are nearly flat.",
      report: "Shorter motions and more goals in the last quarter adjust the tree near the goal.", holds: "no", why: "Without the schedule as many runs find a path: 189, 159 and 180 of 200, against 189, 152 and 181 with it.", chosen: CAR },
  ],
};
