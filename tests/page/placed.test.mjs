/**
 * Bodies and cars on the page: their edges, ways and words, their place in the square, and the hand that moves and
 * turns them.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { planners } from "planarium";
import { namesOfDocuments } from "../../www/domain/option-names.js";
import { decodeLink } from "../../www/planner/link/codec.js";
import { EVENT } from "../../www/planner/run-log/columns.js";
import { Placed } from "../../www/planner/stage/placed.js";
import { SvgContext } from "../../www/formats/svg.js";
import { View } from "planarium/draw";
import { allOf, readXml } from "./xml.mjs";
import { playbackOf } from "../../www/planner/stage/path-playback.js";
import { ending } from "../../www/planner/story.js";
import {
  chooseScene,
  fill,
  finish,
  linkOf,
  offered,
  onPausedPage,
  openScenario,
  pixelsOf,
  seek,
  textMatches,
  useBrowser,
  valueWithin,
  violations,
} from "./browser.mjs";
import { drag, near, openEditor, plane, press, until } from "./editing.mjs";
import { assertFaultless } from "./looks.mjs";
import { sceneOf } from "./library.mjs";
import { runOf } from "./runs.mjs";
import { inTurn, restage } from "./turns.mjs";

/** @import { ScenarioDocument } from "planarium" */

useBrowser();

/** An L in an empty square but for one disc. @type {ScenarioDocument} */
const L = {
  format: "planarium-scenario-1",
  name: "l",
  title: "An L",
  world: { bounds: { min: [-1, -1], max: [1, 1] }, obstacles: [{ type: "disc", center: [0, 0.6], radius: 0.2 }] },
  robot: {
    type: "rigid_body",
    shape: {
      type: "polygon",
      vertices: [
        [-0.05, -0.05],
        [0.3, -0.05],
        [0.3, 0.05],
        [0.05, 0.05],
        [0.05, 0.3],
        [-0.05, 0.3],
      ],
    },
  },
  queries: [{ name: "across", start: [-0.6, -0.6, 0], goal: [0.5, -0.4, 1.5] }],
};

/** A scene's run, to its end. @param {string} id */
function ended(id) {
  const { algorithm, settings } = sceneOf(id);
  const { scenario, run } = runOf(id, algorithm, settings);
  const { robot } = scenario.document();
  assert.ok(robot.type === "car" || robot.type === "rigid_body");
  return { scenario, run, placed: new Placed(robot) };
}

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
function apart(a, b) {
  const turn = Math.abs(a[2] - b[2]) % (2 * Math.PI);
  return Math.max(Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1]), Math.min(turn, 2 * Math.PI - turn));
}

test("an edge is drawn from its first vertex to its second, in pieces that hardly turn, all of it free", () => {
  for (const id of ["blossom", "witness", "parking", "turn", "lanes"]) {
    const { run, scenario } = ended(id);
    assert.ok(run.traces.count > run.edges.count, id);
    for (let e = 0; e < run.edges.count; e++) {
      const rows = run.along(e);
      const [from, to] = run.edges.row(e);
      assert.ok(
        apart(rows, run.vertices.row(from)) < 1e-9 && apart(rows.slice(-3), run.vertices.row(to)) < 1e-6,
        `${id}, edge ${e}`,
      );
      for (let i = 0; i + 3 < rows.length; i += 3) {
        assert.ok(apart([0, 0, rows[i + 2]], [0, 0, rows[i + 5]]) < 0.3, `${id}, edge ${e}`);
        assert.ok(scenario.check(rows.subarray(i, i + 3)).free);
      }
      const motions = run.motionsOf(e);
      assert.ok(motions.length > 0 && motions.length % 3 === 0);
    }
    run.free();
  }
});

test("what a driver does along an edge leads from its first vertex to its second", () => {
  const { run, placed } = ended("blossom");
  for (let e = 0; e < run.edges.count; e++) {
    const [from, to] = run.edges.row(e);
    const motions = run.motionsOf(e);
    /** @type {Float64Array} */
    let at = run.vertices.row(from);
    for (let i = 0; i < motions.length; i += 3) at = placed.after(at, motions.slice(i, i + 3), 1);
    assert.ok(apart(at, run.vertices.row(to)) < 1e-6, `edge ${e}`);
  }
  assert.match(
    placed.motionsText(Float64Array.of(0.5, Math.PI / 4, 1, -0.5, 0, 0.25)),
    /^Controls: v 0\.50 m\/s, \u03c6 45\u00b0 for 1\.00 s; then v \u22120\.50 m\/s, \u03c6 0\u00b0 for 0\.25 s\.$/,
  );
  run.free();
});

test("the way of a car passes its waypoints by exact arcs, with its wheels as they are steered, as long as the result says", () => {
  for (const id of ["blossom", "parking", "lanes"]) {
    const { run, scenario, placed } = ended(id);
    const playback = playbackOf(scenario, run, placed);
    assert.ok(playback?.course);
    const { path, motions = [], length } = run.result;
    assert.ok(Math.abs(playback.length - length) < 1e-6 * length, `${id}: ${playback.length} and ${length}`);
    path.forEach((waypoint, i) =>
      assert.ok(
        apart(playback.configuration(playback.reached[i] / playback.length), waypoint) < 1e-6,
        `${id}, waypoint ${i}`,
      ),
    );
    for (let part = 0; part <= 1; part += 0.001)
      assert.ok(scenario.check(playback.configuration(part)).free, `${id} at ${part}`);
    motions.forEach(({ control: [, phi] }, i) => {
      playback.seek((playback.reached[i] + playback.reached[i + 1]) / 2 / playback.length);
      assert.equal(playback.steering, phi);
    });
    assert.match(ending(run, playback), /: length \d+\.\d\d m, proven to be collision-free/);
    run.free();
  }
});

test("a car's wheels are drawn within its body, the front ones turned so that they roll without slipping", () => {
  const wheelbase = 0.2;
  const view = new View({ min: [-1, -1], max: [1, 1] }, 1000, 1000, { left: 0, right: 0, top: 0, bottom: 0 }, true);
  for (const front of [0.1, 0.17, 0.3]) {
    /** @type {[number, number][]} */
    const vertices = [
      [-0.1, -0.05],
      [front, -0.05],
      [front, 0.05],
      [-0.1, 0.05],
    ];
    const placed = new Placed({
      type: "car",
      shape: { type: "polygon", vertices },
      wheelbase,
      speed: [-1, 1],
      steering: [-1, 1],
    });
    for (const steering of [0, 0.7]) {
      const context = new SvgContext(1000, 1000);
      placed.drawMarks(/** @type {any} */ (context), view, [0, 0, 0], steering, "black");
      const wheels = allOf(readXml(context.toString()), "path")
        .flatMap(({ attributes }) => (attributes.fill === "none" ? [] : attributes.d.split("Z").filter(Boolean)))
        .map((d) =>
          (d.match(/-?[\d.]+ -?[\d.]+/g) ?? []).map((pair) =>
            view.toPlane(.../** @type {[number, number]} */ (pair.split(" ").map(Number))),
          ),
        );
      assert.equal(wheels.length, 4);
      for (const [x] of wheels.flat()) assert.ok(x <= front + 0.003, `a wheel at ${x}, before ${front}`);
      const [[a, b]] = wheels.slice(2);
      const centre = wheels[2].reduce((sum, [x]) => sum + x / 4, 0);
      // Every wheel of a turning car is at a right angle to the line to the centre of the turn.
      const turn = Math.atan2(b[1] - a[1], b[0] - a[0]);
      assert.ok(Math.abs(Math.tan(turn) - (centre / wheelbase) * Math.tan(steering)) < 0.1, `${front}: ${turn}`);
      if (front === 0.3) assert.ok(Math.abs(centre - wheelbase) < 0.003, "where there is room, at the wheelbase");
    }
  }
});

test("a body's edges and way are straight", () => {
  const { run, scenario, placed } = ended("corner");
  assert.deepEqual([run.traces.count, run.motions.count, run.along(0).length], [0, 0, 6]);
  const playback = playbackOf(scenario, run, placed);
  assert.ok(playback && playback.course === null && playback.steering === 0);
  run.free();
});

test("bodies and cars on the page", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "the square shows x and theta, or any two; a link keeps them": async (page) => {
          await chooseScene(page, "corner");
          assert.equal(await page.innerText("#cspace figcaption small"), "x across, theta up");
          assert.equal((await decodeLink(await linkOf(page))).experiment?.view.axes, undefined, "as usual");
          await page.click("#view-fold > summary");
          await page.waitForSelector("#view-up");
          assert.deepEqual(await page.locator("#view-up option").allInnerTexts(), ["x", "y", "theta"]);
          await page.selectOption("#view-up", "1");
          await textMatches(page, "#cspace figcaption small", /^x across, y up$/);
          assert.deepEqual((await decodeLink(await linkOf(page))).experiment?.view.axes, [0, 1]);
          await chooseScene(page, "stones");
          assert.equal(await page.isVisible("#view-plane"), false, "two angles need no choice");
        },

        "words speak of the body and of the car; axe finds nothing with a car at its goal": async (page) => {
          await chooseScene(page, "corner");
          assert.match(await page.innerText("#story"), /^Looking for a path from start to goal\. .*body/);
          assert.equal(await page.innerText("#workspace figcaption small"), "dots mark the body\u2019s origin");
          assert.deepEqual(await page.locator("#pose .name").allInnerTexts(), ["x", "y", "theta"]);
          await page.fill("#pose-0-number", "1.2");
          await page.press("#pose-0-number", "Tab");
          await page.waitForSelector("#touching[data-free=false]");
          assert.match(await page.innerText("#touching"), /^The body touches obstacle \d/);
          await chooseScene(page, "parking");
          assert.match(await page.innerText("#story"), /^Looking for a path from start to goal\. .*car/);
          assert.equal(await page.innerText("#workspace figcaption small"), "dots mark the car\u2019s rear axle");
          assert.equal(await page.innerText("#your-turn"), "Drive");
          assert.ok((await finish(page)).length > 0);
          await assertFaultless(page, "a car at its goal");
        },

        "what is pointed at on an edge tells its control, and shows all that the car passes over": async (page) => {
          await chooseScene(page, "blossom");
          await finish(page);
          const { run, scenario } = ended("blossom");
          // A place on the middle of an edge, far from every vertex and from every other edge.
          const vertices = run.vertices.slice(0, run.vertices.count);
          /** @type {number[][]} */
          const middles = Array.from({ length: run.edges.count }, (_, e) => {
            const rows = run.along(e);
            const at = 3 * Math.floor((rows.length / 3 - 1) / 2);
            return [e, ...scenario.interpolate(rows.slice(at, at + 3), rows.slice(at + 3, at + 6), 0.5)];
          });
          const found = middles.find(([e, x, y]) => {
            for (let v = 0; v < vertices.length; v += 3)
              if (Math.hypot(vertices[v] - x, vertices[v + 1] - y) < 0.07) return false;
            return middles.every(([other, ox, oy]) => other === e || Math.hypot(ox - x, oy - y) > 0.07);
          });
          assert.ok(found);
          const at = await plane(page, { min: [0, 0], max: [2, 2] });
          const before = await pixelsOf(page, "workspace", "top", "newest");
          await page.mouse.move(...at(found[1], found[2]));
          await textMatches(page, "#readout", /^Edge \d+, from vertex \d+ to \d+\. Controls?: v /);
          assert.ok((await pixelsOf(page, "workspace", "top", "newest")) > before + 80, "an outline");
          const vertex = run.edges.row(found[0])[1];
          await page.click("#view-fold > summary");
          await page.fill("#inspect", String(vertex));
          await page.mouse.move(5, 5);
          await textMatches(
            page,
            "#readout",
            new RegExp(`^Vertex ${vertex} at .* \\(m, m, rad\\)\\. Parent \\d+, .* Controls?: v `),
          );
          run.free();
        },

        "a vertex that was removed cannot be inspected, but before its removal it can": async (page) => {
          await chooseScene(page, "witness");
          const { run } = ended("witness");
          // As many iterations as timeline.test.mjs compares to the pixel.
          run.shown = 710;
          assert.ok(run.countOf(EVENT.removed) > 10, "some are removed by then");
          const [gone, event] = [...run.gone].find(([, removal]) => removal < run.past[2]) ?? assert.fail();
          const [, removedAt] = run.events.row(event);
          await page.click("#view-fold > summary");
          await page.fill("#inspect", String(gone));
          for (const [iteration, told] of /** @type {[number, string | null][]} */ ([
            [removedAt - 1, String(gone)],
            [710, null],
          ])) {
            await seek(page, iteration);
            assert.equal(await page.getAttribute("#readout", "data-vertex"), told, `iteration ${iteration}`);
          }
          run.free();
        },

        "settings with a name fill the fields; what is changed by hand is custom": async (page) => {
          assert.deepEqual(
            await offered(page, "planner"),
            [
              "prm",
              "prm-star",
              "lazy-prm",
              "lazy-prm-star",
              "visibility-prm",
              "rrt",
              "rrt-connect",
              "rrt-star",
              "informed-rrt-star",
              "fmt-star",
              "bit-star",
              "aorrtc",
            ],
            "an arm has no controls",
          );
          await chooseScene(page, "blossom");
          assert.equal(await page.inputValue("#preset"), "blossom-3");
          await page.selectOption("#preset", "blossom-5");
          await valueWithin(page, "parameter-blossom", 4, 6);
          assert.equal(await page.inputValue("#parameter-seed"), "1", "the seed stays");
          const preset = planners()
            .find(({ id }) => id === "rrt-control")
            ?.presets.find(({ id }) => id === "six-controls");
          assert.ok(preset);
          await page.selectOption("#preset", "six-controls");
          for (const [name, value] of Object.entries(namesOfDocuments(preset.settings))) {
            const field = page.locator(`#parameter-${name}`);
            assert.equal(
              await field.evaluate((control) =>
                control instanceof HTMLInputElement && control.type === "checkbox"
                  ? control.checked
                  : /** @type {HTMLInputElement} */ (control).value,
              ),
              typeof value === "boolean" ? value : String(value),
              name,
            );
          }
          await fill(page, "#parameter-goal_bias", "0.3");
          assert.equal(await page.inputValue("#preset"), "own");
          await page.selectOption("#preset", "");
          assert.equal(await page.inputValue("#parameter-goal_bias"), "0.05");
          assert.equal(await page.locator("#parameter-metric").count(), 0, "a car has no choice of metrics");
        },

        "by hand a body is moved from anywhere, and turned by the place before it": async (page) => {
          await openScenario(page, L);
          await page.click("#your-turn");
          const at = await plane(page, 1);
          await drag(page, [at(-0.6, -0.6), at(-0.4, -0.5), at(-0.2, -0.6)]);
          await valueWithin(page, "pose-0-number", -0.22, -0.18);
          assert.ok(Math.abs(Number(await page.inputValue("#pose-2-number"))) < 0.01, "it did not turn");
          const [hx, hy] = at(-0.2 + 0.3, -0.6);
          await drag(page, [[hx + 14, hy], [hx - 20, hy - 60], at(-0.2, -0.1)]);
          await valueWithin(page, "pose-2-number", Math.PI / 2 - 0.05, Math.PI / 2 + 0.05);
          await drag(page, [at(-0.2, -0.6), at(0, 0.3)]);
          await page.waitForSelector("#touching[data-free=false]");
          assert.equal(await page.innerText("#touching"), "The body touches obstacle 0.");
          await drag(page, [at(0, 0.3), at(0.5, -0.4)]);
          await textMatches(page, "#story", /You reached the goal, with one collision on the way/);
        },

        "in the editor a start is moved and turned by its handle and by keys; axe finds nothing": async (page) => {
          await openEditor(page, L);
          const at = await plane(page, 1);
          const value = async (/** @type {string} */ name) => Number(await page.inputValue(`#edit-${name}`));
          await drag(page, [at(-0.6, -0.6), at(-0.4, -0.4)]);
          await until(page, "changes", 1);
          near(await value("x"), -0.4, 0.02);
          near(await value("y"), -0.4, 0.02);
          assert.equal(await value("theta"), 0);
          const [hx, hy] = at(-0.4 + 0.3, -0.4);
          await drag(page, [[hx + 14, hy], [hx, hy - 70], at(-0.4, 0.1)]);
          await until(page, "changes", 2);
          near(await value("theta"), Math.PI / 2, 0.05);
          assert.match((await page.getAttribute("#editor", "data-title")) ?? "", /^Start, its heading$/);
          const turned = await value("theta");
          await page.focus("#stage");
          await press(page, ["ArrowRight"], "changes", 3);
          near(await value("theta"), turned + Math.PI / 180, 2e-4);
          await press(page, ["Escape", "ArrowRight"], "changes", 4);
          near(await value("theta"), turned + Math.PI / 180, 2e-4);
          await press(page, ["Control+z", "Control+z", "Control+z"], "redo", 3);
          assert.deepEqual(await violations(page, "#editor"), []);
        },
      },
      restage,
    ),
  ));
