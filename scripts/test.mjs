/**
 * `npm test`: sets up, runs every suite in order and prints how many tests each has passed.
 * `node scripts/test.mjs rust page` runs only those groups: check, rust, wasm, package, page.
 *
 * A suite that runs no test at all, or whose count cannot be read, has failed: silence is not success. Files of tests of the page
 * with a failure are run once more, one at a time: what passes then was refused by a busy machine, and is named at the end.
 */
import { existsSync, mkdirSync, readFileSync, readdirSync } from "node:fs";
import { basename, delimiter, join } from "node:path";
import { buildPackage } from "./build.mjs";
import { assembleOneFile, assemblePage } from "./page.mjs";
import { countsOfHarness, countsOfTap, failuresOfTap } from "./counts.mjs";
import { Problem, root, script, watch } from "./run.mjs";
import {
  cargoBin, ensureBrowser, ensureNodeModules, ensureRustComponents, ensureWasmBindgen, ensureWasmPack, ensureWasmTarget, requireCompilers,
} from "./setup.mjs";

/** @typedef {import("./counts.mjs").Counts} Counts */
/** @typedef {{ group: string, name: string, run: () => Promise<Counts | undefined> }} Suite */

/** Tests that failed once and passed when they were repeated. @type {string[]} */
const unsteadyTests = [];

/** Files of tests that run side by side: most of them wait for a browser. */
const CONCURRENCY = 2;

const WASM = ["--target", "wasm32-unknown-unknown"];
const NO_WARNINGS = ["--", "-D", "warnings"];

/** @type {Suite[]} */
const suites = [
  { group: "check", name: "Rust format", run: () => command("cargo", ["fmt", "--all", "--check"]) },
  { group: "check", name: "clippy, native", run: () => command("cargo", ["clippy", "--locked", "--workspace", "--all-features", "--all-targets", ...NO_WARNINGS]) },
  { group: "check", name: "clippy, wasm32", run: () => command("cargo", ["clippy", "--locked", ...WASM, "--lib", "--tests", ...NO_WARNINGS]) },
  { group: "check", name: "Rust documentation", run: () => command("cargo", ["doc", "--locked", "--no-deps", "--all-features"], { RUSTDOCFLAGS: "-D warnings" }) },
  { group: "check", name: "JavaScript types", run: types },
  { group: "rust", name: "Rust, native", run: () => harness("cargo", ["test", "--locked", "--features", "cli,schema"]) },
  { group: "wasm", name: "Rust, in Node", run: () => wasmPack(["--node"]) },
  { group: "wasm", name: "Rust, in Chrome", run: () => wasmPack(["--headless", "--chrome"], { WASM_BINDGEN_USE_BROWSER: "1" }) },
  { group: "package", name: "npm package", run: () => nodeTests("package") },
  { group: "page", name: "page, in Chromium", run: () => nodeTests("page", { again: true }) },
];

/** What each group needs before it runs; each step looks first. @type {Record<string, (() => Promise<unknown>)[]>} */
const needs = {
  check: [ensureRustComponents, ensureWasmTarget, buildPackage],
  rust: [async () => requireCompilers()],
  wasm: [ensureWasmTarget, ensureWasmBindgen, ensureWasmPack, useBrowser],
  package: [buildPackage, useBrowser],
  page: [buildPackage, async () => { assemblePage(); assembleOneFile(); }, useBrowser],
};

/**
 * Runs a program that has no tests of its own, and counts as one.
 * @param {string} program
 * @param {string[]} args
 * @param {Record<string, string>} [env]
 */
async function command(program, args, env) {
  const { code } = await watch(program, args, { env });
  return code === 0 ? { passed: 1, failed: 0 } : { passed: 0, failed: 1 };
}

/**
 * Runs Rust's test harness, natively or in WebAssembly.
 * @param {string} program
 * @param {string[]} args
 * @param {Record<string, string>} [env]
 * @returns {Promise<Counts | undefined>}
 */
async function harness(program, args, env) {
  const { code, output } = await watch(program, args, { env });
  const counts = countsOfHarness(output);
  // A program that stopped half-way prints no failed test.
  return counts !== undefined && code !== 0 && counts.failed === 0 ? { ...counts, failed: 1 } : counts;
}

/**
 * @param {string[]} args
 * @param {Record<string, string>} [env]
 */
function wasmPack(args, env) {
  const path = [cargoBin, process.env.PATH].join(delimiter);
  return harness("wasm-pack", ["test", ...args], { PATH: path, WASM_BINDGEN_TEST_TIMEOUT: "600", ...env });
}

/** Checks the types of all JavaScript, by each folder's own settings. */
async function types() {
  const compiler = join(root, "node_modules", "typescript", "bin", "tsc");
  const counts = { passed: 0, failed: 0 };
  for (const project of ["js", "scripts", "www"]) {
    const { code } = await watch(process.execPath, [compiler, "--noEmit", "-p", project]);
    counts[code === 0 ? "passed" : "failed"] += 1;
  }
  return counts;
}

/**
 * Runs the tests in a folder by Node's own test runner.
 * @param {string} folder
 * @param {{ again?: boolean }} [options]  are files with a failure run once more?
 * @returns {Promise<Counts | undefined>}
 */
async function nodeTests(folder, { again = false } = {}) {
  const place = join(root, "tests", folder);
  const files = existsSync(place) ? readdirSync(place).filter((name) => name.endsWith(".test.mjs")).sort() : [];
  if (files.length === 0) return undefined;
  mkdirSync(join(root, "dist"), { recursive: true });
  const report = join(root, "dist", `${folder}-tests.tap`);
  const { counts, failures } = await nodeTest(files.map((name) => join(place, name)), report, CONCURRENCY);
  // Without a place of each failure there is nothing that could be run again.
  if (!again || counts === undefined || failures.length === 0 || counts.failed !== failures.length) return counts;
  const places = [...new Set(failures.map(({ file }) => file))];
  console.log(`\n=== once more, one at a time: ${places.map((file) => basename(file)).join(", ")} ===`);
  const { counts: second, failures: still } = await nodeTest(places, report.replace(".tap", "-again.tap"), 1);
  if (second === undefined) return counts;
  const unsteady = failures.filter(({ file, name }) => !still.some((one) => one.file === file && one.name === name));
  for (const { file, name } of unsteady) unsteadyTests.push(`${basename(file)}: ${name}`);
  return { passed: counts.passed + counts.failed - second.failed, failed: second.failed };
}

/**
 * @param {string[]} files
 * @param {string} report  where the results go, as TAP
 * @param {number} concurrency
 */
async function nodeTest(files, report, concurrency) {
  const { code } = await watch(process.execPath, [
    "--test", `--test-concurrency=${concurrency}`,
    "--test-reporter=spec", "--test-reporter-destination=stdout",
    "--test-reporter=tap", `--test-reporter-destination=${report}`,
    ...files,
  ]);
  const tap = readFileSync(report, "utf8");
  const counts = countsOfTap(tap);
  return { counts: counts !== undefined && code !== 0 && counts.failed === 0 ? { ...counts, failed: 1 } : counts, failures: failuresOfTap(tap) };
}

/** Finds or installs the browser and tells the suites where it is. */
async function useBrowser() {
  const { chromium, chromedriver } = await ensureBrowser();
  process.env.CHROMIUM = chromium;
  process.env.CHROMEDRIVER = chromedriver;
}

/** @param {string[]} groups */
async function prepare(groups) {
  await ensureNodeModules();
  for (const step of new Set(groups.flatMap((group) => needs[group]))) await step();
}

/**
 * Runs one suite; whatever it throws is its failure, and the others still run.
 * @param {Suite} suite
 * @returns {Promise<{ name: string, counts: Counts, note: string }>}
 */
async function runSuite({ name, run }) {
  console.log(`\n=== ${name} ===`);
  try {
    const counts = await run();
    if (counts === undefined) return { name, counts: { passed: 0, failed: 1 }, note: "no count of tests was printed" };
    if (counts.passed + counts.failed === 0) return { name, counts: { passed: 0, failed: 1 }, note: "no test ran" };
    return { name, counts, note: "" };
  } catch (error) {
    return { name, counts: { passed: 0, failed: 1 }, note: error instanceof Error ? error.message : String(error) };
  }
}

/** The same tests must run in Node and in Chrome: a runner that silently runs none is caught here. @param {{ name: string, counts: Counts, note: string }[]} results */
function compareEngines(results) {
  const inNode = results.find(({ name }) => name === "Rust, in Node");
  const inChrome = results.find(({ name }) => name === "Rust, in Chrome");
  if (inNode === undefined || inChrome === undefined || inNode.counts.passed === inChrome.counts.passed) return;
  inChrome.counts.failed += 1;
  inChrome.note ||= `${inChrome.counts.passed} passed here but ${inNode.counts.passed} in Node`;
}

await script(async () => {
  const groups = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(needs);
  const unknown = groups.find((group) => !(group in needs));
  if (unknown !== undefined) throw new Problem(`There is no group \`${unknown}\` of tests; there are ${Object.keys(needs).join(", ")}.`);
  if (!process.env.PLANARIUM_SCENARIOS) {
    console.log("PLANARIUM_SCENARIOS is not set: tests on the scenarios of that folder are left out, and say so.");
  }
  await prepare(groups);

  const results = [];
  for (const suite of suites.filter(({ group }) => groups.includes(group))) results.push(await runSuite(suite));
  compareEngines(results);

  const width = Math.max(...results.map(({ name }) => name.length));
  console.log("");
  for (const { name, counts, note } of results) {
    const failed = counts.failed > 0 ? `  ${counts.failed} failed${note === "" ? "" : `: ${note}`}` : "";
    console.log(`${name.padEnd(width)}  ${String(counts.passed).padStart(5)} passed${failed}`);
  }
  const passed = results.reduce((sum, { counts }) => sum + counts.passed, 0);
  const failed = results.reduce((sum, { counts }) => sum + counts.failed, 0);
  console.log(`\n${passed} passed, ${failed} failed`);
  for (const test of unsteadyTests) console.log(`unsteady, passed the second time: ${test}`);
  if (failed > 0) process.exitCode = 1;
});
