/** What holds for every page in every state: for axe, at any width, for fingers, in forced colours. */
import assert from "node:assert/strict";
import { DESK, coloursOf, frames, violations } from "./browser.mjs";

/** @import { Page } from "./browser.mjs" */

/**
 * Colours do not depend on the width, nor names and roles on the colours: two looks hold all of both.
 * @type {["light" | "dark", number][]}
 */
const LOOKS = [
  ["light", 1280],
  ["dark", 320],
];
const WIDTHS = [320, 360, 390, 600, 704, 768, 820, 1024, 1280, 1920, 2560];

/** Waits until the page is at rest. @param {Page} page */
async function settled(page) {
  await frames(page);
  await page.waitForSelector("#counters[data-settled=true], body[data-settled=true]", { state: "attached" });
}

/**
 * Axe finds nothing, and nothing hangs over, in light and dark, on a desktop and on the narrowest phone.
 * @param {Page} page
 * @param {string} state  that the page is in
 */
export async function assertFaultless(page, state) {
  for (const [colorScheme, width] of LOOKS) {
    await page.setViewportSize({ width, height: 860 });
    await page.emulateMedia({ colorScheme });
    await settled(page);
    assert.deepEqual(await violations(page), [], `${state}, ${colorScheme}, ${width} px`);
    assert.equal(await overhang(page), 0, `${state}, ${width} px`);
  }
  await page.emulateMedia({ colorScheme: "light" });
  await page.setViewportSize(DESK.viewport);
  await settled(page);
}

/**
 * Nothing hangs over from 320 to 2560 pixels, and every figure stays large enough.
 * @param {Page} page
 * @param {string} state
 * @param {number} side  of a figure, at least
 */
export async function assertFits(page, state, side) {
  for (const width of WIDTHS) {
    await page.setViewportSize({ width, height: 900 });
    await settled(page);
    assert.equal(await overhang(page), 0, `${state}, ${width} px`);
    const sheets = await page
      .locator(".sheet")
      .evaluateAll((all) =>
        all.filter((sheet) => sheet.checkVisibility()).map((sheet) => sheet.getBoundingClientRect().toJSON()),
      );
    assert.ok(
      sheets.length > 0 && sheets.every((sheet) => sheet.width >= side && sheet.height >= side),
      `${state}, ${width} px: ${JSON.stringify(sheets)}`,
    );
  }
  await page.setViewportSize(DESK.viewport);
  await settled(page);
}

/** Every control is at least 24 pixels high and wide. @param {Page} page */
export async function assertTargets(page) {
  const small = await page.evaluate(() =>
    [...document.querySelectorAll("button, select, .rooms a, input:not([type=file], [name=scene]), summary")]
      .filter((element) => element.checkVisibility() && !element.closest(".visually-hidden, .card"))
      .map((element) => ({
        name: element.id || element.textContent || element.className,
        box: (element.closest("label") ?? element).getBoundingClientRect(),
      }))
      .filter(({ box }) => box.height < 24 || box.width < 24)
      .map(({ name, box }) => `${name} ${box.width}x${box.height}`),
  );
  assert.deepEqual(small, []);
}

/** The stage is drawn in the colours of the system. @param {Page} page  opened with forced colours */
export async function assertForced(page) {
  const [robot, stage, text, ground] = await coloursOf(page, ["var(--robot)", "var(--stage)", "CanvasText", "Canvas"]);
  assert.deepEqual([robot, stage], [text, ground]);
}

/**
 * Every state of a room is without fault, fits and has targets for fingers; then, with forced colours, the page is
 * drawn in them.
 * @param {Page} page
 * @param {Record<string, (page: Page) => Promise<unknown>>} states  how each is entered from the one before it
 */
export async function assertRoom(page, states) {
  for (const [state, enter] of Object.entries(states)) {
    await enter(page);
    await assertFaultless(page, state);
    await assertFits(page, state, 200);
    await assertTargets(page);
  }
  await page.emulateMedia({ forcedColors: "active" });
  await settled(page);
  await assertForced(page);
  assert.deepEqual(await violations(page), []);
}

/** How many pixels hang over. @param {Page} page */
export const overhang = (page) =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
