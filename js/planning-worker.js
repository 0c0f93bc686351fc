/** The pool's end of a worker: its runs, and the calls of each. The worker's end is `worker-entry.js`. */
import { PlanariumError, reasonOf } from "./error.js";

/** @import { Worker as NodeWorker } from "node:worker_threads" */
/** @import { PoolOptions, Signal } from "./worker.js" */

/** Why a worker whose message cannot be read is given up: it may have been a slice. */
const UNREADABLE = "a message of it cannot be read";

/** A planner in a worker, with the calls of its methods that wait for an answer. */
export class Run {
  /** @type {Map<number, { resolve: (value: any) => void, reject: (reason: unknown) => void }>} */
  #calls = new Map();
  #called = 0;
  #signal;
  #worker;
  /** Why it is over. @type {[reason: unknown] | undefined} */
  #end;
  /** @type {(reason: unknown) => void} */
  #fail = () => {};
  /** Rejected once the run has failed. @type {Promise<never>} */
  failure = new Promise((_, reject) => {
    this.#fail = reject;
  });

  /** @param {number} number @param {PlanningWorker} worker @param {Signal | undefined} signal */
  constructor(number, worker, signal) {
    this.number = number;
    this.#worker = worker;
    this.#signal = signal;
    signal?.addEventListener("abort", this.#abort);
    // It may be rejected before anybody awaits it.
    this.failure.catch(() => {});
  }

  /** Whether calls wait. */
  get isBusy() {
    return this.#calls.size > 0;
  }

  /** Calls a method of the planner in the worker. @param {string} method @param {unknown[]} args @returns {Promise<any>} */
  call(method, ...args) {
    return new Promise((resolve, reject) => {
      if (this.#end !== undefined) {
        reject(this.#end[0]);
        return;
      }
      const call = this.#called++;
      this.#calls.set(call, { resolve, reject });
      this.#worker.send({ run: this.number, call, method, args });
    });
  }

  /** Takes the call with a number, which is answered. @param {number} call */
  take(call) {
    const waiting = this.#calls.get(call);
    this.#calls.delete(call);
    return waiting;
  }

  /** Ends the run: calls are rejected, and the worker frees the planner. @param {unknown} reason */
  end(reason) {
    if (this.#end !== undefined) return;
    this.#end = [reason];
    this.#signal?.removeEventListener("abort", this.#abort);
    this.#fail(reason);
    for (const { reject } of this.#calls.values()) reject(reason);
    this.#calls.clear();
    this.#worker.drop(this);
  }

  #abort = () => this.end(this.#signal?.reason);
}

/** A worker with its runs. */
export class PlanningWorker {
  /** Why the worker is gone. @type {PlanariumError | undefined} */
  fault;
  #begun = 0;
  #hasAnswered = false;
  /** The runs by their numbers. @type {Map<number, Run>} */
  #runs = new Map();
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
      if (typeof made?.terminate === "function") void made.terminate();
      throw new PlanariumError("init-failed", `A worker could not be started: ${reasonOf(error)}`, "", {
        cause: error,
      });
    }
    this.#keepAlive();
  }

  /** How many runs it has. */
  get runs() {
    return this.#runs.size;
  }

  /** @param {object} given @param {Signal | undefined} signal */
  begin(given, signal) {
    const run = new Run(this.#begun++, this, signal);
    this.#runs.set(run.number, run);
    this.#worker.postMessage({ run: run.number, given });
    return run;
  }

  /** @param {object} message */
  send(message) {
    this.#worker.postMessage(message);
    this.#keepAlive();
  }

  /** Drops a run that is over. @param {Run} run */
  drop({ number }) {
    this.#runs.delete(number);
    if (this.fault === undefined) this.send({ run: number, isOver: true });
  }

  /** Ends the worker and all its runs. @param {PlanariumError} fault */
  lose(fault) {
    this.fault ??= fault;
    this.#worker.terminate();
    for (const run of this.#runs.values()) run.end(fault);
  }

  #listen() {
    const worker = this.#worker;
    if ("on" in worker) {
      worker.on("message", (answer) => this.#hear(answer));
      worker.on("error", (error) => this.#break(reasonOf(error)));
      worker.on("messageerror", () => this.#break(UNREADABLE));
      worker.on("exit", (code) => this.#break(`exit code ${code}`));
    } else {
      worker.onmessage = ({ data }) => this.#hear(data);
      worker.onmessageerror = () => this.#break(UNREADABLE);
      worker.onerror = (event) => {
        event.preventDefault();
        this.#break(event.message || "no reason is given");
      };
    }
  }

  /** Node waits for the worker before it exits only while calls wait. */
  #keepAlive() {
    if ("ref" in this.#worker) this.#worker[[...this.#runs.values()].some(({ isBusy }) => isBusy) ? "ref" : "unref"]();
  }

  /**
   * Takes an answer of `worker-entry.js`. Other messages are not for the pool: a worker may run further code.
   * @param {unknown} message
   */
  #hear(message) {
    const given = Object(message);
    const { run, call, value, fault, thrown } =
      /** @type {{ run?: unknown, call?: unknown, value?: unknown, fault?: PlanariumError, thrown?: [unknown] }} */ (
        given
      );
    const isFault = typeof fault?.code === "string" && typeof fault.message === "string";
    if (typeof run !== "number" || typeof call !== "number") return;
    if (!(isFault || "value" in given || Array.isArray(thrown))) return;
    this.#hasAnswered = true;
    const waiting = this.#runs.get(run)?.take(call);
    this.#keepAlive();
    if (!isFault) {
      if (thrown === undefined) waiting?.resolve(value);
      else waiting?.reject(thrown[0]);
      return;
    }
    const error = new PlanariumError(fault.code, fault.message, fault.pointer, { nearest: fault.nearest });
    waiting?.reject(error);
    // The core is lost with all runs in it, or was never there.
    if (fault.code === "internal" || fault.code === "init-failed") this.lose(error);
  }

  /** The worker has stopped, or was never there. @param {string} reason */
  #break(reason) {
    this.lose(
      this.#hasAnswered
        ? new PlanariumError("internal", `A worker has stopped: ${reason}`)
        : new PlanariumError("init-failed", `The script of a worker could not be loaded: ${reason}`),
    );
  }
}
