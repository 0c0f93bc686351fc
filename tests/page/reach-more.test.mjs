/** The page of the arm: inverse kinematics to watch, links and files, and for whom it is. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Scenario, reachMethods } from "planarium/full";
import { encodeState } from "../../www/app/link.js";
import { BODIES } from "../../www/reach/scenes.js";
import { decodeLink } from "../../www/planner/link/codec.js";
import { DESK, download, fill, keys, linkOf, pickFile, pixelsOf, useBrowser } from "./browser.mjs";
import { drag, plane } from "./editing.mjs";
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
  solved,
  windowOf,
} from "./reach.mjs";
import { allOf, readXml } from "./xml.mjs";
import { load, textOf } from "./library.mjs";
import { inTurn, openState } from "./turns.mjs";

useBrowser();

/** A motion by the faulty way, at its end. */
const FAULTY = await encodeState(
  { scene: "plane", mode: "between", a: [-3, 0.5], b: [3, 0.5], faulty: [0, 1], along: 1, back: true },
  () => {},
);

test("inverse kinematics to watch, bodies, files and colours", (t) =>
  onReach(
    inTurn(
      t,
      {
        "every method goes down to the target; the closed form is not for many joints, and says so": async (page) => {
          await page.click("#mode-solve");
          for (const { id } of reachMethods()) {
            await page.selectOption("#method", id);
            await rest(page);
            await solved(page);
            assert.ok(Number(await page.getAttribute("#solve", "data-solutions")) >= 1, id);
            if (id === "closed-form")
              assert.match(
                await page.innerText("#story"),
                /^Two configurations reach the target \(elbow up and elbow down\); [^;]*\.$/,
              );
          }
          await choose(page, "tentacle");
          await page.selectOption("#method", "closed-form");
          await page.waitForSelector("#solve[data-status=refused]", { state: "attached" });
          assert.match(await page.innerText("#notice"), /closed form for 1 or 2 links/);
          await page.selectOption("#method", "newton");
          await page.waitForSelector("#solve[data-status=running]", { state: "attached" });
          assert.equal(await page.isHidden("#notice"), true);
        },

        "a scenario with a target brings it along": async (page) => {
          await pickFile(page, "pick.json", textOf("pick"));
          await page.waitForSelector("body[data-scene=file]");
          await click(page, "#mode-solve");
          await solved(page);
          const [x, y] = load("pick").endEffector(await poseOf(page));
          assert.ok(Math.hypot(x - 1.55, y - 0.6) < 1e-8, `${x} ${y}`);
        },

        "a body goes from A to B in a straight line, is dragged and turned, and knows no inverse kinematics": async (
          page,
        ) => {
          await page.click("#mode-solve");
          await choose(page, "plan-corner");
          assert.deepEqual(
            [
              await page.getAttribute("body", "data-mode"),
              await page.isVisible("#mode-solve"),
              await page.isVisible("#arm-fold"),
            ],
            ["hand", false, false],
          );
          const scenario = load("corner");
          const [{ start, goal = [] }] = scenario.document().queries;
          assert.deepEqual(await poseOf(page), start);
          const at = await plane(page, scenario.extent());
          await drag(page, [at(start[0] + 0.1, start[1]), at(start[0] + 0.2, start[1] + 0.15)]);
          await rest(page);
          const moved = await poseOf(page);
          assert.ok(
            Math.abs(moved[0] - start[0] - 0.1) < 0.01 && Math.abs(moved[1] - start[1] - 0.15) < 0.01 && moved[2] === 0,
            `${moved}`,
          );
          await press(page, "#stage", "PageUp", "ArrowRight");
          const turned = await poseOf(page);
          assert.ok(
            Math.abs(turned[2] - Math.PI / 36) < 1e-12 && Math.abs(turned[0] - moved[0] - 0.024) < 1e-9,
            `${turned}`,
          );
          await click(page, "#mode-between");
          assert.equal(await page.getAttribute("#between", "data-hit"), String(scenario.firstHit(start, goal)));
          assert.match(
            await page.innerText("#story"),
            /^The body moves 2\.06 m, and theta turns 3\.14 rad the short way round\. The motion collides after \d+\s%: the body touches obstacle \d\.$/,
          );
          for (let i = 0; i < 10; i++) await click(page, "#between-step-10");
          assert.ok(scenario.distance(await poseOf(page), goal) < 1e-9);
          await click(page, "#rounds button[data-direction=long]");
          assert.match(await page.innerText("#story"), /long way round/);
          assert.ok(scenario.distance(await poseOf(page), goal) < 1e-9, "it ends at B this way, too");
          const { text } = await (await page.click("#export-fold > summary"), download(page, "#export-scenario"));
          assert.equal(Scenario.parse(text).robot, "rigid_body");
        },

        "the stage as PNG and SVG, the scenario as JSON": async (page) => {
          await page.waitForSelector("#stage[data-cells=true]");
          await page.click("#mode-between");
          await page.click("#export-fold > summary");
          assert.equal((await download(page, "#export-png")).bytes.subarray(1, 4).toString(), "PNG");
          const svg = (await download(page, "#export-svg")).text;
          assert.match(svg, /^<svg[\s\S]+<\/svg>\s*$/);
          assert.doesNotMatch(
            svg,
            /data:image/,
            "obstacles of the configuration space are outlines, sharp at any size",
          );
          assert.ok(allOf(readXml(svg), "path").length > 20);
          Scenario.parse((await download(page, "#export-scenario")).text).free();
        },

        "in forced colours the arm is drawn, and no plate is under the word of what is chosen": async (page) => {
          await page.emulateMedia({ forcedColors: "active" });
          await rest(page);
          await click(page, "#mode-between");
          await click(page, "#mode-hand");
          const [adjust, colour, ground] = await page.locator("#mode-hand").evaluate((button) => {
            const { forcedColorAdjust, color, backgroundColor } = getComputedStyle(button);
            return [forcedColorAdjust, color, backgroundColor];
          });
          assert.equal(adjust, "none");
          assert.notEqual(colour, ground);
          assert.ok((await pixelsOf(page, "workspace", "top", "robot")) > 100);
        },

        "the planner's page is handed the arm and the target": async (page) => {
          await click(page, "#mode-solve");
          await page.waitForFunction(() => (document.getElementById("plan")?.getAttribute("href") ?? "").length > 20);
          const { experiment } = await decodeLink(((await page.getAttribute("#plan", "href")) ?? "").split("#")[1]);
          const { queries, robot } = /** @type {any} */ (experiment?.document);
          assert.deepEqual(queries, [
            { name: "reach", start: entryOf("islands").q, target: { point: entryOf("islands").target } },
          ]);
          assert.deepEqual(robot.links, linksOf("islands"));
          await page.click("#plan");
          await page.waitForSelector("#counters[data-settled=true][data-status=running]", { state: "attached" });
          await page.click("#finish");
          await page.waitForSelector("#counters[data-settled=true][data-status=solved]", { state: "attached" });
          assert.equal(await page.isHidden("#notice"), true);
        },
      },
      putBack,
    ),
  ));

test("a target out of reach is said to be, with the nearest point; one in collision too", async () => {
  await onReach(async (page) => {
    await page.click("#mode-solve");
    await page.focus("#stage");
    await keys(page, ...Array(12).fill("Shift+ArrowRight"));
    await page.click("#solve-finish");
    await page.waitForSelector("#solve[data-verdict=out-of-reach]", { state: "attached" });
    await rest(page);
    assert.match(await page.innerText("#story"), /too far away.*nearest point/);
    await page.check("#solve-free_only");
    // Into the disc at (0.62, 0.62).
    const [x, y] = await windowOf(page, "islands", [0.55, 0.6]);
    await page.mouse.click(x, y);
    await rest(page);
    await page.click("#solve-finish");
    await page.waitForSelector("#solve[data-verdict=in-collision]", { state: "attached" });
    await rest(page);
    assert.match(await page.innerText("#story"), /All solutions found collide: link \d touches obstacle/);
  });
});

test("a link of an arm shows the same again", (t) =>
  onReach(
    inTurn(
      t,
      {
        "a link shows the same again: arm, pose, way and run": async (page) => {
          await choose(page, "window");
          await put(page, "link-1-number", "0.5");
          // A pose of many digits.
          await press(page, "#stage", "ArrowUp");
          await page.click("#mode-solve");
          await fill(page, "#solve-seed", "5");
          await click(page, "#solve-step-10");
          const fragment = await linkOf(page);
          assert.ok(fragment.length <= 2049);
          const [q, fingerprint] = [await poseOf(page), await page.getAttribute("#solve", "data-fingerprint")];
          assert.match(fingerprint ?? "", /^[0-9a-f]{16}$/);
          await onReach(
            async (other) => {
              assert.equal(await other.getAttribute("body", "data-scene"), "window");
              assert.equal(await other.getAttribute("body", "data-mode"), "solve");
              assert.deepEqual(await poseOf(other), q);
              assert.equal(await other.getAttribute("#solve", "data-iterations"), "10");
              assert.equal(await other.getAttribute("#solve", "data-fingerprint"), fingerprint);
              assert.equal(await other.inputValue("#link-1-number"), "0.500");
              assert.equal(await other.inputValue("#solve-seed"), "5");
            },
            DESK,
            { path: `reach.html${fragment}` },
          );
        },

        "the faulty way ends elsewhere than at B, and that is said and marked; a link holds it": async (page) => {
          await openState(page, FAULTY);
          await rest(page);
          assert.deepEqual(
            [await page.getAttribute("#between", "data-missed"), await poseOf(page)],
            ["1", [2 * Math.PI - 9, 0.5]],
          );
          assert.match(
            await page.innerText("#story"),
            /^Faulty: joint 1 ends at \u22122\.72 rad instead of 3\.00 rad, so the motion does not end at B\./,
          );
          for (const pane of ["workspace", "cspace"])
            assert.ok((await pixelsOf(page, pane, "top", "rejected")) > 20, pane);
          const fragment = await linkOf(page);
          await click(page, "#all-short");
          assert.equal(await page.getAttribute("#between", "data-missed"), "0");
          assert.match(await page.innerText("#story"), /^Each joint turns the short way round, 0\.28 rad/);
          await onReach(
            async (other) => {
              assert.match(await other.innerText("#story"), /^Faulty/);
              assert.equal(await other.isChecked("#back"), true);
            },
            DESK,
            { path: `reach.html${fragment}` },
          );
        },

        "a link that slides is dragged along its direction, moved by keys, and changed; the link holds it": async (
          page,
        ) => {
          await choose(page, "boom");
          const { a, b } = windowAxes(await poseOf(page));
          // The middle of the second link: dragged out by 0.1 m, and aside, which does nothing.
          const middle = /** @type {[number, number]} */ ([0.5 * a[0], 0.5 * a[1]]);
          const out = /** @type {[number, number]} */ ([
            middle[0] + 0.1 * b[0] - 0.05 * b[1],
            middle[1] + 0.1 * b[1] + 0.05 * b[0],
          ]);
          await drag(page, [await windowOf(page, "boom", middle), await windowOf(page, "boom", out)]);
          await rest(page);
          const [angle, slid] = await poseOf(page);
          assert.equal(angle, 0.1);
          assert.ok(Math.abs(slid - 0.45) < 0.01, `${slid}`);
          // The tip follows the core, also beyond its reach, where nothing is claimed to be nearest.
          await press(page, "#stage", "ArrowUp", "2", "Shift+2");
          assert.ok(Math.abs((await poseOf(page))[1] - slid) < 0.1);
          await page.click("#mode-between");
          await rest(page);
          assert.match(await page.innerText("#story"), /1\.35 rad and 0\.00 m in total/);
          await page.click("#mode-hand");
          // A third link turns, then slides at an angle.
          await put(page, "links-number", "3");
          assert.equal((await poseOf(page)).length, 3);
          await page.selectOption("#joint-2-type", "prismatic");
          await rest(page);
          await put(page, "stop-2-angle", "1.5");
          await put(page, "stop-2-1", "0.25");
          await put(page, "stop-2-0", "0.3");
          assert.match(
            await page.innerText("#arm-reason"),
            /The range of joint 3 must be two numbers, the lower first/,
          );
          await put(page, "joint-2-number", "0.2");
          const q = await poseOf(page);
          const fragment = await linkOf(page);
          await onReach(
            async (other) => {
              assert.deepEqual(await poseOf(other), q);
              assert.deepEqual(
                await other
                  .locator("#intervals select")
                  .evaluateAll((all) => all.map((one) => /** @type {HTMLSelectElement} */ (one).value)),
                ["revolute", "prismatic", "prismatic"],
              );
              assert.equal(await other.inputValue("#stop-2-angle"), "1.50");
            },
            DESK,
            { path: `reach.html${fragment}` },
          );
          // All turn again: the scene's joints are gone, and the link says so.
          for (const i of [1, 2]) await page.selectOption(`#joint-${i}-type`, "revolute");
          await rest(page);
          const turning = await linkOf(page);
          await onReach(
            async (other) => {
              assert.equal(
                await other
                  .locator("#intervals select")
                  .evaluateAll(
                    (all) => all.filter((one) => /** @type {HTMLSelectElement} */ (one).value === "revolute").length,
                  ),
                3,
              );
            },
            DESK,
            { path: `reach.html${turning}` },
          );
        },
      },
      putBack,
    ),
  ));

test("scenes of bodies have bodies", async () => {
  for (const { id } of BODIES) assert.equal(load(id.replace("plan-", "")).robot, "rigid_body", id);
});

/** The tip of the boom from its base, and the direction of its second link. @param {number[]} q */
function windowAxes([angle, slid]) {
  const b = [Math.cos(angle), Math.sin(angle)];
  return { a: b.map((x) => x * (0.45 + slid + 0.3)), b };
}
