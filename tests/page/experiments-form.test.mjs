/** Experiments are made, refused, edited and linked. */
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { decodeExperiment, encodeExperiment } from "../../www/experiments/link.js";
import { fill, linkOf, onPage, pickFile, root, useBrowser } from "./browser.mjs";
import { inTurn, reopen } from "./turns.mjs";
import { small, onExperiment, done, taken, tableOf } from "./experiments.mjs";

/** @import { Page } from "./browser.mjs" */
/** @import { View } from "../../www/experiments/link.js" */

useBrowser();

test("a link holds the whole experiment and its chart", async () => {
  /** @type {View} */
  const view = {
    chart: "box",
    measure: "clearance_evaluations",
    axis: "world",
    isLog: true,
    reported: [{ x: "made", value: 100, label: "a report" }],
  };
  await onExperiment({ document: small, view }, async (page) => {
    await done(page);
    await page.locator("details", { hasText: "Parameters" }).last().locator("summary").click();
    await fill(page, "#planner-1-max_iterations", "70");
    await page.waitForSelector("body[data-phase=ready][data-settled=true]");
    assert.equal(await page.getAttribute("body", "data-done"), "0", "a changed experiment begins without rows");
    await fill(page, "#seeds", "4 to 6");
    await page.waitForSelector("body[data-phase=ready][data-count='18']");
    const fragment = await linkOf(page);
    assert.ok(fragment.length < 800, `${fragment.length}`);
    const { state } = await decodeExperiment(fragment);
    assert.deepEqual(state, {
      document: {
        ...small,
        planners: [small.planners[0], { algorithm: "rrt-connect", set: { max_iterations: 70 } }],
        seeds: { from: 4, count: 3 },
      },
      view,
    });
    const file = (await taken(page, "document")).text;
    await onPage(
      {},
      async (other) => {
        await done(other);
        assert.equal(await linkOf(other), fragment);
        assert.equal((await taken(other, "document")).text, file);
        assert.deepEqual(
          [
            await other.getAttribute("body", "data-chart"),
            await other.inputValue("#view-measure"),
            await other.inputValue("#view-axis"),
          ],
          ["box", "clearance_evaluations", "world"],
        );
        assert.equal(await other.locator("#view-log").isChecked(), true);
        assert.ok(
          (await tableOf(other, "box")).some(
            ({ series, median }) => series === "reported: a report" && median === "100",
          ),
        );
      },
      { path: `experiments.html${fragment}` },
    );
  });
});

test("a view of what is not there shows something else", () =>
  onExperiment(
    { document: small, view: { chart: "heat", measure: "nothing", work: "solved", axis: "planner.q" } },
    async (page) => {
      await done(page);
      assert.deepEqual(
        [
          await page.getAttribute("body", "data-chart"),
          await page.inputValue("#view-measure"),
          await page.inputValue("#view-axis"),
        ],
        ["heat", "solved", "planner.k"],
      );
      assert.equal(await page.isHidden("#notice"), true);
    },
  ));

/** The page of experiments as it opens, which waits. */
const READY = "body[data-phase=ready][data-settled=true]";

/** @param {(page: Page, url: string) => Promise<void>} act */
const onForm = (act) =>
  onPage(
    { reducedMotion: "reduce" },
    async (page, url) => {
      await page.waitForSelector(READY);
      await act(page, url);
    },
    { path: "experiments.html" },
  );

/** @param {Page} page */
const putBack = (page) => reopen(page, READY);

test("an experiment is made, refused and edited", (t) =>
  onForm(
    inTurn(
      t,
      {
        "a student compares RRT in three environments, from the page that opens": async (page) => {
          const ready = () => page.waitForSelector("body[data-phase=ready][data-settled=true]");
          await ready();
          for (const scene of ["trap", "maze", "passage"]) {
            await page.selectOption("#new-world", `scene:${scene}`);
            await page.click("#add-world");
            await ready();
          }
          await page.click("#world-0-remove");
          await page.selectOption("#new-planner", "rrt");
          await page.click("#add-planner");
          await page.waitForSelector("#planner-1-remove");
          await page.click("#planner-0-remove");
          await page.waitForSelector("body[data-phase=ready][data-count='300'][data-settled=true]");
          assert.equal(await page.inputValue("#seeds"), "0 to 99");
          assert.equal(await page.inputValue("#title"), "RRT in 3 worlds");
          await page.click("#run");
          await done(page);
          const words = (await page.locator("#words li").allInnerTexts()).join(" ");
          assert.match(
            words,
            /^All have the same share of trials solved|^The share of trials solved is largest for A /,
          );
          assert.match(words, /All 3 worlds have a path\.$/);
          assert.deepEqual(
            (await tableOf(page, "box")).map(({ world, trials }) => [world, trials]),
            [
              ["trap", "100"],
              ["maze", "100"],
              ["passage", "100"],
            ],
          );
          assert.match(
            (await taken(page, "svg")).text,
            /RRT in 3 worlds.*A bug trap.*n =[^<]*(?:<\/text><text[^>]*>)?100 each\./s,
          );
        },

        "every ready experiment is accepted, with its worlds": async (page) => {
          await page.waitForSelector("body[data-phase=ready][data-settled=true]");
          const ids = await page
            .locator("#ready option:enabled")
            .evaluateAll((all) => all.map((option) => /** @type {HTMLOptionElement} */ (option).value));
          const names = readdirSync(join(root, "www", "experiments", "documents")).map((name) =>
            name.replace(".json", ""),
          );
          assert.deepEqual(ids.toSorted(), names.toSorted());
          for (const id of ids) {
            const { title } = JSON.parse(
              readFileSync(join(root, "www", "experiments", "documents", `${id}.json`), "utf8"),
            );
            await page.selectOption("#ready", id);
            await page.waitForFunction(
              (text) => document.getElementById("story")?.textContent?.startsWith(text),
              title,
            );
            await page.waitForSelector("body[data-phase=ready][data-settled=true], body[data-phase=refused]");
            assert.equal(await page.innerText("#notice"), "", id);
            assert.equal(await page.inputValue("#ready"), id);
          }
          await fill(page, "#seeds", "0 to 2");
          assert.equal(await page.inputValue("#ready"), "", "once it is edited it is one of your own");
        },

        "what is refused shows code and pointer before any trial, and the page goes on": async (page) => {
          await page.waitForSelector("body[data-phase=ready]");
          for (const [change, code, pointer] of /** @type {const} */ ([
            [{ planners: [{ algorithm: "prm", vary: { k: [3, 0] } }] }, "out-of-range", "/planners/0/vary/k/1"],
            [{ planners: [{ algorithm: "sst" }] }, "unsupported", "/planners/0/algorithm"],
            [{ worlds: [{ scene: "nowhere" }] }, "unknown-scene", "/worlds/0/scene"],
            [{ planners: [{ algorithm: "prm", vary: { k: [3, 3] } }] }, "out-of-range", "/planners/0/vary/k/1"],
            [{ worlds: 3 }, "wrong-type", "/worlds"],
            [{ worlds: null }, "wrong-type", "/worlds"],
            [{ worlds: [null] }, "wrong-type", "/worlds/0"],
            [{ planners: null }, "wrong-type", "/planners"],
            [{ title: 3 }, "wrong-type", "/title"],
            [null, "wrong-type", ""],
          ])) {
            await pickFile(page, "bad.json", JSON.stringify(change && { ...small, ...change }));
            await page.waitForSelector(`body[data-phase=refused][data-settled=true] #notice[data-code=${code}]`);
            assert.equal(await page.getAttribute("#notice", "data-pointer"), pointer);
            assert.equal(await page.isDisabled("#run"), true);
            assert.equal(await page.innerText("#trials caption"), "No trials");
          }
          // A scenario is a world for the experiment that is open; here it has no planner.
          await pickFile(page, "good.json", JSON.stringify(small));
          await page.waitForSelector("body[data-phase=ready][data-count='48'][data-settled=true]");
          assert.equal(await page.isHidden("#notice"), true);
          await pickFile(page, "own.json", readFileSync(join(root, "www", "scenes", "pillar.json"), "utf8"));
          // One world has 100 seeds.
          await page.waitForSelector("body[data-phase=ready][data-count='300'][data-settled=true]");
          await page.fill("#vary-0-values", "2 to 6 by 2");
          await page.press("#vary-0-values", "Enter");
          await page.waitForSelector("body[data-phase=ready][data-count='400']");
          assert.equal(
            await page.evaluate(() => document.activeElement?.id),
            "vary-0-values",
            "the form is made again, and the focus stays",
          );
          await fill(page, "#vary-0-values", "0");
          await page.waitForSelector("body[data-phase=refused] #notice[data-pointer='/planners/0/vary/k/0']");
        },

        "an edited ready experiment is one of the reader's own; by a link it keeps its name": async (page) => {
          const ready = () => page.waitForSelector("body[data-phase=ready][data-settled=true]");
          await ready();
          const id = await page.inputValue("#ready");
          const link = await linkOf(page);
          await onPage(
            { reducedMotion: "reduce" },
            async (other) => {
              await other.waitForSelector("body[data-phase=ready][data-settled=true]");
              assert.equal(await other.inputValue("#ready"), id);
            },
            { path: `experiments.html${link}` },
          );
          await page.selectOption("#new-planner", "rrt-star");
          await page.click("#add-planner");
          await page.waitForSelector("#planner-1-remove");
          await ready();
          assert.deepEqual(
            [await page.inputValue("#ready"), /^[^:]*/.exec(await page.innerText("#story"))?.[0]],
            ["", "PRM against RRT*"],
          );
          assert.equal((await decodeExperiment(await linkOf(page))).state?.document.title, "PRM against RRT*");

          // Text that is no list of seeds says why, and nothing runs.
          for (const text of ["abc", "5 to 1"]) {
            await page.fill("#seeds", text);
            assert.match(await page.innerText("#seeds-reason"), /^\W*Enter whole numbers/);
            assert.equal(await page.isDisabled("#run"), true, text);
          }
          await fill(page, "#seeds", "3");
          await ready();
          assert.deepEqual([await page.isHidden("#seeds-reason"), await page.isDisabled("#run")], [true, false]);

          // Only planners for the robots of all worlds can be added.
          assert.deepEqual(
            await page
              .locator("#new-planner option:disabled")
              .evaluateAll((all) => all.map((option) => /** @type {HTMLOptionElement} */ (option).value)),
            ["rrt-control", "sst"],
          );
          // Two things vary: the planner, and k of one; without them there is no heat map.
          assert.equal(await page.isDisabled("#kinds [data-kind=heat]"), false);
          await page.click("#planner-0-remove");
          await ready();
          assert.equal(await page.isDisabled("#kinds [data-kind=heat]"), true);
          assert.match((await page.getAttribute("#kinds [data-kind=heat]", "title")) ?? "", /needs two/);
          await pickFile(
            page,
            "car.json",
            JSON.stringify({
              ...small,
              worlds: [{ generate: "clutter", set: { robot: "car" } }],
              planners: [{ algorithm: "sst" }],
            }),
          );
          await page.waitForSelector("#new-planner option[value=sst]:enabled", { state: "attached" });
          await page.selectOption("#new-world", "scene:stones");
          await page.setViewportSize({ width: 390, height: 700 });
          await page.click("#add-world");
          await page.waitForSelector("body[data-phase=refused] #notice[data-code=unsupported]");
          const box = await page.locator("#notice").boundingBox();
          assert.match(
            await page.innerText("#notice"),
            /^The experiment is refused\. SST plans for robots of type car, not arm/,
          );
          assert.ok(box && box.y > -1 && box.y + box.height < 701, `the refusal is in view: ${JSON.stringify(box)}`);
        },
      },
      putBack,
    ),
  ));

/** What the planner's page hands over for "Over 100 seeds". @type {Parameters<typeof encodeExperiment>[0]} */
const handed = {
  document: {
    format: "planarium-experiment-1",
    title: "PRM against RRT-Connect",
    worlds: [{ scene: "stones" }],
    planners: [
      { algorithm: "prm", set: { samples: 60, k: 4 } },
      { algorithm: "rrt-connect", set: { max_iterations: 500 } },
    ],
    seeds: { from: 0, count: 100 },
  },
  view: { chart: "success", measure: "solved" },
  run: true,
};

test("a short link runs by itself if it asks to, and others wait; it can be stopped", async () => {
  const fragment = await encodeExperiment(handed);
  assert.deepEqual((await decodeExperiment(fragment)).state, handed);
  const path = (/** @type {string} */ of) => ({ path: `experiments.html#${of}` });
  // It was asked for: reduced motion does not keep it from running.
  await onPage(
    { reducedMotion: "reduce" },
    async (page) => {
      await done(page);
      assert.equal(await page.getAttribute("body", "data-done"), "200");
      // In one task, since it takes less than a second.
      const phases = await page.evaluate(() =>
        ["run", "discard"].map((id) => {
          document.getElementById(id)?.click();
          return document.body.dataset.phase;
        }),
      );
      assert.deepEqual(phases, ["running", "ready"]);
      await page.waitForSelector("body[data-phase=ready][data-done='0'][data-settled=true]");
    },
    path(fragment),
  );
  const waits = async (/** @type {typeof handed} */ more, /** @type {RegExp} */ why) =>
    onPage(
      {},
      async (page) => {
        await page.waitForSelector("body[data-phase=ready][data-done='0'][data-settled=true] #chart button");
        assert.match(await page.innerText("#chart"), why);
      },
      path(await encodeExperiment(more)),
    );
  await waits({ ...handed, run: false }, /^No trial has run\./);
  const long = { ...handed.document, seeds: { from: 0, count: 201 } };
  await waits({ ...handed, document: long }, /^More than 400 trials of a link do not start by themselves\./);
});
