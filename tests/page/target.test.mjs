/** The end effector in the editor, targets in the place of goals, and the robot moved by hand. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario } from "planarium";
import {
  MOBILE,
  atRest,
  click,
  counters,
  fill,
  finish,
  isDeep,
  onPausedPage,
  openScenario,
  pixelsOf,
  textMatches,
  useBrowser,
  valueWithin,
  violations,
} from "./browser.mjs";
import { drag, enter, near, openEditor, plane, press, saved, swipe, told, until } from "./editing.mjs";
import { endsOf, textOf } from "./library.mjs";
import { inTurn, restage } from "./turns.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("../../www/domain/types.js").ScenarioDocument} ScenarioDocument */

useBrowser();

/** Three links in a square world with a disc. @type {ScenarioDocument} */
const ARM = {
  format: "planarium-scenario-1",
  name: "arm",
  title: "Arm",
  world: { bounds: { min: [-2, -2], max: [2, 2] }, obstacles: [{ type: "disc", center: [0, 1.2], radius: 0.25 }] },
  robot: { type: "arm", base: [0, 0], links: [0.7, 0.6, 0.5], radius: 0.02 },
  queries: [{ name: "q", start: [2.4, 0.5, 0.3], goal: [0.2, 0.6, 0.4] }],
};

/**
 * Where the end effector is.
 * @param {ScenarioDocument} document
 * @param {ArrayLike<number>} pose
 * @returns {[number, number]}
 */
function tipOf(document, pose) {
  const scenario = Scenario.parse(document);
  const [x, y] = scenario.endEffector(Float64Array.from(pose));
  scenario.free();
  return [x, y];
}

/** How far each joint is turned between two poses at most. @param {number[]} a @param {number[]} b */
const turned = (a, b) =>
  Math.max(...a.map((angle, i) => Math.abs(Math.atan2(Math.sin(b[i] - angle), Math.cos(b[i] - angle)))));

/**
 * On a phone a finger does what the pointer does: in a usual run one test shows it.
 * @param {string} device
 * @param {Record<string, import("./turns.mjs").Act>} acts
 */
const ofDevice = (device, acts) =>
  isDeep || device === "a desktop"
    ? acts
    : Object.fromEntries(Object.entries(acts).filter(([name]) => name.includes("a goal is made a target")));

for (const [device, options, pull] of /** @type {const} */ ([
  ["a desktop", {}, drag],
  ["a phone", MOBILE, swipe],
])) {
  test(`on ${device}, start, goal and target are dragged`, (t) =>
    onPausedPage(
      inTurn(
        t,
        ofDevice(device, {
          [`on ${device}, start and goal follow the end effector without a jump; undo brings them back`]: async (
            page,
          ) => {
            await openEditor(page, ARM);
            let at = await plane(page, 2);
            const [from, goal] = endsOf(ARM.queries[0]);
            await pull(page, [at(...tipOf(ARM, goal)), at(1, -0.4)], 1);
            assert.equal((await told(page)).title, "Goal, end effector");
            let { document } = await saved(page);
            const [, led] = endsOf(document.queries[0]);
            tipOf(document, led).forEach((value, i) => near(value, [1, -0.4][i], 0.02));
            assert.ok(turned(goal, led) < 2.2, `${led}`);
            assert.deepEqual(document.queries[0].start, from, "the start stays");
            // Saving scrolls to its button.
            at = await plane(page, 2);
            await pull(page, [at(...tipOf(ARM, from)), at(-1, -0.6)], 2);
            ({ document } = await saved(page));
            tipOf(document, document.queries[0].start).forEach((value, i) => near(value, [-1, -0.6][i], 0.02));
            await page.locator("#edit-tools button", { hasText: "Undo" }).click();
            await until(page, "undo", 1);
            assert.deepEqual((await saved(page)).document.queries[0].start, from);
            assert.deepEqual(await violations(page), []);
            at = await plane(page, 2);
            await pull(page, [at(1, -0.4), at(1.2, 0), at(1.9, -0.95)], 2);
            ({ document } = await saved(page));
            const [x, y] = tipOf(document, endsOf(document.queries[0])[1]);
            near(Math.hypot(x, y), 1.8, 0.01);
            near(Math.atan2(y, x), Math.atan2(-0.95, 1.9), 0.03);
          },

          [`on ${device}, a goal is made a target: any pose will do, it is dragged, and is a pose again`]: async (
            page,
          ) => {
            await openEditor(page, ARM);
            const tip = tipOf(ARM, endsOf(ARM.queries[0])[1]);
            await page.locator("#stage").press("]");
            await page.locator("#stage").press("]");
            await page.waitForFunction(
              () =>
                document.getElementById("edit-retarget")?.textContent === "Allow any configuration" &&
                !document.getElementById("edit-retarget")?.hidden,
            );
            await page.click("#edit-retarget");
            await until(page, "title", "Target");
            const first = (await saved(page)).document.queries[0];
            assert.equal(first.goal, undefined);
            first.target?.point.forEach((value, i) => near(value, tip[i], 1e-5));
            const vertices = (await counters(page)).vertices;
            assert.ok(vertices > 2, "the start and several goals");
            const at = await plane(page, 2);
            await pull(page, [at(...tip), at(-0.3, -1.1)], 2);
            const { target } = (await saved(page)).document.queries[0];
            target?.point.forEach((value, i) => near(value, [-0.3, -1.1][i], 0.02));
            const ended = await finish(page);
            assert.equal(ended.status, "solved");
            await page.evaluate(() => {
              /** @type {HTMLDetailsElement} */ (document.getElementById("editor-fold")).open = true;
            });
            await page.click("#edit-retarget");
            await until(page, "title", "Goal");
            const again = (await saved(page)).document;
            assert.equal(again.queries[0].target, undefined);
            tipOf(again, endsOf(again.queries[0])[1]).forEach((value, i) => near(value, target?.point[i] ?? NaN, 1e-6));
          },

          [`on ${device}, an unreachable or blocked target is said at once, and planning waits`]: async (page) => {
            await openEditor(page, {
              ...ARM,
              queries: [{ name: "q", start: [2.4, 0.5, 0.3], target: { point: [1, 0.5] } }],
            });
            const at = await plane(page, 2);
            await pull(page, [at(1, 0.5), at(1.8, 1.8)], 1);
            assert.match((await told(page)).touching ?? "", /cannot reach.*nearest point that it can is \(1\.27/);
            await pull(page, [at(1.8, 1.8), at(0, 1.2)], 2);
            assert.match((await told(page)).touching ?? "", /in collision/);
            await pull(page, [at(0, 1.2), at(0.9, -0.7)], 3);
            assert.equal((await told(page)).touching, "");
            assert.equal((await finish(page)).status, "solved");
          },
        }),
        restage,
      ),
      options,
    ));
}

test("end effectors and poses by keys, by hand and in the square", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "the end effector is one more joint: Page Up picks it, arrows move it, fields put it": async (page) => {
          await openEditor(page, ARM);
          await page.focus("#stage");
          await press(page, ["]", "PageUp"], "title", "Start, end effector");
          const tip = tipOf(ARM, ARM.queries[0].start);
          await press(page, ["Shift+ArrowUp"], "undo", 1);
          const up = tipOf(ARM, (await saved(page)).document.queries[0].start);
          near(up[0], tip[0], 1e-3);
          assert.ok(up[1] > tip[1] + 0.05, `${up}`);
          await enter(page, "#edit-x", "-0.5");
          await until(page, "undo", 2);
          near(tipOf(ARM, (await saved(page)).document.queries[0].start)[0], -0.5, 1e-3);
        },

        "a target is moved by arrows and by numbers": async (page) => {
          await openEditor(page, {
            ...ARM,
            queries: [{ name: "q", start: [2.4, 0.5, 0.3], target: { point: [1, 0.5], orientation: 0.5 } }],
          });
          await page.focus("#stage");
          await press(page, ["]", "]"], "title", "Target");
          await press(page, ["ArrowLeft"], "undo", 1);
          await enter(page, "#edit-y", "0.25");
          await until(page, "undo", 2);
          const { target } = (await saved(page)).document.queries[0];
          assert.ok(target && target.point[0] < 1 && target.point[0] > 0.9);
          assert.deepEqual([target.point[1], target.orientation], [0.25, 0.5]);
        },

        "in the reader's hand the arm is led by its end, and arrives at a target": async (page) => {
          await openScenario(page, {
            ...ARM,
            queries: [{ name: "q", start: [2.4, 0.5, 0.3], target: { point: [-0.5, -1.2] } }],
          });
          await click(page, "#your-turn");
          const at = await plane(page, 2);
          await drag(page, [at(...tipOf(ARM, ARM.queries[0].start)), at(-1.3, -0.2), at(-1, -0.9), at(-0.5, -1.2)]);
          await textMatches(page, "#story", /^You reached the goal without a collision/);
        },

        "a pose in collision is red and says what touches; the goal, reached by hand, is announced": async (page) => {
          const pose = async (/** @type {number[]} */ q) => {
            for (const [i, angle] of q.entries()) await fill(page, `#pose-${i}-number`, String(angle));
          };
          await click(page, "#your-turn");
          assert.equal(await page.getAttribute("#touching", "data-free"), "true");
          assert.equal(await pixelsOf(page, "workspace", "top", "collision"), 0);
          await pose([0.7, 0]);
          await page.waitForSelector("#touching[data-free=false]");
          assert.match(await page.innerText("#touching"), /link 2 touches obstacle 0/i);
          assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > 100);
          await click(page, "#your-turn");
          assert.equal(await pixelsOf(page, "workspace", "top", "collision"), 0);
          await page.click("#your-turn");
          await pose(JSON.parse(textOf("stones")).queries[0].goal);
          await textMatches(page, "#story", /reached the goal/);
        },

        "a point of the configuration square is a pose, a link that is dragged turns its joint": async (page) => {
          const square = (await page.locator("#cspace canvas[data-layer=top]").boundingBox()) ?? assert.fail();
          const at = (/** @type {number} */ x, /** @type {number} */ y) =>
            /** @type {[number, number]} */ ([square.x + square.width * x, square.y + square.height * y]);
          await page.mouse.click(...at(1 / 2, 1 / 3));
          await valueWithin(page, "pose-1-number", 0.5, 1.6);
          await drag(page, [at(1 / 2, 1 / 3), at(0.7, 0.6)]);
          await valueWithin(page, "pose-0-number", 0.5, 7);
          for (const i of [0, 1]) await fill(page, `#pose-${i}-number`, "0");
          await atRest(page);
          const [x, y] = (await plane(page, 1.2))(0, 0);
          await drag(page, [
            [x + 60, y],
            [x + 40, y - 40],
          ]);
          await valueWithin(page, "pose-0-number", Math.PI / 4 - 0.1, Math.PI / 4 + 0.1);
        },
      },
      restage,
    ),
  ));
