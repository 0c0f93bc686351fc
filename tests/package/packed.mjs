/** The package as users get it: packed into a tarball and installed into an empty folder. */
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { root } from "../../scripts/run.mjs";

/** An empty folder that is removed when the test process ends. */
export function emptyFolder() {
  const folder = mkdtempSync(join(tmpdir(), "planarium-"));
  process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/**
 * Packs the project, and returns the path of the tarball.
 * @param {{ prepack?: boolean }} [options]  is it built first, as npm does?
 */
export function pack({ prepack = false } = {}) {
  const folder = emptyFolder();
  const scripts = prepack ? [] : ["--ignore-scripts"];
  const [{ filename }] = JSON.parse(
    npm(["pack", "--json", "--pack-destination", folder, ...scripts], root).replace(/^[^[]*/, ""),
  );
  return join(folder, filename);
}

/**
 * Packs the project and installs the tarball into an empty project, without a network.
 * @param {Record<string, string>} [files]  further files of the project
 * @param {string} [tarball]
 * @returns {string} the project's folder
 */
export function install(files = {}, tarball = pack()) {
  const folder = emptyFolder();
  writeFileSync(join(folder, "package.json"), JSON.stringify({ name: "consumer", private: true, type: "module" }));
  npm(["install", tarball, "--offline", "--no-audit", "--no-fund"], folder);
  addFiles(folder, files);
  return folder;
}

/** @param {string} folder @param {Record<string, string>} files */
export function addFiles(folder, files) {
  for (const [name, text] of Object.entries(files)) {
    mkdirSync(join(folder, name, ".."), { recursive: true });
    writeFileSync(join(folder, name), text);
  }
}

/** Runs Node in a folder, and returns what it prints as JSON. @param {string[]} args @param {string} [folder] */
export function node(args, folder = root) {
  return JSON.parse(
    execFileSync(process.execPath, args, { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] }),
  );
}

/** @param {string[]} args @param {string} folder */
function npm(args, folder) {
  // npm hands its settings to scripts through the environment; a test under `npm test` must not inherit them.
  const env = Object.fromEntries(Object.entries(process.env).filter(([name]) => !name.startsWith("npm_")));
  return execFileSync("npm", args, { cwd: folder, env, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
}
