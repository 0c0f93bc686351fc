/** The quick starts of the README, run as they stand: npm in the installed tarball, the command line in a shell. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { ask, root } from "../../scripts/run.mjs";
import { addFiles, emptyFolder, install, pack } from "./packed.mjs";

const readme = readFileSync(join(root, "README.md"), "utf8");

/**
 * The one block of code in a language.
 * @param {string} language
 */
function block(language) {
  const blocks = [...readme.matchAll(new RegExp(`^\`\`\`${language}\n([^]*?)^\`\`\`$`, "gm"))];
  assert.equal(blocks.length, 1, `one block of ${language}`);
  return blocks[0][1];
}

test("the quick start of npm plans a path", () => {
  const folder = install(pack());
  addFiles(folder, { "quick-start.mjs": block("js") });
  const printed = execFileSync(process.execPath, ["quick-start.mjs"], { cwd: folder, encoding: "utf8" });
  assert.match(printed, /^solved \d+\.\d+\n$/);
});

test("the quick start of the command line plans a path that is valid", () => {
  const lines = block("sh").trim().split("\n");
  // Installing is building and copying: the program that the other tests have built serves, on the PATH of a shell.
  assert.equal(lines.shift(), "cargo install --path . --features cli --quiet");
  execFileSync("cargo", ["build", "--locked", "--quiet", "--features", "cli,schema"], { cwd: root, stdio: "inherit" });
  const { target_directory: target } = JSON.parse(ask("cargo", ["metadata", "--format-version", "1", "--no-deps"]) ?? "{}");
  const folder = emptyFolder();
  mkdirSync(join(folder, "bin"));
  copyFileSync(join(target, "debug", "planarium"), join(folder, "bin", "planarium"));
  const env = { ...process.env, PATH: `${join(folder, "bin")}:${process.env.PATH}` };
  const printed = execFileSync("sh", ["-ec", lines.join("\n")], { cwd: folder, env, encoding: "utf8" });
  assert.match(printed, /valid/);
  assert.match(printed, /rrt-connect/);
  assert.equal(JSON.parse(readFileSync(join(folder, "result.json"), "utf8")).status, "solved");
});

test("the two commands are scripts of the project", () => {
  const { scripts } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  for (const [, name] of readme.matchAll(/\| `npm (\w+)` \|/g)) assert.ok(name in scripts, name);
});
