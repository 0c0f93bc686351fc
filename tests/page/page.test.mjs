/** The planner's page: it opens, grows and obeys; a run and its settings. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { planners } from "planarium";
import {
  PHONE,
  atRest,
  choosePlanner,
  chooseScene,
  click,
  counters,
  finish,
  frames,
  growthHash,
  isDeep,
  onPage,
  onPausedPage,
  passes,
  pixelsOf,
  setParameter,
  thumbnails,
  useBrowser,
  valueWithin,
} from "./browser.mjs";
import { overhang } from "./looks.mjs";
import { ALIKE, open, ran, textOf } from "./library.mjs";
import { inTurn, restage } from "./turns.mjs";
import { SCENES } from "../../www/planner/scenes/scenes.js";

useBrowser();

test("on a phone the transport is low but can be reached, and the rest is folded away", () =>
  onPausedPage(async (page) => {
    const covered = () => page.locator("#transport").evaluate((bar) => innerHeight - bar.getBoundingClientRect().top);
    assert.ok((await covered()) <= 100, `${await covered()} px`);
    assert.ok(await page.locator("#play").evaluate((button) => button.getBoundingClientRect().bottom <= innerHeight));
    await page.locator("#numbers").scrollIntoViewIfNeeded();
    assert.ok(await page.locator("#reset").evaluate((button) => button.getBoundingClientRect().bottom <= innerHeight));
    assert.equal(await page.getAttribute("#pseudocode details", "open"), null);
    assert.deepEqual([await page.isVisible("#count-checks"), await page.isVisible("#count-vertices")], [false, true]);
    await page.click("#more-counters summary");
    assert.ok(await page.isVisible("#count-checks"));
    assert.equal(await overhang(page), 0);
  }, PHONE));

test("a roadmap grows by itself; then the path draws itself and the robot drives along it until paused", () =>
  onPage({}, async (page) => {
    await page.waitForFunction(() => Number(document.getElementById("counters")?.dataset.vertices) > 4);
    await passes(page, (await counters(page)).iterations);
    await finish(page);
    await valueWithin(page, "along", 0.05);
    for (const pane of ["workspace", "cspace"]) assert.ok((await pixelsOf(page, pane, "top", "path")) > 200, pane);
    await page.click("#play");
    await page.waitForSelector("#play[data-playing=false]");
    await atRest(page);
    const place = await page.inputValue("#along");
    await frames(page);
    assert.equal(await page.inputValue("#along"), place);
  }));

test("a run and its settings", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "play makes iterations until it is paused; step 1, 10 and 100 make exactly as many": async (page) => {
          // Slow enough that it does not end meanwhile.
          await page.fill("#speed", "25");
          await page.click("#play");
          await passes(page, 10);
          let { iterations } = await click(page, "#play");
          for (const count of [1, 10, 100, 10, 1, 100]) {
            iterations += count;
            assert.equal((await click(page, `#step-${count}`)).iterations, iterations);
          }
        },

        "a run is the same whatever its slices, and a slider moves the robot along its path": async (page) => {
          const fast = await finish(page);
          assert.equal(fast.status, "solved");
          assert.ok(fast.length > 0);
          assert.equal((await click(page, "#reset")).iterations, 0);
          for (const count of [1, 100, 10, 100]) await page.click(`#step-${count}`);
          await page.fill("#speed", "90");
          await page.click("#play");
          await page.waitForSelector("#counters[data-status=solved]", { state: "attached" });
          assert.deepEqual(await atRest(page), fast);
          await page.fill("#along", "1");
          const [goal] = JSON.parse(textOf("stones")).queries[0].goal;
          await valueWithin(page, "pose-0-number", goal - 2e-3, goal + 2e-3);
        },

        "the page's run is the package's run, bit for bit, and ends as it should": async (page) => {
          for (const entry of SCENES) {
            const { id, algorithm, settings } = entry;
            if (!isDeep && ALIKE.includes(id)) continue;
            await chooseScene(page, id);
            const shown = await finish(page);
            const scenario = open(entry);
            const { result, iterations, edges } = ran(scenario, algorithm, settings);
            assert.deepEqual(
              [shown.fingerprint, shown.iterations, shown.edges],
              [result.fingerprint, iterations, edges.length],
              id,
            );
            assert.equal(shown.status, id === "locked" ? "exhausted" : "solved", id);
            assert.match(
              await page.innerText("#story"),
              shown.status === "solved" ? /^Path found/ : /^This roadmap has no path: with k = 9 it has /,
            );
            assert.equal(await page.isVisible("#notice"), false);
            assert.equal(await page.isVisible("#cspace"), scenario.robot !== "disc");
            const inked = (await growthHash(page, "workspace")).split(",").map((layer) => Number(layer.split(" ")[2]));
            assert.ok(Math.max(...inked) > 100, `${id}: ${inked}`);
            if (scenario.robot === "arm" || scenario.robot === "disc") continue;
            for (const pane of ["workspace", "cspace"])
              assert.ok((await pixelsOf(page, pane, "top", "path")) > 50, `${id}: ${pane}`);
          }
        },

        "planner, k, samples and seed make another run; the same ones the same run": async (page) => {
          const runs = [await finish(page)];
          for (const [name, value] of [
            ["k", "5"],
            ["samples", "150"],
            ["seed", "77"],
          ]) {
            await setParameter(page, name, value);
            runs.push(await finish(page));
          }
          assert.equal(runs[2].vertices, 152);
          await choosePlanner(page, "rrt-connect", "step");
          runs.push(await finish(page));
          assert.equal(runs[4].status, "solved");
          await setParameter(page, "step", "0.2");
          runs.push(await finish(page));
          assert.equal(new Set(runs.map(({ fingerprint }) => fingerprint)).size, runs.length);
          await page.selectOption("#planner", "prm");
          assert.equal(await page.inputValue("#parameter-samples"), "150", "what was given is kept");
          assert.equal((await finish(page)).fingerprint, runs[3].fingerprint);
        },

        "a new seed is shown, short enough to say aloud, and makes a new run; the largest one is taken": async (
          page,
        ) => {
          const { fingerprint } = await finish(page);
          const seed = () => page.inputValue("#parameter-seed");
          const old = await seed();
          for (let i = 0; i < 4; i++) {
            await page.click("#new-seed");
            assert.match(await seed(), /^\d{1,6}$/);
          }
          assert.notEqual(await seed(), old);
          assert.notEqual((await finish(page)).fingerprint, fingerprint);
          const largest = String(Number.MAX_SAFE_INTEGER);
          await setParameter(page, "seed", largest);
          await finish(page);
          assert.equal(await seed(), largest);
          assert.equal(await page.isHidden("#parameter-seed-reason"), true);
        },

        "a refused value says why beside its field and leaves the run alone": async (page) => {
          const { fingerprint } = await click(page, "#step-10");
          for (const [name, value, reason, right] of [
            ["k", "0", "below 1", "9"],
            ["samples", "2.5", "whole number", "260"],
            ["seed", "-1", "below 0", "0"],
            ["seed", "", "whole number", "0"],
          ]) {
            await setParameter(page, name, value);
            assert.match(await page.innerText(`#parameter-${name}-reason`), new RegExp(reason));
            assert.equal(await page.getAttribute(`#parameter-${name}`, "aria-invalid"), "true");
            assert.equal((await counters(page)).fingerprint, fingerprint);
            await setParameter(page, name, right);
            assert.equal(await page.isHidden(`#parameter-${name}-reason`), true);
            await page.click("#reset");
            assert.equal((await click(page, "#step-10")).fingerprint, fingerprint);
          }
        },

        "every planner has its pseudo-code, a short panel, rarer parameters under headings, and switches": async (
          page,
        ) => {
          assert.equal(await page.getAttribute("#pseudocode details", "open"), "", "open on a desktop");
          const isArms = (/** @type {{ robots: string[] }} */ { robots }) => robots.includes("arm");
          for (const { id, pseudocode, parameters: all } of planners().filter(isArms)) {
            const parameters = all.filter(isArms);
            await page.selectOption("#planner", id);
            // Planners share lines, so all of them are compared.
            const lines = pseudocode.map(({ text }) => text).join("\n");
            await page.waitForFunction(
              (wanted) =>
                Array.from(document.querySelectorAll("#pseudocode li"), (line) => line.textContent).join("\n") ===
                wanted,
              lines,
            );
            const first = await page.locator(":is(#main-parameters, #parameters) .field").count();
            const groups = await page
              .locator("#more-parameters .group")
              .evaluateAll((elements) =>
                elements.map((element) => [
                  element.querySelector("h3")?.textContent ?? "",
                  element.querySelectorAll(".field").length,
                ]),
              );
            assert.ok(first >= 2 && first <= 4, `${id}: ${first}`);
            assert.equal(
              first + groups.reduce((sum, [, count]) => sum + Number(count), 0),
              parameters.length + 1,
              `${id}: the seed and all of its table`,
            );
            assert.deepEqual(
              groups.at(-1),
              ["Limits", 3],
              "nothing is left over but the iterations, the work and how far ends may move",
            );
            assert.ok(groups.length >= 4 && groups.every(([, count]) => Number(count) <= 6), JSON.stringify(groups));
            for (const { name } of parameters.filter(({ kind }) => kind === "boolean")) {
              assert.equal(await page.getAttribute(`#parameter-${name}`, "role"), "switch");
            }
          }
          await page.selectOption("#planner", "prm");
          await setParameter(page, "k", "");
          assert.equal(await page.getAttribute("#parameter-k", "placeholder"), "automatic");
          assert.equal(await page.getAttribute("#parameter-radius", "placeholder"), "none");
          assert.match((await page.locator("#parameter-k-meaning").textContent()) ?? "", /Automatic: 15/);
          assert.equal((await finish(page)).status, "solved");
        },
      },
      restage,
    ),
  ));

test("the page's own script has at most 61.5 KB gzip all together, its style at most 8 KB", async () => {
  /** @type {Record<string, { url: string, body: Promise<Buffer> }[]>} */
  const fetched = { script: [], stylesheet: [] };
  // In the order of their names: that of their arrival makes a difference of 60 bytes.
  const size = async (/** @type {string} */ kind) => {
    const files = fetched[kind].sort((a, b) => (a.url < b.url ? -1 : 1));
    return gzipSync(Buffer.concat(await Promise.all(files.map(({ body }) => body)))).length;
  };
  await onPausedPage(
    async (page) => {
      await thumbnails(page);
      const [script, style] = [await size("script"), await size("stylesheet")];
      assert.ok(script > 5000 && script <= 61.5 * 1024, `script ${script}`);
      assert.ok(style > 500 && style <= 8 * 1024, `style ${style}`);
    },
    {},
    {
      before: async (page) => {
        page.on("response", (response) => {
          const kind = response.request().resourceType();
          if (kind in fetched && !response.url().includes("/planarium/"))
            fetched[kind].push({ url: response.url(), body: response.body() });
        });
      },
    },
  );
});
