/**
 * The script of a worker of `PlannerPool`. The first message has the address or the contents of the core, if it is not beside this file. A
 * message `{ run, given }` begins a run, `{ run }` asks for a slice, which is answered by `{ run, growth }` or `{ run, fault }`, and
 * `{ run, isOver: true }` drops the run.
 */
import init, { Scenario } from "./planarium.js";
import { PlanariumError, reasonOf } from "./error.js";

/** @import { PlannerOptions } from "./core.js" */
/** @import { WorkerGrowth } from "./worker.js" */

/** Node, where it has no web workers. */
const node = typeof postMessage === "function" ? null : globalThis.process.getBuiltinModule;
const port = /** @type {MessagePort} */ (/** @type {unknown} */ (node === null ? globalThis : node("node:worker_threads").parentPort));

/** The runs by their numbers. @type {Map<number, AsyncGenerator<WorkerGrowth, void, undefined>>} */
const runs = new Map();
/** The core. @type {Promise<void>} */
let started;

/** @param {{ document: string, options?: PlannerOptions, budget: number }} given @returns {AsyncGenerator<WorkerGrowth, void, undefined>} */
async function* grow({ document, options, budget }) {
  await started;
  const scenario = Scenario.parse(document);
  try {
    const planner = scenario.planner(options);
    try {
      for await (const growth of planner.growth({ budget })) yield { ...growth, result: growth.status === "running" ? null : planner.result() };
    } finally {
      planner.free();
    }
  } finally {
    scenario.free();
  }
}

/** Plans a slice and sends it. @param {number} run */
async function answer(run) {
  try {
    const { value: growth } = /** @type {IteratorResult<WorkerGrowth, undefined>} */ (await runs.get(run)?.next());
    if (growth !== undefined) port.postMessage({ run, growth }, [growth.vertices.buffer, growth.edges.buffer, growth.events.buffer]);
  } catch (error) {
    const { code, message, pointer, nearest } = error instanceof PlanariumError ? error : new PlanariumError("internal", reasonOf(error));
    port.postMessage({ run, fault: { code, message, pointer, nearest } });
  }
}

port.onmessage = ({ data }) => {
  if ("core" in data) {
    started = init(data.core ?? node?.("node:fs").readFileSync(new URL("./planarium_bg.wasm", import.meta.url)));
    // Every run reports it.
    started.catch(() => {});
  } else if ("given" in data) {
    runs.set(data.run, grow(data.given));
  } else if ("isOver" in data) {
    void runs.get(data.run)?.return().catch(() => {});
    runs.delete(data.run);
  } else {
    void answer(data.run);
  }
};
