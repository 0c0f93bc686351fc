/**
 * The first roadmap of a new process, as a stand-in for a page: it loads the package, reads a scenario and builds a
 * k-PRM of 1000 samples. `node benches/peers/cold.mjs FILE` prints milliseconds as JSON.
 */
import { readFileSync } from "node:fs";

const text = readFileSync(process.argv[2], "utf8");
const began = performance.now();
const { Scenario } = await import("planarium");
const loaded = performance.now();
const planner = Scenario.parse(text).planner({ algorithm: "prm", samples: 1000, k: 30 });
planner.step(100_000);
const path = planner.path();
const done = performance.now();
console.log(JSON.stringify({ load: loaded - began, roadmap: done - loaded, solved: path.length > 0 }));
