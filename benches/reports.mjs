/**
 * The reports' roadmaps and RRT-Connect in WebAssembly: the twin of benches/reports.rs, on the same generated forests with the same
 * seeds. `npm run build && node benches/reports.mjs` prints a table; medians of wall-clock milliseconds.
 */
import { Scenario } from "planarium";

const FORESTS = 5;

/**
 * @param {Scenario} scenario
 * @param {Record<string, string | number>} options
 */
function time(scenario, options) {
  const began = performance.now();
  const planner = scenario.planner(options);
  planner.step(20_000);
  const milliseconds = performance.now() - began;
  const { status } = planner;
  const { motion_checks: motions } = planner.stats();
  planner.free();
  return { milliseconds, solved: status === "solved", motions };
}

/** @param {number[]} values @param {number} part */
function quantile(values, part) {
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.round((sorted.length - 1) * part)];
}

/** @param {string} name @param {number} links @param {ReturnType<typeof time>[]} runs */
function row(name, links, runs) {
  const kept = name === "k-PRM" ? runs : runs.filter((run) => run.solved);
  const times = kept.map((run) => run.milliseconds);
  const [median, low, high] = [0.5, 0.25, 0.75].map((part) => quantile(times, part).toFixed(4));
  const solved = runs.filter((run) => run.solved).length;
  console.log(`| ${name} | ${links}R | ${median} | ${low} to ${high} | ${solved} of ${runs.length} | ${quantile(kept.map((run) => run.motions), 0.5)} |`);
}

console.log("| planner | arm | median ms | quartiles | solved | motions |\n|---|---|---|---|---|---|");
for (const links of [2, 3, 4]) {
  const forests = Array.from({ length: FORESTS }, (_, seed) => Scenario.generate("forest", { links, seed }));
  const roadmap = { algorithm: "prm", samples: 300 * links - 200, k: 30 };
  // The first runs meet code that the engine has not compiled well yet: they warm it and are not counted.
  for (let seed = 0; seed < 3; seed += 1) for (const forest of forests) time(forest, { ...roadmap, seed });
  const roadmaps = forests.flatMap((forest) => Array.from({ length: 7 }, (_, seed) => time(forest, { ...roadmap, seed })));
  row("k-PRM", links, roadmaps);
  const trees = forests.flatMap((forest) => Array.from({ length: 100 }, (_, seed) => time(forest, { algorithm: "rrt-connect", seed })));
  row("RRT-Connect", links, trees);
}
