/**
 * `npm run compat`: drives the packed package in an empty project of every toolchain, each installed from npm, and
 * prints a table. `npm run compat -- Vite Rollup` drives those whose names contain one of the words; `--full` has them
 * import `planarium/full`; `--write` writes docs/toolchains.md; `--keep` keeps the projects.
 */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { isDeepStrictEqual } from "node:util";
import { chromium } from "playwright-core";
import { Problem, ask, isMain, root, script } from "../scripts/run.mjs";
import { serve } from "../scripts/serve.mjs";
import { ensureBrowser } from "../scripts/setup.mjs";
import { addFiles, pack } from "../tests/package/packed.mjs";
import { CASE, PROGRAM, VERSIONS, toolchains, withFull } from "./toolchains.mjs";

/** @import { Toolchain } from "./toolchains.mjs" */

/**
 * What the two entries of the package gave: the golden fingerprint, or what went wrong; null where there is nothing to
 * drive.
 * @typedef {{ core: string, worker: string | null }} Found
 */
/** @typedef {{ toolchain: Toolchain, found: Found, log: string }} Outcome */

/** Milliseconds that one toolchain may take. */
const LIMIT = 180_000;
const GOLDEN = goldenOf(CASE);
/** @type {Record<string, string>} */
const versions = { ...VERSIONS, ...JSON.parse(readFileSync(join(root, "package.json"), "utf8")).devDependencies };

/** The name of a package, without the version that tells two keys of `VERSIONS` apart. @param {string} key */
const nameOf = (key) => key.replace(/(?<=.)@.*/, "");

/** The fingerprint that the native tests have for a case. @param {object} wanted @returns {string} */
function goldenOf(wanted) {
  /** @type {any[]} */
  const cases = JSON.parse(readFileSync(join(root, "tests", "golden.json"), "utf8"));
  const found = cases.find(({ outcome, ...given }) => isDeepStrictEqual(given, wanted));
  if (found === undefined) throw new Problem("tests/golden.json does not have the case.");
  return found.outcome.fingerprint;
}

/**
 * Makes the project of a toolchain, builds and drives it.
 * @param {Toolchain} toolchain @param {string} tarball
 * @param {{ isLinked?: boolean, isKept?: boolean }} [options]  `isLinked`: the toolchain is that of this project's own
 *   development tools, nothing is fetched
 * @returns {Promise<Outcome>}
 */
export async function drive(toolchain, tarball, { isLinked = false, isKept = false } = {}) {
  const folder = mkdtempSync(join(tmpdir(), "planarium-compat-"));
  const { packages, files, build = [] } = toolchain;
  const project = new Project(folder, isLinked ? [join(root, "node_modules")] : []);
  const found = (async () => {
    addFiles(folder, { "package.json": JSON.stringify({ private: true, type: "module" }), ...files });
    const fetched = isLinked ? ["--offline"] : packages.map((key) => `${nameOf(key)}@${versions[key]}`);
    await project.run(["npm install --no-audit --no-fund", tarball, ...fetched].join(" "));
    if (isLinked)
      for (const name of packages) symlinkSync(join(root, "node_modules", name), join(folder, "node_modules", name));
    for (const command of build) await project.run(command);
    return foundBy(toolchain, project);
  })();
  try {
    const failure = (/** @type {unknown} */ error) => ({
      core: error instanceof Error ? error.message : String(error),
      worker: null,
    });
    return { toolchain, found: await found.catch(failure), log: project.log };
  } finally {
    await project.stop();
    if (!isKept) rmSync(folder, { recursive: true, force: true });
    else console.error(`${toolchain.name}: ${folder}`);
  }
}

/** A project's folder, and the programs that run in it. */
class Project {
  /** What the programs have printed. */
  log = "";
  /** @type {import("node:child_process").ChildProcess[]} */
  #servers = [];

  /**
   * @param {string} folder
   * @param {string[]} modules   further folders of installed packages, whose programs it may run
   */
  constructor(folder, modules) {
    this.folder = folder;
    // The settings of npm that runs this script are not those of the project.
    const own = Object.entries(process.env).filter(([name]) => !name.startsWith("npm_"));
    const programs = [join(folder, "node_modules"), ...modules].map((place) => join(place, ".bin"));
    /** @type {NodeJS.ProcessEnv} */
    this.env = {
      ...Object.fromEntries(own),
      PATH: [...programs, process.env.PATH].join(delimiter),
      NO_COLOR: "1",
      CI: "1",
    };
  }

  /** @param {string} command @param {Record<string, string>} [more] */
  #start(command, more) {
    const child = spawn("sh", ["-c", command], {
      cwd: this.folder,
      env: { ...this.env, ...more },
      stdio: ["ignore", "pipe", "pipe"],
      detached: true,
    });
    for (const stream of [child.stdout, child.stderr])
      stream.setEncoding("utf8").on("data", (text) => {
        this.log += text;
      });
    return child;
  }

  /**
   * Runs a command to its end.
   * @param {string} command
   * @returns {Promise<string>} what it printed on standard output
   */
  async run(command) {
    const child = this.#start(command);
    let output = "";
    child.stdout.on("data", (text) => {
      output += text;
    });
    const timer = setTimeout(() => endGroup(child), LIMIT);
    const [code] = await once(child, "close");
    clearTimeout(timer);
    if (code !== 0) throw new Problem(`\`${command.split(" ")[0]}\` failed: ${lastLine(this.log)}`);
    return output;
  }

  /** Starts a server, and returns its address once it responds. @param {string} command @returns {Promise<string>} */
  async serve(command) {
    const probe = createServer().listen(0, "127.0.0.1");
    await once(probe, "listening");
    const { port } = /** @type {import("node:net").AddressInfo} */ (probe.address());
    await once(probe.close(), "close");
    const child = this.#start(command, { PORT: String(port) });
    this.#servers.push(child);
    const url = `http://127.0.0.1:${port}/`;
    for (const until = Date.now() + LIMIT; ;) {
      if (
        await fetch(url).then(
          () => true,
          () => false,
        )
      )
        return url;
      if (child.exitCode !== null || Date.now() > until)
        throw new Problem(`\`${command.split(" ")[0]}\` does not serve: ${lastLine(this.log)}`);
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
  }

  async stop() {
    for (const child of this.#servers) {
      const closed = child.exitCode === null && once(child, "close");
      endGroup(child);
      await closed;
    }
  }
}

/** Ends a command with the programs that it has started. @param {import("node:child_process").ChildProcess} child */
function endGroup({ pid, exitCode }) {
  if (pid !== undefined && exitCode === null) process.kill(-pid, "SIGKILL");
}

/** @param {string} text */
const lastLine = (text) =>
  text
    .trim()
    .split("\n")
    .filter((line) => /error|cannot|fail/i.test(line))
    .at(-1)
    ?.trim() ??
  text.trim().split("\n").at(-1) ??
  "";

/** Drives what was built. @param {Toolchain} toolchain @param {Project} project @returns {Promise<Found>} */
async function foundBy({ drive: how }, project) {
  // The build was the check.
  if ("typesOnly" in how) return { core: GOLDEN, worker: GOLDEN };
  if ("command" in how) return JSON.parse(await project.run(how.command));
  if ("page" in how) {
    const server = await serve({ root: join(project.folder, how.page), port: 0 });
    return await onPage(server.url, project).finally(server.close);
  }
  const url = await project.serve(how.server);
  return how.isPage ? onPage(url, project) : /** @type {Promise<Found>} */ ((await fetch(url)).json());
}

/** What a page has found. @param {string} url @param {Project} project @returns {Promise<Found>} */
async function onPage(url, project) {
  const browser = await chromium.launch({ executablePath: (await ensureBrowser()).chromium, args: ["--no-sandbox"] });
  try {
    const page = await browser.newPage();
    page.on("console", (message) => {
      project.log += `console: ${message.text()}\n`;
    });
    page.on("pageerror", (error) => {
      project.log += `page error: ${error.message}\n`;
    });
    page.on("requestfailed", (request) => {
      project.log += `request failed: ${request.url()}\n`;
    });
    await page.goto(url);
    const found = await page
      .waitForFunction(() => /** @type {any} */ (globalThis).found, null, { timeout: 60_000 })
      .catch(() => null);
    if (found === null) throw new Problem(`the page does not end: ${lastLine(project.log)}`);
    return await found.jsonValue();
  } finally {
    await browser.close();
  }
}

/** @param {string | null} found */
const cell = (found) => (found === null ? "–" : found === GOLDEN ? "works" : `fails: ${found}`);

/** Whether a toolchain did all that it should. @param {Outcome} outcome */
export const isGreen = ({ found: { core, worker } }) => core === GOLDEN && (worker === null || worker === GOLDEN);

/** What the docs show of each toolchain: what was built with, and nothing else. */
export function recipes() {
  const kinds = /** @type {Record<string, string>} */ ({ js: "javascript", json: "jsonc", capnp: "text" });
  const block = (/** @type {string} */ kind, /** @type {string} */ text) =>
    `\`\`\`${kinds[kind] ?? kind}\n${text.trim()}\n\`\`\`\n`;
  const sections = toolchains.map(({ name, files, shown = [], build = [], drive: how }) => {
    const command = "command" in how ? how.command : "server" in how ? how.server : "";
    const commands = [...build, command].filter((line) => line !== "").join("\n");
    const parts = [
      ...shown.map((file) => `\`${file}\`:\n\n${block(file.split(".").at(-1) ?? "", files[file])}`),
      ...(commands === "" ? [] : [block("text", commands)]),
    ];
    return parts.length === 0 ? "" : `### ${name}\n\n${parts.join("\n")}`;
  });
  return `## The program\n\n\`plan.js\`:\n\n${block("js", PROGRAM)}\n## What each needs\n\n${sections.filter((text) => text !== "").join("\n")}`;
}

/** The versions of a toolchain. @param {Toolchain} toolchain @returns {string} */
export const versionsOf = ({ packages }) => packages.map((key) => `${nameOf(key)} ${versions[key]}`).join(", ") || "–";

/** The page of the docs. @param {Outcome[]} outcomes @param {string} browser */
function documentOf(outcomes, browser) {
  const rows = outcomes.map(({ toolchain, found: { core, worker } }) =>
    `| ${toolchain.name} | ${versionsOf(toolchain)} | ${toolchain.driven} | ${cell(core)} | ${toolchain.note ?? cell(worker)} |`.replaceAll(
      "\n",
      " ",
    ),
  );
  return `# Toolchains

\`npm run compat\` packs the package, installs it with each toolchain from npm into an empty project, builds, and runs the program below: in a process,
or on a page in a browser. "Works" means that the program has planned the bits of the native tests, with \`planarium\` and in a worker with
\`planarium/worker\`. \`npm run compat -- --write\` has written this page, with Node ${process.versions.node} and ${browser}.

| toolchain | versions | driven | \`planarium\` | \`planarium/worker\` |
|---|---|---|---|---|
${rows.join("\n")}

- **Vite before version 8** moves dependencies in development and loses the files beside them; without the setting below \`init\` rejects with
  \`init-failed\`. Its builds need none.
- **Rollup and esbuild** do not follow \`new URL(…, import.meta.url)\`: the script of the worker is an entry of its own, called \`worker-entry.js\`, and
  \`planarium_bg.wasm\` is copied beside it, and for \`planarium/full\` \`full_bg.wasm\` as well.
- **Parcel** reads \`exports\` of packages only if it is told to.
- **A classic worker** cannot load modules by \`importScripts\`, but by \`import()\`. An import map does not apply in workers.
- **workerd** compiles WebAssembly only when a worker is deployed: the module is imported, and passed to \`initSync\`.
- **\`require\`** of ES modules needs Node 20.19, or 22.12 and newer.

${recipes()}`;
}

/** @param {string[]} args */
async function main(args) {
  const isKept = args.includes("--keep");
  const words = args.filter((word) => !word.startsWith("--"));
  const chosen = toolchains.filter(({ name }) => words.length === 0 || words.some((word) => name.includes(word)));
  const isWritten = args.includes("--write");
  const isFull = args.includes("--full");
  if (isWritten && (isFull || words.length > 0)) throw new Problem("`--write` drives all toolchains with planarium.");
  const tarball = pack({ prepack: true });
  /** @type {Outcome[]} */
  const outcomes = [];
  for (const toolchain of chosen) {
    const began = performance.now();
    const outcome = await drive(isFull ? withFull(toolchain) : toolchain, tarball, { isKept });
    outcomes.push(outcome);
    console.log(
      `${toolchain.name.padEnd(36)} ${((performance.now() - began) / 1000).toFixed(1).padStart(6)} s  ${cell(outcome.found.core)} | ${cell(outcome.found.worker)}`,
    );
    if (!isGreen(outcome)) console.log(outcome.log.replace(/^/gm, "    "));
  }
  if (isWritten)
    writeFileSync(
      join(root, "docs", "toolchains.md"),
      documentOf(outcomes, ask((await ensureBrowser()).chromium, ["--version"])?.match(/\w+ [\d.]+/)?.[0] ?? ""),
    );
  if (!outcomes.every(isGreen)) process.exitCode = 1;
}

if (isMain(import.meta.url)) await script(() => main(process.argv.slice(2)));
