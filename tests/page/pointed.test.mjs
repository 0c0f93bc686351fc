/** What is pointed at on the stage, and the planes that are shown. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { AngleSquare } from "../../www/draw/angle-square.js";
import { drawAxes, marginOf } from "../../www/draw/angles.js";
import { View } from "planarium/draw";
import { SvgContext } from "../../www/formats/svg.js";
import { allOf, readXml } from "./xml.mjs";
import {
  PHONE,
  isDeep,
  alphaOf,
  choosePlanner,
  chooseScene,
  finish,
  onPausedPage,
  pixelsOf,
  seek,
  setParameter,
  unfold,
  useBrowser,
} from "./browser.mjs";
import { load, planned } from "./library.mjs";
import { inTurn, restage } from "./turns.mjs";
import { square, see } from "./views.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

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

test("what is pointed at", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "a point of the square is an arm in the workspace, with its collision; nothing is held": async (page) => {
          const scenario = load("stones");
          const at = await square(page);
          const grid = Array.from({ length: 400 }, (_, i) => [
            -3 + (6 * (i % 20)) / 19,
            -3 + (6 * Math.floor(i / 20)) / 19,
          ]);
          const hits = grid.filter((q) => scenario.check(q).touching.length === 1);
          const ways = grid.filter(
            (q) =>
              scenario.check(q).free &&
              Math.hypot(q[0] - 0.1, q[1] - 0.2) > 1.5 &&
              Math.hypot(q[0] + 2.6, q[1] + 0.3) > 1.5,
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
          assert.match(
            bad.text,
            new RegExp(`^Configuration .* rad: link ${part + 1} touches obstacle ${obstacle}\\.$`),
          );
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
        },

        "without a pointer a vertex is read by its number: its parent and the way from its root": async (page) => {
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
        },

        "two selects say which joints, the caption says it too, and the same one twice is not possible": async (
          page,
        ) => {
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
        },

        "a slice shows what collides with the other joints as the robot has them": async (page) => {
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
          const hit = (/** @type {number} */ a, /** @type {number} */ b) =>
            !scenario.check([a, b, pose[2], pose[3]]).free;
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
        },
      },
      restage,
    ),
  ));

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
    const margin = marginOf(scale);
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
    // The square of the pages of kinematics and neighbours takes the scale from the brush.
    const square = new SvgContext(side, side);
    const palette = { obstacle: "#ccc", obstacleEdge: "#888", quiet: "#555" };
    const brush = { context: square, palette, width: side, height: side, ratio: 1, bold: scale };
    new AngleSquare().drawSquare(/** @type {any} */ (brush), [arm(0), arm(1)]);
    assert.ok(square.toString().includes(`${12 * scale}px`));
  }
});
