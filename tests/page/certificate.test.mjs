/** Whether a path exists: the page divides the cells that the package divides, draws them and says what they prove. */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  alphaOf,
  atRest,
  chooseScene,
  click,
  fill,
  onPausedPage,
  openScenario,
  textMatches,
  useBrowser,
} from "./browser.mjs";
import { load } from "./library.mjs";
import { assertFaultless } from "./looks.mjs";
import { inTurn, restage } from "./turns.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

/**
 * What the package divides.
 * @param {import("planarium").Scenario} scenario
 * @param {import("planarium").CertifyOptions} options
 */
function divided(scenario, options) {
  const subdivision = scenario.certify(options);
  while (subdivision.step(1000) === "running");
  return { verdict: subdivision.verdict, cells: subdivision.cellCount.toLocaleString("en-US") };
}

/** Waits for the verdict of the page. @param {Page} page @param {string | null} verdict */
async function decided(page, verdict) {
  await page.waitForSelector(`#certify[data-verdict="${verdict}"]`);
  await atRest(page);
}

/** Pixels of the top layer of a pane on which something is drawn. @param {Page} page @param {string} pane */
const drawn = async (page, pane) => (await alphaOf(page, pane, "top")).alpha.filter((alpha) => alpha > 40).length;

test("cells of a subdivision", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "cells of two joints are divided on their square until it is proven that no path exists; the run is still there":
          async (page) => {
            const scenario = load("locked");
            await chooseScene(page, "locked");
            await atRest(page);
            const before = [await page.innerText("#story"), await drawn(page, "cspace")];
            const { verdict, cells } = divided(scenario, {});
            await click(page, "#certify-ask");
            await decided(page, verdict);
            await textMatches(page, "#story", new RegExp(`${cells} cells\\.$`));
            assert.ok((await drawn(page, "cspace")) > 4 * Number(before[1]));
            await assertFaultless(page, "no path exists");
            await click(page, "#certify-ask");
            await atRest(page);
            assert.deepEqual([await page.innerText("#story"), await drawn(page, "cspace")], before);
          },

        "a disc's cells are in its workspace; the clearance is asked, and robots of other dimensions are not": async (
          page,
        ) => {
          const scenario = load("rings");
          await chooseScene(page, "rings");
          await click(page, "#certify-ask");
          await decided(page, divided(scenario, {}).verdict);
          await textMatches(page, "#story", /^A path exists: /);
          await fill(page, "#certify-clearance", "0.1");
          const { verdict, cells } = divided(scenario, { clearance: 0.1 });
          await decided(page, verdict);
          await textMatches(
            page,
            "#story",
            new RegExp(`^No path with clearance above 0\\.1 m exists: .* ${cells} cells\\.$`),
          );
          await openScenario(page, scenario.document());
          await page.waitForSelector("#certify[data-on=false]");
          await chooseScene(page, "shelf");
          assert.equal(await page.isVisible("#certify-ask"), false);
        },
      },
      restage,
    ),
  ));
