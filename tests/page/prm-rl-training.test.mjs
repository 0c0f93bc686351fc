/** The page of learned edges: it trains as the package does, compares, and takes floors and robots. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Navigation, trainingOptions } from "planarium/full";
import { TrainingPool } from "../../www/prm-rl/pool.js";
import { FIRST, countsOf } from "../../www/prm-rl/session.js";
import { download, dropFile, fill, linkOf, pickFile, pixelsOf, root, textMatches, useBrowser } from "./browser.mjs";
import { EMPTY, inTurn, openState } from "./turns.mjs";
import { ROADMAP, policy, first, onLearned } from "./learned.mjs";
import { CALM, rest, told } from "./stage.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("planarium/full").NavigationDocument} NavigationDocument */

useBrowser();

/** @type {import("planarium/full").PolicyDocument} */
const cargo = JSON.parse(readFileSync(join(root, "www", "prm-rl", "policy-cargo.json"), "utf8"));

/** A training of a few seconds. */
const SHORT = { pairs: 3, tasks: 6, floors: 4, generations: 3, hidden: 4 };

/** The page without a plan, which takes seconds. @param {(page: Page, url: string) => Promise<void>} act */
const onWaiting = (act) => onLearned(act, CALM, `#${EMPTY}`);

/** Trains as the page does. @param {Navigation} task @param {object} options @param {number} [generations] */
function trained(task, options, generations = Infinity) {
  const training = task.training(options);
  training.step(Math.min(generations * training.candidates, 1e9));
  return training;
}

/** Sets the options of a short training. @param {Page} page */
async function prepareTraining(page) {
  await page.click("#part-train");
  await rest(page, "[data-training=ready]");
  for (const [name, value] of Object.entries(SHORT)) {
    if (!(await page.isVisible(`#train-${name}`))) await page.locator("#train-settings summary").click();
    await fill(page, `#train-${name}`, String(value));
    await rest(page, "[data-training=ready]");
  }
}

test("several workers train the same policy as one, also if two of them are lost or join late", async () => {
  Object.defineProperty(globalThis, "navigator", { value: { hardwareConcurrency: 4 }, configurable: true });
  // Each worker has the module, and with it a training, of its own.
  const workers = await Promise.all(
    ["a", "b", "c"].map(async (name) => ({ ...(await import(`../../www/prm-rl/commands.js?${name}`)).commands })),
  );
  const remote = (/** @type {any} */ commands, fails = { command: "", after: 0 }) =>
    /** @type {any} */ (
      new Proxy(
        {},
        {
          get:
            (_, command) =>
            async (/** @type {any[]} */ ...args) => {
              if (command === fails.command && fails.after-- <= 0) throw new Error("lost");
              return commands[command](...args);
            },
        },
      )
    );
  const hired = [remote(workers[1], { command: "returnsOf", after: 3 }), remote(workers[2])];
  const page = remote(workers[0], { command: "advance", after: 2 });
  const pool = new TrainingPool(page, () => hired.shift() ?? assert.fail());
  const { candidates } = await pool.begin(first.toJSON(), SHORT, new AbortController().signal);
  assert.equal(candidates, 6);
  const fingerprints = /** @type {string[]} */ ([]);
  await pool.train(({ generation, fingerprint, history }) => {
    fingerprints.push(fingerprint);
    assert.equal(history.length, 3, "a row for each generation");
    return generation < SHORT.generations;
  });
  assert.equal(pool.workers.length, 1, "the lost ones have gone");
  assert.deepEqual(
    fingerprints,
    [1, 2, 3].map((generations) => trained(first, SHORT, generations).fingerprint),
  );
});

test("a training ends with the policy of the package, is saved, opened, used and linked", async () => {
  let fragment = "";
  const wanted = trained(first, SHORT);
  await onWaiting(async (page) => {
    await prepareTraining(page);
    for (const { name } of trainingOptions()) assert.equal(await page.locator(`#train-${name}`).count(), 1, name);
    await page.click("#train");
    await rest(page, "[data-training=over]");
    assert.equal((await told(page)).trained, wanted.fingerprint);
    assert.ok((await pixelsOf(page, "demonstrations", "top", "goal")) > 50);
    assert.equal(await page.innerText("#fact-mean"), wanted.historySince(2)[0].toFixed(3).replace("-", "\u2212"));
    await page.waitForSelector("#charts .returns .line");
    await page.click("#use-trained");
    await rest(page, "[data-policy=trained]");
    const { name, text } = await download(page, "#save-policy");
    assert.deepEqual(JSON.parse(text), wanted.policy());
    fragment = await linkOf(page);
    await page.click("#ship");
    await rest(page, "[data-policy=shipped]");
    await pickFile(page, name, text);
    await rest(page, "[data-policy=file]");
    assert.equal(await page.innerText("#policy-name"), wanted.policy().name);
  });
  await onLearned(
    async (page) => {
      await rest(page, "[data-training=over]");
      const { trained: again, policy: origin } = await told(page);
      assert.deepEqual([again, origin], [wanted.fingerprint, "trained"]);
    },
    CALM,
    fragment,
  );
});

test("a robot is trained, compared, put on another floor and given cargo", (t) =>
  onWaiting(
    inTurn(
      t,
      {
        "a training is paused and goes on; its drives are chosen, and their rays drawn; at first nothing is called invalid":
          async (page) => {
            const said = await page.locator("#story").evaluateHandle((element) => {
              /** @type {string[]} */
              const all = [];
              new MutationObserver(() => all.push(element.textContent ?? "")).observe(element, {
                childList: true,
                characterData: true,
                subtree: true,
              });
              return all;
            });
            await page.click("#part-train");
            await rest(page, "[data-training=ready]");
            await page.waitForFunction((all) => all.at(-1)?.endsWith("Press Train."), said);
            assert.deepEqual(
              (await said.jsonValue()).filter((text) => text.includes("not valid")),
              [],
            );
            await prepareTraining(page);
            await fill(page, "#train-generations", "100000");
            await rest(page, "[data-training=ready]");
            await page.click("#train");
            await page.waitForFunction(() => Number(document.getElementById("stage")?.dataset.generation) >= 2);
            await page.click("#train");
            await rest(page, "[data-training=ready]");
            const { generation, trained: fingerprint } = await told(page);
            assert.equal(
              fingerprint,
              trained(first, { ...SHORT, generations: 100_000 }, Number(generation)).fingerprint,
            );
            const rays = await pixelsOf(page, "demonstrations", "top", "newest");
            assert.ok(rays > 20);
            await page.locator("#demonstrations canvas[data-layer=top]").click();
            await rest(page);
            assert.notEqual(await pixelsOf(page, "demonstrations", "top", "newest"), rays);
          },

        "the comparison ends with the numbers of the package, drawn and saved": async (page) => {
          const options = { queries: 2, trials: 2, samples: 100, k: 12 };
          await page.click("#part-compare");
          await page.locator("#compare-settings summary").click();
          for (const [name, value] of Object.entries(options)) await fill(page, `#compare-${name}`, String(value));
          await page.click("#compare");
          await rest(page, "[data-compared=over][data-executions='24']");
          const comparison = first.comparison(policy, options);
          comparison.step(1e9);
          for (const { method, reached } of comparison.summary()) {
            const row = page.locator(`#compared tr[data-way=${method}]`);
            assert.equal(await row.getAttribute("data-reached"), String(Math.round(reached.n * (reached.share ?? 0))));
            assert.equal(await row.locator("svg circle").count(), 1);
          }
          await page.click("#export-fold > summary");
          const rows = (await download(page, "#export-comparison")).text.trim().split("\r\n");
          assert.equal(rows.length, 25);
          assert.match(rows[24], /^2,prm-rl,/);
          assert.deepEqual(
            JSON.parse((await download(page, "#export-summary")).text).summary,
            JSON.parse(JSON.stringify(comparison.summary())),
          );
          await fill(page, "#compare-least_distance", "900");
          await page.click("#compare");
          await page.waitForSelector("#compare-least_distance-reason:not([hidden])");
        },

        "a floor from a file is opened and exported; what is wrong is refused by code and pointer, and nothing changes":
          async (page) => {
            const document = Navigation.generate("rooms", { columns: 2, rows: 1, seed: 3 }).toJSON();
            await dropFile(page, "own.json", JSON.stringify({ ...document, title: "My office" }));
            await rest(page, "[data-status=none]");
            assert.match(await page.innerText(".where-now"), /^My office/);
            await page.click("#export-fold > summary");
            const { world } = /** @type {NavigationDocument} */ (
              JSON.parse((await download(page, "#export-task")).text)
            );
            assert.deepEqual(world, JSON.parse(JSON.stringify(document.world)));
            for (const [content, code, pointer] of /** @type {[object, string, string][]} */ ([
              [{ ...document, robot: { ...document.robot, speed: [1, 0] } }, "out-of-range", "/robot/speed"],
              [{ ...policy, weights: policy.weights.slice(1) }, "wrong-dimension", "/weights"],
              [{ ...policy, sensor: { ...policy.sensor, rays: 8 } }, "", ""],
            ])) {
              await pickFile(page, "bad.json", JSON.stringify(content));
              await page.waitForSelector("#notice:not([hidden])");
              if (code) {
                assert.equal(await page.getAttribute("#notice", "data-code"), code);
                assert.match(await page.innerText("#notice"), new RegExp(pointer));
              }
              assert.match(await page.innerText(".where-now"), /^My office/);
              assert.equal((await told(page)).policy, "shipped");
            }
            await pickFile(page, "own.json", JSON.stringify(document));
            await page.waitForSelector("#notice", { state: "hidden" });
            await textMatches(page, "#story", /^PRM-RL plans long routes.*Drag the ring.*press Plan/);
          },

        "a carrier of cargo has a policy of its own; its load is drawn, its swing shown, and it is trained": async (
          page,
        ) => {
          const counts = (/** @type {string} */ way) => page.locator(`#driven tr[data-way=${way}] td`).allInnerTexts();
          const columns = (await counts("prm-rl")).length;
          await page.selectOption("#robot", "cargo");
          await rest(page, "[data-status=none][data-policy=shipped]");
          await textMatches(page, "#policy-about", /for 20 rays/);
          await fill(page, "#drives-trials", "5");
          await fill(page, "#plan-samples", "200");
          await rest(page, "[data-status=solved]");
          await page.click("#drive");
          await rest(page, "[data-drives='5']");
          const yard = Navigation.generate(FIRST.kind, { ...FIRST.options, shape: "cargo" });
          const planner = yard.planner(cargo, { ...ROADMAP, samples: 200 });
          planner.step(1e9);
          const { fingerprint, path } = planner.result();
          assert.equal((await told(page)).fingerprint, fingerprint);
          const drives = Array.from({ length: 5 }, (_, trial) => yard.execute(path.flat(), { trial, policy: cargo }));
          const { reached, collision, swing, timeout } = countsOf(drives);
          assert.deepEqual((await counts("prm-rl")).slice(2, 6), [
            `${reached} of 5`,
            String(collision),
            String(swing),
            String(timeout),
          ]);
          assert.ok(await page.isVisible("#swing-chart svg"));
          const most = Math.max(
            ...Array.from({ length: drives[0].swing.length / 2 }, (_, i) =>
              Math.hypot(...drives[0].swing.slice(2 * i, 2 * i + 2)),
            ),
          );
          assert.match(
            (await page.getAttribute("#swing-chart svg", "aria-label")) ?? "",
            new RegExp(`at most ${most.toFixed(2)} m; the limit is 0\\.30 m`),
          );
          assert.ok((await pixelsOf(page, "floor", "top", "unproven")) > 30, "load, ring and the way of the load");
          await prepareTraining(page);
          await page.click("#train");
          await rest(page, "[data-training=over]");
          assert.equal((await told(page)).trained, trained(yard, SHORT).fingerprint);
          await page.click("#use-trained");
          await page.click("#part-plan");
          await rest(page, "[data-policy=trained]");
          // A policy of another robot is put away.
          await page.selectOption("#robot", "disc");
          await rest(page, "[data-policy=shipped]");
          assert.equal((await counts("prm-rl")).length, columns);
          assert.equal(await page.isVisible("#swing-chart svg"), false);
        },
      },
      (page) => openState(page, EMPTY),
    ),
  ));
