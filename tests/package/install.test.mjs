/** The tarball in an empty folder: planned with by import, by `require`, and out of a bundle; the same bits each time. */
import assert from "node:assert/strict";
import { copyFileSync, existsSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";
import { build } from "esbuild";
import { Scenario } from "planarium";
import { addFiles, install, node } from "./packed.mjs";
import { disc, finish } from "./scenes.mjs";

/** What each consumer runs once it has `Scenario`. */
const plan = `
const planner = Scenario.parse(${JSON.stringify(disc)}).planner({ seed: 5 });
while (planner.step(100) === "running");
console.log(JSON.stringify({ status: planner.status, fingerprint: planner.fingerprint(), path: [...planner.path()] }));
`;
const imported = `import { Scenario } from "planarium";${plan}`;

/** @type {string} */
let folder;
/** @type {unknown} */
let expected;

before(() => {
  folder = install();
  const planner = finish(Scenario.parse(disc).planner({ seed: 5 }));
  assert.equal(planner.status, "solved");
  expected = { status: "solved", fingerprint: planner.fingerprint(), path: [...planner.path()] };
});

for (const [how, args, files] of /** @type {[string, string[], Record<string, string>][]} */ ([
  ["by import", ["import.mjs"], { "import.mjs": imported }],
  ["by require", ["--no-warnings", "require.cjs"], { "require.cjs": `const { Scenario } = require("planarium");${plan}` }],
  ["by require, after an init that resolves at once", ["--no-warnings", "init.cjs"], {
    "init.cjs": `const { default: init, Scenario } = require("planarium"); init().then(() => { ${plan} });`,
  }],
  ["in a worker", ["main.mjs"], {
    "worker.mjs": imported, "main.mjs": `import { Worker } from "node:worker_threads"; new Worker("./worker.mjs");`,
  }],
])) {
  test(`used in Node ${how}`, () => {
    addFiles(folder, files);
    assert.deepEqual(node(args, folder), expected);
  });
}

test("the wasm file, the schema and the manifest can be resolved", () => {
  addFiles(folder, {
    "resolve.mjs": `console.log(JSON.stringify(["planarium_bg.wasm", "scenario.schema.json", "package.json"].map((name) => import.meta.resolve("planarium/" + name))))`,
  });
  const urls = node(["resolve.mjs"], folder);
  assert.equal(urls.length, 3);
  for (const url of urls) assert.ok(existsSync(new URL(url)), url);
});

test("inner modules cannot be reached", () => {
  addFiles(folder, { "inner.mjs": `import("planarium/dist/package/runtime.js").catch((error) => console.log(JSON.stringify(error.code)))` });
  assert.equal(node(["inner.mjs"], folder), "ERR_PACKAGE_PATH_NOT_EXPORTED");
});

const inlined = `
import init, { Scenario } from "planarium";
import bytes from "planarium/planarium_bg.wasm";
await init({ module_or_path: bytes });${plan}`;

for (const [how, entry, options] of /** @type {[string, string, import("esbuild").BuildOptions][]} */ ([
  ["for Node", imported, { platform: "node" }],
  ["for Node, minified", imported, { platform: "node", minify: true }],
  ["for browsers, with the bytes inside", inlined, { platform: "browser", target: "es2022", minify: true, loader: { ".wasm": "binary" } }],
])) {
  test(`bundled by esbuild ${how}`, async () => {
    const out = join(folder, how);
    addFiles(folder, { "entry.mjs": entry });
    const outfile = join(out, "bundle.mjs");
    await build({ entryPoints: [join(folder, "entry.mjs")], outfile, bundle: true, format: "esm", logLevel: "error", ...options });
    const wasm = join(folder, "node_modules/planarium/dist/package/planarium_bg.wasm");
    if (!options.loader) copyFileSync(wasm, join(out, "planarium_bg.wasm"));
    assert.deepEqual(node([outfile], folder), expected);
  });
}
