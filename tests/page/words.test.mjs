/**
 * The page in words: what is looked for, what the planner is at, options of scenes, lessons; and a stage that keeps its
 * size.
 */
import { withOptions } from "../../www/domain/option-names.js";
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario, generators, phases, planners } from "planarium";
import { LESSONS, beginningOf, stageAt } from "../../www/planner/lessons/script.js";
import { SCENES } from "../../www/planner/scenes/scenes.js";
import {
  DESK,
  PHONE,
  addressOf,
  atRest,
  changes,
  chooseScene,
  click,
  finish,
  growthHash,
  offered,
  onPage,
  onPausedPage,
  seek,
  setParameter,
  unfold,
  useBrowser,
} from "./browser.mjs";
import { open, ran, sceneOf } from "./library.mjs";
import { inTurn, openState, restage } from "./turns.mjs";

/** @import { Page } from "playwright-core" */

useBrowser();

/** The lines that are lit. @param {Page} page */
const lit = (page) => page.locator("#pseudocode li[aria-current=step]").allInnerTexts();

/**
 * What lights lines, of the last of some iterations: by the package alone.
 * @param {import("planarium").Planner} planner
 * @param {number} iteration
 */
function marksAt(planner, iteration) {
  planner.record();
  planner.step(iteration);
  const { historyWidth, eventWidth } = planner;
  const rows = planner.historySince(0);
  /** @param {number} column @param {number} row  counted from the end */
  const past = (column, row) => rows[rows.length - row * historyWidth + column];
  /** @type {Set<string>} */
  const marks = new Set([phases[past(3, 2)]]);
  if (past(0, 1) > past(0, 2)) marks.add("vertex");
  if (past(1, 1) > past(1, 2)) marks.add("edge");
  const kinds = ["rejected", "refused", "expanded", "solved", "discarded", "guard"];
  const events = planner.eventsSince(past(2, 2));
  for (let i = 0; i < events.length; i += eventWidth) marks.add(kinds[events[i]]);
  if (planner.status !== "running") marks.add("done");
  return marks;
}

test("lit lines have a glyph, are not announced, change slowly enough to follow", () =>
  onPage(
    { colorScheme: "dark" },
    async (page) => {
      await page.waitForSelector("#pseudocode li[aria-current]");
      const glyph = await page
        .locator("#pseudocode li[aria-current]")
        .first()
        .evaluate((line) => getComputedStyle(line, "::before").content);
      assert.match(glyph, /\S/);
      assert.notEqual(glyph, "none");
      assert.equal(
        await page.locator("#pseudocode").evaluate((element) => element.closest("[aria-live], [role=status]")),
        null,
      );
      await page.fill("#speed", "30");
      await page.click("#reset");
      // The first is what was there before.
      const [, ...times] = await changes(page, "#pseudocode", { attributes: true, subtree: true }, () =>
        page.dispatchEvent("#play", "click"),
      );
      for (let i = 1; i < times.length; i++) assert.ok(times[i] - times[i - 1] >= 200, `${times}`);
    },
    {
      before: async (page) => {
        await page.clock.install();
      },
    },
  ));

test("options of scenes", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "a slider generates the scene again, with the same settings and speed": async (page) => {
          assert.equal(await page.locator(".sliders input").count(), 0, "a scene of a file has none");
          await chooseScene(page, "passage");
          await setParameter(page, "samples", "77");
          await page.fill("#speed", "33");
          const first = await finish(page);
          const slider = page.locator("#option-width");
          assert.equal(
            await page.locator("label", { has: slider }).locator(".name").innerText(),
            "Width of the passage",
          );
          assert.equal(await page.innerText("#option-width-value"), "0.2 m");
          await slider.press("End");
          await page.waitForSelector("#counters[data-iterations='0']", { state: "attached" });
          assert.equal(await page.innerText("#option-width-value"), "0.5 m");
          assert.equal(await page.evaluate(() => document.activeElement?.id), "option-width", "the focus stays");
          const wide = await finish(page);
          assert.notEqual(wide.fingerprint, first.fingerprint);
          const entry = sceneOf("passage");
          assert.equal(
            wide.fingerprint,
            ran(open(entry, { width: 0.5 }), "prm", { ...entry.settings, samples: 77 }).result.fingerprint,
          );
          assert.equal(await page.inputValue("#speed"), "33");
          assert.equal(await page.inputValue("#parameter-samples"), "77");
          assert.equal(await page.getAttribute("body", "data-scene"), "passage");
        },

        "of many moves at once the last one stays, and words are words": async (page) => {
          await chooseScene(page, "maze");
          assert.equal(await page.innerText("#option-difficulty-value"), "medium");
          await page.locator("#option-seed").evaluate((element) => {
            const input = /** @type {HTMLInputElement} */ (element);
            for (let i = 0; i <= 30; i++) {
              input.value = String(i);
              input.dispatchEvent(new Event("input"));
            }
          });
          await page.fill("#option-difficulty", "2");
          await page.waitForFunction(() => document.getElementById("option-seed-value")?.textContent === "30");
          await atRest(page);
          assert.equal(await page.innerText("#option-difficulty-value"), "hard");
          const shown = await finish(page);
          const entry = sceneOf("maze");
          assert.equal(
            shown.fingerprint,
            ran(open(entry, { seed: 30, difficulty: 2 }), entry.algorithm, entry.settings).result.fingerprint,
          );
        },

        "any scene that the core makes can be made; a value out of range is refused beside its field": async (page) => {
          await page.click("#make-fold > summary");
          await page.waitForSelector("#make-kind");
          assert.deepEqual(
            await offered(page, "make-kind"),
            generators().map(({ id }) => id),
          );
          await page.selectOption("#make-kind", "discs");
          await page.fill("#make-count", "-4");
          await page.click("#make button");
          assert.match(await page.innerText("#make-count-reason"), /-4 is below 0/);
          assert.equal(await page.getAttribute("body", "data-scene"), "stones", "nothing was made");
          await page.fill("#make-count", "31");
          await page.fill("#make-seed", "6");
          await page.selectOption("#planner", "rrt-connect");
          await page.click("#make button");
          await page.waitForSelector("body[data-scene=file]");
          const shown = await finish(page);
          assert.equal(
            shown.fingerprint,
            ran(Scenario.generate("discs", { count: 31, seed: 6 }), "rrt-connect", { seed: 0 }).result.fingerprint,
          );
          assert.equal(await page.locator("input[name=scene]:checked").count(), 0);
          await page.fill("#make-links", "5");
          await page.click("#make button");
          await page.waitForSelector("#notice:not([hidden])");
          assert.match(await page.innerText("#notice"), /^This scene cannot be generated\..*links/s);
        },
      },
      restage,
    ),
  ));

test("a lesson begins from its title, goes back and forth, and every step has its address", () =>
  onPausedPage(async (page, url) => {
    await unfold(page, "lessons");
    await page.locator("#lessons button").first().waitFor();
    assert.deepEqual(
      await page.locator("#lessons button").allInnerTexts(),
      LESSONS.map(({ title }) => title),
    );
    const lesson = LESSONS[0];
    await page.click("#lessons button >> nth=0");
    for (const [i, step] of lesson.steps.entries()) {
      await page.waitForFunction(
        (question) => document.querySelector("#lesson legend")?.textContent === question,
        step.question,
      );
      await page.waitForSelector(`#counters[data-settled=true][data-iterations="${beginningOf(lesson, i)}"]`, {
        state: "attached",
      });
      assert.equal(await page.isVisible("#lesson .outcome"), false, "the result is not told before the run");
      const wrong = i % 2 === 1;
      await page.check(`#lesson input >> nth=${wrong ? (step.answer + 1) % step.choices.length : step.answer}`);
      await page.click("#lesson-run");
      await page.waitForSelector("#lesson[data-shown=answer]");
      const verdict = wrong ? `Answer: ${step.choices[step.answer].toLowerCase()}.` : "Correct.";
      assert.equal(await page.innerText("#lesson .outcome"), `${verdict} ${step.text}`);
      assert.match(await page.innerText("#lesson .head"), new RegExp(`${i + 1} of ${lesson.steps.length}`));
      assert.equal(page.url(), addressOf(url, `#lesson=${lesson.id}.${i + 1}`));
      await page.waitForFunction((ends) => {
        const { settled, status, iterations } = /** @type {HTMLElement} */ (document.getElementById("counters"))
          .dataset;
        return settled === "true" && (ends === undefined ? status !== "running" : iterations === String(ends));
      }, step.iteration);
      const stage = stageAt(lesson, i);
      assert.equal(await page.getAttribute("body", "data-scene"), stage.scene);
      assert.equal(await page.inputValue("#planner"), stage.algorithm);
      for (const [name, value] of Object.entries(stage.settings))
        assert.equal(await page.inputValue(`#parameter-${name}`), String(value), name);
      assert.equal(await page.isDisabled("#lesson-previous"), i === 0);
      await page.click("#lesson-next");
    }
    assert.equal(await page.isVisible("#lesson"), false, "after the last step it is over");
    assert.equal(page.url(), addressOf(url));
  }));

for (const [device, options] of /** @type {const} */ ([
  ["a desktop", DESK],
  ["a phone", { viewport: PHONE.viewport }],
])) {
  test(`a step's address opens it on ${device}, and going back shows what was there`, () =>
    onPausedPage(
      async (page, url) => {
        const { steps } = LESSONS.find(({ id }) => id === "pull") ?? assert.fail();
        const run = async () => {
          await page.click("#lesson-run");
          await page.waitForSelector(`#counters[data-settled=true][data-iterations="${steps[1].iteration}"]`, {
            state: "attached",
          });
          await page.waitForSelector("#lesson[data-shown=answer]");
          return growthHash(page, "workspace");
        };
        const there = await run();
        assert.ok((await page.innerText("#lesson .outcome")).endsWith(steps[1].text), "without a choice, too");
        await page.click("#lesson-next");
        await page.click("#lesson-run");
        await page.waitForSelector("#counters[data-settled=true]:not([data-status=running])", { state: "attached" });
        await page.click("#lesson-previous");
        await page.waitForSelector("#lesson[data-shown=question]");
        assert.equal(await run(), there);
        const [band, stage] = await Promise.all(["#lesson", "#stage"].map((name) => page.locator(name).boundingBox()));
        assert.ok(band && stage && band.y + band.height <= stage.y, "one above the other");
        assert.equal(await page.isVisible("#story"), false, "one voice at a time");
        await page.click("#lesson-leave");
        assert.equal(page.url(), addressOf(url));
      },
      options,
      { path: "#lesson=pull.2" },
    ));
}

test("an address without a lesson is said, and the page opens, or stays as it is", () =>
  onPausedPage(
    async (page) => {
      const says = async (/** @type {RegExp} */ sentence) => {
        await page.waitForSelector("#notice:not([hidden])");
        assert.match(await page.innerText("#notice"), sentence);
        assert.equal(await page.getAttribute("body", "data-scene"), "stones");
      };
      await says(/no lesson "alchemy"/);
      for (const [lesson, sentence] of /** @type {[string, RegExp][]} */ ([
        ["trees.77", /5 steps; there is no step 77/],
        ["", /There is no lesson/],
        ["<b>x</b>", /There is no lesson/],
      ])) {
        await page.click("#notice button");
        await openState(page, `lesson=${lesson}`);
        await says(sentence);
      }
    },
    {},
    { path: "#lesson=alchemy.1" },
  ));

test("what is said of a run", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "what is looked for is said first, then what grows, then what came of it": async (page) => {
          assert.match(
            await page.innerText("#story"),
            /^Looking for a path from start to goal\. Each dot is a collision-free configuration of the arm\.$/,
          );
          assert.match(await page.innerText("#workspace figcaption"), /^Workspace\s+dots mark the arm.s tip$/);
          assert.match(
            await page.innerText("#cspace figcaption"),
            /^Configuration space\s+each dot: two joint angles$/,
          );
          while ((await atRest(page)).phase === "sampling") await page.click("#step-100");
          assert.equal((await atRest(page)).phase, "connecting");
          assert.equal(await page.innerText("#story"), SCENES[0].story);
          await finish(page);
          assert.match(await page.innerText("#story"), /^Path found after/);
        },

        "lit are the lines that the iteration shown went through": async (page) => {
          for (const id of ["stones", "trap", "shelf", "museum"]) {
            const entry = sceneOf(id);
            const lines = planners().find((info) => info.id === entry.algorithm)?.pseudocode ?? assert.fail(id);
            if (id !== "stones") await chooseScene(page, id);
            assert.deepEqual(
              await page.locator("#pseudocode li").allInnerTexts(),
              lines.map(({ text }) => text),
              id,
            );
            assert.deepEqual(await lit(page), [], `${id}: before the first iteration nothing has been done`);
            const scenario = open(entry);
            const last = await finish(page);
            for (const iteration of [2, 3, 30, 61, 120, last.iterations]) {
              const planner = withOptions({ ...entry.settings, algorithm: entry.algorithm }, (options) =>
                scenario.planner(options),
              );
              const marks = marksAt(planner, iteration);
              planner.free();
              assert.equal((await seek(page, iteration)).iterations, iteration);
              const wanted = lines
                .filter((line) => line.lit_by.some((mark) => marks.has(mark)))
                .map(({ text }) => text);
              assert.ok(wanted.length > 0);
              assert.deepEqual(await lit(page), wanted, `${id} at ${iteration}: ${[...marks].join(" ")}`);
            }
          }
        },

        "whatever is said, the stage stays where it is": async (page) => {
          const place = () =>
            page.evaluate(() => {
              scrollTo(0, 0);
              const { top, height } = /** @type {HTMLElement} */ (
                document.getElementById("stage")
              ).getBoundingClientRect();
              return `${top.toFixed(0)} ${height.toFixed(0)}`;
            });
          for (const id of ["stones", "locked", "veil"]) {
            if (id !== "stones") await chooseScene(page, id);
            const sizes = [
              [1280, 860],
              [390, 844],
              [1024, 768],
              [820, 1100],
            ];
            for (const [width, height] of sizes.slice(0, id === "stones" ? 4 : 2)) {
              await page.setViewportSize({ width, height });
              await click(page, "#reset");
              const first = await place();
              const sentences = new Set([await page.innerText("#story")]);
              for (const act of ["#step-100", "#finish", "#your-turn"]) {
                await click(page, act);
                sentences.add(await page.innerText("#story"));
                assert.equal(await place(), first, `${id}, ${width} pixels wide: ${await page.innerText("#story")}`);
              }
              assert.ok(sentences.size >= 3);
              await page.click("#your-turn");
            }
          }
        },
      },
      restage,
    ),
  ));
