/** The page's side of a room's worker: questions go out, answers come in. */

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

/** @template {Record<string, (...args: any[]) => unknown>} C   the worker's commands */
export class Asker {
  /** @param {string} url   of the worker, a module @param {(error: Error) => void} onFault   it could not be loaded, or fell over by itself */
  constructor(url, onFault) {
    this.worker = new Worker(url, { type: "module" });
    /** @type {Map<number, { resolve: (value: any) => void, reject: (error: Error) => void }>} */
    this.waiting = new Map();
    this.count = 0;
    this.worker.addEventListener("message", ({ data: { id, value, fault } }) => {
      const one = this.waiting.get(id);
      this.waiting.delete(id);
      if (fault) one?.reject(new WorkerError(fault));
      else one?.resolve(value);
    });
    this.worker.addEventListener("error", (event) => {
      event.preventDefault();
      const error = new Error(event.message || "The worker could not be loaded.");
      for (const { reject } of this.waiting.values()) reject(error);
      this.waiting.clear();
      onFault(error);
    });
  }

  /** Hands over the compiled WebAssembly. @param {WebAssembly.Module} core @returns {Promise<{ version: string }>} */
  start(core) { return this.send("start", [core], []); }

  /**
   * @template {keyof C & string} K
   * @param {K} command @param {Parameters<C[K]>} args
   * @returns {Promise<Awaited<ReturnType<C[K]>>>}  rejects with a `WorkerError`
   */
  ask(command, ...args) { return this.send(command, args, []); }

  /** @param {string} command @param {unknown[]} args @param {Transferable[]} transfer @returns {Promise<any>} */
  send(command, args, transfer) {
    return new Promise((resolve, reject) => {
      const id = this.count++;
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, command, args }, transfer);
    });
  }
}
