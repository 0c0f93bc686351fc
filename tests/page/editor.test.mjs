/** The editor under a pointer and a finger; what is refused. */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  MOBILE,
  alphaOf,
  atRest,
  choosePlanner,
  counters,
  finish,
  onPage,
  onPausedPage,
  openScenario,
  passes,
  pixelsOf,
  setParameter,
  textMatches,
  useBrowser,
} from "./browser.mjs";
import { drag, near, openEditor, plane, press, saved, swipe, told, until } from "./editing.mjs";
import { endsOf, textOf } from "./library.mjs";
import { inTurn, restage } from "./turns.mjs";
import { PLAIN, onPlain, onStones } from "./editing-scenes.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("../../www/domain/types.js").ScenarioDocument} ScenarioDocument */

useBrowser();

/**
 * Does the picture of the configuration space show an obstacle at two angles?
 * @param {Page} page
 * @param {number} across
 * @param {number} up
 */
async function isBlocked(page, across, up) {
  const { width, height, alpha } = await alphaOf(page, "cspace", "ground");
  const ratio = await page.evaluate(() => devicePixelRatio);
  const x = 34 * ratio + ((across + Math.PI) / (2 * Math.PI)) * (width - 46 * ratio);
  const y = 12 * ratio + ((Math.PI - up) / (2 * Math.PI)) * (height - 44 * ratio);
  return alpha[Math.round(y) * width + Math.round(x)] > 128;
}

test("the editor under a pointer", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "the roadmap of a lazy planner is repaired while an obstacle is dragged, and when that is undone": async (
          page,
        ) => {
          await openScenario(page, PLAIN);
          await choosePlanner(page, "lazy-prm", "samples");
          await setParameter(page, "samples", "300");
          const before = await finish(page);
          await openEditor(page, null);
          const at = await plane(page, 1);
          await drag(page, [at(0.5, 0.5), at(0.2, 0.2), at(0, 0.05)], 1);
          const after = await atRest(page);
          assert.deepEqual([after.status, after.vertices, after.phase], ["solved", before.vertices, "done"]);
          assert.ok(after.length > before.length, "the disc is in the way now");
          await drag(page, [at(0, 0.05), at(-0.8, 0.7)], 2);
          await textMatches(page, "#story", /start is in collision/);
          await press(page, ["Control+z"], "undo", 1);
          const undone = await atRest(page);
          assert.deepEqual([undone.status, undone.length], ["solved", after.length]);
        },

        "things, their handles and vertices are dragged; each gesture is one edit": onPlain(async (page, at) => {
          for (const [i, [from, to]] of /** @type {[number, number][][]} */ ([
            [
              [0.5, 0.5],
              [0.2, 0.6],
            ],
            [
              [0.35, 0.6],
              [0.45, 0.6],
            ],
            [
              [-0.3, 0],
              [-0.4, -0.3],
            ],
            [
              [-0.4, 0],
              [-0.4, 0.2],
            ],
            [
              [-0.4, -0.5],
              [-0.4, -0.7],
            ],
            [
              [-0.8, 0.7],
              [-0.7, 0.8],
            ],
            [
              [0.8, -0.7],
              [0.6, -0.7],
            ],
          ]).entries()) {
            await drag(page, [at(...from), at(...to)], i + 1);
          }
          const {
            document: { world, queries },
            text,
          } = await saved(page);
          const [disc, polygon] = world.obstacles;
          assert.ok(disc.type === "disc" && polygon.type === "polygon");
          disc.center.forEach((value, k) => near(value, [0.2, 0.6][k]));
          near(disc.radius, 0.25);
          assert.equal(polygon.vertices.length, 4, "a middle that is dragged becomes a vertex");
          [
            [-0.7, -0.5],
            [-0.4, -0.7],
            [-0.1, -0.5],
            [-0.4, 0.2],
          ].forEach((point, i) => point.forEach((value, k) => near(polygon.vertices[i][k], value, 0.02)));
          near(queries[0].start[0], -0.7);
          near(endsOf(queries[0])[1][0], 0.6);
          for (const number of text.match(/-?\d+\.\d+/g) ?? [])
            assert.ok(number.replace(/^.*\./, "").length <= 4, `${number} is readable`);
          assert.deepEqual(
            { ...(await counters(page)), fingerprint: "", length: 0 },
            { status: "running", phase: "sampling", iterations: 0, vertices: 2, edges: 0, fingerprint: "", length: 0 },
          );
        }),

        "discs, rectangles and polygons are drawn; Shift snaps": onPlain(async (page, at) => {
          await page.click("#edit-tools >> text=Disc");
          await drag(page, [at(0.1, -0.6), at(0.3, -0.6)], 1);
          await until(page, "tool", "select");
          await page.click("#edit-tools >> text=Rectangle");
          await drag(page, [at(0.3, 0), at(0.6, -0.15)], 2);
          await page.click("#edit-tools >> text=Rectangle");
          await drag(page, [at(-0.9, -0.4), at(-0.7, -0.5)], 3, "Shift");
          for (const [i, close] of [
            [4, "first"],
            [5, "double"],
            [6, "Enter"],
          ]) {
            await page.click("#edit-tools >> text=Polygon");
            const y = 0.45 + 0.15 * (Number(i) - 4);
            for (const point of [at(-0.6, y), at(-0.4, y), at(-0.5, y + 0.1)]) await page.mouse.click(...point);
            if (close === "first") await page.mouse.click(...at(-0.6, y));
            else if (close === "double") await page.mouse.click(...at(-0.5, y + 0.1));
            else await page.keyboard.press("Enter");
            await until(page, "undo", i);
          }
          // The dots of this sheet are half a metre apart.
          await drag(page, [at(0.1, -0.6), at(0.17, -0.63)], 7, "Shift");
          const {
            document: {
              world: { obstacles },
            },
          } = await saved(page);
          assert.deepEqual(
            obstacles.map(({ type }) => type),
            ["disc", "polygon", "disc", "polygon", "polygon", "polygon", "polygon", "polygon"],
          );
          const [, , disc, wide, square, ...drawn] = obstacles;
          assert.ok(disc.type === "disc" && wide.type === "polygon" && square.type === "polygon");
          near(disc.radius, 0.2);
          for (const value of disc.center)
            assert.ok(Math.abs(value / 0.1 - Math.round(value / 0.1)) < 1e-9, `${value} is on the grid`);
          const side = (/** @type {[number, number][]} */ [[ax, ay], , [cx, cy]]) => [cx - ax, cy - ay];
          near(side(wide.vertices)[0], 0.3);
          near(side(wide.vertices)[1], 0.15);
          near(side(square.vertices)[0], 0.2);
          assert.ok(Math.abs(side(square.vertices)[0] - side(square.vertices)[1]) < 1e-9, "Shift makes a square");
          for (const polygon of drawn) assert.equal(polygon.type === "polygon" && polygon.vertices.length, 3);
        }),

        "an arm's start follows its links, by fifteen degrees with Shift, and in the square its point": onStones(
          async (page, at) => {
            const {
              queries: [{ start: pose }],
            } = JSON.parse(textOf("stones"));
            const elbow = [0.62 * Math.cos(pose[0]), 0.62 * Math.sin(pose[0])];
            const on = (/** @type {number} */ angle) =>
              at(elbow[0] + 0.4 * Math.cos(angle), elbow[1] + 0.4 * Math.sin(angle));
            await drag(page, [on(pose[0] + pose[1]), on(pose[0] + pose[1] + 0.2)], 1);
            assert.equal((await told(page)).title, "Start, joint 2");
            let { document } = await saved(page);
            assert.equal(document.queries[0].start[0], pose[0]);
            near(document.queries[0].start[1], pose[1] + 0.2, 0.02);
            await drag(page, [on(pose[0] + pose[1] + 0.2), on(pose[0] - 0.3)], 2, "Shift");
            near(Number(await page.inputValue("#edit-joint-2")), -Math.PI / 12, 1e-4);
            const square = await page.locator("#cspace canvas[data-layer=top]").boundingBox();
            assert.ok(square);
            const point = (/** @type {number} */ a, /** @type {number} */ b) =>
              /** @type {[number, number]} */ ([
                square.x + 34 + ((a + Math.PI) / (2 * Math.PI)) * (square.width - 46),
                square.y + 12 + ((Math.PI - b) / (2 * Math.PI)) * (square.height - 44),
              ]);
            await drag(
              page,
              [point(.../** @type {[number, number]} */ (endsOf(document.queries[0])[1])), point(-2, 1)],
              3,
            );
            ({ document } = await saved(page));
            near(endsOf(document.queries[0])[1][0], -2, 0.03);
            near(endsOf(document.queries[0])[1][1], 1, 0.03);
          },
        ),

        "what the core refuses is shown with its reason while it is held, and returns when let go": onPlain(
          async (page, at) => {
            await page.mouse.click(...at(-0.3, 0));
            await until(page, "kind", "polygon");
            await page.mouse.move(...at(0, 0.3));
            await page.mouse.down();
            // Across the opposite edge, at once.
            await page.mouse.move(...at(-0.3, -0.6));
            await until(page, "code", "degenerate-polygon");
            await textMatches(page, "#story", /cross/);
            assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > 20, "the refused shape is drawn");
            await page.mouse.up();
            await until(page, "busy", "false");
            assert.equal((await told(page)).undo, "0");
            assert.match(await page.innerText("#edit-reason"), /cross/);
            // A polygon whose sides cross is not closed, and its corners stay for correction.
            await page.click("#edit-tools >> text=Polygon");
            for (const point of [at(0.2, 0.2), at(0.6, 0), at(0.6, 0.2), at(0.2, 0)]) await page.mouse.click(...point);
            await page.keyboard.press("Enter");
            await textMatches(page, "#story", /cross/);
            assert.equal((await told(page)).code, "degenerate-polygon");
            assert.equal((await told(page)).undo, "0");
            await press(page, ["Backspace", "Enter"], "undo", 1);
            const {
              document: { world },
            } = await saved(page);
            assert.equal(world.obstacles.length, 3);
            assert.deepEqual(world.obstacles[1], BOX);
          },
          { ...PLAIN, world: { ...PLAIN.world, obstacles: [PLAIN.world.obstacles[0], BOX] } },
        ),

        "Escape cancels a gesture, an obstacle stays on the sheet, nothing covers the arm's base": onStones(
          async (page, at) => {
            await page.mouse.move(...at(0.62, 0.5));
            await page.mouse.down();
            await page.mouse.move(...at(0.8, -0.8), { steps: 4 });
            await press(page, ["Escape"], "busy", "false");
            await page.mouse.up();
            assert.equal((await told(page)).undo, "0");
            assert.equal(await page.getAttribute("body", "data-scene"), "stones");
            await page.click("#edit-tools >> text=Disc");
            await page.mouse.click(...at(0, 0));
            await until(page, "code", "base-in-collision");
            await page.click("#edit-tools >> text=Select");
            await drag(page, [at(0.62, 0.5), [5, 5]], 1);
            const {
              document: {
                world: {
                  obstacles: [stone],
                },
              },
            } = await saved(page);
            assert.ok(
              stone.type === "polygon" && stone.vertices.every(([x, y]) => Math.abs(x) < 1.8 && Math.abs(y) < 1.8),
            );
          },
        ),

        "a start in collision is marked and named, planning is refused, and continues once it is moved": onPlain(
          async (page, at) => {
            await drag(page, [at(0.5, 0.5), at(-0.75, 0.7)]);
            await until(page, "touching", "The start is in collision: the disc touches obstacle 0.");
            await textMatches(page, "#story", /start is in collision: the disc touches obstacle 0/);
            assert.equal((await counters(page)).status, "none");
            assert.ok(await page.isDisabled("#play"));
            assert.ok(await page.isHidden("#notice"), "said where the hand is, not above the stage");
            assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > 150);
            // With the editor closed the page shows a notice; with the editor open again the start can be moved.
            await page.click("#edit[aria-pressed=true]");
            await page.waitForSelector("#notice[data-code=start-in-collision]");
            await page.click("#edit[aria-pressed=false]");
            await until(page, "touching", "The start is in collision: the disc touches obstacle 0.");
            const again = await plane(page, 1);
            await drag(page, [again(-0.8, 0.7), again(-0.3, 0.7)]);
            await until(page, "touching", "");
            await page.waitForSelector("#notice", { state: "hidden" });
            assert.equal((await finish(page)).status, "solved");
          },
        ),
      },
      restage,
    ),
  ));

/** @type {ScenarioDocument["world"]["obstacles"][number]} */
const BOX = {
  type: "polygon",
  vertices: [
    [-0.6, -0.2],
    [0, -0.2],
    [0, 0.3],
    [-0.6, 0.3],
  ],
};

test("planning restarts and waits until someone plays; the configuration space follows the hand", () =>
  onPage({}, async (page) => {
    await passes(page, 5);
    await openEditor(page, null);
    await page.waitForSelector("#play[data-playing=false]");
    const at = await plane(page, 1.2);
    // Both links stretched out towards the stone.
    const blocked = () => isBlocked(page, Math.atan2(0.5, 0.62), 0);
    assert.ok(await blocked());
    await page.mouse.move(...at(0.62, 0.5));
    await page.mouse.down();
    await page.mouse.move(...at(1.1, 1.1), { steps: 6 });
    await page.waitForSelector("#counters[data-iterations='0'][data-settled=true]", { state: "attached" });
    assert.ok(!(await blocked()), "free while the stone is held elsewhere");
    await page.mouse.up();
    await until(page, "undo", 1);
    assert.ok(!(await blocked()));
    assert.equal((await atRest(page)).iterations, 0, "it waits");
    assert.equal(await page.getAttribute("#play", "data-playing"), "false");
    assert.equal(await page.getAttribute("body", "data-scene"), "file");
    await page.click("#play");
    await passes(page, 5);
  }));

test("a finger draws and drags, the tools stand above the stage and are large enough", () =>
  onPausedPage(async (page) => {
    await openEditor(page, PLAIN);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "nothing sticks out");
    const above = await page.evaluate(() => document.getElementById("stage")?.previousElementSibling?.id);
    assert.equal(above, "edit-tools");
    for (const box of await page
      .locator("#edit-tools button")
      .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().height)))
      assert.ok(box >= 44);
    const at = await plane(page, 1);
    // A finger that is 12 px off the disc's radius handle still takes it.
    await page.touchscreen.tap(...at(0.5, 0.5));
    await until(page, "title", "Obstacle 0, a disc");
    const [x, y] = at(0.65, 0.5);
    await swipe(page, [[x + 12, y], at(0.8, 0.5)], 1);
    near(Number(await page.inputValue("#edit-radius")), 0.3, 0.02);
    await page.tap("#edit-tools >> text=Rectangle");
    const now = await plane(page, 1);
    await swipe(page, [now(0, -0.5), now(0.3, -0.8)], 2);
    await page.tap("#edit-tools >> text=Polygon");
    const then = await plane(page, 1);
    for (const point of [then(-0.8, -0.8), then(-0.3, -0.8), then(-0.3, -0.4), then(-0.8, -0.8)])
      await page.touchscreen.tap(...point);
    await until(page, "undo", 3);
    assert.ok((await pixelsOf(page, "workspace", "top", "ink")) > 100, "what is selected shows its handles");
    const { document: kept } = await saved(page);
    assert.deepEqual(
      kept.world.obstacles.map((one) => (one.type === "polygon" ? one.vertices.length : 1)),
      [1, 3, 4, 3],
    );
    await page.tap("#editor-fold > summary");
    await page.waitForFunction(() => document.getElementById("edit-tools")?.parentElement?.id === "editor");
  }, MOBILE));
