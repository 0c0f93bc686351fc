/**
 * The script of a worker of `PlannerPool`. The first message has the address or the contents of the core, if it is not
 * beside this file. A message `{ run, given }` makes a planner; `{ run, call, method, args }` calls a method of it, one
 * call after the other, and is answered by `{ run, call, value }`, `{ run, call, fault }` or, with what a function of
 * the caller's has thrown, `{ run, call, thrown: [value] }`; `{ run, isOver: true }` frees the planner. Other messages
 * are ignored.
 */
import init, { Problem, Scenario } from "./planarium.js";
import { PlanariumError, isOwn, reasonOf } from "./error.js";
import { Pause } from "./growth.js";
import { PlannerHost } from "./planner-host.js";

/** @import { PlannerOptions, ProblemDescription } from "./core.js" */
/** @import { ProblemModule, WorkerGrowth } from "./worker.js" */
/**
 * A planner that the pool wants.
 * @typedef {object} Given
 * @property {string} document  the text of a scenario; empty if there is a problem
 * @property {Required<ProblemModule>} [problem]  where the functions of a problem come from
 * @property {PlannerOptions} [options]  of the planner
 */

/** Node, where it has no web workers. */
const node = typeof postMessage === "function" ? null : globalThis.process.getBuiltinModule;
const port = /** @type {MessagePort} */ (
  /** @type {unknown} */ (node === null ? globalThis : node("node:worker_threads").parentPort)
);

/** Milliseconds after which other messages have their turn. */
const TURN = 16;

/** A planner of the pool: the methods that are more than those of `Planner`. */
class Host extends PlannerHost {
  #isFreed = false;
  #hasBegun = false;
  #pause = new Pause();

  /** What a caller must know to read its rows. */
  widths() {
    const { dimension, eventWidth, historyWidth } = this.planner;
    return { dimension, eventWidth, historyWidth };
  }

  /** The next slice of `planner.growth`. @param {number} budget  milliseconds */
  slice(budget) {
    if (this.#hasBegun) this.planner.stepFor(budget);
    this.#hasBegun = true;
    return this.grown();
  }

  /**
   * Makes at most some iterations, for about some time; one at least.
   * @param {number} iterations  refused as by `planner.step`
   * @param {number} budget  milliseconds
   * @returns {Promise<WorkerGrowth | undefined>}  none if it was freed meanwhile
   */
  async step(iterations, budget) {
    const { planner } = this;
    const until = performance.now() + budget;
    const end = planner.iterations + iterations;
    planner.step(Number.isSafeInteger(iterations) && iterations > 1 ? 1 : iterations);
    const left = () => end - planner.iterations;
    while (!this.stepUntil(left, Math.min(until, performance.now() + TURN)) && performance.now() < until) {
      await this.#pause.next();
      if (this.#isFreed) return undefined;
    }
    return this.grown();
  }

  /** @override */
  free() {
    this.#isFreed = true;
    this.#pause.end();
    super.free();
  }
}

/**
 * The planners by the numbers of their runs, and the end of the last call.
 * @type {Map<number, { host: Promise<Host>, last: Promise<void> }>}
 */
const runs = new Map();
/** The core. @type {Promise<void>} */
let started;

/** @param {Given} given */
async function begin({ document, problem, options }) {
  await started;
  const planned = problem === undefined ? Scenario.parse(document) : await problemOf(problem);
  try {
    return new Host(planned.planner(options));
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

/**
 * Calls a method, of the host or else of its planner, and sends what it returns.
 * @param {Promise<Host>} host
 * @param {{ run: number, call: number, method: string, args: unknown[] }} asked
 */
async function answer(host, { run, call, method, args }) {
  if (!runs.has(run)) return;
  try {
    const made = await host;
    const target = method in made ? made : made.planner;
    const value = await Reflect.get(target, method).apply(target, args);
    port.postMessage({ run, call, value }, buffersOf(value));
  } catch (error) {
    if (isOwn(error)) {
      const { code, message, pointer, nearest } = error;
      port.postMessage({ run, call, fault: { code, message, pointer, nearest } });
      return;
    }
    try {
      port.postMessage({ run, call, thrown: [error] });
    } catch {
      // It cannot be sent.
      port.postMessage({
        run,
        call,
        fault: {
          code: "callback-failed",
          message: `A function of the problem has thrown: ${reasonOf(error)}`,
          pointer: "",
        },
      });
    }
  }
}

/** The memory of an array, or of the arrays in an object. @param {unknown} value */
function buffersOf(value) {
  const parts = ArrayBuffer.isView(value) ? [value] : Object.values(Object(value));
  return parts.filter((part) => ArrayBuffer.isView(part)).map(({ buffer }) => /** @type {ArrayBuffer} */ (buffer));
}

port.onmessage = ({ data }) => {
  if (typeof data !== "object" || data === null) return;
  if ("core" in data) {
    started = init(data.core ?? node?.("node:fs").readFileSync(new URL("./planarium_bg.wasm", import.meta.url)));
    // Every run reports it.
    started.catch(() => {});
    return;
  }
  if ("given" in data) {
    const host = begin(data.given);
    host.catch(() => {});
    runs.set(data.run, { host, last: Promise.resolve() });
    return;
  }
  const run = runs.get(data.run);
  if (run === undefined) return;
  const { host } = run;
  if ("isOver" in data) {
    runs.delete(data.run);
    host.then((made) => made.free()).catch(() => {});
  } else if ("method" in data) {
    run.last = run.last.then(() => answer(host, data));
  }
};
