/** A race: planners side by side, given the same work; the table and the curves say what the package says. */
import { withOptions } from "../../www/domain/option-names.js";
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { PHONE, atRest, chooseScene, finish, frames, growthHash, onPage, onPausedPage, pixelsOf, root, seek, setParameter, start, stop, unfold } from "./browser.mjs";
import { assertFaultless, assertTargets } from "./looks.mjs";
import { LocalRun, ended } from "./runs.mjs";
import { PAST } from "../../www/planner/run-log/run-log.js";
import { compete } from "../../www/planner/worker/compete.js";
import { thinned } from "../../www/planner/run-log/curve.js";
import { ticks } from "../../www/widgets/chart.js";
import { nameAll } from "../../www/planner/race/names.js";
import { leaders, letters } from "../../www/planner/race/standings.js";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("../../www/domain/types.js").Plan} Plan */

before(start);
after(stop);

const text = (/** @type {string} */ id) => readFileSync(join(root, "www", "scenes", `${id}.json`), "utf8");

/** What the package says of a plan by itself: its rows of history, its result. @param {string} id @param {Plan} plan */
async function alone(id, { algorithm, settings }) {
  const { Scenario } = await import("planarium");
  const planner = withOptions({ ...settings, algorithm }, (options) => Scenario.parse(text(id)).planner(options));
  planner.record();
  while (planner.step(1000) === "running");
  const data = planner.historySince(0);
  const width = planner.historyWidth;
  const rows = [[0, 0, 0, 0, 0, 0, 0, Infinity], ...Array.from({ length: data.length / width }, (_, i) => [...data.slice(i * width, (i + 1) * width)])];
  return { rows, planner, fingerprint: planner.fingerprint() };
}

/** Adds rivals. @param {Page} page @param {string[]} algorithms */
async function race(page, ...algorithms) {
  if (!(await page.locator("#rival").isVisible())) await page.locator("#race-fold > summary").click();
  for (const algorithm of algorithms) {
    await page.selectOption("#rival", algorithm);
    await page.click("#add-rival");
  }
  await atRest(page);
}

/** The table: a row of texts for each planner. @param {Page} page */
async function table(page) {
  return page.locator("#standings tbody tr").evaluateAll((rows) => rows.map((row) => ({
    fingerprint: /** @type {HTMLElement} */ (row).dataset.fingerprint,
    name: row.children[0].textContent ?? "",
    counts: [...row.children].slice(1, 6).map(({ textContent }) => Number(textContent?.replaceAll(",", ""))),
    found: row.children[6].textContent ?? "", cost: row.children[7].textContent ?? "",
  })));
}

const time = (/** @type {Page} */ page) => page.locator("#time").inputValue().then(Number);

/** Opens a rival's settings and gives one. @param {Page} page @param {string} rival @param {string} name @param {string} value */
async function give(page, rival, name, value) {
  const field = page.locator(`#rival-${rival}-${name}`);
  for (let i = 0; i < 2 && !(await field.isVisible()); i++) await page.locator(`fieldset.rival:has(#rival-${rival}-planner) details:not([open]) > summary:visible`).last().click();
  if ((await field.evaluate(({ tagName }) => tagName)) === "SELECT") await field.selectOption(value);
  else await field.fill(value);
  await field.blur();
  await atRest(page);
}

const A = { algorithm: "prm", settings: { samples: 260, k: 9, seed: 0 } };
const settings = { seed: 0 };

describe("fairness", () => {
  test("at rest each has what belongs to the time that is shown, to the iteration; its next iteration would be too much", async () => {
    const plans = [A, { algorithm: "rrt", settings }, { algorithm: "rrt-connect", settings }, { algorithm: "prm-star", settings: { samples: 260, seed: 0 } }];
    const runs = await Promise.all(plans.map((plan) => alone("stones", plan)));
    await onPausedPage(async (page) => {
      await race(page, "rrt", "rrt-connect", "prm-star");
      assert.equal(await time(page), 0);
      for (const { counts } of await table(page)) assert.deepEqual(counts.slice(3), [0, 0]);
      for (const wanted of [100, 189, 190, 1234, 3475, 6693, 6694, 700, 12_345]) {
        await seek(page, wanted);
        assert.equal(await time(page), wanted);
        (await table(page)).forEach(({ counts: [vertices, edges, motions, evaluations, iterations], name }, i) => {
          const { rows } = runs[i];
          assert.ok(evaluations <= wanted, name);
          assert.ok(iterations === rows.length - 1 || rows[iterations + 1][PAST.evaluations] > wanted, `${name} at ${wanted} has made only ${iterations}`);
          const row = rows[iterations];
          assert.deepEqual([vertices, edges, motions, evaluations], [PAST.vertices, PAST.edges, PAST.motions, PAST.evaluations].map((column) => row[column]), `${name} at ${wanted}`);
        });
      }
    });
  });

  test("whoever is behind goes next: a frame that is too short leaves all nearly level, however many frames it takes", async () => {
    const { Scenario } = await import("planarium");
    const scenario = Scenario.parse(text("rings"));
    const runs = [["prm", { samples: 900 }], ["rrt", { goal_bias: 0 }], ["rrt-connect", {}], ["prm-star", { samples: 300, edge_check: "sampled" }]]
      .map(([algorithm, given]) => new LocalRun(scenario, String(algorithm), { .../** @type {object} */ (given), seed: 3 }));
    let frames = 0;
    while (!compete(runs.map(({ stepper }) => stepper), PAST.evaluations, Infinity, performance.now() + 0.5)) {
      frames++;
      for (const run of runs) run.fetch();
      const going = runs.filter(({ ended }) => !ended).map((run) => run.clock(PAST.evaluations));
      const dearest = Math.max(0, ...runs.map(({ history: { data, width, count } }) => Math.max(...Array.from({ length: count - 1 }, (_, i) => data[(i + 1) * width + PAST.evaluations] - data[i * width + PAST.evaluations]))));
      assert.ok(Math.max(...going) - Math.min(...going) <= 1000 + 64 * dearest, `${going}`);
      assert.ok(frames < 100_000);
    }
    assert.ok(frames > 3, `${frames} frames`);
    assert.ok(runs.every(({ stepper }) => stepper.ended));
  });

  test("a world where no clearance is ever evaluated holds nobody up, and the page says what that means", async () => {
    await onPausedPage(async (page) => {
      await page.setInputFiles("#file", { name: "empty.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify({
        format: "planarium-scenario-1", name: "empty", world: { obstacles: [] }, robot: { type: "arm", base: [0, 0], links: [1, 0.8] },
        queries: [{ name: "across", start: [0.6, 0.2], goal: [-0.6, -0.2] }],
      })) });
      await page.waitForSelector("body[data-scene=file]");
      await race(page, "rrt");
      await page.click("#step-1");
      await atRest(page);
      const [a, b] = await table(page);
      assert.deepEqual([a.counts[3], b.counts[3]], [0, 0]);
      assert.ok(a.fingerprint && b.fingerprint && a.counts[4] > 0 && b.counts[4] > 0);
      assert.match(await page.innerText("#story"), /nothing to avoid/);
      await page.click("#back");
      await atRest(page);
      assert.deepEqual((await table(page)).map(({ counts }) => counts[4]), [0, 0]);
    });
  });

});

describe("one transport", () => {
  test("steps, back, the slider and the field count clearance evaluations and say so; going back shows what was there", async () => {
    await onPausedPage(async (page) => {
      await race(page, "rrt-connect", "rrt");
      assert.deepEqual(await page.locator(".steps button").allInnerTexts(), ["10", "100", "1,000"]);
      for (const [id, name] of [["step-1", "Step 10 clearance evaluations"], ["step-100", "Step 1,000 clearance evaluations"], ["back", "Back 10 clearance evaluations"]]) {
        assert.equal(await page.locator(`#${id}`).getAttribute("aria-label"), name);
      }
      assert.match(await page.locator("#timeline").getAttribute("aria-label") ?? "", /clearance evaluations/);
      assert.match(await page.locator("#speed").getAttribute("aria-valuetext") ?? "", /clearance evaluations a second/);
      assert.equal(await page.getByRole("spinbutton", { name: /^Clearance evaluations/ }).getAttribute("id"), "time");
      await page.click("#step-100");
      await atRest(page);
      assert.equal(await time(page), 1000);
      assert.match(await page.innerText("#time-head"), /^of 1,000 evaluations$/);
      const then = [await table(page), ...await Promise.all(["lane-A", "lane-B", "lane-C"].map((pane) => growthHash(page, pane)))];
      assert.equal(new Set(then.slice(1)).size, 3, "each sheet shows its own planner");
      await page.click("#step-1");
      await atRest(page);
      assert.equal(await time(page), 1010);
      await page.click("#back");
      await atRest(page);
      assert.deepEqual([await table(page), ...await Promise.all(["lane-A", "lane-B", "lane-C"].map((pane) => growthHash(page, pane)))], then);
      await finish(page);
      await page.locator("#timeline").fill("1000");
      await atRest(page);
      const again = (await table(page)).map(({ counts }) => counts);
      assert.deepEqual(again, /** @type {{ counts: number[] }[]} */ (then[0]).map(({ counts }) => counts));
      assert.deepEqual(await Promise.all(["lane-A", "lane-B", "lane-C"].map((pane) => growthHash(page, pane))), then.slice(1));
      await page.click("#reset");
      await atRest(page);
      assert.deepEqual((await table(page)).map(({ counts }) => counts[4]), [0, 0, 0]);
    });
  });

  test("play grows all of them, pause stops all of them", async () => {
    await onPausedPage(async (page) => {
      await race(page, "rrt-connect", "prm");
      // Slow enough that none ends meanwhile.
      await page.locator("#speed").fill("25");
      await page.click("#play");
      await page.waitForFunction(() => Number(/** @type {HTMLInputElement} */ (document.getElementById("time")).value) > 100);
      await page.click("#play");
      await atRest(page);
      const at = await time(page);
      const rows = await table(page);
      assert.ok(rows.every(({ counts }) => counts[4] > 0));
      assert.equal(await page.getAttribute("#play", "data-playing"), "false");
      await frames(page);
      assert.equal(await time(page), at);
      assert.deepEqual(await table(page), rows);
    });
  });

  test("run to the end: each is bit for bit the run that its planner makes alone, with two, three and four", async () => {
    const plans = [A, { algorithm: "rrt-connect", settings }, { algorithm: "rrt", settings }, { algorithm: "visibility-prm", settings }];
    const runs = await Promise.all(plans.map((plan) => alone("stones", plan)));
    await onPausedPage(async (page) => {
      for (let count = 2; count <= 4; count++) {
        await race(page, plans[count - 1].algorithm);
        assert.equal(await page.locator("#stage figure").count(), count);
        await finish(page);
        const rows = await table(page);
        assert.deepEqual(rows.map(({ fingerprint }) => fingerprint), runs.slice(0, count).map(({ fingerprint }) => fingerprint));
        rows.forEach(({ counts, found, cost }, i) => {
          const { rows: history, planner } = runs[i];
          const last = history[history.length - 1];
          assert.deepEqual(counts, [...[PAST.vertices, PAST.edges, PAST.motions, PAST.evaluations].map((column) => last[column]), history.length - 1]);
          const first = history.find((row) => row[PAST.cost] < Infinity);
          assert.equal(found.split(",").slice(0, 2).join("").match(/^\d+/)?.[0] ?? found, first ? String(first[PAST.evaluations]) : "no path");
          if (first) assert.equal(cost.split(" (")[0], `${planner.result().length.toFixed(2)} rad`);
        });
      }
      assert.equal(await page.locator("#add-rival").isDisabled(), true, "four race at most");
    });
  });

  test("once all have ended the robots follow their paths in step", async () => {
    await onPausedPage(async (page) => {
      await race(page, "rrt-connect");
      await finish(page);
      for (const lane of ["lane-A", "lane-B"]) assert.ok(await pixelsOf(page, lane, "top", "path") > 150, lane);
      assert.equal(await page.locator("#along-row").isVisible(), true);
    });
  });
});

describe("rivals", () => {
  test("a rival of the same planner is a copy until it is told otherwise; captions say what differs", async () => {
    const run = await alone("stones", { algorithm: "prm", settings: { samples: 260, k: 4, seed: 0 } });
    await onPausedPage(async (page) => {
      await race(page, "prm");
      await finish(page);
      const [a, b] = await table(page);
      assert.equal(a.fingerprint, b.fingerprint);
      assert.deepEqual([a.name, b.name], ["A PRM", "B PRM"]);
      assert.match(a.found, / \(tied for first\)$/);
      assert.match(await page.innerText("#story"), /^A and B tied: both found a path after [\d,]+ clearance evaluations, of length \d+\.\d\d rad\.$/);
      await give(page, "B", "k", "4");
      await finish(page);
      const rows = await table(page);
      assert.deepEqual(rows.map(({ name }) => name), ["A PRM, k 9", "B PRM, k 4"]);
      assert.equal(rows[1].fingerprint, run.fingerprint);
      assert.deepEqual(await page.locator("#stage figcaption span").allInnerTexts(), ["A PRM, k 9", "B PRM, k 4"]);
      await give(page, "B", "shortcut", "30");
      await finish(page);
      assert.equal((await table(page))[1].name, "B PRM, k 4, shortcut 30");
    });
  });

  test("its seed is that of A until it is given one", async () => {
    await onPausedPage(async (page) => {
      await race(page, "rrt-connect");
      await setParameter(page, "seed", "5");
      await finish(page);
      const plan = { algorithm: "rrt-connect", settings: { seed: 5 } };
      assert.equal((await table(page))[1].fingerprint, (await alone("stones", plan)).fingerprint);
      await give(page, "B", "seed", "6");
      await finish(page);
      const [, b] = await table(page);
      assert.equal(b.fingerprint, (await alone("stones", { ...plan, settings: { seed: 6 } })).fingerprint);
      assert.equal(b.name, "B RRT-Connect, seed 6");
    });
  });

  test("all parameters of all planners can be reached; one that is refused says why and is not planned with", async () => {
    const { planners } = await import("planarium");
    await onPausedPage(async (page) => {
      await race(page, "rrt");
      const isArms = (/** @type {{ robots: string[] }} */ { robots }) => robots.includes("arm");
      for (const { id, parameters } of planners().filter(isArms)) {
        await page.selectOption("#rival-B-planner", id);
        for (const { name } of parameters.filter(isArms)) assert.equal(await page.locator(`#rival-B-${name}`).count(), 1, `${id}: ${name}`);
      }
      await page.selectOption("#rival-B-planner", "prm");
      await finish(page);
      const before = await table(page);
      await give(page, "B", "k", "0");
      assert.match(await page.innerText("#rival-B-k-reason"), /below/);
      await setParameter(page, "k", "5");
      await atRest(page);
      assert.deepEqual(await table(page), before);
      await give(page, "B", "k", "7");
      assert.deepEqual((await table(page)).map(({ name }) => name), ["A PRM, k 5", "B PRM, k 7"]);
    });
  });

  test("a plan that the core refuses names its planner and its field", async () => {
    await onPausedPage(async (page) => {
      await chooseScene(page, "rings");
      await race(page, "rrt-connect", "rrt");
      await give(page, "C", "metric", "naive");
      await page.waitForSelector("#notice:not([hidden])");
      assert.match(await page.innerText("#notice"), /^C, RRT, cannot be planned\. .*naive.*\. Change its settings or remove C to start the race\./);
      assert.deepEqual((await table(page)).map(({ found }) => found), ["not started", "not started", "not started"]);
      assert.equal(await page.locator("#notice").getAttribute("data-pointer"), "/metric");
      assert.match(await page.innerText("#rival-C-metric-reason"), /naive/);
      assert.equal(await page.locator("#rival-B-metric-reason").isHidden(), true);
      await give(page, "C", "metric", "euclidean");
      assert.equal(await page.locator("#notice").isHidden(), true);
      await finish(page);
      assert.ok((await table(page)).every(({ fingerprint }) => fingerprint));
    });
  });

  test("they stay when the scene changes, go one by one, and the last one leaves a single run behind", async () => {
    await onPausedPage(async (page) => {
      await race(page, "rrt", "rrt-connect");
      await chooseScene(page, "rings");
      assert.deepEqual((await table(page)).map(({ name }) => name), ["A PRM", "B RRT", "C RRT-Connect"]);
      assert.equal(await page.locator("#stage figure.workspace").count(), 3);
      assert.equal(await page.locator("input[name=lens]").first().isVisible(), false, "a disc has one picture");
      await page.getByRole("button", { name: "Remove B" }).click();
      await atRest(page);
      assert.deepEqual((await table(page)).map(({ name }) => name), ["A PRM", "B RRT-Connect"]);
      assert.equal(await page.evaluate(() => document.activeElement?.id), "add-rival");
      await page.keyboard.press("Shift+Tab");
      await page.keyboard.press("Shift+Tab");
      await page.keyboard.press("Shift+Tab");
      assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("aria-label")), "Remove B");
      await page.keyboard.press("Enter");
      await atRest(page);
      assert.equal(await page.locator("#standings table").count(), 0);
      assert.equal(await page.locator("#counters").isVisible(), true);
      assert.equal(await page.locator("#stage figure").count(), 1);
      assert.deepEqual(await page.locator(".steps button").allInnerTexts(), ["1", "10", "100"]);
      const { fingerprint } = await finish(page);
      assert.equal(fingerprint, (await alone("rings", { algorithm: "prm", settings: { samples: 900, k: 9, seed: 14 } })).fingerprint);
    });
  });

  test("only planners that serve the robot are offered; a rival that does not serve the next scene is removed, and the race goes on", async () => {
    const { planners } = await import("planarium");
    const idsFor = (/** @type {string} */ robot) => planners().flatMap(({ id, robots }) => (robots.some((one) => one === robot) ? [id] : []));
    await onPausedPage(async (page) => {
      const offered = (/** @type {string} */ id) => page.locator(`#${id} option`).evaluateAll((options) => options.map((option) => /** @type {HTMLOptionElement} */ (option).value));
      await race(page, "rrt");
      assert.deepEqual(await offered("rival"), idsFor("arm"));
      await chooseScene(page, "blossom");
      assert.deepEqual([await offered("rival"), await offered("rival-B-planner")], [idsFor("car"), idsFor("car")]);
      await page.selectOption("#rival-B-planner", "rrt-control");
      await race(page, "sst", "rrt");
      await chooseScene(page, "rings");
      assert.equal(await page.innerText("#notice strong"), "Kinodynamic RRT needs a car, so rival B was removed. SST needs a car, so rival C was removed.");
      assert.deepEqual((await table(page)).map(({ name, found }) => [name, found]), [["A PRM", "sampling"], ["B RRT", "growing"]]);
      assert.deepEqual([await offered("rival"), await offered("rival-B-planner")], [idsFor("disc"), idsFor("disc")]);
      await page.click("#play");
      await page.waitForFunction(() => Number(/** @type {HTMLInputElement} */ (document.getElementById("time")).value) > 0);
      await finish(page);
      assert.ok((await table(page)).every(({ fingerprint }) => fingerprint));
    });
  });

  test("a rival has the presets of its planner; by hand it is the reader's own again", async () => {
    const { planners } = await import("planarium");
    const preset = planners().find(({ id }) => id === "prm")?.presets[0];
    assert.ok(preset);
    await onPausedPage(async (page) => {
      await race(page, "prm");
      await page.locator("fieldset.rival details > summary").first().click();
      assert.equal(await page.inputValue("#rival-B-preset"), "own");
      await page.selectOption("#rival-B-preset", preset.id);
      await atRest(page);
      for (const [name, value] of Object.entries(preset.settings)) assert.equal(await page.inputValue(`#rival-B-${name}`), String(value), name);
      await finish(page);
      assert.equal((await table(page))[1].fingerprint, (await alone("stones", { algorithm: "prm", settings: { seed: 0, ...preset.settings } })).fingerprint);
      await give(page, "B", "k", "6");
      assert.equal(await page.inputValue("#rival-B-preset"), "own");
      await page.selectOption("#rival-B-planner", "rrt-connect");
      assert.equal(await page.locator("#rival-B-preset").isVisible(), false);
    });
  });

  test("one switch for all sheets: workspace or configuration space", async () => {
    await onPausedPage(async (page) => {
      await race(page, "rrt");
      assert.equal(await page.locator("#stage figure.cspace").count(), 2);
      await page.getByLabel("Workspace", { exact: true }).check();
      assert.equal(await page.locator("#stage figure.workspace").count(), 2);
      await finish(page);
      for (const lane of ["lane-A", "lane-B"]) assert.ok(await pixelsOf(page, lane, "vertices", "growth") + await pixelsOf(page, lane, "edges", "start") > 0, lane);
      assert.match(await page.locator("#lane-B canvas[role=img]").getAttribute("aria-label") ?? "", /^Workspace of B RRT.*solved/);
    });
  });
});

describe("winners, in words", () => {
  test("the first and the shortest are named in the table, above the stage and to those who listen", async () => {
    await onPausedPage(async (page) => {
      await race(page, "rrt-connect");
      await seek(page, 190);
      assert.deepEqual((await table(page)).map(({ found }) => found), ["sampling", "190 (first)"]);
      await page.waitForFunction(() => document.getElementById("announcer")?.textContent === "B found a path.");
      await finish(page);
      const [a, b] = await table(page);
      assert.equal(a.cost, "8.93 rad (shortest)");
      assert.equal(b.cost, "9.19 rad");
      assert.equal(await page.innerText("#story"), "B found a path first, after 190 clearance evaluations; A has the shortest, 8.93 rad.");
      await page.waitForFunction(() => document.getElementById("announcer")?.textContent?.endsWith("A has the shortest, 8.93 rad."));
      assert.match(await page.innerText("#standings"), /Standings at equal cost \(one seed\): over many seeds the winner may differ\./);
    });
  });

  test("lengths in different metrics are not compared; a tie is one; a path alone is not the shortest", () => {
    assert.deepEqual([[0], [0, 2], [0, 1, 2]].map(letters), ["A", "A and C", "A, B and C"]);
    const one = { isOver: true, found: 10, cost: 5, metric: "sum" };
    assert.deepEqual(leaders([one, { ...one, cost: 4, metric: "euclidean" }]), { first: [0, 1], shortest: [], isOver: true, isAlike: false });
    assert.deepEqual(leaders([one, { ...one, found: 9, cost: 6 }, { ...one, isOver: false, found: null, cost: Infinity }]), { first: [1], shortest: [0], isOver: false, isAlike: true });
    assert.deepEqual(leaders([one, { ...one, found: null, cost: Infinity }]).shortest, []);
    assert.deepEqual(nameAll([A, { algorithm: "rrt", settings: { seed: 2 } }], (id) => id), ["A prm, seed 0", "B rrt, seed 2"]);
  });
});

/** A dot of a chart in its own units, read off its axes. @param {Page} page @param {string} chart @param {string} label */
async function dot(page, chart, label) {
  return page.locator(`svg.${chart}`).evaluate((picture, name) => {
    /** @param {string} axis @param {string} place @param {number} at */
    const value = (axis, place, at) => {
      const marks = [...picture.querySelectorAll(`text[data-${axis}]`)].map((mark) => [Number(mark.getAttribute(place)), Number(mark.getAttribute(`data-${axis}`))]);
      const [[p, a], [q, b]] = [marks[0], marks[marks.length - 1]];
      return { value: a + ((at - p) / (q - p)) * (b - a), pixel: Math.abs((b - a) / (q - p)) };
    };
    const circle = /** @type {SVGCircleElement} */ (picture.querySelector(`.future circle[data-label="${name}"]`));
    const cursor = /** @type {SVGLineElement} */ (picture.querySelector(".cursor"));
    return {
      x: value("across", "x", circle.cx.baseVal.value), y: value("up", "y", circle.cy.baseVal.value + 4),
      cursor: value("across", "x", cursor.x1.baseVal.value),
    };
  }, label);
}

describe("curves", () => {
  test("the path's curve begins where the path was found, at its length; the cursor is at the time that is shown", async () => {
    const plans = [{ algorithm: "prm", settings: { ...A.settings, shortcut: 60 } }, { algorithm: "rrt-connect", settings: { seed: 0, shortcut: 60 } }];
    const runs = await Promise.all(plans.map((plan) => alone("stones", plan)));
    await onPausedPage(async (page) => {
      await page.locator("#more > summary").click();
      await setParameter(page, "shortcut", "60");
      await race(page, "rrt-connect");
      assert.equal(await page.locator("#curves-fold").evaluate((fold) => /** @type {HTMLDetailsElement} */ (fold).open), true);
      await finish(page);
      await seek(page, 2000);
      await page.waitForFunction(() => document.querySelectorAll("svg.cost .future circle").length === 2);
      for (const [i, label] of ["A", "B"].entries()) {
        const first = /** @type {number[]} */ (runs[i].rows.find((row) => row[PAST.cost] < Infinity));
        const { x, y, cursor } = await dot(page, "cost", label);
        assert.ok(Math.abs(x.value - first[PAST.evaluations]) <= x.pixel, `${label} at ${x.value}, not ${first[PAST.evaluations]}`);
        assert.ok(Math.abs(y.value - first[PAST.cost]) <= y.pixel, `${label} is ${y.value} long, not ${first[PAST.cost]}`);
        assert.ok(Math.abs(cursor.value - 2000) <= cursor.pixel, `cursor at ${cursor.value}`);
      }
      const dashes = await page.locator("svg.cost .future path").evaluateAll((paths) => paths.map((path) => getComputedStyle(path).strokeDasharray));
      assert.equal(new Set(dashes).size, 2, "lines differ by more than colour");
      assert.deepEqual(await page.locator("svg.cost .end").allTextContents().then((labels) => labels.toSorted()), ["A", "B"]);
      const label = await page.locator("svg.vertices").getAttribute("aria-label") ?? "";
      assert.match(label, /^Vertices against clearance evaluations.*A PRM.*262.*B RRT-Connect/);
      await page.getByText("As a table").click();
      await page.waitForSelector("#curves tbody tr");
      const rows = await page.locator("#curves tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map(({ textContent }) => textContent?.replaceAll(",", ""))));
      assert.ok(rows.length >= 8 && rows.length <= 16, `${rows.length} rows`);
      for (const [at, ...values] of rows) {
        runs.forEach((run, i) => {
          const row = /** @type {number[]} */ (run.rows.findLast((one, k) => k === 0 || (one[PAST.evaluations] <= Number(at) && Number(at) > 0)));
          assert.equal(Number(values[2 * i]), row === run.rows[0] ? Number(values[2 * i]) : row[PAST.vertices], `vertices at ${at}`);
          if (row[PAST.cost] === Infinity) assert.equal(values[2 * i + 1], "\u2013");
          else assert.ok(Math.abs(Number(values[2 * i + 1]) - row[PAST.cost]) < 1e-4 * row[PAST.cost], `length at ${at}`);
        });
      }
    });
  });

  test("a single run has curves too, against iterations, in a fold that asks for nothing while it is closed", async () => {
    await onPausedPage(async (page) => {
      await finish(page);
      assert.equal(await page.locator("svg.vertices path").count(), 0);
      await page.locator("#curves-fold > summary").click();
      await page.waitForFunction(() => document.querySelectorAll("svg.cost .future circle").length === 1);
      const { x, y } = await dot(page, "cost", "");
      assert.ok(Math.abs(x.value - 746) <= x.pixel && Math.abs(y.value - 8.934) <= y.pixel, `${x.value}, ${y.value}`);
      assert.match(await page.locator("svg.cost").textContent() ?? "", /iterations/);
    });
  });

  test("they follow a run that grows, drawn at most four times a second", async () => {
    await onPage({}, async (page) => {
      await page.locator("#speed").fill("30");
      await unfold(page, "curves");
      await page.waitForSelector("svg.vertices .line");
      const drawn = await page.evaluate(() => new Promise((/** @type {(times: number[]) => void} */ resolve) => {
        /** @type {number[]} */
        const times = [];
        const watch = new MutationObserver(() => {
          if (times.push(performance.now()) < 5) return;
          watch.disconnect();
          resolve(times);
        });
        // The picture is drawn anew; the mark of the time that is shown moves by itself.
        watch.observe(/** @type {Element} */ (document.querySelector("svg.vertices")), { childList: true });
      }));
      // However slow the machine is, what comes between two drawings can only be longer; each is noticed a little after it.
      for (let i = 1; i < drawn.length; i++) assert.ok(drawn[i] - drawn[i - 1] > 200, `${drawn}`);
    });
  });

  test("thinning keeps the first path and the end, rises, and costs no more for a long run", async () => {
    const { Scenario } = await import("planarium");
    const run = ended(new LocalRun(Scenario.parse(text("stones")), "prm", { samples: 5000, k: 9, seed: 0, shortcut: 200 }));
    for (const column of [-1, PAST.evaluations]) {
      const head = run.clock(column);
      const [rows] = thinned([run], column, head);
      const times = Array.from({ length: rows.length / 3 }, (_, i) => rows[3 * i]);
      assert.ok(times.length <= 300 && times.length > 200, `${times.length} points of ${run.made}`);
      assert.ok(times.every((at, i) => i === 0 || at > times[i - 1]), "times rise");
      assert.deepEqual([times[0], times[times.length - 1]], [0, head]);
      const found = run.foundBy(run.made);
      assert.ok(times.includes(run.clockAt(column, found)), "the first path is there");
      const costs = times.map((_, i) => rows[3 * i + 2]);
      assert.equal(costs.filter((cost) => cost < Infinity)[0], run.history.row(run.iterationAt(column, run.clockAt(column, found)))[PAST.cost]);
      assert.equal(costs[costs.length - 1], run.history.row(run.made)[PAST.cost]);
    }
  });

  test("ticks are round, reach beyond both ends, and are never one", () => {
    assert.deepEqual(ticks(0, 6694, 4), [0, 2000, 4000, 6000, 8000]);
    assert.deepEqual(ticks(7.93, 9.16, 4), [7.5, 8, 8.5, 9, 9.5]);
    for (const [low, high] of [[0, 0], [9.19, 9.19], [0, 1], [1e6, 1e6 + 1], [0, 2.5e7]]) {
      const marks = ticks(low, high, 4);
      assert.ok(marks.length >= 2 && marks.length <= 7 && marks[0] <= low && marks[marks.length - 1] >= high, `${marks}`);
    }
  });
});

describe("every screen", () => {
  test("axe finds nothing, nothing hangs over, controls are large enough, sheets stand in one column on a phone", async () => {
    await onPausedPage(async (page) => {
      await race(page, "rrt", "rrt-connect", "prm-star");
      await finish(page);
      await page.waitForSelector("svg.cost .end");
      await page.locator(".rival summary").first().click();
      await page.getByText("As a table").click();
      await assertFaultless(page, "a race of four");
      for (const [viewport, columns] of /** @type {const} */ ([[PHONE.viewport, 1], [{ width: 1280, height: 860 }, 2]])) {
        await page.setViewportSize(viewport);
        await assertTargets(page);
        assert.equal(new Set(await page.locator("#stage figure").evaluateAll((figures) => figures.map((figure) => Math.round(figure.getBoundingClientRect().left)))).size, columns);
      }
    });
  });
});
