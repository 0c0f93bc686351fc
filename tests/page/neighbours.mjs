/** What tests of the page of nearest neighbours share: its state, and what the package finds. */
import assert from "node:assert/strict";
import { Scenario } from "planarium";
import { encodeState } from "../../www/app/link.js";
import { ROBOTS } from "../../www/neighbours/robots.js";
import { roomOf } from "./reach.mjs";

/** @import { NeighboursOptions } from "planarium" */
/** @import { Page } from "./browser.mjs" */

export const {
  onRoom: onNeighbours,
  rest,
  click,
  press,
  choose,
  put,
  putBack,
} = roomOf(
  "neighbours",
  "body[data-state=ready][data-settled=true][data-found]",
  "robot",
  await encodeState({ draw: { n: 500, seed: 0, free: true } }, () => {}),
);

/** @param {string} id */
export const robotOf = (id) => ROBOTS.find((entry) => entry.id === id) ?? assert.fail(id);

/** @param {Page} page @param {string} id @param {string} value */
export async function select(page, id, value) {
  await page.selectOption(`#${id}`, value);
  await rest(page);
}

/** What the page says of itself. @param {Page} page */
export const stateOf = async (page) =>
  /** @type {Record<string, string>} */ (await page.evaluate(() => ({ ...document.body.dataset })));

/** @param {string} [text] */
export const numbers = (text = "") => (text === "" ? [] : text.split(",").map(Number));

/**
 * What the package finds for what the page shows.
 * @param {Record<string, string>} state
 * @param {NeighboursOptions} [options]
 * @param {Float64Array | number[][]} [list]
 */
export function foundBy({ robot, n, q, k }, options = { index: "linear" }, list) {
  const scenario = Scenario.parse(robotOf(robot).document);
  const index = scenario.neighbours(options);
  index.add(list ?? scenario.sampleConfigurations(Number(n), { seed: 0, free: true }));
  const found = index.nearest(numbers(q), Number(k));
  index.free();
  scenario.free();
  return found;
}
