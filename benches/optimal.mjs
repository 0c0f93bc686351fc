/**
 * `npm run bench:optimal`: what the best path of each optimal planner costs after a number of checks, for a disc among
 * convex polygons, beside OMPL's planners, in percent above the true shortest path.
 *
 *   --worlds N     worlds (10); those without a path are left out
 *   --first N      the seed of the first world (1000)
 *   --seeds N      runs of each planner in each world (100)
 *   --write        updates the table in docs/benchmarks.md
 *
 * A check is on OMPL's side a state whose validity was asked for. On ours it is a configuration or a motion that was
 * tested, and every evaluation of the distance to an obstacle besides, so that no work is free. OMPL looks at an edge
 * in steps of a hundredth of the space, its default.
 */
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { Scenario, historyColumns } from "planarium";
import { script } from "../scripts/run.mjs";
import { integer, update } from "./peers/arguments.mjs";
import { quantile } from "./peers/report.mjs";
import { startSide } from "./peers/sides.mjs";
import { flat } from "./peers/worlds.mjs";

/**
 * @typedef {{ better: [checks: number, cost: number][], isValid: boolean }} Run  checks and cost whenever the best path
 *   became cheaper
 */

/** The numbers of checks after which costs are compared. */
const MOST = [1000, 3000, 10_000, 30_000];
const LAST = MOST[MOST.length - 1];

/** A path this near to the shortest is good, as a fraction. */
const GOOD = 0.02;

/** The numbers of samples of planners that draw all samples first: each is a run of its own. */
const SAMPLES = [50, 100, 200, 400, 800, 1600, 3200];

const ours = ["rrt-star", "informed-rrt-star", "bit-star", "fmt-star", "aorrtc", "prm-star", "lazy-prm-star"];
const theirs = ["rrt-star", "bit-star", "fmt-star"];

await script(async () => {
  const { values: options } = parseArgs({
    options: {
      worlds: { type: "string", default: "10" },
      first: { type: "string", default: "1000" },
      seeds: { type: "string", default: "100" },
      write: { type: "boolean", default: false },
    },
  });
  const [count, first, seeds] = [
    integer("worlds", options.worlds, 1),
    integer("first", options.first, 0),
    integer("seeds", options.seeds, 1),
  ];
  const ompl = await startSide("ompl", true);
  const folder = mkdtempSync(join(tmpdir(), "planarium-bench-"));
  try {
    /** @type {Map<string, Run[][]>} */
    const results = new Map(
      [...ours, ...(ompl === undefined ? [] : theirs.map((id) => `OMPL ${id}`))].map((name) => [name, []]),
    );
    let worlds = 0;
    for (let seed = first; worlds < count; seed += 1) {
      const scenario = Scenario.generate("clutter", { robot: "disc", seed });
      const { length } = scenario.optimum();
      if (length === null) continue;
      worlds += 1;
      console.error(`bench: world ${seed}`);
      const file = join(folder, `${seed}.txt`);
      writeFileSync(file, flat(scenario.document()));
      for (const [name, all] of results) {
        const runs =
          name.startsWith("OMPL") && ompl !== undefined
            ? await peerRuns(ompl, scenario, file, name.slice(5), seeds)
            : ownRuns(scenario, name, seeds);
        all.push(
          runs.map(({ better, isValid }) => ({
            better: better.map(([checks, cost]) => [checks, cost / length - 1]),
            isValid,
          })),
        );
      }
      scenario.free();
    }
    const title = `Planarium, Node ${process.versions.node}; ${ompl?.title ?? "WITHOUT OMPL: not installed"}. ${worlds} worlds, ${seeds} runs each.`;
    const tables = `${title}\n\n${table(results)}\n${duels(results)}`;
    console.log(tables);
    if (options.write) update("optimal", tables);
  } finally {
    ompl?.stop();
    rmSync(folder, { recursive: true, force: true });
  }
});

/** Whether a planner draws all of its samples first. @param {string} planner */
function isBatch(planner) {
  return planner === "fmt-star" || planner === "prm-star";
}

/** @param {Scenario} scenario @param {string} algorithm @param {number} seeds @returns {Run[]} */
function ownRuns(scenario, algorithm, seeds) {
  return Array.from({ length: seeds }, (_, seed) => {
    const runs = isBatch(algorithm)
      ? SAMPLES.map((samples) => ownRun(scenario, { algorithm, samples, seed }))
      : [ownRun(scenario, { algorithm, improveIterations: 1e9, maxIterations: 1e9, seed })];
    return merged(runs);
  });
}

/** One run until it has made a number of checks. @param {Scenario} scenario @param {any} options @returns {Run} */
function ownRun(scenario, options) {
  const planner = scenario.planner({ ...options, events: false });
  planner.record();
  /** @type {Run["better"]} */
  const better = [];
  const width = historyColumns.length;
  let [row, checks] = [0, 0];
  while (checks < LAST && planner.step(50) === "running") read();
  read();
  planner.free();
  // A path of ours is proven.
  return { better, isValid: true };

  function read() {
    const rows = planner.historySince(row);
    for (let at = 0; at < rows.length; at += width) {
      const [configurations, motions, evaluations, cost] = rows.subarray(at + 4, at + width);
      checks = configurations + motions + evaluations;
      if (cost < (better.at(-1)?.[1] ?? Infinity)) better.push([checks, cost]);
    }
    row += rows.length / width;
  }
}

/**
 * @param {import("./peers/sides.mjs").Side} ompl
 * @param {Scenario} scenario
 * @param {string} file
 * @param {string} planner
 * @param {number} seeds
 * @returns {Promise<Run[]>}
 */
async function peerRuns(ompl, scenario, file, planner, seeds) {
  const judge = scenario.planner({ algorithm: "rrt" });
  /** @type {Run[][]} */
  const all = [];
  for (const samples of isBatch(planner) ? SAMPLES : [0]) {
    const runs = await ompl.ask(`${file} disc 0 ${seeds} ${planner} ${LAST} ${samples}`);
    all.push(
      runs.map((/** @type {any} */ { better, path }) => ({
        better,
        isValid: judge.firstHits(edges(path)).every((hit) => hit === 1),
      })),
    );
  }
  judge.free();
  return Array.from({ length: seeds }, (_, seed) => merged(all.map((runs) => runs[seed])));
}

/** The ends of the edges of a path, in a row. @param {number[][]} path */
function edges(path) {
  return new Float64Array(path.slice(1).flatMap((to, i) => [...path[i], ...to]));
}

/**
 * Runs with several numbers of samples as one, each of which is available after its own checks.
 * @param {Run[]} runs
 * @returns {Run}
 */
function merged(runs) {
  return { better: runs.flatMap(({ better }) => better), isValid: runs.every(({ isValid }) => isValid) };
}

/** The cost after a number of checks. @param {Run} run @param {number} most */
function cost({ better }, most) {
  return better.reduce((least, [checks, cost]) => (checks <= most ? Math.min(least, cost) : least), Infinity);
}

/** After how many checks a path is good. @param {Run} run */
function goodAfter({ better }) {
  return better.reduce((least, [checks, cost]) => (cost <= GOOD ? Math.min(least, checks) : least), Infinity);
}

/** @param {number[]} values @param {(value: number) => string} write */
function quartiles(values, write) {
  const [low, middle, high] = [0.25, 0.5, 0.75].map((part) => quantile(values, part)).map(write);
  return `**${middle}** (${low} to ${high})`;
}

/** @param {number} gap */
function percent(gap) {
  return Number.isFinite(gap) ? (100 * gap).toPrecision(3) : "none";
}

/** @param {number} checks */
function whole(checks) {
  return Number.isFinite(checks) ? String(checks) : `> ${LAST}`;
}

/** @param {Map<string, Run[][]>} results */
function table(results) {
  const head = [
    "planner",
    ...MOST.map((most) => `% above, ${most} checks`),
    `checks up to ${100 * GOOD} %`,
    "valid runs, %",
  ];
  const rows = [...results].map(([name, worlds]) => {
    const runs = worlds.flat();
    const valid = runs.filter(({ isValid }) => isValid).length / runs.length;
    return [
      name,
      ...MOST.map((most) =>
        quartiles(
          runs.map((run) => cost(run, most)),
          percent,
        ),
      ),
      quartiles(runs.map(goodAfter), whole),
      percent(valid),
    ];
  });
  return markdown([head, ...rows]);
}

/**
 * In how many worlds the median of one of our planners is below that of OMPL's of the same name.
 * @param {Map<string, Run[][]>} results
 */
function duels(results) {
  const head = ["worlds in which our median is lower", ...MOST.map((most) => `${most} checks`)];
  const rows = theirs
    .filter((id) => results.has(`OMPL ${id}`))
    .map((id) => {
      const [own, peer] = [results.get(id) ?? [], results.get(`OMPL ${id}`) ?? []];
      const median = (/** @type {Run[]} */ runs, /** @type {number} */ most) =>
        quantile(
          runs.map((run) => cost(run, most)),
          0.5,
        );
      return [
        id,
        ...MOST.map(
          (most) =>
            `${own.filter((runs, world) => median(runs, most) < median(peer[world], most)).length} of ${own.length}`,
        ),
      ];
    });
  return markdown([head, ...rows]);
}

/** @param {string[][]} rows */
function markdown([head, ...rows]) {
  return [head, head.map(() => "---"), ...rows].map((row) => `| ${row.join(" | ")} |\n`).join("");
}
