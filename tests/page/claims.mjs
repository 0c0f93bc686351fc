/** What a page displays, as the numbers that entries of the gallery name: read from its text, as a reader does. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { Scenario } from "planarium";
import { root } from "../../scripts/run.mjs";
import { ran } from "./library.mjs";

/** @import { Entry, Shows } from "../../www/gallery/format.js" */
/** @import { Page } from "./browser.mjs" */

/** The counters of a run, and the columns of a race's table, by the names of the numbers. */
const COUNTERS = ["iterations", "vertices", "edges", "motions", "length", "waypoints", "visited"];
/** @type {Partial<Record<keyof Shows, string>>} */
const COLUMNS = {
  iterations: "Iterations",
  vertices: "Vertices",
  edges: "Edges",
  motions: "Motions",
  length: "Path length",
  waypoints: "Path vertices",
  visited: "Vertices visited",
};
/**
 * What a page says in words: a selector, and a pattern whose group is the number.
 * @type {Record<string, Partial<Record<keyof Shows, [string, RegExp]>>>}
 */
const WORDS = {
  planner: {
    pieces: ["#story", /has ([\d,]+) connected components/],
    turn: ["#turns", /joint 1 ([+\u2212-]?[\d.]+) rad/],
    apart: ["#drive .roll .hint", /ends ([\d.]+) m/],
  },
  reach: {
    length: ["#story", /, ([\d.]+) rad in total/],
    turn: ["#story", /theta turns ([\d.]+) rad/],
    end: ["#story", /joint 1 ends at ([\u2212-]?[\d.]+) rad/i],
    solutions: ["#fact-solutions", /^(\d+) /],
  },
  neighbours: {
    visited: ["#story", /visited ([\d,]+) of/],
    missed: ["#story", /missed (\d+) of|neighbours (\d+) (?:is|are) wrong/],
  },
  trajectories: { accepted: ["#fact-accepted", /^([\d,]+) of/], apart: ["main", /([\d.]+) m apart/] },
  "prm-rl": { reached: ["#story", /(\d+) of/] },
};

/** How a page displays a number of an entry: in words of its own, in a table, or as a counter. @param {Entry} entry @param {string} name */
export function displayOf({ page, state }, name) {
  const words = WORDS[page]?.[/** @type {keyof Shows} */ (name)];
  if (words || name === "crossings") return `${page} ${name}`;
  return "lanes" in state && state.lanes.length > 1 ? "column" : "counter";
}

/** An angle between -pi and pi. @param {number} angle */
function wrapped(angle) {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

/** A displayed number; NaN for a dash. @param {string} text */
function numberOf(text) {
  return Number(
    text
      .replaceAll(",", "")
      .replace("\u2212", "-")
      .match(/^[+-]?[\d.]+/)?.[0] ?? NaN,
  );
}

/**
 * The value that an open page displays of a number.
 * @param {Page} page
 * @param {Entry} entry
 * @param {keyof Shows} name
 * @returns {Promise<number | number[]>}
 */
export async function displayed(page, entry, name) {
  if (name === "crossings") return crossings(page, entry);
  const words = WORDS[entry.page]?.[name];
  if (words) {
    const [selector, pattern] = words;
    const text = (await page.textContent(selector)) ?? "";
    const found = pattern
      .exec(text)
      ?.slice(1)
      .find((one) => one !== undefined);
    assert.ok(found, `${entry.id}: the page does not say its ${name}: ${text.slice(0, 400)}`);
    return numberOf(found);
  }
  if (entry.page === "planner" && entry.state.lanes.length > 1) {
    const title = COLUMNS[name] ?? assert.fail(`a race shows no ${name}`);
    const texts = await page.locator("#standings table").evaluate((table, column) => {
      const [head, ...rows] = /** @type {HTMLTableElement} */ (table).rows;
      const at = [...head.cells].findIndex(({ textContent, hidden }) => textContent === column && !hidden);
      return rows.map(({ cells }) => cells[at]?.textContent ?? "");
    }, title);
    return texts.map(numberOf);
  }
  assert.ok(entry.page === "planner" && COUNTERS.includes(name), `${entry.page} shows no ${name}`);
  // Where there is little room the counter is folded away.
  return numberOf((await page.textContent(`#count-${name}`)) ?? "");
}

/**
 * Edges across 0 of any joint. The page draws them and counts none: they are counted in the same run, which its
 * fingerprint identifies.
 * @param {Page} page
 * @param {Entry} entry
 */
async function crossings(page, entry) {
  if (entry.page !== "planner" || !entry.world) return assert.fail(`${entry.id} has no roadmap`);
  const [{ algorithm = "", settings }] = entry.state.lanes;
  const scenario = Scenario.parse(readFileSync(join(root, "www", "gallery", "worlds", `${entry.world}.json`), "utf8"));
  const run = ran(scenario, algorithm, { ...settings, ...(entry.state.query ? { query: entry.state.query } : {}) });
  assert.equal(
    run.result.fingerprint,
    await page.getAttribute("#counters", "data-fingerprint"),
    `${entry.id} is another run`,
  );
  return run.edges.filter(([a, b]) =>
    run.vertices[a].some((angle, joint) => {
      const from = wrapped(angle);
      const to = from + wrapped(run.vertices[b][joint] - from);
      return Math.abs(to) <= Math.PI && from * to < 0;
    }),
  ).length;
}

/**
 * Whether a displayed number is the one of a text, which may have fewer digits; null stands for a dash.
 * @param {number} shown
 * @param {number | null} named
 */
export function isDisplayed(shown, named) {
  if (named === null) return Number.isNaN(shown);
  const digits = /\.(\d+)$/.exec(String(named))?.[1].length ?? 0;
  return (
    Math.abs(shown - named) <= 0.5000001 * 10 ** -digits &&
    (digits > 0 || Number.isInteger(shown) === Number.isInteger(named))
  );
}
