/** What is drawn on the stage on request: what was refused, who waits, poses along the path, regions; and numbers. */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  alphaOf,
  atRest,
  choosePlanner,
  chooseScene,
  click,
  fill,
  finish,
  frames,
  onPausedPage,
  pixelsOf,
  seek,
  setParameter,
  unfold,
  useBrowser,
} from "./browser.mjs";
import { load, planned } from "./library.mjs";
import { inTurn, restage } from "./turns.mjs";
import { EVENT } from "../../www/planner/run-log/columns.js";
import { SIDE as CELLS, addVertex, emptyCells } from "../../www/planner/stage/regions.js";
import { square, see } from "./views.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

/**
 * Where a layer has ink.
 * @param {Page} page
 * @param {string} pane
 * @param {"marks" | "top"} layer
 * @param {number} [least]  of 255: how dense
 * @returns {Promise<number[][]>} device pixels
 */
async function inked(page, pane, layer, least = 1) {
  const { width, alpha } = await alphaOf(page, pane, layer);
  return [...alpha.keys()].filter((i) => alpha[i] >= least).map((i) => [i % width, Math.floor(i / width)]);
}

test("what is drawn on request", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "refused samples stay as crosses, refused motions as lines to where they hit, with a legend": async (page) => {
          const scenario = load("stones");
          await choosePlanner(page, "rrt", "goal_bias");
          await setParameter(page, "step", "1.5");
          await finish(page);
          assert.equal((await inked(page, "cspace", "marks")).length, 0);
          assert.equal(await page.isVisible("#legend-rejected"), false);
          await see(page, "view-refused", true);
          assert.ok(await page.isVisible("#legend-rejected"));
          const places = await inked(page, "cspace", "marks", 100);
          assert.ok(places.length > 200, `${places.length} pixels`);
          const at = await square(page);
          const [low, high] = [at(-Math.PI, -Math.PI), at(Math.PI, Math.PI)];
          // Two pixels beside the border of an obstacle are the width of the line.
          const deep = places.filter(([x, y]) =>
            [
              [-2, 0],
              [2, 0],
              [0, -2],
              [0, 2],
            ].every(([dx, dy]) => {
              const q = [(x + dx + 0.5 - low.x) / (high.x - low.x), (y + dy + 0.5 - low.y) / (high.y - low.y)].map(
                (part) => -Math.PI + 2 * Math.PI * part,
              );
              return !scenario.check(q).free;
            }),
          );
          assert.ok(
            deep.length < 0.02 * places.length,
            `${deep.length} of ${places.length} pixels are inside of obstacles`,
          );
          assert.equal(await page.getAttribute("#legend-rejected", "data-kinds"), "motions");
          await choosePlanner(page, "prm", "samples");
          await finish(page);
          assert.equal(await page.getAttribute("#legend-rejected", "data-kinds"), "samples motions");
          const { length: crosses } = await inked(page, "workspace", "marks");
          await see(page, "view-refused", false);
          const { length: without } = await inked(page, "workspace", "marks");
          assert.ok(crosses > without + 2000, `${crosses} pixels with crosses, ${without} without`);
        },

        "while a roadmap is searched those who wait are in rings, and the legend names them; else not": async (
          page,
        ) => {
          const { iterations } = await finish(page);
          assert.equal(await page.isVisible("#legend-waiting"), false);
          await seek(page, iterations - 8);
          assert.equal(await page.getAttribute("#counters", "data-phase"), "searching");
          assert.ok(await page.isVisible("#legend-waiting"));
          const rings = await pixelsOf(page, "cspace", "top", "ink");
          assert.ok(rings > 100, `${rings} pixels`);
          await seek(page, 300);
          await frames(page);
          assert.equal(await page.isVisible("#legend-waiting"), false);
          assert.ok((await pixelsOf(page, "cspace", "top", "ink")) < rings / 4);
        },

        "as many poses along the path as are wanted, or none": async (page) => {
          for (const id of ["stones", "rings"]) {
            await chooseScene(page, id);
            await finish(page);
            await page.fill("#along", "0");
            const inkWith = async (/** @type {string} */ control, /** @type {string | boolean} */ value) => {
              await see(page, control, value);
              return (await inked(page, "workspace", "top")).length;
            };
            await see(page, "view-strobe", true);
            const [few, many] = [await inkWith("view-poses", "3"), await inkWith("view-poses", "24")];
            assert.ok(await page.isVisible("#legend-poses"));
            const none = await inkWith("view-strobe", false);
            assert.ok(none < few && few < many, `${id}: ${none}, ${few}, ${many} pixels`);
            assert.equal(await page.isVisible("#legend-poses"), false);
            await see(page, "view-poses", "40");
            assert.equal(await page.getAttribute("#view-poses", "aria-invalid"), "true");
          }
        },

        "the path as it was found is shown beside the shortened one, with both lengths in words": async (page) => {
          const { scenario, planner } = planned("shelf", { shortcut: 100 });
          await chooseScene(page, "shelf");
          await setParameter(page, "shortcut", "100");
          await finish(page);
          await page.fill("#along", "0.5");
          await atRest(page);
          const [raw, n] = [planner.rawPath(), scenario.dimension];
          let found = 0;
          for (let i = n; i < raw.length; i += n) found += scenario.distance(raw.slice(i - n, i), raw.slice(i, i + n));
          const { length } = planner.result();
          assert.ok(found > length + 0.1);
          await unfold(page, "view");
          assert.equal(
            await page.textContent("#view-lengths"),
            `${found.toFixed(2)} rad before shortcutting, ${length.toFixed(2)} rad after.`,
          );
          assert.match(
            await page.innerText("#story"),
            new RegExp(`length ${length.toFixed(2)} rad, shortened from ${found.toFixed(2)} rad`),
          );
          assert.equal(await page.isVisible("#legend-raw"), false);
          const alone = await pixelsOf(page, "cspace", "top", "path");
          await see(page, "view-raw", true);
          assert.ok(await page.isVisible("#legend-raw"));
          const both = await pixelsOf(page, "cspace", "top", "path");
          assert.ok(both > alone + 20, `${alone}, then ${both} pixels`);
        },

        "the shortest path is drawn on request, with the gap of the path found, and a reference for two joints": async (
          page,
        ) => {
          await chooseScene(page, "rings");
          await finish(page);
          const gap = async () =>
            Number((await page.locator("#count-gap").innerText()).replace(" %", "").replace("\u2212", "-"));
          assert.equal(await page.isVisible("#gap"), false);
          const before = await pixelsOf(page, "workspace", "top", "ink");
          await see(page, "view-optimum", true);
          await page.waitForSelector("#legend-optimum:not([hidden])");
          assert.ok((await pixelsOf(page, "workspace", "top", "ink")) > before + 200);
          assert.equal(await page.innerText("#legend-optimum-name"), "shortest path");
          const { scenario, planner } = planned("rings");
          const { length } = scenario.optimum();
          assert.ok(Math.abs((await gap()) - 100 * (planner.result().length / (length ?? NaN) - 1)) < 0.51);

          await chooseScene(page, "stones");
          await page.waitForFunction(() => document.getElementById("legend-optimum-name")?.textContent === "reference");
          await finish(page);
          assert.ok((await gap()) > 0);
          await chooseScene(page, "shelf");
          assert.deepEqual(
            [
              await page.isVisible("#view-optimum"),
              await page.isVisible("#gap"),
              await page.isVisible("#legend-optimum"),
            ],
            [false, false, false],
          );
        },

        "Voronoi regions are drawn under a tree of two coordinates, kept in the link, and offered there alone": async (
          page,
        ) => {
          await chooseScene(page, "pillar");
          await finish(page);
          const painted = async (/** @type {string} */ pane) =>
            (await alphaOf(page, pane, "top")).alpha.filter((dense) => dense > 40).length;
          const before = await painted("cspace");
          await see(page, "view-regions", true);
          await atRest(page);
          assert.ok((await painted("cspace")) > before + 10_000, "the whole square");
          await chooseScene(page, "rings");
          await finish(page);
          await chooseScene(page, "shelf");
          assert.equal(await page.isVisible("#view-regions"), false);
        },
      },
      restage,
    ),
  ));

test("numbers of a run", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "the numbers equal the run's, in one line that never changes its height": async (page) => {
          const height = async () => (await page.locator(".numbers").boundingBox())?.height;
          const before = await height();
          const { planner } = planned("stones");
          const {
            configuration_checks: checks,
            motion_checks: motions,
            clearance_evaluations: evaluations,
            nearest_queries: nearest,
            visited,
          } = planner.stats();
          const rejected = planner
            .eventsSince(0)
            .filter((kind, i) => i % planner.eventWidth === 0 && kind === EVENT.rejected).length;
          assert.ok(visited > 40 && rejected > 100);
          await finish(page);
          const text = async (/** @type {string} */ name) => page.innerText(`#count-${name}`);
          const grouped = (/** @type {number} */ count) => count.toLocaleString("en");
          assert.deepEqual(
            [
              await text("checks"),
              await text("rejected"),
              await text("motions"),
              await text("evaluations"),
              await text("nearest"),
              await text("visited"),
              await text("waypoints"),
            ],
            [checks, rejected, motions, evaluations, nearest, visited, planner.result().path.length].map(grouped),
          );
          assert.equal(await text("length"), `${planner.result().length.toFixed(2)} rad`);
          for (const name of ["build", "search"]) assert.match(await text(name), /^[\d.]+ m?s$/);
          assert.match(await text("rate"), /^[\d,.]+[KM]?$/);
          assert.equal(await height(), before);
          // What is not known of an earlier iteration is a dash.
          await click(page, "#back");
          assert.deepEqual(
            [await text("nearest"), await text("build"), await text("search"), await text("rate")],
            Array(4).fill("\u2013"),
          );
          assert.equal(await text("visited"), grouped(visited - 1));
          const rows = await page
            .locator(".numbers dd:visible")
            .evaluateAll((all) => new Set(all.map((element) => Math.round(element.getBoundingClientRect().top))).size);
          assert.equal(rows, 1);
          // The search of a tree visits no roadmap.
          await choosePlanner(page, "rrt", "step");
          await finish(page);
          assert.equal(await text("visited"), "\u2013");
        },

        "the page says which way round each joint took, of a path and of an arm in hand": async (page) => {
          const { scenario, planner } = planned("stones");
          const { path } = planner.result();
          assert.equal(await page.innerText("#turns"), "");
          await finish(page);
          const turn = (/** @type {number} */ angle) => Math.atan2(Math.sin(angle), Math.cos(angle));
          const sums = path[0].map((_, i) => path.slice(1).reduce((sum, q, at) => sum + turn(q[i] - path[at][i]), 0));
          // The first joint of this path turns by more than half a turn.
          assert.ok(sums[0] > Math.PI && Math.abs(sums[1]) < Math.PI);
          const told = (/** @type {number} */ sum) =>
            `${sum > 0 ? "+" : ""}${sum.toFixed(2)} rad`.replace("-", "\u2212");
          assert.equal(
            await page.innerText("#turns"),
            `Turns along the path (+ is counter-clockwise): joint 1 ${told(sums[0])}, the long way round; joint 2 ${told(sums[1])}.`,
          );
          const start = scenario.document().queries[0].start;
          await page.click("#your-turn");
          await fill(page, "#pose-0", "-3.1");
          await atRest(page);
          assert.equal(
            await page.innerText("#turns"),
            `Turns from the start, the short way round (+ is counter-clockwise): joint 1 ${told(turn(-3.1 - start[0]))}; joint 2 0.00 rad.`,
          );
          await chooseScene(page, "rings");
          await finish(page);
          assert.equal(await page.innerText("#turns"), "");
        },
      },
      restage,
    ),
  ));

test("Voronoi regions: each cell belongs to the vertex nearest to it, in the metric of the run, across the borders", () => {
  for (const [id, algorithm, metric] of /** @type {const} */ ([
    ["pillar", "rrt", "sum"],
    ["pillar", "rrt", "euclidean"],
    ["rings", "rrt", "euclidean"],
  ])) {
    const scenario = load(id);
    const isDisc = scenario.robot === "disc";
    const planner = scenario.planner({ algorithm, seed: 3, step: 0.3, direct: false, ...(isDisc ? {} : { metric }) });
    planner.step(120);
    const rows = planner.verticesSince(0);
    const count = rows.length / 2;
    const box = isDisc ? scenario.extent() : { min: [-Math.PI, -Math.PI], max: [Math.PI, Math.PI] };
    const circles = scenario.circles();
    const cells = emptyCells();
    for (let vertex = 0; vertex < count; vertex++)
      addVertex(cells, rows.subarray(2 * vertex, 2 * vertex + 2), vertex, metric, box, circles);
    const { nearest } = cells;
    const gap = (/** @type {number} */ a, /** @type {number} */ b, /** @type {boolean} */ isCircle) =>
      isCircle ? Math.abs(a - b - 2 * Math.PI * Math.round((a - b) / (2 * Math.PI))) : Math.abs(a - b);
    let far = 0;
    for (let at = 0; at < CELLS * CELLS; at += 37) {
      const place = [at % CELLS, Math.floor(at / CELLS)].map(
        (cell, i) => box.min[i] + ((cell + 0.5) / CELLS) * (box.max[i] - box.min[i]),
      );
      const distance = (/** @type {number} */ vertex) => {
        const [x, y] = [0, 1].map((i) => gap(place[i], rows[2 * vertex + i], circles[i]));
        return metric === "sum" ? x + y : Math.hypot(x, y);
      };
      const least = Math.min(...Array.from({ length: count }, (_, vertex) => distance(vertex)));
      assert.ok(distance(nearest[at]) <= least + 1e-9, `${id} ${metric}: cell ${at}`);
      far += Number(!isDisc && [0, 1].some((i) => Math.abs(place[i] - rows[2 * nearest[at] + i]) > Math.PI));
    }
    assert.ok(isDisc || far > 0, "some vertex is nearest across a border");
  }
});
