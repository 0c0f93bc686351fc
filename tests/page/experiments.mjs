/** What tests of the page of experiments share. */
import { encodeExperiment } from "../../www/experiments/link.js";
import { download, onPage } from "./browser.mjs";
import { DONE } from "./pages.mjs";

/** @import { Page } from "./browser.mjs" */
/** @import { LinkedDocument } from "../../www/domain/types.js" */
/** @import { View } from "../../www/experiments/link.js" */

/** Two scenes, two planners, a parameter: 48 trials, some without a path. @type {LinkedDocument} */
export const small = {
  format: "planarium-experiment-1",
  title: "Small",
  worlds: [{ scene: "stones" }, { name: "made", generate: "discs", set: { count: 20 }, seeds: [3] }],
  planners: [
    { algorithm: "prm", set: { samples: 40 }, vary: { k: [2, 4] } },
    { algorithm: "rrt-connect", set: { max_iterations: 60 } },
  ],
  seeds: { from: 0, count: 8 },
  verify: true,
};

/**
 * Opens an experiment by its link, which also runs it.
 * @param {{ document: LinkedDocument, view?: View }} experiment
 * @param {(page: Page, url: string) => Promise<void>} act
 * @param {import("./browser.mjs").More} [more]
 */
export async function onExperiment(experiment, act, more = {}) {
  await onPage({}, act, { path: `experiments.html#${await encodeExperiment(experiment)}`, ...more });
}

/** All trials have ended, and their chart is drawn. @param {Page} page */
export const done = (page) => page.waitForSelector(DONE);

/** Saves a file of the page. @param {Page} page @param {string} id */
export async function taken(page, id) {
  await page.locator("#export-fold").evaluate((fold) => {
    /** @type {HTMLDetailsElement} */ (fold).open = true;
  });
  return download(page, `#export-${id}`);
}

/**
 * The table behind a kind of chart.
 * @param {Page} page
 * @param {string} kind
 * @returns {Promise<Record<string, string>[]>}
 */
export async function tableOf(page, kind) {
  await page.locator("#table-fold").evaluate((fold) => {
    /** @type {HTMLDetailsElement} */ (fold).open = true;
  });
  await page.click(`#kinds [data-kind=${kind}]`);
  await page.waitForSelector(`body[data-chart=${kind}][data-settled=true]`);
  return page.locator("#table table").evaluate((table) => {
    const { tHead, tBodies } = /** @type {HTMLTableElement} */ (table);
    const names = Array.from(tHead?.rows[0].cells ?? [], ({ textContent }) => textContent ?? "");
    return Array.from(tBodies[0].rows, ({ cells }) =>
      Object.fromEntries(Array.from(cells, (cell, i) => [names[i], cell.dataset.value ?? ""])),
    );
  });
}
