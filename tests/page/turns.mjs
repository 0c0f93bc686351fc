/**
 * Tests that take turns on one page: it is opened once, and what a test left there is put back before the next one,
 * which costs a fraction of opening it anew.
 */
import { encodeState } from "../../www/app/link.js";
import { encodeLink } from "../../www/planner/link/codec.js";
import { SCENES } from "../../www/planner/scenes/scenes.js";
import { tidy } from "./browser.mjs";

/** @import { TestContext } from "node:test" */
/** @import { Page } from "./browser.mjs" */
/** @typedef {(page: Page, url: string) => Promise<unknown>} Act */

/**
 * What a page does in subtests, one after the other.
 * @param {TestContext} t
 * @param {Record<string, Act>} acts  by the names of the subtests
 * @param {(page: Page) => Promise<unknown>} putBack  the state in which every act finds the page
 * @returns {(page: Page, url: string) => Promise<void>}
 */
export const inTurn = (t, acts, putBack) => async (page, url) => {
  const viewport = page.viewportSize();
  await page.evaluate(() => {
    for (const fold of document.querySelectorAll("details")) fold.toggleAttribute("data-opens", fold.open);
  });
  for (const [i, [name, act]] of Object.entries(acts).entries())
    await t.test(name, async () => {
      if (i > 0) {
        await tidy(page);
        if (viewport) await page.setViewportSize(viewport);
        await page.emulateMedia({ media: null, colorScheme: "light", forcedColors: "none" });
        await page.evaluate(() => {
          /** @type {HTMLElement | null} */ (document.activeElement)?.blur();
          scrollTo(0, 0);
          for (const fold of document.querySelectorAll("details")) fold.open = fold.hasAttribute("data-opens");
        });
        await putBack(page);
      }
      await act(page, url);
    });
};

/**
 * Opens a state in an open page by its address, and waits until it is shown.
 * @param {Page} page
 * @param {string} fragment
 */
export async function openState(page, fragment) {
  // The page's own listener comes first, so that the state is being opened when the promise resolves.
  await page.evaluate(
    (hash) =>
      new Promise((resolve) => {
        // The page may have been opened by the same address.
        history.replaceState(null, "", location.pathname + location.search);
        addEventListener("hashchange", resolve, { once: true });
        location.hash = hash;
      }),
    fragment,
  );
  await page.waitForSelector("body[data-state=ready][data-settled=true]:not(:has(#counters:not([data-settled=true])))");
  await page.evaluate(() => history.replaceState(null, "", location.pathname + location.search));
}

/** Opens a page anew: where no address says how it opens. @param {Page} page @param {string} ready  then */
export async function reopen(page, ready) {
  const { origin, pathname } = new URL(page.url());
  await page.goto("about:blank");
  await page.goto(origin + pathname);
  await page.waitForSelector(ready);
}

/** The fragment of a room's state as it opens. */
export const EMPTY = await encodeState({}, () => {});

const [{ id, algorithm, settings }] = SCENES;
const FIRST = await encodeLink({ version: 1, scene: id, lanes: [{ algorithm, settings }], iteration: 0, view: {} });

/** The planner's page as it opens, with its editor closed. @param {Page} page */
export async function restage(page) {
  await page.evaluate(() => {
    /** @type {HTMLElement | null} */ (document.querySelector("#edit[aria-pressed=true]"))?.click();
  });
  await openState(page, FIRST);
}
