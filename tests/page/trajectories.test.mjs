/** The page of many trajectories, in Chromium: it grows, stands still, says why not, and gives away what it shows. */
import assert from "node:assert/strict";
import { test } from "node:test";
import * as planarium from "planarium/full";
import { download, fill, linkOf, onPage, pictureOf, pressUntil, useBrowser } from "./browser.mjs";
import { CALM, atRest, rest, told as toldBy } from "./stage.mjs";
import { EMPTY, inTurn, openState } from "./turns.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("./browser.mjs").Options} Options */

useBrowser();

/** What the stage says of itself. @param {Page} page */
async function told(page) {
  const { status, accepted, tried, drawn, last, fingerprint } = await toldBy(page);
  return { status, accepted: Number(accepted), tried: Number(tried), drawn: Number(drawn), last, fingerprint };
}

/**
 * The page, opened; with reduced motion it has run to its end.
 * @param {(page: Page, url: string) => Promise<void>} act
 * @param {Options} [options]
 * @param {string} [fragment]
 */
const onTracks = (act, options = CALM, fragment = "") => onPage(options, act, { path: `trajectories.html${fragment}` });

/** The page with all of its trajectories. @param {(page: Page, url: string) => Promise<void>} act */
const onSolved = (act) =>
  onTracks(async (page, url) => {
    await rest(page, "[data-status=solved]");
    await act(page, url);
  });

/** The experiment as it opens with reduced motion: at its end. @param {Page} page */
async function putBack(page) {
  await openState(page, EMPTY);
  await end(page);
}

/** The experiment restarted and waiting. @param {(page: Page) => Promise<void>} act */
const onEmpty = (act) => async (/** @type {Page} */ page) => {
  await page.click("#course-reset");
  await rest(page, "[data-tried='0']");
  await act(page);
};

/** Tries `count` more trajectories; then there are `sum`. @param {Page} page @param {number} count @param {number} sum */
async function step(page, count, sum) {
  await page.click(`#course-step-${count}`);
  await rest(page, `[data-tried='${sum}']`);
}

/** Goes to the end. @param {Page} page @param {string} [status]  there */
async function end(page, status = "solved") {
  await page.click("#course-finish");
  await rest(page, `[data-status=${status}]`);
}

/** How many pixels of the lower canvas are inked. @param {Page} page */
const inked = async (page) => Number((await pictureOf(page, "#plane canvas[data-layer=growth]"))[0].split(" ")[2]);

/**
 * What the package says of the same experiment.
 * @param {import("planarium/full").TrajectoryOptions} options
 * @param {number} [tried]
 */
function expected(options, tried = 1e6) {
  const trajectories = new planarium.Trajectories(options);
  trajectories.step(tried);
  const run = { ...trajectories.result(), rows: trajectories.acceptedSince(0), tries: [...trajectories.tries()] };
  trajectories.free();
  return run;
}

/**
 * Puts a value into the panel and waits for the experiment that begins with it.
 * @param {Page} page
 * @param {string} name
 * @param {string} value
 */
async function change(page, name, value) {
  const before = await page.getAttribute("#stage", "data-begun");
  await set(page, name, value);
  await page.waitForSelector(`#stage:not([data-begun="${before}"])`);
  await rest(page, "[data-tried='0']");
}

/** Puts a value into the panel. @param {Page} page @param {string} name @param {string} value */
async function set(page, name, value) {
  if (!(await page.isVisible(`#option-${name}`))) await page.locator("#settings summary").click();
  await fill(page, `#option-${name}`, value);
}

test("the experiment begins by itself and grows; with reduced motion it shows what has grown", async () => {
  await onTracks(async (page) => {
    await page.waitForSelector("#course-play[data-playing=true]");
    await page.waitForFunction(() => Number(document.getElementById("stage")?.dataset.drawn) > 20);
  }, {});
  await onTracks(async (page) => {
    await rest(page, "[data-status=solved]");
    const { accepted, refused, fingerprint } = expected({});
    assert.deepEqual(await told(page), {
      status: "solved",
      accepted,
      tried: accepted + refused,
      drawn: 1000,
      last: "accepted",
      fingerprint,
    });
    assert.match(await page.innerText("#story"), /1,000 trajectories, no two of which cross/);
  });
});

test("trajectories grow step by step", (t) =>
  onSolved(
    inTurn(
      t,
      {
        "by buttons and keys it steps, plays, goes to the end and restarts, always to the same": onEmpty(
          async (page) => {
            for (const [count, sum] of [
              [1, 1],
              [10, 11],
              [100, 111],
            ])
              await step(page, count, sum);
            const stepped = await told(page);
            assert.equal(stepped.fingerprint, expected({}, 111).fingerprint);
            assert.equal(stepped.drawn, stepped.accepted);
            await page.fill("#course-speed", "20");
            await page.click("#course-play");
            await page.waitForFunction(() => Number(document.getElementById("stage")?.dataset.tried) > 111);
            await page.click("#course-play");
            await rest(page, "[data-status=running]");
            await end(page);
            assert.equal((await told(page)).fingerprint, expected({}).fingerprint);
            await page.click("#course-reset");
            await rest(page, "[data-tried='0']");
            assert.deepEqual([(await told(page)).drawn, (await told(page)).last], [0, "none"]);
            await page.focus("#stage");
            await pressUntil(page, ".", atRest("[data-tried='1']"));
            await pressUntil(page, " ", "#course-play[data-playing=true]");
            await pressUntil(page, " ", "#course-play[data-playing=false]");
            await rest(page);
            await pressUntil(page, "r", atRest("[data-tried='0']"));
          },
        ),

        "what is accepted is added to the picture; what is refused is shown on top, with the one it crosses": onEmpty(
          async (page) => {
            let before = await inked(page);
            let isRefusedSeen = false;
            for (let tried = 1; tried <= 60 && !isRefusedSeen; tried++) {
              await step(page, 1, tried);
              const { last } = await told(page);
              const now = await inked(page);
              if (last === "refused") {
                assert.equal(now, before, "nothing is added below");
                assert.match(await page.innerText("#story"), /rejected: it crosses number \d+/);
                isRefusedSeen = true;
              } else assert.ok(now > before, `trajectory ${tried} is drawn`);
              before = now;
            }
            assert.ok(isRefusedSeen, "seed 0 refuses one early");
            // The picture that was added to is the one drawn at once.
            await page.click("#course-reset");
            await rest(page, "[data-tried='0']");
            for (let sum = 100; sum <= 300; sum += 100) await step(page, 100, sum);
            const added = await inked(page);
            // Changed colours redraw all of it.
            await page.click("#theme");
            await rest(page, "[data-tried='300']");
            await page.click("#theme");
            await rest(page, "[data-tried='300']");
            const once = await inked(page);
            assert.ok(Math.abs(added - once) <= 0.01 * once, `${added} pixels and ${once}`);
          },
        ),

        "each option is a field from the table; a change restarts, what is refused is said beside it, and where nothing more fits it gives up":
          async (page) => {
            for (const { name, meaning } of planarium.trajectoryOptions()) {
              assert.equal(await page.locator(`#option-${name}-meaning`).textContent(), meaning);
            }
            await change(page, "model", "spiral");
            await change(page, "count", "150");
            await change(page, "seed", "12");
            await end(page);
            assert.equal(
              (await told(page)).fingerprint,
              expected({ model: "spiral", count: 150, seed: 12 }).fingerprint,
            );
            await set(page, "slowest", "3");
            await rest(page, "[data-status=refused]");
            assert.match(await page.innerText("#option-slowest-reason"), /slowest must be at most fastest/);
            assert.ok((await page.isDisabled("#course-play")) && (await page.isDisabled("#course-finish")));
            await set(page, "slowest", "0.5");
            await rest(page, "[data-status=running][data-tried='0']");
            await set(page, "count", "0");
            assert.match(await page.innerText("#option-count-reason"), /0 is below 1/);
            await set(page, "count", "150");
            await change(page, "half_side", "0.2");
            await change(page, "max_iterations", "2000");
            await end(page, "exhausted");
            assert.match(await page.innerText("#story"), /Stopped after 2,000 tries/);
          },

        "the particles move where that is asked for, and rest again; a new seed plays another experiment": async (
          page,
        ) => {
          await page.click("#course-move");
          await page.waitForSelector("body[data-settled=false]");
          assert.equal(await page.getAttribute("#course-move", "aria-pressed"), "true");
          await page.click("#course-move");
          await rest(page);
          await page.click("#new-seed");
          await page.waitForSelector("#course-play[data-playing=true]");
          await end(page);
          const seed = Number(await page.inputValue("#option-seed"));
          assert.equal((await told(page)).fingerprint, expected({ seed }).fingerprint);
        },

        "arc and spiral part as the package says": async (page) => {
          await rest(page);
          for (const [name, value] of [
            ["v", "0.5"],
            ["w", "-1.5"],
            ["duration", "3"],
          ])
            await fill(page, `#one-${name}-number`, value);
          await rest(page);
          const [arc, spiral] = /** @type {const} */ (["arc", "spiral"]).map((model) =>
            planarium.particlePoints({ model, v: 0.5, w: -1.5 }, [3]),
          );
          const apart = Number(await page.getAttribute("#one", "data-apart"));
          assert.ok(Math.abs(apart - Math.hypot(arc[0] - spiral[0], arc[1] - spiral[1])) < 1e-9);
          assert.match(await page.innerText("#one-words"), /After 3\.00 s the arc ends at/);
          await fill(page, "#one-v-number", "-1");
          assert.notEqual(await page.innerText("#one-v-reason"), "");
        },

        "charts, picture, drawing and table hold what the seed decides": async (page) => {
          const { tries, rows } = expected({});
          const mean = (/** @type {number[]} */ values) =>
            values.reduce((sum, value) => sum + value, 0) / values.length;
          const label = (await page.getAttribute("svg.chart.tries", "aria-label")) ?? "";
          assert.ok(
            label.includes(
              `${mean(tries.slice(0, 20)).toFixed(1)} tries on average over the first 20, ${mean(tries.slice(-20)).toFixed(1)} over the last`,
            ),
            label,
          );
          assert.match(
            (await page.getAttribute("svg.chart.time", "aria-label")) ?? "",
            /1000 accepted, [\d.]+ microseconds on average over the first 20/,
          );
          for (const id of ["tries", "time"]) {
            await page.waitForSelector(`svg.chart.${id} .line.average path`);
            assert.equal(await page.locator(`svg.chart.${id} .line.average`).count(), 1);
          }
          await page.click("#export-fold > summary");
          const take = (/** @type {string} */ id) => download(page, `#export-${id}`);
          const png = await take("png");
          assert.equal(png.name, "trajectories-seed0-1000.png");
          assert.deepEqual([...png.bytes.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
          const { text: svg } = await take("svg");
          assert.match(svg, /^<svg|^<\?xml/);
          assert.ok(svg.length > 50_000 && svg.endsWith("</svg>"), String(svg.length));
          const csv = (await take("csv")).text.trimEnd().split("\r\n");
          assert.equal(csv[0], "x,y,theta,v,w,duration,tries,milliseconds,average");
          assert.equal(csv.length, 1001);
          csv
            .slice(1)
            .forEach((line, i) =>
              assert.deepEqual(
                line.split(",").slice(0, 7).map(Number),
                [...rows.subarray(6 * i, 6 * i + 6), tries[i]],
                `row ${i}`,
              ),
            );
        },
      },
      putBack,
    ),
  ));

test("a link holds the experiment, how far it has come, and the single particle", async () => {
  let fragment = "";
  let before = {};
  await onTracks(async (page) => {
    await rest(page, "[data-status=solved]");
    await change(page, "seed", "77");
    await step(page, 100, 100);
    await fill(page, "#one-w-number", "2.5");
    fragment = await linkOf(page);
    before = await told(page);
  });
  await onTracks(
    async (page) => {
      await rest(page, "[data-tried='100']");
      assert.deepEqual(await told(page), before);
      assert.equal(await page.inputValue("#option-seed"), "77");
      assert.equal(Number(await page.inputValue("#one-w-number")), 2.5);
    },
    {},
    fragment,
  );
});
