/** What tests of the editor share: opening it, pointer and finger, what it tells and saves. */
import assert from "node:assert/strict";
import { download, keys, openScenario } from "./browser.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("../../www/domain/types.js").ScenarioDocument} ScenarioDocument */

/**
 * Opens the editor on a scenario.
 * @param {Page} page
 * @param {ScenarioDocument | null} document   null: on what is there
 */
export async function openEditor(page, document) {
  if (document) await openScenario(page, document);
  await page.click("#edit");
  await page.waitForSelector("#editor[data-tool=select]", { state: "attached" });
}

/** What the editor tells of itself. @param {Page} page */
export const told = (page) =>
  page.locator("#editor").evaluate((element) => ({ .../** @type {HTMLElement} */ (element).dataset }));

/** Waits until the editor tells a value. @param {Page} page @param {string} name @param {string | number} value */
export async function until(page, name, value) {
  await page.waitForFunction(
    ([key, wanted]) => document.getElementById("editor")?.dataset[key] === wanted,
    [name, String(value)],
  );
}

/**
 * Pixels of the window for points of the workspace, once the stage stands still.
 * @param {Page} page
 * @param {number | { min: number[], max: number[] }} box  that it shows, or half of its side
 * @param {string} [selector]  of another canvas that shows it
 */
export async function plane(page, box, selector = "#workspace canvas[data-layer=top]") {
  const canvas = page.locator(selector);
  await page.waitForSelector("body[data-settled=true]");
  await canvas.evaluate((element) => element.scrollIntoView({ block: "center" }));
  const at = (await canvas.boundingBox()) ?? assert.fail("no canvas");
  const { min, max } = typeof box === "number" ? { min: [-box, -box], max: [box, box] } : box;
  const scale = Math.min((at.width - 28) / (max[0] - min[0]), (at.height - 28) / (max[1] - min[1]));
  return (/** @type {number} */ x, /** @type {number} */ y) =>
    /** @type {[number, number]} */ ([
      at.x + at.width / 2 + scale * (x - (min[0] + max[0]) / 2),
      at.y + at.height / 2 - scale * (y - (min[1] + max[1]) / 2),
    ]);
}

/**
 * Presses keys, and waits until the editor tells a value.
 * @param {Page} page
 * @param {string[]} names
 * @param {string} name
 * @param {string | number} value
 */
export async function press(page, names, name, value) {
  await keys(page, ...names);
  await until(page, name, value);
}

/** Types a value into a field and presses Enter. @param {Page} page @param {string} selector @param {string} value */
export async function enter(page, selector, value) {
  await page.fill(selector, value);
  await page.press(selector, "Enter");
}

/**
 * A drag with the mouse along points in pixels; in the editor, until there is that number of edits.
 * @param {Page} page
 * @param {[number, number][]} points
 * @param {number} [edits]
 * @param {string} [held]  a key that is held down
 */
export async function drag(page, points, edits, held) {
  if (held) await page.keyboard.down(held);
  await page.mouse.move(...points[0]);
  await page.mouse.down();
  for (const point of points.slice(1)) await page.mouse.move(...point, { steps: 4 });
  await page.mouse.up();
  if (held) await page.keyboard.up(held);
  if (edits !== undefined) await until(page, "undo", edits);
}

/**
 * The same with a finger, which rests before it is lifted: else the browser takes the next tap for the end of a fling.
 * @param {Page} page
 * @param {[number, number][]} points
 * @param {number} [edits]
 */
export async function swipe(page, points, edits) {
  const session = await page.context().newCDPSession(page);
  let timestamp = Date.now() / 1000 - 1;
  const send = (/** @type {"touchStart" | "touchMove" | "touchEnd"} */ type, /** @type {[number, number][]} */ at) =>
    session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: at.map(([x, y]) => ({ x, y })),
      timestamp: (timestamp += 0.01),
    });
  await send("touchStart", [points[0]]);
  for (const [i, [x, y]] of points.slice(1).entries()) {
    const [bx, by] = points[i];
    for (let k = 1; k <= 4; k++) await send("touchMove", [[bx + ((x - bx) * k) / 4, by + ((y - by) * k) / 4]]);
  }
  timestamp += 0.5;
  await send("touchEnd", []);
  await session.detach();
  if (edits !== undefined) await until(page, "undo", edits);
}

/**
 * The document as it is saved.
 * @param {Page} page
 * @returns {Promise<{ text: string, document: ScenarioDocument, name: string }>}
 */
export async function saved(page) {
  const { text, name } = await download(page, "#edit-save");
  return { text, document: JSON.parse(text), name };
}

/** @param {number} value @param {number} wanted @param {number} [within] */
export const near = (value, wanted, within = 0.012) =>
  assert.ok(Math.abs(value - wanted) <= within, `${value} is not ${wanted}`);
