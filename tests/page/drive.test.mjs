/** The keyboard car on the page: keys, buttons, numbers, stops, records, one control's way. */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  PHONE,
  chooseScene,
  download,
  onPage,
  onPausedPage,
  openScenario,
  pickFile,
  pixelsOf,
  pressUntil,
  reveal,
  textMatches,
  useBrowser,
  violations,
} from "./browser.mjs";
import { assertFaultless } from "./looks.mjs";
import { inTurn, restage } from "./turns.mjs";
import { car } from "../package/scenes.mjs";
import { ROAD, scenario } from "./road.mjs";

/** @import { Page } from "./browser.mjs" */

useBrowser();

/** What the bar says. @param {Page} page */
const dash = (page) =>
  page.locator("#drive").evaluate((bar) => {
    const { v, phi, x, y, theta, steps, keys, blocked, paused, replaying, arrived } = /** @type {HTMLElement} */ (bar)
      .dataset;
    return {
      v: Number(v),
      phi: Number(phi),
      pose: [x, y, theta].map(Number),
      steps: Number(steps),
      keys: Number(keys),
      blocked,
      paused,
      replaying,
      arrived,
    };
  });

/** Opens the road and drives. @param {Page} page */
async function drive(page) {
  await openScenario(page, ROAD);
  await takeWheel(page);
}

/** Drives on the open road. @param {Page} page */
async function takeWheel(page) {
  await textMatches(page, "#your-turn", /^Drive$/);
  await page.click("#your-turn");
  await page.waitForSelector("#drive:not([hidden])");
}

/** @param {Page} page @param {string[]} keys */
async function press(page, ...keys) {
  const before = (await dash(page)).keys;
  for (const key of keys) await page.keyboard.press(key);
  await page.waitForFunction(
    (count) => document.getElementById("drive")?.dataset.keys === String(count),
    before + keys.length,
  );
}

test("the keyboard car on the page", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "arrows and letters drive while the stage has the focus; numbers say how; Escape leaves": async (page) => {
          await drive(page);
          assert.equal(await page.evaluate(() => document.activeElement?.id), "stage");
          assert.deepEqual([(await dash(page)).pose, (await dash(page)).v], [[0.3, 0.5, 0], 0]);
          // Less motion is asked for: time goes by with each key alone.
          await press(page, "ArrowUp", "w", "ArrowLeft", "c");
          const { v, phi, steps } = await dash(page);
          assert.deepEqual([v, phi, steps], [0.2, Math.PI / 12, 100]);
          await press(page, "d", "s", "ArrowDown", "ArrowDown", "ArrowRight", "a");
          const back = await dash(page);
          assert.ok(Math.abs(back.v + 0.1) < 1e-12 && back.phi === 0);
          assert.match(await page.innerText("#drive dl"), /v\s+−0\.10 m\/s\s+φ\s+0°\s+x\s+0\.\d{3} m/);
          await page.focus("#planner");
          await page.keyboard.press("w");
          assert.equal((await dash(page)).keys, back.keys, "keys elsewhere are not the car's");
          await page.focus("#stage");
          await page.keyboard.press("Escape");
          await page.waitForSelector("#drive", { state: "hidden" });
          assert.equal(await page.evaluate(() => document.activeElement?.id), "your-turn");
          assert.ok(await page.isVisible("#transport"));
        },

        "it stops at an obstacle, says at which and marks it; axe finds nothing, and it backs off again": async (
          page,
        ) => {
          await drive(page);
          await press(page, ...Array.from({ length: 22 }, () => "w"));
          const stopped = await dash(page);
          assert.deepEqual([stopped.blocked, stopped.v], ["1", 0]);
          assert.ok(stopped.pose[0] > 1.39 && stopped.pose[0] < 1.4, `${stopped.pose}`);
          assert.match(await page.innerText("#story"), /Stopped: obstacle 1 is in the way/);
          assert.equal(await page.getAttribute("#story", "data-tone"), "bad");
          await textMatches(page, "#announcer", /obstacle 1/);
          assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > 60);
          await reveal(page, "#roll-v");
          await assertFaultless(page, "driving");
          await page.focus("#stage");
          await press(page, "s", "s");
          const { blocked, pose } = await dash(page);
          assert.equal(blocked, "");
          assert.ok(pose[0] < stopped.pose[0]);
        },

        "at the goal it says so; another scene ends the drive and leaves nothing behind": async (page) => {
          await drive(page);
          await press(page, "w", "w");
          while ((await dash(page)).pose[0] < 0.84) await press(page, "c");
          await press(page, "s", "s");
          await page.waitForSelector("#drive[data-arrived=true]");
          assert.match(await page.innerText("#story"), /You reached the goal after \d+\.\d s and \d+ keys\./);
          await chooseScene(page, "open");
          await page.waitForSelector("#drive", { state: "hidden" });
          assert.equal(await page.textContent("#your-turn"), "Your turn");
        },

        "a drive is replayed to the same place, and so is its file; another one is refused": async (page) => {
          await drive(page);
          await press(page, "w", "w", "ArrowLeft", "c", "ArrowRight", "c");
          const first = await dash(page);
          await page.click("#drive-replay");
          await textMatches(page, "#announcer", /^Replaying|was replayed/);
          assert.deepEqual(await dash(page), first);
          await reveal(page, "#roll-v");
          const record = JSON.parse((await download(page, "#drive-save")).text);
          assert.deepEqual(
            [record.format, record.scenario, record.steps, record.pose],
            ["planarium-drive-1", car.name, first.steps, first.pose],
          );
          const direct = scenario.drive();
          assert.deepEqual(direct.replay(record.record, record.steps).pose, first.pose);
          await page.click("#drive-restart");
          await page.waitForSelector("#drive[data-keys='0']");
          const file = (/** @type {object} */ content) =>
            pickFile(page, "x.json", JSON.stringify(content), "#drive-file");
          await file(record);
          await page.waitForSelector(`#drive[data-keys='${first.keys}']`);
          assert.deepEqual(await dash(page), first);
          await file({ ...record, record: [{ step: 0, key: "jump" }] });
          await page.waitForSelector("#notice[data-pointer='/record/0/key']");
          await file({ ...record, scenario: "elsewhere" });
          await textMatches(page, "#notice", /recorded in the scene "elsewhere"/);
        },

        "a form shows where one control leads, and refuses what the car cannot do": async (page) => {
          await drive(page);
          await reveal(page, "#roll-v");
          await page.fill("#roll-v", "0.5");
          await page.fill("#roll-phi", "0");
          await page.fill("#roll-duration", "10");
          await page.click("#drive .roll button");
          await textMatches(page, "#drive .roll .hint", /Free for 2\.\d\d s; then obstacle 1 is in the way/);
          await page.fill("#roll-v", "0.7");
          await page.click("#drive .roll button");
          await textMatches(page, "#drive .roll .hint", /within \[-0\.5, 0\.5\]/);
          assert.equal(await page.getAttribute("#roll-v", "aria-invalid"), "true");
        },

        "a switch draws Euler's steps beside the arc, and says how far apart they end": async (page) => {
          await drive(page);
          await reveal(page, "#roll-v");
          const gap = page.locator("#drive dl div", { hasText: "gap to Euler" });
          assert.equal(await gap.isVisible(), false);
          for (const [id, value] of [
            ["v", "0.4"],
            ["phi", "0.5"],
            ["duration", "1.5"],
          ])
            await page.fill(`#roll-${id}`, value);
          await page.click("#drive .roll button");
          await textMatches(page, "#drive .roll .hint", /^Free for all 1\.50 s\.$/);
          assert.equal(await pixelsOf(page, "workspace", "top", "unproven"), 0);
          await page.check("#drive-euler");
          const [x, y] = scenario.rollout([0.3, 0.5, 0], 0.4, 0.5, 1.5).poses.slice(-3);
          for (const dt of [0.01, 0.25]) {
            await page.selectOption("#drive-dt", String(dt));
            const [toX, toY] = scenario
              .rollout([0.3, 0.5, 0], 0.4, 0.5, 1.5, { integration: "euler", dt })
              .poses.slice(-3);
            const apart = Math.hypot(toX - x, toY - y).toFixed(3);
            await textMatches(page, "#drive .roll .hint", new RegExp(`path ends ${apart} m from the end of the arc`));
            await textMatches(page, "#drive dl", new RegExp(`gap to Euler\\s*${apart} m`));
          }
          assert.ok((await pixelsOf(page, "workspace", "top", "unproven")) > 40, "it has a label");
          assert.deepEqual(await violations(page, "#drive"), []);
          await page.focus("#stage");
          await press(page, "w", "a", "c");
          await textMatches(page, "#drive dl", /gap to Euler\s*0\.00\d m/);
          await page.uncheck("#drive-euler");
          await gap.waitFor({ state: "hidden" });
        },
      },
      restage,
    ),
  ));

test("in its own time it drives on, can be paused, and goes on", () =>
  onPage({}, async (page) => {
    await page.waitForSelector("#counters[data-status=running]", { state: "attached" });
    // What is planned there plays on meanwhile.
    await pickFile(page, "own.json", JSON.stringify(ROAD));
    await page.waitForSelector("body[data-scene=file]");
    await takeWheel(page);
    await press(page, "w", "w");
    await page.waitForFunction(() => Number(document.getElementById("drive")?.dataset.x) > 0.4);
    await pressUntil(page, "p", "#drive[data-paused=true]");
    const { steps } = await dash(page);
    await pressUntil(page, "c", "#drive[data-paused=false]");
    await page.waitForFunction((before) => Number(document.getElementById("drive")?.dataset.steps) > before, steps);
  }));

test("buttons are as large as fingers, and do what the keys do", () =>
  onPausedPage(async (page) => {
    await drive(page);
    for (const button of await page.locator("#drive button:visible").all()) {
      const box = await button.boundingBox();
      assert.ok(
        box && box.width >= 44 && box.height >= 44,
        `${await button.innerText()} ${box?.width} x ${box?.height}`,
      );
    }
    for (const key of ["faster", "faster", "left", "slower", "right", "keep"]) await page.tap(`#drive-${key}`);
    await page.waitForSelector("#drive[data-keys='6']");
    const { v, phi, steps } = await dash(page);
    assert.deepEqual([v, phi, steps], [0.1, 0, 150]);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "nothing sticks out");
  }, PHONE));
