/** The quick starts of the README, run as they stand: npm in the installed tarball, the command line in a shell. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { root } from "../../scripts/run.mjs";
import { targetFolder } from "../../scripts/setup.mjs";
import { addFiles, emptyFolder, install, pack } from "./packed.mjs";

const readme = readFileSync(join(root, "README.md"), "utf8");

/**
 * The blocks of code in a language.
 * @param {string} language
 * @param {number} count  how many there are
 */
function blocks(language, count) {
  const found = Array.from(readme.matchAll(new RegExp(`^\`\`\`${language}\n([^]*?)^\`\`\`$`, "gm")), ([, code]) => code);
  assert.equal(found.length, count, `blocks of ${language}`);
  return found;
}

test("the quick starts of npm plan paths, find neighbours, reach, and add trajectories", () => {
  const folder = install(pack());
  const printed = blocks("js", 5).map((code, i) => {
    addFiles(folder, { [`quick-start-${i}.mjs`]: code });
    return execFileSync(process.execPath, [`quick-start-${i}.mjs`], { cwd: folder, encoding: "utf8" });
  });
  assert.match(printed[0], /^solved \d+\.\d+\n$/);
  assert.match(printed[1], /^(?:solved [1-9]\d* motions\n){2}3\n$/);
  assert.match(printed[2], /^\d+ of 10 by the forest; the tree looked at \d+ of 20000, as far as \d\.\d\d\n$/);
  assert.match(printed[3], /^reached true [1-4]\ntrue \[ [\d.]+, [-\d.e]+ \]\n$/);
  assert.match(printed[4], /^solved 500 \d+\nFloat64Array\(2\) \[ 0\.0996917333733128, 0\.007845909572784495 \]\n$/);
});

test("the quick start of the command line plans a path that is valid", () => {
  const lines = blocks("sh", 1)[0].trim().split("\n");
  // Installing is building and copying: the program that the other tests have built serves, on the PATH of a shell.
  assert.equal(lines.shift(), "cargo install --path . --features cli --quiet");
  execFileSync("cargo", ["test", "--no-run", "--locked", "--quiet", "--features", "cli,schema", "--test", "all"], { cwd: root, stdio: "inherit" });
  const folder = emptyFolder();
  mkdirSync(join(folder, "bin"));
  copyFileSync(join(targetFolder(), "debug", "planarium"), join(folder, "bin", "planarium"));
  const env = { ...process.env, PATH: `${join(folder, "bin")}:${process.env.PATH}` };
  const printed = execFileSync("sh", ["-ec", lines.join("\n")], { cwd: folder, env, encoding: "utf8" });
  assert.match(printed, /valid/);
  assert.match(printed, /rrt-connect/);
  for (const [name, planner] of [["result", "rrt-connect"], ["driven", "rrt-control"]]) {
    const result = JSON.parse(readFileSync(join(folder, `${name}.json`), "utf8"));
    assert.deepEqual([result.status, result.planner], ["solved", planner]);
  }
});

test("the two commands are scripts of the project", () => {
  const { scripts } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  for (const [, name] of readme.matchAll(/\| `npm (\w+)` \|/g)) assert.ok(name in scripts, name);
});
