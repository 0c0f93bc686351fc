/** What tests of the stage share: its switches, its sheets and the line beneath it. */
import assert from "node:assert/strict";
import { View } from "planarium/draw";
import { atRest, fill, frames, unfold } from "./browser.mjs";

/** @import { Page } from "./browser.mjs" */

/** Pixels of a sheet for coordinates of the configuration square, whose range is a whole turn. @param {Page} page */
export async function square(page) {
  const box = (await page.locator("#cspace .sheet").boundingBox()) ?? assert.fail();
  const view = new View(
    { min: [-Math.PI, -Math.PI], max: [Math.PI, Math.PI] },
    box.width,
    box.height,
    { left: 34, right: 12, top: 12, bottom: 32 },
    true,
  );
  return (/** @type {number} */ a, /** @type {number} */ b) => ({ x: view.x(a), y: view.y(b) });
}

/**
 * Sets a switch, a number or a choice of the view.
 * @param {Page} page
 * @param {string} id
 * @param {string | boolean} value
 */
export async function see(page, id, value) {
  await unfold(page, "view");
  if (typeof value === "boolean") await page.setChecked(`#${id}`, value);
  else await fill(page, `#${id}`, value);
  await atRest(page);
  await frames(page);
}
