/**
 * The page of learned edges, in Chromium: it trains as the package does, plans by PRM-RL, drives in several ways,
 * compares them, and teaches.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Navigation, rolloutOptions, trainingOptions } from "planarium/full";
import { TrainingPool } from "../../www/prm-rl/pool.js";
import { encodeState } from "../../www/app/link.js";
import { stateRule } from "../../www/prm-rl/state.js";
import { FIRST, countsOf, poseAt } from "../../www/prm-rl/session.js";
import {
  download,
  dropFile,
  fill,
  linkOf,
  onPage,
  pickFile,
  pixelsOf,
  pressUntil,
  root,
  textMatches,
  useBrowser,
} from "./browser.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("./browser.mjs").Options} Options */
/** @typedef {import("planarium/full").NavigationDocument} NavigationDocument */

useBrowser();

const CALM = /** @type {Options} */ ({ reducedMotion: "reduce" });
/** What the page gives a planner, beside what is set. */
const ROADMAP = { samples: 400, k: 15 };
/** @type {import("planarium/full").PolicyDocument} */
const policy = JSON.parse(readFileSync(join(root, "www", "prm-rl", "policy.json"), "utf8"));
/** @type {import("planarium/full").PolicyDocument} */
const cargo = JSON.parse(readFileSync(join(root, "www", "prm-rl", "policy-cargo.json"), "utf8"));
const first = Navigation.generate(FIRST.kind, FIRST.options);
/** A training of a few seconds. */
const SHORT = { pairs: 3, tasks: 6, floors: 4, generations: 3, hidden: 4 };

/**
 * Waits until nothing moves, nothing is computed and all is drawn.
 * @param {Page} page
 * @param {string} [stage]  what the stage says then
 */
const rest = (page, stage = "") => page.waitForSelector(`body[data-state=ready][data-settled=true] #stage${stage}`);

/** What the stage says of itself. @param {Page} page @returns {Promise<Record<string, string>>} */
const told = (page) =>
  page
    .locator("#stage")
    .evaluate((element) => /** @type {Record<string, string>} */ ({ .../** @type {HTMLElement} */ (element).dataset }));

/**
 * The page, opened; with reduced motion it has planned and driven.
 * @param {(page: Page, url: string) => Promise<void>} act
 * @param {Options} [options]
 * @param {string} [fragment]
 */
const onLearned = (act, options = CALM, fragment = "") =>
  onPage(
    options,
    async (page, url) => {
      if (options.reducedMotion === "reduce") await rest(page);
      await act(page, url);
    },
    { path: `prm-rl.html${fragment}` },
  );

/** The page without a plan, which takes seconds. @param {(page: Page) => Promise<void>} act */
const onWaiting = async (act) => onLearned(act, CALM, `#${await encodeState({}, stateRule)}`);

/** What the package plans. @param {Navigation} task @param {object} [options] */
function planned(task, options) {
  const planner = task.planner(policy, { ...ROADMAP, ...options });
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

/** Trains as the page does. @param {Navigation} task @param {object} options @param {number} [generations] */
function trained(task, options, generations = Infinity) {
  const training = task.training(options);
  training.step(Math.min(generations * training.candidates, 1e9));
  return training;
}

/** Sets the options of a short training. @param {Page} page */
async function prepareTraining(page) {
  await page.click("#part-train");
  await rest(page, "[data-training=ready]");
  for (const [name, value] of Object.entries(SHORT)) {
    if (!(await page.isVisible(`#train-${name}`))) await page.locator("#train-settings summary").click();
    await fill(page, `#train-${name}`, String(value));
    await rest(page, "[data-training=ready]");
  }
}

test("several workers train the same policy as one, also if two of them are lost or join late", async () => {
  Object.defineProperty(globalThis, "navigator", { value: { hardwareConcurrency: 4 }, configurable: true });
  // Each worker has the module, and with it a training, of its own.
  const workers = await Promise.all(
    ["a", "b", "c"].map(async (name) => ({ ...(await import(`../../www/prm-rl/commands.js?${name}`)).commands })),
  );
  const remote = (/** @type {any} */ commands, fails = { command: "", after: 0 }) =>
    /** @type {any} */ (
      new Proxy(
        {},
        {
          get:
            (_, command) =>
            async (/** @type {any[]} */ ...args) => {
              if (command === fails.command && fails.after-- <= 0) throw new Error("lost");
              return commands[command](...args);
            },
        },
      )
    );
  const hired = [remote(workers[1], { command: "returnsOf", after: 3 }), remote(workers[2])];
  const page = remote(workers[0], { command: "advance", after: 2 });
  const pool = new TrainingPool(page, () => hired.shift() ?? assert.fail());
  const { candidates } = await pool.begin(first.toJSON(), SHORT, new AbortController().signal);
  assert.equal(candidates, 6);
  const fingerprints = /** @type {string[]} */ ([]);
  await pool.train(({ generation, fingerprint, history }) => {
    fingerprints.push(fingerprint);
    assert.equal(history.length, 3, "a row for each generation");
    return generation < SHORT.generations;
  });
  assert.equal(pool.workers.length, 1, "the lost ones have gone");
  assert.deepEqual(
    fingerprints,
    [1, 2, 3].map((generations) => trained(first, SHORT, generations).fingerprint),
  );
});

test("a robot is drawn where the trace has it, and between two time steps in between", () => {
  const drive = first.execute([...first.toJSON().queries[0].start.slice(0, 2), 3.9, 4], { policy });
  assert.deepEqual(poseAt(drive, 0, 0.2), [...drive.trace.slice(0, 3)]);
  assert.deepEqual(poseAt(drive, 1e9, 0.2), [...drive.trace.slice(-3)]);
  assert.ok(Math.abs(poseAt(drive, 0.3, 0.2)[0] - (drive.trace[3] + drive.trace[6]) / 2) < 1e-12);
});

test("at first the page plans by PRM-RL, drives and plays; with reduced motion all of it is shown", async () => {
  await onLearned(async (page) => {
    await page.waitForSelector("#course-play[data-playing=true]");
    await page.waitForFunction(() => Number(document.getElementById("stage")?.dataset.time) > 0.5);
  }, {});
  await onLearned(async (page) => {
    const { status, way, edges, fingerprint, reached, drives } = await told(page);
    const result = planned(first);
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
      rollouts.map(({ of, forward, backward }) => `rollouts: ${forward} of ${of} there, ${backward} of ${of} back`),
    );
    assert.doesNotMatch(await page.innerText("main"), /proven (?!free)/, "nothing learned is called proven");
    for (const colour of ["unproven", "goal", "newest", "robot"])
      assert.ok((await pixelsOf(page, "floor", "top", colour)) > 50, colour);
    assert.ok((await pixelsOf(page, "floor", "roadmap", "growth")) > 100);
  });
});

test("an edge of the path shows its rollouts, from the list and under the pointer", () =>
  onLearned(async (page) => {
    assert.equal(await pixelsOf(page, "floor", "top", "ink"), 0);
    await page.focus("#edge-3");
    await rest(page, "[data-edge='2']");
    assert.ok((await pixelsOf(page, "floor", "top", "ink")) > 20);
    await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
    await rest(page, "[data-edge='']");
    const [from, to] = planned(first).path.slice(8, 10);
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
  }));

test("start and goal are moved by keys, sliders and dragging; in collision that is said, and then planned anew", () =>
  onLearned(async (page) => {
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
    assert.equal(fingerprint, planned(task).fingerprint);
    const box = (await page.locator("#floor canvas[data-layer=top]").boundingBox()) ?? assert.fail();
    const scale = Math.min((box.width - 28) / 20, (box.height - 28) / 15);
    const place = (/** @type {number} */ px, /** @type {number} */ py) =>
      /** @type {const} */ ([box.x + box.width / 2 + scale * (px - 10), box.y + box.height / 2 - scale * (py - 7.5)]);
    await page.mouse.move(...place(gx, gy));
    await page.mouse.down();
    await page.mouse.move(...place(gx - 1, gy), { steps: 3 });
    await page.mouse.up();
    await rest(page, "[data-status=none]");
    const [dragged] = (await told(page)).goal.split(",").map(Number);
    assert.ok(Math.abs(dragged - (gx - 1)) < 0.1, `${dragged}`);
  }));

test("each way drives as the package does: the policy alone gets stuck, straight edges collide", () =>
  onLearned(async (page) => {
    const [{ start, goal }] = first.toJSON().queries;
    const straight = first.straightPlanner(ROADMAP);
    straight.step(1e9);
    for (const [way, path] of /** @type {[string, number[][]][]} */ ([
      ["policy", [start.slice(0, 2), [...goal]]],
      ["straight", straight.result().path],
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
  }));

test("the drives are played and shown at any time; options of the roadmap equal the package's, and are refused beside their field", () =>
  onLearned(async (page) => {
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
    const loose = planned(first, { leastShare: 0.6 });
    await rest(page, `[data-fingerprint="${loose.fingerprint}"]`);
    await fill(page, "#plan-least_share", "2");
    await page.waitForSelector("#plan-least_share-reason:not([hidden])");
    await fill(page, "#kind", "furnished");
    await rest(page, "[data-status=none]");
    assert.match(await page.innerText(".where-now"), /furnished/i);
  }));

test("a training ends with the policy of the package, is saved, opened, used and linked", async () => {
  let fragment = "";
  const wanted = trained(first, SHORT);
  await onWaiting(async (page) => {
    await prepareTraining(page);
    for (const { name } of trainingOptions()) assert.equal(await page.locator(`#train-${name}`).count(), 1, name);
    await page.click("#train");
    await rest(page, "[data-training=over]");
    assert.equal((await told(page)).trained, wanted.fingerprint);
    assert.ok((await pixelsOf(page, "demonstrations", "top", "goal")) > 50);
    assert.equal(await page.innerText("#fact-mean"), wanted.historySince(2)[0].toFixed(3).replace("-", "\u2212"));
    await page.waitForSelector("#charts .returns .line");
    await page.click("#use-trained");
    await rest(page, "[data-policy=trained]");
    const { name, text } = await download(page, "#save-policy");
    assert.deepEqual(JSON.parse(text), wanted.policy());
    fragment = await linkOf(page);
    await page.click("#ship");
    await rest(page, "[data-policy=shipped]");
    await pickFile(page, name, text);
    await rest(page, "[data-policy=file]");
    assert.equal(await page.innerText("#policy-name"), wanted.policy().name);
  });
  await onLearned(
    async (page) => {
      await rest(page, "[data-training=over]");
      const { trained: again, policy: origin } = await told(page);
      assert.deepEqual([again, origin], [wanted.fingerprint, "trained"]);
    },
    CALM,
    fragment,
  );
});

test("a training is paused and goes on; its drives are chosen, and their rays drawn; at first nothing is called invalid", () =>
  onWaiting(async (page) => {
    const said = await page.locator("#story").evaluateHandle((element) => {
      /** @type {string[]} */
      const all = [];
      new MutationObserver(() => all.push(element.textContent ?? "")).observe(element, {
        childList: true,
        characterData: true,
        subtree: true,
      });
      return all;
    });
    await page.click("#part-train");
    await rest(page, "[data-training=ready]");
    await page.waitForFunction((all) => all.at(-1)?.endsWith("Press Train."), said);
    assert.deepEqual(
      (await said.jsonValue()).filter((text) => text.includes("not valid")),
      [],
    );
    await prepareTraining(page);
    await fill(page, "#train-generations", "100000");
    await rest(page, "[data-training=ready]");
    await page.click("#train");
    await page.waitForFunction(() => Number(document.getElementById("stage")?.dataset.generation) >= 2);
    await page.click("#train");
    await rest(page, "[data-training=ready]");
    const { generation, trained: fingerprint } = await told(page);
    assert.equal(fingerprint, trained(first, { ...SHORT, generations: 100_000 }, Number(generation)).fingerprint);
    const rays = await pixelsOf(page, "demonstrations", "top", "newest");
    assert.ok(rays > 20);
    await page.locator("#demonstrations canvas[data-layer=top]").click();
    await rest(page);
    assert.notEqual(await pixelsOf(page, "demonstrations", "top", "newest"), rays);
  }));

test("the comparison ends with the numbers of the package, drawn and saved", () =>
  onWaiting(async (page) => {
    const options = { queries: 2, trials: 2, samples: 300, k: 12 };
    await page.click("#part-compare");
    await page.locator("#compare-settings summary").click();
    for (const [name, value] of Object.entries(options)) await fill(page, `#compare-${name}`, String(value));
    await page.click("#compare");
    await rest(page, "[data-compared=over][data-executions='24']");
    const comparison = first.comparison(policy, options);
    comparison.step(1e9);
    for (const { method, reached } of comparison.summary()) {
      const row = page.locator(`#compared tr[data-way=${method}]`);
      assert.equal(await row.getAttribute("data-reached"), String(Math.round(reached.n * (reached.share ?? 0))));
      assert.equal(await row.locator("svg circle").count(), 1);
    }
    await page.click("#export-fold > summary");
    const rows = (await download(page, "#export-comparison")).text.trim().split("\r\n");
    assert.equal(rows.length, 25);
    assert.match(rows[24], /^2,prm-rl,/);
    assert.deepEqual(
      JSON.parse((await download(page, "#export-summary")).text).summary,
      JSON.parse(JSON.stringify(comparison.summary())),
    );
    await fill(page, "#compare-least_distance", "900");
    await page.click("#compare");
    await page.waitForSelector("#compare-least_distance-reason:not([hidden])");
  }));

test("the lesson asks five questions, and answers with what was driven", () =>
  onLearned(async (page) => {
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
  }));

test("a link shows the same plan, drives and time, and the step of a lesson", async () => {
  const reached = (/** @type {Record<string, string>} */ data) =>
    ["fingerprint", "reached", "drives", "time", "way", "start", "goal"].map((name) => data[name]);
  let fragment = "";
  /** @type {Record<string, string>} */
  let before = {};
  await onLearned(async (page) => {
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
  });
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

test("a floor from a file is opened and exported; what is wrong is refused by code and pointer, and nothing changes", () =>
  onWaiting(async (page) => {
    const document = Navigation.generate("rooms", { columns: 2, rows: 1, seed: 3 }).toJSON();
    await dropFile(page, "own.json", JSON.stringify({ ...document, title: "My office" }));
    await rest(page, "[data-status=none]");
    assert.match(await page.innerText(".where-now"), /^My office/);
    await page.click("#export-fold > summary");
    const { world } = /** @type {NavigationDocument} */ (JSON.parse((await download(page, "#export-task")).text));
    assert.deepEqual(world, JSON.parse(JSON.stringify(document.world)));
    for (const [content, code, pointer] of /** @type {[object, string, string][]} */ ([
      [{ ...document, robot: { ...document.robot, speed: [1, 0] } }, "out-of-range", "/robot/speed"],
      [{ ...policy, weights: policy.weights.slice(1) }, "wrong-dimension", "/weights"],
      [{ ...policy, sensor: { ...policy.sensor, rays: 8 } }, "", ""],
    ])) {
      await pickFile(page, "bad.json", JSON.stringify(content));
      await page.waitForSelector("#notice:not([hidden])");
      if (code) {
        assert.equal(await page.getAttribute("#notice", "data-code"), code);
        assert.match(await page.innerText("#notice"), new RegExp(pointer));
      }
      assert.match(await page.innerText(".where-now"), /^My office/);
      assert.equal((await told(page)).policy, "shipped");
    }
    await pickFile(page, "own.json", JSON.stringify(document));
    await page.waitForSelector("#notice", { state: "hidden" });
    await textMatches(page, "#story", /^PRM-RL plans long routes.*Drag the ring.*press Plan/);
  }));

test("a carrier of cargo has a policy of its own; its load is drawn, its swing shown, and it is trained", () =>
  onWaiting(async (page) => {
    const counts = (/** @type {string} */ way) => page.locator(`#driven tr[data-way=${way}] td`).allInnerTexts();
    const columns = (await counts("prm-rl")).length;
    await page.selectOption("#robot", "cargo");
    await rest(page, "[data-status=none][data-policy=shipped]");
    await textMatches(page, "#policy-about", /for 20 rays/);
    await page.click("#drive");
    await rest(page, "[data-drives='20']");
    const yard = Navigation.generate(FIRST.kind, { ...FIRST.options, shape: "cargo" });
    const planner = yard.planner(cargo, ROADMAP);
    planner.step(1e9);
    const { fingerprint, path } = planner.result();
    assert.equal((await told(page)).fingerprint, fingerprint);
    const drives = Array.from({ length: 20 }, (_, trial) => yard.execute(path.flat(), { trial, policy: cargo }));
    const { reached, collision, swing, timeout } = countsOf(drives);
    assert.deepEqual((await counts("prm-rl")).slice(2, 6), [
      `${reached} of 20`,
      String(collision),
      String(swing),
      String(timeout),
    ]);
    assert.ok(await page.isVisible("#swing-chart svg"));
    const most = Math.max(
      ...Array.from({ length: drives[0].swing.length / 2 }, (_, i) =>
        Math.hypot(...drives[0].swing.slice(2 * i, 2 * i + 2)),
      ),
    );
    assert.match(
      (await page.getAttribute("#swing-chart svg", "aria-label")) ?? "",
      new RegExp(`at most ${most.toFixed(2)} m; the limit is 0\\.30 m`),
    );
    assert.ok((await pixelsOf(page, "floor", "top", "unproven")) > 30, "load, ring and the way of the load");
    await prepareTraining(page);
    await page.click("#train");
    await rest(page, "[data-training=over]");
    assert.equal((await told(page)).trained, trained(yard, SHORT).fingerprint);
    await page.click("#use-trained");
    await page.click("#part-plan");
    await rest(page, "[data-policy=trained]");
    // A policy of another robot is put away.
    await page.selectOption("#robot", "disc");
    await rest(page, "[data-policy=shipped]");
    assert.equal((await counts("prm-rl")).length, columns);
    assert.equal(await page.isVisible("#swing-chart svg"), false);
  }));
