/**
 * The page in a frame: `?embed=1` shows only the stage and its transport, and the parent controls it by messages, which
 * docs/teaching.md lists. Once ready and with each change, the frame posts its state to the parent.
 */
import { errorInfo } from "../app/error-info.js";
import { paced } from "../app/paced.js";
import { SCENES } from "./scenes/scenes.js";

/** @import { Page } from "./page.js" */
/** @import { Settings, State } from "../domain/types.js" */

/** Milliseconds between two states that are posted. */
const PAUSE = 100;

/** @typedef {{ planarium: string, id?: unknown, scene?: string, document?: object, algorithm?: string, settings?: Settings, query?: string, iteration?: number, play?: boolean, count?: number }} Order */

/** @param {State | null} state */
function numbersOf(state) {
  if (!state) return null;
  const { playing, settled, sentence, clock, lanes } = state;
  return { playing, settled, sentence, iteration: lanes[0].iteration, clock, lanes };
}

/** Answers the messages of the parent. @param {Page} page */
export function watchParent(page) {
  /** @param {Order} order @returns {Promise<unknown>} */
  async function execute(order) {
    switch (order.planarium) {
      case "load": {
        const entry = SCENES.find(({ id }) => id === order.scene);
        if (!entry && !order.document) throw Object.assign(new Error(`There is no scene "${String(order.scene)}".`), { code: "unknown-scene", pointer: "/scene" });
        const { algorithm, settings = {}, query, iteration, play } = order;
        const plans = algorithm ? [{ algorithm, settings }] : undefined;
        await page.open(entry ? await page.sourceOf(entry) : { document: order.document ?? {} }, { entry, plans, query, iteration, play });
        return numbersOf(await page.arrived());
      }
      case "play": return page.run(({ timeline }) => timeline.play());
      case "pause": return page.run(({ timeline }) => timeline.pause());
      case "step": return page.run(({ timeline }) => timeline.step(whole(order.count ?? 1, "count")));
      case "seek": return page.run(({ timeline }) => timeline.seek(whole(order.iteration, "iteration")));
      case "state": return numbersOf(await page.arrived());
      default: throw Object.assign(new Error(`There is no order "${order.planarium}".`), { code: "unknown-order", pointer: "/planarium" });
    }
  }

  addEventListener("message", async ({ source, origin, data }) => {
    if (source !== window.parent || typeof data !== "object" || data === null || typeof data.planarium !== "string") return;
    const target = origin === "null" ? "*" : origin;
    const { id } = /** @type {Order} */ (data);
    try {
      window.parent.postMessage({ planarium: "answer", id, value: (await execute(data)) ?? null }, target);
    } catch (error) {
      window.parent.postMessage({ planarium: "answer", id, fault: errorInfo(error) }, target);
      if (errorInfo(error).code === "internal") page.app.fail(error);
    }
  });

  page.onState(paced(PAUSE, () => window.parent.postMessage({ planarium: "state", state: numbersOf(page.state) }, "*")));

  // Escape returns the focus to the parent.
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
