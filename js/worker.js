/** Planning in workers: in browsers, Deno and Bun in web workers, in Node in its threads. Importing it loads neither a core nor a worker. */
import { PlanariumError, reasonOf } from "./error.js";
import { plain } from "./plain.js";

/** @import { Growth, InitSyncInput, PlannerOptions, ResultDocument, Scenario, ScenarioDocument } from "./core.js" */
/** @import { Worker as NodeWorker } from "node:worker_threads" */

/**
 * The end of a run.
 * @typedef {object} Ended
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
 * @property {(growth: WorkerGrowth) => void} [onProgress]  called with what each slice has added; what it throws ends the run
 */

/**
 * How a pool is made. Most programs need none of it.
 * @typedef {object} PoolOptions
 * @property {number} [workers]  workers at most, at least 1; by default one fewer than there are processors
 * @property {() => object} [worker]  starts a worker that runs `planarium/worker-entry`, where a bundler does not find it by itself
 * @property {string | InitSyncInput} [core]  the address (text or `URL`), the bytes or the compiled module of `planarium_bg.wasm`, where it does not lie beside that script
 */

/** A module of Node, where there are no web workers. @template {"worker_threads" | "os"} N @param {N} name */
const node = (name) => globalThis.process.getBuiltinModule(`node:${name}`);

/** Starts a worker of the platform. */
function start() {
  // Bundlers find the script of the worker by this very form.
  if (typeof Worker === "function") return new Worker(new URL("./worker-entry.js", import.meta.url), { type: "module" });
  const { Worker: Thread } = node("worker_threads");
  return new Thread(new URL("./worker-entry.js", import.meta.url));
}

/** A processor is left to the caller. */
function mostWorkers() {
  return Math.max(1, (globalThis.navigator?.hardwareConcurrency ?? node("os").availableParallelism()) - 1);
}

/**
 * Workers that plan. They are started when they are needed, and shared by runs if there are more runs than workers. Runs have the bits of the
 * same planner in `planarium`, stepped by hand.
 */
export class PlannerPool {
  /** @type {Required<Omit<PoolOptions, "core">> & Pick<PoolOptions, "core">} */
  #options;
  /** @type {PlanningWorker[]} */
  #workers = [];
  #isTerminated = false;

  /**
   * @param {PoolOptions} [options]
   * @throws {PlanariumError} `unknown-field`, `out-of-range`
   */
  constructor(options) {
    const { workers = mostWorkers(), worker = start, core, ...rest } = options ?? {};
    refuse(rest, "workers, worker, core");
    if (!Number.isInteger(workers) || workers < 1) throw new PlanariumError("out-of-range", `workers must be a whole number from 1, not ${String(workers)}`, "/workers");
    this.#options = { workers, worker, core: core instanceof URL ? core.href : core };
  }

  /**
   * Plans to the end.
   * @param {Scenario | ScenarioDocument | string} scenario
   * @param {PlannerOptions} [options]  those of `scenario.planner`
   * @param {RunOptions & ProgressOptions} [settings]
   * @returns {Promise<ResultDocument>}
   * @throws {PlanariumError} rejects as `growth` does
   */
  async plan(scenario, options, settings) {
    const { onProgress, ...rest } = settings ?? {};
    if (onProgress !== undefined && typeof onProgress !== "function") throw new PlanariumError("wrong-type", "onProgress must be a function", "/onProgress");
    let result = null;
    for await (const growth of this.growth(scenario, options, rest)) {
      onProgress?.(growth);
      ({ result } = growth);
    }
    return /** @type {ResultDocument} */ (result);
  }

  /**
   * Plans to the end, and yields what each slice has added; the arrays are transferred. The run starts with the first `next`, and `break` ends
   * it. While a slice is handled the next one is planned, and none after it: a slow loop makes the planner wait. The last slice has the result.
   * @param {Scenario | ScenarioDocument | string} scenario
   * @param {PlannerOptions} [options]  those of `scenario.planner`
   * @param {RunOptions} [settings]  when the signal is aborted, the loop throws its reason at once, and the worker drops the run after the slice in hand
   * @returns {AsyncGenerator<WorkerGrowth, void, undefined>}
   * @throws {PlanariumError} those of `Scenario.parse`, `scenario.planner` and `planner.growth`; `init-failed` if the worker or the core cannot be
   *   loaded; `internal` if either is lost (the next run has a new one); `freed` once the pool is terminated
   */
  async *growth(scenario, options, settings) {
    const { signal, budget = 16, ...rest } = settings ?? {};
    refuse(rest, "signal, budget, and onProgress of plan");
    if (signal !== undefined && typeof signal?.addEventListener !== "function") throw new PlanariumError("wrong-type", "signal must be an AbortSignal", "/signal");
    const { document } = /** @type {Scenario} */ (Object(scenario));
    const given = { document: copyOf(typeof document === "function" ? document.call(scenario) : scenario, "scenario"), options: copyOf(options, "options"), budget };
    if (signal?.aborted) throw signal.reason;
    const worker = this.#leastBusy();
    const run = worker.begin(given);
    const abort = () => worker.fail(run, signal?.reason);
    signal?.addEventListener("abort", abort);
    try {
      for (let ahead = worker.next(run); ;) {
        const growth = await ahead;
        if (signal?.aborted) throw signal.reason;
        if (growth.result === null) ahead = worker.next(run);
        yield growth;
        if (growth.result !== null) return;
      }
    } finally {
      signal?.removeEventListener("abort", abort);
      worker.end(run);
    }
  }

  /** Ends all workers at once, in the middle of a slice too. Runs are rejected with the code `freed`, and so are later ones. */
  terminate() {
    this.#isTerminated = true;
    for (const worker of this.#workers.splice(0)) worker.lose(terminated());
  }

  /** The same as `terminate`, for `using`. */
  [Symbol.dispose]() {
    this.terminate();
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

/** A worker with its runs. Each has a number, and asks for one slice at a time. */
class PlanningWorker {
  /** Why the worker is gone. @type {PlanariumError | undefined} */
  fault;
  /** How many runs it has. */
  runs = 0;
  #begun = 0;
  #hasAnswered = false;
  /** Who waits for a slice, by the number of the run. @type {Map<number, { resolve: (growth: WorkerGrowth) => void, reject: (reason: unknown) => void }>} */
  #waiting = new Map();
  #worker;

  /** @param {Pick<Required<PoolOptions>, "worker"> & PoolOptions} options */
  constructor({ worker, core }) {
    /** @type {Worker | NodeWorker | undefined} */
    let made;
    try {
      this.#worker = made = /** @type {Worker | NodeWorker} */ (worker());
      this.#listen();
      made.postMessage({ core });
    } catch (error) {
      void made?.terminate();
      throw new PlanariumError("init-failed", `A worker could not be started: ${reasonOf(error)}`, "", { cause: error });
    }
    this.#keepAlive(false);
  }

  /** @param {object} given @returns {number} the number of the run */
  begin(given) {
    const run = this.#begun++;
    if (this.runs++ === 0) this.#keepAlive(true);
    this.#worker.postMessage({ run, given });
    return run;
  }

  /** The next slice. @param {number} run @returns {Promise<WorkerGrowth>} */
  next(run) {
    const slice = new Promise((resolve, reject) => {
      if (this.fault !== undefined) return reject(this.fault);
      this.#waiting.set(run, { resolve, reject });
      this.#worker.postMessage({ run });
    });
    // It may be rejected before anybody awaits it.
    slice.catch(() => {});
    return slice;
  }

  /** Rejects whoever waits for a slice of this run. @param {number} run @param {unknown} reason */
  fail(run, reason) {
    this.#waiting.get(run)?.reject(reason);
  }

  /** Ends a run: the worker drops it after the slice in hand. @param {number} run */
  end(run) {
    this.#waiting.delete(run);
    if (this.fault !== undefined) return;
    this.#worker.postMessage({ run, isOver: true });
    if (--this.runs === 0) this.#keepAlive(false);
  }

  /** Ends the worker and all its runs. @param {PlanariumError} fault */
  lose(fault) {
    this.fault ??= fault;
    this.#worker.terminate();
    for (const { reject } of this.#waiting.values()) reject(fault);
  }

  #listen() {
    const worker = this.#worker;
    if ("on" in worker) {
      worker.on("message", (answer) => this.#hear(answer));
      worker.on("error", (error) => this.#break(reasonOf(error)));
      worker.on("exit", (code) => this.#break(`exit code ${code}`));
    } else {
      worker.onmessage = ({ data }) => this.#hear(data);
      worker.onerror = (event) => {
        event.preventDefault();
        this.#break(event.message || "no reason is given");
      };
    }
  }

  /** Whether Node waits for the worker before it exits. @param {boolean} isNeeded */
  #keepAlive(isNeeded) {
    if ("ref" in this.#worker) this.#worker[isNeeded ? "ref" : "unref"]();
  }

  /** @param {{ run: number, growth?: WorkerGrowth, fault?: { code: string, message: string, pointer: string, nearest?: readonly number[] } }} answer */
  #hear({ run, growth, fault }) {
    this.#hasAnswered = true;
    const sent = this.#waiting.get(run);
    if (growth !== undefined) return sent?.resolve(growth);
    const { code, message, pointer, nearest } = /** @type {PlanariumError} */ (fault);
    const error = new PlanariumError(code, message, pointer, { nearest });
    // The core is lost with all runs in it, or was never there.
    if (code === "internal" || code === "init-failed") this.lose(error);
    else sent?.reject(error);
  }

  /** The worker has stopped, or was never there. @param {string} reason */
  #break(reason) {
    this.lose(this.#hasAnswered
      ? new PlanariumError("internal", `A worker has stopped: ${reason}`)
      : new PlanariumError("init-failed", `The script of a worker could not be loaded: ${reason}`));
  }
}

/** A copy that can be sent. @param {unknown} value @param {string} name */
function copyOf(value, name) {
  const copy = typeof value === "object" && value !== null ? plain(value) : value;
  if (copy instanceof Error) throw new PlanariumError("wrong-type", `the ${name} cannot be read: ${copy.message}`, "", { cause: copy.cause });
  if (typeof copy === "function" || typeof copy === "symbol") throw new PlanariumError("wrong-type", `the ${name} is a ${typeof copy}`);
  return copy;
}

/** @param {object} unknown @param {string} known */
function refuse(unknown, known) {
  const [name] = Object.keys(unknown);
  if (name !== undefined) throw new PlanariumError("unknown-field", `unknown option ${JSON.stringify(name)}; known options are ${known}`, `/${name}`);
}

function terminated() {
  return new PlanariumError("freed", "This pool has been terminated.");
}
