/**
 * The page's end of the worker: each command is a method that returns a promise. With a signal as the last argument it
 * can be aborted: then the promise rejects at once, and the worker does not begin the command if it has not yet.
 */

/**
 * @template C
 * @typedef {{ [K in keyof C]: C[K] extends (...args: infer A) => infer R ?
 *   (...args: [...A, signal?: AbortSignal]) => Promise<Awaited<R>> : never }} Remote
 */

/**
 * Starts a worker with the compiled WebAssembly.
 * @param {Worker} worker
 * @param {string} room   whose commands it runs
 * @param {WebAssembly.Module | Promise<WebAssembly.Module>} core
 * @param {(error: Error) => void} onError   it could not be loaded, or failed outside of a command
 * @returns {unknown}  a `Remote` of the room's commands; rejections are errors with `code` and `pointer`
 */
export function connect(worker, room, core, onError) {
  /** @type {Map<number, { resolve: (value: unknown) => void, reject: (error: Error) => void }>} */
  const calls = new Map();
  let count = 0;
  const call = (
    /** @type {string} */ command,
    /** @type {unknown[]} */ args,
    /** @type {AbortSignal | undefined} */ signal = undefined,
  ) => {
    const id = count++;
    const abort = () => {
      calls.get(id)?.reject(signal?.reason);
      calls.delete(id);
      worker.postMessage({ id, isAborted: true });
    };
    return new Promise((resolve, reject) => {
      signal?.throwIfAborted();
      signal?.addEventListener("abort", abort);
      calls.set(id, { resolve, reject });
      worker.postMessage({ id, room, command, args });
    }).finally(() => signal?.removeEventListener("abort", abort));
  };
  worker.addEventListener("message", ({ data: { id, value, fault } }) => {
    const sent = calls.get(id);
    calls.delete(id);
    if (!fault) return sent?.resolve(value);
    const error = Object.assign(new Error(fault.message), fault);
    if (sent) sent.reject(error);
    // Nobody waits for it, but the worker has lost what it had.
    else if (fault.code === "internal") onError(error);
  });
  worker.addEventListener("error", (event) => {
    event.preventDefault();
    const error = new Error(event.message || "The worker could not be loaded.");
    for (const { reject } of calls.values()) reject(error);
    calls.clear();
    onError(error);
  });
  const started = Promise.resolve(core).then((module) => call("start", [module]));
  started.catch(onError);
  return new Proxy(
    {},
    {
      get:
        (_, command) =>
        async (/** @type {unknown[]} */ ...args) => {
          await started;
          const signal = args.at(-1) instanceof AbortSignal ? /** @type {AbortSignal} */ (args.pop()) : undefined;
          return call(String(command), args, signal);
        },
    },
  );
}
