/** The same bits everywhere: the golden outcomes by the package in Node, in Chromium, and in a worker there. */
import assert from "node:assert/strict";
import { cpSync, readFileSync, readdirSync } from "node:fs";
import { basename, join } from "node:path";
import { test } from "node:test";
import * as light from "planarium";
import * as full from "planarium/full";
import { chromium } from "playwright-core";
import { root } from "../../scripts/run.mjs";
import { serve } from "../../scripts/serve.mjs";
import { ensureBrowser } from "../../scripts/setup.mjs";
import { outcomes } from "./golden.mjs";
import { addFiles, emptyFolder } from "./packed.mjs";

/** Cases with their outcomes. @param {string} name @returns {any[]} */
const golden = (name) => JSON.parse(readFileSync(join(root, "tests", `${name}.json`), "utf8"));

const place = join(root, "www", "scenes");
const scenes = Object.fromEntries(
  readdirSync(place)
    .filter((name) => name.endsWith(".json"))
    .map((name) => [basename(name, ".json"), readFileSync(join(place, name), "utf8")]),
);
const lists = [
  "golden",
  "golden-neighbours",
  "golden-trajectories",
  "golden-ik",
  "golden-certificates",
  "golden-custom",
  "golden-timing",
].map(golden);
const [plans, neighbours, trajectories, reaches, certificates, customs, timings] = lists;
const cases = { plans, neighbours, trajectories, reaches, certificates, customs, timings, scenes };
/** What only the full core has. */
const ofFull = [trajectories, reaches, timings];
const expected = lists.map((some) => some.map(({ outcome }) => outcome));

test("golden outcomes in Node", () => {
  [110, 24, 10, 30, 4, 14, 14].forEach((least, i) => assert.ok(lists[i].length >= least));
  assert.deepEqual(outcomes(full, cases), expected);
});

test("golden outcomes in Node of what the light core has", () => {
  const core = /** @type {any} */ ({ ...light, Trajectories: full.Trajectories });
  const found = outcomes(core, { ...cases, trajectories: [], reaches: [], timings: [] });
  assert.deepEqual(
    found,
    expected.map((outcome, i) => (ofFull.includes(lists[i]) ? [] : outcome)),
  );
});

test("golden outcomes in Chromium, on the page and in a worker, without special headers", async () => {
  const site = emptyFolder();
  cpSync(join(root, "dist", "package"), join(site, "package"), { recursive: true });
  cpSync(join(root, "tests", "package", "golden.mjs"), join(site, "golden.mjs"));
  addFiles(site, {
    "input.json": JSON.stringify(cases),
    "run.mjs": `
import init, * as planarium from "./package/full/full.js";
import { outcomes } from "./golden.mjs";
export async function run() {
  const cases = await (await fetch("./input.json")).json();
  await init();
  return outcomes(planarium, cases);
}`,
    "worker.mjs": `import { run } from "./run.mjs"; run().then((found) => postMessage(found));`,
    "index.html": "<!doctype html><title>golden</title>",
  });
  const server = await serve({ root: site, port: 0 });
  const browser = await chromium.launch({ executablePath: (await ensureBrowser()).chromium, args: ["--no-sandbox"] });
  try {
    const page = await browser.newPage();
    await page.goto(server.url);
    const onPage = await page.evaluate(`import("./run.mjs").then(({ run }) => run())`);
    assert.deepEqual(onPage, expected);
    const inWorker = await page.evaluate(`new Promise((resolve, reject) => {
      const worker = new Worker("./worker.mjs", { type: "module" });
      worker.onmessage = ({ data }) => resolve(data);
      worker.onerror = ({ message }) => reject(new Error(message));
    })`);
    assert.deepEqual(inWorker, expected);
    assert.equal(await page.evaluate("crossOriginIsolated"), false);
  } finally {
    await browser.close();
    await server.close();
  }
});
