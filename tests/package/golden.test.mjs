/** The same bits everywhere: the golden outcomes by the package in Node, in Chromium, and in a worker there. */
import assert from "node:assert/strict";
import { cpSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { test } from "node:test";
import * as planarium from "planarium";
import { chromium } from "playwright-core";
import { root } from "../../scripts/run.mjs";
import { serve } from "../../scripts/serve.mjs";
import { ensureBrowser } from "../../scripts/setup.mjs";
import { outcomes, reachOutcomes, trajectoryOutcomes } from "./golden.mjs";
import { neighboursOf } from "./neighbours.mjs";
import { emptyFolder } from "./packed.mjs";

/** Cases with their outcomes. @param {string} name */
function golden(name) { return JSON.parse(readFileSync(join(root, "tests", `${name}.json`), "utf8")); }

/** @type {import("./golden.mjs").Case[]} */
const cases = golden("golden");
const place = join(root, "www", "scenes");
const scenes = Object.fromEntries(
  readdirSync(place).filter((name) => name.endsWith(".json")).map((name) => [basename(name, ".json"), readFileSync(join(place, name), "utf8")]),
);
/** @type {import("./neighbours.mjs").Case[]} */
const asked = golden("golden-neighbours");
/** @type {import("./golden.mjs").TrajectoryCase[]} */
const tracks = golden("golden-trajectories");
/** @type {import("./golden.mjs").ReachCase[]} */
const reaches = golden("golden-ik");
const expected = [cases, asked, tracks, reaches].map((some) => some.map(({ outcome }) => outcome));

test("golden outcomes in Node", () => {
  assert.ok(cases.length >= 110 && asked.length >= 24 && tracks.length >= 10 && reaches.length >= 30);
  assert.deepEqual([outcomes(planarium, cases, scenes), neighboursOf(planarium, asked, scenes), trajectoryOutcomes(planarium, tracks), reachOutcomes(planarium, reaches)], expected);
});

test("golden outcomes in Chromium, on the page and in a worker, without special headers", async () => {
  const site = emptyFolder();
  cpSync(join(root, "dist", "package"), join(site, "package"), { recursive: true });
  for (const name of ["golden.mjs", "neighbours.mjs"]) cpSync(join(root, "tests", "package", name), join(site, name));
  mkdirSync(join(site, "data"));
  writeFileSync(join(site, "data", "input.json"), JSON.stringify({ cases, asked, tracks, reaches, scenes }));
  writeFileSync(join(site, "run.mjs"), `
import init, * as planarium from "./package/planarium.js";
import { outcomes, reachOutcomes, trajectoryOutcomes } from "./golden.mjs";
import { neighboursOf } from "./neighbours.mjs";
export async function run() {
  const { cases, asked, tracks, reaches, scenes } = await (await fetch("./data/input.json")).json();
  await init();
  return [outcomes(planarium, cases, scenes), neighboursOf(planarium, asked, scenes), trajectoryOutcomes(planarium, tracks), reachOutcomes(planarium, reaches)];
}`);
  writeFileSync(join(site, "worker.mjs"), `import { run } from "./run.mjs"; run().then((answer) => postMessage(answer));`);
  writeFileSync(join(site, "index.html"), "<!doctype html><title>golden</title>");
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
