/**
 * The script of a worker of `PlannerPool`. The first message has the address or the contents of the core, if it is not
 * beside this file. A message `{ run, given }` begins a run, `{ run }` asks for a slice, which is answered by `{ run,
 * growth }`, `{ run, fault }` or, with what a function of the caller's has thrown, `{ run, thrown: [value] }`; `{ run,
 * isOver: true }` drops the run. Other messages are ignored.
 */
import init, { Problem, Scenario } from "./planarium.js";
import { PlanariumError, isOwn, reasonOf } from "./error.js";

/** @import { PlannerOptions, ProblemDescription } from "./core.js" */
/** @import { ProblemModule, WorkerGrowth } from "./worker.js" */
/**
 * A run that the pool wants.
 * @typedef {object} Given
 * @property {string} document  the text of a scenario; empty if there is a problem
 * @property {Required<ProblemModule>} [problem]  where the functions of a problem come from
 * @property {PlannerOptions} [options]  of the planner
 * @property {number} budget  milliseconds in one slice
 */

/** Node, where it has no web workers. */
const node = typeof postMessage === "function" ? null : globalThis.process.getBuiltinModule;
const port = /** @type {MessagePort} */ (
  /** @type {unknown} */ (node === null ? globalThis : node("node:worker_threads").parentPort)
);

/** The runs by their numbers. @type {Map<number, AsyncGenerator<WorkerGrowth, void, undefined>>} */
const runs = new Map();
/** The core. @type {Promise<void>} */
let started;

/** @param {Given} given @returns {AsyncGenerator<WorkerGrowth, void, undefined>} */
async function* grow({ document, problem, options, budget }) {
  await started;
  const planned = problem === undefined ? Scenario.parse(document) : await problemOf(problem);
  try {
    const planner = planned.planner(options);
    try {
      for await (const growth of planner.growth({ budget }))
        yield { ...growth, result: growth.status === "running" ? null : planner.result() };
    } finally {
      planner.free();
    }
  } finally {
    planned.free();
  }
}

/** The problem that a module describes. @param {Required<ProblemModule>} problem */
async function problemOf({ module, export: name, arguments: given }) {
  /** @type {Record<string, unknown>} */
  let exports;
  try {
    // Bundlers leave it to the browser.
    exports = await import(/* webpackIgnore: true */ /* turbopackIgnore: true */ /* @vite-ignore */ String(module));
  } catch (error) {
    throw new PlanariumError(
      "module-failed",
      `The module ${module} could not be loaded: ${reasonOf(error)}`,
      "/module",
    );
  }
  const found = exports[name];
  if (found === undefined) {
    throw new PlanariumError(
      "module-failed",
      `The module ${module} has no export ${JSON.stringify(name)}; it has ${Object.keys(exports).join(", ") || "none"}.`,
      "/export",
    );
  }
  return new Problem(/** @type {ProblemDescription} */ (typeof found === "function" ? await found(...given) : found));
}

/** Plans a slice and sends it. @param {number} run */
async function answer(run) {
  try {
    const { value: growth } = /** @type {IteratorResult<WorkerGrowth, undefined>} */ (await runs.get(run)?.next());
    if (growth !== undefined)
      port.postMessage({ run, growth }, [growth.vertices.buffer, growth.edges.buffer, growth.events.buffer]);
  } catch (error) {
    if (isOwn(error)) {
      const { code, message, pointer, nearest } = error;
      port.postMessage({ run, fault: { code, message, pointer, nearest } });
      return;
    }
    try {
      port.postMessage({ run, thrown: [error] });
    } catch {
      // It cannot be sent.
      port.postMessage({
        run,
        fault: {
          code: "callback-failed",
          message: `A function of the problem has thrown: ${reasonOf(error)}`,
          pointer: "",
        },
      });
    }
  }
}

port.onmessage = ({ data }) => {
  if (typeof data !== "object" || data === null) return;
  if ("core" in data) {
    started = init(data.core ?? node?.("node:fs").readFileSync(new URL("./planarium_bg.wasm", import.meta.url)));
    // Every run reports it.
    started.catch(() => {});
  } else if ("given" in data) {
    runs.set(data.run, grow(data.given));
  } else if (!runs.has(data.run)) {
    return;
  } else if ("isOver" in data) {
    void runs
      .get(data.run)
      ?.return()
      .catch(() => {});
    runs.delete(data.run);
  } else {
    void answer(data.run);
  }
};
