/**
 * What can be seen on the stage: what is pointed at, what was refused, who waits, poses along the path, planes,
 * numbers.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { drawAxes } from "../../www/draw/angles.js";
import { View } from "planarium/draw";
import { SvgContext } from "../../www/formats/svg.js";
import { allOf, readXml } from "./xml.mjs";
import {
  PHONE,
  isDeep,
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
import { EVENT } from "../../www/planner/run-log/columns.js";
import { SIDE as CELLS, addVertex, emptyCells } from "../../www/planner/stage/regions.js";

/** @import { Page } from "./browser.mjs" */

useBrowser();

/** Pixels of a sheet for coordinates of the configuration square, whose range is a whole turn. @param {Page} page */
async function square(page) {
  const box = (await page.locator("#cspace .sheet").boundingBox()) ?? assert.fail();
  const view = new View(
    { min: [-Math.PI, -Math.PI], max: [Math.PI, Math.PI] },
    box.width,
    box.height,
    { left: 34, right: 12, top: 12, bottom: 32 },
    true,
  );
  return (/** @type {number} */ a, /** @type {number} */ b) => ({ x: view.x(a), y: view.y(b) });
}

/**
 * Sets a switch, a number or a choice of the view.
 * @param {Page} page
 * @param {string} id
 * @param {string | boolean} value
 */
async function see(page, id, value) {
  await unfold(page, "view");
  if (typeof value === "boolean") await page.setChecked(`#${id}`, value);
  else await fill(page, `#${id}`, value);
  await atRest(page);
  await frames(page);
}

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

/**
 * The line beneath the stage, once it speaks of what is wanted.
 * @param {Page} page
 * @param {string} wanted   what the readout must say, as a CSS selector
 */
async function readout(page, wanted) {
  const line = page.locator(`#readout${wanted}`);
  await line.waitFor();
  return { text: await line.innerText(), vertex: Number(await line.getAttribute("data-vertex")) };
}

test("a point of the square is an arm in the workspace, with its collision; nothing is held", () =>
  onPausedPage(async (page) => {
    const scenario = load("stones");
    const at = await square(page);
    const grid = Array.from({ length: 400 }, (_, i) => [-3 + (6 * (i % 20)) / 19, -3 + (6 * Math.floor(i / 20)) / 19]);
    const hits = grid.filter((q) => scenario.check(q).touching.length === 1);
    const ways = grid.filter(
      (q) =>
        scenario.check(q).free && Math.hypot(q[0] - 0.1, q[1] - 0.2) > 1.5 && Math.hypot(q[0] + 2.6, q[1] + 0.3) > 1.5,
    );
    const before = await page.locator("#stage").boundingBox();
    const ends = {
      collision: await pixelsOf(page, "workspace", "top", "collision"),
      ink: await pixelsOf(page, "cspace", "top", "ink"),
    };
    const [hit, way] = [hits[Math.floor(hits.length / 2)], ways[Math.floor(ways.length / 2)]];
    await page.hover("#cspace .sheet", { position: at(hit[0], hit[1]) });
    const bad = await readout(page, "[data-vertex='-1'][data-free=false]");
    const { part, obstacle } = scenario.check(hit).touching[0];
    assert.match(bad.text, new RegExp(`^Configuration .* rad: link ${part + 1} touches obstacle ${obstacle}\\.$`));
    assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > ends.collision + 60);
    assert.ok(await page.isVisible("#legend-touching"));
    await page.hover("#cspace .sheet", { position: at(way[0], way[1]) });
    const good = await readout(page, "[data-vertex='-1'][data-free=true]");
    assert.match(good.text, /^Configuration .* rad: free, \d+\.\d{3} m from obstacle \d+\.$/);
    assert.ok((await pixelsOf(page, "workspace", "top", "ink")) > 60, "the arm is drawn");
    assert.ok((await pixelsOf(page, "cspace", "top", "ink")) > ends.ink + 20, "the point is in a ring");
    assert.equal(await pixelsOf(page, "workspace", "top", "collision"), ends.collision);
    assert.equal(await page.locator("#stage.in-hand").count(), 0);
    assert.deepEqual(await page.locator("#stage").boundingBox(), before, "nothing has moved");
    await page.hover("#story");
    await readout(page, ":not([data-vertex])");
    assert.ok((await pixelsOf(page, "cspace", "top", "ink")) <= ends.ink);
  }));

for (const options of isDeep ? [{}, { viewport: PHONE.viewport }] : [{}]) {
  test(`near a vertex it is that vertex, in both panes${"viewport" in options ? ", on a phone" : ""}`, () =>
    onPausedPage(async (page) => {
      const { scenario, planner } = planned("stones");
      await finish(page);
      const rows = planner.verticesSince(0);
      const edges = planner.edgesSince(0);
      const at = await square(page);
      const sheet = (await page.locator("#workspace .sheet").boundingBox()) ?? assert.fail();
      const world = new View(
        scenario.extent(),
        sheet.width,
        sheet.height,
        { left: 14, right: 14, top: 14, bottom: 14 },
        false,
      );
      const tips = scenario.endEffectors(rows);
      for (const wanted of [17, 60, 201]) {
        for (const pane of ["cspace", "workspace"]) {
          const place = (/** @type {number} */ v) =>
            pane === "cspace"
              ? at(rows[2 * v], rows[2 * v + 1])
              : { x: world.x(tips[2 * v]), y: world.y(tips[2 * v + 1]) };
          const { x, y } = place(wanted);
          const point = { x: x + 1, y: y + 1 };
          const distances = Array.from({ length: rows.length / 2 }, (_, v) =>
            Math.hypot(place(v).x - point.x, place(v).y - point.y),
          );
          const nearest = distances.indexOf(Math.min(...distances));
          // On a phone the transport stands over the lower end of the page.
          await page.locator(`#${pane}`).evaluate((figure) => figure.scrollIntoView({ block: "start" }));
          await page.hover(`#${pane} .sheet`, { position: point, force: true });
          const told = await readout(page, `[data-vertex='${nearest}']`);
          const degree = edges.filter((end) => end === nearest).length;
          const numbers = [...rows.slice(2 * nearest, 2 * nearest + 2)]
            .map((value) => value.toFixed(2).replace("-", "\u2212"))
            .join(", ");
          assert.equal(told.text, `Vertex ${nearest} at ${numbers} rad: ${degree} ${degree === 1 ? "edge" : "edges"}.`);
        }
      }
      // As of an earlier iteration there is nothing but the start.
      await seek(page, 0);
      const { x, y } = at(rows[2 * 60], rows[2 * 60 + 1]);
      await page.locator("#cspace").evaluate((figure) => figure.scrollIntoView({ block: "start" }));
      await page.hover("#cspace .sheet", { position: { x, y }, force: true });
      await readout(page, "[data-vertex='-1']");
    }, options));
}

test("without a pointer a vertex is read by its number: its parent and the way from its root", () =>
  onPausedPage(async (page) => {
    const { scenario, planner } = planned("firs", { algorithm: "rrt", step: 0.35, seed: 7 });
    await chooseScene(page, "firs");
    await choosePlanner(page, "rrt", "goal_bias");
    await setParameter(page, "step", "0.35");
    await setParameter(page, "seed", "7");
    assert.equal((await finish(page)).fingerprint, planner.fingerprint());
    const bare = await pixelsOf(page, "workspace", "top", "ink");
    await see(page, "inspect", "1");
    const goal = await readout(page, "[data-vertex='1']");
    assert.ok(goal.text.endsWith(`; ${planner.result().length.toFixed(2)} rad from the root.`), goal.text);
    const rows = planner.verticesSince(0);
    const edges = planner.edgesSince(0);
    const parent = edges[edges.indexOf(9, 1) - 1];
    const away = scenario.distance(rows.slice(2 * parent, 2 * parent + 2), rows.slice(18, 20)).toFixed(2);
    for (let i = 0; i < 8; i++) await page.press("#inspect", "ArrowUp");
    const told = await readout(page, "[data-vertex='9']");
    assert.match(told.text, new RegExp(`\\. Parent ${parent}, ${away} rad away; `));
    const ringed = await pixelsOf(page, "workspace", "top", "ink");
    assert.ok(ringed > bare + 15, `${bare}, then ${ringed} pixels`);
    await see(page, "inspect", "");
    await readout(page, ":not([data-vertex])");
  }));

test("refused samples stay as crosses, refused motions as lines to where they hit, with a legend", () =>
  onPausedPage(async (page) => {
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
    assert.ok(deep.length < 0.02 * places.length, `${deep.length} of ${places.length} pixels are inside of obstacles`);
    assert.equal(await page.getAttribute("#legend-rejected", "data-kinds"), "motions");
    await choosePlanner(page, "prm", "samples");
    await finish(page);
    assert.equal(await page.getAttribute("#legend-rejected", "data-kinds"), "samples motions");
    const { length: crosses } = await inked(page, "workspace", "marks");
    await see(page, "view-refused", false);
    const { length: without } = await inked(page, "workspace", "marks");
    assert.ok(crosses > without + 2000, `${crosses} pixels with crosses, ${without} without`);
  }));

test("while a roadmap is searched those who wait are in rings, and the legend names them; else not", () =>
  onPausedPage(async (page) => {
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
  }));

test("as many poses along the path as are wanted, or none", () =>
  onPausedPage(async (page) => {
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
  }));

test("the path as it was found is shown beside the shortened one, with both lengths in words", () =>
  onPausedPage(async (page) => {
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
  }));

test("names of axes stand clear of the numbers in small squares, and grow with the words of the projector", () => {
  const arm = (/** @type {number} */ joint) => ({
    name: `joint ${joint}`,
    unit: /** @type {const} */ ("rad"),
    low: -Math.PI,
    high: Math.PI,
    isCircle: true,
  });
  for (const scale of [1, 1.7]) {
    const side = 180 * scale;
    const margin = { left: 34 * scale, right: 12 * scale, top: 12 * scale, bottom: 32 * scale };
    const view = new View({ min: [-Math.PI, -Math.PI], max: [Math.PI, Math.PI] }, side, side, margin, true);
    const context = new SvgContext(side, side);
    drawAxes(
      /** @type {any} */ (context),
      view,
      {
        x: margin.left,
        y: margin.top,
        width: side - margin.left - margin.right,
        height: side - margin.top - margin.bottom,
      },
      [arm(0), arm(1)],
      scale,
    );
    const words = allOf(readXml(context.toString()), "text");
    const groups = allOf(readXml(context.toString()), "g")
      .map(({ attributes }) => attributes.style)
      .filter(Boolean);
    assert.ok(groups.length > 0 && groups.every((style) => style.includes(`${12 * scale}px`)), String(groups));
    const across = words.filter(({ attributes }) => attributes.y === words[0].attributes.y && attributes.x);
    const spans = across
      .map(({ attributes, children }) => [
        Number(attributes.x) - 3.1 * scale * String(children[0]).length,
        Number(attributes.x) + 3.1 * scale * String(children[0]).length,
      ])
      .toSorted(([a], [b]) => a - b);
    assert.equal(spans.length, 4);
    spans.slice(1).forEach(([from], i) => assert.ok(from > spans[i][1] + 2, `${spans}`));
  }
});

test("two selects say which joints, the caption says it too, and the same one twice is not possible", () =>
  onPausedPage(async (page) => {
    await unfold(page, "view");
    assert.equal(
      await page.locator("#view-plane").evaluate((element) => /** @type {HTMLElement} */ (element).hidden),
      true,
    );
    const { planner } = planned("thicket");
    await chooseScene(page, "thicket");
    await finish(page);
    await see(page, "view-across", "2");
    await see(page, "view-up", "3");
    assert.match(await page.innerText("#cspace figcaption"), /joint 3 across, joint 4 up/);
    const rows = planner.verticesSince(0);
    const at = await square(page);
    const [x, y] = [rows[4 * 30 + 2], rows[4 * 30 + 3]];
    await page.hover("#cspace .sheet", { position: at(x, y) });
    const { vertex } = await readout(page, "[data-vertex]:not([data-vertex='-1'])");
    const there = at(rows[4 * vertex + 2], rows[4 * vertex + 3]);
    assert.ok(Math.hypot(there.x - at(x, y).x, there.y - at(x, y).y) < 2, `vertex ${vertex} is in another place`);
    await see(page, "view-across", "3");
    assert.match(await page.innerText("#cspace figcaption"), /joint 4 across, joint 3 up/);
    assert.equal(await page.inputValue("#view-up"), "2");
    await chooseScene(page, "stones");
    assert.doesNotMatch(await page.innerText("#cspace figcaption"), /across/);
  }));

test("a slice shows what collides with the other joints as the robot has them", () =>
  onPausedPage(async (page) => {
    const scenario = load("thicket");
    await chooseScene(page, "thicket");
    assert.ok((await pixelsOf(page, "cspace", "ground", "obstacle")) < 50);
    await see(page, "view-slice", true);
    assert.match(await page.innerText("#cspace figcaption"), /slice at the robot’s configuration/);
    const { start: pose } = scenario.document().queries[0];
    const at = await square(page);
    const grid = Array.from({ length: 900 }, (_, i) => [
      -3.05 + (6.1 * (i % 30)) / 29,
      -3.05 + (6.1 * Math.floor(i / 30)) / 29,
    ]);
    // The picture has 96 cells a side, each of one configuration: points whose surroundings of a cell are alike must
    // agree.
    const cell = (2 * Math.PI) / 96;
    const hit = (/** @type {number} */ a, /** @type {number} */ b) => !scenario.check([a, b, pose[2], pose[3]]).free;
    const around = [
      [0, 0],
      [cell, 0],
      [-cell, 0],
      [0, cell],
      [0, -cell],
      [cell, cell],
      [-cell, -cell],
      [cell, -cell],
      [-cell, cell],
    ];
    const clear = grid.filter(([a, b]) => new Set(around.map(([x, y]) => hit(a + x, b + y))).size === 1);
    const hits = clear.map(([a, b]) => hit(a, b));
    assert.ok(clear.length > 500 && hits.some(Boolean) && !hits.every(Boolean), `${clear.length} points`);
    const { width, alpha } = await alphaOf(page, "cspace", "ground");
    const filled = clear
      .map(([a, b]) => at(a, b))
      .map(({ x, y }) => alpha[Math.floor(y) * width + Math.floor(x)] > 128);
    const agree = hits.filter((one, i) => one === filled[i]).length / hits.length;
    assert.ok(agree > 0.99, `${(100 * agree).toFixed(1)} % of ${clear.length} points agree`);
    await see(page, "view-slice", false);
    assert.ok((await pixelsOf(page, "cspace", "ground", "obstacle")) < 50);
  }));

test("the numbers equal the run's, in one line that never changes its height", () =>
  onPausedPage(async (page) => {
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
  }));

test("the page says which way round each joint took, of a path and of an arm in hand", () =>
  onPausedPage(async (page) => {
    const { scenario, planner } = planned("stones");
    const { path } = planner.result();
    assert.equal(await page.innerText("#turns"), "");
    await finish(page);
    const turn = (/** @type {number} */ angle) => Math.atan2(Math.sin(angle), Math.cos(angle));
    const sums = path[0].map((_, i) => path.slice(1).reduce((sum, q, at) => sum + turn(q[i] - path[at][i]), 0));
    // The first joint of this path turns by more than half a turn.
    assert.ok(sums[0] > Math.PI && Math.abs(sums[1]) < Math.PI);
    const told = (/** @type {number} */ sum) => `${sum > 0 ? "+" : ""}${sum.toFixed(2)} rad`.replace("-", "\u2212");
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
  }));

test("the shortest path is drawn on request, with the gap of the path found, and a reference for two joints", () =>
  onPausedPage(async (page) => {
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
      [await page.isVisible("#view-optimum"), await page.isVisible("#gap"), await page.isVisible("#legend-optimum")],
      [false, false, false],
    );
  }));

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

test("Voronoi regions are drawn under a tree of two coordinates, kept in the link, and offered there alone", () =>
  onPausedPage(async (page) => {
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
  }));
