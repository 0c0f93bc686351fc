/**
 * A part of `npm run compat` that fetches nothing: toolchains that the project itself has, and those that need none.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";
import { drive, isGreen, recipes, versionsOf } from "../../compat/compat.mjs";
import { toolchains, withFull } from "../../compat/toolchains.mjs";
import { root } from "../../scripts/run.mjs";
import { pack } from "./packed.mjs";

/** @type {string} */
let tarball;
before(() => {
  tarball = pack();
});

const names = [
  "Node, require",
  "Vite, development",
  "Vite, build",
  "esbuild",
  "import map",
  "classic worker",
  "TypeScript, `moduleResolution` node16",
];
const withBoth = ["Node, require", "Vite, build", "esbuild"];
for (const [entry, name] of [
  ...names.map((name) => ["planarium", name]),
  ...withBoth.map((name) => ["planarium/full", name]),
]) {
  test(`${entry} works with ${name}`, async () => {
    const toolchain = toolchains.find((one) => one.name === name);
    assert.ok(toolchain);
    const outcome = await drive(entry === "planarium" ? toolchain : withFull(toolchain), tarball, { isLinked: true });
    assert.ok(isGreen(outcome), `${JSON.stringify(outcome.found)}\n${outcome.log}`);
  });
}

test("docs/toolchains.md has every toolchain with its version, and what was built with", () => {
  const text = readFileSync(join(root, "docs", "toolchains.md"), "utf8");
  for (const toolchain of toolchains)
    assert.ok(
      text.includes(`\n| ${toolchain.name} | ${versionsOf(toolchain)} |`),
      `${toolchain.name}: npm run compat -- --write`,
    );
  assert.ok(text.endsWith(recipes()), "npm run compat -- --write");
});
