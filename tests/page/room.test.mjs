/** How much room there is, on the planner's page. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario } from "planarium/full";
import {
  PHONE,
  atRest,
  chooseScene,
  fill,
  finish,
  linkOf,
  onPausedPage,
  openScenario,
  pixelsOf,
  textMatches,
  unfold,
  useBrowser,
} from "./browser.mjs";
import { assertFaultless } from "./looks.mjs";
import { inTurn, openState, restage } from "./turns.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

/** A wall with a narrow door straight ahead and a wide one aside. */
const DOORS = {
  format: "planarium-scenario-1",
  name: "doors",
  world: {
    bounds: { min: [0, 0], max: [10, 10] },
    obstacles: [
      {
        type: "wall",
        points: [
          [5, 0],
          [5, 4.5],
        ],
        width: 0.2,
      },
      {
        type: "wall",
        points: [
          [5, 5.5],
          [5, 7],
        ],
        width: 0.2,
      },
      {
        type: "wall",
        points: [
          [5, 9],
          [5, 10],
        ],
        width: 0.2,
      },
    ],
  },
  robot: { type: "disc", radius: 0.3 },
  queries: [
    { name: "across", start: [1, 5], goal: [9, 5] },
    { name: "aside", start: [1, 5], goal: [1, 0.5] },
  ],
};

/** What the page knows. @param {Page} page */
const known = (page) =>
  page.locator("#room").evaluate((/** @type {HTMLElement} */ { dataset }) => ({
    radius: Number(dataset.radius),
    length: Number(dataset.length),
    nodes: Number(dataset.nodes),
    clearance: Number(dataset.clearance),
  }));

/** Turns switches, and waits for what they show. @param {Page} page @param {string[]} names */
async function turn(page, ...names) {
  for (const name of names) await page.click(`#room-${name}`);
  await page.waitForSelector("#room[data-state=ready]");
  await atRest(page);
}

/** @param {Page} page @param {string} name */
const isInLegend = (page, name) => page.isVisible(`#legend-${name}`);

test("how much room there is", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "the widest disc and the safest path are those of the package, drawn, and go with the query": async (page) => {
          await openScenario(page, DOORS);
          await unfold(page, "room");
          const scenario = Scenario.parse(JSON.stringify(DOORS));
          const before = await pixelsOf(page, "workspace", "top", "goal");
          await turn(page, "widest");
          await page.waitForSelector("#room[data-radius]");
          assert.equal((await known(page)).radius, scenario.widest().radius);
          await textMatches(
            page,
            "#room-widest-text",
            /up to 0\.900 m radius.*1\.800 m wide, between obstacle 1 and obstacle 2.*has 0\.300 m: there is room/,
          );
          const withDisc = await pixelsOf(page, "workspace", "top", "goal");
          assert.ok(withDisc > before, "the disc is drawn");
          await turn(page, "safest");
          await page.waitForSelector("#room[data-length]");
          assert.equal((await known(page)).length, scenario.safest().length);
          assert.ok((await pixelsOf(page, "workspace", "top", "goal")) > withDisc, "the path is drawn");
          await turn(page, "optimum");
          await textMatches(page, "#room-safest-text", /longer than the shortest/);
          for (const name of ["widest", "safest", "optimum"]) assert.ok(await isInLegend(page, name), name);
          await fill(page, "#query", "aside");
          await textMatches(page, "#room-widest-text", /does not fit at the goal, beside the bounds/);
          assert.equal((await known(page)).radius, scenario.widest("aside").radius);
          await turn(page, "widest", "safest", "optimum");
          assert.ok(!(await isInLegend(page, "widest")) && !(await isInLegend(page, "safest")));
          assert.equal(await page.getAttribute("#room", "data-radius"), null);
          scenario.free();
        },

        "the route graph has the detour that is asked, and a link stores all of it": async (page) => {
          await chooseScene(page, "rings");
          await unfold(page, "room");
          await turn(page, "routes");
          await page.waitForSelector("#room[data-nodes]");
          const document = await page.evaluate(async () => (await fetch("scenes/rings.json")).json());
          const scenario = Scenario.parse(document);
          assert.equal((await known(page)).nodes, scenario.routeGraph().nodes.length);
          assert.ok((await pixelsOf(page, "workspace", "top", "start")) > 500, "it is drawn");
          await fill(page, "#room-detour-number", "1.1");
          await page.waitForSelector("#room[data-state=ready]");
          const { nodes, edges } = scenario.routeGraph({ detour: 1.1 });
          await textMatches(page, "#room-routes-text", new RegExp(`^${nodes.length} nodes and ${edges.length} edges`));
          const link = await linkOf(page);
          await restage(page);
          await textMatches(page, "#room-routes-text", /Route graphs are for/);
          assert.ok(!(await isInLegend(page, "routes")) && (await page.isDisabled("#room-routes")));
          await openState(page, link);
          await page.waitForSelector(`#room[data-nodes="${nodes.length}"]`);
          assert.equal(await page.inputValue("#room-detour-number"), "1.100");
          assert.ok(await page.isChecked("#room-routes"));
          scenario.free();
        },

        "the chart has the smallest clearance of the path, and a press on it moves the robot there": async (page) => {
          await openScenario(page, DOORS);
          await unfold(page, "room");
          await textMatches(page, "#room-along", /no path yet/);
          await finish(page);
          await page.waitForSelector("#room[data-clearance]");
          const { clearance } = await known(page);
          // The planner may take either door.
          assert.ok(clearance > 0 && clearance <= 0.6 + 1e-9, String(clearance));
          await textMatches(page, "#room-along", new RegExp(`^Smallest clearance: ${clearance.toFixed(3)} m`));
          const picture = page.locator("#room svg.chart");
          await picture.waitFor();
          await picture.locator(".cursor").waitFor({ state: "attached" });
          const box = await picture.boundingBox();
          assert.ok(box);
          await picture.click({ position: { x: box.width - 29, y: box.height / 2 } });
          await page.waitForFunction(
            () => Number(/** @type {HTMLInputElement} */ (document.getElementById("along")).value) > 0.98,
          );
          await picture.click({ position: { x: 57, y: box.height / 2 } });
          await page.waitForFunction(
            () => Number(/** @type {HTMLInputElement} */ (document.getElementById("along")).value) < 0.02,
          );
          await page.click("#reset");
          await textMatches(page, "#room-along", /no path yet/);
          assert.equal(await page.getAttribute("#room", "data-clearance"), null);
        },

        "what is not known of a robot is not offered": async (page) => {
          await unfold(page, "room");
          for (const [scene, offered] of /** @type {[string, string[]][]} */ ([
            ["stones", ["optimum"]],
            ["crates", ["routes"]],
            ["turn", []],
            ["rings", ["optimum", "safest", "widest", "routes"]],
          ])) {
            await chooseScene(page, scene);
            const enabled = await page
              .locator("#room .room input[type=checkbox]:enabled")
              .evaluateAll((all) => all.map(({ id }) => id.replace("room-", "")));
            assert.deepEqual(enabled, offered, scene);
          }
        },

        "a start in collision is said; nothing hangs over at any width": async (page) => {
          await openScenario(page, { ...DOORS, queries: [{ name: "in", start: [5, 3], goal: [9, 5] }] });
          await unfold(page, "room");
          await turn(page, "widest");
          await textMatches(page, "#room-widest-text", /^The start is in collision/);
          await openScenario(page, DOORS);
          await finish(page);
          await turn(page, "safest", "routes");
          await page.waitForSelector("#room[data-clearance]");
          await assertFaultless(page, "how much room");
        },
      },
      restage,
    ),
  ));

test("how much room there is, on a phone", () =>
  onPausedPage(async (page) => {
    await openScenario(page, DOORS);
    await unfold(page, "room");
    await turn(page, "widest", "safest", "routes");
    await page.waitForSelector("#room[data-radius][data-length][data-nodes]");
    const widths = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
    assert.ok(widths[0] <= widths[1], String(widths));
  }, PHONE));
