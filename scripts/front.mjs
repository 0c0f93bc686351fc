/**
 * The start page's pictures, each drawn by the code of its page, and the slides of a class. It needs the package in
 * `dist/package`.
 */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { coloursOf, documents } from "./gallery.mjs";
import { root } from "./run.mjs";
import { decodeFragment } from "../www/formats/fragment.js";

/** Bounds of the links in the plan of a class. */
const LINK_LIMITS = { characters: 8192, bytes: 65_536 };
/** Pixels of the picture of a page. */
const CARD = { width: 400, height: 300 };
/** Pixels of the picture that grows. */
const GROWN = { width: 480, height: 480 };
/** Seconds of the fleet's plan that its picture shows. */
const MEETING = 5;

/**
 * What the picture of each page shows: a state of that page and which pane of it. The fleet has code of its own.
 * @type {Record<string, { page: import("../www/gallery/format.js").PageName, state: object, pane?: number }>}
 */
const SHOWN = {
  plan: {
    page: "planner",
    state: { scene: "stones", lanes: [{ algorithm: "prm", settings: { samples: 260, k: 9, seed: 0 } }] },
  },
  reach: {
    page: "reach",
    state: { scene: "islands", mode: "solve", solve: { method: "damped-least-squares" }, steps: 5000 },
  },
  neighbours: {
    page: "neighbours",
    state: { robot: "two", draw: { n: 260, seed: 0, free: true }, q: [3, 0.4], k: 12 },
    pane: 1,
  },
  trajectories: { page: "trajectories", state: { given: { seed: 1 }, tried: 900 } },
  "prm-rl": { page: "prm-rl", state: { planned: 1, driven: 1, time: 1000 } },
  experiments: {
    page: "experiments",
    state: { document: "arm-samples", view: { chart: "box", measure: "length", axis: "planner.samples" } },
  },
  gallery: {
    page: "planner",
    state: {
      scene: "lanes",
      lanes: [{ algorithm: "rrt-connect", settings: { seed: 1 } }],
    },
  },
};

/**
 * Writes `start/NAME.svg` for each page and `start/run.svg`, and returns what the start page's HTML needs.
 * @param {string} out  the folder of the pages
 * @param {{ name: string, title: string, learns: string }[]} pages
 * @returns {Promise<{ cards: string, run: string }>}
 */
export async function assembleFront(out, pages) {
  const [{ openEntry }, { sheetOf }, { RUN }, { beginRun, drawRun }, { encodeLink }, library] = await Promise.all([
    import("../www/gallery/build/open.js"),
    import("../www/gallery/build/sheet.js"),
    import("../www/start/run.js"),
    import("../www/start/growth.js"),
    import("../www/planner/link/codec.js"),
    import("planarium"),
  ]);
  const style = coloursOf();
  mkdirSync(join(out, "start"), { recursive: true });
  /** @typedef {import("../www/gallery/build/sheet.js").Pane} Pane */
  const write = (/** @type {string} */ name, /** @type {Pane} */ pane, /** @type {string} */ title, size = CARD) =>
    writeFileSync(join(out, "start", `${name}.svg`), sheetOf([pane], { title, style }, size));
  const opened = (/** @type {object} */ entry) => openEntry(/** @type {any} */ (entry), documents);
  for (const { name, title } of pages) {
    const { pane = 0, ...entry } = SHOWN[name] ?? {};
    write(name, name === "fleet" ? await fleetPane() : (await opened(entry)).panes[pane], title);
  }
  const grown = beginRun(library);
  while (grown.planner.step(1000) === "running");
  write(
    "run",
    ({ context, palette, width, height }) => drawRun(context, grown, palette, width, height),
    "A tree among discs, and the path that RRT* found",
    GROWN,
  );
  const { kind, options, algorithm, settings } = RUN;
  const lanes = [{ algorithm, settings: { ...settings } }];
  const run = `plan.html#${await encodeLink({ version: 1, view: {}, scene: `make-${kind}`, options, lanes, iteration: grown.planner.iterations })}`;
  const cards = pages.map(
    ({ name, title, learns }) =>
      `      <li><a href="${name}.html"><img src="start/${name}.svg" width="${CARD.width}" height="${CARD.height}" alt=""><b>${title}</b><span>${learns}</span></a></li>`,
  );
  return { cards: cards.join("\n"), run };
}

/** The first fleet of its page on its way. */
async function fleetPane() {
  const [{ FleetSession }, { commands }, { Floor }, { drawWhole }, { coloursOf }, { NO_APP }] = await Promise.all([
    import("../www/fleet/session.js"),
    import("../www/fleet/commands.js"),
    import("../www/fleet/floor.js"),
    import("../www/draw/sheet.js"),
    import("../www/gallery/build/fleet.js"),
    import("../www/gallery/build/sheet.js"),
  ]);
  const session = new FleetSession(NO_APP, /** @type {any} */ (commands));
  session.hasRoadmap = false;
  await session.load({ kind: "ring", options: { count: 12 } }, { isQuick: true });
  session.setTime(MEETING);
  const floor = new Floor(session);
  floor.colours = coloursOf(session.robots.length);
  return (/** @type {import("../www/draw/sheet.js").Brush} */ brush) => drawWhole(floor, brush);
}

const LINK = /\[([^\]]+)\]\(\.\.\/www\/([^)]+)\)/g;

/**
 * The rows of the plan of a class in docs/teaching.md: its minute, title, page, question, and answer. `linked` is the
 * answer in Markdown, whose links open further pages.
 */
export function classPlan() {
  const text = readFileSync(join(root, "docs", "teaching.md"), "utf8");
  return Array.from(
    text.matchAll(/^\| (\d+) \| \[([^\]]+)\]\(\.\.\/www\/([^)]+)\) \| (.+) \| (.+) \|$/gm),
    ([, minute, title, page, question, linked]) => ({
      minute: Number(minute),
      title,
      page,
      question,
      linked,
      answer: linked.replace(LINK, "$1"),
    }),
  );
}

/** Links to the guides of the planners that a page opens with. @param {string} page  with its fragment */
async function guidesOf(page) {
  const { value, fault } = await decodeFragment(page.split("#")[1], LINK_LIMITS, () => {});
  if (fault) throw new Error(`${page}: ${fault}`);
  const { lanes, document } = /** @type {any} */ (value);
  /** @type {Set<string>} */
  const planners = new Set((lanes ?? document.planners).map((/** @type {any} */ { algorithm }) => algorithm));
  return Array.from(planners, (id) => {
    const [, title] = /** @type {RegExpExecArray} */ (
      /^# ([^:\n]+)/.exec(readFileSync(join(root, "docs", "planners", `${id}.md`), "utf8"))
    );
    return `<a href="docs/planners/${id}.html" target="_blank">${title}</a>`;
  });
}

/** The HTML of the slides. */
export async function slides() {
  const html = (/** @type {string} */ text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
  const sections = await Promise.all(
    classPlan().map(async ({ title, page, question, linked }) => {
      const answer = html(linked).replace(LINK, (_, words, other) => `<a href="${other}">${words}</a>`);
      const guides = `About ${(await guidesOf(page)).join(", ")}`;
      return `<section class="slide" data-page="${page}" data-title="${html(title)}" hidden><h1>${html(question)}</h1><p class="answer" hidden>${answer}</p><span class="guides" hidden>${guides}</span></section>`;
    }),
  );
  return sections.join("\n  ");
}
