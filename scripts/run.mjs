/** Running other programs, with errors that name the command. */
import { spawn, spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";

/** The root of the project, and the working directory of every command. */
export const root = fileURLToPath(new URL("..", import.meta.url));

/** An expected failure whose message says what to do; it is printed without a stack trace. */
export class Problem extends Error {}

/** Variables of the environment besides those of this process. @typedef {Record<string, string | undefined>} Env */

/**
 * Runs a program to its end. Its output goes to standard error, so that standard output is free for results.
 * @param {string} command @param {string[]} args @param {Env} [env]
 * @throws {Problem} if it cannot be started or does not exit with 0
 */
export async function run(command, args, env) {
  const code = await exitCode(command, args, env, ["ignore", 2, 2]);
  if (code !== 0) throw new Problem(`\`${[command, ...args].join(" ")}\` failed (exit code ${code}).`);
}

/**
 * Runs a program to its end and returns its output, which is printed as well if it `isLive`.
 * @param {string} command
 * @param {string[]} args
 * @param {Env | undefined} env
 * @param {boolean} isLive
 */
export async function watch(command, args, env, isLive) {
  let output = "";
  const code = await exitCode(command, args, env, ["ignore", "pipe", "pipe"], (text) => {
    output += text;
    if (isLive) process.stdout.write(text);
  });
  return { code, output };
}

/**
 * The standard output of a short command, or undefined if it cannot be run or fails.
 * @param {string} command
 * @param {string[]} args
 */
export function ask(command, args) {
  const { status, stdout } = spawnSync(command, args, { cwd: root, encoding: "utf8", maxBuffer: 256 * 1024 * 1024 });
  return status === 0 ? stdout.trim() : undefined;
}

/**
 * @param {string} command
 * @param {string[]} args
 * @param {Env | undefined} env
 * @param {import("node:child_process").StdioOptions} stdio
 * @param {(text: string) => void} [listen]
 * @returns {Promise<number>}
 */
function exitCode(command, args, env, stdio, listen) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { cwd: root, env: { ...process.env, ...env }, stdio });
    for (const stream of [child.stdout, child.stderr]) {
      stream?.setEncoding("utf8").on("data", (text) => listen?.(text));
    }
    child.on("error", (error) => reject(new Problem(`\`${command}\` cannot be started: ${error.message}`)));
    child.on("close", (code, signal) => resolve(code ?? (signal === null ? 1 : 128)));
  });
}

/**
 * Runs the main function of a script. A `Problem` is printed as its message, any other error with its stack trace; both
 * exit with 1.
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

/** Whether a module is the program that Node was started with. @param {string} url  its `import.meta.url` */
export function isMain(url) {
  return process.argv[1] !== undefined && fileURLToPath(url) === process.argv[1];
}
