/**
 * The memory of the WebAssembly instance after building a roadmap. It never shrinks, so this is the peak.
 * `node benches/peers/memory.mjs FILE SAMPLES` prints bytes as JSON.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { Scenario } from "planarium";
import { root } from "../../scripts/run.mjs";

/** The memory of the package's instance. */
const { initSync } = await import(pathToFileURL(join(root, "dist", "package", "planarium_glue.js")).href);
/** @type {WebAssembly.Memory} */
const memory = initSync().memory;

const [file, samples] = process.argv.slice(2);
const before = memory.buffer.byteLength;
const planner = Scenario.parse(readFileSync(file, "utf8")).planner({
  algorithm: "prm",
  samples: Number(samples),
  k: 10,
  maxIterations: 4e9,
});
while (planner.step(10_000) === "running");
const { vertices, edges } = planner.stats();
console.log(JSON.stringify({ before, peak: memory.buffer.byteLength, vertices, edges, events: planner.eventCount }));
