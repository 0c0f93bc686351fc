/**
 * The state in which a page was left, for the way back and forward to it where the browser has not kept the page. It is
 * stored in the tab, by the key of the page's entry in the history; a browser without such keys opens the address. A
 * page in a frame always opens its address, which is its parent's to choose.
 */

/** Characters of a state that is stored, at most: all states of a tab have room for some millions. */
const MOST = 1 << 20;

const isFrame = () => window.parent !== window;

/** The name under which the state of the current entry is stored. */
const place = () => `left ${location.pathname} ${/** @type {any} */ (globalThis).navigation.currentEntry.key}`;

/** Stores the state whenever the page is left. @param {() => object | null} save   plain data; null: nothing is open */
export function keepState(save) {
  if (isFrame()) return;
  addEventListener("pagehide", () => {
    try {
      const state = save();
      const text = JSON.stringify(state);
      if (state && text.length <= MOST) sessionStorage.setItem(place(), text);
    } catch {
      // There is no storage, none is left, or the browser has no keys: the way back leads to the address.
    }
  });
}

/**
 * Takes what was stored for this entry of the history.
 * @returns {object | null} the state in which the page was left, if the browser has gone back or forward to it
 */
export function takeState() {
  if (isFrame()) return null;
  try {
    const text = sessionStorage.getItem(place());
    sessionStorage.removeItem(place());
    const [opened] = /** @type {PerformanceNavigationTiming[]} */ (performance.getEntriesByType("navigation"));
    return text !== null && opened?.type === "back_forward" ? JSON.parse(text) : null;
  } catch {
    return null;
  }
}
