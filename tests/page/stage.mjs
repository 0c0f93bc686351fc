/** What tests of rooms with one stage share: when it is at rest, and what it says of itself. */
/** @typedef {import("playwright-core").Page} Page */

export const CALM = /** @type {import("./browser.mjs").Options} */ ({ reducedMotion: "reduce" });

/** At rest: nothing moves, nothing is computed, all is drawn. @param {string} [stage]  what the stage says then */
export const atRest = (stage = "") => `body[data-state=ready][data-settled=true] #stage${stage}`;

/** Waits until a room is at rest. @param {Page} page @param {string} [stage]  what the stage says then */
export const rest = (page, stage) => page.waitForSelector(atRest(stage));

/** What the stage says of itself. @param {Page} page @returns {Promise<Record<string, string>>} */
export const told = (page) =>
  page
    .locator("#stage")
    .evaluate((element) => /** @type {Record<string, string>} */ ({ .../** @type {HTMLElement} */ (element).dataset }));
