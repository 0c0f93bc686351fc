/** A race: planners side by side, given the same work; the table and the curves say what the package says. */
import { withOptions } from "../../www/domain/option-names.js";
import assert from "node:assert/strict";
import { test } from "node:test";
import { planners } from "planarium";
import {
  PHONE,
  atRest,
  changes,
  chooseScene,
  click,
  fill,
  finish,
  frames,
  growthHash,
  keys,
  offered,
  onPage,
  onPausedPage,
  openScenario,
  pixelsOf,
  reveal,
  seek,
  setParameter,
  textMatches,
  unfold,
  useBrowser,
  valueWithin,
} from "./browser.mjs";
import { open, sceneOf } from "./library.mjs";
import { assertFaultless, assertTargets } from "./looks.mjs";
import { PAST } from "../../www/planner/run-log/columns.js";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("../../www/domain/types.js").Plan} Plan */

useBrowser();

/** What the package says of a plan by itself: its rows of history, its result. @param {string} id @param {Plan} plan */
function alone(id, { algorithm, settings }) {
  const planner = withOptions({ ...settings, algorithm }, (options) => open(sceneOf(id)).planner(options));
  planner.record();
  while (planner.step(1000) === "running");
  const data = planner.historySince(0);
  const width = planner.historyWidth;
  const rows = [
    [0, 0, 0, 0, 0, 0, 0, Infinity],
    ...Array.from({ length: data.length / width }, (_, i) => [...data.slice(i * width, (i + 1) * width)]),
  ];
  return { rows, planner, fingerprint: planner.fingerprint() };
}

/** Adds rivals. @param {Page} page @param {string[]} algorithms */
async function race(page, ...algorithms) {
  if (!(await page.isVisible("#rival"))) await page.locator("#race-fold > summary").click();
  for (const algorithm of algorithms) {
    await page.selectOption("#rival", algorithm);
    await page.click("#add-rival");
  }
  await atRest(page);
}

/** The table: a row of texts for each planner. @param {Page} page */
async function table(page) {
  return page.locator("#standings tbody tr").evaluateAll((rows) =>
    rows.map((row) => ({
      fingerprint: /** @type {HTMLElement} */ (row).dataset.fingerprint,
      name: row.children[0].textContent ?? "",
      counts: [...row.children].slice(1, 6).map(({ textContent }) => Number(textContent?.replaceAll(",", ""))),
      found: row.children[6].textContent ?? "",
      cost: row.children[7].textContent ?? "",
      waypoints: row.children[8].textContent ?? "",
      searched: [...row.children]
        .slice(9)
        .map((cell) => (/** @type {HTMLElement} */ (cell).hidden ? "" : (cell.textContent ?? ""))),
    })),
  );
}

const time = (/** @type {Page} */ page) => page.inputValue("#time").then(Number);

/**
 * Opens a rival's settings and gives one.
 * @param {Page} page
 * @param {string} rival
 * @param {string} name
 * @param {string} value
 */
async function give(page, rival, name, value) {
  const field = page.locator(`#rival-${rival}-${name}`);
  for (let i = 0; i < 2 && !(await field.isVisible()); i++)
    await page
      .locator(`fieldset.rival:has(#rival-${rival}-planner) details:not([open]) > summary:visible`)
      .last()
      .click();
  await fill(page, `#rival-${rival}-${name}`, value);
  await atRest(page);
}

const A = { algorithm: "prm", settings: { samples: 260, k: 9, seed: 0 } };
const settings = { seed: 0 };

const four = [
  A,
  { algorithm: "rrt", settings },
  { algorithm: "rrt-connect", settings },
  { algorithm: "prm-star", settings: { samples: 260, seed: 0 } },
];

/**
 * Checks that a race of `four` gets the same on any number of workers, at rest and at the end, and that a run after it
 * does: each planner has made as many iterations as fit into the time that is shown.
 * @param {Page} page
 * @param {number} workers   expected
 * @param {number[]} [times]
 */
async function assertSameOn(page, workers, times = [1234]) {
  const runs = four.map((plan) => alone("stones", plan));
  await race(page, "rrt", "rrt-connect", "prm-star");
  assert.equal(await time(page), 0);
  for (const { counts } of await table(page)) assert.deepEqual(counts.slice(3), [0, 0]);
  assert.equal(page.workers().length, workers);
  for (const wanted of times) {
    await seek(page, wanted);
    assert.equal(await time(page), wanted);
    (await table(page)).forEach(({ counts, name }, i) => {
      const at = runs[i].rows.findLastIndex((row) => row[PAST.clearanceEvaluations] <= wanted);
      assert.deepEqual(
        counts,
        [
          ...[PAST.vertices, PAST.edges, PAST.motionChecks, PAST.clearanceEvaluations].map(
            (column) => runs[i].rows[at][column],
          ),
          at,
        ],
        `${name} at ${wanted}`,
      );
    });
  }
  await finish(page);
  assert.deepEqual(
    (await table(page)).map(({ fingerprint }) => fingerprint),
    runs.map(({ fingerprint }) => fingerprint),
  );
  for (const rival of ["D", "C", "B"]) await click(page, `fieldset.rival:has(#rival-${rival}-planner) button`);
  assert.equal((await finish(page)).fingerprint, runs[0].fingerprint);
}

/** @param {number} count   of processors */
const processors = (count) => ({
  before: async (/** @type {Page} */ page) =>
    void (await page.addInitScript(
      (n) => Object.defineProperty(navigator, "hardwareConcurrency", { value: n }),
      count,
    )),
});

test("on four processors three workers plan a race of four, on one processor one does: the same", async () => {
  // One more finds the shortest path.
  await onPausedPage(
    (page) => assertSameOn(page, 3 + 1, [100, 189, 190, 1234, 3475, 6693, 6694, 700, 12_345]),
    {},
    processors(4),
  );
  await onPausedPage((page) => assertSameOn(page, 1 + 1), {}, processors(1));
});

test("where no further worker can be loaded the first one plans for all", async () => {
  let loaded = 0;
  await onPausedPage(
    async (page) => {
      await assertSameOn(page, 1);
      assert.ok(loaded > 1, "it was tried");
      assert.equal(await page.isHidden("#notice"), true);
    },
    {},
    {
      expectErrors: true,
      before: async (page) => {
        await processors(8).before(page);
        await page.route(/\/worker\.js$/, (route) => (loaded++ === 0 ? route.continue() : route.abort()));
      },
    },
  );
});

test("a path's vertices, and of roadmaps what the search has visited and its time, are columns; the time tells apart roadmaps that tie", () =>
  onPausedPage(async (page) => {
    const runs = ["a-star", "dijkstra", "breadth-first"].map(
      (search) => alone("stones", { ...A, settings: { ...A.settings, search } }).planner,
    );
    await race(page, "prm", "prm");
    await give(page, "B", "search", "dijkstra");
    await give(page, "C", "search", "breadth-first");
    await finish(page);
    const rows = await table(page);
    assert.deepEqual(
      rows.map(({ waypoints }) => waypoints),
      runs.map((run) => String(run.result().path.length)),
    );
    assert.deepEqual(
      rows.map(({ searched: [visited] }) => visited),
      runs.map((run) => String(run.stats().visited)),
    );
    for (const {
      searched: [, seconds],
    } of rows)
      assert.match(seconds, /^(?:below )?[\d.]+ ms$/);
    assert.match(
      await page.innerText("#story"),
      new RegExp(`Vertices visited: ${runs.map((run, i) => `${"ABC"[i]} ${run.stats().visited}`).join(", ")}\\.$`),
    );
    await seek(page, 100);
    assert.deepEqual(
      (await table(page)).map(({ waypoints, searched: [visited] }) => [waypoints, visited]),
      runs.map(() => ["\u2013", "0"]),
    );
    for (const rival of ["C", "B"]) await click(page, `fieldset.rival:has(#rival-${rival}-planner) button`);
    await race(page, "rrt");
    await finish(page);
    assert.deepEqual(
      (await table(page)).map(({ searched }) => searched[1] !== "" && searched[1] !== "\u2013"),
      [true, false],
      "a tree is not searched",
    );
  }));

test("a world where no clearance is ever evaluated holds nobody up, and the page says what that means", () =>
  onPausedPage(async (page) => {
    await openScenario(page, {
      format: "planarium-scenario-1",
      name: "empty",
      world: { obstacles: [] },
      robot: { type: "arm", base: [0, 0], links: [1, 0.8] },
      queries: [{ name: "across", start: [0.6, 0.2], goal: [-0.6, -0.2] }],
    });
    await race(page, "rrt");
    await click(page, "#step-1");
    const [a, b] = await table(page);
    assert.deepEqual([a.counts[3], b.counts[3]], [0, 0]);
    assert.ok(a.fingerprint && b.fingerprint && a.counts[4] > 0 && b.counts[4] > 0);
    assert.match(await page.innerText("#story"), /nothing to avoid/);
    await click(page, "#back");
    assert.deepEqual(
      (await table(page)).map(({ counts }) => counts[4]),
      [0, 0],
    );
  }));

test("the transport counts clearance evaluations and says so; going back shows what was there", () =>
  onPausedPage(async (page) => {
    await race(page, "rrt-connect", "rrt");
    assert.deepEqual(await page.locator(".steps button").allInnerTexts(), ["10", "100", "1,000"]);
    for (const [id, name] of [
      ["step-1", "Step 10 clearance evaluations"],
      ["step-100", "Step 1,000 clearance evaluations"],
      ["back", "Back 10 clearance evaluations"],
    ]) {
      assert.equal(await page.getAttribute(`#${id}`, "aria-label"), name);
    }
    assert.match((await page.getAttribute("#timeline", "aria-label")) ?? "", /clearance evaluations/);
    assert.match((await page.getAttribute("#speed", "aria-valuetext")) ?? "", /clearance evaluations a second/);
    assert.equal(await page.getByRole("spinbutton", { name: /^Clearance evaluations/ }).getAttribute("id"), "time");
    await click(page, "#step-100");
    assert.equal(await time(page), 1000);
    assert.match(await page.innerText("#time-head"), /^of 1,000 evaluations$/);
    // The shortest path is computed beside the run.
    await textMatches(page, "#standings", /gap/);
    const pictures = () => Promise.all(["lane-A", "lane-B", "lane-C"].map((pane) => growthHash(page, pane)));
    const [rows, then] = [await table(page), await pictures()];
    assert.equal(new Set(then).size, 3, "each sheet shows its own planner");
    await click(page, "#step-1");
    assert.equal(await time(page), 1010);
    await click(page, "#back");
    assert.deepEqual([await table(page), await pictures()], [rows, then]);
    await finish(page);
    await page.fill("#timeline", "1000");
    await atRest(page);
    const counts = async () => (await table(page)).map((row) => row.counts);
    assert.deepEqual([await counts(), await pictures()], [rows.map((row) => row.counts), then]);
    await click(page, "#reset");
    assert.deepEqual(
      (await table(page)).map(({ counts }) => counts[4]),
      [0, 0, 0],
    );
  }));

test("one switch chooses the picture of all sheets; play grows all of them, pause stops all of them", () =>
  onPausedPage(async (page) => {
    await race(page, "rrt", "prm");
    assert.equal(await page.locator("#stage figure.cspace").count(), 3);
    await page.getByLabel("Workspace", { exact: true }).check();
    assert.equal(await page.locator("#stage figure.workspace").count(), 3);
    // Slow enough that none ends meanwhile.
    await page.fill("#speed", "25");
    await page.click("#play");
    await valueWithin(page, "time", 100);
    await click(page, "#play");
    const at = await time(page);
    const rows = await table(page);
    assert.ok(rows.every(({ counts }) => counts[4] > 0));
    assert.equal(await page.getAttribute("#play", "data-playing"), "false");
    await frames(page);
    assert.equal(await time(page), at);
    assert.deepEqual(await table(page), rows);
    await finish(page);
    for (const lane of ["lane-A", "lane-B"])
      assert.ok(
        (await pixelsOf(page, lane, "vertices", "growth")) + (await pixelsOf(page, lane, "edges", "start")) > 0,
        lane,
      );
    assert.match(
      (await page.getAttribute("#lane-B canvas[role=img]", "aria-label")) ?? "",
      /^Workspace of B RRT.*solved/,
    );
  }));

test("two, three or four run as each would alone, bit for bit; then the robots follow their paths", () =>
  onPausedPage(async (page) => {
    const plans = [
      A,
      { algorithm: "rrt-connect", settings },
      { algorithm: "rrt", settings },
      { algorithm: "visibility-prm", settings },
    ];
    const runs = plans.map((plan) => alone("stones", plan));
    for (let count = 2; count <= 4; count++) {
      await race(page, plans[count - 1].algorithm);
      assert.equal(await page.locator("#stage figure").count(), count);
      await finish(page);
      const rows = await table(page);
      assert.deepEqual(
        rows.map(({ fingerprint }) => fingerprint),
        runs.slice(0, count).map(({ fingerprint }) => fingerprint),
      );
      rows.forEach(({ counts, found, cost }, i) => {
        const { rows: history, planner } = runs[i];
        const last = history[history.length - 1];
        assert.deepEqual(counts, [
          ...[PAST.vertices, PAST.edges, PAST.motionChecks, PAST.clearanceEvaluations].map((column) => last[column]),
          history.length - 1,
        ]);
        const first = history.find((row) => row[PAST.length] < Infinity);
        assert.equal(
          found.split(",").slice(0, 2).join("").match(/^\d+/)?.[0] ?? found,
          first
            ? String(first[PAST.clearanceEvaluations])
            : planner.reason === "not-connected"
              ? "not connected"
              : "gave up",
        );
        if (first) assert.equal(cost.split(" (")[0], `${planner.result().length.toFixed(2)} rad`);
      });
    }
    assert.equal(await page.isDisabled("#add-rival"), true, "four race at most");
    for (const lane of ["lane-A", "lane-B"]) assert.ok((await pixelsOf(page, lane, "top", "path")) > 150, lane);
    assert.equal(await page.isVisible("#along-row"), true);
  }));

test("a rival of the same planner is a copy until it is changed; captions say what differs", () =>
  onPausedPage(async (page) => {
    const run = alone("stones", { algorithm: "prm", settings: { samples: 260, k: 4, seed: 0 } });
    await race(page, "prm");
    await finish(page);
    const [a, b] = await table(page);
    assert.equal(a.fingerprint, b.fingerprint);
    assert.deepEqual([a.name, b.name], ["A PRM", "B PRM"]);
    assert.match(a.found, / \(tied for first\)$/);
    assert.match(
      await page.innerText("#story"),
      /^A and B tied: both found a path after [\d,]+ clearance evaluations, of length \d+\.\d\d rad\.$/,
    );
    await give(page, "B", "k", "4");
    await finish(page);
    const rows = await table(page);
    assert.deepEqual(
      rows.map(({ name }) => name),
      ["A PRM, k 9", "B PRM, k 4"],
    );
    assert.equal(rows[1].fingerprint, run.fingerprint);
    assert.deepEqual(await page.locator("#stage figcaption span").allInnerTexts(), ["A PRM, k 9", "B PRM, k 4"]);
    await give(page, "B", "shortcut", "30");
    await finish(page);
    assert.equal((await table(page))[1].name, "B PRM, k 4, shortcut 30");
  }));

test("a rival has all parameters of its planner; a refused value says why and leaves that parameter as it was", () =>
  onPausedPage(async (page) => {
    await race(page, "rrt");
    const isArms = (/** @type {{ robots: string[] }} */ { robots }) => robots.includes("arm");
    for (const { id, parameters } of planners().filter(isArms)) {
      await page.selectOption("#rival-B-planner", id);
      for (const { name } of parameters.filter(isArms))
        assert.equal(await page.locator(`#rival-B-${name}`).count(), 1, `${id}: ${name}`);
    }
    await page.selectOption("#rival-B-planner", "prm");
    await finish(page);
    const before = await table(page);
    await give(page, "B", "k", "0");
    assert.match(await page.innerText("#rival-B-k-reason"), /below/);
    assert.deepEqual(await table(page), before);
    await setParameter(page, "k", "5");
    await atRest(page);
    assert.deepEqual(
      (await table(page)).map(({ name }) => name),
      ["A PRM, k 5", "B PRM, k 9"],
    );
    assert.equal(await page.inputValue("#rival-B-k"), "0");
    assert.match(await page.innerText("#rival-B-k-reason"), /below/);
    await give(page, "B", "k", "7");
    assert.deepEqual(
      (await table(page)).map(({ name }) => name),
      ["A PRM, k 5", "B PRM, k 7"],
    );
  }));

test("a plan that the core refuses names its planner and its field", () =>
  onPausedPage(async (page) => {
    await chooseScene(page, "rings");
    await race(page, "rrt-connect", "rrt");
    await give(page, "C", "metric", "naive");
    await page.waitForSelector("#notice:not([hidden])");
    assert.match(
      await page.innerText("#notice"),
      /^C, RRT, cannot be planned\. .*naive.*\. Change its settings or remove C to start the race\./,
    );
    assert.deepEqual(
      (await table(page)).map(({ found }) => found),
      ["not started", "not started", "not started"],
    );
    assert.equal(await page.getAttribute("#notice", "data-pointer"), "/metric");
    assert.match(await page.innerText("#rival-C-metric-reason"), /naive/);
    assert.equal(await page.isHidden("#rival-B-metric-reason"), true);
    await give(page, "C", "metric", "euclidean");
    assert.equal(await page.isHidden("#notice"), true);
    await finish(page);
    assert.ok((await table(page)).every(({ fingerprint }) => fingerprint));
  }));

test("they stay when the scene changes, go one by one, and the last one leaves a single run behind", () =>
  onPausedPage(async (page) => {
    await race(page, "rrt", "rrt-connect");
    await chooseScene(page, "rings");
    assert.deepEqual(
      (await table(page)).map(({ name }) => name),
      ["A PRM", "B RRT", "C RRT-Connect"],
    );
    assert.equal(await page.locator("#stage figure.workspace").count(), 3);
    assert.equal(await page.locator("input[name=lens]").first().isVisible(), false, "a disc has one picture");
    await page.getByRole("button", { name: "Remove B" }).click();
    await atRest(page);
    assert.deepEqual(
      (await table(page)).map(({ name }) => name),
      ["A PRM", "B RRT-Connect"],
    );
    assert.equal(await page.evaluate(() => document.activeElement?.id), "add-rival");
    await keys(page, "Shift+Tab", "Shift+Tab", "Shift+Tab");
    assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("aria-label")), "Remove B");
    await page.keyboard.press("Enter");
    await atRest(page);
    assert.equal(await page.locator("#standings table").count(), 0);
    assert.equal(await page.isVisible("#counters"), true);
    assert.equal(await page.locator("#stage figure").count(), 1);
    assert.deepEqual(await page.locator(".steps button").allInnerTexts(), ["1", "10", "100"]);
    const { fingerprint } = await finish(page);
    assert.equal(
      fingerprint,
      alone("rings", { algorithm: "prm", settings: { samples: 900, k: 9, seed: 14 } }).fingerprint,
    );
  }));

test("only planners that serve the robot are offered; others are removed, and the race goes on", () =>
  onPausedPage(async (page) => {
    const idsFor = (/** @type {string} */ robot) =>
      planners().flatMap(({ id, robots }) => (robots.some((one) => one === robot) ? [id] : []));
    await race(page, "rrt");
    assert.deepEqual(await offered(page, "rival"), idsFor("arm"));
    await chooseScene(page, "blossom");
    for (const list of ["rival", "rival-B-planner"]) assert.deepEqual(await offered(page, list), idsFor("car"));
    await page.selectOption("#rival-B-planner", "rrt-control");
    await race(page, "sst", "rrt");
    await chooseScene(page, "rings");
    assert.equal(
      await page.innerText("#notice strong"),
      "Kinodynamic RRT needs a car; this scene has a disc: PRM is used as A. Kinodynamic RRT needs a car, so rival B was removed. SST needs a car, so rival C was removed.",
    );
    assert.deepEqual(
      (await table(page)).map(({ name, found }) => [name, found]),
      [
        ["A PRM", "sampling"],
        ["B RRT", "growing"],
      ],
    );
    for (const list of ["rival", "rival-B-planner"]) assert.deepEqual(await offered(page, list), idsFor("disc"));
    await page.click("#play");
    await valueWithin(page, "time", 0);
    await finish(page);
    assert.ok((await table(page)).every(({ fingerprint }) => fingerprint));
  }));

test("a rival has the presets of its planner; by hand it is the reader's own again", () =>
  onPausedPage(async (page) => {
    const preset = planners().find(({ id }) => id === "prm")?.presets[0];
    assert.ok(preset);
    await race(page, "prm");
    await page.locator("fieldset.rival details > summary").first().click();
    assert.equal(await page.inputValue("#rival-B-preset"), "own");
    await page.selectOption("#rival-B-preset", preset.id);
    await atRest(page);
    for (const [name, value] of Object.entries(preset.settings))
      assert.equal(await page.inputValue(`#rival-B-${name}`), String(value), name);
    await finish(page);
    assert.equal(
      (await table(page))[1].fingerprint,
      alone("stones", { algorithm: "prm", settings: { seed: 0, ...preset.settings } }).fingerprint,
    );
    await give(page, "B", "k", "6");
    assert.equal(await page.inputValue("#rival-B-preset"), "own");
    await page.selectOption("#rival-B-planner", "rrt-connect");
    assert.equal(await page.isVisible("#rival-B-preset"), false);
  }));

test("the first and the shortest are named in the table, above the stage and to those who listen", () =>
  onPausedPage(async (page) => {
    await race(page, "rrt-connect");
    await seek(page, 492);
    assert.deepEqual(
      (await table(page)).map(({ found }) => found),
      ["connecting", "492 (first)"],
    );
    await textMatches(page, "#announcer", /^B found a path\.$/);
    await finish(page);
    // The shortest path is computed beside the run.
    await textMatches(page, "#standings", /gap[^]*gap/);
    const [a, b] = await table(page);
    assert.match(a.cost, /^8\.93 rad \(gap \d\.\d %, shortest\)$/);
    assert.match(b.cost, /^10\.02 rad \(gap \d+ %\)$/);
    assert.equal(
      await page.innerText("#story"),
      "B found a path first, after 492 clearance evaluations; A has the shortest, 8.93 rad.",
    );
    await textMatches(page, "#announcer", /A has the shortest, 8\.93 rad\.$/);
    assert.match(await page.innerText("#standings"), /This is one seed: over many seeds the winner may differ\./);
  }));

/**
 * A dot of a chart in its own units, read off its axes.
 * @param {Page} page
 * @param {string} chart
 * @param {string} label
 */
async function dot(page, chart, label) {
  return page.locator(`svg.${chart}`).evaluate((picture, name) => {
    /** The place of an element that is moved. @param {Element} element */
    const placeOf = (element) => (element.getAttribute("transform")?.match(/-?[\d.]+/g) ?? []).map(Number);
    /** @param {"x" | "y"} axis @param {number} at */
    const value = (axis, at) => {
      const marks = [...picture.querySelectorAll(`.${axis}-axis-tick-label text`)].map((mark) => [
        placeOf(mark)[axis === "x" ? 0 : 1],
        Number(mark.textContent?.replaceAll(",", "")),
      ]);
      const [[p, a], [q, b]] = [marks[0], marks[marks.length - 1]];
      return { value: a + ((at - p) / (q - p)) * (b - a), pixel: Math.abs((b - a) / (q - p)) };
    };
    const labels = [...picture.querySelectorAll(".end")].map(({ textContent }) => textContent);
    const circle = /** @type {SVGCircleElement} */ (
      picture.querySelectorAll(".future circle")[name ? labels.toSorted().indexOf(name) : 0]
    );
    const cursor = /** @type {SVGLineElement} */ (picture.querySelector(".cursor"));
    return {
      x: value("x", circle.cx.baseVal.value),
      y: value("y", circle.cy.baseVal.value),
      cursor: value("x", cursor.x1.baseVal.value),
    };
  }, label);
}

test("over 100 seeds a race is an experiment with all its planners", () =>
  onPausedPage(async (page) => {
    await race(page, "rrt");
    for (const button of ["#race-over-seeds", "#over-seeds"]) {
      const [other] = await Promise.all([page.context().waitForEvent("page"), page.click(button)]);
      await other.waitForSelector('body[data-count="200"]');
      assert.equal(await other.isHidden("#notice"), true);
      await other.close();
    }
  }));

test("the path's curve begins where the path was found; the cursor is at the time that is shown", () =>
  onPausedPage(async (page) => {
    const plans = [
      { algorithm: "prm", settings: { ...A.settings, shortcut: 60 } },
      { algorithm: "rrt-connect", settings: { seed: 0, shortcut: 60 } },
    ];
    const runs = plans.map((plan) => alone("stones", plan));
    await reveal(page, "#more-parameters");
    await setParameter(page, "shortcut", "60");
    await race(page, "rrt-connect");
    assert.equal(
      await page.locator("#curves-fold").evaluate((fold) => /** @type {HTMLDetailsElement} */ (fold).open),
      true,
    );
    await finish(page);
    await seek(page, 2000);
    await page.waitForFunction(() => document.querySelectorAll("svg.cost .future circle").length === 2);
    for (const [i, label] of ["A", "B"].entries()) {
      const first = /** @type {number[]} */ (runs[i].rows.find((row) => row[PAST.length] < Infinity));
      const { x, y, cursor } = await dot(page, "cost", label);
      assert.ok(
        Math.abs(x.value - first[PAST.clearanceEvaluations]) <= x.pixel,
        `${label} at ${x.value}, not ${first[PAST.clearanceEvaluations]}`,
      );
      assert.ok(
        Math.abs(y.value - first[PAST.length]) <= y.pixel,
        `${label} is ${y.value} long, not ${first[PAST.length]}`,
      );
      assert.ok(Math.abs(cursor.value - 2000) <= cursor.pixel, `cursor at ${cursor.value}`);
    }
    // The reference that both are compared with is a line as well.
    await page.waitForSelector("svg.gap .end");
    const dashes = await page
      .locator("svg.cost .future path")
      .evaluateAll((paths) => paths.map((path) => getComputedStyle(path).strokeDasharray));
    assert.equal(new Set(dashes).size, 3, "lines differ by more than colour");
    assert.deepEqual(
      await page
        .locator("svg.cost .end")
        .allTextContents()
        .then((labels) => labels.toSorted()),
      ["A", "B", "reference"],
    );
    const { length } = open(sceneOf("stones")).optimum();
    const label = (await page.getAttribute("svg.vertices", "aria-label")) ?? "";
    assert.match(label, /^Vertices against clearance evaluations.*A PRM.*262.*B RRT-Connect/);
    await page.getByText("As a table").click();
    await page.waitForSelector("#curves tbody tr");
    const rows = await page
      .locator("#curves tbody tr")
      .evaluateAll((all) =>
        all.map((row) => [...row.children].map(({ textContent }) => textContent?.replaceAll(",", ""))),
      );
    assert.ok(rows.length >= 8 && rows.length <= 16, `${rows.length} rows`);
    for (const [at, ...values] of rows) {
      runs.forEach((run, i) => {
        const row = /** @type {number[]} */ (
          run.rows.findLast((one, k) => k === 0 || (one[PAST.clearanceEvaluations] <= Number(at) && Number(at) > 0))
        );
        const [vertices, cost, gap] = values.slice(3 * i);
        assert.equal(
          Number(vertices),
          row === run.rows[0] ? Number(vertices) : row[PAST.vertices],
          `vertices at ${at}`,
        );
        if (row[PAST.length] === Infinity) return assert.deepEqual([cost, gap], ["\u2013", "\u2013"]);
        assert.ok(Math.abs(Number(cost) - row[PAST.length]) < 1e-4 * row[PAST.length], `length at ${at}`);
        assert.ok(
          Math.abs(Number(gap) - 100 * (row[PAST.length] / (length ?? NaN) - 1)) < 0.06,
          `gap at ${at}: ${gap} of ${row[PAST.length]} and ${length}`,
        );
      });
    }
  }));

test("a single run has curves against iterations, in a fold that is idle while it is closed", () =>
  onPausedPage(async (page) => {
    await finish(page);
    assert.equal(await page.locator("svg.vertices path").count(), 0);
    await page.locator("#curves-fold > summary").click();
    await page.waitForFunction(() => document.querySelectorAll("svg.cost .future circle").length === 1);
    const { x, y } = await dot(page, "cost", "");
    assert.ok(Math.abs(x.value - 746) <= x.pixel && Math.abs(y.value - 8.934) <= y.pixel, `${x.value}, ${y.value}`);
    assert.match((await page.locator("svg.cost").textContent()) ?? "", /iterations/);
  }));

test("they follow a run that grows, drawn at most four times a second", () =>
  onPage(
    {},
    async (page) => {
      await page.fill("#speed", "30");
      await unfold(page, "curves");
      await page.waitForSelector("svg.vertices .line");
      // The picture is drawn again; the mark of the time that is shown moves by itself.
      const drawn = await changes(page, "svg.vertices", { childList: true });
      for (let i = 1; i < drawn.length; i++) assert.ok(drawn[i] - drawn[i - 1] >= 250, `${drawn}`);
    },
    {
      before: async (page) => {
        await page.clock.install();
      },
    },
  ));

test("in a race of four axe finds nothing and all fits; on a phone sheets stand in one column", () =>
  onPausedPage(async (page) => {
    await race(page, "rrt", "rrt-connect", "prm-star");
    await finish(page);
    await page.waitForSelector("svg.cost .end");
    await page.locator(".rival summary").first().click();
    await page.getByText("As a table").click();
    await assertFaultless(page, "a race of four", 120);
    for (const [viewport, columns] of /** @type {const} */ ([
      [PHONE.viewport, 1],
      [{ width: 1280, height: 860 }, 2],
    ])) {
      await page.setViewportSize(viewport);
      await assertTargets(page);
      assert.equal(
        new Set(
          await page
            .locator("#stage figure")
            .evaluateAll((figures) => figures.map((figure) => Math.round(figure.getBoundingClientRect().left))),
        ).size,
        columns,
      );
    }
  }));
