/** The robot in the editor: its type, numbers and shape. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { rectangleBetween } from "../../www/domain/obstacles.js";
import { MOBILE, finish, onPausedPage, textMatches, useBrowser } from "./browser.mjs";
import { drag, enter, near, openEditor, plane, press, saved, swipe, until } from "./editing.mjs";
import { PLAIN, onPlain } from "./editing-scenes.mjs";
import { assertFaultless } from "./looks.mjs";
import { inTurn, restage } from "./turns.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("../../www/domain/types.js").ScenarioDocument} ScenarioDocument */

useBrowser();

/** The plain world with a body in it. @type {ScenarioDocument} */
const BODY = {
  ...PLAIN,
  robot: {
    type: "rigid_body",
    shape: rectangleBetween([-0.1, -0.05], [0.1, 0.05]),
  },
  queries: [{ name: "across", start: [-0.7, 0.7, 0], goal: [0.7, -0.7, 0] }],
};

/** Opens the part of the robot. @param {Page} page */
const unfoldRobot = (page) => page.click("#robot-fold > summary");

/** The robot as it is saved. @param {Page} page */
const robotOf = async (page) => (await saved(page)).document.robot;

/** Where a point of the shape is in the window. @param {Page} page @param {number} corner */
async function cornerOf(page, corner) {
  const box = await page.locator("#shape rect").nth(corner).boundingBox();
  assert.ok(box, "the figure shows its corners");
  return /** @type {[number, number]} */ ([box.x + box.width / 2, box.y + box.height / 2]);
}

test("the robot in the editor", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "a disc becomes a body, a car, an arm and a disc again; start and goal come along, and it is said how": onPlain(
          async (page) => {
            await unfoldRobot(page);
            await enter(page, "#edit-robot-radius", "0.08");
            await until(page, "undo", 1);
            assert.deepEqual(await robotOf(page), { type: "disc", radius: 0.08 });
            for (const [type, text, dimension] of /** @type {const} */ ([
              ["rigid_body", /keep x and y; their theta is 0/, 3],
              ["car", /keep x and y\.$/, 3],
              ["disc", /keep x and y\.$/, 2],
              ["arm", /All joints of start and goal are 0/, 2],
            ])) {
              await page.selectOption("#robot-type", type);
              await textMatches(page, "#robot-text", text);
              const { document } = await saved(page);
              assert.equal(document.robot.type, type);
              assert.equal(document.queries[0].start.length, dimension);
              if (type !== "arm") assert.deepEqual(document.queries[0].start.slice(0, 2), [-0.8, 0.7]);
              assert.equal(await page.locator("#pose input[type=range]").count(), dimension);
              if (type === "car") assert.equal((await finish(page)).status, "solved");
            }
            await page.focus("#stage");
            await press(page, Array(5).fill("Control+z"), "undo", 0);
            assert.deepEqual(await robotOf(page), PLAIN.robot);
            assert.equal((await finish(page)).status, "solved");
            await page.focus("#stage");
            await press(page, Array(2).fill("Control+Shift+Z"), "undo", 2);
            assert.equal(await page.inputValue("#robot-type"), "rigid_body");
          },
        ),

        "what the core refuses is said beside its field, and nothing changes": onPlain(async (page) => {
          await unfoldRobot(page);
          await page.selectOption("#robot-type", "car");
          await until(page, "undo", 1);
          const before = await robotOf(page);
          await enter(page, "#edit-wheelbase", "0");
          await until(page, "code", "out-of-range");
          await textMatches(page, "#edit-wheelbase-reason", /greater than 0/);
          assert.equal(await page.getAttribute("#edit-wheelbase", "aria-invalid"), "true");
          await page.click("#robot-fields summary");
          await enter(page, "#edit-speed-from", "3");
          await textMatches(page, "#edit-speed-from-reason", /lower limit 3/);
          assert.deepEqual(await robotOf(page), before);
          await enter(page, "#edit-speed-from", "0");
          await enter(page, "#edit-wheelbase", "0.11");
          await until(page, "undo", 3);
          assert.equal(await page.getAttribute("#edit-wheelbase", "aria-invalid"), null);
          const after = await robotOf(page);
          assert.ok(after.type === "car");
          assert.deepEqual([after.speed, after.wheelbase], [[0, 1], 0.11]);
        }),

        "a footprint is typed, its corners are dragged in the figure, moved by keys, added and deleted": onPlain(
          async (page) => {
            await unfoldRobot(page);
            await enter(page, "#edit-robot-length", "0.3");
            await enter(page, "#edit-robot-width", "0.16");
            await until(page, "undo", 2);
            let robot = await robotOf(page);
            assert.ok(robot.type === "rigid_body");
            assert.deepEqual(robot.shape.vertices[2], [0.15, 0.08]);
            await page.click("#robot-fold >> text=Shape");
            await page.locator("#shape").scrollIntoViewIfNeeded();
            const [x, y] = await cornerOf(page, 2);
            const scale = (x - (await cornerOf(page, 3))[0]) / 0.3;
            await drag(
              page,
              [
                [x, y],
                [x + 0.1 * scale, y],
              ],
              3,
            );
            await page.focus("#shape");
            await press(page, ["Shift+ArrowUp"], "undo", 4);
            await press(page, ["Insert"], "undo", 5);
            await enter(page, "#edit-corner-x", "-0.05");
            await enter(page, "#edit-corner-y", "0.2");
            await until(page, "undo", 7);
            robot = await robotOf(page);
            assert.ok(robot.type === "rigid_body");
            assert.equal(robot.shape.vertices.length, 5);
            near(robot.shape.vertices[2][0], 0.25, 0.005);
            assert.deepEqual(robot.shape.vertices[3], [-0.05, 0.2]);
            assert.match((await page.getAttribute("#shape", "aria-label")) ?? "", /corner 3 of 5/);
            // Across the opposite side: refused.
            await enter(page, "#edit-corner-y", "-0.2");
            await until(page, "code", "degenerate-polygon");
            await textMatches(page, "#edit-corner-y-reason", /cross/);
            await assertFaultless(page, "a shape being edited");
            await page.focus("#shape");
            await press(page, ["Delete"], "undo", 8);
            await page.click("#robot-box");
            await until(page, "undo", 9);
            robot = await robotOf(page);
            assert.ok(robot.type === "rigid_body");
            assert.equal(robot.shape.vertices.length, 4);
            const at = await plane(page, 1);
            await page.mouse.click(...at(-0.7 + 0.2, 0.7));
            await until(page, "title", "Start");
            assert.equal((await finish(page)).status, "solved");
          },
          BODY,
        ),

        "an arm gets links, lengths, a base, limits and a link that slides": async (page) => {
          await openEditor(page, null);
          await unfoldRobot(page);
          await enter(page, "#edit-links", "3");
          await until(page, "undo", 1);
          await textMatches(page, "#robot-text", /New joints of start and goal are 0/);
          assert.equal(await page.locator("#pose input[type=range]").count(), 3);
          await page.click("#robot-fields summary >> text=Link 3");
          await enter(page, "#edit-link-3", "0.25");
          await enter(page, "#edit-joint-3-from", "-1");
          await until(page, "undo", 3);
          await enter(page, "#edit-joint-3-to", "1");
          await until(page, "undo", 4);
          let robot = await robotOf(page);
          assert.ok(robot.type === "arm");
          assert.deepEqual([robot.links[2], robot.joints?.[2]], [0.25, { type: "revolute", limits: [-1, 1] }]);
          await page.selectOption("#edit-joint-3-type", "prismatic");
          await until(page, "undo", 5);
          assert.ok(await page.isVisible("#edit-joint-3-angle"), "its fold stays open");
          await enter(page, "#edit-joint-3-to", "0.2");
          await until(page, "undo", 6);
          await enter(page, "#edit-base-x", "0.1");
          await until(page, "undo", 7);
          robot = await robotOf(page);
          assert.ok(robot.type === "arm");
          assert.deepEqual(robot.joints?.[2], { type: "prismatic", range: [0, 0.2], angle: 0 });
          assert.deepEqual(robot.base, [0.1, 0]);
          await page.focus("#stage");
          await press(page, Array(7).fill("Control+z"), "undo", 0);
          await page.waitForSelector("body[data-scene=stones]");
        },

        "a margin is added and taken away": onPlain(async (page) => {
          await unfoldRobot(page);
          await enter(page, "#edit-margin", "0.04");
          await until(page, "undo", 1);
          assert.deepEqual(await robotOf(page), { type: "disc", radius: 0.05, margin: 0.04 });
          await enter(page, "#edit-margin", "0");
          await until(page, "undo", 2);
          assert.deepEqual(await robotOf(page), PLAIN.robot);
        }),
      },
      restage,
    ),
  ));

test("with a finger the shape is dragged and the bounds are", () =>
  onPausedPage(async (page) => {
    await openEditor(page, BODY);
    await unfoldRobot(page);
    await page.tap("#robot-fold >> text=Shape");
    await page.locator("#shape").evaluate((element) => element.scrollIntoView({ block: "center" }));
    const [x, y] = await cornerOf(page, 2);
    await swipe(
      page,
      [
        [x + 8, y],
        [x + 30, y],
      ],
      1,
    );
    const robot = await robotOf(page);
    assert.ok(robot.type === "rigid_body" && robot.shape.vertices[2][0] > 0.1);
    const at = await plane(page, 1);
    await swipe(page, [at(0.2, -1), at(0.2, -0.9)], 2);
    near((await saved(page)).document.world.bounds?.min[1] ?? NaN, -0.9, 0.03);
  }, MOBILE));
