/**
 * The keyboard car on the page: keys, buttons, numbers, stops, records, one control's way; and time that no frame
 * decides.
 */
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { Scenario } from "planarium";
import { Driving } from "../../www/planner/driving/driving.js";
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
  textMatches,
  useBrowser,
} from "./browser.mjs";
import { assertFaultless } from "./looks.mjs";

/** @import { DriveKey, ScenarioDocument } from "planarium" */
/** @import { Session } from "../../www/planner/session.js" */
/** @import { Page } from "./browser.mjs" */

useBrowser();

/** A car on an empty square with a wall to its right. @type {ScenarioDocument} */
const ROAD = {
  format: "planarium-scenario-1",
  name: "road",
  world: {
    bounds: { min: [0, 0], max: [2, 2] },
    obstacles: [
      { type: "disc", center: [0.3, 1.7], radius: 0.1 },
      {
        type: "polygon",
        vertices: [
          [1.5, 0],
          [1.6, 0],
          [1.6, 1.2],
          [1.5, 1.2],
        ],
      },
    ],
  },
  robot: {
    type: "car",
    shape: {
      type: "polygon",
      vertices: [
        [-0.05, -0.06],
        [0.25, -0.06],
        [0.25, 0.06],
        [-0.05, 0.06],
      ],
    },
    wheelbase: 0.2,
    speed: [-0.5, 0.5],
    steering: [-0.7854, 0.7854],
  },
  queries: [
    { name: "home", start: [0.3, 0.5, 0], goal: [0.9, 0.5, 0], goal_tolerance: { translation: 0.1, rotation: 0.5 } },
  ],
};

const scenario = Scenario.parse(ROAD);
/** When the tests of time begin, in milliseconds. */
const from = 1e12;

/**
 * A drive that begins at `from`, with what it needs of a session.
 * @param {boolean} [byKeys]  time passes with keys alone
 */
function begun(byKeys = false) {
  const document = scenario.document();
  const { start, goal } = document.queries[0];
  const shown = {
    scenario,
    document,
    query: "home",
    start,
    goal,
    hand: null,
    check: null,
    driven: null,
    placed: { isNear: () => false },
  };
  const session = { shown, wake() {}, timeline: { pause() {} }, byHand: { release() {}, game: {} } };
  const driving = new Driving(/** @type {Session} */ (/** @type {unknown} */ (session)));
  driving.start(byKeys, from);
  return driving;
}

describe("time", () => {
  /** Moments of keys, milliseconds. @type {[number, DriveKey][]} */
  const keys = [
    [3, "faster"],
    [111.4, "faster"],
    [127, "left"],
    [600.01, "faster"],
    [640, "right"],
    [641, "right"],
    [1234.5, "slower"],
    [1802, "left"],
  ];

  /**
   * Drives for two seconds.
   * @param {number} rate  frames a second
   * @param {number} [late]  milliseconds after which a key is heard
   */
  function driven(rate, late = 0) {
    const driving = begun();
    /** @type {[number, () => void][]} */
    const happens = keys.map(([at, key]) => [at + late, () => driving.press(key, from + at)]);
    for (let frame = 1; frame <= 2.2 * rate; frame++)
      happens.push([(1000 * frame) / rate, () => driving.pass(from + (1000 * frame) / rate)]);
    happens.sort(([a], [b]) => a - b);
    for (const [, then] of happens) then();
    driving.pause(from + 2030);
    assert.ok(driving.state && driving.state.blocked === null);
    return { state: driving.state, trace: [...driving.trace], record: driving.record()?.record ?? [] };
  }

  test("the same keys lead to the same bits at 30, 60, 120 and 144 frames a second", () => {
    const slow = driven(30);
    assert.ok(slow.trace.length > 3 * 150);
    for (const rate of [60, 120, 144]) assert.deepEqual(driven(rate), slow, `${rate} frames a second`);
  });

  test("a key that is heard late counts from its moment all the same", () => {
    assert.deepEqual(driven(60, 25), driven(60));
  });

  test("a pose after two seconds is that of the package's drive by the same keys, one step after the other", () => {
    const { state, record } = driven(60);
    assert.equal(record.length, keys.length);
    const direct = scenario.drive();
    for (const { step, key } of record) {
      direct.tick(step - direct.state.steps);
      direct.press(key);
    }
    assert.deepEqual(direct.tick(state.steps - direct.state.steps).pose, state.pose);
  });

  test("a page that nobody saw for a while has not driven on meanwhile", () => {
    const driving = begun();
    driving.press("faster", from);
    driving.pass(from + 16);
    driving.pass(from + 60_000);
    assert.ok(driving.state && driving.state.steps < 30, `${driving.state?.steps}`);
  });

  test("by keys alone, each takes a quarter of a second", () => {
    const driving = begun(true);
    driving.press("faster", from);
    driving.pass(from + 5000);
    driving.press("keep", from + 6000);
    assert.deepEqual([driving.state?.steps, driving.moves], [50, false]);
  });

  test("while the car rests no time goes by: a recording begins with its first key", () => {
    const driving = begun();
    driving.press("faster", from + 8000);
    driving.pass(from + 8130);
    assert.deepEqual([driving.state?.steps, driving.record()?.record], [10, [{ step: 0, key: "faster" }]]);
  });

  test("a recording is replayed in its own time to the same bits, and shown at any part of it", () => {
    const driving = begun();
    for (const [at, key] of keys) driving.press(key, from + at);
    driving.pass(from + 2030);
    const { state, trace } = driving;
    const recording = /** @type {{ record: import("planarium").KeyPress[], steps: number }} */ (driving.record());
    const again = /** @type {NonNullable<ReturnType<typeof driving.again>>} */ (driving.again());
    assert.ok(state && Math.abs(again.seconds - recording.steps * scenario.drive().stepSeconds) < 1e-12);
    for (const part of [0, 0.5, 1, 0.25, 1]) {
      const { pose, driven } = again.at(part);
      const direct = scenario.drive().replay(recording.record, Math.round(part * recording.steps));
      assert.deepEqual([[...pose], driven.steering], [direct.pose, direct.phi]);
    }
    assert.deepEqual([...again.at(0).pose], ROAD.queries?.[0].start);
    again.free();
    driving.replay(from, recording);
    driving.pass(from + 16);
    assert.ok(driving.tape && driving.state && driving.state.steps < recording.steps);
    for (let at = 100; at < 4000; at += 100) driving.pass(from + at);
    assert.deepEqual([driving.tape, driving.state?.pose, driving.trace], [null, state.pose, trace]);
  });

  test("while it is paused no time goes by; C goes on", () => {
    const driving = begun();
    driving.press("faster", from);
    driving.pass(from + 130);
    driving.pause(from + 130);
    assert.deepEqual([driving.state?.steps, driving.moves], [10, false]);
    driving.press("keep", from + 5000);
    driving.pass(from + 5130);
    assert.deepEqual([driving.state?.steps, driving.paused], [20, false]);
  });
});

describe("Euler's steps beside the arc", () => {
  /** @param {Driving} driving @returns {NonNullable<Driving["beside"]>} */
  const besideOf = ({ beside }) => beside ?? assert.fail("they are drawn");

  test("they belong to the control shown, else to the control held since it was changed", () => {
    const driving = begun(true);
    driving.setEuler(0.25);
    assert.ok(!driving.beside, "nothing moves");
    for (const key of /** @type {const} */ (["faster", "left", "keep"])) driving.press(key, from);
    // Held for half a second.
    const held = [...driving.trace.slice(-3 * 51)];
    const { poses, apart } = besideOf(driving);
    assert.deepEqual(poses.slice(0, 3), Float64Array.from(held.slice(0, 3)));
    // A step goes straight on along the heading of its start, for a quarter of a second at 0.1 m/s.
    assert.equal(poses.length, 9);
    const theta = poses[2];
    const [dx, dy] = [poses[3] - poses[0], poses[4] - poses[1]];
    assert.ok(Math.hypot(dx - 0.025 * Math.cos(theta), dy - 0.025 * Math.sin(theta)) < 1e-12);
    const [[x, y], [toX, toY]] = [held, [...poses]].map((rows) => rows.slice(-3));
    assert.ok(apart === Math.hypot(toX - x, toY - y) && apart > 1e-4, `${apart}`);
    driving.roll(0.4, 0.5, 1);
    const shown = scenario.rollout(driving.state?.pose ?? [], 0.4, 0.5, 1, { integration: "euler", dt: 0.25 });
    assert.deepEqual(besideOf(driving).poses, shown.poses);
    driving.setEuler(0);
    assert.ok(!driving.beside);
    assert.equal(driving.announcement, "Free for all 1.00 s.");
  });

  test("the gap falls with the step, and is unknown where they touch something", () => {
    const driving = begun();
    driving.roll(0.4, 0.5, 1.5);
    const gaps = [0.5, 0.25, 0.1, 0.01].map((dt) => {
      driving.setEuler(dt);
      return Number(besideOf(driving).apart) / dt;
    });
    assert.ok(
      gaps.every((gap) => Math.abs(gap / gaps[3] - 1) < 0.05),
      `${gaps}`,
    );
    // The arc turns away from the wall; a step of half a second goes straight into it.
    driving.start(false, from, [1.1, 0.5, 0]);
    driving.setEuler(0.5);
    driving.roll(0.5, 0.7, 1);
    assert.ok(driving.rollout?.blocked === null && besideOf(driving).apart === null, `${driving.announcement}`);
    assert.match(driving.announcement, /touches something before that/);
  });
});

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

test("arrows and letters drive while the stage has the focus; numbers say how; Escape leaves", () =>
  onPausedPage(async (page) => {
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
  }));

test("it stops at an obstacle, says at which and marks it; axe finds nothing, and it backs off again", () =>
  onPausedPage(async (page) => {
    await drive(page);
    await press(page, ...Array.from({ length: 22 }, () => "w"));
    const stopped = await dash(page);
    assert.deepEqual([stopped.blocked, stopped.v], ["1", 0]);
    assert.ok(stopped.pose[0] > 1.24 && stopped.pose[0] < 1.25, `${stopped.pose}`);
    assert.match(await page.innerText("#story"), /Stopped: obstacle 1 is in the way/);
    assert.equal(await page.getAttribute("#story", "data-tone"), "bad");
    await textMatches(page, "#announcer", /obstacle 1/);
    assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > 60);
    await page.click("#drive .more summary");
    await assertFaultless(page, "driving");
    await page.focus("#stage");
    await press(page, "s", "s");
    const { blocked, pose } = await dash(page);
    assert.equal(blocked, "");
    assert.ok(pose[0] < stopped.pose[0]);
  }));

test("in its own time it drives on, can be paused, and goes on", () =>
  onPage({}, async (page) => {
    await page.waitForSelector("#counters[data-status=running]", { state: "attached" });
    await drive(page);
    await press(page, "w", "w");
    await page.waitForFunction(() => Number(document.getElementById("drive")?.dataset.x) > 0.4);
    await pressUntil(page, "p", "#drive[data-paused=true]");
    const { steps } = await dash(page);
    await pressUntil(page, "c", "#drive[data-paused=false]");
    await page.waitForFunction((before) => Number(document.getElementById("drive")?.dataset.steps) > before, steps);
  }));

test("at the goal it says so; another scene ends the drive and leaves nothing behind", () =>
  onPausedPage(async (page) => {
    await drive(page);
    await press(page, "w", "w");
    while ((await dash(page)).pose[0] < 0.84) await press(page, "c");
    await press(page, "s", "s");
    await page.waitForSelector("#drive[data-arrived=true]");
    assert.match(await page.innerText("#story"), /You reached the goal after \d+\.\d s and \d+ keys\./);
    await chooseScene(page, "open");
    await page.waitForSelector("#drive", { state: "hidden" });
    assert.equal(await page.textContent("#your-turn"), "Your turn");
  }));

test("a drive is replayed to the same place, and so is its file; another one is refused", () =>
  onPausedPage(async (page) => {
    await drive(page);
    await press(page, "w", "w", "ArrowLeft", "c", "ArrowRight", "c");
    const first = await dash(page);
    await page.click("#drive-replay");
    await textMatches(page, "#announcer", /^Replaying|was replayed/);
    assert.deepEqual(await dash(page), first);
    await page.click("#drive .more summary");
    const record = JSON.parse((await download(page, "#drive-save")).text);
    assert.deepEqual(
      [record.format, record.scenario, record.steps, record.pose],
      ["planarium-drive-1", "road", first.steps, first.pose],
    );
    const direct = scenario.drive();
    assert.deepEqual(direct.replay(record.record, record.steps).pose, first.pose);
    await page.click("#drive-restart");
    await page.waitForSelector("#drive[data-keys='0']");
    const file = (/** @type {object} */ content) => pickFile(page, "x.json", JSON.stringify(content), "#drive-file");
    await file(record);
    await page.waitForSelector(`#drive[data-keys='${first.keys}']`);
    assert.deepEqual(await dash(page), first);
    await file({ ...record, record: [{ step: 0, key: "jump" }] });
    await page.waitForSelector("#notice[data-pointer='/record/0/key']");
    await file({ ...record, scenario: "elsewhere" });
    await textMatches(page, "#notice", /recorded in the scene "elsewhere"/);
  }));

test("a form shows where one control leads, and refuses what the car cannot do", () =>
  onPausedPage(async (page) => {
    await drive(page);
    await page.click("#drive .more summary");
    await page.fill("#roll-v", "0.5");
    await page.fill("#roll-phi", "0");
    await page.fill("#roll-duration", "10");
    await page.click("#drive .roll button");
    await textMatches(page, "#drive .roll .hint", /Free for 1\.\d\d s; then obstacle 1 is in the way/);
    await page.fill("#roll-v", "0.7");
    await page.click("#drive .roll button");
    await textMatches(page, "#drive .roll .hint", /within \[-0\.5, 0\.5\]/);
    assert.equal(await page.getAttribute("#roll-v", "aria-invalid"), "true");
  }));

test("a switch draws Euler's steps beside the arc, and says how far apart they end", () =>
  onPausedPage(async (page) => {
    await drive(page);
    await page.click("#drive .more summary");
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
      const [toX, toY] = scenario.rollout([0.3, 0.5, 0], 0.4, 0.5, 1.5, { integration: "euler", dt }).poses.slice(-3);
      const apart = Math.hypot(toX - x, toY - y).toFixed(3);
      await textMatches(page, "#drive .roll .hint", new RegExp(`path ends ${apart} m from the end of the arc`));
      await textMatches(page, "#drive dl", new RegExp(`gap to Euler\\s*${apart} m`));
    }
    assert.ok((await pixelsOf(page, "workspace", "top", "unproven")) > 40, "it has a label");
    await assertFaultless(page, "Euler");
    await page.focus("#stage");
    await press(page, "w", "a", "c");
    await textMatches(page, "#drive dl", /gap to Euler\s*0\.00\d m/);
    await page.uncheck("#drive-euler");
    await gap.waitFor({ state: "hidden" });
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
