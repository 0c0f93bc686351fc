/**
 * The tarball in an empty folder: planned with by import, by `require`, and out of a bundle; the same bits each time.
 */
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
  [
    "by require",
    ["--no-warnings", "require.cjs"],
    { "require.cjs": `const { Scenario } = require("planarium");${plan}` },
  ],
  [
    "by require, after an init that resolves at once",
    ["--no-warnings", "init.cjs"],
    {
      "init.cjs": `const { default: init, Scenario } = require("planarium"); init().then(() => { ${plan} });`,
    },
  ],
  [
    "in a worker",
    ["main.mjs"],
    {
      "worker.mjs": imported,
      "main.mjs": `import { Worker } from "node:worker_threads"; new Worker("./worker.mjs");`,
    },
  ],
])) {
  test(`used in Node ${how}`, () => {
    addFiles(folder, files);
    assert.deepEqual(node(args, folder), expected);
  });
}

test("the wasm file, the schema and the manifest can be resolved", () => {
  addFiles(folder, {
    "resolve.mjs": `console.log(JSON.stringify(["planarium_bg.wasm", "full_bg.wasm", "import_bg.wasm", "shortest_bg.wasm", "scenario.schema.json", "package.json"].map((name) => import.meta.resolve("planarium/" + name))))`,
  });
  const urls = node(["resolve.mjs"], folder);
  assert.equal(urls.length, 6);
  for (const url of urls) assert.ok(existsSync(new URL(url)), url);
});

test("inner modules cannot be reached", () => {
  addFiles(folder, {
    "inner.mjs": `import("planarium/dist/package/runtime.js").catch((error) => console.log(JSON.stringify(error.code)))`,
  });
  assert.equal(node(["inner.mjs"], folder), "ERR_PACKAGE_PATH_NOT_EXPORTED");
});

const inlined = `
import init, { Scenario } from "planarium";
import bytes from "planarium/planarium_bg.wasm";
await init({ module_or_path: bytes });${plan}`;

/**
 * Bundles an entry; the glues that it holds are named as the package has them.
 * @param {string} entry
 * @param {string} out  the folder of the bundle
 * @param {import("esbuild").BuildOptions} options
 */
async function bundled(entry, out, options) {
  addFiles(folder, { "entry.mjs": entry });
  const outfile = join(out, "bundle.mjs");
  const { metafile } = await build({
    entryPoints: [join(folder, "entry.mjs")],
    outfile,
    bundle: true,
    format: "esm",
    logLevel: "error",
    metafile: true,
    ...options,
  });
  const glues = Object.keys(metafile?.inputs ?? {}).filter((name) => name.endsWith("glue.js"));
  return { outfile, glues: glues.map((name) => name.replace(/.*dist\/package\//, "")) };
}

for (const [how, entry, options] of /** @type {[string, string, import("esbuild").BuildOptions][]} */ ([
  ["for Node", imported, { platform: "node" }],
  ["for Node, minified", imported, { platform: "node", minify: true }],
  [
    "for browsers, with the bytes inside",
    inlined,
    { platform: "browser", target: "es2022", minify: true, loader: { ".wasm": "binary" } },
  ],
])) {
  test(`bundled by esbuild ${how}`, async () => {
    const out = join(folder, how);
    const { outfile } = await bundled(entry, out, options);
    const wasm = join(folder, "node_modules/planarium/dist/package/planarium_bg.wasm");
    if (!options.loader) copyFileSync(wasm, join(out, "planarium_bg.wasm"));
    assert.deepEqual(node([outfile], folder), expected);
  });
}

test("bundled by esbuild with planarium/full: one core, and that is the other", async () => {
  const out = join(folder, "full");
  const entry = imported.replace('"planarium"', '"planarium/full"');
  const { outfile, glues } = await bundled(entry, out, { platform: "node" });
  assert.deepEqual(glues, ["full/planarium_glue.js"]);
  copyFileSync(join(folder, "node_modules/planarium/dist/package/full/full_bg.wasm"), join(out, "full_bg.wasm"));
  assert.deepEqual(node([outfile], folder), expected);
});

test("planarium and planarium/full side by side: documents pass, objects of one are foreign to the other", () => {
  addFiles(folder, {
    "both.mjs": `
import * as light from "planarium";
import * as full from "planarium/full";
import { PlannerPool } from "planarium/worker";
const code = (call) => { try { return call(); } catch (error) { return [error.code, error instanceof light.PlanariumError]; } };
const made = [light, full].map(({ Scenario }) => Scenario.generate("forest", { links: 2, seed: 4 }));
const pool = new PlannerPool({ workers: 1 });
const options = { algorithm: "prm", samples: 100 };
const found = {
  prints: [light.solve(made[1], options), full.solve(made[0], options), light.solve(made[0], options), await pool.plan(made[1], options)].map((result) => result.fingerprint),
  fleets: ["Fleet" in light, "Fleet" in full, "reach" in made[0], "reach" in made[1]],
  taken: code(() => light.Scenario.prototype.extent.call(made[1])),
  planner: code(() => light.Scenario.parse(made[1].planner(options))),
  lists: [light.planners().length === full.planners().length, light.reachMethods, full.reachMethods().length > 3],
};
pool.terminate();
console.log(JSON.stringify(found));
`,
  });
  const { prints, ...found } = node(["both.mjs"], folder);
  assert.equal(new Set(prints).size, 1);
  assert.deepEqual(found, {
    fleets: [false, true, false, true],
    taken: ["illegal-invocation", true],
    planner: ["wrong-type", true],
    lists: [true, null, true],
  });
});

const world = `[{ name: "a.txt", bytes: new TextEncoder().encode("0 1\\n0 0\\n") }]`;
const report = `then(({ report }) => console.log(JSON.stringify([report.format, report.obstacles.polygons])))`;

test("planarium/import in Node, by import and by require", () => {
  addFiles(folder, {
    "world.mjs": `import { readWorld } from "planarium/import"; readWorld(${world}).${report};`,
    "world.cjs": `require("planarium/import").readWorld(${world}).${report};`,
  });
  for (const args of [["world.mjs"], ["--no-warnings", "world.cjs"]])
    assert.deepEqual(node(args, folder), ["grid", 1], args.join(" "));
});

for (const [how, entry, options] of /** @type {[string, string, import("esbuild").BuildOptions][]} */ ([
  ["for Node", `import { readWorld } from "planarium/import"; readWorld(${world}).${report};`, { platform: "node" }],
  [
    "for browsers, with the bytes inside",
    `import init, { readWorld } from "planarium/import"; import bytes from "planarium/import_bg.wasm";
     await init(bytes); readWorld(${world}).${report};`,
    { platform: "browser", target: "es2022", minify: true, loader: { ".wasm": "binary" } },
  ],
])) {
  test(`planarium/import bundled by esbuild ${how}: its glue alone`, async () => {
    const out = join(folder, "import", how);
    const { outfile, glues } = await bundled(entry, out, options);
    assert.deepEqual(glues, ["import/import_glue.js"]);
    const wasm = join(folder, "node_modules/planarium/dist/package/import/import_bg.wasm");
    if (!options.loader) copyFileSync(wasm, join(out, "import_bg.wasm"));
    assert.deepEqual(node([outfile], folder), ["grid", 1]);
  });
}

const path = `console.log(JSON.stringify(shortestPath([0, 0], [3, 4], { coordinates: "metres" }).properties.length));`;

test("planarium/shortest in Node, by import and by require", () => {
  addFiles(folder, {
    "path.mjs": `import { shortestPath } from "planarium/shortest"; ${path}`,
    "path.cjs": `const { shortestPath } = require("planarium/shortest"); ${path}`,
  });
  for (const args of [["path.mjs"], ["--no-warnings", "path.cjs"]]) assert.equal(node(args, folder), 5, args.join(" "));
});

test("planarium/shortest bundled by esbuild for browsers, with the bytes inside: its glue alone", async () => {
  const entry = `import init, { shortestPath } from "planarium/shortest"; import bytes from "planarium/shortest_bg.wasm";
    await init(bytes); ${path}`;
  const { outfile, glues } = await bundled(entry, join(folder, "shortest"), {
    platform: "browser",
    target: "es2022",
    minify: true,
    loader: { ".wasm": "binary" },
  });
  assert.deepEqual(glues, ["shortest/shortest_glue.js"]);
  assert.equal(node([outfile], folder), 5);
});
