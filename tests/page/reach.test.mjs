/** The page of the arm on a desk and on a phone: turned, led, moved and solved. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Robot } from "../../www/reach/robot.js";
import { Motion } from "../../www/reach/motion.js";
import { PHONE, isDeep, keys, pixelsOf, useBrowser, valueWithin } from "./browser.mjs";
import {
  choose,
  click,
  entryOf,
  linksOf,
  onReach,
  poseOf,
  press,
  put,
  putBack,
  rest,
  scenarioOf,
  solved,
  windowOf,
} from "./reach.mjs";
import { swipe } from "./editing.mjs";
import { inTurn } from "./turns.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

const TURNED = "a joint is turned by its number and by its slider, and a number out of range is refused";

const BETWEEN = "from A to B, the short way and the long way, it touches where the core says";

/** What the arm does on any device. @type {Record<string, (page: Page) => Promise<void>>} */
const ANYWHERE = {
  [TURNED]: async (page) => {
    const scenario = scenarioOf("islands");
    await put(page, "joint-1-number", "0.75");
    const q = await poseOf(page);
    assert.equal(q[1], 0.75);
    const [x, y] = scenario.endEffector(q);
    assert.equal(await page.innerText("#fact-tip"), `(${x.toFixed(2)}, ${y.toFixed(2)}) m`.replaceAll("-", "\u2212"));
    await press(page, "#joint-1", "ArrowRight");
    assert.ok((await poseOf(page))[1] > 0.75);
    const kept = await poseOf(page);
    await put(page, "joint-0-number", "9");
    assert.match(await page.innerText("#joint-0-reason"), /9 is above/);
    assert.deepEqual(await poseOf(page), kept);
  },

  "arrow keys lead the tip exactly where the core follows": async (page) => {
    await choose(page, "tentacle");
    const scenario = scenarioOf("tentacle");
    let q = Float64Array.from(await poseOf(page));
    const step = linksOf("tentacle").reduce((a, b) => a + b, 0) * 0.01;
    for (const [key, dx, dy] of /** @type {[string, number, number][]} */ ([
      ["ArrowUp", 0, step],
      ["ArrowLeft", -step, 0],
      ["Shift+ArrowDown", 0, -10 * step],
    ])) {
      const [x, y] = scenario.endEffector(q);
      const followed = scenario.follow(q, [x + dx, y + dy]);
      assert.ok(followed.reached);
      await press(page, "#stage", key);
      assert.deepEqual(await poseOf(page), [...followed.configuration]);
      q = Float64Array.from(followed.configuration);
    }
  },

  "the nearest point, what touches and a singular arm are shown and said": async (page) => {
    const scenario = scenarioOf("islands");
    await put(page, "joint-0-number", "0");
    await put(page, "joint-1-number", "0.02");
    const [x, y] = scenario.endEffector([0, 0.02]);
    await press(page, "#stage", "Shift+ArrowRight");
    assert.equal(await page.getAttribute("#stage", "data-reached"), "false");
    const nearest = scenario.nearestReachable([x + 0.1 * 1.12, y]);
    assert.ok(nearest.distance > 0.05);
    assert.ok(
      (await page.innerText("#story")).includes(`${nearest.distance.toFixed(2)} m away`),
      await page.innerText("#story"),
    );
    await keys(page, "Shift+ArrowLeft", "Shift+ArrowLeft");
    await page.waitForSelector("#stage[data-reached=true]");
    const before = await pixelsOf(page, "workspace", "top", "collision");
    assert.equal(before, 0);
    await put(page, "joint-0-number", "0.78");
    await put(page, "joint-1-number", "0");
    assert.equal(await page.getAttribute("#stage", "data-free"), "false");
    const { touching } = scenario.check([0.78, 0]);
    for (const { part, obstacle } of touching)
      assert.match(
        await page.innerText("#fact-collision"),
        new RegExp(`link ${part + 1} touches obstacle ${obstacle}`, "i"),
      );
    assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > 200);
    assert.equal(await page.getAttribute("#stage", "data-singular"), "true");
    assert.equal(await page.innerText("#fact-isotropy"), "0.00");
    await put(page, "joint-0-number", "-0.8");
    assert.match(await page.innerText("#story"), /Nearly singular/);
  },

  [BETWEEN]: async (page) => {
    await click(page, "#mode-between");
    const { a, b } = entryOf("islands");
    const motionOf = (/** @type {import("../../www/reach/motion.js").Direction} */ direction) =>
      new Motion(new Robot(entryOf("islands").document, a), a, b, [direction, direction]);
    assert.equal(await page.getAttribute("#between", "data-hit"), String(motionOf("short").hit ?? "none"));
    assert.deepEqual(await poseOf(page), a);
    await click(page, "#all-long");
    assert.equal(await page.getAttribute("#between", "data-hit"), String(motionOf("long").hit ?? "none"));
    assert.match(await page.innerText("#story"), /long way round/);
    for (let i = 0; i < 3; i++) await click(page, "#between-step-10");
    assert.equal(await page.inputValue("#along"), "0.3");
    assert.ok((await pixelsOf(page, "workspace", "top", "path")) > 100);
    await page.fill("#between-speed", "100");
    await page.click("#between-play");
    await valueWithin(page, "along", 0.9999);
    await rest(page);
    const wrapped = (await poseOf(page)).map((angle, i) => Math.abs(Math.sin((angle - b[i]) / 2)));
    assert.ok(
      wrapped.every((off) => off < 1e-9),
      `it ends at B: ${wrapped}`,
    );
    assert.equal(await page.getAttribute("#between-play", "data-playing"), "false");
  },

  "inverse kinematics is the core's run, step by step, with its solutions": async (page) => {
    await click(page, "#mode-solve");
    const { q, target } = entryOf("islands");
    const run = scenarioOf("islands").reach({
      target,
      start: q,
      method: "damped-least-squares",
      solutions: 8,
      restarts: 40,
      seed: 0,
    });
    await click(page, "#solve-step-1");
    assert.equal(await page.getAttribute("#solve", "data-iterations"), "1");
    run.step(1);
    assert.deepEqual(await poseOf(page), [...run.configuration()]);
    assert.ok((await pixelsOf(page, "workspace", "top", "goal")) > 30, "the target is a cross");
    await solved(page);
    while (run.step(100) === "running");
    assert.equal(await page.getAttribute("#solve", "data-fingerprint"), run.fingerprint());
    assert.equal(await page.getAttribute("#solve", "data-solutions"), String(run.solutionCount));
    assert.equal(run.solutionCount, 2, "an elbow on either side");
    assert.equal(
      await page.innerText("#story"),
      `Two configurations reach the target; ${(await page.getAttribute("#solve", "data-free")) === "2" ? "neither collides" : "1 of them is collision-free"}.`,
    );
    assert.equal(await page.locator("#solutions button").count(), 2);
    await click(page, "#solutions button >> nth=1");
    assert.deepEqual(await poseOf(page), [...run.solutionsSince(1)].slice(0, 2));
    await page.waitForSelector("#charts .line path");
    assert.match((await page.getAttribute("#charts svg", "aria-label")) ?? "", /iterations/);
  },
};

/** A phone adds its size, which these two show. */
const { [TURNED]: turns, [BETWEEN]: moves } = ANYWHERE;

test("on a desktop the arm is turned, led, moved and solved", (t) => onReach(inTurn(t, ANYWHERE, putBack)));

test("on a phone it is, too", (t) =>
  onReach(
    inTurn(
      t,
      {
        ...(isDeep ? ANYWHERE : { [TURNED]: turns, [BETWEEN]: moves }),
        "a finger at the tip drags it, and elsewhere leaves the page to be scrolled": async (page) => {
          const before = await poseOf(page);
          const scenario = scenarioOf("islands");
          const [x, y] = await windowOf(page, "islands", scenario.endEffector(before));
          const [fx, fy] = await windowOf(page, "islands", [-0.2, -0.9]);
          const prevented = await page.locator("#workspace canvas[data-layer=top]").evaluate(
            (canvas, places) =>
              places.map(([clientX, clientY]) => {
                const touch = new Touch({ identifier: 1, target: canvas, clientX, clientY });
                return !canvas.dispatchEvent(
                  new TouchEvent("touchstart", { touches: [touch], cancelable: true, bubbles: true }),
                );
              }),
            [
              [x, y],
              [fx, fy],
            ],
          );
          assert.deepEqual(prevented, [true, false]);
          await swipe(page, [
            [x, y],
            [x - 20, y + 30],
          ]);
          await rest(page);
          assert.notDeepEqual(await poseOf(page), before);
        },
      },
      putBack,
    ),
    PHONE,
  ));
