/** In the editor: walls, holes, bounds, and new scenes. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { rectangleBetween } from "../../www/domain/obstacles.js";
import {
  atRest,
  finish,
  onPausedPage,
  openScenario,
  pixelsOf,
  take,
  textMatches,
  unfold,
  useBrowser,
} from "./browser.mjs";
import { drag, enter, near, openEditor, plane, press, saved, told, until } from "./editing.mjs";
import { PLAIN, onPlain } from "./editing-scenes.mjs";
import { assertFaultless } from "./looks.mjs";
import { inTurn, restage } from "./turns.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("../../www/domain/types.js").Obstacle} Obstacle */
/** @typedef {import("../../www/domain/types.js").Point} Point */
/** @typedef {import("../../www/domain/types.js").ScenarioDocument} ScenarioDocument */

useBrowser();

/** @param {number} low @param {number} high */
const square = (low, high) => rectangleBetween([low, low], [high, high]).vertices;

/** The plain world with other obstacles. @param {Obstacle[]} obstacles @param {Point} [start] @param {Point} [goal] @returns {ScenarioDocument} */
const world = (obstacles, start = [-0.9, 0.9], goal = [0.9, -0.9]) => ({
  ...PLAIN,
  world: { ...PLAIN.world, obstacles },
  queries: [{ name: "across", start, goal }],
});

/** A ring whose inside is free, with an island in it, and a wall. @type {Obstacle[]} */
const RING = [
  { type: "polygon", vertices: square(-0.7, 0.7), holes: [square(-0.5, 0.5)] },
  {
    type: "wall",
    points: [
      [0, -0.3],
      [0, 0.3],
    ],
    width: 0.1,
  },
];

/** @param {ScenarioDocument} document @param {number} index */
const wallAt = ({ world: { obstacles } }, index) => {
  const wall = obstacles[index];
  return wall.type === "wall" ? wall : assert.fail(`obstacle ${index} is a ${wall.type}`);
};

/** @param {ScenarioDocument} document @param {number} index */
const polygonAt = ({ world: { obstacles } }, index) => {
  const polygon = obstacles[index];
  return polygon.type === "polygon" ? polygon : assert.fail(`obstacle ${index} is a ${polygon.type}`);
};

test("walls, holes, bounds and new scenes in the editor", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "a wall is drawn point by point and ended three ways; its points and its width are changed": onPlain(
          async (page, at) => {
            for (const [i, close] of /** @type {const} */ (["double", "Enter", "first"]).entries()) {
              await page.click("#edit-tools >> text=Wall");
              await textMatches(page, "#story", /end the wall/);
              const y = -0.75 + 0.25 * i;
              for (const point of [at(0.2, y), at(0.5, y), at(0.5, y + 0.1)]) await page.mouse.click(...point);
              if (close === "double") await page.mouse.click(...at(0.5, y + 0.1));
              else if (close === "first") await page.mouse.click(...at(0.2, y));
              else await page.keyboard.press("Enter");
              await until(page, "undo", i + 1);
              await until(page, "title", `Obstacle ${i + 2}, a wall`);
            }
            const { document: drawn } = await saved(page);
            assert.deepEqual(
              [2, 3, 4].map((i) => wallAt(drawn, i).closed ?? false),
              [false, false, true],
            );
            near(wallAt(drawn, 2).points[2][1], -0.65);
            await enter(page, "#edit-width", "0.08");
            await until(page, "undo", 4);
            await page.click("#edit-closed");
            await until(page, "undo", 5);
            // A point, a middle that becomes one, and the whole wall. Saving has scrolled.
            const now = await plane(page, 1);
            await drag(page, [now(0.5, -0.25), now(0.7, -0.25)], 6);
            await drag(page, [now(0.45, -0.25), now(0.45, -0.1)], 7);
            await page.focus("#stage");
            await press(page, ["ArrowUp"], "undo", 8);
            const { document: changed } = await saved(page);
            const wall = wallAt(changed, 4);
            assert.deepEqual([wall.width, wall.closed ?? false, wall.points.length], [0.08, false, 4]);
            near(wall.points[1][1], -0.09);
            near(wall.points[2][0], 0.7);
            await page.focus("#stage");
            // Past the last point of an open wall, as far again.
            await press(page, ["PageUp"], "title", "Obstacle 4, a wall, point 3");
            await press(page, ["Insert"], "title", "Obstacle 4, a wall, point 4");
            await press(page, ["Delete"], "undo", 10);
            await press(page, ["PageUp", "Delete", "PageUp", "Delete"], "undo", 12);
            await press(page, ["PageUp", "Delete"], "code", "degenerate-wall");
            await enter(page, "#edit-width", "-1");
            await until(page, "code", "out-of-range");
            assert.match(await page.innerText("#edit-reason"), /width/);
            await page.focus("#stage");
            await press(page, Array(12).fill("Control+z"), "undo", 0);
            assert.equal((await saved(page)).document.world.obstacles.length, 2);
          },
        ),

        "a polygon in another one is cut out of it, and the robot plans in the hole; the hole is changed and filled":
          onPlain(
            async (page, at) => {
              await page.click("#edit-tools >> text=Rectangle");
              await drag(page, [at(-0.5, -0.5), at(0.5, 0.5)], 1);
              await until(page, "touching", /** @type {string} */ ((await told(page)).touching));
              assert.match((await told(page)).touching ?? "", /start is in collision/);
              await page.click("#edit-hole >> text=Cut as a hole");
              await until(page, "title", "Obstacle 0, a polygon, hole 0, vertex 0");
              await until(page, "touching", "");
              assert.equal((await finish(page)).status, "solved");
              const { document: made } = await saved(page);
              assert.equal(made.world.obstacles.length, 1);
              assert.equal(polygonAt(made, 0).holes?.[0].length, 4);
              await page.focus("#stage");
              await press(page, ["Shift+ArrowDown"], "undo", 3);
              await press(page, ["Insert"], "title", "Obstacle 0, a polygon, hole 0, vertex 1");
              const now = await plane(page, 1);
              await drag(page, [now(0.5, 0.5), now(0.6, 0.6)], 5);
              const [hole] = polygonAt((await saved(page)).document, 0).holes ?? [];
              assert.equal(hole.length, 5);
              assert.ok(hole.some(([x, y]) => Math.hypot(x - 0.6, y - 0.6) < 0.02));
              // Out of the outline: refused, and the hole returns.
              const then = await plane(page, 1);
              await page.mouse.move(...then(0.6, 0.6));
              await page.mouse.down();
              await page.mouse.move(...then(0.9, 0.9), { steps: 3 });
              await until(page, "busy", "true");
              await page.waitForFunction(() => (document.getElementById("editor")?.dataset.code ?? "") !== "");
              await press(page, ["Escape"], "busy", "false");
              await page.mouse.up();
              assert.equal((await told(page)).undo, "5");
              await page.click("#edit-hole >> text=Fill the hole");
              await until(page, "undo", 6);
              assert.match((await told(page)).touching ?? "", /start is in collision/);
              await page.focus("#stage");
              await press(page, ["h"], "code", "no-polygon-around");
              await press(page, Array(6).fill("Control+z"), "undo", 0);
            },
            world([{ type: "polygon", vertices: square(-0.7, 0.7) }], [-0.3, 0], [0.3, 0]),
          ),

        "holes and walls are drawn, hit where they are, copied, moved and exported": async (page) => {
          await openScenario(page, world(RING));
          const colour = () => pixelsOf(page, "workspace", "ground", "obstacle");
          const holed = await colour();
          assert.equal((await finish(page)).status, "solved");
          await openEditor(page, null);
          const at = await plane(page, 1);
          await page.mouse.click(...at(-0.2, 0));
          await until(page, "title", "");
          await page.mouse.click(...at(0.04, 0.2));
          await until(page, "title", "Obstacle 1, a wall");
          await page.mouse.click(...at(0.6, 0));
          await until(page, "title", "Obstacle 0, a polygon");
          await page.focus("#stage");
          await press(page, ["ArrowRight"], "undo", 1);
          await press(page, ["d"], "title", "Obstacle 2, a polygon");
          const { document } = await saved(page);
          assert.deepEqual(
            polygonAt(document, 0).holes?.[0].toSorted(([a, b], [c, d]) => a - c || b - d),
            [
              [-0.49, -0.5],
              [-0.49, 0.5],
              [0.51, -0.5],
              [0.51, 0.5],
            ],
          );
          assert.equal(polygonAt(document, 2).holes?.length, 1);
          await page.focus("#stage");
          await press(page, ["Delete", "[", "[", "Delete"], "undo", 4);
          await unfold(page, "export");
          const { text } = await take(page, "svg");
          assert.match(text, /<path d="M[^"]*ZM[^"]*Z"\/>/, "the outline and its hole");
          await page.focus("#stage");
          await press(page, Array(4).fill("Control+z"), "undo", 0);
          assert.match((await take(page, "svg")).text, /stroke-linecap="round"/, "the wall");
          await openScenario(page, world([{ type: "polygon", vertices: square(-0.7, 0.7) }]));
          assert.ok((await colour()) > 1.5 * holed, "the hole is empty");
        },

        "a start on a wall is named, and the wall hatched": async (page) => {
          await openScenario(page, world([RING[1]], [0.02, 0], [0.8, 0]));
          await openEditor(page, null);
          await until(page, "touching", "The start is in collision: the disc touches obstacle 0.");
          assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > 150);
          const at = await plane(page, 1);
          await drag(page, [at(0.02, 0), at(-0.5, 0)], 1);
          await until(page, "touching", "");
          assert.equal((await finish(page)).status, "solved");
        },

        "the bounds are dragged by an edge and a corner, typed, and moved by keys; the view follows": onPlain(
          async (page, at) => {
            await drag(page, [at(1, 0.1), at(0.9, 0.1)], 1);
            await until(page, "title", "Bounds, right edge");
            near(Number(await page.inputValue("#edit-right")), 0.9);
            const narrow = await plane(page, { min: [-1, -1], max: [0.9, 1] });
            // Beyond the pane.
            await drag(page, [narrow(-1, -1), narrow(-1.4, -1.5)], 2);
            await until(page, "title", "Bounds");
            const { document } = await saved(page);
            const { min, max } = document.world.bounds ?? assert.fail();
            near(min[0], -1.4, 0.02);
            near(min[1], -1.5, 0.02);
            near(max[0], 0.9);
            const wide = await plane(page, { min, max });
            await drag(page, [wide(0.5, 0.5), wide(0.5, 0.2)], 3);
            assert.equal((await told(page)).title, "Obstacle 0, a disc", "the view shows the new bounds");
            await page.click("#scene-fold > summary");
            await page.click("#edit-bounds");
            await until(page, "title", "Bounds");
            await enter(page, "#edit-top", "2");
            await until(page, "undo", 4);
            await page.focus("#stage");
            await press(page, ["PageDown"], "title", "Bounds, left edge");
            await press(page, ["Shift+ArrowLeft"], "undo", 5);
            await enter(page, "#edit-left", "5");
            await until(page, "code", "out-of-range");
            const { world: changed } = (await saved(page)).document;
            near(changed.bounds?.min[0] ?? NaN, min[0] - 0.1, 0.02);
            assert.equal(changed.bounds?.max[1], 2);
            await page.focus("#stage");
            await press(page, ["Delete"], "code", "missing-field");
            await press(page, Array(5).fill("Control+z"), "undo", 0);
            await plane(page, 1);
            assert.equal((await finish(page)).status, "solved");
          },
        ),

        "a new scene has the robot of choice and nothing else; undo restores the one before, and its planner serves":
          async (page) => {
            await page.click("#new-scene");
            await until(page, "undo", 1);
            await page.locator("#where", { hasText: "New scene" }).waitFor();
            await page.selectOption("#new-robot", "car");
            await page.click("#edit-new");
            await until(page, "undo", 2);
            await page.waitForSelector("body[data-scene=file]");
            const { document } = await saved(page);
            assert.deepEqual([document.world.obstacles, document.robot.type], [[], "car"]);
            assert.equal((await finish(page)).status, "solved");
            await assertFaultless(page, "a new scene");
            await page.focus("#stage");
            await press(page, ["Control+z", "Control+z"], "undo", 0);
            await page.waitForSelector("body[data-scene=stones]");
            assert.equal((await atRest(page)).status, "running");
            assert.equal(await page.textContent("#where"), "Two links among stones \u00b7 PRM");
          },
      },
      restage,
    ),
  ));
