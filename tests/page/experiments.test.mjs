/**
 * The page of experiments: its rows equal the core's, however they are run; charts, files and links hold what it
 * shows.
 */
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Experiment, ecdf, paired, quartiles, share } from "planarium/full";
import { ceilingOf, tasksOf } from "../../www/experiments/ceiling.js";
import { captionOf } from "../../www/experiments/chart-view.js";
import { bySettings } from "../../www/experiments/charts/summaries.js";
import { CHARTS, chartOf, completed, remarkOf } from "../../www/experiments/charts.js";
import { commonTrials } from "../../www/experiments/common.js";
import { comparisons } from "../../www/experiments/comparisons.js";
import { decodeExperiment, encodeExperiment } from "../../www/experiments/link.js";
import { Rows } from "../../www/experiments/rows.js";
import {
  counters,
  download,
  fill,
  frames,
  linkOf,
  onPage,
  pickFile,
  root,
  useBrowser,
  violations,
} from "./browser.mjs";
import { assertFaultless, assertTargets, overhang } from "./looks.mjs";

/** @import { ExperimentDocument, TrialRow } from "planarium/full" */
/** @import { Page } from "./browser.mjs" */
/** @import { LinkedDocument } from "../../www/domain/types.js" */
/** @import { View } from "../../www/experiments/link.js" */

useBrowser();

/** @type {{ experiment: ExperimentDocument, outcome: { rows: string[] } }[]} */
const golden = JSON.parse(readFileSync(join(root, "tests", "golden-experiment.json"), "utf8"));

/** Two scenes, two planners, a parameter: 48 trials, some without a path. @type {LinkedDocument} */
const small = {
  format: "planarium-experiment-1",
  title: "Small",
  worlds: [{ scene: "stones" }, { name: "made", generate: "discs", set: { count: 20 }, seeds: [3] }],
  planners: [
    { algorithm: "prm", set: { samples: 40 }, vary: { k: [2, 4] } },
    { algorithm: "rrt-connect", set: { max_iterations: 60 } },
  ],
  seeds: { from: 0, count: 8 },
  verify: true,
};

/** The names of its planners and worlds. @type {Record<string, string>} */
const titles = { prm: "PRM", "rrt-connect": "RRT-Connect", stones: "Two links among stones", made: "made" };

/** Runs many trials, one worker or three. @param {number} workers */
const processors = (workers) => (/** @type {Page} */ page) =>
  void page.addInitScript(
    (count) => Object.defineProperty(navigator, "hardwareConcurrency", { value: count }),
    workers + 1,
  );

/**
 * Opens an experiment by its link, which also runs it.
 * @param {{ document: LinkedDocument, view?: View }} experiment
 * @param {(page: Page, url: string) => Promise<void>} act
 * @param {import("./browser.mjs").More} [more]
 */
async function onExperiment(experiment, act, more = {}) {
  await onPage({}, act, { path: `experiments.html#${await encodeExperiment(experiment)}`, ...more });
}

/** All trials have ended, and their chart is drawn. @param {Page} page */
const done = (page) => page.waitForSelector("body[data-phase=done][data-settled=true]:not([data-chart=''])");

/** Saves a file of the page. @param {Page} page @param {string} id */
async function taken(page, id) {
  await page.locator("#export-fold").evaluate((fold) => {
    /** @type {HTMLDetailsElement} */ (fold).open = true;
  });
  return download(page, `#export-${id}`);
}

/** The rows of a document, as the core gives them here. @param {string | ExperimentDocument} document */
function rowsOf(document) {
  const experiment = Experiment.parse(document);
  const { columns } = experiment;
  const rows = Array.from({ length: experiment.trialCount }, (_, i) => {
    const trial = experiment.trial(i);
    while (trial.step(1e6));
    const row = trial.row();
    trial.free();
    return row;
  });
  const summary = experiment.summary(rows);
  experiment.free();
  return {
    rows,
    summary,
    csv: `${[columns, ...rows.map((row) => columns.map((column) => row[column] ?? ""))].map((cells) => cells.join(",")).join("\n")}\n`,
  };
}

/**
 * The table behind a kind of chart.
 * @param {Page} page
 * @param {string} kind
 * @returns {Promise<Record<string, string>[]>}
 */
async function tableOf(page, kind) {
  await page.locator("#table-fold").evaluate((fold) => {
    /** @type {HTMLDetailsElement} */ (fold).open = true;
  });
  await page.click(`#kinds [data-kind=${kind}]`);
  await page.waitForSelector(`body[data-chart=${kind}][data-settled=true]`);
  return page.locator("#table table").evaluate((table) => {
    const { tHead, tBodies } = /** @type {HTMLTableElement} */ (table);
    const names = Array.from(tHead?.rows[0].cells ?? [], ({ textContent }) => textContent ?? "");
    return Array.from(tBodies[0].rows, ({ cells }) =>
      Object.fromEntries(Array.from(cells, (cell, i) => [names[i], cell.dataset.value ?? ""])),
    );
  });
}

for (const workers of [1, 3]) {
  test(`rows are the golden ones, run by ${workers === 1 ? "one worker" : "three"}`, async () => {
    for (const { experiment: document, outcome } of golden) {
      await onExperiment(
        { document },
        async (page) => {
          await done(page);
          const { text } = await taken(page, "rows");
          assert.deepEqual(text.trimEnd().split("\n").slice(1), outcome.rows);
          assert.equal(text, rowsOf(document).csv);
          const times = (await taken(page, "times")).text.trimEnd().split("\n");
          assert.equal(times[0], "trial,build_seconds,search_seconds");
          assert.equal(times.length, outcome.rows.length + 1);
        },
        { before: async (page) => processors(workers)(page) },
      );
    }
  });
}

test("trials of a worker that cannot be loaded are run by the others", () =>
  onExperiment(
    { document: small },
    async (page) => {
      await done(page);
      assert.equal((await taken(page, "rows")).text, rowsOf((await taken(page, "document")).text).csv);
    },
    {
      expectErrors: true,
      before: async (page) => {
        processors(3)(page);
        let loaded = 0;
        await page.route("**/rooms/worker.js", (route) => (loaded++ === 0 ? route.continue() : route.abort()));
      },
    },
  ));

test("charts have the values of the rows; pictures and files hold them", () =>
  onExperiment({ document: small }, async (page) => {
    await done(page);
    const { rows, csv, summary } = rowsOf((await taken(page, "document")).text);
    assert.equal((await taken(page, "rows")).text, csv);
    assert.deepEqual(JSON.parse((await taken(page, "summary")).text), summary);
    assert.equal(rows.length, 48);
    /** @param {(row: TrialRow) => boolean} which @param {string} measure */
    const sample = (which, measure) =>
      Float64Array.from(rows.filter(which), (row) => (row.status === "solved" ? Number(row[measure]) : NaN));
    assert.ok(
      rows.some(({ status }) => status !== "solved"),
      "not all have a path",
    );

    await fill(page, "#view-axis", "planner.k");
    for (const record of await tableOf(page, "success")) {
      const which = (/** @type {TrialRow} */ row) =>
        String(row["planner.k"] ?? "null") === record["planner.k"] &&
        record.series === `${titles[String(row.planner)]}, ${titles[String(row.world)]}`;
      const one = share(Array.from(rows.filter(which), ({ status }) => Number(status === "solved")));
      assert.deepEqual([record.trials, record.percent, record.low, record.high].map(Number), [
        one.n,
        ...[one.share, one.low, one.high].map((value) => 100 * Number(value)),
      ]);
    }
    await fill(page, "#view-measure", "valid");
    for (const record of await tableOf(page, "success")) {
      const some = rows.filter(
        (row) =>
          String(row["planner.k"] ?? "null") === record["planner.k"] &&
          record.series === `${titles[String(row.planner)]}, ${titles[String(row.world)]}`,
      );
      const one = share(Array.from(some, ({ valid }) => (valid === null ? NaN : Number(valid))));
      assert.deepEqual([record.trials, record.missing, record.percent].map(Number), [
        one.n,
        one.missing,
        one.share === null ? NaN : 100 * one.share,
      ]);
    }
    for (const record of await tableOf(page, "box")) {
      const which = (/** @type {TrialRow} */ row) =>
        String(row["planner.k"] ?? "null") === record["planner.k"] &&
        record.series === `${titles[String(row.planner)]}, ${titles[String(row.world)]}`;
      const { n, missing, values } = quartiles(sample(which, "length"));
      assert.deepEqual([record.trials, record.missing].map(Number), [n, missing]);
      if (values)
        assert.deepEqual(
          ["least", "lower quartile", "median", "upper quartile", "most"].map((column) => Number(record[column])),
          [...values],
        );
    }
    assert.equal(
      await page.locator(".plot .trial").count(),
      rows.filter(({ status }) => status === "solved").length,
      "a dot for each path",
    );

    const steps = await tableOf(page, "ecdf");
    const connect = ecdf(
      sample(
        ({ planner, world }) => planner === "rrt-connect" && world === "made",
        await page.inputValue("#view-work"),
      ),
    );
    const own = steps.filter(({ series }) => series === "RRT-Connect, made");
    assert.deepEqual(
      own.map((step) => Number(step["share percent"])),
      connect.shares.map((one) => 100 * one),
      "failures stay in the denominator",
    );

    await page.click("#kinds [data-kind=heat]");
    await fill(page, "#view-second", "world");
    await fill(page, "#view-measure", "motion_checks");
    for (const record of await tableOf(page, "heat")) {
      const { n, values } = quartiles(
        sample(
          (row) => String(row["planner.k"]) === record["planner.k"] && row.world === record.world,
          "motion_checks",
        ),
      );
      assert.deepEqual([record.trials, record.median].map(Number), [n, values?.[2] ?? NaN]);
    }
    for (const kind of ["cost", "line"]) assert.ok((await tableOf(page, kind)).length > 1, kind);

    // In words, two settings at a time, trial by trial: a yes or no by McNemar's test, a length by Wilcoxon's.
    await page.click("#kinds [data-kind=success]");
    await fill(page, "#view-measure", "solved");
    await page.waitForSelector("body[data-chart=success][data-settled=true]");
    const settings = /** @type {const} */ ([
      ["prm", 2, "PRM, k = 2"],
      ["prm", 4, "PRM, k = 4"],
      ["rrt-connect", null, "RRT-Connect"],
    ]).map(([planner, k, name]) => {
      const own = rows.filter((row) => row.planner === planner && row["planner.k"] === k);
      return {
        name,
        solved: Float64Array.from(own, ({ status }) => Number(status === "solved")),
        lengths: Float64Array.from(own, (row) => Number(row.length ?? NaN)),
      };
    });
    const words = () => page.locator("#words li").allInnerTexts();
    const rounded = (/** @type {number} */ p) =>
      Math.round(p * 1e4) > 0 ? `p = ${Math.round(p * 1e4) / 1e4}` : "p < 0.0001";
    for (const [a, b] of [
      [settings[1], settings[0]],
      [settings[2], settings[0]],
      [settings[0], settings[2]],
    ]) {
      await page.selectOption("#baseline", b.name);
      await page.selectOption("#other", a.name);
      await page.waitForSelector("body[data-settled=true]");
      assert.deepEqual([await page.inputValue("#other"), await page.inputValue("#baseline")], [a.name, b.name]);
      const shares = paired(a.solved, b.solved, a.name, b.name, "");
      const sentences = await words();
      assert.ok(sentences.length <= 4, sentences.join("\n"));
      assert.match(sentences[1], /McNemar\u2019s exact test/);
      assert.ok(sentences[1].includes(rounded(shares.sign_p)), sentences[1]);
      assert.ok(
        sentences[1].startsWith(shares.larger > shares.smaller ? a.name : shares.larger < shares.smaller ? b.name : ""),
        sentences[1],
      );
    }
    await page.click("#kinds [data-kind=box]");
    await fill(page, "#view-measure", "length");
    await page.waitForSelector("body[data-chart=box][data-settled=true]");
    const [a, , b] = settings;
    const lengths = paired(a.lengths, b.lengths, a.name, b.name, "");
    const [, pair] = await words();
    assert.ok(
      pair.startsWith(
        `The path length of ${a.name} is smaller than that of ${b.name} in ${lengths.smaller} of ${lengths.n} pairs that both solved, larger in ${lengths.larger}`,
      ),
      pair,
    );
    assert.ok(pair.includes(`Wilcoxon\u2019s signed-rank test, ${rounded(lengths.wilcoxon_p)}`), pair);

    // Lengths over the worlds and seeds that every setting solved, if it solves at least half.
    const kept = settings.filter(({ solved }) => Number(share(solved).share) >= 0.5);
    assert.ok(kept.length > 1, "two settings solve half");
    const common = Array.from(kept[0].solved.keys()).filter((i) => kept.every(({ solved }) => solved[i] === 1));
    await page.locator("label[for=view-common]").click();
    await page.waitForSelector("body[data-settled=true]");
    assert.ok((await page.innerText("#remark")).includes(`Only the ${common.length} worlds and seeds that all`));
    const box = await tableOf(page, "box");
    assert.equal(
      box.reduce((sum, { trials }) => sum + Number(trials), 0),
      kept.length * common.length,
    );
    assert.equal(
      box.reduce((sum, { missing }) => sum + Number(missing), 0),
      0,
    );
    await page.locator("label[for=view-common]").click();

    // Title and caption are in the exported chart, and no trial is run again for them.
    await fill(page, "#title", "Trials & errors");
    await page.fill("#own-caption", "A caption by the reader.");
    await page.waitForSelector("body[data-phase=done][data-done='48'][data-settled=true]");
    assert.match(await page.innerText("#remark"), /^A caption by the reader\. Boxes: quartiles /);
    await tableOf(page, "line");

    const png = await taken(page, "png");
    assert.deepEqual([...png.bytes.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
    const svg = await taken(page, "svg");
    assert.match(svg.text, /^<svg[^>]*xmlns="http:\/\/www.w3.org\/2000\/svg"/);
    for (const part of ["path length", "Trials &amp; errors", "A caption by the reader.", "n = "])
      assert.ok(svg.text.includes(part), part);
    assert.equal(svg.name.startsWith("trials-errors"), true, svg.name);
    assert.doesNotMatch(svg.text, /var\(--/);
    const shown = await tableOf(page, "line");
    const lines = (await taken(page, "table")).text.trimEnd().split("\r\n");
    assert.equal(lines.length, shown.length + 1);
    assert.ok(lines[0].startsWith("planner.k,series,trials,missing"));
    assert.ok(
      lines.every((one, i) => one.endsWith(i === 0 ? ",measure,unit" : ",path length,rad")),
      lines[1],
    );
    assert.match(svg.name, /-line-length\.svg$/);
  }));

test("paused, gone on with and cancelled, it ends with the same rows", () =>
  onPage(
    { reducedMotion: "reduce" },
    async (page) => {
      await page.waitForSelector("body[data-phase=ready][data-settled=true]");
      const document = JSON.parse((await taken(page, "document")).text);
      /** Presses a button as soon as more trials have ended. @param {string} id @param {number} more  than these */
      const press = (id, more) =>
        page.evaluate(
          ([name, least]) =>
            new Promise((resolve) => {
              const watch = new MutationObserver(() => {
                if (Number(document.body.dataset.done) <= Number(least)) return;
                watch.disconnect();
                document.getElementById(String(name))?.click();
                resolve(undefined);
              });
              watch.observe(document.body, { attributes: true });
            }),
          [id, more],
        );
      const ended = async () => Number(await page.getAttribute("body", "data-done"));
      let pressed = press("cancel", 0);
      assert.match(
        await page.innerText("#chart"),
        /^With reduced motion trials do not start by themselves\.\s+Run 1,?200 trials$/,
      );
      await page.click("#chart button");
      await pressed;
      await page.waitForSelector("body[data-phase=ready][data-done='0'][data-settled=true]");
      await page.waitForSelector("#chart button");
      pressed = press("run", 0);
      await page.click("#run");
      await pressed;
      await page.waitForSelector("body[data-phase=paused][data-settled=true]");
      const before = await ended();
      assert.ok(before > 0 && before < 1200, `${before}`);
      assert.equal(await page.innerText("#run"), "Go on");
      assert.equal(
        Number(await page.getAttribute("body", "data-drawn")),
        before,
        "the chart shows those that have ended",
      );
      const part = `${before} of 1200`;
      assert.ok((await page.innerText("#remark")).replaceAll(",", "").endsWith(`${part} trials.`), "and says so");
      assert.ok((await taken(page, "rows")).name.includes(`-${part.replaceAll(" ", "-")}-trials.`));
      pressed = press("run", before);
      await page.click("#run");
      await pressed;
      await page.waitForSelector("body[data-phase=paused][data-settled=true]");
      assert.ok((await ended()) > before);
      await page.focus("#stage");
      await page.keyboard.press(" ");
      await done(page);
      assert.equal((await taken(page, "rows")).text, rowsOf(document).csv);
    },
    { path: "experiments.html" },
  ));

test("a link holds the whole experiment and its chart", async () => {
  /** @type {View} */
  const view = {
    chart: "box",
    measure: "clearance_evaluations",
    axis: "world",
    isLog: true,
    reported: [{ x: "made", value: 100, label: "a report" }],
  };
  await onExperiment({ document: small, view }, async (page) => {
    await done(page);
    await page.locator("details", { hasText: "Parameters" }).last().locator("summary").click();
    await fill(page, "#planner-1-max_iterations", "70");
    await page.waitForSelector("body[data-phase=ready][data-settled=true]");
    assert.equal(await page.getAttribute("body", "data-done"), "0", "a changed experiment begins without rows");
    await fill(page, "#seeds", "4 to 6");
    await page.waitForSelector("body[data-phase=ready][data-count='18']");
    const fragment = await linkOf(page);
    assert.ok(fragment.length < 800, `${fragment.length}`);
    const { state } = await decodeExperiment(fragment);
    assert.deepEqual(state, {
      document: {
        ...small,
        planners: [small.planners[0], { algorithm: "rrt-connect", set: { max_iterations: 70 } }],
        seeds: { from: 4, count: 3 },
      },
      view,
    });
    const file = (await taken(page, "document")).text;
    await onPage(
      {},
      async (other) => {
        await done(other);
        assert.equal(await linkOf(other), fragment);
        assert.equal((await taken(other, "document")).text, file);
        assert.deepEqual(
          [
            await other.getAttribute("body", "data-chart"),
            await other.inputValue("#view-measure"),
            await other.inputValue("#view-axis"),
          ],
          ["box", "clearance_evaluations", "world"],
        );
        assert.equal(await other.locator("#view-log").isChecked(), true);
        assert.ok(
          (await tableOf(other, "box")).some(
            ({ series, median }) => series === "reported: a report" && median === "100",
          ),
        );
      },
      { path: `experiments.html${fragment}` },
    );
  });
});

test("a view of what is not there shows something else", () =>
  onExperiment(
    { document: small, view: { chart: "heat", measure: "nothing", work: "solved", axis: "planner.q" } },
    async (page) => {
      await done(page);
      assert.deepEqual(
        [
          await page.getAttribute("body", "data-chart"),
          await page.inputValue("#view-measure"),
          await page.inputValue("#view-axis"),
        ],
        ["heat", "solved", "planner.k"],
      );
      assert.equal(await page.isHidden("#notice"), true);
    },
  ));

test("what is put across is not up any more: another factor is", () => {
  const factors = ["planner.k", "world", "planner"].map((column) => ({
    column,
    title: column,
    unit: "",
    values: [1, 2],
    isNumeric: column === "planner.k",
  }));
  const shown = (/** @type {string} */ axis, /** @type {string} */ second, all = factors) => {
    const { kind, axis: across, second: up } = completed({ chart: "heat", axis, second }, all, [], ["solved"]);
    return [kind.id, across?.column, up?.column];
  };
  assert.deepEqual(shown("world", "planner"), ["heat", "world", "planner"]);
  assert.deepEqual(shown("world", "world"), ["heat", "world", "planner.k"]);
  assert.deepEqual(shown("planner.k", "planner.k"), ["heat", "planner.k", "world"]);
  assert.deepEqual(shown("world", "world", [factors[1]]), ["success", "world", undefined]);
});

test("a student compares RRT in three environments, from the page that opens", () =>
  onPage(
    { reducedMotion: "reduce" },
    async (page) => {
      const ready = () => page.waitForSelector("body[data-phase=ready][data-settled=true]");
      await ready();
      for (const scene of ["trap", "maze", "passage"]) {
        await page.selectOption("#new-world", `scene:${scene}`);
        await page.click("#add-world");
        await ready();
      }
      await page.click("#world-0-remove");
      await page.selectOption("#new-planner", "rrt");
      await page.click("#add-planner");
      await page.waitForSelector("#planner-1-remove");
      await page.click("#planner-0-remove");
      await page.waitForSelector("body[data-phase=ready][data-count='300'][data-settled=true]");
      assert.equal(await page.inputValue("#seeds"), "0 to 99");
      assert.equal(await page.inputValue("#title"), "RRT in 3 worlds");
      await page.click("#run");
      await done(page);
      const words = (await page.locator("#words li").allInnerTexts()).join(" ");
      assert.match(words, /^All have the same share of trials solved|^The share of trials solved is largest for A /);
      assert.match(words, /All 3 worlds have a path\.$/);
      assert.deepEqual(
        (await tableOf(page, "box")).map(({ world, trials }) => [world, trials]),
        [
          ["trap", "100"],
          ["maze", "100"],
          ["passage", "100"],
        ],
      );
      assert.match(
        (await taken(page, "svg")).text,
        /RRT in 3 worlds.*A bug trap.*n =[^<]*(?:<\/text><text[^>]*>)?100 each\./s,
      );
    },
    { path: "experiments.html" },
  ));

test("every ready experiment is accepted, with its worlds", () =>
  onPage(
    { reducedMotion: "reduce" },
    async (page) => {
      await page.waitForSelector("body[data-phase=ready][data-settled=true]");
      const ids = await page
        .locator("#ready option:enabled")
        .evaluateAll((all) => all.map((option) => /** @type {HTMLOptionElement} */ (option).value));
      const names = readdirSync(join(root, "www", "experiments", "documents")).map((name) => name.replace(".json", ""));
      assert.deepEqual(ids.toSorted(), names.toSorted());
      for (const id of ids) {
        const { title } = JSON.parse(readFileSync(join(root, "www", "experiments", "documents", `${id}.json`), "utf8"));
        await page.selectOption("#ready", id);
        await page.waitForFunction((text) => document.getElementById("story")?.textContent?.startsWith(text), title);
        await page.waitForSelector("body[data-phase=ready][data-settled=true], body[data-phase=refused]");
        assert.equal(await page.innerText("#notice"), "", id);
        assert.equal(await page.inputValue("#ready"), id);
      }
      await fill(page, "#seeds", "0 to 2");
      assert.equal(await page.inputValue("#ready"), "", "once it is edited it is one of your own");
    },
    { path: "experiments.html" },
  ));

test("what is refused shows code and pointer before any trial, and the page goes on", () =>
  onPage(
    { reducedMotion: "reduce" },
    async (page) => {
      await page.waitForSelector("body[data-phase=ready]");
      for (const [change, code, pointer] of /** @type {const} */ ([
        [{ planners: [{ algorithm: "prm", vary: { k: [3, 0] } }] }, "out-of-range", "/planners/0/vary/k/1"],
        [{ planners: [{ algorithm: "sst" }] }, "unsupported", "/planners/0/algorithm"],
        [{ worlds: [{ scene: "nowhere" }] }, "unknown-scene", "/worlds/0/scene"],
        [{ worlds: 3 }, "wrong-type", "/worlds"],
      ])) {
        await pickFile(page, "bad.json", JSON.stringify({ ...small, ...change }));
        await page.waitForSelector(`body[data-phase=refused][data-settled=true] #notice[data-code=${code}]`);
        assert.equal(await page.getAttribute("#notice", "data-pointer"), pointer);
        assert.equal(await page.isDisabled("#run"), true);
        assert.equal(await page.innerText("#trials caption"), "No trials");
      }
      // A scenario is a world for the experiment that is open; here it has no planner.
      await pickFile(page, "good.json", JSON.stringify(small));
      await page.waitForSelector("body[data-phase=ready][data-count='48'][data-settled=true]");
      assert.equal(await page.isHidden("#notice"), true);
      await pickFile(page, "own.json", readFileSync(join(root, "www", "scenes", "pillar.json"), "utf8"));
      // One world has 100 seeds.
      await page.waitForSelector("body[data-phase=ready][data-count='300'][data-settled=true]");
      await page.fill("#vary-0-values", "2 to 6 by 2");
      await page.press("#vary-0-values", "Enter");
      await page.waitForSelector("body[data-phase=ready][data-count='400']");
      assert.equal(
        await page.evaluate(() => document.activeElement?.id),
        "vary-0-values",
        "the form is made again, and the focus stays",
      );
      await fill(page, "#vary-0-values", "0");
      await page.waitForSelector("body[data-phase=refused] #notice[data-pointer='/planners/0/vary/k/0']");
    },
    { path: "experiments.html" },
  ));

test("an edited ready experiment is one of the reader's own; by a link it keeps its name", () =>
  onPage(
    { reducedMotion: "reduce" },
    async (page) => {
      const ready = () => page.waitForSelector("body[data-phase=ready][data-settled=true]");
      await ready();
      const id = await page.inputValue("#ready");
      const link = await linkOf(page);
      await onPage(
        { reducedMotion: "reduce" },
        async (other) => {
          await other.waitForSelector("body[data-phase=ready][data-settled=true]");
          assert.equal(await other.inputValue("#ready"), id);
        },
        { path: `experiments.html${link}` },
      );
      await page.selectOption("#new-planner", "rrt-star");
      await page.click("#add-planner");
      await page.waitForSelector("#planner-1-remove");
      await ready();
      assert.deepEqual(
        [await page.inputValue("#ready"), /^[^:]*/.exec(await page.innerText("#story"))?.[0]],
        ["", "PRM against RRT*"],
      );
      assert.equal((await decodeExperiment(await linkOf(page))).state?.document.title, "PRM against RRT*");

      // Text that is no list of seeds says why, and nothing runs.
      for (const text of ["abc", "5 to 1"]) {
        await page.fill("#seeds", text);
        assert.match(await page.innerText("#seeds-reason"), /^\W*Enter whole numbers/);
        assert.equal(await page.isDisabled("#run"), true, text);
      }
      await fill(page, "#seeds", "3");
      await ready();
      assert.deepEqual([await page.isHidden("#seeds-reason"), await page.isDisabled("#run")], [true, false]);

      // Only planners for the robots of all worlds can be added.
      assert.deepEqual(
        await page
          .locator("#new-planner option:disabled")
          .evaluateAll((all) => all.map((option) => /** @type {HTMLOptionElement} */ (option).value)),
        ["rrt-control", "sst"],
      );
      // Two things vary: the planner, and k of one; without them there is no heat map.
      assert.equal(await page.isDisabled("#kinds [data-kind=heat]"), false);
      await page.click("#planner-0-remove");
      await ready();
      assert.equal(await page.isDisabled("#kinds [data-kind=heat]"), true);
      assert.match((await page.getAttribute("#kinds [data-kind=heat]", "title")) ?? "", /needs two/);
      await pickFile(
        page,
        "car.json",
        JSON.stringify({
          ...small,
          worlds: [{ generate: "clutter", set: { robot: "car" } }],
          planners: [{ algorithm: "sst" }],
        }),
      );
      await page.waitForSelector("#new-planner option[value=sst]:enabled", { state: "attached" });
      await page.selectOption("#new-world", "scene:stones");
      await page.setViewportSize({ width: 390, height: 700 });
      await page.click("#add-world");
      await page.waitForSelector("body[data-phase=refused] #notice[data-code=unsupported]");
      const box = await page.locator("#notice").boundingBox();
      assert.match(
        await page.innerText("#notice"),
        /^The experiment is refused\. SST plans for robots of type car, not arm/,
      );
      assert.ok(box && box.y > -1 && box.y + box.height < 701, `the refusal is in view: ${JSON.stringify(box)}`);
    },
    { path: "experiments.html" },
  ));

test("settings without a path are no baseline; four sentences are enough for any number of settings", () => {
  const rows = new Rows(["planner", "seed", "status", "length"], 12);
  // Two settings without paths, and two with them.
  for (let trial = 0; trial < 12; trial++)
    rows.set(
      trial,
      ["abcd"[Math.floor(trial / 3)], trial % 3, trial < 6 ? "failed" : "solved", trial < 6 ? null : trial],
      [0, 0],
    );
  const factor = { column: "planner", title: "planner", unit: "", values: [..."abcd"], isNumeric: false };
  const lengths = comparisons(rows, [factor], "length");
  assert.deepEqual([lengths.baseline, lengths.other], ["c", "d"]);
  assert.match(lengths.sentences[0], /smallest for c, 7 \(n = 3\), and largest for d, 10 \(n = 3\)/);
  assert.match(lengths.sentences[1], /^The path length of d is smaller than that of c in 0 of 3 pairs/);
  assert.equal(comparisons(rows, [factor], "length", { baseline: "d" }).baseline, "d");
  assert.equal(
    comparisons(rows, [factor], "length", { other: "a" }).sentences[1],
    "No pair has a value of both a and c.",
  );
  const solved = comparisons(rows, [factor], "solved", { baseline: "b", other: "d" }).sentences;
  assert.match(solved[1], /^d finds a path more often than b, alone in 3 of 3 pairs, and b alone in 0/);
  assert.match(solved[2], /^None of the 3 other settings differs significantly from b\.$/);
  const { which, pairs, left } = commonTrials(rows, [factor]);
  assert.deepEqual([[...which], pairs, left], [[0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1], 3, ["a", "b"]]);
});

test("every chart has a button, fits a measure and says what its marks mean", () => {
  assert.equal(new Set(CHARTS.map(({ id }) => id)).size, CHARTS.length);
  const rows = new Rows(["planner", "planner.k", "seed", "status", "length", "iterations", "clearance_evaluations"], 8);
  for (let trial = 0; trial < 8; trial++)
    rows.set(
      trial,
      ["ab"[trial % 2], trial >> 2, (trial >> 1) % 2, trial === 5 ? "failed" : "solved", trial, 1, 2],
      [0, 0],
    );
  const of = (/** @type {string} */ column, /** @type {any[]} */ values, /** @type {boolean} */ isNumeric) => ({
    column,
    title: column,
    unit: "",
    values,
    isNumeric,
  });
  const factors = [of("planner", ["a", "b"], false), of("planner.k", [0, 1], true)];
  for (const { id, fits, title } of CHARTS) {
    assert.ok(["solved", "length"].some(fits) && title, id);
    const chart = chartOf(rows, factors, { chart: id }, ["length"], "m", { most: 75 });
    assert.deepEqual([chart.kind.id, chart.rows().length > 0, chart.counted.length > 0], [id, true, true]);
    assert.match(remarkOf(chart), /^[A-Z].* n = \d+ (?:each|to \d+)\./, id);
    assert.equal(chart.ceiling, ["success", "line", "ecdf"].includes(id) ? 75 : null, id);
    const captionWhile = (/** @type {number} */ uncertified) =>
      captionOf(chart, { document: small, view: {}, ceiling: null, rows, uncertified });
    const subject = "PRM, RRT-Connect; Two links among stones, made; 8 trials.";
    assert.equal(captionWhile(0), `${subject} ${remarkOf(chart)}`, id);
    const isOfPaths = chart.measure === "solved" || chart.kind.isOfAll === true;
    assert.equal(captionWhile(2).endsWith("still being examined."), isOfPaths, id);
    // Worlds across or in series have ceilings of their own.
    const worlds = [...factors, of("world", ["u", "v"], false)];
    assert.equal(chartOf(rows, worlds, { chart: id }, ["length"], "m", { most: 75 }).ceiling, null, id);
  }
});

test("one more chart is one object in the table", () => {
  const rows = new Rows(["planner", "seed", "status", "length"], 4);
  for (let trial = 0; trial < 4; trial++) rows.set(trial, ["ab"[trial % 2], trial >> 1, "solved", 1 + trial], [0, 0]);
  const factor = { column: "planner", title: "planner", unit: "", values: ["a", "b"], isNumeric: false };
  /** @type {import("../../www/experiments/charts.js").Chart} */
  const range = {
    id: "range",
    title: "Range",
    fits: (measure) => measure === "length",
    controls: ["measure", "axis"],
    swatch: "none",
    data: (query) => bySettings(query),
    marks: (plot, { summaries }) => ({
      marks: [plot.ruleX(summaries, { x: "x", y1: "low", y2: "high" })],
      options: {},
    }),
    remark: () => "Lines: from the shortest to the longest path.",
  };
  CHARTS.push(range);
  try {
    const chart = chartOf(rows, [factor], { chart: "range" }, ["length"], "m", null);
    assert.deepEqual([chart.kind, chart.measure, chart.summaries.length], [range, "length", 2]);
    assert.match(remarkOf(chart), /^Lines: from the shortest .* n = 2 each\./);
  } finally {
    CHARTS.pop();
  }
});

test("the ceiling counts worlds with a proven path, certified ones and unknown ones", () => {
  const document = /** @type {ExperimentDocument} */ ({
    format: "planarium-experiment-1",
    worlds: [{ generate: "discs", seeds: { from: 0, count: 4 } }],
    planners: [{ algorithm: "prm" }, { algorithm: "prm", name: "leaps", set: { edge_check: "none" } }],
    seeds: [0],
  });
  const rows = new Rows(["world", "world_seed", "query", "planner", "seed", "status", "length"], 8);
  // World 0 is solved with proof, world 1 without; the others are not.
  for (let trial = 0; trial < 8; trial++) {
    const planner = ["prm", "leaps"][trial % 2];
    const isSolved = trial === 0 || trial === 3;
    rows.set(
      trial,
      ["discs", trial >> 1, "q", planner, 0, isSolved ? "solved" : "failed", isSolved ? 1 : null],
      [0, 0],
    );
  }
  const tasks = tasksOf(rows, document);
  assert.deepEqual(
    tasks.map(({ hasPath }) => hasPath),
    [true, false, false, false],
  );
  const { most, words } = ceilingOf(
    tasks,
    new Map([
      [tasks[1].key, "infeasible"],
      [tasks[2].key, "connected"],
    ]),
  );
  assert.equal(most, 75);
  assert.equal(
    words,
    "Of 4 worlds 2 have a path, 1 is proven to have none and 1 may have one or not: no planner can solve more than 75 % of these trials.",
  );
  assert.match(ceilingOf(tasks, new Map([[tasks[1].key, "unsupported"]])).words, /certificates are for discs and arms/);
});

test("worlds without a path are counted: the page examines them when all trials have ended", () =>
  onExperiment(
    {
      document: {
        format: "planarium-experiment-1",
        worlds: [{ generate: "forest", set: { links: 2 }, seeds: [3, 17, 1] }],
        planners: [{ algorithm: "rrt-connect", set: { max_iterations: 3000 } }],
        seeds: { from: 0, count: 3 },
      },
    },
    async (page) => {
      await done(page);
      const known = "Of 3 worlds 1 has a path and 2 are proven to have none";
      assert.ok((await page.innerText("#remark")).includes(known));
      assert.match((await page.locator("#words li").allInnerTexts()).join(" "), new RegExp(known));
      assert.match(await page.innerText("#story"), /3 of 9 trials found a path\. At most 33\.3 % can be solved\.$/);
    },
  ));

/** What the planner's page hands over for "Over 100 seeds". @type {Parameters<typeof encodeExperiment>[0]} */
const handed = {
  document: {
    format: "planarium-experiment-1",
    title: "PRM against RRT-Connect",
    worlds: [{ scene: "stones" }],
    planners: [
      { algorithm: "prm", set: { samples: 60, k: 4 } },
      { algorithm: "rrt-connect", set: { max_iterations: 500 } },
    ],
    seeds: { from: 0, count: 100 },
  },
  view: { chart: "success", measure: "solved" },
  run: true,
};

test("a short link runs by itself if it asks to, and others wait; it can be stopped", async () => {
  const fragment = await encodeExperiment(handed);
  assert.deepEqual((await decodeExperiment(fragment)).state, handed);
  const path = (/** @type {string} */ of) => ({ path: `experiments.html#${of}` });
  // It was asked for: reduced motion does not keep it from running.
  await onPage(
    { reducedMotion: "reduce" },
    async (page) => {
      await done(page);
      assert.equal(await page.getAttribute("body", "data-done"), "200");
      // In one task, since it takes less than a second.
      const phases = await page.evaluate(() =>
        ["run", "cancel"].map((id) => {
          document.getElementById(id)?.click();
          return document.body.dataset.phase;
        }),
      );
      assert.deepEqual(phases, ["running", "ready"]);
      await page.waitForSelector("body[data-phase=ready][data-done='0'][data-settled=true]");
    },
    path(fragment),
  );
  const waits = async (/** @type {typeof handed} */ more, /** @type {RegExp} */ why) =>
    onPage(
      {},
      async (page) => {
        await page.waitForSelector("body[data-phase=ready][data-done='0'][data-settled=true] #chart button");
        assert.match(await page.innerText("#chart"), why);
      },
      path(await encodeExperiment(more)),
    );
  await waits({ ...handed, run: false }, /^No trial has run\./);
  const long = { ...handed.document, seeds: { from: 0, count: 201 } };
  await waits({ ...handed, document: long }, /^More than 400 trials of a link do not start by themselves\./);
});

test("a print has the chart, its table and the sentences, and no controls", () =>
  onExperiment({ document: small }, async (page) => {
    await done(page);
    await page.emulateMedia({ media: "print", colorScheme: "dark" });
    await page.waitForSelector("#table tbody tr");
    for (const shown of ["#story", ".plot", "#remark", "#table table", "#words li"])
      assert.ok(await page.locator(shown).first().isVisible(), shown);
    for (const hidden of ["#run", "#kinds", "#view", "#pair", "#trials", "#form", "#ready", ".masthead"])
      assert.equal(await page.locator(hidden).first().isVisible(), false, hidden);
    await page.waitForSelector("body[data-settled=true]");
    const ink = await page.locator(".plot").evaluate((plot) => getComputedStyle(plot).color);
    await page.emulateMedia({ media: "screen" });
    await page.waitForSelector("#table-fold:not([open])", { state: "attached" });
    await page.waitForSelector("body[data-settled=true]");
    assert.notEqual(await page.locator(".plot").evaluate((plot) => getComputedStyle(plot).color), ink);
  }));

test("a trial opens on the planner's page with its settings and ends with its fingerprint", () =>
  onExperiment({ document: small, view: { chart: "box" } }, async (page) => {
    await done(page);
    const { rows } = rowsOf((await taken(page, "document")).text);
    const check = async (/** @type {number} */ trial, /** @type {() => Promise<unknown>} */ open) => {
      const [other] = await Promise.all([page.context().waitForEvent("page"), open()]);
      await other.waitForSelector("#counters[data-settled=true]", { state: "attached" });
      const { fingerprint, status, iterations } = await counters(other);
      const row = rows[trial];
      assert.deepEqual(
        [fingerprint, status, iterations],
        [row.fingerprint, row.status, row.iterations],
        `trial ${trial}`,
      );
      assert.equal(await other.inputValue("#parameter-seed"), String(row.seed));
      await other.close();
    };
    const dot = page.locator(".plot .trial").nth(5);
    await check(Number(await dot.getAttribute("data-trial")), () => dot.dispatchEvent("click"));
    for (const trial of [19, 2]) await check(trial, () => page.click(`#trials tr[data-trial="${trial}"] a[href]`));
    await page.click("#trials-on");
    await page.waitForSelector("#trials tr[data-trial='30']");
    await check(30, () => page.click("#trials tr[data-trial='30'] a[href]"));
  }));

test("axe finds nothing, all fits", () =>
  onExperiment({ document: small }, async (page) => {
    await done(page);
    for (const fold of ["table", "export"])
      await page.locator(`#${fold}-fold`).evaluate((one) => {
        /** @type {HTMLDetailsElement} */ (one).open = true;
      });
    for (const kind of ["success", "line"]) {
      await page.click(`#kinds [data-kind=${kind}]`);
      await assertFaultless(page, kind);
    }
    for (const width of [320, 390, 704, 1024, 2560]) {
      await page.setViewportSize({ width, height: 900 });
      await frames(page);
      await page.waitForSelector("body[data-settled=true]");
      assert.equal(await overhang(page), 0, `${width} px`);
    }
    await assertTargets(page);
    await page.emulateMedia({ forcedColors: "active" });
    assert.deepEqual(await violations(page), []);
  }));
