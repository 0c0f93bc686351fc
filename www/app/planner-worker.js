/**
 * The page's side of the worker that plans: requests are sent, replies come in. Whoever asks waits for a reply, the page does not.
 */

/** @import { Commands } from "../planner/worker/worker.js" */
/** @import { Fault } from "../domain/types.js" */

/** What the worker says has gone wrong. */
export class WorkerError extends Error {
  /** @param {Fault} fault */
  constructor({ message, code, pointer }) {
    super(message);
    this.code = code;
    this.pointer = pointer;
  }
}

export class PlannerWorker {
  /** @param {Worker} worker @param {(error: Error) => void} onFault  it could not be loaded, or fell over by itself */
  constructor(worker, onFault) {
    this.worker = worker;
    /** @type {Map<number, { resolve: (value: any) => void, reject: (error: Error) => void }>} */
    this.waiting = new Map();
    this.count = 0;
    worker.addEventListener("message", ({ data: { id, value, fault } }) => {
      const waiting = this.waiting.get(id);
      this.waiting.delete(id);
      if (fault) waiting?.reject(new WorkerError(fault));
      else waiting?.resolve(value);
    });
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      const error = new Error(event.message || "The worker could not be loaded.");
      for (const { reject } of this.waiting.values()) reject(error);
      this.waiting.clear();
      onFault(error);
    });
  }

  /**
   * @template {keyof Commands} C
   * @param {C} command @param {Parameters<Commands[C]>} args @param {Transferable[]} [transfer]
   * @returns {Promise<Awaited<ReturnType<Commands[C]>>>}  rejects with a `WorkerError`
   */
  ask(command, args, transfer = []) {
    return new Promise((resolve, reject) => {
      const id = this.count++;
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, command, args }, transfer);
    });
  }
}
