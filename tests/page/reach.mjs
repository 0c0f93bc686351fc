/** The pages of the rooms in the browser, for their tests; and what the tests of the arm share. */
import assert from "node:assert/strict";
import { Scenario } from "planarium/full";
import { SCENES } from "../../www/reach/scenes.js";
import { DESK, choose as chooseOne, fill, keys, onPage, reveal } from "./browser.mjs";
import { plane } from "./editing.mjs";
import { EMPTY, openState, reopen } from "./turns.mjs";

/** @import { More, Options, Page } from "./browser.mjs" */

/** @param {string} id */
export const entryOf = (id) => SCENES.find((scene) => scene.id === id) ?? assert.fail(id);

/** The lengths of the links of a scene's arm. @param {string} id */
export const linksOf = (id) => {
  const { robot } = entryOf(id).document;
  return robot.type === "arm" ? robot.links : assert.fail(id);
};

/** @param {string} id */
export const scenarioOf = (id) => Scenario.parse(entryOf(id).document);

/**
 * What tests of every room do.
 * @param {string} name  of its page
 * @param {string} ready  its body at rest
 * @param {string} chosen  the attribute that says which scene is chosen
 * @param {string | null} [first]  the fragment of its state as it opens; null: no address says it
 */
export function roomOf(name, ready, chosen, first = EMPTY) {
  /** Waits until all is computed and drawn. @param {Page} page */
  const rest = async (page) => {
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(resolve)));
    await page.waitForSelector(ready);
  };
  return {
    rest,
    /**
     * Opens the page and waits until it is at rest.
     * @param {(page: Page, url: string) => Promise<void>} test
     * @param {Options} [options]
     * @param {More} [more]
     */
    onRoom: (test, options = DESK, more = {}) =>
      onPage(
        { reducedMotion: "reduce", ...options },
        async (page, url) => {
          await page.waitForSelector(ready);
          await reveal(page, "#more");
          await test(page, url);
        },
        { path: `${name}.html`, ...more },
      ),
    /** @param {Page} page @param {string} selector */
    click: async (page, selector) => {
      await page.click(selector);
      await rest(page);
    },
    /** Presses keys on an element. @param {Page} page @param {string} selector @param {...string} names */
    press: async (page, selector, ...names) => {
      await page.focus(selector);
      await keys(page, ...names);
      await rest(page);
    },
    /** Chooses a scene or a robot. @param {Page} page @param {string} id */
    choose: async (page, id) => {
      await chooseOne(page, "scene", id);
      await page.waitForSelector(`body[data-${chosen}=${id}]`);
      await rest(page);
    },
    /** The page as it opens. @param {Page} page */
    putBack: async (page) => {
      if (first === null) await reopen(page, ready);
      else await openState(page, first);
      await rest(page);
      await reveal(page, "#more");
    },
    /** Puts a number into a field. @param {Page} page @param {string} id @param {string | number} value */
    put: async (page, id, value) => {
      await fill(page, `#${id}`, String(value));
      await rest(page);
    },
  };
}

export const {
  onRoom: onReach,
  rest,
  click,
  press,
  choose,
  put,
  putBack,
} = roomOf("reach", "body[data-state=ready][data-settled=true]", "scene", null);

/** Solves to the end. @param {Page} page */
export async function solved(page) {
  await page.click("#solve-finish");
  await page.waitForSelector("#solve:not([data-status=running])", { state: "attached" });
  await rest(page);
}

/** The pose. @param {Page} page */
export const poseOf = async (page) => ((await page.getAttribute("body", "data-q")) ?? "").split(",").map(Number);

/**
 * Where a point of the world is, in pixels of the window.
 * @param {Page} page
 * @param {string} id  of the scene
 * @param {[number, number]} point
 */
export const windowOf = async (page, id, point) => (await plane(page, scenarioOf(id).extent()))(...point);
