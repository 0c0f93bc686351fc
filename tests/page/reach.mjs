/** The page of the arm in the browser, for its tests. */
import assert from "node:assert/strict";
import { Scenario } from "planarium";
import { documentOf } from "../../www/reach/session.js";
import { SCENES } from "../../www/reach/scenes.js";
import { DESK, choose as chooseOne, onPage } from "./browser.mjs";
import { plane } from "./editing.mjs";

/** @import { Options, Page } from "./browser.mjs" */

/** @param {string} id */
export const entryOf = (id) => SCENES.find((scene) => scene.id === id) ?? assert.fail(id);

/** @param {string} id */
export const scenarioOf = (id) => Scenario.parse(documentOf(entryOf(id)));

/** The page of the arm, at rest. @param {(page: Page, url: string) => Promise<void>} test @param {Options} [options] @param {import("./browser.mjs").More} [more] */
export async function onReach(test, options = DESK, more = {}) {
  await onPage({ reducedMotion: "reduce", ...options }, async (page, url) => {
    await page.waitForSelector("body[data-state=ready][data-settled=true]");
    await test(page, url);
  }, { path: "reach.html", ...more });
}

/** Waits until all is drawn. @param {Page} page */
export async function rest(page) {
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(resolve)));
  await page.waitForSelector("body[data-settled=true]");
}

/** @param {Page} page @param {string} id */
export async function choose(page, id) {
  await chooseOne(page, "scene", id);
  await page.waitForSelector(`body[data-scene=${id}]`);
  await rest(page);
}

/** The pose. @param {Page} page */
export const poseOf = async (page) => ((await page.getAttribute("body", "data-q")) ?? "").split(",").map(Number);

/** Puts a number into a field. @param {Page} page @param {string} id @param {string} value */
export async function put(page, id, value) {
  await page.fill(`#${id}`, value);
  await page.locator(`#${id}`).blur();
  await rest(page);
}

/** Where a point of the world is, in pixels of the window. @param {Page} page @param {string} id  of the scene @param {[number, number]} point */
export const windowOf = async (page, id, point) => (await plane(page, scenarioOf(id).extent()))(...point);
