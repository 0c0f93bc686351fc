/** The page of nearest neighbours: asked and dragged, on a desk and on a phone. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario } from "planarium";
import { ROBOTS } from "../../www/neighbours/robots.js";
import { DESK, PHONE, fill, isDeep, linkOf, pixelsOf, useBrowser } from "./browser.mjs";
import { drag, plane } from "./editing.mjs";
import { inTurn } from "./turns.mjs";
import {
  onNeighbours,
  rest,
  click,
  press,
  choose,
  put,
  putBack,
  robotOf,
  select,
  stateOf,
  numbers,
  foundBy,
} from "./neighbours.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

/**
 * Where a point of the world is, in pixels of the window.
 * @param {Page} page
 * @param {string} id
 * @param {number[]} point
 */
const windowOf = async (page, id, [x, y]) => (await plane(page, Scenario.parse(robotOf(id).document).extent()))(x, y);

test("what is found, what is missed, and what it takes", (t) =>
  onNeighbours(
    inTurn(
      t,
      {
        "every preset of a robot shows what a scan finds; an arm opens where the naive metric is wrong": async (
          page,
        ) => {
          for (const { id, presets, q, k, document } of ROBOTS) {
            await choose(page, id);
            const first = await stateOf(page);
            const scenario = Scenario.parse(document);
            assert.ok(scenario.distance(numbers(first.q), q) < 1e-9 && first.k === String(k), id);
            if (document.robot.type === "arm") {
              await select(page, "option-metric", "naive");
              assert.ok(Number((await stateOf(page)).missed) > 0, id);
              assert.match(await page.innerText("#story"), /(is|are) wrong/);
              await select(page, "option-metric", "sum");
            }
            for (const i of presets.keys()) {
              await select(page, "preset", String(i));
              const state = await stateOf(page);
              assert.equal(state.k, String(presets[i][1]));
              assert.ok(scenario.distance(numbers(state.q), presets[i][0]) < 1e-9);
              const expected = foundBy(state);
              assert.deepEqual(numbers(state.found), [...expected.indices], `${id}, question ${i}`);
              assert.equal(state.missed, "0");
              const rows = await page
                .locator("#neighbours tbody tr")
                .evaluateAll((all) => all.map((row) => /** @type {HTMLElement} */ (row).dataset.distance));
              assert.deepEqual(rows.map(Number), [...expected.distances]);
              assert.equal(await page.inputValue("#preset"), String(i));
            }
            scenario.free();
          }
        },

        "the naive metric misleads: what it misses and what it finds wrongly is said and marked": async (page) => {
          await put(page, "q0-number", 0.02);
          await put(page, "q1-number", -0.03);
          await put(page, "k-number", 12);
          await select(page, "option-metric", "naive");
          const state = await stateOf(page);
          const [naive, meant] = /** @type {const} */ (["naive", "sum"]).map(
            (metric) => foundBy(state, { index: "linear", metric }).indices,
          );
          assert.deepEqual(numbers(state.found), [...naive]);
          const missed = [...meant].filter((one) => !naive.includes(one)).length;
          assert.ok(missed > 0, "the target is at the cut");
          assert.equal(state.missed, String(missed));
          assert.match(await page.innerText("#story"), /naive metric .* cuts each circle at 0/);
          assert.equal(await page.locator("#neighbours tr[data-right=false]").count(), missed);
          assert.equal(await page.innerText("#fact-recall"), `${12 - missed} of 12`);
          for (const pane of ["workspace", "cspace"])
            assert.ok((await pixelsOf(page, pane, "top", "rejected")) > 10, pane);
          await select(page, "option-metric", "euclidean");
          const euclidean = await stateOf(page);
          assert.deepEqual(numbers(euclidean.found), [...foundBy(state, { metric: "euclidean" }).indices]);
          assert.equal(euclidean.missed, "0");
          assert.equal(await pixelsOf(page, "cspace", "top", "rejected"), 0);
        },

        "a kd-tree without wrap-around misses what lies across pi: said, marked, drawn up to the border, and in a link":
          async (page) => {
            await put(page, "q0-number", 3.1);
            await put(page, "q1-number", 1);
            await put(page, "k-number", 12);
            const right = await stateOf(page);
            assert.equal(right.missed, "0");
            await select(page, "index", "kd-tree-unwrapped");
            const state = await stateOf(page);
            const [plain, meant] = /** @type {const} */ (["kd-tree-unwrapped", "linear"]).map(
              (index) => foundBy(state, { index }).indices,
            );
            assert.deepEqual([numbers(state.found), numbers(right.found)], [[...plain], [...meant]]);
            const missed = [...meant].filter((one) => !plain.includes(one)).length;
            assert.ok(missed > 0, "the target is at the seam");
            assert.equal(state.missed, String(missed));
            assert.match(
              await page.innerText("#story"),
              new RegExp(`This kd-tree .* cuts each circle at \u03c0\\. Of its 12 neighbours ${missed} `),
            );
            assert.equal(await page.locator("#neighbours tr[data-right=false]").count(), missed);
            assert.equal(await page.innerText("#fact-recall"), `${12 - missed} of 12`);
            for (const pane of ["workspace", "cspace"])
              assert.ok((await pixelsOf(page, pane, "top", "rejected")) > 10, pane);
            await onNeighbours(async (other) => assert.deepEqual(await stateOf(other), state), DESK, {
              path: `neighbours.html${await linkOf(page)}`,
            });
            await select(page, "option-metric", "naive");
            assert.match(await page.innerText("#story"), /The naive metric .* cuts each circle at 0/);
            await select(page, "option-metric", "sum");
            await put(page, "q0-number", 1.5);
            assert.match(
              await page.innerText("#story"),
              /Here it happens to be right\. Move a joint near \u03c0 to see it fail\./,
            );
            await choose(page, "point");
            assert.deepEqual([(await stateOf(page)).index, (await stateOf(page)).missed], ["kd-tree-unwrapped", "0"]);
            assert.match(await page.innerText("#story"), /^The kd-tree visited .* to find the 8 nearest\.$/);
          },

        "scan, tree and forest: how many they visit, and what a forest misses": async (page) => {
          await choose(page, "four");
          await put(page, "count-number", 5000);
          await put(page, "k-number", 40);
          const tree = await stateOf(page);
          assert.ok(Number(tree.visited) < 5000);
          await select(page, "index", "linear");
          const scan = await stateOf(page);
          assert.deepEqual([scan.visited, scan.found], ["5000", tree.found]);
          await select(page, "index", "forest");
          await put(page, "option-candidates", 45);
          await put(page, "option-trees", 2);
          const forest = await stateOf(page);
          const expected = foundBy(forest, { index: "forest", trees: 2, candidates: 45 });
          assert.deepEqual([numbers(forest.found), Number(forest.visited)], [[...expected.indices], expected.visited]);
          assert.equal(
            Number(forest.missed),
            numbers(tree.found).filter((one) => !expected.indices.includes(one)).length,
          );
          assert.ok(Number(forest.missed) > 0);
          assert.match(await page.innerText("#story"), new RegExp(`missed ${forest.missed} of the 40 nearest`));
          await select(page, "index", "kd-tree");
          assert.equal((await stateOf(page)).found, tree.found, "what only a forest takes is no trouble to a tree");
          await select(page, "index", "forest");
          assert.equal((await stateOf(page)).found, forest.found, "and is there again");
          await fill(page, "#option-trees", "65");
          assert.match(await page.innerText("#option-trees-reason"), /65 is above 64/);
          assert.equal((await stateOf(page)).found, forest.found);
        },

        "lists are drawn by number and seed, free or not, up to 100,000, which stay in hand": async (page) => {
          const first = await stateOf(page);
          await put(page, "seed-number", 7);
          assert.notEqual((await stateOf(page)).found, first.found);
          await click(page, "#free");
          const scenario = Scenario.parse(robotOf("two").document);
          assert.deepEqual(numbers((await stateOf(page)).found), [
            ...foundBy(first, {}, scenario.sampleConfigurations(500, { seed: 7 })).indices,
          ]);
          await page.press("#count", "End");
          await page.waitForSelector("body[data-n='100000']");
          await rest(page);
          const many = await stateOf(page);
          assert.deepEqual(numbers(many.found), [
            ...foundBy(many, {}, scenario.sampleConfigurations(100_000, { seed: 7 })).indices,
          ]);
          assert.ok(Number(many.visited) < 1000);
          for (const value of ["0", "100001", "1.5", ""]) {
            await fill(page, "#count-number", value);
            assert.notEqual(await page.innerText("#count-reason"), "", value);
          }
          assert.equal((await stateOf(page)).n, "100000");
          scenario.free();
        },
      },
      putBack,
    ),
  ));

const DRAGGED = "the target is dragged in the workspace, and the neighbours follow";

/** What is done with the target on any device. @type {Record<string, (page: Page) => Promise<void>>} */
const ANYWHERE = {
  [DRAGGED]: async (page) => {
    for (const [id, handle, to] of /** @type {[string, (q: number[]) => number[], number[]][]} */ ([
      ["two", (q) => Scenario.parse(robotOf("two").document).endEffector(q), [-0.3, 0.9]],
      ["body", (q) => q.slice(0, 2), [0.6, 0.7]],
      ["point", (q) => q, [1.7, 0.3]],
    ])) {
      await choose(page, id);
      const was = await stateOf(page);
      await drag(page, [await windowOf(page, id, handle(numbers(was.q))), await windowOf(page, id, to)]);
      await rest(page);
      const state = await stateOf(page);
      const q = numbers(state.q);
      if (id === "two")
        assert.ok(q[0] === numbers(was.q)[0] && q[1] !== numbers(was.q)[1], "a link's end turns its own joint");
      else assert.ok(Math.hypot(q[0] - to[0], q[1] - to[1]) < 0.02, `${id}: ${state.q}`);
      assert.deepEqual(numbers(state.found), [...foundBy(state).indices], id);
    }
  },

  "the target is put anywhere on the square, moved by keys, by sliders and by numbers": async (page) => {
    const canvas = page.locator("#cspace canvas[data-layer=top]");
    await canvas.scrollIntoViewIfNeeded();
    const box = (await canvas.boundingBox()) ?? assert.fail("no canvas");
    await page.mouse.click(box.x + 34 + (box.width - 46) / 2, box.y + 12 + (box.height - 44) / 2);
    await rest(page);
    const middle = await stateOf(page);
    assert.ok(
      numbers(middle.q).every((angle) => Math.abs(angle) < 0.03),
      middle.q,
    );
    assert.deepEqual(numbers(middle.found), [...foundBy(middle).indices]);
    await press(page, "#stage", "ArrowRight", "Shift+ArrowUp");
    const moved = numbers((await stateOf(page)).q).map((angle, i) => angle - numbers(middle.q)[i]);
    assert.ok(Math.abs(moved[0] - 0.01 * Math.PI) < 1e-9 && Math.abs(moved[1] - 0.1 * Math.PI) < 1e-9, moved.join());
    await press(page, "#q0", "Home");
    assert.ok(Math.abs(Math.abs(numbers((await stateOf(page)).q)[0]) - Math.PI) < 1e-9);
    await put(page, "q1-number", -1.25);
    const state = await stateOf(page);
    assert.equal(numbers(state.q)[1], -1.25);
    assert.deepEqual(numbers(state.found), [...foundBy(state).indices]);
    await fill(page, "#q1-number", "4");
    assert.match(await page.innerText("#q1-reason"), /4 is above/);
  },
};

test("on a desktop the target is moved", (t) => onNeighbours(inTurn(t, ANYWHERE, putBack)));

test("on a phone it is, too", (t) =>
  onNeighbours(inTurn(t, isDeep ? ANYWHERE : { [DRAGGED]: ANYWHERE[DRAGGED] }, putBack), PHONE));
