/**
 * The page's side of the worker: orders go out, answers and states come in. Whoever asks waits for an answer, the page does not.
 */

/** @import { Commands } from "./worker/worker.js" */
/** @import { Fault, State } from "./types.js" */
/** @typedef {{ resolve: (value: unknown) => void, reject: (fault: StudioError) => void }} Waiting */

/** Commands after which nothing that is counted moves: they read, or they change how something looks or how fast it goes. */
const QUIET = new Set([
  "start", "facts", "curves", "log", "randomSeed", "provide", "thumbnail", "take", "takeStep", "takeEnd", "takeDrop",
  "pointer", "resize", "pace", "pane", "unpane",
]);

/** What the worker says has gone wrong. */
export class StudioError extends Error {
  /** @param {Fault} fault */
  constructor({ message, code, pointer }) {
    super(message);
    this.code = code;
    this.pointer = pointer;
  }
}

export class Studio {
  /** @param {Worker} worker @param {(error: Error) => void} onFault  what nobody waits for has gone wrong */
  constructor(worker, onFault) {
    this.worker = worker;
    this.onFault = onFault;
    /** Hears of each frame. @type {(state: State) => void} */
    this.onState = () => {};
    /** Hears of each order that moves something. */
    this.onOrder = () => {};
    /** The number of the newest such order: states from before it are old news. */
    this.ordered = -1;
    /** @type {Map<number, Waiting>} */
    this.waiting = new Map();
    this.count = 0;
    worker.addEventListener("message", ({ data }) => {
      if ("state" in data) {
        this.onState(data.state);
        return;
      }
      const waiting = this.waiting.get(data.id);
      this.waiting.delete(data.id);
      if (data.fault) waiting?.reject(new StudioError(data.fault));
      else waiting?.resolve(data.value);
    });
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      this.fail(new Error(event.message || "The worker could not be loaded."));
    });
  }

  /** Everyone who waits, waits in vain. @param {Error} error */
  fail(error) {
    for (const { reject } of this.waiting.values()) reject(/** @type {StudioError} */ (error));
    this.waiting.clear();
    this.onFault(error);
  }

  /**
   * Sends a command. States from before one that moves something are old news from here on.
   * @template {keyof Commands} C
   * @param {C} command
   * @param {Parameters<Commands[C]>} args
   * @param {Transferable[]} [transfer]
   * @returns {Promise<Awaited<ReturnType<Commands[C]>>>}  rejects with a `StudioError`
   */
  ask(command, args, transfer = []) {
    if (!QUIET.has(command)) this.order();
    return new Promise((resolve, reject) => {
      const id = this.count++;
      this.waiting.set(id, { resolve: (value) => resolve(/** @type {Awaited<ReturnType<Commands[C]>>} */ (value)), reject });
      this.worker.postMessage({ id, command, args }, transfer);
    });
  }

  /** Sends a command whose result is to be seen. @template {keyof Commands} C @param {C} command @param {Parameters<Commands[C]>} args */
  tell(command, ...args) {
    this.ask(command, args).catch((error) => this.onFault(error));
  }

  /** The next message is an order that moves something. */
  order() {
    this.ordered = this.count;
    this.onOrder();
  }
}
