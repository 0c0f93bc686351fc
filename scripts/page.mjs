/** Builds the pages around the package, as files for a web server. */
import { createHash } from "node:crypto";
import { cpSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join, relative, sep } from "node:path";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";
import { DRAW, dist, includedIn, joinModules, readyExperiments } from "./bundle.mjs";
import { assembleFront, slides } from "./front.mjs";
import { assembleGallery } from "./gallery.mjs";
import { unlessMade } from "./kept.mjs";
import { NOTICES, addPageNotices } from "./notices.mjs";
import { root } from "./run.mjs";
import { GALLERY, PAGES, ROOMS, SLIDES, START, documentOf } from "./shell.mjs";

export { assembleOneFile } from "./one-file.mjs";
export { PAGES };

/**
 * What the build draws: the gallery's entries, the start page's cards and the link of its run. A draft draws them once.
 * @type {{ figures: string, cards: string, run: string } | null}
 */
let drawn = null;

/**
 * Assembles the pages around the package: for each a script, with parts that are loaded on demand, and for the
 * planner's page and for the rooms a worker. The package is a separate file, the same as published. Source maps lie
 * beside the scripts.
 *
 * A page is `www/NAME.html`, the contents of the slots of `www/app/shell.html`. A room also has `www/NAME/main.js` and
 * `www/NAME/style.css`; the worker of the rooms is `www/rooms/worker.js`. The rooms share parts, none of them with the
 * planner's page, and the core of `planarium/full`; the planner's page has that of `planarium`. `planarium/import` is
 * loaded on demand. The gallery's entries, pictures and links are made here from the data in `www/gallery/`.
 *
 * Nothing is done where they are already made of all this.
 */
export const assemblePage = () =>
  unlessMade("page", [join("dist", "page")], null, () => assemblePageIn(join(dist, "page")));

/**
 * Assembles the pages in a folder.
 * @param {string} out
 * @param {boolean} [isDraft]   files are neither compressed nor kept for use without a network, which takes most of the
 *   time, and the gallery's pictures are made once
 */
export async function assemblePageIn(out, isDraft = false) {
  const page = join(root, "www");
  if (!isDraft) rmSync(out, { recursive: true, force: true });
  mkdirSync(join(out, "planarium"), { recursive: true });
  for (const part of ["icon.svg", "scenes", "experiments/documents", "gallery/worlds"])
    cpSync(join(page, part), join(out, part), { recursive: true });
  for (const [name, folder] of [
    ["planarium", "."],
    ["full", "full"],
    ["import", "import"],
  ]) {
    cpSync(join(dist, "package", folder, `${name}_bg.wasm`), join(out, "planarium", `${name}_bg.wasm`));
    joinModules(join(dist, "package", folder, `${name}.js`), join(out, "planarium", `${name}.js`));
  }
  const inParts = { outfile: undefined, outdir: out, splitting: true, chunkNames: "parts/[name]-[hash]" };
  joinModules(join(page, "style", "style.css"), join(out, "style.css"));
  // The page and the worker import the package themselves, and no part of theirs does.
  const beside = {
    ...inParts,
    alias: { ...DRAW, planarium: "./planarium/planarium.js", "planarium/import": "./planarium/import.js" },
    external: ["./planarium/planarium.js", "./planarium/import.js"],
  };
  const planner = joinModules(join(page, "planner", "main.js"), "", beside);
  joinModules(join(page, "planner", "worker", "worker.js"), "", beside);
  // Of every page: it reads maps and drawings, and no page loads it before the first of them.
  const worlds = joinModules(join(page, "worlds", "worker.js"), join(out, "world-worker.js"), {
    alias: beside.alias,
    external: beside.external,
  });
  joinModules(join(page, "worlds", "style.css"), join(out, "world.css"));
  // Of the planner's page: it times paths and judges those of other programs, with all of the core.
  const paths = joinModules(join(page, "paths", "worker.js"), join(out, "path-worker.js"), {
    alias: {
      planarium: "./planarium/full.js",
      "planarium/full": "./planarium/full.js",
      "planarium/import": "./planarium/import.js",
    },
    external: ["./planarium/full.js", "./planarium/import.js"],
  });
  const rooms = assembleRooms(inParts);
  const others = assembleOthers(out);
  if (!isDraft || drawn === null)
    drawn = { figures: await assembleGallery(join(out, GALLERY)), ...(await assembleFront(out, PAGES)) };
  const { figures, ...front } = drawn;
  const made = { ...front, slides: await slides() };
  for (const name of [START, SLIDES, ...PAGES.map((page) => page.name)]) {
    const scripts = ROOMS.includes(name)
      ? importsOf(rooms, `www/${name}/main.js`)
      : name === PAGES[0].name
        ? importsOf(planner, "www/planner/main.js")
        : [];
    writeFileSync(
      join(out, `${name}.html`),
      documentOf(
        name,
        scripts.map((file) => relative(out, file).split(sep).join("/")),
        name === GALLERY ? { figures } : made,
      ),
    );
  }
  if (isDraft) return;
  const files = readdirSync(out, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && !entry.name.endsWith(".map"))
    .map((entry) => relative(out, join(entry.parentPath, entry.name)).split(sep).join("/"))
    .sort();
  const version = files
    .reduce((hash, file) => hash.update(file).update(readFileSync(join(out, file))), createHash("sha256"))
    .digest("hex")
    .slice(0, 16);
  joinModules(join(page, "app", "offline.js"), join(out, "offline.js"), {
    banner: {
      js: `globalThis.VERSION=${JSON.stringify(version)};globalThis.FILES=${JSON.stringify(["./", ...files.filter((file) => !/^gallery\/.*\.svg$/.test(file))])};`,
    },
  });
  // Not among the files that are stored for use without a network.
  addPageNotices(
    join(dist, "package", NOTICES),
    join(out, NOTICES),
    [planner, worlds, paths, rooms, ...others].flatMap(includedIn),
  );
  files.forEach((file) => compress(join(out, file)));
}

/** Writes a file compressed beside itself, by Brotli and by gzip, if that makes it smaller. @param {string} path */
function compress(path) {
  const bytes = readFileSync(path);
  // The highest quality takes seconds for the module, which is most of what is loaded; the next lower saves nearly as
  // much elsewhere.
  const quality = path.endsWith(".wasm") ? constants.BROTLI_MAX_QUALITY : 9;
  const forms = {
    br: brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: quality } }),
    gz: gzipSync(bytes, { level: 9 }),
  };
  for (const [ending, form] of Object.entries(forms))
    if (form.length < bytes.length) writeFileSync(`${path}.${ending}`, form);
}

/**
 * The files that a script imports, directly or not, but for those that it loads on demand.
 * @param {import("esbuild").Metafile} metafile
 * @param {string} entry
 * @returns {string[]}
 */
function importsOf({ outputs }, entry) {
  const reached = new Set(Object.keys(outputs).filter((file) => outputs[file].entryPoint === entry));
  for (const file of reached) {
    for (const { path, kind, external } of outputs[file].imports)
      if (kind === "import-statement" && !external) reached.add(path);
  }
  return [...reached].slice(1);
}

/**
 * The scripts and styles of the rooms and their worker, with one set of parts. An entry and a part lie equally deep, so
 * that the package has the same address for both.
 * @param {import("esbuild").BuildOptions} inParts
 * @returns {import("esbuild").Metafile}
 */
function assembleRooms(inParts) {
  const page = join(root, "www");
  const out = /** @type {string} */ (inParts.outdir);
  const entries = [join(page, "rooms", "worker.js"), ...ROOMS.map((name) => join(page, name, "main.js"))];
  const made = joinModules("", "", {
    ...inParts,
    entryPoints: entries,
    define: { "globalThis.EXPERIMENTS": JSON.stringify(readyExperiments()) },
    outbase: page,
    alias: { ...DRAW, planarium: "../planarium/full.js", "planarium/full": "../planarium/full.js" },
    external: ["../planarium/full.js"],
  });
  for (const name of ROOMS) joinModules(join(page, name, "style.css"), join(out, name, "style.css"));
  return made;
}

/**
 * The scripts and styles of the start page and of the slides, and the script that sends the planner's old links to its
 * page.
 * @param {string} out
 */
function assembleOthers(out) {
  const www = join(root, "www");
  joinModules(join(www, "start", "forward.js"), join(out, "start", "forward.js"), { format: "iife", sourcemap: false });
  return ["start", "class"].map((folder) => {
    joinModules(join(www, folder, "style.css"), join(out, folder, "style.css"));
    return joinModules(join(www, folder, "main.js"), join(out, folder, "main.js"), {
      alias: { ...DRAW, planarium: "../planarium/planarium.js" },
      external: ["../planarium/planarium.js"],
    });
  });
}
