/** The page of experiments: its rows equal the core's, however they are run; charts and files hold what it shows. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Experiment, ecdf, paired, quartiles, share } from "planarium/full";
import { encodeExperiment } from "../../www/experiments/link.js";
import { addressOf, counters, fill, frames, onPage, root, useBrowser, violations } from "./browser.mjs";
import { assertFaultless, assertFills, assertTargets, overhang } from "./looks.mjs";
import { SMALL } from "./pages.mjs";
import { inTurn } from "./turns.mjs";
import { small, onExperiment, done, taken, tableOf } from "./experiments.mjs";

/** @import { ExperimentDocument, TrialRow } from "planarium/full" */
/** @import { Page } from "./browser.mjs" */

useBrowser();

/** @type {{ experiment: ExperimentDocument, outcome: { rows: string[] } }[]} */
const golden = JSON.parse(readFileSync(join(root, "tests", "golden-experiment.json"), "utf8"));

/** The names of its planners and worlds. @type {Record<string, string>} */
const titles = { prm: "PRM", "rrt-connect": "RRT-Connect", stones: "Two links among stones", made: "made" };

/** Runs many trials, one worker or three. @param {number} workers */
const processors = (workers) => (/** @type {Page} */ page) =>
  void page.addInitScript(
    (count) => Object.defineProperty(navigator, "hardwareConcurrency", { value: count }),
    workers + 1,
  );

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

test("an experiment that was run", (t) =>
  onExperiment(
    { document: small },
    inTurn(
      t,
      {
        "charts have the values of the rows; pictures and files hold them": async (page) => {
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
              ...[one.share, one.low, one.high].map((value) => Number((100 * Number(value)).toPrecision(12))),
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

          // In words, two settings at a time, trial by trial: a yes or no by McNemar's test, a number by Wilcoxon's.
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
              motions: Float64Array.from(own, ({ status, motion_checks: all }) =>
                status === "solved" ? Number(all) : NaN,
              ),
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
            assert.ok(sentences.length <= 5, sentences.join("\n"));
            assert.match(sentences[1], /McNemar\u2019s exact test/);
            assert.ok(sentences[1].includes(rounded(shares.sign_p)), sentences[1]);
            assert.ok(
              sentences[1].startsWith(
                shares.larger > shares.smaller ? a.name : shares.larger < shares.smaller ? b.name : "",
              ),
              sentences[1],
            );
          }
          await page.click("#kinds [data-kind=box]");
          await fill(page, "#view-measure", "motion_checks");
          await page.waitForSelector("body[data-chart=box][data-settled=true]");
          const [a, , b] = settings;
          const motions = paired(a.motions, b.motions, a.name, b.name, "");
          const [, pair] = await words();
          assert.ok(
            pair.startsWith(
              `The number of motions tested of ${a.name} is smaller than that of ${b.name} in ${motions.smaller} of ${motions.n} pairs that both solved, larger in ${motions.larger}`,
            ),
            pair,
          );
          assert.ok(pair.includes(`Wilcoxon\u2019s signed-rank test, ${rounded(motions.wilcoxon_p)}`), pair);
          // Lengths of an arm and of a disc have different units.
          await fill(page, "#view-measure", "length");
          await page.waitForSelector("body[data-chart=box][data-settled=true]");
          assert.equal((await words()).length, 3, "units, each world, the ceiling");
          assert.equal(await page.isHidden("#pair"), true);

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
          assert.match(
            await page.innerText("#remark"),
            /^A caption by the reader\. .*; 48 trials .* Boxes: quartiles /,
          );
          await tableOf(page, "line");
          // Another measure has its caption.
          await page.selectOption("#view-measure", "solved");
          assert.equal(await page.inputValue("#own-caption"), "");
          await page.selectOption("#view-measure", "length");
          assert.equal(await page.inputValue("#own-caption"), "A caption by the reader.");

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
            lines.every((one, i) => one.endsWith(i === 0 ? ",measure,unit" : ',"path length",')),
            lines[1],
          );
          assert.match(svg.name, /-line-length\.svg$/);
        },

        "a print has the chart, its table and the sentences, and no controls": async (page) => {
          await done(page);
          // A browser counts the pages before it changes the media.
          for (const [event, isOpen] of /** @type {const} */ ([
            ["beforeprint", true],
            ["afterprint", false],
          ])) {
            await page.evaluate((name) => void dispatchEvent(new Event(name)), event);
            for (const fold of ["#table-fold", "#words-fold"])
              assert.equal(
                await page.locator(fold).evaluate((one) => /** @type {HTMLDetailsElement} */ (one).open),
                isOpen || fold === "#words-fold",
              );
            if (isOpen) assert.ok((await page.locator("#table tbody tr").count()) > 0);
          }
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
        },

        "a trial opens on the planner's page with its settings and ends with its fingerprint": async (page) => {
          await done(page);
          await tableOf(page, "box");
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
          for (const trial of [19, 2])
            await check(trial, () => page.click(`#trials tr[data-trial="${trial}"] a[href]`));
          await page.click("#trials-on");
          await page.waitForSelector("#trials tr[data-trial='30']");
          await check(30, () => page.click("#trials tr[data-trial='30'] a[href]"));
        },

        "axe finds nothing, all fits": async (page) => {
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
        },
      },
      async () => {},
    ),
  ));

/** A short experiment that runs as it is opened. */
const CHART = `#${await encodeExperiment({ document: SMALL, run: true })}`;

/** Pairs of words of the chart of which one covers the other. */
function overlaps() {
  const words = Array.from(document.querySelectorAll("#stage .plot text"), (word) => ({
    text: word.textContent,
    box: word.getBoundingClientRect(),
  })).filter(({ text }) => text);
  return words.flatMap(({ text, box }, i) =>
    words
      .slice(i + 1)
      .filter(
        ({ box: other }) =>
          Math.min(box.right, other.right) - Math.max(box.left, other.left) > 1 &&
          Math.min(box.bottom, other.bottom) - Math.max(box.top, other.top) > 3,
      )
      .map((other) => `${text} and ${other.text}`),
  );
}

test("its chart fills small screens, projectors and frames", () =>
  onPage(
    { reducedMotion: "reduce", viewport: { width: 1024, height: 768 } },
    async (page, url) => {
      const fills = async (/** @type {string} */ name) => {
        await page.waitForSelector("#stage .plot");
        await assertFills(page, name);
        assert.deepEqual(await page.evaluate(overlaps), [], name);
      };
      await fills("desk");
      await page.click("#projector");
      await fills("projector");
      await page.setViewportSize({ width: 1280, height: 720 });
      await fills("wide projector");
      for (const [width, height] of [
        [960, 540],
        [640, 480],
      ]) {
        await page.setViewportSize({ width, height });
        await page.goto(addressOf(url, `experiments.html?embed=1${CHART}`));
        await fills(`frame of ${width}`);
        assert.equal(await page.isVisible(".masthead"), false);
      }
    },
    { path: `experiments.html${CHART}` },
  ));

test("paused, gone on with and discarded, it ends with the same rows", () =>
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
      let pressed = press("discard", 0);
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
