/** The toolchains: what an empty project of each installs, how it is built, and how it is driven. */

/**
 * @typedef {object} Toolchain
 * @property {string} name
 * @property {string[]} packages   keys of `VERSIONS`: what is installed beside the package
 * @property {Record<string, string>} files   of the project
 * @property {string[]} [shown]    files that a user needs besides the program: the docs show them
 * @property {string[]} [build]    commands, run in the project's folder with its programs on the PATH
 * @property {Drive} drive
 * @property {string} driven       what is driven, for the table
 * @property {string} [note]       what a user should know, for the table
 */
/**
 * How a program is run: its output is `{ core, worker }` as JSON, what the two entries of the package have planned.
 * @typedef {{ command: string } | { page: string } | { server: string, isPage: boolean } | { typesOnly: true }} Drive
 *   `command` prints it, `page` is a folder whose index.html sets `found`, `server` is a command that serves such a
 *   page or the output itself on the port PORT; types are only checked
 */

/** Versions; those of packages that the project itself uses are in its package.json. */
export const VERSIONS = {
  "@rollup/plugin-node-resolve": "16.0.3",
  "@sveltejs/vite-plugin-svelte": "7.3.1",
  "@types/node": "20.19.43",
  "@vitejs/plugin-react": "6.3.0",
  bun: "1.4.5",
  deno: "2.9.6",
  parcel: "2.16.4",
  react: "19.3.1",
  "react-dom": "19.3.1",
  rollup: "4.68.7",
  svelte: "5.57.3",
  "typescript@5": "5.9.3",
  "vite@7": "7.3.8",
  webpack: "5.112.2",
  "webpack-cli": "7.3.1",
  workerd: "1.20261117.1",
};

/** A case of tests/golden.json. */
export const CASE = {
  generate: "forest",
  options: { links: 3, seed: 3 },
  planner: "prm",
  seed: 3,
  parameters: { k: 12, metric: "euclidean", samples: 200 },
};
const [generated, options] = [CASE.options, { algorithm: CASE.planner, seed: CASE.seed, ...CASE.parameters }].map(
  (value) =>
    JSON.stringify(value)
      .replace(/"(\w+)":/g, " $1: ")
      .replace("}", " }"),
);

/** Plans here and in a worker. */
export const PROGRAM = `import init, { Scenario } from "planarium";
import { PlannerPool } from "planarium/worker";

export async function plan() {
  await init();
  const options = ${options};
  const scenario = Scenario.generate("${CASE.generate}", ${generated});
  const planner = scenario.planner(options);
  for await (const growth of planner) void growth;
  const pool = new PlannerPool();
  const worker = await pool.plan(scenario, options).then(({ fingerprint }) => fingerprint, String);
  pool.terminate();
  return { core: planner.fingerprint(), worker };
}
`;
const printed = `import { plan } from "./plan.js";
console.log(JSON.stringify(await plan()));
`;
const found = `import { plan } from "./plan.js";
plan().then((found) => { globalThis.found = found; }, (error) => { globalThis.found = { core: String(error), worker: "" }; });
`;
const VITE = "vite --host 127.0.0.1 --port $PORT --strictPort";
/** @param {string} script */
const pageOf = (script) => `<!doctype html>
<title>Planarium</title>
<link rel="icon" href="data:,">
<div id="app"></div>
${script}
`;
const module = pageOf(`<script type="module" src="./main.js"></script>`);
const page = { "plan.js": PROGRAM, "main.js": found, "index.html": module };
const place = "./node_modules/planarium/dist/package";
const direct = PROGRAM.replace(/"planarium"/, `"${place}/planarium.js"`).replace(
  /"planarium\/worker"/,
  `"${place}/worker.js"`,
);

/** @type {Toolchain[]} */
export const toolchains = [
  {
    name: "Node, import",
    packages: [],
    files: { "plan.js": PROGRAM, "main.js": printed },
    drive: { command: "node main.js" },
    driven: "a module",
  },
  {
    name: "Node, require",
    packages: [],
    driven: "a CommonJS script",
    drive: { command: "node --no-warnings main.cjs" },
    files: {
      "main.cjs": `${PROGRAM.replace(/import (?:init, )?(\{.*\}) from (".*");/g, "const $1 = require($2);")
        .replace("export ", "")
        .replace("  await init();\n", "")}
plan().then((found) => console.log(JSON.stringify(found)));
`,
    },
  },
  {
    name: "Deno",
    packages: ["deno"],
    files: { "plan.js": PROGRAM, "main.js": printed },
    driven: "a module",
    drive: { command: "deno run --allow-read main.js" },
  },
  {
    name: "Bun",
    packages: ["bun"],
    files: { "plan.js": PROGRAM, "main.js": printed },
    driven: "a module",
    drive: { command: "bun main.js" },
  },
  {
    name: "Vite, development",
    packages: ["vite"],
    files: page,
    driven: "the page of the server",
    drive: { server: VITE, isPage: true },
  },
  {
    name: "Vite 7, development",
    packages: ["vite@7"],
    driven: "the page of the server",
    drive: { server: VITE, isPage: true },
    shown: ["vite.config.js"],
    files: {
      ...page,
      "vite.config.js": `export default { optimizeDeps: { exclude: ["planarium"] } }; // versions before 8 move the script, and lose the files beside it
`,
    },
  },
  {
    name: "Vite, build",
    packages: ["vite"],
    files: page,
    build: ["vite build"],
    driven: "the built page",
    drive: { page: "dist" },
  },
  {
    name: "webpack",
    packages: ["webpack", "webpack-cli"],
    driven: "the built page",
    drive: { page: "dist" },
    files: { ...page, "index.html": pageOf(`<script src="./main.js"></script>`) },
    build: ["webpack --mode production --entry ./main.js", "cp index.html dist"],
  },
  {
    name: "Rollup",
    packages: ["rollup", "@rollup/plugin-node-resolve"],
    driven: "the built page",
    drive: { page: "dist" },
    shown: ["rollup.config.js"],
    files: {
      ...page,
      "rollup.config.js": `import { nodeResolve } from "@rollup/plugin-node-resolve";

export default {
  input: { main: "./main.js", "worker-entry": "planarium/worker-entry" },
  output: { dir: "dist" },
  plugins: [nodeResolve({ browser: true })],
};
`,
    },
    build: ["rollup --config", "cp index.html node_modules/planarium/dist/package/planarium_bg.wasm dist"],
  },
  {
    name: "Parcel",
    packages: ["parcel"],
    driven: "the built page",
    drive: { page: "dist" },
    shown: ["package.json"],
    files: {
      ...page,
      "package.json": `{
  "type": "module",
  "private": true,
  "@parcel/resolver-default": { "packageExports": true }
}
`,
    },
    build: ["parcel build index.html --public-url ./ --no-cache"],
  },
  {
    name: "esbuild",
    packages: ["esbuild"],
    files: page,
    driven: "the built page",
    drive: { page: "dist" },
    build: [
      "esbuild main.js worker-entry=planarium/worker-entry --bundle --format=esm --minify --outdir=dist",
      "cp index.html node_modules/planarium/dist/package/planarium_bg.wasm dist",
    ],
  },
  {
    name: '`<script type="module">`',
    packages: [],
    files: { ...page, "plan.js": direct },
    driven: "the page, without a bundler",
    drive: { page: "." },
  },
  {
    name: "import map",
    packages: [],
    driven: "the page, without a bundler",
    drive: { page: "." },
    shown: ["index.html"],
    files: {
      ...page,
      "index.html": pageOf(`<script type="importmap">
{ "imports": { "planarium": "${place}/planarium.js", "planarium/worker": "${place}/worker.js" } }
</script>
<script type="module" src="./main.js"></script>`),
    },
  },
  {
    name: "classic worker",
    packages: [],
    driven: "a worker of a page, which has workers of its own",
    drive: { page: "." },
    shown: ["classic.js"],
    files: {
      "plan.js": direct,
      "classic.js": `import("./plan.js").then(({ plan }) => plan()).then((found) => postMessage(found)); // importScripts loads no modules
`,
      "index.html": pageOf(
        `<script>new Worker("classic.js").onmessage = ({ data }) => { globalThis.found = data; };</script>`,
      ),
    },
  },
  {
    name: "workerd",
    packages: ["workerd", "esbuild"],
    driven: "a server",
    drive: { server: "workerd serve config.capnp --socket-addr=http=127.0.0.1:$PORT", isPage: false },
    shown: ["main.js", "config.capnp"],
    files: {
      "main.js": `import { Scenario, initSync } from "planarium";
import core from "planarium/planarium_bg.wasm"; // compiled when the worker is deployed: workerd compiles nothing later

initSync(core);
export default {
  async fetch() {
    const planner = Scenario.generate("${CASE.generate}", ${generated}).planner(${options});
    for await (const growth of planner) void growth;
    return Response.json({ core: planner.fingerprint(), worker: null });
  },
};
`,
      "config.capnp": `using Workerd = import "/workerd/workerd.capnp";
const config :Workerd.Config = (services = [(name = "main", worker = .main)], sockets = [(name = "http", service = "main")]);
const main :Workerd.Worker = (
  modules = [(name = "main.js", esModule = embed "dist/main.js"), (name = "planarium_bg.wasm", wasm = embed "dist/planarium_bg.wasm")],
  compatibilityDate = "2026-01-01",
);
`,
    },
    build: [
      "esbuild main.js --bundle --format=esm --conditions=workerd,worker,browser --loader:.wasm=copy --asset-names=[name] --outdir=dist",
    ],
    note: "workerd has no workers of its own",
  },
  {
    name: "React",
    packages: ["react", "react-dom", "vite", "@vitejs/plugin-react"],
    build: ["vite build"],
    driven: "the built page",
    drive: { page: "dist" },
    files: {
      "plan.js": PROGRAM,
      "index.html": pageOf(`<script type="module" src="./main.jsx"></script>`),
      "vite.config.js": `import react from "@vitejs/plugin-react";

export default { plugins: [react()] };
`,
      "main.jsx": `import { StrictMode, useEffect, useState } from "react";
import { createRoot } from "react-dom/client";
import { plan } from "./plan.js";

function App() {
  const [found, setFound] = useState(null);
  useEffect(() => { plan().then(setFound); }, []);
  useEffect(() => { globalThis.found = found; }, [found]);
  return <output>{found?.core}</output>;
}
createRoot(document.getElementById("app")).render(<StrictMode><App /></StrictMode>);
`,
    },
  },
  {
    name: "Svelte",
    packages: ["svelte", "vite", "@sveltejs/vite-plugin-svelte"],
    build: ["vite build"],
    driven: "the built page",
    drive: { page: "dist" },
    files: {
      "plan.js": PROGRAM,
      "index.html": module,
      "vite.config.js": `import { svelte } from "@sveltejs/vite-plugin-svelte";

export default { plugins: [svelte()] };
`,
      "main.js": `import { mount } from "svelte";
import App from "./App.svelte";

mount(App, { target: document.getElementById("app") });
`,
      "App.svelte": `<script>
  import { plan } from "./plan.js";
  let found = $state(null);
  plan().then((value) => { found = value; });
  $effect(() => { globalThis.found = $state.snapshot(found); });
</script>

<output>{found?.core}</output>
`,
    },
  },
  ...[
    ["TypeScript", "typescript", "node16", "node16"],
    ["TypeScript", "typescript", "esnext", "bundler"],
    ["TypeScript 5", "typescript@5", "node16", "node16"],
  ].map(
    ([name, key, kind, resolution]) =>
      /** @type {Toolchain} */ ({
        name: `${name}, \`moduleResolution\` ${resolution}`,
        packages: [key],
        driven: "types, strict",
        shown: ["tsconfig.json"],
        drive: { typesOnly: true },
        build: ["tsc --project ."],
        files: {
          "main.ts": PROGRAM.replace("const options =", "const options: PlannerOptions =").replace(
            "Scenario }",
            "Scenario, type PlannerOptions }",
          ),
          "tsconfig.json": JSON.stringify({
            compilerOptions: {
              strict: true,
              noEmit: true,
              target: "es2022",
              module: kind,
              moduleResolution: resolution,
              types: [],
            },
            files: ["main.ts"],
          }),
        },
      }),
  ),
];

/**
 * The same project with `planarium/full`. The worker has the light core, so that both files are copied where one is.
 * @param {Toolchain} toolchain @returns {Toolchain}
 */
export function withFull(toolchain) {
  const inText = (/** @type {string} */ text) =>
    text
      .replace(/(from |require\(|exclude: \[)"planarium"/g, '$1"planarium/full"')
      .replace(`from "${place}/planarium.js"`, `from "${place}/full/full.js"`)
      .replace(`"planarium": "${place}/planarium.js"`, `"planarium/full": "${place}/full/full.js"`)
      .replaceAll("planarium_bg.wasm", "full_bg.wasm");
  const inCommand = (/** @type {string} */ command) =>
    command.replace(
      "node_modules/planarium/dist/package/planarium_bg.wasm",
      "$& node_modules/planarium/dist/package/full/full_bg.wasm",
    );
  return {
    ...toolchain,
    build: toolchain.build?.map(inCommand),
    files: Object.fromEntries(Object.entries(toolchain.files).map(([name, text]) => [name, inText(text)])),
  };
}
