/**
 * Installs what the build and the tests need beyond rustup, a C linker and Node, unless it exists.
 * `node scripts/setup.mjs` installs everything; `npm start` and `npm test` call what they need.
 */
import { existsSync, readFileSync, statSync } from "node:fs";
import { homedir } from "node:os";
import { delimiter, join } from "node:path";
import { Problem, ask, isMain, root, run, script } from "./run.mjs";

/** The version of wasm-pack that the tests were written with. */
const WASM_PACK = "0.15.1";

/** The version of Dask that the example for clusters is tested with. */
const DASK = "dask[distributed]==2026.8.0";

const WASM_TARGET = "wasm32-unknown-unknown";

/** Settings for tools that run for seconds: only the crates that read and write modules are worth optimizing. */
const optimized = ["walrus", "wasmparser", "wasm-encoder", "gimli", "leb128", "wasm-bindgen-cli-support"];
export const QUICK_TOOL = [
  "debug=0",
  "opt-level=0",
  'package."*".opt-level=0',
  ...optimized.map((crate) => `package.${crate}.opt-level=1`),
].flatMap((setting) => ["--config", `profile.dev.${setting}`]);

/** The folder into which `cargo install` installs programs. */
export const cargoBin = join(process.env.CARGO_HOME ?? join(homedir(), ".cargo"), "bin");

/** Fails unless Cargo and a linker exist; this script cannot install a compiler. */
export function requireCompilers() {
  if (ask("cargo", ["--version"]) === undefined) {
    throw new Problem("`cargo` is missing. Install Rust with rustup: https://rustup.rs");
  }
  if (ask("cc", ["--version"]) === undefined) {
    throw new Problem("A C linker (`cc`) is missing. On Debian or Ubuntu: sudo apt-get install build-essential");
  }
}

/** Installs the npm development tools from the lock file, unless they exist and are no older than it. */
export async function ensureNodeModules() {
  const [major, minor] = process.versions.node.split(".").map(Number);
  // The documentation's builder loads ES modules with `require`.
  if (major < 20 || major === 21 || (major === 20 && minor < 19) || (major === 22 && minor < 12))
    throw new Problem(`Node 20.19, 22.12 or newer is required; this is ${process.versions.node}.`);
  const installed = join(root, "node_modules", ".package-lock.json");
  const lock = join(root, "package-lock.json");
  if (existsSync(installed) && statSync(installed).mtimeMs >= statSync(lock).mtimeMs) return;
  say("installing the npm development tools");
  await run("npm", ["ci", "--ignore-scripts", "--no-audit", "--no-fund"]);
}

/** Adds Rust's WebAssembly target. */
export async function ensureWasmTarget() {
  requireCompilers();
  const sysroot = ask("rustc", ["--print", "sysroot"]) ?? "";
  if (existsSync(join(sysroot, "lib", "rustlib", WASM_TARGET))) return;
  say(`adding the Rust target ${WASM_TARGET}`);
  await run("rustup", ["target", "add", WASM_TARGET]);
}

/** Adds rustfmt and clippy. */
export async function ensureRustComponents() {
  for (const [component, command] of [
    ["rustfmt", "rustfmt"],
    ["clippy", "clippy-driver"],
  ]) {
    if (ask(command, ["--version"]) !== undefined) continue;
    say(`adding ${component}`);
    await run("rustup", ["component", "add", component]);
  }
}

/** Builds wasm-bindgen's command line and test runner in the version of the crate, and returns their folder. */
export async function ensureTestRunner() {
  await run("cargo", [...QUICK_TOOL, "build", "--quiet", "--locked", "-p", "planarium-bindgen", "--features", "tests"]);
  return join(targetFolder(), "debug");
}

/** The target folder of Cargo. */
export function targetFolder() {
  const metadata = ask("cargo", ["metadata", "--format-version", "1", "--no-deps", "--locked"]);
  if (metadata === undefined) throw new Problem("`cargo metadata` failed.");
  return JSON.parse(metadata).target_directory;
}

/** Installs wasm-pack. */
export async function ensureWasmPack() {
  if (ask(join(cargoBin, "wasm-pack"), ["--version"])?.endsWith(` ${WASM_PACK}`)) return;
  say(`installing wasm-pack ${WASM_PACK} (once, takes some minutes)`);
  // It only calls other programs. A build without optimization takes a third of the time.
  await run("cargo", ["install", "wasm-pack", "--version", WASM_PACK, "--force", "--locked", "--debug"], {
    CARGO_PROFILE_DEV_DEBUG: "0",
  });
}

/**
 * A Python with Dask: the one that PLANARIUM_PYTHON names, or one in the target folder. Without one a test is skipped.
 */
export async function ensureDask() {
  if (process.env.PLANARIUM_PYTHON) return process.env.PLANARIUM_PYTHON;
  const folder = join(targetFolder(), "dask");
  const python = join(folder, "bin", "python");
  if (ask(python, ["-c", "import dask.distributed"]) !== undefined) return python;
  say("installing Dask in the target folder");
  try {
    await run("python3", ["-m", "venv", "--clear", folder]);
    await run(python, ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", DASK]);
    return python;
  } catch (error) {
    console.log(
      `Dask cannot be installed, and its test is skipped: ${error instanceof Error ? error.message : String(error)}`,
    );
    return undefined;
  }
}

/**
 * Finds Chromium and its driver, or installs them with apt-get if that is permitted. The headless shell is the fastest
 * browser.
 */
export async function ensureBrowser() {
  const found = findBrowser();
  if (found !== undefined) return found;
  const install = ["apt-get", "install", "-y", "--no-install-recommends", "chromium-headless-shell", "chromium-driver"];
  const byHand = `  sudo ${install.join(" ")}\nor set CHROMIUM and CHROMEDRIVER to the two programs.`;
  const prefix = process.getuid?.() === 0 ? [] : ["sudo", "-n"];
  const mayInstall =
    find("apt-get") !== undefined && (prefix.length === 0 || ask("sudo", ["-n", "true"]) !== undefined);
  if (!mayInstall)
    throw new Problem(`Chromium and chromedriver are missing, and installing them requires root. Run:\n${byHand}`);
  say("installing Chromium and chromedriver");
  for (const line of [["apt-get", "update"], install]) {
    const [command, ...args] = [...prefix, ...line];
    await run(command, args, { DEBIAN_FRONTEND: "noninteractive" });
  }
  const installed = findBrowser();
  if (installed === undefined) throw new Problem(`Chromium and chromedriver are not on the PATH. Run:\n${byHand}`);
  return installed;
}

/** Chromium and its driver, from the variables CHROMIUM and CHROMEDRIVER or from the PATH. */
function findBrowser() {
  const browsers = [
    "chromium-headless-shell",
    "chrome-headless-shell",
    "chromium",
    "chromium-browser",
    "google-chrome-stable",
    "google-chrome",
  ];
  const chromium = process.env.CHROMIUM ?? find(...browsers);
  const chromedriver = process.env.CHROMEDRIVER ?? find("chromedriver");
  return chromium !== undefined && chromedriver !== undefined ? { chromium, chromedriver } : undefined;
}

/** The version of a crate in the lock file. @param {string} crate */
export function lockedVersion(crate) {
  const lock = readFileSync(join(root, "Cargo.lock"), "utf8");
  const versions = [...lock.matchAll(new RegExp(`^name = "${crate}"\nversion = "(.+)"$`, "gm"))].map(
    (match) => match[1],
  );
  if (versions.length !== 1) {
    throw new Problem(
      `Cargo.lock must contain one version of ${crate}, not ${versions.length}: ${versions.join(", ")}`,
    );
  }
  return versions[0];
}

/** The path of the first of these programs that is on the PATH. @param {string[]} programs */
function find(...programs) {
  const folders = (process.env.PATH ?? "").split(delimiter).filter((folder) => folder !== "");
  return programs.flatMap((program) => folders.map((folder) => join(folder, program))).find((path) => existsSync(path));
}

/** @param {string} what */
const say = (what) => console.error(`set-up: ${what}`);

if (isMain(import.meta.url)) {
  await script(async () => {
    await ensureNodeModules();
    await ensureWasmTarget();
    await ensureRustComponents();
    await ensureTestRunner();
    await ensureWasmPack();
    await ensureBrowser();
  });
}
