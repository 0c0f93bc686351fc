/** The page's end of the worker: each command is a method that returns a promise. */

/**
 * @template C
 * @typedef {{ [K in keyof C]: C[K] extends (...args: infer A) => infer R ? (...args: A) => Promise<Awaited<R>> : never
 *   }} Remote
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
  const call = (/** @type {string} */ command, /** @type {unknown[]} */ args) =>
    new Promise((resolve, reject) => {
      calls.set(count, { resolve, reject });
      worker.postMessage({ id: count++, room, command, args });
    });
  worker.addEventListener("message", ({ data: { id, value, fault } }) => {
    const sent = calls.get(id);
    calls.delete(id);
    if (fault) sent?.reject(Object.assign(new Error(fault.message), fault));
    else sent?.resolve(value);
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
          return call(String(command), args);
        },
    },
  );
}
