/** Chromium and the built page, for the tests of the page: every page opened here is watched for errors and for requests that leave the site. */
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { serve } from "../../scripts/serve.mjs";

export const root = fileURLToPath(new URL("../../", import.meta.url));
export const pageRoot = fileURLToPath(new URL("../../dist/page", import.meta.url));

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").BrowserContextOptions} Options */

/** @type {import("playwright-core").Browser | undefined} */
let browser;
/** @type {Awaited<ReturnType<typeof serve>> | undefined} */
let server;

/** Starts browser and server. Chromium is taken from CHROMIUM or from where Debian puts it. */
export async function start() {
  assert.ok(existsSync(pageRoot), "dist/page is missing: run `npm run build` first");
  server = await serve({ root: pageRoot, port: 0 });
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
}

export async function stop() {
  await browser?.close();
  await server?.close();
}

/**
 * Opens the page in a context of its own, runs a test on it, and holds it to silence: no error on the console, nothing thrown,
 * no request to anywhere else.
 * @param {Options} options  `reducedMotion: "reduce"` opens it paused
 * @param {(page: Page, url: string) => Promise<void>} test
 * @param {{ before?: (page: Page) => Promise<void>, expectErrors?: boolean, path?: string }} [more]  `path`: of the page, its query and fragment
 */
export async function onPage(options, test, { before, expectErrors = false, path = "" } = {}) {
  assert.ok(browser && server, "start() comes first");
  const url = server.url;
  // What the page keeps for later would answer in the place of the files that tests put in its way.
  const context = await browser.newContext({ viewport: { width: 1280, height: 860 }, serviceWorkers: "block", ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(20_000);
  /** @type {string[]} */
  const faults = [];
  page.on("console", (message) => {
    // The tests read canvases back more often than a page would, and keep its files from being kept: both are remarked on.
    const remark = /^(Canvas2D: Multiple readback operations|Service Worker registration blocked by Playwright)/.test(message.text());
    if ((message.type() === "error" || message.type() === "warning") && !remark) faults.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => faults.push(`thrown: ${error.message}`));
  page.on("request", (request) => {
    const { protocol, origin } = new URL(request.url());
    if (protocol !== "data:" && protocol !== "blob:" && origin !== new URL(url).origin) faults.push(`request to ${request.url()}`);
  });
  try {
    await before?.(page);
    await page.goto(url + path);
    await test(page, url);
    if (!expectErrors) assert.deepEqual(faults, []);
  } finally {
    await context.close();
  }
}

/** An empty page in a context of its own. @param {Options} options @param {(page: Page) => Promise<void>} test */
export async function inBrowser(options, test) {
  assert.ok(browser, "start() comes first");
  const context = await browser.newContext({ viewport: { width: 1280, height: 860 }, ...options });
  try {
    await test(await context.newPage());
  } finally {
    await context.close();
  }
}

/**
 * A page that waits at iteration 0.
 * @param {(page: Page, url: string) => Promise<void>} test @param {Options} [options] @param {{ before?: (page: Page) => Promise<void>, expectErrors?: boolean }} [more]
 */
export async function onPausedPage(test, options = {}, more = {}) {
  await onPage({ reducedMotion: "reduce", ...options }, async (page, url) => {
    await page.waitForSelector("#counters[data-settled=true][data-status=running]", { state: "attached" });
    await test(page, url);
  }, more);
}

/** The numbers of the run. @param {Page} page */
export async function counters(page) {
  return page.locator("#counters").evaluate((element) => {
    const { status, phase, iterations, vertices, edges, fingerprint, length } = /** @type {HTMLElement} */ (element).dataset;
    return {
      status: status ?? "", phase: phase ?? "", iterations: Number(iterations), vertices: Number(vertices), edges: Number(edges),
      fingerprint: fingerprint ?? "", length: length === undefined ? NaN : Number(length),
    };
  });
}

/** Waits until all that was ordered is done and drawn. @param {Page} page */
export async function atRest(page) {
  await page.waitForSelector("#counters[data-settled=true]", { timeout: 60_000, state: "attached" });
  return counters(page);
}

/** Runs to the end and waits for it. @param {Page} page */
export async function finish(page) {
  await page.click("#finish");
  const ended = ["solved", "exhausted"].map((status) => `#counters[data-settled=true][data-status=${status}]`).join(", ");
  await page.waitForSelector(ended, { timeout: 60_000, state: "attached" });
  return counters(page);
}

/** Puts a scene on the stage. @param {Page} page @param {string} id */
export async function chooseScene(page, id) {
  await page.locator(`input[name=scene][value=${id}]`).check({ force: true });
  await page.waitForSelector(`body[data-scene=${id}]`);
  await page.waitForSelector("#counters[data-settled=true][data-status=running]", { state: "attached" });
}

/** Types a value into a parameter and leaves the field. @param {Page} page @param {string} name @param {string} value */
export async function setParameter(page, name, value) {
  const field = page.locator(`#parameter-${name}`);
  await field.fill(value);
  await field.blur();
}

/** Hands a file to the page as if it were picked. @param {Page} page @param {string} name @param {string} text */
export async function pickFile(page, name, text) {
  await page.setInputFiles("#file", { name, mimeType: "application/json", buffer: Buffer.from(text) });
}

/** Drops a file on the page. @param {Page} page @param {string} name @param {string} text */
export async function dropFile(page, name, text) {
  await page.evaluate(([fileName, content]) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([content], fileName, { type: "application/json" }));
    for (const type of ["dragenter", "dragover", "drop"]) {
      document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer: transfer }));
    }
  }, [name, text]);
}

/**
 * How many pixels of a layer have (nearly) the colour of a custom property.
 * @param {Page} page @param {string} pane @param {import("../../www/stage/layer.js").LayerName} layer @param {string} property  without its dashes
 */
export async function pixelsOf(page, pane, layer, property) {
  return page.evaluate(([paneId, layerName, name]) => {
    const probe = document.createElement("span");
    probe.style.forcedColorAdjust = "none";
    probe.style.color = `var(--${name})`;
    document.body.append(probe);
    const wanted = (getComputedStyle(probe).color.match(/[\d.]+/g) ?? []).map(Number);
    probe.remove();
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector(`#${paneId} canvas[data-layer=${layerName}]`));
    // The worker draws on it: its pixels are read from a copy.
    const copy = new OffscreenCanvas(canvas.width, canvas.height);
    const context = copy.getContext("2d");
    if (!context) return -1;
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] > 200 && [0, 1, 2].every((k) => Math.abs(data[i + k] - wanted[k]) < 12)) count++;
    }
    return count;
  }, [pane, layer, property]);
}

/**
 * What the layers of growth show, as a number that differs when a pixel does.
 * @param {Page} page @param {string} pane @returns {Promise<string>}
 */
export async function growthHash(page, pane) {
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  return page.evaluate((id) => {
    let hash = 0x811c9dc5;
    let ink = 0;
    for (const name of ["edges", "vertices", "marks"]) {
      const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector(`#${id} canvas[data-layer=${name}]`));
      const context = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
      context?.drawImage(canvas, 0, 0);
      const { data } = /** @type {ImageData} */ (context?.getImageData(0, 0, canvas.width, canvas.height));
      for (const byte of data) {
        hash = Math.imul(hash ^ byte, 0x01000193);
        if (byte > 0) ink++;
      }
    }
    return `${hash >>> 0} ${ink}`;
  }, pane);
}

/**
 * How long the page's own thread and its worker's worked at each of their tasks meanwhile, milliseconds of processor time: unlike
 * the time that has passed, it does not count what else the machine does.
 * @param {Page} page @param {() => Promise<void>} meanwhile
 */
export async function tasks(page, meanwhile) {
  assert.ok(browser, "start() comes first");
  await browser.startTracing(page, { categories: ["disabled-by-default-devtools.timeline", "__metadata"] });
  await meanwhile();
  /** @type {{ traceEvents: { name: string, tid: number, pid: number, tdur?: number, args: { name?: string } }[] }} */
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  const threads = new Map(traceEvents.filter(({ name }) => name === "thread_name").map(({ pid, tid, args }) => [`${pid} ${tid}`, args.name ?? ""]));
  const of = (/** @type {RegExp} */ thread) => traceEvents
    .filter(({ name, pid, tid, tdur }) => /RunTask$/.test(name) && tdur !== undefined && thread.test(threads.get(`${pid} ${tid}`) ?? ""))
    .map(({ tdur }) => (tdur ?? 0) / 1000);
  return { page: of(/^CrRendererMain$/), worker: of(/DedicatedWorker/) };
}

/** What axe finds against WCAG 2.2 A and AA, and good practice. @param {Page} page @returns {Promise<string[]>} */
export async function violations(page) {
  await page.evaluate(readFileSync(join(root, "node_modules", "axe-core", "axe.min.js"), "utf8"));
  return page.evaluate(async () => {
    // @ts-expect-error axe defines itself
    const { violations: found } = await axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"] });
    return found.map((/** @type {{ id: string, nodes: { html: string }[] }} */ { id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" ")}`);
  });
}

/** The worker that plans and draws. @param {Page} page */
export function worker(page) {
  const found = page.workers()[0];
  assert.ok(found, "the page has its worker");
  return found;
}
