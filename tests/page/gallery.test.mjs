/**
 * The gallery of the course reports: all rows are there, every entry opens in its page and shows what it says, and the
 * page itself works.
 */
import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { targetFolder } from "../../scripts/setup.mjs";
import { decodeState } from "../../www/app/link.js";
import { decodeExperiment } from "../../www/experiments/link.js";
import { HOLDS } from "../../www/gallery/format.js";
import { REPORT_1 } from "../../www/gallery/report-1.js";
import { REPORT_2 } from "../../www/gallery/report-2.js";
import { REPORT_3 } from "../../www/gallery/report-3.js";
import { REPORT_4 } from "../../www/gallery/report-4.js";
import { REPORT_5 } from "../../www/gallery/report-5.js";
import { REPORTS, TEXTS } from "../../www/gallery/reports.js";
import { stateRule as neighboursRule } from "../../www/neighbours/state.js";
import { decodeLink } from "../../www/planner/link/codec.js";
import { stateRule as learnedRule } from "../../www/prm-rl/state.js";
import { stateRule as reachRule } from "../../www/reach/state.js";
import { stateRule as trajectoriesRule } from "../../www/trajectories/state.js";
import { documents } from "../../scripts/gallery.mjs";
import { displayed, isTold } from "./claims.mjs";
import { PHONE, coloursOf, onPage, pageRoot, textMatches, useBrowser, violations } from "./browser.mjs";

/** @import { Entry, Shows } from "../../www/gallery/format.js" */
/** @import { Page } from "./browser.mjs" */

useBrowser();

/** Rows of the reports, and how many of them each has. */
const COUNTS = [41, 23, 25, 59, 13];
const entries = REPORTS.flatMap((report) => report.entries);
const rows = REPORTS.flatMap((report) => report.rows);
/** The links that the build has made, by the ids of entries. @type {Record<string, string>} */
const addresses = JSON.parse(readFileSync(join(pageRoot, "gallery", "reports.json"), "utf8")).addresses;
const shots = join(targetFolder(), "gallery");

/** How each page says that a state is open and drawn. @type {Record<Entry["page"], string>} */
const READY = {
  planner: "body[data-state=ready][data-settled=true]:has(#counters[data-settled=true])",
  reach: "body[data-state=ready][data-settled=true]",
  neighbours: "body[data-state=ready][data-settled=true][data-found]",
  trajectories: "body[data-state=ready][data-settled=true]",
  "prm-rl": "body[data-state=ready][data-settled=true]",
  experiments: "body[data-state=ready][data-settled=true]",
};
/**
 * The layer that shows it, and its colours unless any will do, by what is expected.
 * @type {Record<string, [layer: string, ...colours: string[]]>}
 */
const SHOWS = {
  solved: ["top", "path", "unproven"],
  flawed: ["top", "unproven"],
  exhausted: ["edges"],
  running: ["ground", "start"],
  refused: ["ground", "start", "goal"],
  free: ["top", "robot"],
  "in collision": ["top", "collision"],
  found: ["top", "start", "rejected"],
  drawn: ["ground", "growth"],
  trajectories: ["growth", "growth"],
};

test("all 161 rows are there, each with a verdict, its place and its entries", () => {
  assert.deepEqual(
    REPORTS.map((report) => report.rows.length),
    COUNTS,
  );
  assert.deepEqual(
    rows.map(({ row }) => row),
    rows.map((_, i) => i + 1),
  );
  const ids = new Set(entries.map(({ id }) => id));
  for (const { row, shows, verdict, where, entries: own, holds, why } of rows) {
    assert.ok(shows && where + own.join(""), `row ${row} says what it is and where`);
    assert.ok(["yes", "partly", "no"].includes(verdict) && holds in HOLDS, `row ${row}`);
    assert.ok(holds === "yes" || why, `row ${row} says why it does not hold`);
    assert.ok(verdict !== "yes" || own.length > 0 || where, `row ${row}`);
    for (const id of own) assert.ok(ids.has(id), `row ${row}: ${id}`);
  }
});

test("every entry has its own id, is named by a row, and says in few words what to see", () => {
  const named = new Set(rows.flatMap((row) => row.entries));
  assert.equal(new Set(entries.map(({ id }) => id)).size, entries.length);
  for (const report of REPORTS) {
    for (const { id, title, see, try: tried = "", report: says = "", why = "", chosen = "", holds } of report.entries) {
      assert.match(id, new RegExp(`^${report.number}-[a-z0-9.-]+$`), id);
      assert.ok(named.has(id), `${id} is named by a row`);
      assert.ok(title.length <= 48, `${id}: ${title}`);
      assert.ok(holds === "yes" || why, `${id} says why it does not hold`);
      const texts = [see, tried, says, why, chosen];
      assert.ok(
        see && texts.every((text) => text === "" || /^[^a-z].*[.:?)]$/s.test(text)),
        `${id}: ${texts.find((text) => text && !/^[^a-z].*[.:?)]$/s.test(text))}`,
      );
      assert.ok(texts.join(" ").length <= 640, `${id}: ${texts.join(" ").length} characters`);
    }
  }
});

test("every number that an entry tells to see is shown by the page, or is one of its settings", () => {
  for (const entry of [REPORT_1, REPORT_2, REPORT_3, REPORT_4, REPORT_5].flatMap((report) => report.entries)) {
    const named = TEXTS.flatMap((field) => [...(entry[field] ?? "").matchAll(/\{(\w+)/g)].map(([, name]) => name));
    for (const name of Object.keys(entry.shows ?? {})) assert.ok(named.includes(name), `${entry.id} names its ${name}`);
    const settings = [
      entry.state,
      entry.world && documents.world(entry.world),
      entry.page === "experiments" && documents.experiment(entry.state.document),
    ];
    const known = numbersIn(JSON.stringify(settings));
    assert.deepEqual(
      numbersIn(entry.see.replace(/\{[^}]*\}|\d*\u03c0/g, "")).filter((number) => !known.includes(number)),
      [],
      `${entry.id}: neither shown nor set`,
    );
  }
});

/** The numbers in a text, without their signs. @param {string} text */
function numbersIn(text) {
  return (text.match(/\d+(?:\.\d+)?/g) ?? []).map(Number);
}

test("every link is one that its page reads", async () => {
  /** @type {Record<Entry["page"], (fragment: string) => Promise<{ fault: string | null }>>} */
  const read = {
    planner: decodeLink,
    experiments: decodeExperiment,
    reach: (fragment) => decodeState(fragment, reachRule),
    neighbours: (fragment) => decodeState(fragment, neighboursRule),
    trajectories: (fragment) => decodeState(fragment, trajectoriesRule),
    "prm-rl": (fragment) => decodeState(fragment, learnedRule),
  };
  for (const { id, page } of entries) {
    const [path, fragment] = addresses[id].split("#");
    assert.equal(path, page === "planner" ? "./" : `${page}.html`, id);
    assert.equal((await read[page](fragment)).fault || "", "", id);
  }
});

for (const name of /** @type {Entry["page"][]} */ (Object.keys(READY))) {
  const own = entries.filter(({ page }) => page === name);
  if (own.length === 0) continue;
  test(`the entries of ${name} open, and show what they say`, () =>
    onPage({ reducedMotion: "reduce", viewport: { width: 1024, height: 640 } }, async (page, url) => {
      mkdirSync(shots, { recursive: true });
      let isFirst = true;
      /** @type {string[]} */
      const wrong = [];
      for (const entry of own) {
        const [path, fragment] = addresses[entry.id].split("#");
        if (isFirst) await page.goto(`${url}${path.replace("./", "")}#${fragment}`);
        // The page's own listener comes first, so that the state is being opened when the promise resolves.
        else
          await page.evaluate(
            (hash) =>
              new Promise((resolve) => {
                addEventListener("hashchange", resolve, { once: true });
                location.hash = hash;
              }),
            fragment,
          );
        isFirst = false;
        await page.waitForSelector(READY[name], { state: "attached" });
        await page.screenshot({ path: join(shots, `${entry.id}.png`) });
        assert.equal(await outcomeOf(page, name), entry.expect, entry.id);
        if (entry.expect !== "refused")
          assert.equal((await page.isHidden("#notice")) ? "" : await page.innerText("#notice"), "", entry.id);
        for (const [number, told] of Object.entries(entry.shows ?? {})) {
          const [shown, wanted] = [await displayed(page, entry, /** @type {keyof Shows} */ (number)), told].map((one) =>
            Array.isArray(one) ? one : [one],
          );
          const isRight = shown.length === wanted.length && wanted.every((one, i) => isTold(Number(shown[i]), one));
          if (!isRight)
            wrong.push(
              `${entry.id}: ${number} is ${shown.join(", ")} on the page, and ${wanted.join(", ")} in its text`,
            );
        }
        const [layer, ...colours] = SHOWS[name === "trajectories" ? name : entry.expect] ?? [];
        if (layer)
          assert.ok((await inkOf(page, layer, colours)) > 20, `${entry.id} draws ${colours.join(" or ") || "edges"}`);
      }
      assert.deepEqual(wrong, []);
    }));
}

/** What an open page shows, as entries call it. @param {Page} page @param {Entry["page"]} name */
function outcomeOf(page, name) {
  return page.evaluate((room) => {
    const dataOf = (/** @type {string} */ css) =>
      /** @type {HTMLElement | null} */ (document.querySelector(css))?.dataset ?? {};
    switch (room) {
      case "planner": {
        if (dataOf("#notice").code === "in-collision" || dataOf("#counters").status === "none") return "refused";
        const first = dataOf("#standings tbody tr").status;
        if (document.querySelector("#stage.race")) return first;
        return dataOf("#story").tone === "bad" ? "flawed" : dataOf("#counters").status;
      }
      case "reach":
        return dataOf("#stage").free === "true" ? "free" : "in collision";
      case "neighbours":
        return dataOf("body").ask === "false" ? "drawn" : dataOf("body").found === "" ? "nothing" : "found";
      case "prm-rl":
      case "trajectories":
        return dataOf("#stage").status;
      default:
        return "open";
    }
  }, name);
}

/**
 * How many pixels of the first figure's layer have nearly one of some colours, or any.
 * @param {Page} page
 * @param {string} layer
 * @param {string[]} names
 */
async function inkOf(page, layer, names) {
  const colours = await coloursOf(
    page,
    names.map((name) => `var(--${name})`),
  );
  return page.evaluate(
    ([wanted, css]) => {
      const element = /** @type {HTMLCanvasElement} */ (document.querySelector(String(css)));
      const context = new OffscreenCanvas(element.width, element.height).getContext("2d", { willReadFrequently: true });
      context?.drawImage(element, 0, 0);
      const { data } = /** @type {ImageData} */ (context?.getImageData(0, 0, element.width, element.height));
      let count = 0;
      for (let i = 0; i < data.length; i += 4) {
        if (
          data[i + 3] > 80 &&
          (wanted.length === 0 ||
            /** @type {number[][]} */ (wanted).some((colour) =>
              colour.every((part, k) => Math.abs(part - data[i + k]) < 24),
            ))
        )
          count++;
      }
      return count;
    },
    /** @type {const} */ ([colours, `#stage canvas[data-layer=${layer}]`]),
  );
}

test("an entry opens by its address, leads to its neighbours and to its page, and closes", () =>
  onPage(
    {},
    async (page, url) => {
      const [first, second] = entries;
      await page.waitForSelector("body[data-state=ready]");
      assert.equal(await page.locator(".entry").count(), entries.length);
      assert.equal(await page.locator("#rows tbody tr[id]").count(), rows.length);
      await page.evaluate(() =>
        Promise.all(Array.from(document.images, (image) => Object.assign(image, { loading: "eager" }).decode())),
      );
      await page.click(`#at-${CSS(first.id)} a`);
      await page.waitForSelector(`.entry:target .detail >> text=${first.see.slice(0, 30)}`);
      await page.keyboard.press("ArrowRight");
      await page.waitForFunction((id) => location.hash === `#${id}`, second.id);
      assert.ok(
        await page
          .locator(".entry:target img")
          .evaluate((image) =>
            /** @type {HTMLImageElement} */ (image).decode().then(() => image.getBoundingClientRect().width > 300),
          ),
      );
      await page.keyboard.press("Escape");
      await page.waitForFunction(() => document.querySelector(".entry:target") === null);
      await page.goBack();
      await page.waitForSelector(".entry:target");
      assert.equal(
        await page.locator(".entry:target .open").evaluate((link) => /** @type {HTMLAnchorElement} */ (link).href),
        new URL(addresses[second.id], url).href,
      );
    },
    { path: "gallery.html" },
  ));

test("filters leave the entries that fit, and an address shows its entry all the same", () =>
  onPage(
    {},
    async (page) => {
      await page.waitForSelector("body[data-state=ready]");
      await page.selectOption("#filter-holds", "no");
      await page.selectOption("#filter-robot", "arm");
      const wanted = entries.filter(({ holds, robot }) => holds === "no" && robot === "arm");
      assert.ok(wanted.length > 0 && wanted.length < entries.length);
      assert.deepEqual(
        await page.locator(".entry:visible").evaluateAll((all) => all.map(({ id }) => id)),
        wanted.map(({ id }) => id),
      );
      await textMatches(page, "#story", new RegExp(`^${wanted.length} of ${entries.length} entries`));
      const other = entries.find(({ robot }) => robot === "particle") ?? assert.fail();
      await page.evaluate((id) => {
        location.hash = id;
      }, other.id);
      await page.waitForSelector(`.entry:target:visible`);
      assert.equal(await page.getAttribute("body", "data-shown"), String(entries.length));
    },
    { path: "gallery.html" },
  ));

test("an address that is no entry shows the gallery, and with the table in focus arrows open no other entry", () =>
  onPage(
    {},
    async (page) => {
      await page.waitForSelector("body[data-state=ready]");
      assert.equal(await page.locator(".entry:target").count(), 0);
      await page.evaluate((id) => {
        location.hash = id;
      }, entries[0].id);
      await page.waitForSelector(".entry:target");
      await page.focus("#rows .scroll");
      await page.keyboard.press("ArrowRight");
      assert.equal(await page.evaluate(() => location.hash), `#${entries[0].id}`);
    },
    { path: "gallery.html#100%" },
  ));

test("axe finds nothing in the gallery, nothing hangs over on a phone, and it can be read without a script", async () => {
  await onPage(
    { ...PHONE, colorScheme: "dark" },
    async (page) => {
      await page.waitForSelector("body[data-state=ready]");
      // What holds for one report holds for all, but takes axe less time.
      await page.selectOption("#filter-report", "5");
      assert.deepEqual(await violations(page), []);
      await page.selectOption("#filter-report", "any");
      for (const width of [320, 390, 820]) {
        await page.setViewportSize({ width, height: 844 });
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0, `${width} px`);
      }
    },
    { path: `gallery.html#${entries[entries.length - 1].id}` },
  );
  await onPage(
    { javaScriptEnabled: false },
    async (page) => {
      assert.ok(await page.isVisible(`.entry:target .open`));
    },
    { path: `gallery.html#${entries[0].id}` },
  );
});

/** An id for a selector: it begins with a digit. @param {string} id */
function CSS(id) {
  return id.replace(/[.]/g, "\\.");
}
