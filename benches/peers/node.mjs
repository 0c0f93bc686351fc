/**
 * The package's side of the benchmark: the same jobs and replies as native.rs, in WebAssembly.
 *
 *   FILE PLANNER SEED RUNS LIMIT name=value ...
 *   FILE first SEED RUNS
 *   FILE fleet SEED RUNS
 *   FILE longest SEED   the longest iteration of the planner of a fleet
 */
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { Scenario, solve, version } from "planarium";
import { Fleet } from "planarium/full";
import { camelCase } from "../../scripts/declarations.mjs";

/** Iterations between two readings of the clock. */
const SLICE = 32;

/** @typedef {import("./sides.mjs").Run} Run */

/** @param {string} job */
function answer(job) {
  const [file, algorithm, first, runs, limit, ...pairs] = job.split(" ");
  const text = readFileSync(file, "utf8");
  if (algorithm === "longest") return { seconds: [longestIteration(text, Number(first))] };
  if (algorithm === "first" || algorithm === "fleet") {
    const answered = algorithm === "first" ? firstAnswer : fleetPlan;
    const seconds = [];
    for (let i = 0; i < Number(runs); i += 1) {
      const time = answered(text, Number(first) + i);
      if (time === null) return { seconds: [] };
      seconds.push(time);
    }
    return { seconds };
  }
  const parameters = Object.fromEntries(
    pairs.map((pair) => {
      const [name, value] = pair.split("=");
      return [camelCase(name), Number.isNaN(Number(value)) ? value : Number(value)];
    }),
  );
  const scenario = Scenario.parse(text);
  const done = Array.from({ length: Number(runs) }, (_, i) =>
    outcome(
      scenario,
      /** @type {import("planarium").PlannerOptions} */ ({ algorithm, seed: Number(first) + i, ...parameters }),
      Number(limit),
    ),
  );
  scenario.free();
  return { runs: done };
}

/**
 * The seconds from the text of a scenario to the result of the default planner; null if that has no path.
 * @param {string} text
 * @param {number} seed
 */
function firstAnswer(text, seed) {
  const asked = performance.now();
  const { status } = solve(text, { seed });
  const seconds = (performance.now() - asked) / 1e3;
  return status === "solved" ? seconds : null;
}

/**
 * The seconds from a new planner of a fleet to its result; null if that has no plan.
 * @param {string} text
 * @param {number} seed
 */
function fleetPlan(text, seed) {
  const fleet = Fleet.parse(text);
  const asked = performance.now();
  const planner = fleet.planner({ seed });
  planner.step(Number.MAX_SAFE_INTEGER);
  planner.result();
  const seconds = (performance.now() - asked) / 1e3;
  const isSolved = planner.status === "solved";
  planner.free();
  fleet.free();
  return isSolved ? seconds : null;
}

/**
 * The seconds of the longest iteration of the planner of a fleet.
 * @param {string} text
 * @param {number} seed
 */
function longestIteration(text, seed) {
  const fleet = Fleet.parse(text);
  const planner = fleet.planner({ seed });
  let [longest, before] = [0, performance.now()];
  while (planner.step(1) === "running") {
    const now = performance.now();
    longest = Math.max(longest, now - before);
    before = now;
  }
  planner.free();
  fleet.free();
  return longest / 1e3;
}

/**
 * One run from a new planner to its path.
 * @param {Scenario} scenario
 * @param {import("planarium").PlannerOptions} options
 * @param {number} limit  in seconds
 * @returns {Run}
 */
function outcome(scenario, options, limit) {
  const asked = performance.now();
  const planner = scenario.planner(options);
  const began = performance.now();
  let built;
  while (planner.step(SLICE) === "running" && performance.now() - began < limit * 1e3) {
    if (built === undefined && planner.phase === "searching") built = performance.now() - began;
  }
  planner.path();
  const whole = performance.now() - began;
  const stats = planner.stats();
  const { status, length } = planner.result();
  planner.free();
  const build = built ?? whole;
  return {
    setup: (began - asked) / 1e3,
    build: build / 1e3,
    search: (whole - build) / 1e3,
    solved: status === "solved",
    length,
    motions: stats.motion_checks,
    vertices: stats.vertices,
    edges: stats.edges,
  };
}

console.log(JSON.stringify({ name: `Planarium ${version}, Node ${process.versions.node}` }));
for await (const job of createInterface({ input: process.stdin })) {
  let reply;
  try {
    reply = answer(job);
  } catch (error) {
    reply = { error: String(error) };
  }
  console.log(JSON.stringify(reply));
}
