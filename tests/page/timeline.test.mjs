/** Any time of a run, shown again: the same to the pixel whichever way one comes to it, and at once. */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  PHONE,
  atRest,
  choosePlanner,
  chooseScene,
  click,
  finish,
  frames,
  growthHash,
  isDeep,
  onPausedPage,
  reveal,
  seek,
  setParameter,
  unfold,
  useBrowser,
} from "./browser.mjs";
import { inTurn, restage } from "./turns.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

/**
 * Runs large enough that copies of layers are taken and used; SST and BIT* remove vertices.
 * @type {[string, string, Record<string, number>][]}
 */
const RUNS = [
  ["locked", "prm", { samples: 700, k: 8 }],
  ["locked", "visibility-prm", { failures: 4000 }],
  ["locked", "rrt", { step: 0.1, max_iterations: 4000 }],
  ["locked", "rrt-connect", { step: 0.08, max_iterations: 4000 }],
  ["witness", "sst", { seed: 2 }],
  ["pillar", "bit-star", { batch_size: 60, improve_iterations: 1500 }],
];

/** Both panes, once words that changed have found their room. @param {Page} page */
async function picture(page) {
  await frames(page);
  await atRest(page);
  return [await growthHash(page, "workspace"), await growthHash(page, "cspace")];
}

/**
 * An iteration of each run, come to in all ways.
 * @param {typeof RUNS} runs
 * @returns {Record<string, (page: Page) => Promise<void>>}
 */
const lookedAt = (runs) =>
  Object.fromEntries(
    runs.map(([scene, algorithm, settings]) => [
      algorithm,
      async (page) => {
        await chooseScene(page, scene);
        await unfold(page, "view");
        await page.locator("#view-refused").evaluate((input) => /** @type {HTMLElement} */ (input).click());
        await choosePlanner(page, algorithm, Object.keys(settings)[0]);
        await reveal(page, "#more-parameters");
        for (const [name, value] of Object.entries(settings)) await setParameter(page, name, String(value));
        await atRest(page);
        // Step by step to an iteration, and on to the end.
        for (let i = 0; i < 7; i++) await page.click("#step-100");
        const { iterations } = await click(page, "#step-10");
        const stepped = await picture(page);
        const end = await finish(page);
        assert.ok(end.iterations > iterations + 500, `${end.iterations} iterations`);
        const ended = await picture(page);
        assert.notDeepEqual(ended, stepped);
        // Back from the end, back to nothing, and forth in one leap.
        await seek(page, iterations);
        assert.deepEqual(await picture(page), stepped, "back from the end");
        await seek(page, 1);
        await seek(page, end.iterations - 3);
        await seek(page, iterations);
        assert.deepEqual(await picture(page), stepped, "there and back");
        await seek(page, 0);
        await seek(page, end.iterations);
        assert.deepEqual(await picture(page), ended, "the end in one leap");
        // A fresh run.
        await page.click("#reset");
        await seek(page, iterations);
        assert.deepEqual(await picture(page), stepped, "a fresh run");
      },
    ]),
  );

test("an iteration looks the same however one comes to it", (t) =>
  // The RRT is looked at on the phone.
  onPausedPage(inTurn(t, lookedAt(isDeep ? RUNS : RUNS.filter(([, algorithm]) => algorithm !== "rrt")), restage)));

test("on a phone it does, too", (t) => onPausedPage(inTurn(t, lookedAt(isDeep ? RUNS : [RUNS[2]]), restage), PHONE));
