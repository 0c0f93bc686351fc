/** Running other programs: output goes where it should, and a failure names the command. */
import { spawn, spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";

/** Root of the project; every command runs here. */
export const root = fileURLToPath(new URL("..", import.meta.url));

/** A failure that needs no stack trace: the message says what to do. */
export class Problem extends Error {}

/** @param {string} path @throws {Problem} */
export function requireFile(path) {
  if (!existsSync(path)) throw new Problem(`${path} is missing.`);
}

/**
 * Runs a program to its end, its output on our standard error, so that standard output stays free for results.
 * @param {string} command
 * @param {string[]} args
 * @param {{ env?: Record<string, string | undefined>, cwd?: string }} [options]
 * @returns {Promise<void>}
 * @throws {Problem} when it cannot be started or does not exit with 0
 */
export async function run(command, args, options = {}) {
  const code = await exitCode(command, args, options, ["ignore", 2, 2]);
  if (code !== 0) throw new Problem(`\`${[command, ...args].join(" ")}\` failed (exit code ${code}).`);
}

/**
 * Runs a program to its end, shows its output as it comes and returns it too.
 * @param {string} command
 * @param {string[]} args
 * @param {{ env?: Record<string, string | undefined>, cwd?: string }} [options]
 * @returns {Promise<{ code: number, output: string }>}
 */
export async function watch(command, args, options = {}) {
  let output = "";
  const code = await exitCode(command, args, options, ["ignore", "pipe", "pipe"], (text) => {
    output += text;
    process.stdout.write(text);
  });
  return { code, output };
}

/**
 * Standard output of a short command, or undefined when it cannot be run or fails.
 * @param {string} command
 * @param {string[]} args
 * @returns {string | undefined}
 */
export function ask(command, args) {
  const { status, stdout } = spawnSync(command, args, { cwd: root, encoding: "utf8", maxBuffer: 256 * 1024 * 1024 });
  return status === 0 ? stdout.trim() : undefined;
}

/**
 * @param {string} command
 * @param {string[]} args
 * @param {{ env?: Record<string, string | undefined>, cwd?: string }} options
 * @param {import("node:child_process").StdioOptions} stdio
 * @param {(text: string) => void} [listen]
 * @returns {Promise<number>}
 */
function exitCode(command, args, options, stdio, listen) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { cwd: options.cwd ?? root, env: { ...process.env, ...options.env }, stdio });
    for (const stream of [child.stdout, child.stderr]) {
      stream?.setEncoding("utf8").on("data", (text) => listen?.(text));
    }
    child.on("error", (error) => reject(new Problem(`\`${command}\` cannot be started: ${error.message}`)));
    child.on("close", (code, signal) => resolve(code ?? (signal === null ? 1 : 128)));
  });
}

/**
 * Runs a script's main function: a `Problem` is printed as one sentence, anything else with its trace; both exit with 1.
 * @param {() => Promise<void>} main
 */
export async function script(main) {
  try {
    await main();
  } catch (error) {
    console.error(error instanceof Problem ? `\n${error.message}` : error);
    process.exit(1);
  }
}

/**
 * Whether a module is the program that Node was started with.
 * @param {string} url  its `import.meta.url`
 */
export function isMain(url) {
  return process.argv[1] !== undefined && fileURLToPath(url) === process.argv[1];
}
