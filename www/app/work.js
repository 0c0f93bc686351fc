/** Work that takes a while. */

/**
 * Work of which only the newest call counts: a newer one aborts the older, and `cancel` aborts it too. A call that was
 * aborted rejects with an `AbortError`, which `App.fail` does not show, whatever came of its work.
 * @template {unknown[]} A
 * @template T
 * @param {(signal: AbortSignal, ...args: A) => Promise<T>} work
 * @returns {((...args: A) => Promise<T>) & { cancel: () => void }}
 */
export function latest(work) {
  let controller = new AbortController();
  const cancel = () => controller.abort();
  const call = async (/** @type {A} */ ...args) => {
    cancel();
    const { signal } = (controller = new AbortController());
    try {
      return await work(signal, ...args);
    } finally {
      signal.throwIfAborted();
    }
  };
  return Object.assign(call, { cancel });
}

/**
 * Work that runs once at a time: of the calls meanwhile only one follows, when it has ended.
 * @param {() => Promise<unknown>} work   reads the state that it works on
 * @returns {() => Promise<void>}   resolves when nothing is left to do
 */
export function coalesced(work) {
  /** @type {Promise<void> | null} */
  let running = null;
  let isDue = false;
  const run = async () => {
    try {
      while (isDue) {
        isDue = false;
        await work();
      }
    } finally {
      running = null;
    }
  };
  return () => {
    isDue = true;
    return (running ??= run());
  };
}

/** Whether work was aborted. @param {unknown} error */
export function isAbort(error) {
  return error instanceof DOMException && error.name === "AbortError";
}
