/** The page in words: what is looked for, what the planner is at, options of scenes, lessons; and a stage that keeps its size. */
import { withOptions } from "../../www/domain/option-names.js";
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { Scenario, phases, planners } from "planarium";
import { LESSONS, beginningOf, stageAt } from "../../www/planner/lessons/script.js";
import { SCENES } from "../../www/planner/scenes/scenes.js";
import { atRest, chooseScene, finish, growthHash, onPage, onPausedPage, setParameter, start, stop } from "./browser.mjs";
import { open, sceneOf } from "./library.mjs";
import { assertFaultless } from "./looks.mjs";

/** @import { Page } from "playwright-core" */

before(start);
after(stop);

/** The lines that are lit. @param {Page} page */
const lit = (page) => page.locator("#pseudocode li[aria-current=step]").allInnerTexts();

/** What lights lines, of the last of some iterations: told by the package alone. @param {import("planarium").Planner} planner @param {number} iteration */
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

describe("pseudo-code", () => {
  for (const id of ["stones", "trap", "shelf", "museum"]) {
    test(`${id}: lit are the lines that the iteration shown went through`, async () => {
      const entry = sceneOf(id);
      const lines = planners().find((info) => info.id === entry.algorithm)?.pseudocode ?? assert.fail(id);
      await onPausedPage(async (page) => {
        if (id !== "stones") await chooseScene(page, id);
        assert.deepEqual(await page.locator("#pseudocode li").allInnerTexts(), lines.map(({ text }) => text));
        assert.deepEqual(await lit(page), [], "before the first iteration nothing has been done");
        const scenario = open(entry);
        const last = await finish(page);
        for (const iteration of [2, 3, 30, 61, 120, last.iterations]) {
          const planner = withOptions({ ...entry.settings, algorithm: entry.algorithm }, (options) => scenario.planner(options));
          const marks = marksAt(planner, iteration);
          planner.free();
          await page.fill("#time", String(iteration));
          await page.press("#time", "Enter");
          await page.waitForFunction((wanted) => document.getElementById("counters")?.dataset.iterations === String(wanted), iteration);
          await atRest(page);
          const wanted = lines.filter((line) => line.lit_by.some((mark) => marks.has(mark))).map(({ text }) => text);
          assert.ok(wanted.length > 0);
          assert.deepEqual(await lit(page), wanted, `${id} at ${iteration}: ${[...marks].join(" ")}`);
        }
      });
    });
  }

  test("a glyph marks lit lines beside their tint, nobody is told of each, and playing it changes at a pace that can be followed", async () => {
    await onPage({ colorScheme: "dark" }, async (page) => {
      await page.waitForSelector("#pseudocode li[aria-current]");
      const glyph = await page.locator("#pseudocode li[aria-current]").first().evaluate((line) => getComputedStyle(line, "::before").content);
      assert.match(glyph, /\S/);
      assert.notEqual(glyph, "none");
      assert.equal(await page.locator("#pseudocode").evaluate((element) => element.closest("[aria-live], [role=status]")), null);
      await page.locator("#speed").fill("30");
      await page.click("#reset");
      const written = page.evaluate(() => new Promise((/** @type {(times: number[]) => void} */ resolve) => {
        /** @type {number[]} */
        const times = [];
        const watch = new MutationObserver(() => {
          if (times.push(performance.now()) < 5) return;
          watch.disconnect();
          resolve(times);
        });
        watch.observe(/** @type {HTMLElement} */ (document.getElementById("pseudocode")), { attributes: true, subtree: true });
      }));
      await page.click("#play");
      // The first is what was there before; however slow the machine is, what comes between two others can only be longer.
      const times = (await written).slice(1);
      for (let i = 1; i < times.length; i++) assert.ok(times[i] - times[i - 1] > 190, `${times}`);
    });
  });

  test("it is open on a desktop, closed on a phone, and follows the planner that is chosen", async () => {
    await onPausedPage(async (page) => {
      assert.equal(await page.locator("#pseudocode details").getAttribute("open"), "");
      for (const { id, pseudocode } of planners().filter(({ robots }) => robots.includes("arm"))) {
        await page.selectOption("#planner", id);
        // PlannerWorker share lines: all of them are waited for, or the last planner's may still stand there.
        await page.waitForFunction(
          (lines) => JSON.stringify([...document.querySelectorAll("#pseudocode li")].map(({ textContent }) => textContent)) === lines,
          JSON.stringify(pseudocode.map(({ text }) => text)),
        );
      }
    });
    await onPausedPage(async (page) => assert.equal(await page.locator("#pseudocode details").getAttribute("open"), null), { viewport: { width: 390, height: 844 } });
  });
});

describe("options of a scene", () => {
  test("a slider makes the scene anew and keeps the settings of the planner and the speed", async () => {
    await onPausedPage(async (page) => {
      assert.equal(await page.locator(".sliders input").count(), 0, "a scene of a file has none");
      await chooseScene(page, "passage");
      await setParameter(page, "samples", "77");
      await page.fill("#speed", "33");
      const first = await finish(page);
      const slider = page.locator("#option-width");
      assert.equal(await page.locator("label", { has: slider }).locator(".name").innerText(), "Width of the passage");
      assert.equal(await page.locator("#option-width-value").innerText(), "0.2 m");
      await slider.focus();
      await page.keyboard.press("End");
      await page.waitForFunction(() => document.getElementById("counters")?.dataset.iterations === "0");
      assert.equal(await page.locator("#option-width-value").innerText(), "0.5 m");
      assert.equal(await page.evaluate(() => document.activeElement?.id), "option-width", "the focus stays");
      const wide = await finish(page);
      assert.notEqual(wide.fingerprint, first.fingerprint);
      const entry = sceneOf("passage");
      const planner = open(entry, { width: 0.5 }).planner({ ...entry.settings, samples: 77, algorithm: "prm" });
      while (planner.step(1000) === "running");
      assert.equal(wide.fingerprint, planner.fingerprint());
      assert.equal(await page.inputValue("#speed"), "33");
      assert.equal(await page.inputValue("#parameter-samples"), "77");
      assert.equal(await page.getAttribute("body", "data-scene"), "passage");
    });
  });

  test("of many moves at once the last one stays, and words are words", async () => {
    await onPausedPage(async (page) => {
      await chooseScene(page, "maze");
      assert.equal(await page.locator("#option-difficulty-value").innerText(), "medium");
      await page.locator("#option-seed").evaluate((element) => {
        const input = /** @type {HTMLInputElement} */ (element);
        for (let i = 0; i <= 30; i++) {
          input.value = String(i);
          input.dispatchEvent(new Event("input"));
        }
      });
      await page.locator("#option-difficulty").fill("2");
      await page.waitForFunction(() => document.getElementById("option-seed-value")?.textContent === "30");
      await atRest(page);
      assert.equal(await page.locator("#option-difficulty-value").innerText(), "hard");
      const shown = await finish(page);
      const entry = sceneOf("maze");
      const planner = withOptions({ ...entry.settings, algorithm: entry.algorithm }, (options) => open(entry, { seed: 30, difficulty: 2 }).planner(options));
      while (planner.step(1000) === "running");
      assert.equal(shown.fingerprint, planner.fingerprint());
    });
  });

  test("any scene that the core makes can be made; a value out of range is refused beside its field", async () => {
    await onPausedPage(async (page) => {
      await page.click("#scene-options summary");
      await page.waitForSelector("#make-kind");
      const kinds = await page.locator("#make-kind option").evaluateAll((options) => options.map((option) => /** @type {HTMLOptionElement} */ (option).value));
      assert.ok(kinds.length >= 5, kinds.join());
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
      const planner = Scenario.generate("discs", { count: 31, seed: 6 }).planner({ algorithm: "rrt-connect", seed: 0 });
      while (planner.step(1000) === "running");
      assert.equal(shown.fingerprint, planner.fingerprint());
      assert.equal(await page.locator("input[name=scene]:checked").count(), 0);
      await page.fill("#make-links", "5");
      await page.click("#make button");
      await page.waitForSelector("#notice:not([hidden])");
      assert.match(await page.innerText("#notice"), /^This scene cannot be generated\..*links/s);
    });
  });
});

describe("lessons", () => {
  test("each is begun from its title; previous, next and leave do so, and every step has its address", async () => {
    await onPausedPage(async (page, url) => {
      await page.evaluate(() => { /** @type {HTMLDetailsElement} */ (document.getElementById("lessons-fold")).open = true; });
      await page.locator("#lessons button").first().waitFor();
      assert.deepEqual(await page.locator("#lessons button").allInnerTexts(), LESSONS.map(({ title }) => title));
      const lesson = LESSONS[0];
      await page.click("#lessons button >> nth=0");
      for (const [i, step] of lesson.steps.entries()) {
        await page.waitForFunction((question) => document.querySelector("#lesson legend")?.textContent === question, step.question);
        await page.waitForSelector(`#counters[data-settled=true][data-iterations="${beginningOf(lesson, i)}"]`, { state: "attached" });
        assert.equal(await page.locator("#lesson .outcome").isVisible(), false, "the result is not told before the run");
        const wrong = i % 2 === 1;
        await page.check(`#lesson input >> nth=${wrong ? (step.answer + 1) % step.choices.length : step.answer}`);
        await page.click("#lesson-run");
        await page.waitForSelector("#lesson[data-shown=answer]");
        const verdict = wrong ? `Answer: ${step.choices[step.answer].toLowerCase()}.` : "Correct.";
        assert.equal(await page.innerText("#lesson .outcome"), `${verdict} ${step.text}`);
        assert.match(await page.innerText("#lesson .head"), new RegExp(`${i + 1} of ${lesson.steps.length}`));
        assert.equal(page.url(), `${url}#lesson=${lesson.id}.${i + 1}`);
        await page.waitForFunction((ends) => {
          const { settled, status, iterations } = /** @type {HTMLElement} */ (document.getElementById("counters")).dataset;
          return settled === "true" && (ends === undefined ? status !== "running" : iterations === String(ends));
        }, step.iteration);
        const stage = stageAt(lesson, i);
        assert.equal(await page.getAttribute("body", "data-scene"), stage.scene);
        assert.equal(await page.inputValue("#planner"), stage.algorithm);
        for (const [name, value] of Object.entries(stage.settings)) assert.equal(await page.inputValue(`#parameter-${name}`), String(value), name);
        assert.equal(await page.locator("#lesson-previous").isDisabled(), i === 0);
        await page.click("#lesson-next");
      }
      assert.equal(await page.locator("#lesson").isVisible(), false, "after the last step it is over");
      assert.equal(page.url(), url);
    });
  });

  test("a step's address opens it, and going back shows what was there", async () => {
    for (const viewport of [{ width: 1280, height: 860 }, { width: 390, height: 844 }]) {
      await onPausedPage(async (fresh, url) => {
        await fresh.goto("about:blank");
        await fresh.goto(`${url}#lesson=pull.2`);
        const { steps } = LESSONS.find(({ id }) => id === "pull") ?? assert.fail();
        const arrived = () => fresh.waitForSelector(`#counters[data-settled=true][data-iterations="${steps[1].iteration}"]`, { state: "attached" });
        await fresh.locator("#lesson-run").click();
        await arrived();
        await fresh.waitForSelector("#lesson[data-shown=answer]");
        const there = await growthHash(fresh, "workspace");
        assert.ok((await fresh.innerText("#lesson .outcome")).endsWith(steps[1].text), "without a choice, too");
        await fresh.click("#lesson-next");
        await fresh.click("#lesson-run");
        await fresh.waitForSelector("#counters[data-settled=true]:not([data-status=running])", { state: "attached" });
        await fresh.click("#lesson-previous");
        await fresh.waitForSelector("#lesson[data-shown=question]");
        await fresh.click("#lesson-run");
        await fresh.waitForSelector(`#counters[data-settled=true][data-iterations="${steps[1].iteration}"]`, { state: "attached" });
        assert.equal(await growthHash(fresh, "workspace"), there);
        const [band, stage] = await Promise.all(["#lesson", "#stage"].map((name) => fresh.locator(name).boundingBox()));
        assert.ok(band && stage && band.y + band.height <= stage.y, "one above the other");
        assert.equal(await fresh.locator("#story").isVisible(), false, "one voice at a time");
        await fresh.click("#lesson-leave");
        assert.equal(fresh.url(), url);
      }, { viewport });
    }
  });

  test("an address without a lesson is said, and the page opens", async () => {
    await onPausedPage(async (fresh, url) => {
      /** @type {[string, RegExp][]} */
      const wrong = [["#lesson=alchemy.1", /no lesson "alchemy"/], ["#lesson=trees.77", /5 steps; there is no step 77/], ["#lesson=", /There is no lesson/], ["#lesson=<b>x</b>", /There is no lesson/]];
      for (const [fragment, sentence] of wrong) {
        await fresh.goto("about:blank");
        await fresh.goto(url + fragment);
        await fresh.waitForSelector("#notice:not([hidden])");
        assert.match(await fresh.innerText("#notice"), sentence);
        assert.equal(await fresh.getAttribute("body", "data-scene"), "stones");
      }
    });
  });
});

describe("first words", () => {
  test("what is looked for is said first, then what grows, then what came of it", async () => {
    await onPausedPage(async (page) => {
      assert.match(await page.innerText("#story"), /^Looking for a path from start to goal\. Each dot is a collision-free configuration of the arm\.$/);
      assert.match(await page.innerText("#workspace figcaption"), /^Workspace\s+dots mark the arm.s tip$/);
      assert.match(await page.innerText("#cspace figcaption"), /^Configuration space\s+each dot: two joint angles$/);
      while ((await atRest(page)).phase === "sampling") await page.click("#step-100");
      assert.equal((await atRest(page)).phase, "connecting");
      assert.equal(await page.innerText("#story"), SCENES[0].story);
      await finish(page);
      assert.match(await page.innerText("#story"), /^Path found after/);
    });
  });

  test("whatever is said, the stage stays where it is", async () => {
    await onPausedPage(async (page) => {
      const place = () => page.evaluate(() => {
        scrollTo(0, 0);
        const { top, height } = /** @type {HTMLElement} */ (document.getElementById("stage")).getBoundingClientRect();
        return `${top.toFixed(0)} ${height.toFixed(0)}`;
      });
      for (const id of ["stones", "locked", "veil"]) {
        if (id !== "stones") await chooseScene(page, id);
        for (const [width, height] of [[1280, 860], [1024, 768], [390, 844], [820, 1100]]) {
          await page.setViewportSize({ width, height });
          await page.click("#reset");
          await atRest(page);
          const first = await place();
          const sentences = new Set([await page.innerText("#story")]);
          for (const act of ["#step-100", "#finish", "#your-turn"]) {
            await page.click(act);
            await atRest(page);
            sentences.add(await page.innerText("#story"));
            assert.equal(await place(), first, `${id}, ${width} pixels wide: ${await page.innerText("#story")}`);
          }
          assert.ok(sentences.size >= 3);
          await page.click("#your-turn");
        }
      }
    });
  });

  test("axe finds nothing in a lesson, a made scene and a link to be copied by hand", async () => {
    await onPausedPage(async (page) => {
      await page.evaluate(() => {
        for (const details of document.querySelectorAll("details")) details.open = true;
        Object.defineProperty(navigator, "clipboard", { get() { throw new Error("closed"); } });
      });
      await page.click("#lessons button >> nth=1");
      await page.waitForSelector("#lesson:not([hidden])");
      await chooseScene(page, "maze");
      await page.click("#step-10");
      await atRest(page);
      await page.click("#link");
      await page.locator("#link-told input").waitFor();
      await assertFaultless(page, "a lesson and a link");
    });
  });
});
