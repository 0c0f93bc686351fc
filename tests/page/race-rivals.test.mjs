/** The rivals of a race: they come, are set, and go. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { planners } from "planarium";
import {
  atRest,
  chooseScene,
  finish,
  keys,
  offered,
  onPausedPage,
  setParameter,
  useBrowser,
  valueWithin,
} from "./browser.mjs";
import { inTurn, restage } from "./turns.mjs";
import { alone, race, table, give } from "./race.mjs";

useBrowser();

test("rivals come, are set, and go", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "a rival of the same planner is a copy until it is changed; captions say what differs": async (page) => {
          const run = alone("stones", { algorithm: "prm", settings: { samples: 260, k: 4, seed: 0 } });
          await race(page, "prm");
          await finish(page);
          const [a, b] = await table(page);
          assert.equal(a.fingerprint, b.fingerprint);
          assert.deepEqual([a.name, b.name], ["A PRM", "B PRM"]);
          assert.match(a.found, / \(tied for first\)$/);
          assert.match(
            await page.innerText("#story"),
            /^A and B tied: both found a path after [\d,]+ clearance evaluations, of length \d+\.\d\d rad\.$/,
          );
          await give(page, "B", "k", "4");
          await finish(page);
          const rows = await table(page);
          assert.deepEqual(
            rows.map(({ name }) => name),
            ["A PRM, k 9", "B PRM, k 4"],
          );
          assert.equal(rows[1].fingerprint, run.fingerprint);
          assert.deepEqual(await page.locator("#stage figcaption span").allInnerTexts(), ["A PRM, k 9", "B PRM, k 4"]);
          await give(page, "B", "shortcut", "30");
          await finish(page);
          assert.equal((await table(page))[1].name, "B PRM, k 4, shortcut 30");
        },

        "a rival has all parameters of its planner; a refused value says why and leaves that parameter as it was":
          async (page) => {
            await race(page, "rrt");
            const isArms = (/** @type {{ robots: string[] }} */ { robots }) => robots.includes("arm");
            for (const { id, parameters } of planners().filter(isArms)) {
              await page.selectOption("#rival-B-planner", id);
              for (const { name } of parameters.filter(isArms))
                assert.equal(await page.locator(`#rival-B-${name}`).count(), 1, `${id}: ${name}`);
            }
            await page.selectOption("#rival-B-planner", "prm");
            await finish(page);
            const before = await table(page);
            await give(page, "B", "k", "0");
            assert.match(await page.innerText("#rival-B-k-reason"), /below/);
            assert.deepEqual(await table(page), before);
            await setParameter(page, "k", "5");
            await atRest(page);
            assert.deepEqual(
              (await table(page)).map(({ name }) => name),
              ["A PRM, k 5", "B PRM, k 9"],
            );
            assert.equal(await page.inputValue("#rival-B-k"), "0");
            assert.match(await page.innerText("#rival-B-k-reason"), /below/);
            await give(page, "B", "k", "7");
            assert.deepEqual(
              (await table(page)).map(({ name }) => name),
              ["A PRM, k 5", "B PRM, k 7"],
            );
          },

        "they stay when the scene changes; a plan that the core refuses names its planner and its field; they go one by one, and the last one leaves a single run behind":
          async (page) => {
            await race(page, "rrt", "rrt-connect");
            await chooseScene(page, "rings");
            assert.deepEqual(
              (await table(page)).map(({ name }) => name),
              ["A PRM", "B RRT", "C RRT-Connect"],
            );
            assert.equal(await page.locator("#stage figure.workspace").count(), 3);
            assert.equal(await page.locator("input[name=lens]").first().isVisible(), false, "a disc has one picture");
            await give(page, "B", "metric", "naive");
            await page.waitForSelector("#notice:not([hidden])");
            assert.match(
              await page.innerText("#notice"),
              /^B, RRT, cannot be planned\. .*naive.*\. Change its settings or remove B to start the race\./,
            );
            assert.deepEqual(
              (await table(page)).map(({ found }) => found),
              ["not started", "not started", "not started"],
            );
            assert.equal(await page.getAttribute("#notice", "data-pointer"), "/metric");
            assert.match(await page.innerText("#rival-B-metric-reason"), /naive/);
            assert.equal(await page.isHidden("#rival-C-metric-reason"), true);
            await give(page, "B", "metric", "euclidean");
            assert.equal(await page.isHidden("#notice"), true);
            await finish(page);
            assert.ok((await table(page)).every(({ fingerprint }) => fingerprint));
            // Folded, it has three places between its buttons.
            await page.locator("fieldset.rival details[open] > summary").first().click();
            await page.getByRole("button", { name: "Remove B" }).click();
            await atRest(page);
            assert.deepEqual(
              (await table(page)).map(({ name }) => name),
              ["A PRM", "B RRT-Connect"],
            );
            assert.equal(await page.evaluate(() => document.activeElement?.id), "add-rival");
            await keys(page, "Shift+Tab", "Shift+Tab", "Shift+Tab");
            assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("aria-label")), "Remove B");
            await page.keyboard.press("Enter");
            await atRest(page);
            assert.equal(await page.locator("#standings table").count(), 0);
            assert.equal(await page.isVisible("#counters"), true);
            assert.equal(await page.locator("#stage figure").count(), 1);
            assert.deepEqual(await page.locator(".steps button").allInnerTexts(), ["1", "10", "100"]);
            const { fingerprint } = await finish(page);
            assert.equal(
              fingerprint,
              alone("rings", { algorithm: "prm", settings: { samples: 900, k: 9, seed: 14 } }).fingerprint,
            );
          },

        "only planners that serve the robot are offered; others are removed, and the race goes on": async (page) => {
          const idsFor = (/** @type {string} */ robot) =>
            planners().flatMap(({ id, robots }) => (robots.some((one) => one === robot) ? [id] : []));
          await race(page, "rrt");
          assert.deepEqual(await offered(page, "rival"), idsFor("arm"));
          await chooseScene(page, "blossom");
          for (const list of ["rival", "rival-B-planner"]) assert.deepEqual(await offered(page, list), idsFor("car"));
          await page.selectOption("#rival-B-planner", "rrt-control");
          await race(page, "sst", "rrt");
          await chooseScene(page, "rings");
          assert.equal(
            await page.innerText("#notice strong"),
            "Kinodynamic RRT needs a car; this scene has a disc: PRM is used as A. Kinodynamic RRT needs a car, so rival B was removed. SST needs a car, so rival C was removed.",
          );
          assert.deepEqual(
            (await table(page)).map(({ name, found }) => [name, found]),
            [
              ["A PRM", "sampling"],
              ["B RRT", "growing"],
            ],
          );
          for (const list of ["rival", "rival-B-planner"]) assert.deepEqual(await offered(page, list), idsFor("disc"));
          await page.click("#play");
          await valueWithin(page, "time", 0);
          await finish(page);
          assert.ok((await table(page)).every(({ fingerprint }) => fingerprint));
        },

        "a rival has the presets of its planner; by hand it is the reader's own again": async (page) => {
          const preset = planners().find(({ id }) => id === "prm")?.presets[0];
          assert.ok(preset);
          await race(page, "prm");
          await page.locator("fieldset.rival details > summary").first().click();
          assert.equal(await page.inputValue("#rival-B-preset"), "own");
          await page.selectOption("#rival-B-preset", preset.id);
          await atRest(page);
          for (const [name, value] of Object.entries(preset.settings))
            assert.equal(await page.inputValue(`#rival-B-${name}`), String(value), name);
          await finish(page);
          assert.equal(
            (await table(page))[1].fingerprint,
            alone("stones", { algorithm: "prm", settings: { seed: 0, ...preset.settings } }).fingerprint,
          );
          await give(page, "B", "k", "6");
          assert.equal(await page.inputValue("#rival-B-preset"), "own");
          await page.selectOption("#rival-B-planner", "rrt-connect");
          assert.equal(await page.isVisible("#rival-B-preset"), false);
        },
      },
      restage,
    ),
  ));
