/**
 * Robots of one's own: the arms of generated forests, told to `Problem` by functions in JavaScript, beside the same arms as scenarios.
 *
 *   node benches/own.mjs [SEEDS] [FILE...]   scenarios of arms in place of the generated ones
 *
 * For each arm: milliseconds to the first path by RRT-Connect, median; that time over the time in the function; how many
 * configurations it got, in how many calls. The last row of an arm is OxMPL's package for JavaScript with the same function, which it
 * calls for one configuration at a time.
 */
import { readFileSync } from "node:fs";
import { basename } from "node:path";
import { Problem, Scenario } from "planarium";
import { digits, quantile, table } from "./peers/report.mjs";
import { oxmplInJavaScript } from "./peers/sides.mjs";

/** @typedef {import("planarium").ScenarioDocument} Document */
/** @typedef {{ milliseconds: number, inside: number, calls: number, configurations: number }} Run */

/** The distance of two neighbouring samples, radians in the sum metric: as the peers sample. */
const RESOLUTION = 0.05;

/** The squared distance of a point and a segment. @param {number} px @param {number} py @param {number} ax @param {number} ay @param {number} bx @param {number} by */
function toSegment(px, py, ax, ay, bx, by) {
  const dx = bx - ax, dy = by - ay;
  const along = Math.max(0, Math.min(1, ((px - ax) * dx + (py - ay) * dy) / (dx * dx + dy * dy)));
  return (px - ax - along * dx) ** 2 + (py - ay - along * dy) ** 2;
}

/** The distance of an arm's links from discs and polygons, 0 if they touch. @param {Document} document */
function distanceOf({ world: { obstacles }, robot }) {
  if (robot.type !== "arm") throw new Error("only arms are told here");
  const { base, links, radius = 0 } = robot;
  // Each obstacle in a circle; the edges of a polygon by both ends.
  const around = obstacles.map((one) => {
    if (one.type === "disc") return { x: one.center[0], y: one.center[1], r: one.radius, edges: new Float64Array(0) };
    const [x, y] = [0, 1].map((j) => one.vertices.reduce((sum, vertex) => sum + vertex[j], 0) / one.vertices.length);
    const r = Math.max(...one.vertices.map((vertex) => Math.hypot(vertex[0] - x, vertex[1] - y)));
    return { x, y, r, edges: Float64Array.from(one.vertices.flatMap((from, i) => [...from, ...one.vertices[(i + 1) % one.vertices.length]])) };
  });
  /** @param {Float64Array} rows @param {number} at @param {number} least  what is farther does not matter */
  return (rows, at, least = Infinity) => {
    let ax = base[0], ay = base[1], angle = 0;
    for (let i = 0; i < links.length; i += 1) {
      angle += rows[at + i];
      const bx = ax + links[i] * Math.cos(angle), by = ay + links[i] * Math.sin(angle);
      for (let o = 0; o < around.length; o += 1) {
        const { x, y, r, edges } = around[o];
        const room = least + r + radius;
        const squared = toSegment(x, y, ax, ay, bx, by);
        if (squared >= room * room) continue;
        if (edges.length === 0) least = Math.sqrt(squared) - r - radius;
        for (let k = 0; k < edges.length; k += 4) {
          const cx = edges[k], cy = edges[k + 1], dx = edges[k + 2], dy = edges[k + 3];
          const c = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax), d = (bx - ax) * (dy - ay) - (by - ay) * (dx - ax);
          const a = (dx - cx) * (ay - cy) - (dy - cy) * (ax - cx), b = (dx - cx) * (by - cy) - (dy - cy) * (bx - cx);
          if (c * d <= 0 && a * b <= 0) return 0;
          const near = Math.min(toSegment(ax, ay, cx, cy, dx, dy), toSegment(bx, by, cx, cy, dx, dy), toSegment(cx, cy, ax, ay, bx, by), toSegment(dx, dy, ax, ay, bx, by));
          least = Math.min(least, Math.sqrt(near) - radius);
        }
      }
      if (least <= 0) return 0;
      ax = bx;
      ay = by;
    }
    return least;
  };
}

/** The arm of a document as a problem; `note` is told how long each call took. @param {Document} document @param {boolean} isProven @param {(milliseconds: number, count: number) => void} note */
function told(document, isProven, note) {
  const { robot, queries } = document;
  if (robot.type !== "arm") throw new Error("only arms are told here");
  const { links } = robot;
  const n = links.length;
  const distance = distanceOf(document);
  const evaluate = (/** @type {Float64Array} */ rows, /** @type {Float64Array} */ results) => {
    const began = performance.now();
    for (let i = 0; i < results.length; i += 1) results[i] = isProven ? distance(rows, n * i) : Number(distance(rows, n * i, 1e-9) > 0);
    note(performance.now() - began, results.length);
  };
  const [{ start, goal }] = queries;
  if (goal === undefined) throw new Error("the first query has a target");
  const space = { coordinates: links.map(() => /** @type {const} */ ({ kind: "circle" })), metric: /** @type {const} */ ("sum") };
  const reach = links.map((_, i) => links.slice(i).reduce((sum, length) => sum + length, 0));
  return new Problem({ space, start, goal, ...(isProven ? { clearance: evaluate, reach } : { isFree: evaluate, resolution: RESOLUTION }) });
}

/** Plans with a seed; the time of its construction does not count. @typedef {(seed: number) => () => void} Plan */

/** The planner of a problem. @param {Problem | Scenario} problem @returns {Plan} */
function ours(problem) {
  return (seed) => {
    const planner = problem.planner({ algorithm: "rrt-connect", seed });
    return () => {
      if (planner.step(100_000) !== "solved") throw new Error(`seed ${seed}: no path`);
      planner.free();
    };
  };
}

/**
 * OxMPL's RRT-Connect on the same arm. Its space of circles has the Euclidean metric, where a motion is shorter than in the sum metric: so at
 * the same resolution it evaluates fewer samples. The range is OMPL's default.
 * @param {any} oxmpl
 * @param {Document} document
 * @param {(milliseconds: number, count: number) => void} note
 * @returns {Plan}
 */
function theirs(oxmpl, document, note) {
  const { robot, queries: [{ start, goal }] } = document;
  if (robot.type !== "arm" || goal === undefined) throw new Error("only arms with a goal are told here");
  const n = robot.links.length;
  const distance = distanceOf(document);
  const circle = new oxmpl.SO2StateSpace();
  // A motion is tested at every tenth of this length, which is a fraction of pi for a circle, and of the diagonal for a product.
  circle.setLongestValidLineSegmentFraction(10 * RESOLUTION / (Math.PI * Math.sqrt(n)));
  const builder = new oxmpl.CompoundStateSpaceBuilder();
  for (let i = 0; i < n; i += 1) builder.addSO2StateSpace(circle, 1);
  const space = builder.build();
  const stateAt = (/** @type {ArrayLike<number>} */ angles) => {
    const state = new oxmpl.CompoundStateBuilder();
    for (let i = 0; i < n; i += 1) state.addSO2State(new oxmpl.SO2State(angles[i]));
    return state.build();
  };
  const target = stateAt(goal);
  const region = new oxmpl.Goal({
    isSatisfied: (/** @type {any} */ state) => space.distance(state, target) <= 1e-9,
    distanceGoal: (/** @type {any} */ state) => space.distance(state, target),
    sampleGoal: () => stateAt(goal),
  });
  const row = new Float64Array(n);
  const checker = new oxmpl.StateValidityChecker((/** @type {any} */ state) => {
    for (let i = 0; i < n; i += 1) row[i] = state.getComponent(i).value;
    const began = performance.now();
    const isFree = distance(row, 0, 1e-9) > 0;
    note(performance.now() - began, 1);
    return isFree;
  });
  const problem = oxmpl.ProblemDefinition.fromCompoundState(space, stateAt(start), region);
  return (seed) => {
    const planner = new oxmpl.RRTConnect(0.2 * Math.PI * Math.sqrt(n), 0, problem, new oxmpl.PlannerConfig(seed));
    planner.setup(checker);
    return () => { planner.solve(10); };
  };
}

/** A run, after a warm-up. @param {Plan} plan @param {number} seed @param {Run} run  counts up meanwhile */
function measured(plan, seed, run) {
  Object.assign(run, { milliseconds: 0, inside: 0, calls: 0, configurations: 0 });
  const solve = plan(seed);
  const began = performance.now();
  solve();
  run.milliseconds = performance.now() - began;
  return { ...run };
}

const [seeds = "30", ...files] = process.argv.slice(2);
const scenarios = files.length > 0
  ? files.map((file) => ({ name: basename(file, ".json"), scenario: Scenario.parse(readFileSync(file, "utf8")) }))
  : [2, 3, 4].map((links) => ({ name: `forest of ${links} joints`, scenario: Scenario.generate("forest", { links, seed: 7 }) }));

const oxmpl = await oxmplInJavaScript();
/** @type {string[][]} */
const rows = [];
for (const { name, scenario } of scenarios) {
  const document = scenario.document();
  /** @type {Run} */
  const run = { milliseconds: 0, inside: 0, calls: 0, configurations: 0 };
  const note = (/** @type {number} */ milliseconds, /** @type {number} */ count) => {
    run.inside += milliseconds;
    run.calls += 1;
    run.configurations += count;
  };
  /** @type {[string, Plan][]} */
  const plans = [
    ["isFree", ours(told(document, false, note))], ["clearance", ours(told(document, true, note))], ["as a scenario", ours(scenario)],
    ["OxMPL, isFree", theirs(oxmpl, document, note)],
  ];
  for (const [, plan] of plans) for (let seed = 0; seed < 20; seed += 1) measured(plan, 1000 + seed, run);
  // In turn, so that the load of the machine is the same for all.
  /** @type {Run[][]} */
  const allRuns = plans.map(() => []);
  for (let seed = 0; seed < Number(seeds); seed += 1) plans.forEach(([, plan], i) => allRuns[i].push(measured(plan, seed, run)));
  for (const [i, [how]] of plans.entries()) {
    const runs = allRuns[i];
    const sum = (/** @type {keyof Run} */ of) => runs.reduce((all, one) => all + one[of], 0);
    const isOwn = how !== "as a scenario";
    rows.push([
      name, how, digits(quantile(runs.map(({ milliseconds }) => milliseconds), 0.5)), isOwn ? digits(quantile(runs.map(({ milliseconds, inside }) => milliseconds / inside), 0.5)) : "-",
      ...(isOwn ? [digits(sum("configurations") / runs.length), digits(sum("calls") / runs.length)] : ["-", "-"]),
    ]);
  }
}
console.log(table(["arm", "what is free", "ms, median", "time / time in the function", "configurations", "calls"], rows));
