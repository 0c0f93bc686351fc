/** A race: planners side by side, given the same work; its table says what the package says. */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  PHONE,
  atRest,
  click,
  finish,
  frames,
  growthHash,
  onPausedPage,
  openScenario,
  pixelsOf,
  seek,
  textMatches,
  useBrowser,
  valueWithin,
} from "./browser.mjs";
import { assertFaultless, assertTargets, overhang } from "./looks.mjs";
import { inTurn, restage } from "./turns.mjs";
import { PAST } from "../../www/planner/run-log/columns.js";
import { alone, race, table, give, A, settings } from "./race.mjs";

/** @typedef {import("playwright-core").Page} Page */

useBrowser();

const time = (/** @type {Page} */ page) => page.inputValue("#time").then(Number);

const four = [
  A,
  { algorithm: "rrt", settings },
  { algorithm: "rrt-connect", settings },
  { algorithm: "prm-star", settings: { samples: 260, seed: 0 } },
];

/**
 * Checks that a race of `four` gets the same on any number of workers, at rest and at the end, and that a run after it
 * does: each planner has made as many iterations as fit into the time that is shown.
 * @param {Page} page
 * @param {number} workers   expected
 * @param {number[]} [times]
 */
async function assertSameOn(page, workers, times = [1234]) {
  const runs = four.map((plan) => alone("stones", plan));
  await race(page, "rrt", "rrt-connect", "prm-star");
  assert.equal(await time(page), 0);
  for (const { counts } of await table(page)) assert.deepEqual(counts.slice(3), [0, 0]);
  assert.equal(page.workers().length, workers);
  for (const wanted of times) {
    await seek(page, wanted);
    assert.equal(await time(page), wanted);
    (await table(page)).forEach(({ counts, name }, i) => {
      const at = runs[i].rows.findLastIndex((row) => row[PAST.clearanceEvaluations] <= wanted);
      assert.deepEqual(
        counts,
        [
          ...[PAST.vertices, PAST.edges, PAST.motionChecks, PAST.clearanceEvaluations].map(
            (column) => runs[i].rows[at][column],
          ),
          at,
        ],
        `${name} at ${wanted}`,
      );
    });
  }
  await finish(page);
  assert.deepEqual(
    (await table(page)).map(({ fingerprint }) => fingerprint),
    runs.map(({ fingerprint }) => fingerprint),
  );
  for (const rival of ["D", "C", "B"]) await click(page, `fieldset.rival:has(#rival-${rival}-planner) button`);
  assert.equal((await finish(page)).fingerprint, runs[0].fingerprint);
}

/** @param {number} count   of processors */
const processors = (count) => ({
  before: async (/** @type {Page} */ page) =>
    void (await page.addInitScript(
      (n) => Object.defineProperty(navigator, "hardwareConcurrency", { value: n }),
      count,
    )),
});

test("on four processors three workers plan a race of four, the same as one would", () =>
  onPausedPage(
    // One more finds the shortest path.
    (page) => assertSameOn(page, 3 + 1, [100, 189, 190, 1234, 3475, 6693, 6694, 700, 12_345]),
    {},
    processors(4),
  ));

test("where no further worker can be loaded the first one plans for all", async () => {
  let loaded = 0;
  await onPausedPage(
    async (page) => {
      await assertSameOn(page, 1);
      assert.ok(loaded > 1, "it was tried");
      assert.equal(await page.isHidden("#notice"), true);
    },
    {},
    {
      expectErrors: true,
      before: async (page) => {
        await processors(8).before(page);
        await page.route(/\/worker\.js$/, (route) => (loaded++ === 0 ? route.continue() : route.abort()));
      },
    },
  );
});

test("what the table of a race says, and its transport", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "a path's vertices, and of roadmaps what the search has visited and its time, are columns; the time tells apart roadmaps that tie":
          async (page) => {
            const runs = ["a-star", "dijkstra", "breadth-first"].map(
              (search) => alone("stones", { ...A, settings: { ...A.settings, search } }).planner,
            );
            await race(page, "prm", "prm");
            await give(page, "B", "search", "dijkstra");
            await give(page, "C", "search", "breadth-first");
            await finish(page);
            const rows = await table(page);
            assert.deepEqual(
              rows.map(({ waypoints }) => waypoints),
              runs.map((run) => String(run.result().path.length)),
            );
            assert.deepEqual(
              rows.map(({ searched: [visited] }) => visited),
              runs.map((run) => String(run.stats().visited)),
            );
            for (const {
              searched: [, seconds],
            } of rows)
              assert.match(seconds, /^(?:below )?[\d.]+ ms$/);
            assert.match(
              await page.innerText("#story"),
              new RegExp(
                `Vertices visited: ${runs.map((run, i) => `${"ABC"[i]} ${run.stats().visited}`).join(", ")}\\.$`,
              ),
            );
            await seek(page, 100);
            assert.deepEqual(
              (await table(page)).map(({ waypoints, searched: [visited] }) => [waypoints, visited]),
              runs.map(() => ["\u2013", "0"]),
            );
            for (const rival of ["C", "B"]) await click(page, `fieldset.rival:has(#rival-${rival}-planner) button`);
            await race(page, "rrt");
            await finish(page);
            assert.deepEqual(
              (await table(page)).map(({ searched }) => searched[1] !== "" && searched[1] !== "\u2013"),
              [true, false],
              "a tree is not searched",
            );
          },

        "a world where no clearance is ever evaluated holds nobody up, and the page says what that means": async (
          page,
        ) => {
          await openScenario(page, {
            format: "planarium-scenario-1",
            name: "empty",
            world: { obstacles: [] },
            robot: { type: "arm", base: [0, 0], links: [1, 0.8] },
            queries: [{ name: "across", start: [0.6, 0.2], goal: [-0.6, -0.2] }],
          });
          await race(page, "rrt");
          await click(page, "#step-1");
          const [a, b] = await table(page);
          assert.deepEqual([a.counts[3], b.counts[3]], [0, 0]);
          assert.ok(a.fingerprint && b.fingerprint && a.counts[4] > 0 && b.counts[4] > 0);
          assert.match(await page.innerText("#story"), /nothing to avoid/);
          await click(page, "#back");
          assert.deepEqual(
            (await table(page)).map(({ counts }) => counts[4]),
            [0, 0],
          );
        },

        "the first and the shortest are named in the table, above the stage and to those who listen; the transport counts clearance evaluations, and going back shows what was there":
          async (page) => {
            await race(page, "rrt-connect");
            await seek(page, 492);
            assert.deepEqual(
              (await table(page)).map(({ found }) => found),
              ["connecting", "492 (first)"],
            );
            await textMatches(page, "#announcer", /^B found a path\.$/);
            await finish(page);
            // The shortest path is computed beside the run.
            await textMatches(page, "#standings", /gap[^]*gap/);
            const [a, b] = await table(page);
            assert.match(a.cost, /^8\.93 rad \(gap \d\.\d %, shortest here\)$/);
            assert.match(b.cost, /^10\.02 rad \(gap \d+ %\)$/);
            assert.equal(
              await page.innerText("#story"),
              "B found a path first, after 492 clearance evaluations; A has the shortest here, 8.93 rad.",
            );
            await textMatches(page, "#announcer", /A has the shortest here, 8\.93 rad\.$/);
            assert.match(
              await page.innerText("#standings"),
              /This is one seed: over many seeds the winner may differ\./,
            );
            await click(page, "#reset");
            await race(page, "rrt");
            assert.deepEqual(await page.locator(".steps button").allInnerTexts(), ["10", "100", "1,000"]);
            for (const [id, name] of [
              ["step-1", "Step 10 clearance evaluations"],
              ["step-100", "Step 1,000 clearance evaluations"],
              ["back", "Back 10 clearance evaluations"],
            ]) {
              assert.equal(await page.getAttribute(`#${id}`, "aria-label"), name);
            }
            assert.match((await page.getAttribute("#timeline", "aria-label")) ?? "", /clearance evaluations/);
            assert.match((await page.getAttribute("#speed", "aria-valuetext")) ?? "", /clearance evaluations a second/);
            assert.equal(
              await page.getByRole("spinbutton", { name: /^Clearance evaluations/ }).getAttribute("id"),
              "time",
            );
            await click(page, "#step-100");
            assert.equal(await time(page), 1000);
            assert.match(await page.innerText("#time-head"), /^of 1,000 evaluations$/);
            // The shortest path is computed beside the run.
            await textMatches(page, "#standings", /gap/);
            const pictures = () => Promise.all(["lane-A", "lane-B", "lane-C"].map((pane) => growthHash(page, pane)));
            const [rows, then] = [await table(page), await pictures()];
            assert.equal(new Set(then).size, 3, "each sheet shows its own planner");
            await click(page, "#step-1");
            assert.equal(await time(page), 1010);
            await click(page, "#back");
            assert.deepEqual([await table(page), await pictures()], [rows, then]);
            await finish(page);
            await page.fill("#timeline", "1000");
            await atRest(page);
            const counts = async () => (await table(page)).map((row) => row.counts);
            assert.deepEqual([await counts(), await pictures()], [rows.map((row) => row.counts), then]);
            await click(page, "#reset");
            assert.deepEqual(
              (await table(page)).map(({ counts }) => counts[4]),
              [0, 0, 0],
            );
          },

        "one switch chooses the picture of all sheets; play grows all of them, pause stops all of them": async (
          page,
        ) => {
          await race(page, "rrt", "prm");
          assert.equal(await page.locator("#stage figure.cspace").count(), 3);
          await page.getByLabel("Workspace", { exact: true }).check();
          assert.equal(await page.locator("#stage figure.workspace").count(), 3);
          // Slow enough that none ends meanwhile.
          await page.fill("#speed", "25");
          await page.click("#play");
          await valueWithin(page, "time", 100);
          await click(page, "#play");
          const at = await time(page);
          const rows = await table(page);
          assert.ok(rows.every(({ counts }) => counts[4] > 0));
          assert.equal(await page.getAttribute("#play", "data-playing"), "false");
          await frames(page);
          assert.equal(await time(page), at);
          assert.deepEqual(await table(page), rows);
          await finish(page);
          for (const lane of ["lane-A", "lane-B"])
            assert.ok(
              (await pixelsOf(page, lane, "vertices", "growth")) + (await pixelsOf(page, lane, "edges", "start")) > 0,
              lane,
            );
          assert.match(
            (await page.getAttribute("#lane-B canvas[role=img]", "aria-label")) ?? "",
            /^Workspace of B RRT.*solved/,
          );
        },

        "two, three or four run as each would alone, bit for bit; then the robots follow their paths": async (page) => {
          const plans = [
            A,
            { algorithm: "rrt-connect", settings },
            { algorithm: "rrt", settings },
            { algorithm: "visibility-prm", settings },
          ];
          const runs = plans.map((plan) => alone("stones", plan));
          for (let count = 2; count <= 4; count++) {
            await race(page, plans[count - 1].algorithm);
            assert.equal(await page.locator("#stage figure").count(), count);
            await finish(page);
            const rows = await table(page);
            assert.deepEqual(
              rows.map(({ fingerprint }) => fingerprint),
              runs.slice(0, count).map(({ fingerprint }) => fingerprint),
            );
            rows.forEach(({ counts, found, cost }, i) => {
              const { rows: history, planner } = runs[i];
              const last = history[history.length - 1];
              assert.deepEqual(counts, [
                ...[PAST.vertices, PAST.edges, PAST.motionChecks, PAST.clearanceEvaluations].map(
                  (column) => last[column],
                ),
                history.length - 1,
              ]);
              const first = history.find((row) => row[PAST.length] < Infinity);
              assert.equal(
                found.split(",").slice(0, 2).join("").match(/^\d+/)?.[0] ?? found,
                first
                  ? String(first[PAST.clearanceEvaluations])
                  : planner.reason === "not-connected"
                    ? "not connected"
                    : "gave up",
              );
              if (first) assert.equal(cost.split(" (")[0], `${planner.result().length.toFixed(2)} rad`);
            });
          }
          assert.equal(await page.isDisabled("#add-rival"), true, "four race at most");
          for (const lane of ["lane-A", "lane-B"]) assert.ok((await pixelsOf(page, lane, "top", "path")) > 150, lane);
          assert.equal(await page.isVisible("#along-row"), true);
        },

        "over 100 seeds a race is an experiment with all its planners": async (page) => {
          await race(page, "rrt");
          for (const button of ["#race-over-seeds", "#over-seeds"]) {
            const [other] = await Promise.all([page.context().waitForEvent("page"), page.click(button)]);
            await other.waitForSelector('body[data-count="200"]');
            assert.equal(await other.isHidden("#notice"), true);
            assert.equal(await other.innerText("#kinds [aria-pressed=true]"), "Distribution");
            await other.close();
          }
        },

        "in a race axe finds nothing, four fit any width, and on a phone their sheets stand in one column": async (
          page,
        ) => {
          await race(page, "rrt");
          await finish(page);
          await page.waitForSelector("svg.cost .end");
          await page.locator(".rival summary").first().click();
          await page.getByText("As a table").click();
          // What holds for one rival holds for all, but takes axe less time.
          await assertFaultless(page, "a race", 120);
          await race(page, "rrt-connect", "prm-star");
          await finish(page);
          for (const width of [320, 768, 1440]) {
            await page.setViewportSize({ width, height: 900 });
            await atRest(page);
            assert.equal(await overhang(page), 0, `${width} px`);
            const sides = await page
              .locator(".sheet:visible")
              .evaluateAll((sheets) => sheets.flatMap(({ clientWidth, clientHeight }) => [clientWidth, clientHeight]));
            assert.ok(sides.length === 8 && Math.min(...sides) >= 120, `${width} px: ${sides}`);
          }
          for (const [viewport, columns] of /** @type {const} */ ([
            [PHONE.viewport, 1],
            [{ width: 1280, height: 860 }, 2],
          ])) {
            await page.setViewportSize(viewport);
            await assertTargets(page);
            assert.equal(
              new Set(
                await page
                  .locator("#stage figure")
                  .evaluateAll((figures) => figures.map((figure) => Math.round(figure.getBoundingClientRect().left))),
              ).size,
              columns,
            );
          }
        },
      },
      restage,
    ),
  ));
