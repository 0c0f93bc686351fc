/**
 * `npm test`: installs tools, runs every suite in order, and prints the number of passed tests and the seconds of each.
 * `node scripts/test.mjs rust page` runs only those groups: check, rust, wasm, package, page; or quick, format and
 * native tests.
 *
 * A suite that runs no test, or whose count cannot be parsed, has failed. The last lines of failed suites are repeated
 * above the table.
 */
import { AsyncLocalStorage } from "node:async_hooks";
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { delimiter, join } from "node:path";
import { assembleOneFile, assemblePage, buildPackage } from "./build.mjs";
import { countsOfHarness, countsOfTap } from "./counts.mjs";
import { Problem, root, script, watch } from "./run.mjs";
import { pagePolicy, serve } from "./serve.mjs";
import {
  cargoBin,
  ensureBrowser,
  ensureDask,
  ensureNodeModules,
  ensureRustComponents,
  ensureTestRunner,
  ensureWasmPack,
  ensureWasmTarget,
  requireCompilers,
} from "./setup.mjs";
import { buildSite } from "./site.mjs";

/** @typedef {import("./counts.mjs").Counts} Counts */
/** @typedef {import("./run.mjs").Env} Env */
/**
 * A suite; those of one word `together` that follow each other run at the same time, since each keeps one processor busy.
 * @typedef {{ groups: string[], name: string, together?: string, run: () => Promise<Counts | undefined> }} Suite
 */
/** @typedef {{ name: string, seconds: number, counts: Counts, note: string, output: string }} Result */

const WASM = ["--target", "wasm32-unknown-unknown"];
const NO_WARNINGS = ["--", "-D", "warnings"];

/** What the modules of `planarium`, of `planarium/import` and of `planarium/shortest` are made of. */
const LIGHT = ["--no-default-features", "--features", "bindings"];
const FORMATS = ["-p", "planarium-formats", "--features", "bindings"];
const SHORTEST = ["-p", "planarium-shortest", "--features", "bindings"];

/** The library, the formats, shortest paths of maps, and the command line. */
const CRATES = [
  "-p",
  "planarium",
  "-p",
  "planarium-formats",
  "-p",
  "planarium-shortest",
  "-p",
  "planarium-cli",
  "-p",
  "own-planner",
];

/** The crates that others build on. */
const DOCUMENTED = ["-p", "planarium", "-p", "planarium-formats", "-p", "planarium-shortest"];

/** The tests that `wasm-pack test` runs. */
const SMOKE_TEST = "sampling::";

/** The files that oxfmt formats. */
const JAVASCRIPT = "**/*.{js,mjs,ts}";

/** How many lines of the output of a failed suite are repeated at the end. */
const REPEATED_LINES = 40;

/** How many test files run at a time: a test of a page waits at times, and three keep two processors busy. */
const FILES_AT_A_TIME = 3;

/** The folder of wasm-bindgen's programs. */
let bindgenFolder = "";

/**
 * What the programs of a suite print: at once if it `isLive`, else when the suite has ended. It is repeated if the suite
 * fails.
 * @typedef {{ output: string, isLive: boolean }} Printed
 */
/** @type {AsyncLocalStorage<Printed>} */
const printing = new AsyncLocalStorage();

/** @type {Suite[]} */
const suites = [
  { groups: ["check", "quick"], name: "Rust format", run: () => command("cargo", ["fmt", "--all", "--check"]) },
  {
    groups: ["check"],
    name: "clippy, native",
    run: () =>
      command("cargo", [
        "clippy",
        "--locked",
        "--workspace",
        "--features",
        "parallel,schema",
        "--all-targets",
        ...NO_WARNINGS,
      ]),
  },
  {
    groups: ["check"],
    name: "clippy, wasm32",
    run: () => command("cargo", ["clippy", "--locked", ...WASM, "--lib", "--tests", ...NO_WARNINGS]),
  },
  {
    groups: ["check"],
    name: "clippy, wasm32 without full",
    run: () => command("cargo", ["clippy", "--locked", ...WASM, ...LIGHT, "--lib", ...NO_WARNINGS]),
  },
  {
    groups: ["check"],
    name: "clippy, wasm32, formats",
    run: () => command("cargo", ["clippy", "--locked", ...WASM, ...FORMATS, "--lib", ...NO_WARNINGS]),
  },
  {
    groups: ["check"],
    name: "clippy, wasm32, shortest",
    run: () => command("cargo", ["clippy", "--locked", ...WASM, ...SHORTEST, "--lib", ...NO_WARNINGS]),
  },
  {
    groups: ["check"],
    name: "Rust documentation",
    run: () =>
      command("cargo", ["doc", "--locked", "--no-deps", "--all-features", ...DOCUMENTED], {
        RUSTDOCFLAGS: "-D warnings",
      }),
  },
  {
    groups: ["check"],
    name: "JavaScript format",
    run: () => tool("oxfmt/bin/oxfmt", "--check", JAVASCRIPT),
  },
  {
    groups: ["check"],
    name: "JavaScript lint",
    run: () => tool("oxlint/bin/oxlint", "--deny-warnings"),
  },
  ...["js", "scripts", "www"].map((project) => ({
    groups: ["check"],
    name: `JavaScript types, ${project}`,
    run: () => types(project),
  })),
  {
    groups: ["check"],
    name: "spelling",
    run: () => tool("cspell/bin.mjs", "--no-progress"),
  },
  {
    groups: ["rust", "quick"],
    name: "Rust, native",
    run: () => harness("cargo", ["test", "--locked", ...CRATES, "--all-features"]),
  },
  { groups: ["wasm"], together: "wasm", name: "Rust, in Node", run: () => wasm() },
  {
    groups: ["wasm"],
    together: "wasm",
    name: "Rust, in Chrome",
    run: () => wasm({ WASM_BINDGEN_USE_BROWSER: "1", WASM_BINDGEN_TEST_WEBDRIVER_JSON: webdriverFile() }),
  },
  {
    groups: ["wasm"],
    name: "wasm-pack test --node",
    run: () =>
      harness("wasm-pack", ["test", "--node", "--", "--locked", "--test", "all", "--", SMOKE_TEST], wasmEnvironment()),
  },
  { groups: ["package"], name: "npm package", run: () => nodeTests("package") },
  { groups: ["page"], name: "page, in Chromium", run: () => withBrowser((env) => nodeTests("page", env)) },
];

/**
 * The set-up of each group; each step does nothing if it is already done.
 * @type {Record<string, (() => Promise<unknown>)[]>}
 */
const needs = {
  check: [ensureRustComponents, ensureWasmTarget, buildPackage],
  rust: [async () => requireCompilers(), useDask],
  wasm: [
    ensureWasmTarget,
    async () => {
      bindgenFolder = await ensureTestRunner();
    },
    ensureWasmPack,
    useBrowser,
  ],
  package: [buildPackage, useBrowser],
  page: [
    buildPackage,
    async () => {
      await assemblePage();
      assembleOneFile();
      await buildSite();
    },
    useBrowser,
  ],
};

/** The groups that run by default; `quick` is a part of them. */
const ALL = Object.keys(needs);
needs.quick = [ensureRustComponents];

/**
 * Runs the program of a suite and remembers what it prints.
 * @param {string} program @param {string[]} args @param {Env} [env]
 */
async function observe(program, args, env) {
  const printed = /** @type {Printed} */ (printing.getStore());
  const result = await watch(program, args, env, printed.isLive);
  printed.output = result.output;
  return result;
}

/** Runs a program that counts as one test. @param {string} program @param {string[]} args @param {Env} [env] */
async function command(program, args, env) {
  const { code } = await observe(program, args, env);
  return code === 0 ? { passed: 1, failed: 0 } : { passed: 0, failed: 1 };
}

/** Runs a program of an npm package. @param {string} path  in node_modules @param {string[]} args */
function tool(path, ...args) {
  return command(process.execPath, [join(root, "node_modules", path), ...args]);
}

/**
 * Runs Rust's test harness, natively or in WebAssembly.
 * @param {string} program
 * @param {string[]} args
 * @param {Env} [env]
 */
async function harness(program, args, env) {
  const { code, output } = await observe(program, args, env);
  return withExitCode(countsOfHarness(output), code);
}

/**
 * Runs the tests that are compiled to WebAssembly, in Node or, if the environment says so, in a browser.
 * @param {Env} [env]
 */
function wasm(env) {
  return harness("cargo", ["test", "--locked", ...WASM, "--test", "all"], { ...wasmEnvironment(), ...env });
}

function wasmEnvironment() {
  return {
    PATH: [bindgenFolder, cargoBin, process.env.PATH].join(delimiter),
    CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: "wasm-bindgen-test-runner",
    WASM_BINDGEN_TEST_TIMEOUT: "1800",
    // The default of five seconds is too short to start the driver on a busy machine.
    WASM_BINDGEN_TEST_DRIVER_TIMEOUT: "60",
  };
}

/** Writes the capabilities of webdriver.json with the path of the browser. */
function webdriverFile() {
  const capabilities = JSON.parse(readFileSync(join(root, "webdriver.json"), "utf8"));
  capabilities["goog:chromeOptions"].binary = process.env.CHROMIUM;
  const file = join(root, "dist", "webdriver.json");
  mkdirSync(join(root, "dist"), { recursive: true });
  writeFileSync(file, JSON.stringify(capabilities));
  return file;
}

/** Checks the types of JavaScript with the settings of a folder. @param {string} project */
function types(project) {
  return tool("typescript/bin/tsc", "--noEmit", "-p", project);
}

/**
 * Runs the tests in a folder with Node's test runner.
 * @param {string} folder
 * @param {Env} [env]
 */
async function nodeTests(folder, env) {
  const place = join(root, "tests", folder);
  const files = readdirSync(place)
    .filter((name) => name.endsWith(".test.mjs"))
    .sort();
  if (files.length === 0) return undefined;
  mkdirSync(join(root, "dist"), { recursive: true });
  const report = join(root, "dist", `${folder}-tests.tap`);
  const args = [
    "--test",
    `--test-concurrency=${FILES_AT_A_TIME}`,
    "--test-reporter=spec",
    "--test-reporter-destination=stdout",
    "--test-reporter=tap",
    `--test-reporter-destination=${report}`,
    `--test-reporter=${new URL("slowest.mjs", import.meta.url)}`,
    "--test-reporter-destination=stdout",
    ...files.map((name) => join(place, name)),
  ];
  const { code } = await observe(process.execPath, args, env);
  return withExitCode(countsOfTap(readFileSync(report, "utf8")), code);
}

/**
 * Runs a suite with one browser and one server of the pages for all its files. Should the browser end before the suite,
 * what waits for it fails, files that start later fail at once, and the suite fails with the reason.
 * @param {(env: Env) => Promise<Counts | undefined>} suite
 */
async function withBrowser(suite) {
  const { chromium } = await import("playwright-core");
  const pages = await serve({
    root: join(root, "dist", "page"),
    port: 0,
    policy: pagePolicy(),
    docs: join(root, "dist", "site"),
  });
  const browser = await chromium.launchServer({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox"] });
  let ending = "";
  browser.process().once("exit", (code, signal) => {
    ending ||= `Chromium ended before the tests did (${signal ?? `exit code ${code}`})`;
  });
  try {
    const counts = await suite({ PLANARIUM_BROWSER: browser.wsEndpoint(), PLANARIUM_PAGES: pages.url });
    if (ending !== "") throw new Problem(ending);
    return counts;
  } finally {
    ending = "closed";
    await browser.close();
    await pages.close();
  }
}

/**
 * A program that was aborted may report no failed test: its exit code is one.
 * @param {Counts | undefined} counts
 * @param {number} code
 */
function withExitCode(counts, code) {
  return counts !== undefined && code !== 0 && counts.failed === 0 ? { ...counts, failed: 1 } : counts;
}

/** Finds or installs Dask and passes its Python to the tests of the command line. */
async function useDask() {
  process.env.PLANARIUM_PYTHON = (await ensureDask()) ?? "";
}

/** Finds or installs the browser and passes its path to the suites. */
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
 * Runs one suite. An exception is a failure of that suite only.
 * @param {Suite} suite @param {boolean} isLive  whether its output is printed at once, or at its end
 * @returns {Promise<Result>}
 */
async function runSuite({ name, run }, isLive) {
  const heading = `\n=== ${name} ===`;
  if (isLive) console.log(heading);
  const began = performance.now();
  const printed = { output: "", isLive };
  const { counts, note } = await printing
    .run(printed, run)
    .then(judge, (error) => failure(error instanceof Error ? error.message : String(error)));
  if (!isLive) console.log(`${heading}\n${printed.output}`);
  return { name, seconds: (performance.now() - began) / 1000, counts, note, output: printed.output };
}

/** Suites in their order; those that run at the same time are one batch. @param {Suite[]} chosen */
function batches(chosen) {
  /** @type {Suite[][]} */
  const all = [];
  for (const suite of chosen) {
    const last = all.at(-1);
    if (last && suite.together !== undefined && last[0].together === suite.together) last.push(suite);
    else all.push([suite]);
  }
  return all;
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

/** Fails if Chrome runs another number of tests than Node. @param {Result[]} results */
function compareEngines(results) {
  const [inNode, inChrome] = ["Rust, in Node", "Rust, in Chrome"].map((wanted) =>
    results.find(({ name }) => name === wanted),
  );
  if (inNode === undefined || inChrome === undefined || inNode.counts.passed === inChrome.counts.passed) return;
  inChrome.counts.failed += 1;
  inChrome.note ||= `${inChrome.counts.passed} passed here but ${inNode.counts.passed} in Node`;
}

/** Prints the last lines of every suite that failed. @param {Result[]} results */
function repeatFailures(results) {
  for (const { name, output } of results.filter(({ counts }) => counts.failed > 0)) {
    console.log(
      `\n=== ${name} failed; its last lines ===\n${output.trimEnd().split("\n").slice(-REPEATED_LINES).join("\n")}`,
    );
  }
}

/**
 * Prints the table of suites, set-up first.
 * @param {Result[]} results @param {number} setUp  seconds @param {number} began  when all of it did
 */
function printTable(results, setUp, began) {
  const width = Math.max(...results.map(({ name }) => name.length));
  const row = (/** @type {string} */ name, /** @type {number} */ seconds, /** @type {string} */ counts) =>
    console.log(`${name.padEnd(width)}  ${seconds.toFixed(1).padStart(7)} s  ${counts}`);
  console.log("");
  row("set-up", setUp, "");
  for (const { name, seconds, counts, note } of results) {
    const failed = counts.failed > 0 ? `  ${counts.failed} failed${note === "" ? "" : `: ${note}`}` : "";
    row(name, seconds, `${String(counts.passed).padStart(5)} passed${failed}`);
  }
  row("total", (performance.now() - began) / 1000, "");
}

await script(async () => {
  const groups = process.argv.length > 2 ? process.argv.slice(2) : ALL;
  const unknown = groups.find((group) => !(group in needs));
  if (unknown !== undefined)
    throw new Problem(`There is no group \`${unknown}\` of tests. Groups: ${Object.keys(needs).join(", ")}.`);
  if (!process.env.PLANARIUM_SCENARIOS) {
    console.log("PLANARIUM_SCENARIOS is not set: tests that need that folder of scenarios are skipped.");
  }
  const began = performance.now();
  await prepare(groups);
  const setUp = (performance.now() - began) / 1000;

  const results = [];
  const chosen = suites.filter((one) => one.groups.some((group) => groups.includes(group)));
  for (const batch of batches(chosen))
    results.push(...(await Promise.all(batch.map((suite) => runSuite(suite, batch.length === 1)))));
  compareEngines(results);
  repeatFailures(results);
  printTable(results, setUp, began);
  const passed = results.reduce((sum, { counts }) => sum + counts.passed, 0);
  const failed = results.reduce((sum, { counts }) => sum + counts.failed, 0);
  console.log(`\n${passed} passed, ${failed} failed`);
  if (failed > 0) process.exitCode = 1;
});
