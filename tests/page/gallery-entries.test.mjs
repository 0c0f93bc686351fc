/**
 * Entries of the gallery: all rows of the reports are there, and entries open in their pages and show what they say. A
 * sample of them is opened, which has one of each kind; with `PLANARIUM_DEEP=1` all are.
 */
import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
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
import { MORE } from "../../www/gallery/more.js";
import { ENTRIES, REPORTS, TEXTS } from "../../www/gallery/reports.js";
import { stateRule as fleetRule } from "../../www/fleet/state.js";
import { stateRule as neighboursRule } from "../../www/neighbours/state.js";
import { decodeLink } from "../../www/planner/link/codec.js";
import { stateRule as learnedRule } from "../../www/prm-rl/state.js";
import { stateRule as reachRule } from "../../www/reach/state.js";
import { stateRule as trajectoriesRule } from "../../www/trajectories/state.js";
import { documents } from "../../scripts/gallery.mjs";
import { displayOf, displayed, isDisplayed } from "./claims.mjs";
import { coloursOf, isDeep, onPage, useBrowser } from "./browser.mjs";
import { ofReports, topics, entries, rows, addresses } from "./gallery.mjs";

/** @import { Entry, Shows } from "../../www/gallery/format.js" */
/** @import { Page } from "./browser.mjs" */

useBrowser();

/** Rows of the reports, and how many of them each has. */
const COUNTS = [41, 23, 25, 59, 13];

const shots = join(targetFolder(), "gallery");

/** How each page says that a state is open and drawn. @type {Record<Entry["page"], string>} */
const READY = {
  planner: "body[data-state=ready][data-settled=true]:has(#counters[data-settled=true])",
  reach: "body[data-state=ready][data-settled=true]",
  neighbours: "body[data-state=ready][data-settled=true][data-found]",
  trajectories: "body[data-state=ready][data-settled=true]",
  fleet: "body[data-state=ready][data-settled=true]",
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
  fleet: ["top"],
  // It has no plan: its drives are drawn, which time out.
  policy: ["top", "rejected"],
};

/** What only some entries have: an outcome on a page, a race, a number that is displayed in its own way. @param {Entry} entry */
function kindsOf(entry) {
  const { page, expect, state, shows = {} } = entry;
  const isRace = "lanes" in state && state.lanes.length > 1;
  return [
    `${page} ${expect}`,
    ...(isRace ? ["race"] : []),
    ...Object.keys(shows).map((name) => displayOf(entry, name)),
  ];
}

/** Few entries that have all kinds among them: the next one is always one with the most kinds that are missing. */
function sample() {
  const missing = new Set(ENTRIES.flatMap(kindsOf));
  const newOf = (/** @type {Entry} */ entry) => new Set(kindsOf(entry).filter((kind) => missing.has(kind))).size;
  /** @type {Entry[]} */
  const chosen = [];
  while (missing.size > 0) {
    const next = ENTRIES.reduce((best, entry) => (newOf(entry) > newOf(best) ? entry : best));
    for (const kind of kindsOf(next)) missing.delete(kind);
    chosen.push(next);
  }
  return chosen;
}

test("all 161 rows are there, each with a verdict, its place and its entries", () => {
  assert.deepEqual(
    REPORTS.map((report) => report.rows.length),
    COUNTS,
  );
  assert.deepEqual(
    rows.map(({ row }) => row),
    rows.map((_, i) => i + 1),
  );
  const ids = new Set(ofReports.map(({ id }) => id));
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
  const reported = new Map(REPORTS.flatMap((report) => report.entries.map(({ id }) => [id, report.number])));
  for (const { id, title, see, try: tried = "", report: says = "", why = "", chosen = "", holds } of ENTRIES) {
    const number = reported.get(id);
    assert.match(id, number ? new RegExp(`^${number}-[a-z0-9.-]+$`) : /^[a-z]+-[a-z-]+$/, id);
    assert.equal(named.has(id), number !== undefined, `${id} is named by a row if it is of a report`);
    assert.equal(holds !== undefined, number !== undefined, `${id} has a verdict if it is of a report`);
    assert.ok(title.length <= 48, `${id}: ${title}`);
    assert.ok(!number || holds === "yes" || why, `${id} says why it does not hold`);
    const texts = [see, tried, says, why, chosen];
    assert.ok(
      see && texts.every((text) => text === "" || /^[^a-z].*[.:?)]$/s.test(text)),
      `${id}: ${texts.find((text) => text && !/^[^a-z].*[.:?)]$/s.test(text))}`,
    );
    assert.ok(texts.join(" ").length <= 640, `${id}: ${texts.join(" ").length} characters`);
  }
});

test("every entry has a topic, every topic has entries, and the best of a topic come first", () => {
  assert.deepEqual(new Set(entries), new Set(ENTRIES));
  for (const { id, best, entries: own } of topics) {
    assert.ok(own.length > 0, id);
    assert.deepEqual(
      own.slice(0, best.length).map((entry) => entry.id),
      best,
      id,
    );
  }
});

test("every number that an entry tells to see is shown by the page, or is one of its settings", () => {
  for (const entry of [
    ...[REPORT_1, REPORT_2, REPORT_3, REPORT_4, REPORT_5].flatMap(({ entries: own }) => own),
    ...MORE,
  ]) {
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
    fleet: (fragment) => decodeState(fragment, fleetRule),
    "prm-rl": (fragment) => decodeState(fragment, learnedRule),
  };
  for (const { id, page } of ENTRIES) {
    const [path, fragment] = addresses[id].split("#");
    assert.equal(path, page === "planner" ? "plan.html" : `${page}.html`, id);
    assert.equal((await read[page](fragment)).fault || "", "", id);
  }
});

test("a sample of the entries has every kind of them", (t) => {
  const own = sample();
  assert.deepEqual(new Set(own.flatMap(kindsOf)), new Set(ENTRIES.flatMap(kindsOf)));
  assert.ok(own.length < ENTRIES.length / 4, `${own.length}`);
  if (!isDeep)
    t.diagnostic(
      `${ENTRIES.length - own.length} of ${ENTRIES.length} entries are not opened: PLANARIUM_DEEP=1 opens all`,
    );
});

test(`${isDeep ? "the" : "some"} entries of each page open, and show what they say`, (t) =>
  onPage(
    { reducedMotion: "reduce", viewport: { width: 1024, height: 640 } },
    async (page, url) => {
      mkdirSync(shots, { recursive: true });
      for (const name of /** @type {Entry["page"][]} */ (Object.keys(READY))) {
        const own = (isDeep ? ENTRIES : sample()).filter(({ page }) => page === name);
        await t.test(name, async () => {
          let isFirst = true;
          /** @type {string[]} */
          const wrong = [];
          for (const entry of own) {
            const [path, fragment] = addresses[entry.id].split("#");
            if (isFirst) await page.goto(`${url}${path}#${fragment}`);
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
            for (const [number, named] of Object.entries(entry.shows ?? {})) {
              const [shown, wanted] = [await displayed(page, entry, /** @type {keyof Shows} */ (number)), named].map(
                (one) => (Array.isArray(one) ? one : [one]),
              );
              const isRight =
                shown.length === wanted.length && wanted.every((one, i) => isDisplayed(Number(shown[i]), one));
              if (!isRight)
                wrong.push(
                  `${entry.id}: ${number} is ${shown.join(", ")} on the page, and ${wanted.join(", ")} in its text`,
                );
            }
            const isAlone = "way" in entry.state && entry.state.way === "policy";
            const [layer, ...colours] = SHOWS[name] ?? SHOWS[isAlone ? "policy" : entry.expect] ?? [];
            if (layer)
              assert.ok(
                (await inkOf(page, layer, colours)) > 20,
                `${entry.id} draws ${colours.join(" or ") || "edges"}`,
              );
          }
          assert.deepEqual(wrong, []);
        });
      }
    },
    { path: "icon.svg" },
  ));

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
      case "fleet":
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
