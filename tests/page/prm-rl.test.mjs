/** The page of learned edges: it plans by PRM-RL, drives in several ways, and teaches. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Navigation, rolloutOptions } from "planarium/full";
import { countsOf, poseAt } from "../../www/prm-rl/session.js";
import { fill, linkOf, pixelsOf, pressUntil, useBrowser } from "./browser.mjs";
import { EMPTY, inTurn } from "./turns.mjs";
import { ROADMAP, policy, first, onLearned } from "./learned.mjs";
import { CALM, rest, told } from "./stage.mjs";

useBrowser();

/** What a planner of the package finds. @param {ReturnType<Navigation["planner"]>} planner */
function planned(planner) {
  planner.step(1e9);
  return planner.result();
}

/**
 * How a number of drives of the package end.
 * @param {Navigation} task
 * @param {number[][]} path
 * @param {boolean} isLearned
 * @param {number} [trials]
 */
const driven = (task, path, isLearned, trials = 20) =>
  countsOf(
    Array.from({ length: trials }, (_, trial) => task.execute(path.flat(), { trial, ...(isLearned && { policy }) })),
  );

test("a robot is drawn where the trace has it, and between two time steps in between", () => {
  const drive = first.execute([...first.toJSON().queries[0].start.slice(0, 2), 3.9, 4], { policy });
  assert.deepEqual(poseAt(drive, 0, 0.2), [...drive.trace.slice(0, 3)]);
  assert.deepEqual(poseAt(drive, 1e9, 0.2), [...drive.trace.slice(-3)]);
  assert.ok(Math.abs(poseAt(drive, 0.3, 0.2)[0] - (drive.trace[3] + drive.trace[6]) / 2) < 1e-12);
});

test("at first the page plans by PRM-RL, drives and plays", () =>
  onLearned(async (page) => {
    await page.waitForSelector("#course-play[data-playing=true]");
    await page.waitForFunction(() => Number(document.getElementById("stage")?.dataset.time) > 0.5);
  }, {}));

test("PRM-RL plans, drives and plays", (t) =>
  onLearned(
    inTurn(
      t,
      {
        "with reduced motion all of it is shown; an edge of the path shows its rollouts, from the list and under the pointer":
          async (page) => {
            const { status, way, edges, fingerprint, reached, drives } = await told(page);
            const result = planned(first.planner(policy, ROADMAP));
            const { reached: all } = driven(first, result.path, true);
            assert.deepEqual(
              [status, way, fingerprint, edges],
              ["solved", "prm-rl", result.fingerprint, String(result.path.length - 1)],
            );
            assert.deepEqual([reached, drives], [String(all), "20"]);
            assert.match(await page.innerText("#story"), new RegExp(`^PRM-RL: ${all} of 20 drives reached the goal`));
            const rollouts = first.edgeRollouts(policy, result.path.flat(), ROADMAP);
            assert.deepEqual(
              await page.locator("#edges button > span:first-child").allInnerTexts(),
              rollouts.map(
                ({ of, forward, backward }) => `rollouts: ${forward} of ${of} there, ${backward} of ${of} back`,
              ),
            );
            assert.doesNotMatch(await page.innerText("main"), /proven (?!free)/, "nothing learned is called proven");
            for (const colour of ["unproven", "goal", "newest", "robot"])
              assert.ok((await pixelsOf(page, "floor", "top", colour)) > 50, colour);
            assert.ok((await pixelsOf(page, "floor", "roadmap", "growth")) > 100);
            assert.equal(await pixelsOf(page, "floor", "top", "ink"), 0);
            await page.focus("#edge-3");
            await rest(page, "[data-edge='2']");
            assert.ok((await pixelsOf(page, "floor", "top", "ink")) > 20);
            await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
            await rest(page, "[data-edge='']");
            const [from, to] = result.path.slice(8, 10);
            const { min, max } = first.toJSON().world.bounds ?? assert.fail();
            await page.locator("#floor").scrollIntoViewIfNeeded();
            const box = (await page.locator("#floor canvas[data-layer=top]").boundingBox()) ?? assert.fail();
            const scale = Math.min((box.width - 28) / (max[0] - min[0]), (box.height - 28) / (max[1] - min[1]));
            const [x, y] = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
            await page.mouse.move(
              box.x + box.width / 2 + scale * (x - (min[0] + max[0]) / 2),
              box.y + box.height / 2 - scale * (y - (min[1] + max[1]) / 2),
            );
            await rest(page, "[data-edge='8']");
          },

        "the drives are played and shown at any time; options of the roadmap equal the package's, and are refused beside their field":
          async (page) => {
            await page.fill("#time", "10");
            await rest(page, "[data-time='10.000']");
            await page.focus("#stage");
            await pressUntil(page, "r", "#stage[data-time='0.000']");
            for (const { name, meaning } of rolloutOptions())
              assert.equal(
                await page
                  .locator(`#plan-${name}-meaning`)
                  .textContent()
                  .then((text) => text?.startsWith(meaning)),
                true,
                name,
              );
            await fill(page, "#plan-least_share", "0.6");
            const loose = planned(first.planner(policy, { ...ROADMAP, leastShare: 0.6 }));
            await rest(page, `[data-fingerprint="${loose.fingerprint}"]`);
            await fill(page, "#plan-least_share", "2");
            await page.waitForSelector("#plan-least_share-reason:not([hidden])");
          },

        "each way drives as the package does: the policy alone gets stuck, straight edges collide": async (page) => {
          const [{ start, goal }] = first.toJSON().queries;
          for (const [way, path] of /** @type {[string, number[][]][]} */ ([
            ["policy", [start.slice(0, 2), [...goal]]],
            ["straight", planned(first.straightPlanner(ROADMAP)).path],
          ])) {
            await page.click(`#way-${way}`);
            await page.click("#drive");
            await rest(page, `[data-way=${way}][data-drives='20']`);
            const { reached, collision, timeout } = driven(first, path, way === "policy");
            assert.ok(reached < 10, `${way}: ${reached}`);
            assert.deepEqual(
              await page
                .locator(`#driven tr[data-way=${way}] td`)
                .allInnerTexts()
                .then((cells) => cells.slice(2, 5)),
              [`${reached} of 20`, String(collision), String(timeout)],
            );
            assert.ok((await pixelsOf(page, "floor", "top", collision > timeout ? "collision" : "rejected")) > 15, way);
          }
          await fill(page, "#drives-trials", "5");
          await page.click("#drive");
          await rest(page, "[data-drives='5']");
        },

        "start and goal are moved by keys, sliders and dragging; in collision that is said, and then planned anew":
          async (page) => {
            await page.focus("#stage");
            const { goal } = await told(page);
            await pressUntil(page, "ArrowLeft", "#stage[data-status=none]");
            const [x, y] = goal.split(",").map(Number);
            assert.equal((await told(page)).goal, [x - 0.05, y].join());
            await page.click("#moved-start");
            await page.focus("#stage");
            const { start } = await told(page);
            await pressUntil(page, "PageUp", `#stage:not([data-start="${start}"])`);
            // A wall is at the left and below.
            await fill(page, "#start-x-number", "0.1");
            await rest(page, "[data-status=refused]");
            assert.match(await page.innerText("#story"), /^The start is in collision/);
            assert.ok(await page.isDisabled("#drive"));
            await fill(page, "#start-x-number", "3.2");
            await rest(page, "[data-status=none]");
            await page.click("#plan");
            await rest(page, "[data-status=solved]");
            const { start: from, goal: to, fingerprint } = await told(page);
            const [sx, sy, theta] = from.split(",").map(Number);
            const [gx, gy] = to.split(",").map(Number);
            const task = Navigation.parse({
              ...first.toJSON(),
              queries: [{ name: "query", start: [sx, sy, theta], goal: [gx, gy] }],
            });
            assert.equal(fingerprint, planned(task.straightPlanner(ROADMAP)).fingerprint);
            const box = (await page.locator("#floor canvas[data-layer=top]").boundingBox()) ?? assert.fail();
            const scale = Math.min((box.width - 28) / 20, (box.height - 28) / 15);
            const place = (/** @type {number} */ px, /** @type {number} */ py) =>
              /** @type {const} */ ([
                box.x + box.width / 2 + scale * (px - 10),
                box.y + box.height / 2 - scale * (py - 7.5),
              ]);
            await page.mouse.move(...place(gx, gy));
            await page.mouse.down();
            await page.mouse.move(...place(gx - 1, gy), { steps: 3 });
            await page.mouse.up();
            await rest(page, "[data-status=none]");
            const [dragged] = (await told(page)).goal.split(",").map(Number);
            assert.ok(Math.abs(dragged - (gx - 1)) < 0.1, `${dragged}`);
          },

        "the lesson asks five questions, and answers with what was driven": async (page) => {
          await page.click("#begin-lesson");
          for (const step of [1, 2, 3, 4, 5]) {
            await page.waitForSelector(`#lesson[data-step='${step}'][data-shown=question]`);
            if (step === 3) await page.locator("#lesson input").nth(2).check();
            await page.click("#lesson-run");
            await page.waitForSelector("#lesson[data-shown=answer]");
            await rest(page);
            const text = await page.innerText("#lesson .outcome");
            if (step > 1) {
              const { reached, drives } = await told(page);
              assert.equal(drives, "20");
              assert.match(text, new RegExp(`\\b${reached} of 20 drives`), `step ${step}: ${text}`);
              if (step === 2) assert.ok(Number(reached) >= 18, text);
              if (step === 3) assert.ok(Number(reached) <= 2 && text.startsWith("Correct."), text);
              if (step === 5) assert.ok(Number(reached) >= 17, text);
            }
            await page.click("#lesson-next");
          }
          assert.ok(await page.isHidden("#lesson"));
        },

        "another floor is made": async (page) => {
          await fill(page, "#kind", "furnished");
          await rest(page, "[data-status=none]");
          assert.match(await page.innerText(".where-now"), /furnished/i);
        },
      },
      // Each goes on from what the one before it has left: to plan takes seconds.
      async () => {},
    ),
  ));

test("a link shows the same plan, drives and time, and the step of a lesson", async () => {
  const reached = (/** @type {Record<string, string>} */ data) =>
    ["fingerprint", "reached", "drives", "time", "way", "start", "goal"].map((name) => data[name]);
  let fragment = "";
  /** @type {Record<string, string>} */
  let before = {};
  await onLearned(
    async (page) => {
      await page.click("#way-straight");
      await fill(page, "#plan-margin", "0.1");
      await rest(page, "[data-way=straight][data-status=solved]");
      await fill(page, "#drives-trials", "3");
      await page.click("#drive");
      await rest(page, "[data-drives='3']");
      await page.fill("#time", "1");
      await rest(page, "[data-time='1.000']");
      fragment = await linkOf(page);
      before = await told(page);
    },
    CALM,
    `#${EMPTY}`,
  );
  await onLearned(
    async (page) => {
      await rest(page, "[data-time='1.000']");
      assert.deepEqual(reached(await told(page)), reached(before));
      await page.click("#begin-lesson");
      await page.waitForSelector("#lesson[data-step='1']");
      await page.click("#lesson-next");
      await page.waitForSelector("#lesson[data-step='2']");
      fragment = await linkOf(page);
    },
    {},
    fragment,
  );
  await onLearned(
    (page) => page.waitForSelector("#lesson[data-step='2'][data-shown=question]").then(() => {}),
    CALM,
    fragment,
  );
});
