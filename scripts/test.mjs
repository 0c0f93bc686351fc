/**
 * `npm test`: sets up, runs every suite in order and prints how many tests each has passed and how long it took.
 * `node scripts/test.mjs rust page` runs only those groups: check, rust, wasm, package, page; or quick, the native part of them.
 *
 * A suite that runs no test at all, or whose count cannot be read, has failed: silence is not success. Nothing is run twice.
 */
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { delimiter, join } from "node:path";
import { assembleOneFile, assemblePage, buildPackage } from "./build.mjs";
import { countsOfHarness, countsOfTap } from "./counts.mjs";
import { Problem, root, script, watch } from "./run.mjs";
import {
  cargoBin, ensureBrowser, ensureNodeModules, ensureRustComponents, ensureTestRunner, ensureWasmPack, ensureWasmTarget, requireCompilers,
} from "./setup.mjs";

/** @typedef {import("./counts.mjs").Counts} Counts */
/** @typedef {{ groups: string[], name: string, run: () => Promise<Counts | undefined> }} Suite */
/** @typedef {{ name: string, seconds: number, counts: Counts, note: string }} Result */

const WASM = ["--target", "wasm32-unknown-unknown"];
const NO_WARNINGS = ["--", "-D", "warnings"];

/** The module of tests that `wasm-pack test` runs. */
const SMOKE_TEST = "sampling::";

/** Folder of wasm-bindgen's programs. */
let bindgenFolder = "";

/** @type {Suite[]} */
const suites = [
  { groups: ["check", "quick"], name: "Rust format", run: () => command("cargo", ["fmt", "--all", "--check"]) },
  { groups: ["check"], name: "clippy, native", run: () => command("cargo", ["clippy", "--locked", "--workspace", "--features", "cli,schema", "--all-targets", ...NO_WARNINGS]) },
  { groups: ["check"], name: "clippy, wasm32", run: () => command("cargo", ["clippy", "--locked", ...WASM, "--lib", "--tests", ...NO_WARNINGS]) },
  { groups: ["check"], name: "Rust documentation", run: () => command("cargo", ["doc", "--locked", "--no-deps", "--all-features"], { RUSTDOCFLAGS: "-D warnings" }) },
  { groups: ["check"], name: "JavaScript types", run: types },
  { groups: ["rust", "quick"], name: "Rust, native", run: () => harness("cargo", ["test", "--locked", "--features", "cli,schema"]) },
  { groups: ["wasm"], name: "Rust, in Node", run: () => wasm() },
  { groups: ["wasm"], name: "Rust, in Chrome", run: () => wasm({ WASM_BINDGEN_USE_BROWSER: "1", WASM_BINDGEN_TEST_WEBDRIVER_JSON: webdriverFile() }) },
  { groups: ["wasm"], name: "wasm-pack test --node", run: () => harness("wasm-pack", ["test", "--node", "--", "--locked", "--test", "all", "--", SMOKE_TEST], wasmEnvironment()) },
  { groups: ["package"], name: "npm package", run: () => nodeTests("package", 2) },
  { groups: ["page"], name: "page, in Chromium", run: () => nodeTests("page", 1) },
];

/** What each group needs before it runs; each step looks first. @type {Record<string, (() => Promise<unknown>)[]>} */
const needs = {
  check: [ensureRustComponents, ensureWasmTarget, buildPackage],
  rust: [async () => requireCompilers()],
  wasm: [ensureWasmTarget, async () => { bindgenFolder = await ensureTestRunner(); }, ensureWasmPack, useBrowser],
  package: [buildPackage, useBrowser],
  page: [buildPackage, async () => { assemblePage(); assembleOneFile(); }, useBrowser],
};

/** Groups that run when none is named; `quick` repeats a part of them. */
const ALL = Object.keys(needs);
needs.quick = [ensureRustComponents];

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
  return withExitCode(countsOfHarness(output), code);
}

/**
 * Runs the tests that are compiled to WebAssembly, in Node unless the environment names a browser.
 * @param {Record<string, string>} [env]
 */
function wasm(env) {
  return harness("cargo", ["test", "--locked", ...WASM, "--test", "all"], { ...wasmEnvironment(), ...env });
}

function wasmEnvironment() {
  return {
    PATH: [bindgenFolder, cargoBin, process.env.PATH].join(delimiter),
    CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: "wasm-bindgen-test-runner",
    WASM_BINDGEN_TEST_TIMEOUT: "600",
    // A busy machine takes longer than five seconds to start the driver.
    WASM_BINDGEN_TEST_DRIVER_TIMEOUT: "60",
  };
}

/** The capabilities in webdriver.json, with the browser that was found. */
function webdriverFile() {
  const capabilities = JSON.parse(readFileSync(join(root, "webdriver.json"), "utf8"));
  capabilities["goog:chromeOptions"].binary = process.env.CHROMIUM;
  const file = join(root, "dist", "webdriver.json");
  mkdirSync(join(root, "dist"), { recursive: true });
  writeFileSync(file, JSON.stringify(capabilities));
  return file;
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
 * @param {number} concurrency  files that run at a time
 * @returns {Promise<Counts | undefined>}
 */
async function nodeTests(folder, concurrency) {
  const place = join(root, "tests", folder);
  const files = existsSync(place) ? readdirSync(place).filter((name) => name.endsWith(".test.mjs")).sort() : [];
  if (files.length === 0) return undefined;
  mkdirSync(join(root, "dist"), { recursive: true });
  const report = join(root, "dist", `${folder}-tests.tap`);
  const { code } = await watch(process.execPath, [
    "--test", `--test-concurrency=${concurrency}`,
    "--test-reporter=spec", "--test-reporter-destination=stdout",
    "--test-reporter=tap", `--test-reporter-destination=${report}`,
    ...files.map((name) => join(place, name)),
  ]);
  return withExitCode(countsOfTap(readFileSync(report, "utf8")), code);
}

/**
 * A program that stopped half-way may print no failed test: its exit code counts as one.
 * @param {Counts | undefined} counts
 * @param {number} code
 */
function withExitCode(counts, code) {
  return counts !== undefined && code !== 0 && counts.failed === 0 ? { ...counts, failed: 1 } : counts;
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
 * @returns {Promise<Result>}
 */
async function runSuite({ name, run }) {
  console.log(`\n=== ${name} ===`);
  const began = performance.now();
  const { counts, note } = await run().then(judge, (error) => failure(error instanceof Error ? error.message : String(error)));
  return { name, seconds: (performance.now() - began) / 1000, counts, note };
}

/** @param {Counts | undefined} counts */
function judge(counts) {
  if (counts === undefined) return failure("no count of tests was printed");
  return counts.passed + counts.failed === 0 ? failure("no test ran") : { counts, note: "" };
}

/** @param {string} note */
function failure(note) {
  return { counts: { passed: 0, failed: 1 }, note };
}

/** The same tests must run in Node and in Chrome: a runner that silently runs none is caught here. @param {Result[]} results */
function compareEngines(results) {
  const [inNode, inChrome] = ["Rust, in Node", "Rust, in Chrome"].map((wanted) => results.find(({ name }) => name === wanted));
  if (inNode === undefined || inChrome === undefined || inNode.counts.passed === inChrome.counts.passed) return;
  inChrome.counts.failed += 1;
  inChrome.note ||= `${inChrome.counts.passed} passed here but ${inNode.counts.passed} in Node`;
}

/** Prints the table of suites, set-up first. @param {Result[]} results @param {number} setUp  seconds */
function printTable(results, setUp) {
  const width = Math.max(...results.map(({ name }) => name.length));
  const row = (/** @type {string} */ name, /** @type {number} */ seconds, /** @type {string} */ counts) =>
    console.log(`${name.padEnd(width)}  ${seconds.toFixed(1).padStart(7)} s  ${counts}`);
  console.log("");
  row("set-up", setUp, "");
  for (const { name, seconds, counts, note } of results) {
    const failed = counts.failed > 0 ? `  ${counts.failed} failed${note === "" ? "" : `: ${note}`}` : "";
    row(name, seconds, `${String(counts.passed).padStart(5)} passed${failed}`);
  }
  row("in all", results.reduce((sum, { seconds }) => sum + seconds, setUp), "");
}

await script(async () => {
  const groups = process.argv.length > 2 ? process.argv.slice(2) : ALL;
  const unknown = groups.find((group) => !(group in needs));
  if (unknown !== undefined) throw new Problem(`There is no group \`${unknown}\` of tests; there are ${Object.keys(needs).join(", ")}.`);
  if (!process.env.PLANARIUM_SCENARIOS) {
    console.log("PLANARIUM_SCENARIOS is not set: tests on the scenarios of that folder are left out, and say so.");
  }
  const began = performance.now();
  await prepare(groups);
  const setUp = (performance.now() - began) / 1000;

  const results = [];
  for (const suite of suites.filter((one) => one.groups.some((group) => groups.includes(group)))) results.push(await runSuite(suite));
  compareEngines(results);
  printTable(results, setUp);
  const passed = results.reduce((sum, { counts }) => sum + counts.passed, 0);
  const failed = results.reduce((sum, { counts }) => sum + counts.failed, 0);
  console.log(`\n${passed} passed, ${failed} failed`);
  if (failed > 0) process.exitCode = 1;
});
