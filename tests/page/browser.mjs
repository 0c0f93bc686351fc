/**
 * Chromium and the built pages, for their tests: every page opened here is watched for errors and for requests that
 * leave the site. A run of all files has one browser and one server, whose addresses are in the environment; a file
 * that is run by itself has its own.
 */
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { pagePolicy, serve } from "../../scripts/serve.mjs";

export const root = fileURLToPath(new URL("../../", import.meta.url));
const siteRoot = fileURLToPath(new URL("../../dist/site", import.meta.url));
export const pageRoot = fileURLToPath(new URL("../../dist/page", import.meta.url));

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").BrowserContextOptions} Options */
/** @typedef {"ground" | "growth" | "roadmap" | "edges" | "vertices" | "marks" | "top"} LayerName  of a figure */
/**
 * @typedef {{ before?: (page: Page) => Promise<void>, expectErrors?: boolean, path?: string, isFolded?: boolean }} More
 *   `path`: of a page, its query and fragment; without a name it is the planner's
 */
/** @typedef {{ context: import("playwright-core").BrowserContext, page: Page, faults: string[] }} Opened */

/** Are all cases tried, and not only those that differ in kind? */
export const isDeep = process.env.PLANARIUM_DEEP === "1";

/** The planner's page. */
const PLAN = "plan.html";

export const DESK = { viewport: { width: 1280, height: 860 } };
export const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true };
/** A phone whose browser lays pages out as phones do. */
export const MOBILE = { ...PHONE, isMobile: true };

/** A script that wraps the core: its next function whose name contains `self.trap` traps. */
export const TRAP = `{
  self.trap = "";
  const { Instance } = WebAssembly;
  WebAssembly.Instance = function (module, imports) {
    const { exports } = new Instance(module, imports);
    return { exports: Object.fromEntries(Object.entries(exports).map(([name, one]) => [name, typeof one !== "function" ? one : (...args) => {
      if (!self.trap || !name.includes(self.trap)) return one(...args);
      self.trap = "";
      throw new WebAssembly.RuntimeError("unreachable");
    }])) };
  };
}
`;

/** @type {import("playwright-core").Browser | undefined} */
let browser;
/** @type {{ url: string, close?: () => Promise<void> } | undefined} */
let server;
let begin = async () => {};
/** @type {Promise<void> | undefined} */
let starting;
/** Pages that wait for the next test, by what cannot be changed once a page is open. @type {Map<string, Opened>} */
const idle = new Map();

/**
 * Connects to the browser and the server of the run, or starts them. Chromium is taken from CHROMIUM or from where
 * Debian puts it.
 * @param {string} [folder]  of the page, where it is another build: it has a server of its own
 */
export async function start(folder = pageRoot) {
  const { PLANARIUM_BROWSER, PLANARIUM_PAGES, CHROMIUM } = process.env;
  if (PLANARIUM_PAGES && folder === pageRoot) server = { url: PLANARIUM_PAGES };
  else {
    assert.ok(existsSync(folder), `${folder} is missing: run \`npm run build\` first`);
    server = await serve({
      root: folder,
      port: 0,
      policy: folder === pageRoot ? pagePolicy() : undefined,
      docs: siteRoot,
    });
  }
  if (PLANARIUM_BROWSER) {
    browser = await chromium.connect(PLANARIUM_BROWSER, { timeout: 30_000 }).catch((error) => {
      throw new Error("The browser of this run does not answer: it has crashed, or was closed.", { cause: error });
    });
    return;
  }
  const found = ["/usr/bin/chromium-headless-shell", "/usr/bin/chromium"].find((path) => existsSync(path));
  browser = await chromium.launch({ executablePath: CHROMIUM ?? found, args: ["--no-sandbox"] });
}

export async function stop() {
  idle.clear();
  await browser?.close();
  await server?.close?.();
}

/**
 * The address of a page.
 * @param {string} url  of the server
 * @param {string} [path]  of the page, its query and fragment; without a name it is the planner's
 */
export const addressOf = (url, path = "") => new URL(path, new URL(PLAN, url)).href;

/**
 * The tests of a file have a browser and a server, once one of them opens a page.
 * @param {string} [folder]  of the page, where it is another one
 */
export function useBrowser(folder) {
  begin = () => (starting ??= start(folder));
  after(stop);
}

/**
 * A page in a context of its own, watched for errors and for requests that leave the site.
 * @param {Options} options
 * @returns {Promise<Opened>}
 */
async function opened(options) {
  assert.ok(browser && server, "start() comes first");
  const { origin: home } = new URL(server.url);
  // What the page keeps for later would answer in the place of the files that tests put in its way.
  const context = await browser.newContext({ ...DESK, serviceWorkers: "block", ...options });
  // What takes so long will never come: no test waits for a clock, so a busy machine may take its time.
  context.setDefaultTimeout(60_000);
  const page = await context.newPage();
  /** @type {string[]} */
  const faults = [];
  page.on("console", (message) => {
    // The tests read canvases back more often than a page would, and keep its files from being kept: both are remarked
    // on.
    const remark = /^(Canvas2D: Multiple readback operations|Service Worker registration blocked by Playwright)/.test(
      message.text(),
    );
    if ((message.type() === "error" || message.type() === "warning") && !remark)
      faults.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => faults.push(`thrown: ${error.message}`));
  page.on("request", (request) => {
    const { protocol, origin } = new URL(request.url());
    if (protocol !== "data:" && protocol !== "blob:" && origin !== home) faults.push(`request to ${request.url()}`);
  });
  return { context, page, faults };
}

/**
 * Opens the page, runs a test on it, and holds it to silence: no error on the console, nothing thrown, no request to
 * anywhere else. The document is a new one each time; the window that it is in serves the next test too, unless the
 * test prepares it.
 * @param {Options} options  `reducedMotion: "reduce"` opens it paused
 * @param {(page: Page, url: string) => Promise<void>} test
 * @param {More} [more]
 */
export async function onPage(options, test, { before, expectErrors = false, path = "" } = {}) {
  await begin();
  assert.ok(server, "start() comes first");
  const { url } = server;
  const {
    viewport,
    colorScheme = "light",
    reducedMotion = "no-preference",
    forcedColors = "none",
    ...fixed
  } = { ...DESK, ...options };
  const key = before || expectErrors || fixed.permissions ? "" : JSON.stringify({ reducedMotion, ...fixed });
  const one = (key && idle.get(key)) || (await opened(options));
  idle.delete(key);
  const { page, context, faults } = one;
  let isKept = false;
  try {
    if (viewport) await page.setViewportSize(viewport);
    await page.emulateMedia({ media: null, colorScheme, reducedMotion, forcedColors });
    await before?.(page);
    await page.goto(addressOf(url, path));
    await test(page, url);
    if (!expectErrors) assert.deepEqual(faults, []);
    isKept = key !== "";
  } finally {
    if (isKept) {
      await tidy(page);
      await page.goto("about:blank");
      idle.set(key, one);
    } else await context.close();
  }
}

/** Takes away what a test left around its document. @param {Page} page */
export async function tidy(page) {
  const context = page.context();
  for (const other of context.pages()) if (other !== page) await other.close();
  if (page.url().startsWith("http"))
    await page.evaluate(() => {
      localStorage.clear();
      sessionStorage.clear();
    });
  await context.clearPermissions();
  await page.unrouteAll();
  await page.mouse.move(0, 0);
}

/**
 * A page that waits at iteration 0, with "More" open unless the test `isFolded`.
 * @param {(page: Page, url: string) => Promise<void>} test @param {Options} [options] @param {More} [more]
 */
export async function onPausedPage(test, options = {}, more = {}) {
  await onPage(
    { reducedMotion: "reduce", ...options },
    async (page, url) => {
      await page.waitForSelector("#counters[data-settled=true][data-status=running]", { state: "attached" });
      if (!more.isFolded) await reveal(page, "#more");
      await test(page, url);
    },
    more,
  );
}

/** The numbers of the run. @param {Page} page */
export async function counters(page) {
  return page.locator("#counters").evaluate((element) => {
    const { status, phase, iterations, vertices, edges, fingerprint, length } = /** @type {HTMLElement} */ (element)
      .dataset;
    return {
      status: status ?? "",
      phase: phase ?? "",
      iterations: Number(iterations),
      vertices: Number(vertices),
      edges: Number(edges),
      fingerprint: fingerprint ?? "",
      length: length === undefined ? NaN : Number(length),
    };
  });
}

/** Waits until all that was ordered is done and drawn. @param {Page} page */
export async function atRest(page) {
  await page.waitForSelector("#counters[data-settled=true]", { state: "attached" });
  return counters(page);
}

/** Runs to the end and waits for it. @param {Page} page */
export async function finish(page) {
  const ended = ["solved", "exhausted"]
    .map((status) => `#counters[data-settled=true][data-status=${status}]`)
    .join(", ");
  // What plays may come to its end by itself: then the button is off.
  await page.waitForSelector(`#finish:enabled, ${ended}`, { state: "attached" });
  await page.locator("#finish").evaluate((button) => /** @type {HTMLElement} */ (button).click());
  await page.waitForSelector(ended, { state: "attached" });
  return counters(page);
}

/** Shows an iteration of a run, or a time of a race. @param {Page} page @param {number} time */
export async function seek(page, time) {
  await page.fill("#time", String(time));
  await page.press("#time", "Enter");
  return atRest(page);
}

/** Opens the folds that a control is in, such as "More". @param {Page} page @param {string} selector */
export async function reveal(page, selector) {
  await page
    .locator(selector)
    .first()
    .evaluate((element) => {
      for (let fold = element.closest("details"); fold; fold = fold.parentElement?.closest("details") ?? null)
        fold.open = true;
    });
}

/** Opens a fold and waits for what is in it. @param {Page} page @param {string} id */
export async function unfold(page, id) {
  await reveal(page, `#${id}-fold`);
  await page.waitForFunction((name) => (document.getElementById(name)?.childElementCount ?? 0) > 0, id);
}

/**
 * Chooses one of several, wherever the strip that it is in has scrolled to.
 * @param {import("playwright-core").Page | import("playwright-core").Frame} page
 * @param {string} name
 * @param {string} value
 */
export async function choose(page, name, value) {
  await page
    .locator(`input[name=${name}][value=${value}]`)
    .evaluate((input) => /** @type {HTMLElement} */ (input).click());
}

/** Puts a scene on the stage, with its own planner. @param {Page} page @param {string} id */
export async function chooseScene(page, id) {
  await choose(page, "scene", id);
  await page.waitForSelector(`body[data-scene=${id}]`);
  const own = page.locator("#own-planner:not([hidden])");
  if ((await own.count()) > 0) await own.evaluate((button) => /** @type {HTMLElement} */ (button).click());
  await page.waitForSelector("#counters[data-settled=true][data-status=running]", { state: "attached" });
}

/** Clicks, and waits until all that was ordered is done and drawn. @param {Page} page @param {string} selector */
export async function click(page, selector) {
  await reveal(page, selector);
  await page.click(selector);
  return atRest(page);
}

/** Presses keys, one after the other. @param {Page} page @param {...string} names */
export async function keys(page, ...names) {
  for (const name of names) await page.keyboard.press(name);
}

/**
 * Presses a key, and waits until an element is in a state.
 * @param {Page} page
 * @param {string} key
 * @param {string} selector
 */
export async function pressUntil(page, key, selector) {
  await page.keyboard.press(key);
  await page.waitForSelector(selector, { state: "attached" });
}

/** The page's link, as its fragment. @param {Page} page */
export async function linkOf(page) {
  await page.evaluate(() => history.replaceState(null, "", location.pathname + location.search));
  await page.click("#link");
  await page.waitForFunction(() => location.hash.length > 1);
  return new URL(page.url()).hash;
}

/** The values that a select offers. @param {Page} page @param {string} id @returns {Promise<string[]>} */
export const offered = (page, id) =>
  page
    .locator(`#${id}`)
    .evaluate((/** @type {HTMLSelectElement} */ { options }) => Array.from(options, ({ value }) => value));

/**
 * Gives a field or a select a value, and leaves it.
 * @param {Page} page
 * @param {string} selector
 * @param {string} value
 */
export async function fill(page, selector, value) {
  await reveal(page, selector);
  const control = page.locator(selector);
  if (await control.evaluate(({ tagName }) => tagName === "SELECT")) await control.selectOption(value);
  else await control.fill(value);
  await control.blur();
}

/**
 * Types a value into a parameter and leaves the field.
 * @param {Page} page
 * @param {string} name
 * @param {string} value
 */
export const setParameter = (page, name, value) => fill(page, `#parameter-${name}`, value);

/**
 * Chooses a planner and waits for its panel.
 * @param {Page} page
 * @param {string} id
 * @param {string} parameter  that it has
 */
export async function choosePlanner(page, id, parameter) {
  await page.selectOption("#planner", id);
  await page.waitForSelector(`#parameter-${parameter}`, { state: "attached" });
}

/** Waits until a run has made more than a number of iterations. @param {Page} page @param {number} iterations */
export const passes = (page, iterations) =>
  page.waitForFunction((least) => Number(document.getElementById("counters")?.dataset.iterations) > least, iterations);

/**
 * Waits until a field or a slider has a value within bounds.
 * @param {Page} page
 * @param {string} id
 * @param {number} low
 * @param {number} [high]
 */
export const valueWithin = (page, id, low, high = Infinity) =>
  page.waitForFunction(
    ([name, least, most]) => {
      const value = Number(/** @type {HTMLInputElement} */ (document.getElementById(String(name))).value);
      return value > Number(least) && value < Number(most);
    },
    [id, low, high],
  );

/** Waits until an element's text matches. @param {Page} page @param {string} selector @param {RegExp} pattern */
export const textMatches = (page, selector, pattern) =>
  page.waitForFunction(
    ([css, source]) => new RegExp(source).test(document.querySelector(css)?.textContent ?? ""),
    [selector, pattern.source],
  );

/**
 * Saves a file, as a click does.
 * @param {Page} page
 * @param {string} selector
 * @returns {Promise<{ name: string, bytes: Buffer, text: string }>}
 */
export async function download(page, selector) {
  await reveal(page, selector);
  const [file] = await Promise.all([page.waitForEvent("download"), page.click(selector)]);
  // The browser may be another process's: then the file has no path here.
  const parts = [];
  for await (const part of await file.createReadStream()) parts.push(part);
  const bytes = Buffer.concat(parts);
  return { name: file.suggestedFilename(), bytes, text: bytes.toString() };
}

/** Takes away what a page exports. @param {Page} page @param {string} id */
export const take = (page, id) => download(page, `#export-${id}`);

/**
 * The times of the next five changes of an element, milliseconds of the page's clock. The clock is stopped and then
 * moved by this function alone, so that the times are those the page itself reads, however slow the machine is. It must
 * have been installed before the page opened.
 * @param {Page} page
 * @param {string} selector
 * @param {MutationObserverInit} what
 * @param {() => Promise<unknown>} [begin]  is called while the clock stands
 */
export async function changes(page, selector, what, begin) {
  await page.clock.pauseAt(await page.evaluate(() => Date.now() + 1000));
  const times = await page.locator(selector).evaluateHandle((element, options) => {
    /** @type {number[]} */
    const all = [];
    new MutationObserver(() => all.push(performance.now())).observe(element, options);
    return all;
  }, what);
  await begin?.();
  while ((await times.evaluate(({ length }) => length)) < 5) await page.clock.runFor(20);
  return times.jsonValue();
}

/**
 * Hands a file to the page as if it were picked.
 * @param {Page} page
 * @param {string} name
 * @param {string | Uint8Array} content
 * @param {string} [selector]  of the field
 */
export const pickFile = (page, name, content, selector) => pickFiles(page, { [name]: content }, selector);

/**
 * Hands files to the page as if they were picked at once.
 * @param {Page} page
 * @param {Record<string, string | Uint8Array>} files  contents by name
 * @param {string} [selector]  of the field
 */
export async function pickFiles(page, files, selector = "#file") {
  const picked = Object.entries(files).map(([name, content]) => ({
    name,
    mimeType: "application/octet-stream",
    buffer: Buffer.from(content),
  }));
  await page.setInputFiles(selector, picked);
}

/** Opens a scenario from a file. @param {Page} page @param {object} document */
export async function openScenario(page, document) {
  await pickFile(page, "own.json", JSON.stringify(document));
  await page.waitForSelector("body[data-scene=file]");
  return atRest(page);
}

/** Drops a file on the page. @param {Page} page @param {string} name @param {string | Uint8Array} content */
export async function dropFile(page, name, content) {
  await page.evaluate(
    ({ fileName, bytes }) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([Uint8Array.from(bytes)], fileName));
      for (const type of ["dragenter", "dragover", "drop"]) {
        document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer: transfer }));
      }
    },
    { fileName: name, bytes: [...Buffer.from(content)] },
  );
}

/** Waits for the next frame but one: what was drawn before is on the screen. @param {Page} page */
export const frames = (page) =>
  page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));

/**
 * Colours as the page computes them: red, green and blue, 0 to 255.
 * @param {Page} page
 * @param {string[]} expressions  of CSS
 */
export const coloursOf = (page, expressions) =>
  page.evaluate(
    (all) =>
      all.map((expression) => {
        const probe = document.createElement("span");
        probe.style.forcedColorAdjust = "none";
        probe.style.color = expression;
        document.body.append(probe);
        const { color } = getComputedStyle(probe);
        probe.remove();
        return (color.match(/[\d.]+/g) ?? []).slice(0, 3).map(Number);
      }),
    expressions,
  );

/**
 * How many pixels of a layer have (nearly) the colour of a custom property.
 * @param {Page} page @param {string} pane @param {LayerName} layer @param {string} property  without its dashes
 */
export async function pixelsOf(page, pane, layer, property) {
  await frames(page);
  const [wanted] = await coloursOf(page, [`var(--${property})`]);
  return page.locator(`#${pane} canvas[data-layer=${layer}]`).evaluate((element, colour) => {
    const { width, height } = /** @type {HTMLCanvasElement} */ (element);
    const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
    context?.drawImage(/** @type {HTMLCanvasElement} */ (element), 0, 0);
    const { data } = /** @type {ImageData} */ (context?.getImageData(0, 0, width, height));
    let count = 0;
    for (let i = 0; i < data.length; i += 4)
      if (data[i + 3] > 200 && colour.every((value, k) => Math.abs(value - data[i + k]) < 12)) count++;
    return count;
  }, wanted);
}

/**
 * How dense the pixels of a layer are, row by row, 0 to 255, and its size.
 * @param {Page} page
 * @param {string} pane
 * @param {LayerName} layer
 */
export async function alphaOf(page, pane, layer) {
  await frames(page);
  const { width, height, text } = await page.locator(`#${pane} canvas[data-layer=${layer}]`).evaluate((element) => {
    const { width, height } = /** @type {HTMLCanvasElement} */ (element);
    const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
    context?.drawImage(/** @type {HTMLCanvasElement} */ (element), 0, 0);
    const { data } = /** @type {ImageData} */ (context?.getImageData(0, 0, width, height));
    const rows = Array.from({ length: height }, (_, y) =>
      String.fromCharCode(...Array.from({ length: width }, (_, x) => data[4 * (y * width + x) + 3])),
    );
    return { width, height, text: btoa(rows.join("")) };
  });
  return { width, height, alpha: Buffer.from(text, "base64") };
}

/**
 * What layers show, as a number for each that differs when a pixel does, and whether it has ink.
 * @param {Page} page @param {string} selector  of canvases
 */
export async function pictureOf(page, selector) {
  await frames(page);
  return page.locator(selector).evaluateAll((elements) =>
    elements.map((element) => {
      const canvas = /** @type {HTMLCanvasElement} */ (element);
      const context = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
      context?.drawImage(canvas, 0, 0);
      const { data } = /** @type {ImageData} */ (context?.getImageData(0, 0, canvas.width, canvas.height));
      let hash = 0x811c9dc5;
      let ink = 0;
      // An empty canvas may have any size.
      new Uint32Array(data.buffer).forEach((pixel, i) => {
        if (pixel === 0) return;
        hash = Math.imul(Math.imul(hash ^ i, 0x01000193) ^ pixel, 0x01000193);
        ink++;
      });
      return `${canvas.dataset.layer} ${hash >>> 0} ${ink}`;
    }),
  );
}

/** What the layers of growth show. @param {Page} page @param {string} pane */
export const growthHash = async (page, pane) =>
  (
    await pictureOf(page, ["edges", "vertices", "marks"].map((name) => `#${pane} canvas[data-layer=${name}]`).join())
  ).join();

/**
 * What axe finds against WCAG 2.2 A and AA, and good practice.
 * @param {Page} page
 * @param {string} [within]  a selector: what is looked at, all of the page by default
 * @returns {Promise<string[]>}
 */
export async function violations(page, within) {
  if (!(await page.evaluate(() => "axe" in window)))
    await page.evaluate(readFileSync(join(root, "node_modules", "axe-core", "axe.min.js"), "utf8"));
  return page.evaluate(async (selector) => {
    // @ts-expect-error axe defines itself
    const { violations: found } = await axe.run(selector ?? document, {
      resultTypes: ["violations"],
      runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"],
    });
    return found.map(
      (/** @type {{ id: string, nodes: { html: string }[] }} */ { id, nodes }) =>
        `${id}: ${nodes.map(({ html }) => html).join(" ")}`,
    );
  }, within);
}

/** Waits until every scene of the gallery has its picture. @param {Page} page */
export async function thumbnails(page) {
  await page.waitForFunction(() =>
    [...document.querySelectorAll(".card canvas")].every(
      (canvas) => ![0, 300].includes(/** @type {HTMLCanvasElement} */ (canvas).width),
    ),
  );
}

/** The worker that plans. @param {Page} page */
export function worker(page) {
  const found = page.workers()[0];
  assert.ok(found, "the page has its worker");
  return found;
}
