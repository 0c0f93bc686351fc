/**
 * Builds the npm package and the pages:
 *
 *   dist/glue/     wasm-bindgen's output, optimized: a folder for each core
 *   dist/types/    declarations of the package, from the JSDoc types
 *   dist/package/  the files that `npm pack` publishes
 *   dist/page/     the static pages
 *   dist/planarium.html   the planner's page in one file
 *   dist/planarium-experiments.html   the page of experiments in one file
 *
 * `node scripts/build.mjs` builds everything, `node scripts/build.mjs package` only the package.
 */
import { createHash } from "node:crypto";
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { createRequire } from "node:module";
import { homedir } from "node:os";
import { basename, dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import {
  coreDeclarations,
  forJavaScript,
  kindType,
  ofScenarios,
  optionTypes,
  reachable,
  rowsOf,
  tablesOf,
} from "./declarations.mjs";
import { assembleOneFile, assemblePage } from "./page.mjs";
import { Problem, ask, isMain, root, run, script } from "./run.mjs";
import { QUICK_TOOL, ensureNodeModules, ensureWasmTarget, lockedVersion, targetFolder } from "./setup.mjs";

export { assembleOneFile, assemblePage };

/** The modules that hold a core: `planarium/full` has its own copies of them. All others are shared. */
const HOLDERS = [
  "callback",
  "catalogue",
  "core",
  "functions",
  "guard",
  "node",
  "planarium",
  "planarium_glue",
  "runtime",
];

/**
 * A core: a crate compiled with some features, and an entry of the package with modules of its own.
 * @typedef {object} Core
 * @property {string} name  of its WebAssembly
 * @property {string} crate
 * @property {string[]} build  what is asked of cargo; each has a profile, since they would overwrite each other
 * @property {string} profile
 * @property {string[]} optimize  the best trade-off of size and speed among -O2, -O3, -O4, -Os and -Oz; functions of more than
 *   100 instructions that have one caller stay functions: 5 KB less, in the same time
 * @property {string} glue  the name of the script that calls it
 * @property {string} folder  of its modules in the package
 * @property {string[]} held  the modules that lie in its folder
 */
/** @type {Core} */
const LIGHT = {
  name: "planarium",
  crate: "planarium",
  build: ["build", "--lib", "--no-default-features", "--features", "bindings"],
  profile: "light",
  optimize: ["-O3", "-ocimfs", "100"],
  glue: "planarium_glue",
  folder: "",
  held: HOLDERS,
};
/** @type {Core} */
const FULL = {
  ...LIGHT,
  name: "full",
  build: ["build", "--lib"],
  profile: "wasm",
  folder: "full",
  held: [...HOLDERS, "choices", "full", "full-node"],
};
/** @type {Core} */
const IMPORT = {
  name: "import",
  crate: "planarium-formats",
  build: ["rustc", "--lib", "--crate-type", "cdylib", "-p", "planarium-formats", "--features", "bindings"],
  profile: "import",
  optimize: ["-Oz"],
  glue: "import_glue",
  folder: "import",
  held: ["import", "import-node", "import_glue", "runtime", "world"],
};
/** @type {Core} */
const SHORTEST = {
  name: "shortest",
  crate: "planarium-shortest",
  build: ["rustc", "--lib", "--crate-type", "cdylib", "-p", "planarium-shortest", "--features", "bindings"],
  profile: "shortest",
  optimize: ["-O3", "-ocimfs", "100"],
  glue: "shortest_glue",
  folder: "shortest",
  held: ["shortest", "shortest-node", "shortest_glue", "runtime"],
};
/** The cores that plan. */
const PLANNING = [LIGHT, FULL];
/** The cores whose modules have a folder. */
const PLACED = [FULL, IMPORT, SHORTEST];
const CORES = [LIGHT, ...PLACED];

/** What the glue of a core exports, unless all is declared in `core.d.ts`. @type {Map<Core, string>} */
const DECLARED = new Map([
  [
    IMPORT,
    `export declare function readFiles(names: string[], contents: Uint8Array[], options: string): [string, Uint8Array | null];
export declare function readPathFile(name: string, bytes: Uint8Array, options: string): [string, Float64Array];
export declare function writePathFile(numbers: Float64Array, isTimed: boolean, dimension: number | undefined, options: string): Uint8Array;`,
  ],
  [
    SHORTEST,
    `export declare class ShortestMap {
  constructor(coordinates: Float64Array, kinds: Uint8Array, counts: Uint32Array, distance: number, bounds: Float64Array, planar: boolean, manyQueries: boolean);
  readonly tangents: number | undefined;
  query(x: number, y: number, toX: number, toY: number): Float64Array;
  free(): void;
}`,
  ],
]);

const dist = join(root, "dist");
const types = join(dist, "types", "planarium");

/** Where cargo unpacks crates: a folder for each registry. */
const REGISTRIES = join(process.env.CARGO_HOME ?? join(homedir(), ".cargo"), "registry", "src");

/**
 * Hot functions are marked `#[inline]`; with this threshold level 2 is as small as level "s", and plans a seventh
 * faster.
 */
const INLINE_LESS = "-Cllvm-args=-inline-threshold=10";

/** Compiles the crate and assembles the package. */
export async function buildPackage() {
  await ensureNodeModules();
  await ensureWasmTarget();
  requireOneBindgen();
  // The flags of the compiler name the folders of registries: if these came later, all would be compiled again.
  if (!existsSync(REGISTRIES)) await run("cargo", ["fetch", "--locked", "--target", "wasm32-unknown-unknown"]);
  // Linking takes one processor, and most of the time.
  const modules = await Promise.all(CORES.map(compileCrate));
  for (const [i, core] of CORES.entries()) await makeGlue(core, modules[i]);
  PLANNING.forEach(makeCatalogue);
  makeWorldTypes();
  await makeTypes();
  await assemblePackage();
}

/** Fails unless the glue and the crate use the same version of wasm-bindgen: other versions are incompatible. */
function requireOneBindgen() {
  const crate = lockedVersion("wasm-bindgen");
  const tool = lockedVersion("wasm-bindgen-cli-support");
  if (crate !== tool) {
    throw new Problem(
      `wasm-bindgen is ${crate} in the crate but ${tool} in tools/bindgen. Set both to one version in Cargo.toml and tools/bindgen/Cargo.toml.`,
    );
  }
}

/** Where the glue of a core lies. @param {Core} core */
function glueOf({ name }) {
  return join(dist, "glue", name);
}

/** @param {Core} core @returns {Promise<string>} path of the compiled module */
async function compileCrate({ crate, profile, build: [command, ...options] }) {
  // The module must not contain paths of this machine: those of the toolchain and of crates are shortened.
  const toolchain = ask("rustc", ["--print", "sysroot"]) ?? "";
  // Each registry has a folder, whose name is that of its host.
  const registries = existsSync(REGISTRIES)
    ? readdirSync(REGISTRIES).map((name) => [join(REGISTRIES, name), "crates"])
    : [];
  const cut = [...registries, [toolchain, "rust"], [root, "planarium"]];
  const flags = cut.map(([from, to]) => `--remap-path-prefix=${from}=/${to}`);
  // Joined to those of .cargo/config.toml, which the variable RUSTFLAGS would replace.
  const joined = `target.wasm32-unknown-unknown.rustflags=${JSON.stringify([...flags, INLINE_LESS])}`;
  const target = "wasm32-unknown-unknown";
  const settings = ["--config", joined, "--profile", profile, "--target", target, "--locked"];
  await run("cargo", [command, ...options, ...settings]);
  const wasm = join(targetFolder(), target, profile, `${crate.replaceAll("-", "_")}.wasm`);
  // Its list of features has the length of each name before it.
  if (!readFileSync(wasm).includes("+\x07simd128")) {
    throw new Problem("The module was compiled without vector instructions: unset the variable RUSTFLAGS.");
  }
  return wasm;
}

/**
 * Writes the glue and the optimized module, unless they exist for the same input.
 * @param {Core} core
 * @param {string} wasm
 */
async function makeGlue(core, wasm) {
  const [glue, { name, optimize }] = [glueOf(core), core];
  const tool = readFileSync(join(root, "tools", "bindgen", "src", "main.rs"));
  const binaryen = readFileSync(join(root, "node_modules", "binaryen", "package.json"));
  const here = readFileSync(fileURLToPath(import.meta.url));
  const stamp = createHash("sha256")
    .update(readFileSync(wasm))
    .update(tool)
    .update(here)
    .update(binaryen)
    .update(lockedVersion("wasm-bindgen"))
    .digest("hex");
  const stampFile = join(glue, "stamp");
  if (existsSync(stampFile) && readFileSync(stampFile, "utf8") === stamp) return;

  rmSync(glue, { recursive: true, force: true });
  mkdirSync(glue, { recursive: true });
  await run("cargo", [...QUICK_TOOL, "run", "--quiet", "--locked", "-p", "planarium-bindgen", "--", wasm, glue, name]);
  // The entries of the package have the names of the cores, so the generated file gets another one.
  const script = readFileSync(join(glue, `${name}.js`), "utf8").replace(/^\/\* @ts-self-types=.*\*\/\n/, "");
  writeFileSync(join(glue, `${core.glue}.js`), withLoss(script));
  rmSync(join(glue, `${name}.js`));
  renameSync(join(glue, `${name}.d.ts`), join(glue, "declarations.txt"));
  const functions = DECLARED.get(core) ?? `export * from "./core.js";`;
  writeFileSync(
    join(glue, `${core.glue}.d.ts`),
    `${functions}
export declare function initSync(options: { module: BufferSource | WebAssembly.Module }): { memory: WebAssembly.Memory };
export declare function __wbg_reset_state(): void;
export declare function __planarium_lose(): void;
`,
  );

  const module = join(glue, `${name}_bg.wasm`);
  const optimized = join(glue, "optimized.wasm");
  await run(process.execPath, [
    join(root, "node_modules", "binaryen", "bin", "wasm-opt"),
    ...optimize,
    module,
    "-o",
    optimized,
  ]);
  renameSync(optimized, module);
  writeFileSync(stampFile, stamp);
}

/**
 * The glue with a function that declares its instance lost: from then on no finalizer frees a handle into it. Only a
 * fresh instance ends that.
 * @param {string} script
 */
function withLoss(script) {
  const [finalizer, reset] = [/if \(instance === __wbg_instance_id\) wasm\./g, "__wbg_reinit_scheduled = false;\n"];
  const classes = script.split("new FinalizationRegistry(").length - 1;
  if ((script.match(finalizer)?.length ?? 0) !== classes || script.split(`    ${reset}`).length !== 2) {
    throw new Problem("The glue of wasm-bindgen has another form than withLoss in scripts/build.mjs expects.");
  }
  return (
    script
      .replaceAll(finalizer, "if (instance === __wbg_instance_id && !__planarium_is_lost) wasm.")
      .replace(`    ${reset}`, `    ${reset}    __planarium_is_lost = false;\n`) +
    "\nlet __planarium_is_lost = false;\nexport function __planarium_lose() { __planarium_is_lost = true; }\n"
  );
}

/**
 * The catalogue as a module beside the glue: each call gives a fresh copy. And the core, guarded, with its
 * declarations.
 * @param {Core} core
 */
function makeCatalogue(core) {
  const glue = glueOf(core);
  const document = JSON.parse(readFileSync(join(root, "schema", "catalogue.json"), "utf8"));
  const whole = forJavaScript(document);
  const tables = tablesOf(document);
  writeFileSync(join(glue, "tables.js"), tables.script);
  writeFileSync(join(glue, "tables.d.ts"), tables.declarations);
  const catalogue = core === FULL ? whole : ofScenarios(whole);
  const renamed = [
    ...new Set(
      rowsOf(catalogue)
        .filter(({ name, option }) => name !== option)
        .map(({ option }) => option),
    ),
  ];
  // The function has a name, since webpack keeps anonymous defaults that nobody uses.
  writeFileSync(
    join(glue, "catalogue.js"),
    `const text = ${JSON.stringify(JSON.stringify(catalogue))};
export default function catalogue() { return JSON.parse(text); }
export const renamed = ${JSON.stringify(renamed)};
`,
  );
  writeFileSync(
    join(glue, "catalogue.d.ts"),
    `import type { FleetGeneratorInfo, FleetPlannerInfo, GeneratorInfo, IndexInfo, NavigationGeneratorInfo, ParameterInfo, PlannerInfo, ReachMethodInfo } from "./core.js";
declare function catalogue(): { planners: PlannerInfo[], generators: GeneratorInfo[], reach_methods: ReachMethodInfo[], indexes: IndexInfo[], fleet_planners: FleetPlannerInfo[], fleet_generators: FleetGeneratorInfo[], navigation_generators: NavigationGeneratorInfo[], rollouts: ParameterInfo[], training: ParameterInfo[], comparison: ParameterInfo[], trajectories: ParameterInfo[] };
export default catalogue;
export declare const renamed: readonly string[];
`,
  );
  const declarations = coreDeclarations(readFileSync(join(glue, "declarations.txt"), "utf8"));
  writeFileSync(
    join(glue, "core.d.ts"),
    `/// <reference lib="esnext.disposable" preserve="true" />
${readFileSync(join(root, "js", "types.d.ts"), "utf8")}
${kindType(document)}
${optionTypes(whole)}
${declarations}`,
  );
  const names = Array.from(declarations.matchAll(/^export (?:class|function) (\w+)/gm), ([, name]) => name);
  writeFileSync(
    join(glue, "core.js"),
    `import * as glue from "./planarium_glue.js";
import { guarded } from "./guard.js";
export const { ${names.join(", ")} } = guarded(glue);
`,
  );
}

/** The types of `planarium/import`: those of its arguments and results, from the JavaScript part and the crate. */
function makeWorldTypes() {
  const glue = glueOf(IMPORT);
  const own = readFileSync(join(root, "js", "import-types.d.ts"), "utf8");
  const made = coreDeclarations(readFileSync(join(glue, "declarations.txt"), "utf8"));
  // `own` also names scenarios, which it imports from the planning core: they are not declared again.
  const named = reachable(made.replace(/^export function .*\n/gm, ""), [
    "Angles, PathForm, PathReport, WorldOptions, WorldReport",
  ]);
  writeFileSync(join(glue, "world.d.ts"), own + named);
}

/** Checks the JavaScript layer against the generated glue and writes its declarations. */
async function makeTypes() {
  rmSync(types, { recursive: true, force: true });
  await run(process.execPath, [join(root, "node_modules", "typescript", "bin", "tsc"), "-p", "js"]);
  // Those of the core are the same module by two names.
  for (const { name } of PLANNING)
    cpSync(join(dist, "glue", name, "core.d.ts"), join(types, name === FULL.name ? "full.core.d.ts" : "core.d.ts"));
  cpSync(join(glueOf(LIGHT), "tables.d.ts"), join(types, "tables.d.ts"));
  cpSync(join(glueOf(IMPORT), "world.d.ts"), join(types, "world.d.ts"));
  const own = [...declarationsOf(["planarium", ...SHARED_ENTRIES])]
    .filter((name) => name !== "core.d.ts")
    .map((name) => readFileSync(join(types, name), "utf8"));
  own.push(readFileSync(join(root, "js", "types.d.ts"), "utf8"));
  writeFileSync(join(types, "core.d.ts"), reachable(readFileSync(join(types, "core.d.ts"), "utf8"), own));
}

async function assemblePackage() {
  const out = mkdtempSync(join(dist, "package-"));
  for (const core of CORES) {
    const [glue, place] = [glueOf(core), join(out, core.folder)];
    mkdirSync(place, { recursive: true });
    cpSync(join(glue, `${core.name}_bg.wasm`), join(place, `${core.name}_bg.wasm`));
    for (const name of ["catalogue.js", "core.js"].filter((file) => existsSync(join(glue, file))))
      writeFileSync(join(place, name), placed(readFileSync(join(glue, name), "utf8"), core));
    // Nobody reads the generated glue; ours stays as it was written.
    /** @type {typeof import("esbuild")} */
    const { transformSync } = createRequire(import.meta.url)("esbuild");
    const { code } = transformSync(readFileSync(join(glue, `${core.glue}.js`), "utf8"), {
      minify: true,
      format: "esm",
      target: "es2022",
    });
    writeFileSync(join(place, `${core.glue}.js`), code);
  }
  cpSync(join(glueOf(LIGHT), "tables.js"), join(out, "tables.js"));
  const own = PLACED.flatMap(({ held }) => held).filter((name) => !LIGHT.held.includes(name));
  for (const file of readdirSync(join(root, "js"))) {
    const name = basename(file, ".js");
    if (!file.endsWith(".js")) continue;
    const text = readFileSync(join(root, "js", file), "utf8");
    if (!own.includes(name)) writeFileSync(join(out, file), text);
    for (const core of PLACED)
      if (core.held.includes(name)) writeFileSync(join(out, core.folder, file), placed(text, core));
  }
  for (const name of declarationsOf(["planarium", ...SHARED_ENTRIES])) cpSync(join(types, name), join(out, name));
  for (const core of PLACED)
    for (const name of declarationsOf([core.name])) {
      if (!core.held.includes(basename(name, ".d.ts"))) continue;
      const text = readFileSync(join(types, core === FULL && name === "core.d.ts" ? "full.core.d.ts" : name), "utf8");
      writeFileSync(join(out, core.folder, name), placed(text, core));
    }
  const { writeNotices } = await import("./notices.mjs");
  writeNotices(join(out, "THIRD-PARTY-NOTICES.txt"));
  takeOver(out, join(dist, "package"));
}

/**
 * A module as it stands in the folder of a core: shared modules are above it, and its WebAssembly has another name.
 * @param {string} text
 * @param {Core} core
 */
function placed(text, { name, folder, glue, held }) {
  if (folder === "") return text;
  return text
    .replaceAll("./planarium_glue.js", `./${glue}.js`)
    .replace(/((?:from |import\()")\.\/([\w-]+)\.js"/g, (whole, before, module) =>
      held.includes(module) ? whole : `${before}../${module}.js"`,
    )
    .replaceAll("planarium_bg.wasm", `${name}_bg.wasm`);
}

/**
 * Moves a new folder's files into one that may be in use: equal files stay, others go.
 * @param {string} fresh
 * @param {string} place
 */
function takeOver(fresh, place) {
  mkdirSync(place, { recursive: true });
  const filesIn = (/** @type {string} */ folder) =>
    readdirSync(folder, { recursive: true, withFileTypes: true })
      .filter((entry) => entry.isFile())
      .map((entry) => relative(folder, join(entry.parentPath, entry.name)));
  const names = new Set(filesIn(fresh));
  for (const name of names) {
    const [from, to] = [fresh, place].map((folder) => join(folder, name));
    mkdirSync(dirname(to), { recursive: true });
    if (!existsSync(to) || !readFileSync(to).equals(readFileSync(from))) renameSync(from, to);
  }
  for (const name of filesIn(place)) if (!names.has(name)) rmSync(join(place, name));
  rmSync(fresh, { recursive: true });
}

/** The entries that belong to no core. */
const SHARED_ENTRIES = ["draw", "worker", "worker-entry"];

/** The declarations of entries and those that they import, directly or indirectly. @param {string[]} entries */
function declarationsOf(entries) {
  const reached = new Set(entries.map((entry) => `${entry}.d.ts`));
  for (const name of reached) {
    // Comments name modules that only scripts import.
    const text = readFileSync(join(types, name), "utf8").replace(/\/\*[^]*?\*\//g, "");
    for (const match of text.matchAll(/(?:from |import\()"\.\/([\w-]+)\.js"/g)) reached.add(`${match[1]}.d.ts`);
  }
  return reached;
}

if (isMain(import.meta.url)) {
  await script(async () => {
    await buildPackage();
    if (process.argv[2] === "package") return;
    await assemblePage();
    assembleOneFile();
  });
}
