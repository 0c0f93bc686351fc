/**
 * Planning in workers: in browsers, Deno and Bun in web workers, in Node in its threads. Importing it loads neither a
 * core nor a worker.
 */
import { PlanariumError, reasonOf } from "./error.js";
import { classOf } from "./handle.js";
import { budgetOf, copyOf, fieldsOf } from "./plain.js";
import { PlanningWorker } from "./planning-worker.js";
import { RemotePlanner } from "./remote-planner.js";

export { RemotePlanner } from "./remote-planner.js";

/** @import { Growth, InitSyncInput, PlannerOptions, ResultDocument, Scenario, ScenarioDocument } from "./core.js" */

/**
 * What a slice of a run in a worker has added besides.
 * @typedef {object} Ended
 * @property {Float64Array} traces  the shapes of the new edges: see `planner.tracesSince`
 * @property {Float64Array} motions  of a car along the new edges: see `planner.motionsSince`
 * @property {Float64Array} history  the new rows of history, if it is recorded: see `planner.historySince`
 * @property {ResultDocument | null} result  of a run that has ended; null before
 */

/** What a slice of a run has added. @typedef {Growth & Ended} WorkerGrowth */

/**
 * An `AbortSignal`, as far as it matters here.
 * @typedef {object} Signal
 * @property {boolean} aborted  whether it has been aborted
 * @property {unknown} reason  why: what the run is rejected with
 * @property {(type: "abort", listener: () => void) => void} addEventListener  listens
 * @property {(type: "abort", listener: () => void) => void} removeEventListener  listens no more
 */

/**
 * How a run is planned.
 * @typedef {object} RunOptions
 * @property {Signal} [signal]  an `AbortSignal` that ends the run
 * @property {number} [budget]  the time of one slice, in milliseconds; 16 by default
 */

/**
 * What `plan` takes besides.
 * @typedef {object} ProgressOptions
 * @property {(growth: WorkerGrowth) => unknown} [onProgress]  called with what each slice has added; if it returns a
 *   promise, that is awaited before the next slice is handed over; what it throws, or is rejected with, ends the run
 */

/**
 * A problem of a custom robot, whose functions are in a module: a worker imports it, since functions cannot be
 * sent.
 * @typedef {object} ProblemModule
 * @property {string | { readonly href: string }} module  its absolute address, such as `new URL("./robot.js",
 *   import.meta.url)`
 * @property {string} [export]  the name of the export, `default` by default: a `ProblemDescription`, or a function that
 *   returns one, or a promise of it
 * @property {readonly unknown[]} [arguments]  of that function; they are cloned
 */

/**
 * How a pool is made. Most programs need none of it.
 * @typedef {object} PoolOptions
 * @property {number} [workers]  workers at most, at least 1; by default one fewer than there are processors
 * @property {() => object} [worker]  starts a worker that runs `planarium/worker-entry`, where a bundler does not find
 *   it by itself
 * @property {string | InitSyncInput} [core]  the address (text or `URL`), the bytes or the compiled module of
 *   `planarium_bg.wasm`, where it does not lie beside that script
 */

/** A module of Node, where there are no web workers. @template {"worker_threads" | "os"} N @param {N} name */
const node = (name) => globalThis.process.getBuiltinModule(`node:${name}`);

/** Starts a worker of the platform. */
function start() {
  // Bundlers find the script of the worker by this very form.
  if (typeof Worker === "function")
    return new Worker(new URL("./worker-entry.js", import.meta.url), { type: "module" });
  const { Worker: Thread } = node("worker_threads");
  return new Thread(new URL("./worker-entry.js", import.meta.url));
}

/** A processor is left to the caller. */
function mostWorkers() {
  return Math.max(1, (globalThis.navigator?.hardwareConcurrency ?? node("os").availableParallelism()) - 1);
}

/**
 * Workers that plan. They are started when they are needed, and shared by runs if there are more runs than workers.
 * Runs have the bits of the same planner in `planarium`, stepped by hand.
 */
export class PlannerPool {
  /** @type {Required<Omit<PoolOptions, "core">> & Pick<PoolOptions, "core">} */
  #options;
  /** @type {PlanningWorker[]} */
  #workers = [];
  #isTerminated = false;

  /**
   * @param {PoolOptions} [options]
   * @throws {PlanariumError} `wrong-type`, `unknown-field`, `out-of-range`
   */
  constructor(options) {
    const {
      workers = mostWorkers(),
      worker = start,
      core,
    } = /** @type {PoolOptions} */ (fieldsOf(options, "options", "workers, worker, core"));
    if (!Number.isInteger(workers) || workers < 1)
      throw new PlanariumError(
        "out-of-range",
        `workers must be a whole number from 1, not ${String(workers)}`,
        "/workers",
      );
    this.#options = { workers, worker, core: core instanceof URL ? core.href : core };
  }

  /**
   * Plans to the end.
   * @param {Scenario | ScenarioDocument | string | ProblemModule} scenario
   * @param {PlannerOptions} [options]  those of `scenario.planner`, or of `problem.planner`
   * @param {RunOptions & ProgressOptions} [settings]
   * @returns {Promise<ResultDocument>}
   * @throws {PlanariumError} rejects as `growth` does
   */
  async plan(scenario, options, settings) {
    PlannerPool.#require(this, "plan");
    const { onProgress, signal, budget } = /** @type {RunOptions & ProgressOptions} */ (
      fieldsOf(settings, "settings", "signal, budget, onProgress")
    );
    if (onProgress !== undefined && typeof onProgress !== "function")
      throw new PlanariumError("wrong-type", "onProgress must be a function", "/onProgress");
    let result = null;
    for await (const growth of this.#slices(scenario, options, { signal, budget }, onProgress)) ({ result } = growth);
    return /** @type {ResultDocument} */ (result);
  }

  /**
   * Plans to the end, and yields what each slice has added; the arrays are transferred. The run starts with the first
   * `next`, and `break` ends it. While a slice is handled the next one is planned, and none after it: a slow loop makes
   * the planner wait. The last slice has the result.
   * @param {Scenario | ScenarioDocument | string | ProblemModule} scenario
   * @param {PlannerOptions} [options]  those of `scenario.planner`, or of `problem.planner`
   * @param {RunOptions} [settings]  when the signal is aborted, the loop throws its reason at once, and the worker
   *   drops the run after the slice in hand
   * @returns {AsyncGenerator<WorkerGrowth, void, undefined>}
   * @throws {PlanariumError} those of `Scenario.parse`, `scenario.planner` and `planner.growth`; `unsupported` for a
   *   problem whose functions are not in a module, `module-failed` if its module cannot be loaded or has no such
   *   export, and a copy of what its functions throw; `init-failed` if the worker or the core cannot be loaded;
   *   `internal` if either is lost (the next run has a new one); `freed` once the pool is terminated
   */
  async *growth(scenario, options, settings) {
    PlannerPool.#require(this, "growth");
    yield* this.#slices(
      scenario,
      options,
      /** @type {RunOptions} */ (fieldsOf(settings, "settings", "signal, budget")),
    );
  }

  /**
   * Makes a planner that is stepped by hand.
   * @param {Scenario | ScenarioDocument | string | ProblemModule} scenario
   * @param {PlannerOptions} [options]  those of `scenario.planner`, or of `problem.planner`
   * @param {Pick<RunOptions, "signal">} [settings]  when the signal is aborted, all calls reject with its reason, and
   *   the planner is freed
   * @returns {Promise<RemotePlanner>}
   * @throws {PlanariumError} rejects as `growth` does
   */
  async planner(scenario, options, settings) {
    PlannerPool.#require(this, "planner");
    const { signal } = /** @type {RunOptions} */ (fieldsOf(settings, "settings", "signal"));
    const run = this.#begin(scenario, options, signal);
    try {
      return await RemotePlanner.of(run);
    } catch (error) {
      run.end(error);
      throw error;
    }
  }

  /**
   * @param {Scenario | ScenarioDocument | string | ProblemModule} scenario
   * @param {PlannerOptions | undefined} options
   * @param {RunOptions} settings
   * @param {(growth: WorkerGrowth) => unknown} [onProgress]
   * @returns {AsyncGenerator<WorkerGrowth, void, undefined>}
   */
  async *#slices(scenario, options, { signal, budget = 16 }, onProgress) {
    budgetOf(budget);
    const run = this.#begin(scenario, options, signal);
    const next = () => {
      /** @type {Promise<WorkerGrowth>} */
      const slice = run.call("slice", budget);
      slice.catch((error) => run.end(error));
      return slice;
    };
    try {
      for (let ahead = next(); ;) {
        const growth = await ahead;
        if (signal?.aborted) throw signal.reason;
        if (growth.result === null) ahead = next();
        // A listener that never ends must not outlast the run.
        if (onProgress !== undefined) await Promise.race([onProgress(growth), run.failure]);
        yield growth;
        if (growth.result !== null) return;
      }
    } finally {
      run.end(undefined);
    }
  }

  /**
   * @param {Scenario | ScenarioDocument | string | ProblemModule} scenario
   * @param {PlannerOptions | undefined} options
   * @param {Signal | undefined} signal
   */
  #begin(scenario, options, signal) {
    if (signal !== undefined && typeof signal?.addEventListener !== "function")
      throw new PlanariumError("wrong-type", "signal must be an AbortSignal", "/signal");
    const given = { ...planned(scenario), options: copyOf(options, "options") };
    if (signal?.aborted) throw signal.reason;
    return this.#leastBusy().begin(given, signal);
  }

  /**
   * Ends all workers at once, in the middle of a slice too. Runs are rejected with the code `freed`, and so are later
   * ones.
   */
  terminate() {
    PlannerPool.#require(this, "terminate");
    this.#isTerminated = true;
    for (const worker of this.#workers.splice(0)) worker.lose(terminated());
  }

  /** The same as `terminate`, for `using`. */
  [Symbol.dispose]() {
    PlannerPool.#require(this, "terminate");
    this.terminate();
  }

  /** Refuses a receiver that is no pool. @param {unknown} self @param {string} name  of the method */
  static #require(self, name) {
    if (!(#isTerminated in Object(self)))
      throw new PlanariumError(
        "illegal-invocation",
        `${name} belongs to a PlannerPool, and was called on something else.`,
      );
  }

  /** The worker with the fewest runs; a new one if all have some, as far as there may be more. */
  #leastBusy() {
    if (this.#isTerminated) throw terminated();
    this.#workers = this.#workers.filter(({ fault }) => fault === undefined);
    const [first] = this.#workers.sort((a, b) => a.runs - b.runs);
    if (first !== undefined && (first.runs === 0 || this.#workers.length >= this.#options.workers)) return first;
    const worker = new PlanningWorker(this.#options);
    this.#workers.push(worker);
    return worker;
  }
}

/**
 * What a worker plans, as it is sent.
 * @param {unknown} scenario
 * @returns {{ document: unknown } | { problem: Required<ProblemModule> }}
 */
function planned(scenario) {
  /** @type {Record<string, unknown>} */
  let fields = {};
  try {
    const { document, module, space, clearance, isFree } = Object(scenario);
    fields = { document, module, space, clearance, isFree };
  } catch {
    // The copy says why it cannot be read.
  }
  const { document, module, space, clearance, isFree } = fields;
  if (typeof document === "function") return { document: copyOf(document.call(scenario), "scenario") };
  if (module !== undefined) return { problem: moduleOf(scenario) };
  if (
    classOf(scenario) === "Problem" ||
    (space !== undefined && (typeof clearance === "function" || typeof isFree === "function"))
  ) {
    throw new PlanariumError(
      "unsupported",
      'A problem has functions, which cannot be sent to a worker: put its description into a module, and give { module: new URL("./robot.js", import.meta.url) }.',
    );
  }
  return { document: copyOf(scenario, "scenario") };
}

/** @param {unknown} given @returns {Required<ProblemModule>} */
function moduleOf(given) {
  const {
    module,
    export: name = "default",
    arguments: list = [],
  } = fieldsOf(given, "problem", "module, export, arguments");
  let address = "";
  try {
    ({ href: address } = new URL(String(Object(module).href ?? module)));
  } catch (error) {
    throw new PlanariumError(
      "wrong-type",
      `module must be an absolute address, such as new URL("./robot.js", import.meta.url): ${reasonOf(error)}`,
      "/module",
      { cause: error },
    );
  }
  if (typeof name !== "string")
    throw new PlanariumError("wrong-type", "export must be the name of an export", "/export");
  if (!Array.isArray(list)) throw new PlanariumError("wrong-type", "arguments must be a list", "/arguments");
  try {
    return { module: address, export: name, arguments: structuredClone(list) };
  } catch (error) {
    throw new PlanariumError(
      "wrong-type",
      `the arguments cannot be sent to a worker: ${reasonOf(error)}`,
      "/arguments",
      { cause: error },
    );
  }
}

function terminated() {
  return new PlanariumError("freed", "This pool has been terminated.");
}
