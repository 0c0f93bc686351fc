/** Curves of a race and of a run: they say what the package says, and follow a run that grows. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { changes, finish, onPage, onPausedPage, reveal, seek, setParameter, unfold, useBrowser } from "./browser.mjs";
import { open, sceneOf } from "./library.mjs";
import { inTurn, restage } from "./turns.mjs";
import { PAST } from "../../www/planner/run-log/columns.js";
import { alone, race, A } from "./race.mjs";

/** @typedef {import("playwright-core").Page} Page */

useBrowser();

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

test("curves of a race and of a run", (t) =>
  onPausedPage(
    inTurn(
      t,
      {
        "a single run has curves against iterations, in a fold that is idle while it is closed": async (page) => {
          await finish(page);
          assert.equal(await page.locator("svg.vertices path").count(), 0);
          await page.locator("#curves-fold > summary").click();
          await page.waitForFunction(() => document.querySelectorAll("svg.cost .future circle").length === 1);
          const { x, y } = await dot(page, "cost", "");
          assert.ok(
            Math.abs(x.value - 746) <= x.pixel && Math.abs(y.value - 8.934) <= y.pixel,
            `${x.value}, ${y.value}`,
          );
          assert.match((await page.locator("svg.cost").textContent()) ?? "", /iterations/);
        },

        "the path's curve begins where the path was found; the cursor is at the time that is shown": async (page) => {
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
                run.rows.findLast(
                  (one, k) => k === 0 || (one[PAST.clearanceEvaluations] <= Number(at) && Number(at) > 0),
                )
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
        },
      },
      restage,
    ),
  ));

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
