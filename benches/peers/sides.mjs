/** The sides of the comparison: each is a process that waits for jobs, so that they can run in turn. */
import { spawn } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, statSync } from "node:fs";
import { availableParallelism } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";
import { Problem, ask, root, run } from "../../scripts/run.mjs";

/** @typedef {"native" | "node" | "ompl" | "oxmpl"} SideName */

/**
 * @typedef {object} Run  the outcome of one run; times in seconds
 * @property {number} setup  from the world to a new planner
 * @property {number} build
 * @property {number} search
 * @property {boolean} solved
 * @property {number} length
 * @property {number} motions
 * @property {number} vertices
 * @property {number} edges
 */

const peers = join(root, "benches", "peers");
const built = join(root, "target", "peers");

/** How each side is built and started. @type {Record<SideName, (build: boolean) => Promise<string[]>>} */
const makers = { native, node, ompl, oxmpl };

export const sideNames = /** @type {SideName[]} */ (Object.keys(makers));

/** The common core, pinned by `taskset` if available: the last one, which the system uses least. */
export const pinned =
  ask("taskset", ["--version"]) === undefined ? [] : ["taskset", "-c", String(availableParallelism() - 1)];

/**
 * Builds a side and starts it. A peer that cannot be built or started is skipped with a message; a side of our own must
 * work.
 * @param {SideName} name
 * @param {boolean} build  whether to build, or to use the existing build
 * @returns {Promise<Side | undefined>}
 */
export async function startSide(name, build) {
  try {
    const side = new Side(name, await makers[name](build));
    await side.greeted;
    return side;
  } catch (error) {
    if (name === "native" || name === "node") throw error;
    console.error(`\nbench: going on WITHOUT ${name}: ${error instanceof Error ? error.message : error}\n`);
    return undefined;
  }
}

/** The reply of a process that has ended. */
const stopped = JSON.stringify({ error: "its process has stopped" });

export class Side {
  /** @type {((line: string) => void)[]} */
  #waiting = [];
  #hasEnded = false;
  #process;

  /**
   * @param {SideName} name
   * @param {string[]} command
   */
  constructor(name, command) {
    this.name = name;
    this.title = "";
    const [program, ...args] = [...pinned, ...command];
    this.#process = spawn(program, args, { cwd: root, stdio: ["pipe", "pipe", "inherit"] });
    this.greeted = this.#reply().then((reply) => {
      this.title = reply.name;
    });
    createInterface({ input: this.#process.stdout }).on("line", (line) => this.#waiting.shift()?.(line));
    // Requests that are pending when the process ends are answered.
    const end = () => {
      this.#hasEnded = true;
      for (const answer of this.#waiting.splice(0)) answer(stopped);
    };
    this.#process.on("error", end).on("close", end);
    this.#process.stdin.on("error", end);
  }

  /**
   * @param {string} job
   * @returns {Promise<Run[]>}
   */
  async ask(job) {
    return (await this.reply(job)).runs;
  }

  /** All that its program replies. @param {string} job @returns {Promise<any>} */
  async reply(job) {
    const reply = this.#reply();
    this.#process.stdin.write(`${job}\n`);
    return reply;
  }

  stop() {
    this.#process.stdin.end();
  }

  /** @returns {Promise<any>} */
  async #reply() {
    const line = this.#hasEnded
      ? stopped
      : await new Promise((resolve) => {
          this.#waiting.push(resolve);
        });
    const reply = JSON.parse(line);
    if (reply.error !== undefined) throw new Problem(`${this.name}: ${reply.error}`);
    return reply;
  }
}

/** The crate, as `cargo bench` compiles it. @param {boolean} build */
async function native(build) {
  if (build) await run("cargo", ["bench", "--locked", "--bench", "peers", "--no-run"]);
  // The name of the program contains a hash that only Cargo knows.
  const messages = ask("cargo", ["bench", "--locked", "--bench", "peers", "--no-run", "--message-format=json"]) ?? "";
  const artifacts = messages
    .split("\n")
    .filter((line) => line.startsWith("{"))
    .map((line) => JSON.parse(line));
  const program = artifacts.find(({ target, executable }) => target?.name === "peers" && executable)?.executable;
  if (program === undefined) throw new Problem("The native side of the benchmark could not be built.");
  return [program, "--serve"];
}

/** The npm package, in this Node. @param {boolean} build */
async function node(build) {
  if (build) {
    const { buildPackage } = await import("../../scripts/build.mjs");
    await buildPackage();
  }
  return [process.execPath, join(peers, "node.mjs")];
}

/** OMPL as Debian packages it. @param {boolean} build */
async function ompl(build) {
  const program = join(built, "ompl");
  if (build || !existsSync(program)) await compileWithOmpl(join(peers, "ompl", "main.cpp"), program);
  return [program];
}

/** OMPL on the cells of maps; null, with a message, if it cannot be built. @returns {Promise<Side | null>} */
export async function startGridSide() {
  const program = join(built, "ompl-grid");
  try {
    const source = join(root, "benches", "worlds", "ompl.cpp");
    const isCurrent = existsSync(program) && statSync(program).mtimeMs > statSync(source).mtimeMs;
    if (!isCurrent) await compileWithOmpl(source, program);
    const side = new Side("ompl", [program]);
    await side.greeted;
    return side;
  } catch (error) {
    console.error(`\nbench: going on WITHOUT OMPL: ${error instanceof Error ? error.message : error}\n`);
    return null;
  }
}

/** @param {string} source @param {string} program */
async function compileWithOmpl(source, program) {
  const include = ["/usr/include/ompl-1.5", "/usr/include/ompl"].find((folder) =>
    existsSync(join(folder, "ompl", "config.h")),
  );
  if (include === undefined)
    throw new Problem("OMPL's headers are missing. On Debian: sudo apt-get install libompl-dev libeigen3-dev g++");
  if (ask("g++", ["--version"]) === undefined) throw new Problem("g++ is missing. On Debian: sudo apt-get install g++");
  mkdirSync(built, { recursive: true });
  // Like the crate: optimised for the architecture, not for this machine.
  const flags = ["-O3", "-DNDEBUG", "-std=c++17", `-I${include}`, "-isystem", "/usr/include/eigen3"];
  await run("g++", [...flags, source, "-o", program, "-lompl"]);
}

/** OxMPL from Cargo's registry. @param {boolean} build */
async function oxmpl(build) {
  const folder = join(built, "oxmpl");
  const program = join(folder, "release", "planarium-bench-oxmpl");
  if (build || !existsSync(program)) {
    await run("cargo", [
      "build",
      "--release",
      "--locked",
      "--manifest-path",
      join(peers, "oxmpl", "Cargo.toml"),
      "--target-dir",
      folder,
    ]);
  }
  return [program];
}

/**
 * OxMPL's package for JavaScript, from its crate; it is not on npm.
 * @returns {Promise<any>} its module, ready to use
 */
export async function oxmplInJavaScript() {
  const folder = join(built, "oxmpl-js");
  const target = "wasm32-unknown-unknown";
  const wasm = join(folder, target, "release", "oxmpl_js.wasm");
  const glue = join(folder, "glue");
  if (!existsSync(join(glue, "planarium.js"))) {
    await run("cargo", [
      "build",
      "--release",
      "--locked",
      "--manifest-path",
      join(peers, "oxmpl-js", "Cargo.toml"),
      "-p",
      "oxmpl-js",
      "--target",
      target,
      "--target-dir",
      folder,
    ]);
    await run("cargo", ["run", "--quiet", "--locked", "-p", "planarium-bindgen", "--", wasm, glue]);
  }
  const module = await import(pathToFileURL(join(glue, "planarium.js")).href);
  module.initSync({ module: readFileSync(join(glue, "planarium_bg.wasm")) });
  return module;
}
