/** What tests of rooms with one stage share: when it is at rest, and what it says of itself. */
/** @typedef {import("playwright-core").Page} Page */

export const CALM = /** @type {import("./browser.mjs").Options} */ ({ reducedMotion: "reduce" });

/**
 * Waits until nothing moves, nothing is computed and all is drawn.
 * @param {Page} page
 * @param {string} [stage]  what the stage says then
 */
export const rest = (page, stage = "") =>
  page.waitForSelector(`body[data-state=ready][data-settled=true] #stage${stage}`);

/** What the stage says of itself. @param {Page} page @returns {Promise<Record<string, string>>} */
export const told = (page) =>
  page
    .locator("#stage")
    .evaluate((element) => /** @type {Record<string, string>} */ ({ .../** @type {HTMLElement} */ (element).dataset }));
