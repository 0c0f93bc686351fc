/** What tests of the page of several robots share: its states, and what the package plans. */
import assert from "node:assert/strict";
import { encodeState } from "../../www/app/link.js";
import { stateRule } from "../../www/fleet/state.js";
import { Fleet } from "planarium/full";
import { SCENES } from "../../www/fleet/scenes.js";
import { choose, onPage } from "./browser.mjs";
import { CALM, rest, told } from "./stage.mjs";
import { openState } from "./turns.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("./browser.mjs").Options} Options */
/** @typedef {import("planarium/full").FleetOptions} FleetOptions */

/**
 * The page, opened; with reduced motion it has planned.
 * @param {(page: Page, url: string) => Promise<void>} act
 * @param {Options} [options]
 * @param {string} [fragment]
 */
export const onFleet = (act, options = CALM, fragment = "") =>
  onPage(
    options,
    async (page, url) => {
      if (options.reducedMotion === "reduce") await rest(page, ":is([data-status=solved], [data-status=exhausted])");
      await act(page, url);
    },
    { path: `fleet.html${fragment}` },
  );

/**
 * Does something that begins a plan, and waits for its end.
 * @param {Page} page
 * @param {() => Promise<unknown>} act
 * @param {string} [status]
 */
export async function replanned(page, act, status = "solved") {
  const { plans } = await told(page);
  await act();
  await page.waitForSelector(`#stage:not([data-plans='${plans}'])`);
  await rest(page, `[data-status=${status}]`);
  return told(page);
}

/** Chooses a ready fleet. @param {Page} page @param {string} id @param {string} [status] */
export const chooseFleet = (page, id, status) => replanned(page, () => choose(page, "scene", id), status);

/** A ready fleet of the page. @param {string} id */
export function fleetOf(id) {
  const { kind, options } = SCENES.find((entry) => entry.id === id) ?? assert.fail(id);
  return Fleet.generate(kind, options);
}

/** What the package plans. @param {Fleet} fleet @param {FleetOptions} [options] */
export function planned(fleet, options) {
  const planner = fleet.planner(options);
  planner.step(1e9);
  return { result: planner.result(), planner };
}

/** The planner with which the page opens. */
const FIRST = await encodeState({ planner: "pbs" }, stateRule);

/** The first fleet as it opens. @param {Page} page */
export async function putBack(page) {
  await openState(page, FIRST);
  await rest(page, "[data-status=solved]");
}
