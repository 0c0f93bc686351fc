/**
 * Custom robots: the arms of generated forests, given to `Problem` as functions in JavaScript, beside the same arms as
 * scenarios.
 *
 *   node benches/own.mjs [SEEDS] [FILE...]   scenarios of arms in place of the generated ones
 *
 * For each arm: milliseconds to the first path by RRT-Connect; the same of a run whose function only copies the results
 * recorded before, which is planner and crossing alone; and of the function alone, called from a loop with the batches
 * recorded before. Each run is measured several times, in turn with the others, and each number is the median over the
 * seeds of the median of a seed, as is the ratio of the first time to the last. Then how many configurations the
 * function got, in how many calls. The last row of a planar arm is OxMPL's package for JavaScript with the same
 * function, which it calls for one configuration at a time. Then the arm of six joints in `examples/own`, by its
 * clearance and by the sign of that.
 */
import { readFileSync } from "node:fs";
import { basename } from "node:path";
import { Problem, Scenario } from "planarium";
import { description as sixJoints } from "../examples/own/six-joints.js";
import { digits, quantile, table } from "./peers/report.mjs";
import { oxmplInJavaScript } from "./peers/sides.mjs";

/** @typedef {import("planarium").ScenarioDocument} Document */
/** What a function got and wrote. @typedef {{ rows: Float64Array, results: Float64Array }} Batch */
/**
 * A run of a seed, without its construction; it returns how to free it.
 * @typedef {(seed: number) => () => (() => void) | void} Plan
 */
/**
 * A way to say what is free; without `record` a document says it.
 * @typedef {{ plan: Plan, record?: (seed: number) => Batch[], replay?: (batches: Batch[]) => Plan, alone?: (batches:
 *   Batch[]) => void }} Way
 */

/** The distance of two neighbouring samples, radians in the sum metric: as the peers sample. */
const RESOLUTION = 0.05;

/**
 * The squared distance of a point and a segment.
 * @param {number} px
 * @param {number} py
 * @param {number} ax
 * @param {number} ay
 * @param {number} bx
 * @param {number} by
 */
function toSegment(px, py, ax, ay, bx, by) {
  const dx = bx - ax,
    dy = by - ay;
  const along = Math.max(0, Math.min(1, ((px - ax) * dx + (py - ay) * dy) / (dx * dx + dy * dy)));
  return (px - ax - along * dx) ** 2 + (py - ay - along * dy) ** 2;
}

/** The distance of an arm's links from discs and polygons, 0 if they touch. @param {Document} document */
function distanceOf({ world: { obstacles }, robot }) {
  if (robot.type !== "arm") throw new Error("only arms are supported here");
  const { base, links, radius = 0 } = robot;
  // Each obstacle in a circle; the edges of a polygon by both ends.
  const around = obstacles.map((one) => {
    if (one.type === "disc") return { x: one.center[0], y: one.center[1], r: one.radius, edges: new Float64Array(0) };
    if (one.type === "wall" || one.holes) throw new Error("walls and holes are not supported here");
    const [x, y] = [0, 1].map((j) => one.vertices.reduce((sum, vertex) => sum + vertex[j], 0) / one.vertices.length);
    const r = Math.max(...one.vertices.map((vertex) => Math.hypot(vertex[0] - x, vertex[1] - y)));
    return {
      x,
      y,
      r,
      edges: Float64Array.from(
        one.vertices.flatMap((from, i) => [...from, ...one.vertices[(i + 1) % one.vertices.length]]),
      ),
    };
  });
  /** @param {Float64Array} rows @param {number} at @param {number} least  what is farther does not matter */
  return (rows, at, least = Infinity) => {
    let ax = base[0],
      ay = base[1],
      angle = 0;
    for (let i = 0; i < links.length; i += 1) {
      angle += rows[at + i];
      const bx = ax + links[i] * Math.cos(angle),
        by = ay + links[i] * Math.sin(angle);
      for (let o = 0; o < around.length; o += 1) {
        const { x, y, r, edges } = around[o];
        const room = least + r + radius;
        const squared = toSegment(x, y, ax, ay, bx, by);
        if (squared >= room * room) continue;
        if (edges.length === 0) least = Math.sqrt(squared) - r - radius;
        for (let k = 0; k < edges.length; k += 4) {
          const cx = edges[k],
            cy = edges[k + 1],
            dx = edges[k + 2],
            dy = edges[k + 3];
          const c = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax),
            d = (bx - ax) * (dy - ay) - (by - ay) * (dx - ax);
          const a = (dx - cx) * (ay - cy) - (dy - cy) * (ax - cx),
            b = (dx - cx) * (by - cy) - (dy - cy) * (bx - cx);
          if (c * d <= 0 && a * b <= 0) return 0;
          const near = Math.min(
            toSegment(ax, ay, cx, cy, dx, dy),
            toSegment(bx, by, cx, cy, dx, dy),
            toSegment(cx, cy, ax, ay, bx, by),
            toSegment(dx, dy, ax, ay, bx, by),
          );
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

/** The planner of a problem. @param {Problem | Scenario} problem @returns {Plan} */
function ours(problem) {
  return (seed) => {
    const planner = problem.planner({ algorithm: "rrt-connect", seed });
    return () => {
      if (planner.step(100_000) !== "solved") throw new Error(`seed ${seed}: no path`);
      return () => planner.free();
    };
  };
}

/** Evaluates rows of configurations. @typedef {(rows: Float64Array, results: Float64Array) => void} Evaluate */
/**
 * A problem, and its two functions.
 * @typedef {{ base: { space: import("planarium").SpaceDescription, start: number[], goal: number[] }, reach: number[],
 *   clearance: Evaluate, isFree: Evaluate }} Twins
 */

/** The arm of a document. @param {Document} document @returns {Twins} */
function twinsOf(document) {
  const {
    robot,
    queries: [{ start, goal }],
  } = document;
  if (robot.type !== "arm" || goal === undefined) throw new Error("only arms with a goal are supported here");
  const { links } = robot;
  const n = links.length;
  const distance = distanceOf(document);
  return {
    base: { space: { coordinates: links.map(() => ({ kind: "circle" })), metric: "sum" }, start, goal },
    reach: links.map((_, i) => links.slice(i).reduce((sum, length) => sum + length, 0)),
    clearance(rows, results) {
      for (let i = 0; i < results.length; i += 1) results[i] = distance(rows, n * i);
    },
    isFree(rows, results) {
      for (let i = 0; i < results.length; i += 1) results[i] = Number(distance(rows, n * i, 1e-9) > 0);
    },
  };
}

/** The arm of six joints. @returns {Twins} */
function twinsInSpace() {
  const { space, start, goal, reach, clearance } = /** @type {any} */ (sixJoints);
  const isFree = (/** @type {Float64Array} */ rows, /** @type {Float64Array} */ results) => {
    clearance(rows, results);
    for (let i = 0; i < results.length; i += 1) results[i] = Number(results[i] > 0);
  };
  return { base: { space, start, goal }, reach, clearance, isFree };
}

/** An arm as a problem. @param {Twins} twins @param {boolean} isProven @returns {Way} */
function told({ base, reach, clearance, isFree }, isProven) {
  const evaluate = isProven ? clearance : isFree;
  const problem = (/** @type {Evaluate} */ by) =>
    new Problem({ ...base, ...(isProven ? { clearance: by, reach } : { isFree: by, resolution: RESOLUTION }) });
  /** @type {Batch[]} */
  let noted = [];
  const noting = problem((rows, results) => {
    evaluate(rows, results);
    noted.push({ rows: rows.slice(), results: results.slice() });
  });
  /** @type {Batch[]} */
  let played = [];
  let next = 0;
  const replaying = problem((rows, results) => {
    if (next === played.length) return evaluate(rows, results); // start and goal, before the run
    const known = played[next].results;
    next += 1;
    for (let i = 0; i < known.length; i += 1) results[i] = known[i];
  });
  return {
    plan: ours(problem(evaluate)),
    record(seed) {
      const run = ours(noting)(seed);
      noted = [];
      run()?.();
      return noted;
    },
    replay: (batches) => (seed) => {
      const run = ours(replaying)(seed);
      return () => {
        [played, next] = [batches, 0];
        const free = run();
        [played, next] = [[], 0];
        return free;
      };
    },
    alone(batches) {
      for (const { rows, results } of batches) evaluate(rows, results);
    },
  };
}

/**
 * OxMPL's RRT-Connect on the same arm. Its space of circles has the Euclidean metric, where a motion is shorter than in
 * the sum metric: so at the same resolution it evaluates fewer samples. The range is OMPL's default. What it makes is
 * freed by hand: what is left to the garbage collector slows it, after some hundred runs to a hundredth.
 * @param {any} oxmpl
 * @param {Document} document
 * @returns {Way}
 */
function theirs(oxmpl, document) {
  const {
    robot,
    queries: [{ start, goal }],
  } = document;
  if (robot.type !== "arm" || goal === undefined) throw new Error("only arms with a goal are supported here");
  const n = robot.links.length;
  const distance = distanceOf(document);
  const circle = new oxmpl.SO2StateSpace();
  // A motion is tested at every tenth of this length, which is a fraction of pi for a circle, and of the diagonal for a
  // product.
  circle.setLongestValidLineSegmentFraction((10 * RESOLUTION) / (Math.PI * Math.sqrt(n)));
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
  /** @type {Batch[]} */
  let noted = [];
  const isFree = (/** @type {any} */ state) => {
    for (let i = 0; i < n; i += 1) {
      const angle = state.getComponent(i);
      row[i] = angle.value;
      angle.free();
    }
    state.free();
    return distance(row, 0, 1e-9) > 0;
  };
  const checker = new oxmpl.StateValidityChecker(isFree);
  const noting = new oxmpl.StateValidityChecker((/** @type {any} */ state) => {
    const found = isFree(state);
    noted.push({ rows: row.slice(), results: new Float64Array(1) });
    return found;
  });
  const problem = oxmpl.ProblemDefinition.fromCompoundState(space, stateAt(start), region);
  const run = (/** @type {number} */ seed, /** @type {any} */ by) => {
    const planner = new oxmpl.RRTConnect(0.2 * Math.PI * Math.sqrt(n), 0, problem, new oxmpl.PlannerConfig(seed));
    planner.setup(by);
    return () => {
      planner.solve(10);
      return () => planner.free();
    };
  };
  return {
    plan: (seed) => run(seed, checker),
    record(seed) {
      noted = [];
      run(seed, noting)();
      return noted;
    },
    alone(batches) {
      for (const { rows, results } of batches) results[0] = Number(distance(rows, 0, 1e-9) > 0);
    },
  };
}

/** Milliseconds. @param {() => (() => void) | void} run */
function timed(run) {
  const began = performance.now();
  const free = run();
  const milliseconds = performance.now() - began;
  free?.();
  return milliseconds;
}

const [seeds = "100", ...files] = process.argv.slice(2);
const oxmpl = await oxmplInJavaScript();
/** @param {string} name @param {Scenario} scenario @returns {{ name: string, ways: [string, Way][] }} */
const planar = (name, scenario) => {
  const document = scenario.document();
  const twins = twinsOf(document);
  return {
    name,
    ways: [
      ["isFree", told(twins, false)],
      ["clearance", told(twins, true)],
      ["as a scenario", { plan: ours(scenario) }],
      ["OxMPL, isFree", theirs(oxmpl, document)],
    ],
  };
};
const inSpace = twinsInSpace();
/** @type {{ name: string, ways: [string, Way][] }[]} */
const arms =
  files.length > 0
    ? files.map((file) => planar(basename(file, ".json"), Scenario.parse(readFileSync(file, "utf8"))))
    : [
        ...[2, 3, 4].map((links) =>
          planar(`forest of ${links} joints`, Scenario.generate("forest", { links, seed: 7 })),
        ),
        {
          name: "six joints in space",
          ways: [
            ["isFree", told(inSpace, false)],
            ["clearance", told(inSpace, true)],
          ],
        },
      ];
/** How often each seed is measured; the first few warm up. */
const ROUNDS = 15,
  WARM = 5;

const median = (/** @type {number[]} */ values) => quantile(values, 0.5);
/** @type {string[][]} */
const rows = [];
for (const { name, ways } of arms) {
  const all = Array.from({ length: Number(seeds) }, (_, seed) =>
    ways.map(([, { plan, record, replay, alone }]) => {
      const batches = record?.(seed) ?? [];
      /** @type {[string, () => number][]} */
      const measures = [["whole", () => timed(plan(seed))]];
      if (replay) measures.push(["planner", () => timed(replay(batches)(seed))]);
      if (alone) measures.push(["alone", () => timed(() => alone(batches))]);
      return {
        batches,
        measures: measures.map(([what, measure]) => ({ what, measure, times: /** @type {number[]} */ ([]) })),
      };
    }),
  );
  for (let round = 0; round < ROUNDS; round += 1) {
    for (const { measures } of all.flat()) for (const { measure, times } of measures) times.push(measure());
  }
  for (const [i, [how]] of ways.entries()) {
    const runs = all.map((of) => of[i]);
    const of = (/** @type {string} */ wanted) =>
      runs.flatMap(({ measures }) =>
        measures.filter(({ what }) => what === wanted).map(({ times }) => median(times.slice(WARM))),
      );
    const [whole, planner, alone] = ["whole", "planner", "alone"].map(of);
    const mean = (/** @type {(batches: Batch[]) => number} */ count) =>
      digits(runs.reduce((sum, { batches }) => sum + count(batches), 0) / runs.length);
    rows.push([
      name,
      how,
      digits(median(whole)),
      planner.length ? digits(median(planner)) : "-",
      ...(alone.length
        ? [digits(median(alone)), digits(median(whole.map((time, seed) => time / alone[seed])))]
        : ["-", "-"]),
      ...(alone.length
        ? [
            mean((batches) => batches.reduce((sum, { results }) => sum + results.length, 0)),
            mean((batches) => batches.length),
          ]
        : ["-", "-"]),
    ]);
  }
}
console.log(
  table(
    [
      "arm",
      "what is free",
      "ms",
      "planner, crossing: ms",
      "function alone: ms",
      "whole / function",
      "configurations",
      "calls",
    ],
    rows,
  ),
);
