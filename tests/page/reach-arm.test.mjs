/** The arm is dragged and keyed, has a square or axes, is made and opened; its motions and its ellipse are the core's. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Robot } from "../../www/reach/robot.js";
import { slidesOf } from "../../www/domain/coordinates.js";
import { ellipseOf } from "../../www/reach/jacobian.js";
import { SCENES } from "../../www/reach/scenes.js";
import { Motion, turnOf } from "../../www/reach/motion.js";
import { alphaOf, pickFile, pixelsOf, useBrowser } from "./browser.mjs";
import { choose, click, entryOf, onReach, poseOf, press, put, putBack, rest, scenarioOf, windowOf } from "./reach.mjs";
import { textOf } from "./library.mjs";
import { drag } from "./editing.mjs";
import { inTurn } from "./turns.mjs";

useBrowser();

test("a motion is the core's own where joints turn the short way, and is free as far as the core says", () => {
  for (const { id, a, b, q } of SCENES) {
    for (const pose of [a, b, q]) assert.ok(scenarioOf(id).check(pose).free, `${id}: ${pose}`);
    const robot = new Robot(entryOf(id).document, a);
    const short = new Motion(
      robot,
      a,
      b,
      a.map(() => "short"),
    );
    const hit = robot.scenario.firstHit(a, b);
    assert.equal(short.hit === null, hit === null, id);
    if (hit !== null) assert.ok(Math.abs((short.hit ?? 1) - hit) < 1e-2, `${id}: ${short.hit} ${hit}`);
    const long = new Motion(
      robot,
      a,
      b,
      a.map(() => "long"),
    );
    for (const motion of [short, long]) {
      const free = motion.hit ?? 1;
      for (let i = 0; i <= 400; i++)
        if (i / 400 < free - 1e-9) assert.ok(robot.isFree(robot.fitted(motion.at(i / 400))), `${id} at ${i / 400}`);
      const end = robot.fitted(motion.at(1));
      b.forEach((value, i) => assert.ok(Math.abs(Math.sin((end[i] - value) / 2)) < 1e-9));
    }
    long.turns.forEach((turn, i) => {
      // Where a joint need not turn, it does not.
      if (!robot.coordinates[i].isCircle || short.turns[i] === 0) assert.equal(turn, short.turns[i]);
      else assert.ok(Math.abs(Math.abs(turn - short.turns[i]) - 2 * Math.PI) < 1e-9);
    });
  }
});

test("the faulty way turns as far as the short way, and ends at B unless two angles differ by more than half a turn", () => {
  assert.ok(Math.abs(turnOf(-3, 3, true, "faulty") - (2 * Math.PI - 6)) < 1e-12);
  assert.equal(turnOf(-3, 3, false, "faulty"), 6, "what does not wrap has one way");
  for (let i = 0; i < 50; i++) {
    const [from, to] = [Math.PI * Math.sin(2.7 * i), Math.PI * Math.sin(1 + 4.1 * i)];
    const [short, faulty] = /** @type {const} */ (["short", "faulty"]).map((way) => turnOf(from, to, true, way));
    assert.equal(Math.abs(faulty), Math.abs(short));
    assert.equal(Math.abs(Math.sin((from + faulty - to) / 2)) < 1e-9, Math.abs(to - from) <= Math.PI, `${from} ${to}`);
  }
});

test("an arm is dragged and keyed", (t) =>
  onReach(
    inTurn(
      t,
      {
        "keys turn joints by five degrees; what collides is taken back where that is wanted": async (page) => {
          const scenario = scenarioOf("islands");
          await put(page, "joint-1-number", "0");
          let q = await poseOf(page);
          await press(page, "#stage", "Shift+2", "2", "Shift+1", "1");
          assert.ok((await poseOf(page)).every((angle, i) => Math.abs(angle - q[i]) < 1e-12));
          await press(page, "#stage", "3");
          await click(page, "label[for=back]");
          const turned = (/** @type {number[]} */ [a, b]) => [a + Math.PI / 36, b];
          const names = ["1"];
          for (; scenario.firstHit(q, turned(q)) === null; names.push("1")) q = turned(q);
          await press(page, "#stage", ...names);
          assert.ok(
            (await poseOf(page)).every((angle, i) => Math.abs(angle - q[i]) < 1e-9),
            "the last turn is taken back",
          );
          assert.equal(await page.getAttribute("#stage", "data-free"), "true");
          assert.match(
            await page.innerText("#story"),
            /^Taken back: joint 1 turned 5\u00b0 counter-clockwise, and link 2 touches obstacle 0\.$/,
          );
          await click(page, "label[for=back]");
          await press(page, "#stage", "1");
          assert.equal(await page.getAttribute("#stage", "data-free"), "false");
        },

        "the tip follows the mouse; a link turns its own joint alone": async (page) => {
          const scenario = scenarioOf("islands");
          const before = await poseOf(page);
          const [x0, y0] = await windowOf(page, "islands", scenario.endEffector(before));
          const [x1, y1] = await windowOf(page, "islands", [0.3, -0.6]);
          await page.mouse.move(x0, y0);
          await page.mouse.down();
          for (let i = 1; i <= 8; i++) {
            await page.mouse.move(x0 + ((x1 - x0) * i) / 8, y0 + ((y1 - y0) * i) / 8);
            await rest(page);
          }
          await page.mouse.up();
          await rest(page);
          const q = await poseOf(page);
          const [tx, ty] = scenario.endEffector(q);
          assert.ok(Math.hypot(tx - 0.3, ty + 0.6) < 0.02, `${tx} ${ty}`);
          const elbow = scenario.footprint(q)[1];
          assert.ok(elbow.type === "capsule");
          const middle = /** @type {[number, number]} */ ([
            (elbow.a[0] + elbow.b[0]) / 2,
            (elbow.a[1] + elbow.b[1]) / 2,
          ]);
          const [mx, my] = await windowOf(page, "islands", middle);
          await drag(page, [
            [mx, my],
            [mx + 25, my + 25],
          ]);
          await rest(page);
          const turned = await poseOf(page);
          assert.equal(turned[0], q[0]);
          assert.ok(Math.abs(turned[1] - q[1]) > 0.05);
        },

        "the last link keeps its direction while the tip goes, where there are joints for it": async (page) => {
          assert.equal(await page.isDisabled("#keep"), true);
          assert.match(await page.innerText("#keep-hint"), /third/);
          await choose(page, "corner");
          await page.check("#keep");
          await rest(page);
          const sum = (/** @type {number[]} */ q) => q.reduce((a, b) => a + b, 0);
          const kept = sum(await poseOf(page));
          await press(page, "#stage", "ArrowUp", "ArrowRight", "Shift+ArrowDown");
          assert.ok(Math.abs(Math.sin((sum(await poseOf(page)) - kept) / 2)) < 1e-6);
          assert.ok(await page.isVisible("#direction"));
          await put(page, "direction-number", "1");
          assert.ok(Math.abs(Math.sin((sum(await poseOf(page)) - 1) / 2)) < 1e-6);
        },
      },
      putBack,
    ),
  ));

test("its ellipse is the core's manipulability, and what the tip does when the joints turn a little", () => {
  for (const { id, q } of SCENES) {
    const scenario = scenarioOf(id);
    const { major, minor, angle, manipulability } = ellipseOf(
      scenario.footprint(q),
      slidesOf(/** @type {import("../../www/domain/coordinates.js").ArmRobot} */ (scenario.document().robot), q),
    );
    const tip = scenario.endEffector(q);
    const { manipulability: wanted } = scenario.follow(q, tip);
    assert.ok(Math.abs(manipulability - wanted) < 1e-9 * (1 + wanted), `${id}: ${manipulability} ${wanted}`);
    assert.ok(Math.abs(major * minor - manipulability) < 1e-12);
    // Along the major axis goes the farthest of many small turns of length 1.
    let most = 0;
    for (let k = 0; k < 4000; k++) {
      const turn = q.map((_, i) => Math.sin(1 + 7.13 * k * (i + 1)));
      const length = Math.hypot(...turn);
      const [x, y] = scenario.endEffector(q.map((value, i) => value + (1e-6 * turn[i]) / length));
      most = Math.max(most, Math.abs((x - tip[0]) * Math.cos(angle) + (y - tip[1]) * Math.sin(angle)) / 1e-6);
    }
    assert.ok(most <= major * (1 + 1e-4), `${id}: ${most} ${major}`);
    if (q.length <= 3) assert.ok(most > 0.97 * major, `${id}: ${most} ${major}`);
  }
});

test("an arm has a square or axes, is made and is opened", (t) =>
  onReach(
    inTurn(
      t,
      {
        "the arm is made of 1 to 8 links, longer and shorter, thick and thin, with stops and without": async (page) => {
          for (const count of [8, 1, 3]) {
            await put(page, "links-number", String(count));
            assert.equal((await poseOf(page)).length, count);
            assert.equal(await page.locator("#joints input[type=range]").count(), count);
          }
          await put(page, "link-2-number", "0.9");
          await put(page, "radius-number", "0.08");
          await click(page, "label[for=stops]");
          assert.equal(await page.locator("#intervals input").count(), 6);
          await put(page, "stop-0-0", "0.5");
          assert.ok((await poseOf(page))[0] >= 0.5, "what was beyond a stop is at it");
          await put(page, "stop-0-1", "0.1");
          assert.match(await page.innerText("#arm-reason"), /limits of joint 1/);
          await put(page, "stop-0-1", "2");
          assert.equal(await page.isHidden("#arm-reason"), true);
          await click(page, "label[for=stops]");
          assert.equal(await page.locator("#intervals input").count(), 0);
        },

        "two joints are a square of the core's obstacles without a border; a drag in it is a pose": async (page) => {
          await page.waitForSelector("#stage[data-cells=true]");
          await rest(page);
          const share = await pixelsOf(page, "cspace", "ground", "obstacle");
          assert.ok(share > 2000, `${share}`);
          const box = (await page.locator("#cspace canvas[data-layer=top]").boundingBox()) ?? assert.fail();
          const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
          await drag(page, [
            [x, y],
            [x + 40, y - 30],
          ]);
          await rest(page);
          const [a, b] = await poseOf(page);
          assert.ok(a > 0.2 && b > 0.1, `${a} ${b}`);
          // Beside the border there is a twin on the other side.
          await put(page, "joint-0-number", "3.1");
          await put(page, "joint-1-number", "-2");
          const { free } = scenarioOf("islands").check([3.1, -2]);
          assert.ok(free);
          const { width, alpha } = await alphaOf(page, "cspace", "top");
          const covered = [true, false].map(
            (isLeft) => alpha.filter((dense, i) => dense > 40 && i % width < width / 2 === isLeft).length,
          );
          assert.ok(covered[0] > 20 && covered[1] > 20, `${covered}`);
        },

        "more joints have an axis for each; a drag along one turns that joint alone; stops are bars": async (page) => {
          await choose(page, "limits");
          assert.equal(await page.isVisible("#cspace"), false);
          const before = await poseOf(page);
          const box = (await page.locator("#axes canvas[data-layer=top]").boundingBox()) ?? assert.fail();
          const x = box.x + box.width - 24;
          await drag(page, [
            [x, box.y + box.height / 2],
            [x, box.y + box.height * 0.7],
          ]);
          await rest(page);
          const q = await poseOf(page);
          assert.deepEqual(q.slice(0, 2), before.slice(0, 2));
          assert.ok(q[2] < -0.3 && q[2] >= -1.6, `${q[2]}`);
          await drag(page, [
            [x, box.y + 10],
            [x, box.y - 40],
          ]);
          await rest(page);
          assert.equal((await poseOf(page))[2], 1.6, "it ends at its stop");
        },

        "the arm is that of a scenario of the reader's own; one that cannot be, or without an arm, is refused": async (
          page,
        ) => {
          const text = JSON.stringify({
            ...entryOf("islands").document,
            robot: { type: "arm", base: [0.62, 0.62], links: [1] },
            queries: [],
          });
          const kept = await poseOf(page);
          await pickFile(page, "bad.json", text);
          await page.waitForSelector("#notice[data-code=base-in-collision]");
          assert.deepEqual(await poseOf(page), kept);
          await pickFile(page, "shelf.json", textOf("shelf"));
          await page.waitForSelector("body[data-scene=file]");
          await rest(page);
          assert.deepEqual(await poseOf(page), [1.42, -1.2, -0.22]);
          await pickFile(page, "museum.json", textOf("museum"));
          await page.waitForSelector("#notice[data-code=unsupported]");
          assert.match(await page.innerText("#notice"), /This page is for arms/);
        },
      },
      putBack,
    ),
  ));
