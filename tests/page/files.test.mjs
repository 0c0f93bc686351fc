/** Scenes and files of the planner's page, and its print. */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  atRest,
  chooseScene,
  click,
  counters,
  dropFile,
  finish,
  onPage,
  onPausedPage,
  pickFile,
  pixelsOf,
  useBrowser,
} from "./browser.mjs";
import { sceneOf, textOf } from "./library.mjs";
import { inTurn, restage } from "./turns.mjs";
import { SCENES } from "../../www/planner/scenes/scenes.js";

useBrowser();

test("scenes and files", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "the gallery counts its scenes in view, shows all of them, and the header names the chosen one": async (
          page,
        ) => {
          const inView = () =>
            page.locator(".card").evaluateAll((cards) => {
              const strip = /** @type {HTMLElement} */ (cards[0].parentElement).getBoundingClientRect();
              return cards.filter((card) => card.getBoundingClientRect().right <= strip.right + 1).length;
            });
          const shown = async () => [
            await inView(),
            await page.innerText(".gallery-size .hint"),
            await page.getAttribute("#all-scenes", "aria-expanded"),
          ];
          const few = await inView();
          assert.ok(few < SCENES.length);
          assert.deepEqual(await shown(), [few, `${few} of ${SCENES.length} scenes`, "false"]);
          await page.click("#all-scenes");
          assert.deepEqual(await shown(), [SCENES.length, `${SCENES.length} scenes`, "true"]);
          await page.click("#all-scenes");
          assert.equal(await inView(), few);
          for (const id of ["stones", "blossom", "museum"]) {
            await chooseScene(page, id);
            assert.ok((await page.innerText("#where")).startsWith(`${sceneOf(id).title} \u00b7 `), id);
          }
        },

        "a bad file is refused with code and place; a good one is planned, dropped or picked": async (page) => {
          const kept = await click(page, "#step-100");
          const good = JSON.parse(textOf("stones"));
          const negative = structuredClone(good);
          negative.robot.links[1] = -0.5;
          for (const [text, code, pointer] of [
            ["{ not json", "invalid-json", ""],
            [JSON.stringify({ ...good, colour: "red" }), "unknown-field", "/colour"],
            [JSON.stringify(negative), "out-of-range", "/robot/links/1"],
          ]) {
            await dropFile(page, "mine.json", text);
            await page.waitForSelector(`#notice[data-code="${code}"]`);
            await atRest(page);
            assert.equal(await page.getAttribute("#notice", "data-pointer"), pointer);
            const words = await page.innerText("#notice");
            assert.ok(words.includes("mine.json") && words.includes(code) && words.includes(pointer), words);
            assert.deepEqual(await counters(page), kept);
            assert.equal(await page.getAttribute("body", "data-scene"), "stones");
          }
          await page.click("#notice button");
          assert.equal(await page.isHidden("#notice"), true);
          assert.equal((await click(page, "#step-1")).iterations, kept.iterations + 1);
          const mine = { ...JSON.parse(textOf("firs")), name: "mine", title: "My own" };
          await dropFile(page, "mine.json", JSON.stringify(mine));
          await page.waitForSelector("body[data-scene=file]");
          await page.selectOption("#planner", "rrt-connect");
          assert.equal((await finish(page)).status, "solved");
          await pickFile(page, "disc.json", textOf("rings"));
          await page.waitForSelector("#cspace", { state: "hidden" });
          await page.waitForFunction(() => document.getElementById("counters")?.dataset.iterations === "0");
          assert.equal((await click(page, "#step-10")).iterations, 10);
        },

        "a start in collision is named, shown in red, and the page stays usable": async (page) => {
          const mine = JSON.parse(textOf("stones"));
          mine.queries[0].start = [0.7, 0];
          await dropFile(page, "mine.json", JSON.stringify(mine));
          await page.waitForSelector("#notice[data-code=start-in-collision]");
          assert.match(await page.innerText("#notice"), /touches obstacle 0/);
          assert.match(await page.innerText("#touching"), /link \d touches obstacle 0/i);
          assert.equal((await atRest(page)).status, "none");
          assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > 100);
          await page.click(".card >> nth=0");
          await page.waitForSelector("body[data-scene=stones]");
          assert.equal(await page.isHidden("#notice"), true);
          assert.equal((await finish(page)).status, "solved");
        },

        "a printed page has scene, settings and iteration, no buttons, and panes side by side": async (page) => {
          const { iterations } = await finish(page);
          await page.waitForSelector("body[data-complete=true]");
          for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
            await page.emulateMedia({ media: "screen", colorScheme });
            assert.equal(await page.isVisible("#printed"), false);
            await page.pdf();
            await page.emulateMedia({ media: "print" });
            await page.setViewportSize({ width: 794, height: 1123 });
            assert.equal(
              await page.innerText("#printed"),
              `Two links among stones \u00b7 PRM, k 9, samples 260, sampler uniform, seed 0 \u00b7 iteration ${iterations}`,
            );
            for (const button of await page.locator("button, input, select").all())
              assert.equal(await button.isVisible(), false);
            const sheets = await page
              .locator(".sheet, .sheet canvas")
              .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().toJSON()));
            const [left, right] = [0, sheets.length / 2].map((first) => sheets.slice(first, first + sheets.length / 2));
            assert.ok(Math.max(...left.map((box) => box.right)) <= Math.min(...right.map((box) => box.left)));
            assert.ok(sheets.every(({ width, height }) => width > 300 && Math.abs(width - height) < 1));
          }
          // The link is made once the page has been at rest for a while.
          await page.waitForSelector("#printed-link svg", { state: "attached" });
          // A link that is too long for a code.
          await pickFile(page, "rings.json", textOf("rings"));
          await page.waitForSelector("body[data-scene=file]");
          await page.waitForFunction(() =>
            /has [2-9],\d{3} characters, too many/.test(document.getElementById("printed-link")?.textContent ?? ""),
          );
          assert.equal(await page.locator("#printed-link svg").count(), 0);
          await page.emulateMedia({ media: "screen" });
        },
      },
      restage,
    ),
  ));

test("a finished run has its code on paper while the robot drives", () =>
  onPage({}, async (page) => {
    await finish(page);
    await page.waitForSelector("#printed-link svg", { state: "attached" });
    assert.equal(await page.getAttribute("body", "data-settled"), "false", "it drives");
  }));
