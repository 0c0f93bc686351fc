/**
 * The pages that are also built as one HTML file each, which runs from `file://` and in a sandboxed frame: the script,
 * the worker and the WebAssembly (gzip in base64), the documents and the style are elements of it. Its policy names its
 * style, and the script that unpacks the others, by their hashes.
 */
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { DRAW, dist, includedIn, joinModules, readyExperiments } from "./bundle.mjs";
import { NOTICES, packageNotices } from "./notices.mjs";
import { root } from "./run.mjs";
import { documentOf } from "./shell.mjs";

const www = join(root, "www");

/**
 * @typedef {object} Part
 * @property {string} out     in `dist/`
 * @property {string} core    in `dist/package/`, without its ending
 * @property {string} folder  of the page's script and style
 * @property {string} style
 * @property {string} worker
 * @property {string[]} documents  folders of `www/`
 */

/** @type {Record<string, Part>} */
const FILES = {
  plan: {
    out: "planarium.html",
    core: "planarium",
    folder: "planner",
    style: "style/style.css",
    worker: "planner/worker/worker.js",
    documents: ["scenes"],
  },
  experiments: {
    out: "planarium-experiments.html",
    core: "full/full",
    folder: "experiments",
    style: "experiments/style.css",
    worker: "experiments/worker.js",
    documents: ["scenes", "experiments/documents", "gallery/worlds"],
  },
};

/** Writes `dist/planarium.html`, the planner's page, and `dist/planarium-experiments.html`, that of experiments. */
export function assembleOneFile() {
  rmSync(join(dist, "one-file"), { recursive: true, force: true });
  for (const [name, part] of Object.entries(FILES)) writeFileSync(join(dist, part.out), fileOf(name, part));
}

/** @param {string} name @param {Part} part @returns {string}  HTML */
function fileOf(name, { core, folder, style: sheet, worker, documents }) {
  const text = (/** @type {string} */ path) => readFileSync(path, "utf8");
  const packed = (/** @type {string} */ path) => gzipSync(readFileSync(path), { level: 9 }).toString("base64");
  const made = join(dist, "one-file", name);
  const library = join(dist, "package", `${core}.js`);
  const inside = {
    sourcemap: false,
    // What reads maps and shows a part of them, and what times and judges paths, is not in it, nor does it get that far.
    external: ["./world.js", "./zoom.js", "./door.js", "./timing-panel.js", "./room-panel.js", "./judge/judge.js"],
    alias: { ...DRAW, planarium: library, "planarium/full": library },
    define: { "globalThis.EXPERIMENTS": JSON.stringify(readyExperiments()) },
  };
  const main = joinModules(join(www, folder, "main.js"), join(made, "main.js"), inside);
  // The worker receives the compiled module, so the package needs no address.
  joinModules(join(www, worker), join(made, "worker.js"), {
    ...inside,
    format: "iife",
    logOverride: { "empty-import-meta": "silent" },
  });
  joinModules(join(www, sheet), join(made, "style.css"), { sourcemap: false });
  const style = text(join(made, "style.css"));
  const policy = `default-src 'none'; script-src ${hashOf(UNPACK)} 'wasm-unsafe-eval' blob:; worker-src blob:; style-src ${hashOf(style)}; img-src data: blob:; base-uri 'none'; form-action 'none'`;
  const icon = `data:image/svg+xml;base64,${readFileSync(join(www, "icon.svg")).toString("base64")}`;
  const parts = [
    ["core", packed(join(dist, "package", `${core}_bg.wasm`))],
    ["main", packed(join(made, "main.js"))],
    ["worker", packed(join(made, "worker.js"))],
    ["notices", packageNotices(includedIn(main))],
    ...documents.flatMap((path) =>
      readdirSync(join(www, path))
        .filter((file) => file.endsWith(".json"))
        .map((file) => [`${path}/${file}`, JSON.stringify(JSON.parse(text(join(www, path, file))))]),
    ),
  ];
  return documentOf(name, null)
    .replace(
      /<meta http-equiv="Content-Security-Policy"[^>]*>/,
      () => `<meta http-equiv="Content-Security-Policy" content="${policy}">`,
    )
    .replace(/href="icon.svg"/, () => `href="${icon}"`)
    .replace(/ *<link rel="(preload|modulepreload)"[^>]*>\n/g, "")
    .replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${style}</style>`)
    .replace(/ *<script type="module"[^>]*><\/script>\n/, "")
    .replace(
      "<head>",
      () =>
        `<head>\n<!-- Contains npm packages, whose licences are at its end, and the crates of the npm package, whose ${NOTICES} lists them. -->`,
    )
    .replace(
      "</body>",
      () => `${parts.map(([name, part]) => `<script type="text/plain" id="inline-${name}">${part}</script>`).join("\n")}
<script type="module">${UNPACK}</script>
</body>`,
    );
}

/** Imports the page's script from the element that holds it. */
const UNPACK = `
const bytes = Uint8Array.from(atob(document.getElementById("inline-main").textContent), (character) => character.charCodeAt(0));
const script = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).blob();
await import(URL.createObjectURL(new Blob([script], { type: "text/javascript" })));
`;

/** The hash of a text as a content security policy contains it. @param {string} text */
function hashOf(text) {
  return `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
}
