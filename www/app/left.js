/**
 * The state in which a page was left, for the way back and forward to it where the browser has not kept the page. It is
 * stored in the tab, by the key of the page's entry in the history; a browser without such keys opens the address.
 */

/** The name under which the state of the current entry is stored. */
const place = () => `left ${/** @type {any} */ (globalThis).navigation.currentEntry.key}`;

/** Stores the state whenever the page is left. @param {() => object} save   plain data */
export function keepState(save) {
  addEventListener("pagehide", () => {
    try {
      sessionStorage.setItem(place(), JSON.stringify(save()));
    } catch {
      // It is too large, there is no storage or no key, or nothing is open yet.
    }
  });
}

/** Whether the browser has gone back or forward to the page. */
export function isReturn() {
  const [opened] = /** @type {PerformanceNavigationTiming[]} */ (performance.getEntriesByType("navigation"));
  return opened?.type === "back_forward";
}

/**
 * The state in which the page was left, if the browser has gone back or forward to it.
 * @param {(state: unknown) => void} check   throws what is no state of the page
 * @returns {object | null}
 */
export function stateLeft(check) {
  if (!isReturn()) return null;
  try {
    const state = JSON.parse(sessionStorage.getItem(place()) ?? "null");
    if (state) check(state);
    return state;
  } catch {
    // Another version of the page stored it.
    return null;
  }
}
