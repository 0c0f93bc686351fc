/** The page of the arm in the browser, for its tests. */
import assert from "node:assert/strict";
import { Scenario } from "planarium";
import { documentOf } from "../../www/reach/bench.js";
import { SCENES } from "../../www/reach/scenes.js";
import { onPage } from "./browser.mjs";

/** @import { Options, Page } from "./browser.mjs" */

export const DESK = { viewport: { width: 1280, height: 860 } };
export const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true };

/** @param {string} id */
export const entryOf = (id) => SCENES.find((scene) => scene.id === id) ?? assert.fail(id);

/** @param {string} id */
export const scenarioOf = (id) => Scenario.parse(documentOf(entryOf(id)));

/** The page of the arm, at rest. @param {(page: Page, url: string) => Promise<void>} test @param {Options} [options] @param {{ path?: string, expectErrors?: boolean, before?: (page: Page) => Promise<void> }} [more] */
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
  await page.locator(`input[name=scene][value=${id}]`).check({ force: true });
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

/** Where a point of the world is, in pixels of the window; the view is that of `stage/view.js`. @param {Page} page @param {string} id  of the scene @param {[number, number]} point */
export async function windowOf(page, id, [x, y]) {
  const canvas = page.locator("#workspace canvas[data-layer=top]");
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox() ?? assert.fail("no canvas");
  const { min, max } = scenarioOf(id).extent();
  const scale = Math.min((box.width - 28) / (max[0] - min[0]), (box.height - 28) / (max[1] - min[1]));
  return [box.x + box.width / 2 + scale * (x - (min[0] + max[0]) / 2), box.y + box.height / 2 - scale * (y - (min[1] + max[1]) / 2), scale];
}
