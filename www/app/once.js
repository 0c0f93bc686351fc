/**
 * Loads something once, with the first call. Later calls return the same promise, so that callers continue in their
 * order. After a failure the next call tries again.
 * @template T
 * @param {() => Promise<T>} load
 * @returns {() => Promise<T>}
 */
export function once(load) {
  /** @type {Promise<T> | undefined} */
  let loading;
  return () =>
    (loading ??= load().catch((error) => {
      loading = undefined;
      throw error;
    }));
}

/**
 * Compares values with those of the call before, by name: what takes long is shown again only if they differ.
 * @returns {(name: string, ...values: unknown[]) => boolean}   whether they differ
 */
export function comparer() {
  /** @type {Map<string, unknown[]>} */
  const known = new Map();
  return (name, ...values) => {
    const before = known.get(name);
    known.set(name, values);
    return !before || before.length !== values.length || !values.every((value, i) => Object.is(value, before[i]));
  };
}
