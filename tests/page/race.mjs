/** What tests of races share: planners side by side, and what the package says of each by itself. */
import { withOptions } from "../../www/domain/option-names.js";
import { atRest, fill } from "./browser.mjs";
import { open, sceneOf } from "./library.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("../../www/domain/types.js").Plan} Plan */

/** What the package says of a plan by itself: its rows of history, its result. @param {string} id @param {Plan} plan */
export function alone(id, { algorithm, settings }) {
  const planner = withOptions({ ...settings, algorithm }, (options) => open(sceneOf(id)).planner(options));
  planner.record();
  while (planner.step(1000) === "running");
  const data = planner.historySince(0);
  const width = planner.historyWidth;
  const rows = [
    [0, 0, 0, 0, 0, 0, 0, Infinity],
    ...Array.from({ length: data.length / width }, (_, i) => [...data.slice(i * width, (i + 1) * width)]),
  ];
  return { rows, planner, fingerprint: planner.fingerprint() };
}

/** Adds rivals. @param {Page} page @param {string[]} algorithms */
export async function race(page, ...algorithms) {
  if (!(await page.isVisible("#rival"))) await page.locator("#race-fold > summary").click();
  for (const algorithm of algorithms) {
    await page.selectOption("#rival", algorithm);
    await page.click("#add-rival");
  }
  await atRest(page);
}

/** The table: a row of texts for each planner. @param {Page} page */
export async function table(page) {
  return page.locator("#standings tbody tr").evaluateAll((rows) =>
    rows.map((row) => ({
      fingerprint: /** @type {HTMLElement} */ (row).dataset.fingerprint,
      name: row.children[0].textContent ?? "",
      counts: [...row.children].slice(1, 6).map(({ textContent }) => Number(textContent?.replaceAll(",", ""))),
      found: row.children[6].textContent ?? "",
      cost: row.children[7].textContent ?? "",
      waypoints: row.children[8].textContent ?? "",
      searched: [...row.children]
        .slice(9)
        .map((cell) => (/** @type {HTMLElement} */ (cell).hidden ? "" : (cell.textContent ?? ""))),
    })),
  );
}

/**
 * Opens a rival's settings and gives one.
 * @param {Page} page
 * @param {string} rival
 * @param {string} name
 * @param {string} value
 */
export async function give(page, rival, name, value) {
  const field = page.locator(`#rival-${rival}-${name}`);
  for (let i = 0; i < 2 && !(await field.isVisible()); i++)
    await page
      .locator(`fieldset.rival:has(#rival-${rival}-planner) details:not([open]) > summary:visible`)
      .last()
      .click();
  await fill(page, `#rival-${rival}-${name}`, value);
  await atRest(page);
}

export const A = { algorithm: "prm", settings: { samples: 260, k: 9, seed: 0 } };

export const settings = { seed: 0 };
