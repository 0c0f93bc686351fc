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
import { outcomes, reachOutcomes } from "./golden.mjs";
import { emptyFolder } from "./packed.mjs";

/** @type {import("./golden.mjs").Case[]} */
const cases = JSON.parse(readFileSync(join(root, "tests", "golden.json"), "utf8"));
/** @type {import("./golden.mjs").ReachCase[]} */
const reachCases = JSON.parse(readFileSync(join(root, "tests", "reach-golden.json"), "utf8"));
const place = join(root, "www", "scenes");
const scenes = Object.fromEntries(
  readdirSync(place).filter((name) => name.endsWith(".json")).map((name) => [basename(name, ".json"), readFileSync(join(place, name), "utf8")]),
);
const expected = [...cases, ...reachCases].map(({ outcome }) => outcome);

test("golden outcomes in Node", () => {
  assert.ok(cases.length >= 12);
  assert.ok(reachCases.length >= 30);
  assert.deepEqual([...outcomes(planarium, cases, scenes), ...reachOutcomes(planarium, reachCases)], expected);
});

test("golden outcomes in Chromium, on the page and in a worker, without special headers", async () => {
  const site = emptyFolder();
  cpSync(join(root, "dist", "package"), join(site, "package"), { recursive: true });
  cpSync(join(root, "tests", "package", "golden.mjs"), join(site, "golden.mjs"));
  mkdirSync(join(site, "data"));
  writeFileSync(join(site, "data", "input.json"), JSON.stringify({ cases, reachCases, scenes }));
  writeFileSync(join(site, "run.mjs"), `
import init, * as planarium from "./package/planarium.js";
import { outcomes, reachOutcomes } from "./golden.mjs";
export async function run() {
  const { cases, reachCases, scenes } = await (await fetch("./data/input.json")).json();
  await init();
  return [...outcomes(planarium, cases, scenes), ...reachOutcomes(planarium, reachCases)];
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
