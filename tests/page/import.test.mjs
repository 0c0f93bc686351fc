/** What NumPy brings comes in, or is refused in words. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { writeNpy } from "../../www/formats/npy.js";
import {
  atRest,
  chooseScene,
  click,
  finish,
  onPausedPage,
  pickFile,
  pixelsOf,
  unfold,
  useBrowser,
  take,
} from "./browser.mjs";
import { fixture, pickled } from "./npy.mjs";
import { inTurn, restage } from "./turns.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

const SQUARES = [0.1, 0.1, 0.2, 0.1, 0.2, 0.2, 0.1, 0.2, /**/ 1.7, 1.7, 1.9, 1.7, 1.9, 1.9, 1.7, 1.9];

test("what NumPy brings comes in or is refused", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "NumPy polygons are added to the scene, replace its obstacles or are left out; the planner stays": async (
          page,
        ) => {
          await page.selectOption("#planner", "rrt-connect");
          const before = await obstacles(page);
          for (const name of ["numpy1-ragged", "numpy2-ragged"]) {
            await pickFile(page, "ragged.npy", fixture(name));
            await page.waitForSelector("#notice.question");
            assert.match(await page.innerText("#notice"), /3 polygons with 10 vertices/);
            await page.keyboard.press("Escape");
            assert.equal(await page.isVisible("#notice"), false);
          }
          assert.equal(await page.getAttribute("body", "data-scene"), "stones");
          assert.equal(await obstacles(page), before);
          await pickFile(page, "squares.npy", writeNpy(Float64Array.from(SQUARES), [2, 4, 2]));
          await page.waitForSelector("#notice.question");
          assert.match(await page.innerText("#notice"), /squares\.npy holds 2 polygons with 8 vertices/);
          assert.equal(
            await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).dataset.choice),
            "add",
            "the keyboard is at the choices",
          );
          await page.keyboard.press("Enter");
          await page.waitForSelector("body[data-scene=file]");
          assert.equal(await obstacles(page), before + 2);
          assert.equal(await page.inputValue("#planner"), "rrt-connect");
          assert.equal(await page.isVisible("#notice"), false);
          await pickFile(page, "squares.npy", writeNpy(Float64Array.from(SQUARES), [2, 4, 2]));
          await page.click("#notice [data-choice=replace]");
          await page.waitForFunction(() => document.getElementById("notice")?.hidden);
          assert.equal(await obstacles(page), 2);
          assert.equal((await finish(page)).status, "solved");
        },

        "NumPy configurations are marked by shape on both sheets, counted and cleared": async (page) => {
          const blank = await pixelsOf(page, "workspace", "ground", "collision");
          // Straight poses all around: some touch a stone, some do not.
          const rows = Float64Array.from({ length: 400 }, (_, i) =>
            i % 2 ? (Math.floor(i / 20) / 20) * 5 - 2.5 : ((i % 20) / 20) * 6 - 3,
          );
          await pickFile(page, "poses.npy", writeNpy(rows, [200, 2]));
          await page.click("#notice [data-choice=mark]");
          await page.waitForSelector("#marked[data-count='200']");
          await atRest(page);
          const free = Number(await page.getAttribute("#marked", "data-free"));
          assert.ok(free > 0 && free < 200, `${free} are free`);
          assert.match(
            await page.innerText("#marked"),
            new RegExp(`200 configurations of poses.npy: *${free} free, *${200 - free} in collision`),
          );
          assert.equal(blank, 0);
          for (const pane of ["workspace", "cspace"]) {
            assert.ok((await pixelsOf(page, pane, "ground", "collision")) > 50, `${pane}: crosses`);
            assert.ok((await pixelsOf(page, pane, "ground", "ink")) > 50, `${pane}: discs`);
          }
          // More than a polygon may have can only be configurations.
          await pickFile(page, "cloud.npy", writeNpy(new Float64Array(12_000), [6000, 2]));
          await page.waitForSelector("#marked[data-count='6000']");
          await click(page, "#clear-marks");
          assert.equal(await pixelsOf(page, "cspace", "ground", "collision"), 0);
          assert.equal(await page.isVisible("#marked"), false);
          await pickFile(page, "poses.npy", writeNpy(rows.slice(0, 4), [2, 2]));
          await page.waitForSelector("#marked[data-count='2']:not([hidden])");
          await chooseScene(page, "pillar");
          assert.equal(await page.isVisible("#marked"), false);
          assert.equal(await pixelsOf(page, "workspace", "ground", "collision"), 0);
        },

        "whatever is wrong is refused in a sentence with a code, and the stage stays as it was": async (page) => {
          /** @type {[string, Uint8Array, RegExp][]} */
          const files = [
            [
              "hostile.npy",
              pickled("\x80\x02cos\nsystem\n(X\x02\x00\x00\x00lstR."),
              /asks for os\.system, which is refused/,
            ],
            ["cut.npy", fixture("numpy2-ragged").subarray(0, 170), /./],
            ["empty.npy", new Uint8Array(), /not a NumPy array/],
            ["deep.npy", writeNpy(new Float64Array(30), [5, 2, 3]), /Its shape is \(5, 2, 3\)/],
            [
              "nan.npy",
              writeNpy(Float64Array.of(0, 0, 1, NaN, 2, 2), [1, 3, 2]),
              /Vertex 1 of polygon 0 must be two finite numbers/,
            ],
            ["pair.npy", writeNpy(Float64Array.of(0, 0, 1, NaN), [2, 2]), /Number 1 of configuration 1 is not finite/],
            ["many.npy", writeNpy(new Float64Array(5001 * 2 * 3), [5001, 3, 2]), /5000 vertices|list of polygons/],
            ["huge.npy", new Uint8Array(11 * 2 ** 20).fill(0x93), /11\.0 MB; the limit is 10 MB/],
          ];
          for (const [name, bytes, sentence] of files) {
            await pickFile(page, name, bytes);
            await page.waitForFunction(
              (file) => document.querySelector("#notice strong")?.textContent?.startsWith(file),
              name,
            );
            assert.match(await page.innerText("#notice"), sentence, name);
            assert.equal(
              await page.getAttribute("#notice", "data-code"),
              name === "huge.npy" ? "too-large" : "invalid-npy",
              name,
            );
          }
          // The core has the last word: a polygon that crosses itself.
          await pickFile(page, "bow.npy", writeNpy(Float64Array.of(0.1, 0.1, 0.3, 0.3, 0.3, 0.1, 0.1, 0.3), [1, 4, 2]));
          await page.click("#notice [data-choice=add]");
          await page.waitForSelector("#notice[data-code]:not(.question)");
          assert.match((await page.getAttribute("#notice", "data-pointer")) ?? "", /^\/world\/obstacles\/\d+/);
          assert.equal(await page.getAttribute("body", "data-scene"), "stones");
          assert.equal((await finish(page)).status, "solved");
        },
      },
      restage,
    ),
  ));

/** How many obstacles the scene on the stage has: read from what would be taken away. @param {Page} page */
async function obstacles(page) {
  if ((await page.locator("#export-scenario").count()) === 0) await unfold(page, "export");
  return JSON.parse((await take(page, "scenario")).text).world.obstacles.length;
}
