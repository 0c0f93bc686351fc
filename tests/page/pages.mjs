/**
 * What is particular about each page, for the tests that hold for all of them. A page without a row is tested as it
 * opens.
 */
import { encodeState } from "../../www/app/link.js";
import { atRest, choose, click, fill, finish, pickFile, unfold } from "./browser.mjs";

/** @import { Page } from "./browser.mjs" */

/**
 * @typedef {object} Row
 * @property {string} [ready]  beside being at rest: a selector of what it shows as it opens
 * @property {"planarium" | "full" | ""} [core]  the module of WebAssembly that it loads
 * @property {number} [side]  of its figures at any width, pixels, at least; 0: it has none
 * @property {Record<string, (page: Page) => Promise<unknown>>} [states]  how each is entered from the one before it
 * @property {number} [controls]  in the panel as it opens, at most, beside the choice of a scene
 * @property {string[]} [broken]  fragments that are refused for what they say, besides those that no page can read
 * @property {string} [search]  leaves some of its entries: what holds for them holds for all, but takes axe less time
 * @property {boolean} [takesFiles]
 * @property {boolean} [isEmbedded]  does it open in a frame, as its figure alone?
 * @property {boolean} [isPrinted]  is it printed without its controls?
 */

/** All trials of an experiment have ended, and their chart is drawn. */
export const DONE = "body[data-phase=done][data-settled=true][data-chart]:not([data-chart=''])";

/** All is computed and drawn. @param {Page} page */
export const rest = async (page) => {
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(resolve)));
  await page.waitForSelector("#counters[data-settled=true], body[data-state=ready][data-settled=true]", {
    state: "attached",
  });
};

/** Unfolds all of the page. @param {Page} page */
const unfoldAll = async (page) => {
  await page.evaluate(() => {
    for (const details of document.querySelectorAll("details")) details.open = true;
  });
  await rest(page);
};

/** Gives fields their values, one after the other. @param {Page} page @param {Record<string, string>} values */
const give = async (page, values) => {
  for (const [id, value] of Object.entries(values)) {
    await fill(page, `#${id}`, value);
    await rest(page);
  }
};

/** Chooses a scene. @param {Page} page @param {string} id @param {string} shown  then, beside being at rest */
const stage = async (page, id, shown) => {
  await choose(page, "scene", id);
  await page.waitForSelector(shown);
  await rest(page);
};

/** Clicks, and waits until all is computed and drawn. @param {Page} page @param {string} selector @param {string} [shown] */
const press = async (page, selector, shown = "body") => {
  await page.click(selector);
  await page.waitForSelector(shown);
  await rest(page);
};

/** A state that no page can open, as a fragment. @param {object} state */
const fragmentOf = (state) => encodeState(state, () => {});

/** @type {Record<string, Row>} */
export const ROWS = {
  plan: {
    ready: "#counters[data-status=running]",
    core: "planarium",
    side: 120,
    controls: 6,
    states: {
      "solved, all numbers and parameters open": async (page) => {
        await finish(page);
        await page.click("#more summary");
        await unfold(page, "view");
        await unfold(page, "curves");
      },
      "the editor, with something selected": async (page) => {
        await page.click("#edit");
        await page.waitForSelector("#edit-tools");
        await page.locator("#stage").press("]");
        await atRest(page);
      },
      "a lesson, with everything unfolded": async (page) => {
        await page.click("#edit");
        await unfoldAll(page);
        await unfold(page, "export");
        await page.click("#lessons button");
        await page.waitForSelector("#lesson:not([hidden])");
        await atRest(page);
      },
      "the robot moved by hand, in collision": async (page) => {
        await page.click("#lesson-leave");
        await stage(page, "stones", "body[data-scene=stones]");
        await click(page, "#step-10");
        await page.click("#your-turn");
        await give(page, { "pose-0-number": "0.7", "pose-1-number": "0" });
        await page.waitForSelector("#touching[data-free=false]");
      },
    },
  },
  reach: {
    ready: "body[data-scene=islands]",
    controls: 3,
    states: {
      touching: (page) => give(page, { "joint-0-number": "0.78", "joint-1-number": "0" }),
      solved: async (page) => {
        await stage(page, "corner", "body[data-scene=corner]");
        await page.click("#mode-solve");
        await press(page, "#solve-finish", "#solve:not([data-status=running])");
      },
      "a body, from A to B the faulty way": async (page) => {
        await stage(page, "plan-corner", "body[data-scene=plan-corner]");
        await press(page, "#mode-between");
        await give(page, { "joint-2-number": "-3" });
        await press(page, "#set-a");
        await unfoldAll(page);
        await press(page, "#rounds button[data-direction=faulty]", "#between[data-missed='1']");
      },
      "with stops": async (page) => {
        await stage(page, "limits", "body[data-scene=limits]");
        await unfoldAll(page);
      },
    },
    broken: [
      "2abc",
      `1${"a".repeat(3000)}`,
      await fragmentOf({ scene: "corner", robot: { links: [0.1, -1] }, solve: { method: "ccd" } }),
    ],
  },
  neighbours: {
    ready: "body[data-robot=two][data-found]",
    controls: 6,
    states: {
      naive: async (page) => {
        await page.selectOption("#option-metric", "naive");
        await rest(page);
      },
      "a body, by a forest, measured, all unfolded": async (page) => {
        await stage(page, "body", "body[data-robot=body]");
        await page.selectOption("#index", "forest");
        await press(page, "#measure", "#timing[data-timing=done]");
        await unfoldAll(page);
      },
      "the list alone": (page) => press(page, "label[for=ask]", "body[data-ask=false]"),
    },
    broken: [
      await fragmentOf({
        robot: "three",
        draw: { n: 300, seed: 1, free: true },
        q: [0, 0, 0],
        k: 3,
        index: "forest",
        given: { trees: 1000 },
      }),
      await fragmentOf({ robot: "body", weights: [0, -1] }),
    ],
  },
  trajectories: {
    ready: "#stage[data-status=solved]",
    side: 180,
    takesFiles: false,
    states: { unfolded: unfoldAll },
    broken: [await fragmentOf({ given: { haste: 3 } })],
  },
  fleet: {
    ready: "#stage[data-status=solved]",
    states: {
      "everything unfolded": async (page) => {
        await unfoldAll(page);
        await page.click("#robot-7 .chip");
        await give(page, { time: "5" });
      },
      "an order that fails": async (page) => {
        await stage(page, "swap", "#stage[data-status=solved]");
        await page.click("#robot-2 .chip");
        await press(page, "#first", "#stage[data-status=exhausted]");
      },
    },
    broken: [
      await fragmentOf({ kind: "maze" }),
      await fragmentOf({ given: { haste: 3 } }),
      await fragmentOf({ order: [0, 900] }),
      await fragmentOf({ planner: "composite" }),
    ],
  },
  "prm-rl": {
    ready: "#stage[data-status=solved]",
    states: {
      "a plan with its drives, unfolded": unfoldAll,
      "a step of the lesson, with its answer": async (page) => {
        await page.click("#begin-lesson");
        await press(page, "#lesson-run", "#lesson[data-shown=answer]");
      },
      "a training": async (page) => {
        await page.click("#lesson-leave");
        await press(page, "#part-train", "#stage[data-training=ready]");
      },
      "a comparison": (page) => press(page, "#part-compare"),
    },
    broken: [await fragmentOf({ options: { seed: 5 }, given: { haste: 3 }, planned: 1 })],
  },
  experiments: {
    ready: "body[data-phase=ready]",
    side: 0,
    states: {
      "an experiment that was run": async (page) => {
        await pickFile(page, "small.json", JSON.stringify(SMALL));
        await page.waitForSelector("body[data-phase=ready][data-count='8'][data-settled=true]");
        await press(page, "#run", DONE);
        await unfoldAll(page);
      },
      "success as bars": (page) => press(page, "#kinds [data-kind=success]", "body[data-chart=success]"),
    },
  },
  gallery: { core: "", side: 0, search: "edge_check", takesFiles: false, isEmbedded: false, isPrinted: false },
};

/**
 * A short experiment, some of whose trials find no path.
 * @type {import("../../www/domain/types.js").LinkedDocument}
 */
export const SMALL = {
  format: "planarium-experiment-1",
  title: "Small",
  worlds: [{ scene: "stones" }],
  planners: [
    { algorithm: "prm", set: { samples: 40 } },
    { algorithm: "rrt-connect", set: { max_iterations: 60 } },
  ],
  seeds: { from: 0, count: 4 },
};
