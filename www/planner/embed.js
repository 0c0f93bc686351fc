/**
 * The page inside another one: `?embed=1` shows the stage and its transport only, and the parent may steer it by messages.
 *
 * The parent posts `{ planarium: "load" | "play" | "pause" | "step" | "seek" | "state", id?, ... }` to the frame:
 * - `load`: `scene` (an id) or `document` (a scenario), and, if wanted, `algorithm`, `settings`, `query`, `iteration`, `play`;
 * - `step`: `count` (1; below 0: back); `seek`: `iteration`; `state`: the state once all that was ordered before is shown;
 * and gets `{ planarium: "answer", id, value }` or `{ planarium: "answer", id, fault: { message, code, pointer } }`. Once ready,
 * and whenever something was shown, the frame posts `{ planarium: "state", state }` to its parent, ten times a second at most.
 */
import { faultOf } from "../app/fault.js";
import { SCENES } from "./scenes/scenes.js";

/** @import { Page } from "./page.js" */
/** @import { Settings, State } from "../domain/types.js" */

/** Milliseconds between two states that are posted. */
const PAUSE = 100;

/** @typedef {{ planarium: string, id?: unknown, scene?: string, document?: object, algorithm?: string, settings?: Settings, query?: string, iteration?: number, play?: boolean, count?: number }} Order */

/** @param {State | null} state  what a parent wants to know: numbers and words */
function told(state) {
  if (!state) return null;
  const { playing, settled, sentence, clock, lanes } = state;
  return { playing, settled, sentence, iteration: lanes[0].iteration, clock, lanes };
}

/** Obeys the page around this one. @param {Page} page */
export function watchParent(page) {
  /** @param {Order} order @returns {Promise<unknown>} */
  async function obey(order) {
    switch (order.planarium) {
      case "load": {
        const entry = SCENES.find(({ id }) => id === order.scene);
        if (!entry && !order.document) throw Object.assign(new Error(`There is no scene "${String(order.scene)}".`), { code: "unknown-scene", pointer: "/scene" });
        const { algorithm, settings = {}, query, iteration, play } = order;
        const plans = algorithm ? [{ algorithm, settings }] : undefined;
        await page.open(entry ? await page.sourceOf(entry) : { document: order.document ?? {} }, { entry, plans, query, iteration, play });
        return told(await page.arrived());
      }
      case "play": return page.run(({ timeline }) => timeline.play());
      case "pause": return page.run(({ timeline }) => timeline.pause());
      case "step": return page.run(({ timeline }) => timeline.step(whole(order.count ?? 1, "count")));
      case "seek": return page.run(({ timeline }) => timeline.seek(whole(order.iteration, "iteration")));
      case "state": return told(await page.arrived());
      default: throw Object.assign(new Error(`There is no order "${order.planarium}".`), { code: "unknown-order", pointer: "/planarium" });
    }
  }

  addEventListener("message", async ({ source, origin, data }) => {
    if (source !== window.parent || typeof data !== "object" || data === null || typeof data.planarium !== "string") return;
    const target = origin === "null" ? "*" : origin;
    const { id } = /** @type {Order} */ (data);
    try {
      window.parent.postMessage({ planarium: "answer", id, value: (await obey(data)) ?? null }, target);
    } catch (error) {
      window.parent.postMessage({ planarium: "answer", id, fault: faultOf(error) }, target);
    }
  });

  let last = -Infinity;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  page.onState(() => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      last = performance.now();
      window.parent.postMessage({ planarium: "state", state: told(page.state) }, "*");
    }, Math.max(0, last + PAUSE - performance.now()));
  });

  // Escape gives the keys back to whoever shows the frame.
  if (document.documentElement.classList.contains("embed")) {
    addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || event.defaultPrevented) return;
      if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
      window.parent.focus();
      window.parent.postMessage({ planarium: "escape" }, "*");
    });
  }
}

/** @param {unknown} value @param {string} name @returns {number} */
function whole(value, name) {
  if (typeof value === "number" && Number.isSafeInteger(value)) return value;
  throw Object.assign(new Error(`\`${name}\` must be a whole number, not ${JSON.stringify(value)}.`), { code: "wrong-type", pointer: `/${name}` });
}
