/**
 * The package's side of the benchmark: the same jobs and replies as native.rs, in WebAssembly.
 *
 *   FILE PLANNER SEED RUNS LIMIT name=value ...
 */
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { Scenario, version } from "planarium";
import { camelCase } from "../../scripts/declarations.mjs";

/** Iterations between two readings of the clock. */
const SLICE = 32;

/** @typedef {import("./sides.mjs").Run} Run */

/** @param {string} job */
function answer(job) {
  const [file, algorithm, first, runs, limit, ...pairs] = job.split(" ");
  const parameters = Object.fromEntries(
    pairs.map((pair) => {
      const [name, value] = pair.split("=");
      return [camelCase(name), Number.isNaN(Number(value)) ? value : Number(value)];
    }),
  );
  const scenario = Scenario.parse(readFileSync(file, "utf8"));
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
