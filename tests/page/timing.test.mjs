/** Paths that are timed on the planner's page, and paths of other programs that are judged there. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario } from "planarium/full";
import { writePath } from "planarium/import";
import { pathKind } from "../../www/planner/judge/kind.js";
import { traceOf } from "../../www/planner/judge/trace.js";
import { PathPlayback } from "../../www/planner/stage/path-playback.js";
import { Timed } from "../../www/planner/timing/timed.js";
import {
  PHONE,
  atRest,
  chooseScene,
  counters,
  dropFile,
  fill,
  finish,
  linkOf,
  onPausedPage,
  openScenario,
  pickFile,
  pixelsOf,
  reveal,
  take,
  textMatches,
  unfold,
  useBrowser,
} from "./browser.mjs";
import { openEditor, press } from "./editing.mjs";
import { assertFaultless, assertTargets } from "./looks.mjs";
import { planned } from "./library.mjs";
import { race } from "./race.mjs";
import { inTurn, openState, restage } from "./turns.mjs";

/** @import { Page } from "./browser.mjs" */
/** @import { TimingLimits, Trajectory } from "planarium/full" */

useBrowser();

/** Waits until the path on the stage is timed. @param {Page} page */
const timed = (page) => page.waitForSelector("#timing[data-state=timed]");

/** Opens the fold, and waits until the path is timed. @param {Page} page */
async function openTiming(page) {
  await unfold(page, "timing");
  await timed(page);
}

/** @param {Page} page */
const durationOf = async (page) => Number(await page.getAttribute("#timing", "data-duration"));

/**
 * The trajectory of the path on the stage, by the package alone.
 * @param {Page} page
 * @param {TimingLimits} limits
 * @returns {Promise<Trajectory>}
 */
async function packaged(page, limits) {
  await unfold(page, "export");
  const [document, result] = [await take(page, "scenario"), await take(page, "result")];
  const scenario = Scenario.parse(document.text);
  try {
    return scenario.time(result.text, limits);
  } finally {
    scenario.free();
  }
}

/** Puts a slider where a hand would. @param {Page} page @param {string} selector @param {number} value */
const slide = (page, selector, value) =>
  page.locator(selector).evaluate((element, to) => {
    /** @type {HTMLInputElement} */ (element).value = String(to);
    element.dispatchEvent(new Event("input", { bubbles: true }));
  }, value);

/** The numbers of a text. @param {string} text */
const numbersIn = (text) =>
  Array.from(text.replaceAll("\u2212", "-").matchAll(/-?\d+(\.\d+)?/g), ([one]) => Number(one));

/** A world of one post, with a disc that has to get past it. */
const POST = {
  format: "planarium-scenario-1",
  name: "post",
  world: {
    bounds: { min: [0, 0], max: [4, 4] },
    obstacles: [{ type: "disc", center: [2, 2], radius: 0.5 }],
  },
  robot: { type: "disc", radius: 0.25 },
  queries: [{ name: "past", start: [1, 1], goal: [3, 3] }],
};

test("a path that is timed", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "takes as long as by the package; charts, readout, pose and exports are those of the trajectory": async (
          page,
        ) => {
          await unfold(page, "timing");
          await textMatches(page, "#timing-line", /no path yet/);
          await finish(page);
          await timed(page);
          const trajectory = await packaged(page, { speed: 1, acceleration: 2 });
          const { duration, restCount } = trajectory;
          assert.equal(await durationOf(page), duration);
          assert.match(
            await page.innerText("#timing-line"),
            new RegExp(`${duration.toFixed(3)}\\ss, with ${restCount} rests`),
          );
          assert.match(await page.innerText("#timing-hint"), /Rounded corners/);
          // Four numbers of each chart: the extremes of both joints.
          const rows = trajectory.sample(duration / 4000);
          const most = (/** @type {number} */ column) => {
            const values = rows.filter((_, i) => i % 7 === column);
            return [Math.min(...values), Math.max(...values)];
          };
          const charts = await page
            .locator("#timing svg[role=img]")
            .evaluateAll((all) => all.map((one) => one.getAttribute("aria-label") ?? ""));
          for (const [chart, columns] of /** @type {[number, number[]][]} */ ([
            [0, [3, 4]],
            [1, [5, 6]],
          ])) {
            const [, ...drawn] = numbersIn(charts[chart].replaceAll(/joint \d/g, ""));
            columns.flatMap(most).forEach((value, i) => {
              assert.ok(Math.abs(drawn[i] - value) < 0.02, `${charts[chart]}: ${value}`);
            });
          }
          const at = 0.3 * duration;
          await slide(page, "#timing-time", at);
          await atRest(page);
          const shown = numbersIn(await page.innerText("#timing-now"));
          const { time, velocity, acceleration, configuration } = trajectory.state(
            Number(await page.inputValue("#timing-time")),
          );
          [time, duration, ...velocity].forEach((value, i) =>
            assert.ok(Math.abs(shown[i] - value) < 0.02, `${shown}: ${value}`),
          );
          assert.ok(acceleration.length === 2);
          await reveal(page, "#pose");
          for (const [i, value] of configuration.entries()) {
            const pose = Number(await page.inputValue(`#pose-${i}-number`));
            assert.ok(Math.abs(Math.sin((pose - value) / 2)) < 1e-3, `${pose}: ${value}`);
          }
          assert.deepEqual(JSON.parse((await take(page, "trajectory")).text), JSON.parse(JSON.stringify(trajectory)));
          const states = trajectory.sample(0.01);
          const document = JSON.parse((await take(page, "scenario")).text);
          for (const form of /** @type {const} */ (["csv", "json"])) {
            await page.selectOption("#export-form", form);
            const bytes = await writePath({ states }, { scenario: document, form, query: document.queries[0].name });
            assert.equal((await take(page, "timed")).text, new TextDecoder().decode(bytes));
          }
          const disabled = await page.locator("#export-form option:disabled").allInnerTexts();
          assert.deepEqual(disabled, ["GeoJSON", "ROS path", "ROS waypoints"], "an arm has no place");
          trajectory.free();
        },

        "is played by keys and buttons at a chosen speed, and its limits change it": async (page) => {
          await finish(page);
          await openTiming(page);
          const before = await durationOf(page);
          assert.equal(await page.innerText("#along-name"), "Time");
          await page.focus("#timing-time");
          await page.keyboard.press("End");
          await textMatches(page, "#timing-now", /^(\d+\.\d\d) of \1 s/);
          await page.keyboard.press("Home");
          await textMatches(page, "#timing-now", /^0\.00 of/);
          await page.keyboard.press("ArrowRight");
          await textMatches(page, "#timing-now", /^0\.0?[1-9]/);
          await page.keyboard.press(" ");
          await page.waitForSelector("#play[data-playing=true]");
          await page.click("#timing-play");
          await page.waitForSelector("#play[data-playing=false]");
          await page.click("#timing-pace-2");
          await page.waitForSelector("#timing-pace-2[aria-pressed=true]");
          // A field takes more than its slider reaches.
          await fill(page, "#limit-speed-number", "0.004");
          await page.waitForFunction(
            (old) => Number(document.getElementById("timing")?.dataset.duration) > 100 * old,
            before,
          );
          assert.equal(await page.inputValue("#limit-speed-number"), "0.004");
          await fill(page, "#limit-speed-number", "0.5");
          await page.waitForFunction(
            (old) => Number(document.getElementById("timing")?.dataset.duration) > old,
            before,
          );
          const trajectory = await packaged(page, { speed: 0.5, acceleration: 2 });
          assert.equal(await durationOf(page), trajectory.duration);
          trajectory.free();
          await fill(page, "#limit-acceleration-number", "-1");
          await textMatches(page, "#limit-acceleration-reason", /below/);

          const link = await linkOf(page);
          await restage(page);
          assert.equal(
            await page.locator("#timing-fold").evaluate((fold) => /** @type {HTMLDetailsElement} */ (fold).open),
            false,
          );
          await openState(page, link);
          await finish(page);
          await timed(page);
          assert.equal(await page.inputValue("#limit-speed-number"), "0.500");
          assert.equal(await page.getAttribute("#timing-pace-2", "aria-pressed"), "true");
          assert.ok((await durationOf(page)) > before);

          // What was timed does not stay under another run.
          await page.click("#reset");
          await page.waitForSelector("#timing[data-state=none]");
          assert.ok(await page.isHidden("#timing .charts"));
          await page.locator("#timing-fold > summary").click();
          await finish(page);
          await textMatches(page, "#along-name", /Path/);
        },

        "of a disc, a body, a car, and of two planners in a race": async (page) => {
          await unfold(page, "timing");
          for (const [id, limits, chartCount] of /** @type {[string, TimingLimits, number][]} */ ([
            ["rings", { speed: 1, acceleration: 2 }, 2],
            ["crates", { speed: 1, acceleration: 2, turnRate: 1, turnAcceleration: 2 }, 4],
            ["turn", { speed: 1, acceleration: 2 }, 2],
          ])) {
            await chooseScene(page, id);
            await finish(page);
            await timed(page);
            const [speed, acceleration] = await Promise.all(
              ["speed", "acceleration"].map(async (name) => Number(await page.inputValue(`#limit-${name}-number`))),
            );
            const trajectory = await packaged(page, { ...limits, speed, acceleration });
            assert.equal(await durationOf(page), trajectory.duration, id);
            trajectory.free();
            assert.equal(await page.locator("#timing svg[role=img]").count(), chartCount, id);
          }
          const before = await durationOf(page);
          await fill(page, "#limit-lateral_acceleration", "0.02");
          await page.waitForFunction(
            (old) => Number(document.getElementById("timing")?.dataset.duration) > old,
            before,
          );
          await assertFaultless(page, "a car whose path is timed");
          await assertTargets(page);

          await chooseScene(page, "stones");
          await race(page, "rrt-connect");
          await finish(page);
          await timed(page);
          // The time axis is that of the slower robot.
          const durations = numbersIn(await page.innerText("#timing-line")).filter((_, i) => i % 2 === 0);
          assert.match(await page.innerText("#timing-line"), /The fastest motions take: A .*; B /);
          assert.ok(Math.abs(Math.max(...durations) - (await durationOf(page))) < 1e-3, `${durations}`);
          assert.deepEqual(await page.locator("#timing-legend span").allInnerTexts(), [
            "A joint 1",
            "A joint 2",
            "B joint 1",
            "B joint 2",
            "limit",
          ]);
        },
      },
      restage,
    ),
  ));

test("a trajectory between its rows, and a robot that moves as it is timed", () => {
  const turning = { turnRate: 1, turnAcceleration: 2, differential: true };
  for (const [id, limits, wheelbase] of /** @type {[string, TimingLimits, number][]} */ ([
    ["stones", { speed: 1, acceleration: 2 }, 0],
    ["rings", { speed: 1, acceleration: 2, ...turning }, 0],
    ["turn", { speed: 0.5, acceleration: 1 }, 1],
  ])) {
    const { scenario, planner } = planned(id);
    const result = planner.result();
    const full = Scenario.parse(scenario.document());
    const trajectory = full.time(result, limits);
    const { duration, restCount: rests, dimension } = trajectory;
    const step = duration / 4000;
    const one = new Timed(scenario, { duration, rests, step, rows: trajectory.sample(step), dimension }, wheelbase);
    assert.equal(one.heading(1), limits.differential ? trajectory.state(duration).configuration[2] : null);
    // Between two rows an acceleration may jump.
    const most = Math.max(1e-5, step * step);
    for (let i = 0; i <= 977; i++) {
      const { pose, velocity } = one.state((i / 977) * duration);
      const wanted = trajectory.state((i / 977) * duration);
      pose.forEach((value, k) => assert.ok(Math.abs(value - wanted.configuration[k]) < most, `${id} at ${i}`));
      velocity.forEach((value, k) =>
        assert.ok(Math.abs(value - wanted.velocity[k]) < Math.max(0.02, 2 * step), `${id} at ${i}`),
      );
    }
    assert.ok(scenario.distance(one.pose(0), Float64Array.from(result.path[0])) < 1e-9);
    assert.ok(scenario.distance(one.pose(1), Float64Array.from(result.path.at(-1) ?? [])) < 1e-9);

    const playback = new PathPlayback(scenario, Float64Array.from(result.path.flat()));
    playback.seek(0);
    playback.timed = one;
    playback.advance(0.25);
    assert.ok(Math.abs(playback.at * duration - 0.25) < 1e-9, "at true speed");
    one.pace = 2;
    playback.advance(0.25);
    assert.ok(Math.abs(playback.at * duration - 0.75) < 1e-9, "twice as fast");
    assert.deepEqual(playback.pose, one.pose(playback.at));
    playback.advance(duration);
    assert.equal(playback.at, 1);
    playback.advance(10);
    assert.equal(playback.at, 0, "it begins again at the start");
    trajectory.free();
    full.free();
    planner.free();
    scenario.free();
  }
});

test("files are told apart: paths, what may be one, and others", () => {
  const kind = (/** @type {string} */ text, name = "file", dimension = 2) =>
    pathKind(dimension, { name, bytes: new Uint8Array(Buffer.from(text)) });
  for (const text of [
    "x,y\n0,0\n1,1\n",
    "# a path\nt; x [m]; y [m]\n0;1;2\n",
    "joint_0 joint_1\n0 1\n",
    "[[0, 0], [1, 1]]",
    '{"poses": [{"position": {"x": 1}}]}',
    '{"path": [[0, 0]]}',
    "header:\n  stamp: 0\nposes: []\n",
    "# A path of Planarium: waypoints\n- frame_id: map\n  position: {x: 0, y: 0}\n",
    '{"columns": {"x": {"unit": "m", "values": [0, 1]}}}',
  ])
    assert.equal(kind(text), "path", text);
  for (const text of [
    "0 0\n1 1\n",
    "0,0,0\n1,1,1\n",
    '{"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": {"type": "LineString"}}]}',
  ])
    assert.equal(kind(text), "maybe", text);
  for (const text of [
    "",
    "1,2,3,4,5,6,7,8\n",
    "type octile\nheight 4\n",
    JSON.stringify(POST),
    '{"scenario": "a", "path": [[0, 0]]}',
    "image: rooms.pgm\nresolution: 0.1\n",
    '{"type": "Polygon", "coordinates": []}',
    "<svg xmlns='http://www.w3.org/2000/svg'/>",
  ])
    assert.equal(kind(text), "other", text);
});

test("the line of a path ends at its contact and goes on after it, and is an arc where it moves along one", () => {
  const path = {
    id: 1,
    count: 3,
    rows: Float64Array.of(0, 0, 2, 0, 2, 2),
    indices: Uint32Array.of(0, 1, 2),
    report: /** @type {any} */ ({}),
  };
  const contact = /** @type {any} */ ({ edge: 1, fraction: 0.25, configuration: [2, 0.5] });
  assert.deepEqual(traceOf(path, 2, contact, false), {
    before: Float64Array.of(0, 0, 2, 0, 2, 0.5),
    after: Float64Array.of(2, 0.5, 2, 2),
  });
  assert.equal(traceOf(path, 2, null, false).after.length, 0);
  const quarter = {
    ...path,
    count: 2,
    rows: Float64Array.of(1, 0, Math.PI / 2, 0, 1, Math.PI),
    indices: Uint32Array.of(0, 1),
  };
  const { before } = traceOf(quarter, 3, null, true);
  for (let i = 0; i < before.length; i += 3) assert.ok(Math.abs(Math.hypot(before[i], before[i + 1]) - 1) < 1e-12);
  assert.ok(before.length / 3 > 10);
});

test("a path of another program", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "is drawn with its first contact, leaves scene and run alone, and is removed": async (page) => {
          await openScenario(page, POST);
          const run = await finish(page);
          await dropFile(page, "path.csv", "x,y,speed\n1,1,0\n1,2,1\n3,2,0\n");
          await page.waitForSelector("#judged[data-state=judged][data-free=false]");
          await atRest(page);
          assert.match(
            await page.innerText("#judged"),
            /path\.csv: not free: the disc touches obstacle 0 at \(1\.50, 2\.00\), between waypoints 1 and 2, after 12\.5 % of the way\. Left out: column speed\./,
          );
          assert.ok((await pixelsOf(page, "workspace", "top", "collision")) > 50, "the contact is marked");
          assert.ok((await pixelsOf(page, "workspace", "top", "ink")) > 40, "the path is drawn");
          assert.ok(await page.isVisible("#legend-judged"));
          assert.ok(await page.isHidden("#judged-arcs"), "a disc has no heading");
          assert.deepEqual(await counters(page), run);
          await assertFaultless(page, "a path is judged");

          await pickFile(
            page,
            "line.geojson",
            JSON.stringify({
              type: "LineString",
              coordinates: [
                [1, 1],
                [1, 3],
                [3, 3],
              ],
            }),
          );
          await page.click("#notice [data-choice=path]");
          await page.waitForSelector("#judged[data-state=judged][data-free=true]");
          const scenario = Scenario.parse(/** @type {any} */ (POST));
          const { clearance } = scenario.judge([
            [1, 1],
            [1, 3],
            [3, 3],
          ]);
          scenario.free();
          assert.match(
            await page.innerText("#judged"),
            new RegExp(
              `line\\.geojson: free, with 3 waypoints\\. The smallest clearance is ${clearance?.distance.toFixed(3)} m, to obstacle 0`,
            ),
          );
          assert.equal(await pixelsOf(page, "workspace", "top", "collision"), 0);

          // What the page exports it reads, but for an array whose first column could be anything.
          const states = Float64Array.of(0, 1, 1, 0, 0, 0, 0, 4, 1, 3, 0, 0, 0, 0);
          for (const form of /** @type {const} */ (["csv", "json", "nav-path", "nav-waypoints"])) {
            const bytes = await writePath({ states }, { scenario: /** @type {any} */ (POST), form });
            await pickFile(page, `own-${form}`, Buffer.from(bytes));
            await textMatches(page, "#judged", new RegExp(`^own-${form}: free, with 2 waypoints`));
          }
          const array = await writePath({ states }, { scenario: /** @type {any} */ (POST), form: "npy" });
          await pickFile(page, "own.npy", Buffer.from(array));
          await page.waitForSelector("#notice[data-code=wrong-columns]");

          // It is judged again in an edited scene.
          await pickFile(page, "path.csv", "x,y,speed\n1,1,0\n1,2,1\n3,2,0\n");
          await page.waitForSelector("#judged[data-state=judged][data-free=false]");
          await openEditor(page, null);
          await page.focus("#stage");
          await press(page, ["]", "]", "]"], "title", "Obstacle 0, a disc");
          await press(page, ["Delete"], "undo", 1);
          await page.waitForSelector("#judged[data-state=judged][data-free=true]");
          await press(page, ["Control+z"], "redo", 1);
          await page.waitForSelector("#judged[data-state=judged][data-free=false]");
          await page.click("#edit");
          await finish(page);

          await page.click("#judged-remove");
          assert.ok(await page.isHidden("#judged"));
          assert.ok(await page.isHidden("#legend-judged"));
          assert.equal(await page.evaluate(() => document.activeElement?.id), "stage");
          assert.deepEqual(await atRest(page), run);
        },

        "is refused with its line, and the one before stays": async (page) => {
          await openScenario(page, POST);
          await pickFile(page, "good.csv", "x,y\n1,1\n1,3\n");
          await page.waitForSelector("#judged[data-state=judged]");
          for (const [text, code, sentence] of /** @type {[string, string, RegExp][]} */ ([
            ["x,y\n1,1\n1,two\n", "invalid-file", /line 3/],
            ["x,theta\n1,1\n1,2\n", "wrong-columns", /x and y/],
          ])) {
            await pickFile(page, "bad.csv", text);
            await page.waitForSelector(`#notice[data-code=${code}]`);
            assert.match(await page.innerText("#notice"), sentence);
            assert.match(await page.innerText("#judged"), /^good\.csv: free/);
          }
          await chooseScene(page, "stones");
          assert.ok(await page.isHidden("#judged"), "another scene takes it away");
        },

        "of a car: turns that it cannot drive, angles in degrees, motions along arcs": async (page) => {
          await chooseScene(page, "turn");
          const { scenario, planner } = planned("turn");
          const [x, y, theta] = scenario.document().queries[0].start ?? assert.fail();
          planner.free();
          const degrees = (theta * 180) / Math.PI;
          await pickFile(page, "spin.csv", `x,y,theta\n${x},${y},${degrees}\n${x},${y},${degrees + 300}\n`);
          await page.click("#notice [data-choice=degrees]");
          await page.waitForSelector("#judged[data-state=judged][data-valid=false]");
          assert.match(
            await page.innerText("#judged"),
            /The car cannot drive 1 turn: the first, between waypoints 0 and 1, needs a radius of 0\.00 m/,
          );
          await page.check("#judged-arcs");
          await page.waitForSelector("#judged[data-state=judged]");
          scenario.free();
        },
      },
      restage,
    ),
  ));

test("timing and a judged path on a phone, and in forced colours", () =>
  onPausedPage(
    async (page) => {
      await openScenario(page, POST);
      await finish(page);
      await openTiming(page);
      await pickFile(page, "path.csv", "x,y\n1,1\n1,2\n3,2\n");
      await page.waitForSelector("#judged[data-state=judged]");
      await assertTargets(page);
    },
    { ...PHONE, forcedColors: "active" },
  ));
