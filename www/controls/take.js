/** What to take away is fetched when its fold is opened for the first time. */
import { byId } from "./dom.js";

/** @import { Page } from "../page.js" */

/** @param {Page} page */
export function watchTake(page) {
  const fold = byId("take-fold", HTMLDetailsElement);
  fold.addEventListener("toggle", async () => {
    try {
      (await import("../take/take.js")).showTake(page);
    } catch (error) {
      page.notice.show("What to take away could not be loaded.", error);
    }
  }, { once: true });
}
