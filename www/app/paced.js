/**
 * Limits how often a function is called: of several calls within a pause, the last one is made, at its end.
 * @template {unknown[]} A
 * @param {number} pause   milliseconds
 * @param {(...args: A) => void} act
 * @returns {(...args: A) => void}
 */
export function paced(pause, act) {
  let last = -Infinity;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  return (...args) => {
    clearTimeout(timer);
    timer = setTimeout(
      () => {
        last = performance.now();
        act(...args);
      },
      Math.max(0, last + pause - performance.now()),
    );
  };
}

/**
 * Tells how often to do something.
 * @param {number} pause   milliseconds
 * @returns {(isForced: boolean) => boolean}   whether it is forced, or the pause since the last time is over
 */
export function pacer(pause) {
  let last = -Infinity;
  return (isForced) => {
    const now = performance.now();
    if (!isForced && now - last < pause) return false;
    last = now;
    return true;
  };
}
