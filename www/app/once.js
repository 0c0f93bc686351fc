/**
 * Something that is fetched once, when it is first asked for. Whoever asks meanwhile waits for the same promise, so that all go on
 * in the order in which they asked: of several imports of one module the last may be told first. What could not be fetched is
 * fetched again by the next who asks.
 * @template T
 * @param {() => Promise<T>} load
 * @returns {() => Promise<T>}
 */
export function once(load) {
  /** @type {Promise<T> | undefined} */
  let loading;
  return () => loading ??= load().catch((error) => {
    loading = undefined;
    throw error;
  });
}
