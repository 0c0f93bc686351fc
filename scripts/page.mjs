/** Builds the pages around the package: as files for a web server, and as one file. */
import { createHash } from "node:crypto";
import { cpSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, join, relative, sep } from "node:path";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";
import { assembleFront, slides } from "./front.mjs";
import { assembleGallery } from "./gallery.mjs";
import { addPageNotices, packageNotices } from "./notices.mjs";
import { root } from "./run.mjs";

const dist = join(root, "dist");

/**
 * The pages, in the order of the links between them: the file, the name in the links, the title on the start page, and
 * what one learns there. The first is the planner's, the others are rooms; the start page, `index.html`, is not listed.
 */
export const PAGES = [
  {
    name: "plan",
    link: "Planners",
    title: "Planners",
    learns: "How roadmaps and trees search for a path: fourteen planners, step by step, alone or in a race.",
  },
  {
    name: "reach",
    link: "Kinematics",
    title: "Kinematics",
    learns: "How joint angles place the tip of an arm, and how inverse kinematics finds angles for a point.",
  },
  {
    name: "neighbours",
    link: "Neighbours",
    title: "Nearest neighbours",
    learns: "Which configurations are close when angles wrap around, and what an index saves.",
  },
  {
    name: "trajectories",
    link: "Trajectories",
    title: "Trajectories",
    learns: "Why each further trajectory that crosses no other one is harder to find.",
  },
  {
    name: "fleet",
    link: "Fleets",
    title: "Robot fleets",
    learns: "Who waits for whom when robots share a floor, and why the order of planning decides.",
  },
  {
    name: "prm-rl",
    link: "Learned edges",
    title: "Learned edges",
    learns: "What a roadmap gains when a trained policy drives its edges (PRM-RL), and what it cannot prove.",
  },
  {
    name: "experiments",
    link: "Experiments",
    title: "Experiments",
    learns: "Whether one planner is really better: hundreds of trials, with intervals and tests.",
  },
  {
    name: "gallery",
    link: "Gallery",
    title: "Gallery",
    learns: "What to look for: figures from course reports, each a run that you can open and change.",
  },
];
/** The pages that bring their own body, and no core: the start page, which loads it later, and the slides of a class. */
const START = "index";
const SLIDES = "class";
/** The part of the package that needs no core: each script has what it uses of it. */
const DRAW = { "planarium/draw": join(dist, "package", "draw.js") };
const NOTICES = "THIRD-PARTY-NOTICES.txt";
const ROOMS = PAGES.slice(1).map(({ name }) => name);
/**
 * What the build draws: the gallery's entries, the start page's cards and the link of its run. A draft draws them once.
 * @type {{ figures: string, cards: string, run: string } | null}
 */
let drawn = null;
/** The page that computes nothing: it needs neither the core nor a script to be read. */
const GALLERY = "gallery";

/**
 * Assembles the pages around the package: for each a script, with parts that are loaded on demand, and for the
 * planner's page and for the rooms a worker. The package is a separate file, the same as published. Source maps lie
 * beside the scripts.
 *
 * A page is `www/NAME.html`, the contents of the slots of `www/app/shell.html`. A room also has `www/NAME/main.js` and
 * `www/NAME/style.css`; the worker of the rooms is `www/rooms/worker.js`. The rooms share parts, none of them with the
 * planner's page, and the core of `planarium/full`; the planner's page has that of `planarium`. The gallery's entries,
 * pictures and links are made here from the data in `www/gallery/`.
 *
 * @param {{ out?: string, isDraft?: boolean }} [options]   the folder; and whether files are neither compressed nor
 *   kept for use without a network, which takes most of the time. In a draft the gallery's pictures are made once.
 */
export async function assemblePage({ out = join(dist, "page"), isDraft = false } = {}) {
  const page = join(root, "www");
  if (!isDraft) rmSync(out, { recursive: true, force: true });
  mkdirSync(join(out, "planarium"), { recursive: true });
  for (const part of ["icon.svg", "scenes", "experiments/documents", "gallery/worlds"])
    cpSync(join(page, part), join(out, part), { recursive: true });
  for (const [name, folder] of [
    ["planarium", "."],
    ["full", "full"],
  ]) {
    cpSync(join(dist, "package", folder, `${name}_bg.wasm`), join(out, "planarium", `${name}_bg.wasm`));
    joinModules(join(dist, "package", folder, `${name}.js`), join(out, "planarium", `${name}.js`));
  }
  const inParts = { outfile: undefined, outdir: out, splitting: true, chunkNames: "parts/[name]-[hash]" };
  joinModules(join(page, "style", "style.css"), join(out, "style.css"));
  // The page and the worker import the package themselves, and no part of theirs does.
  const beside = {
    ...inParts,
    alias: { ...DRAW, planarium: "./planarium/planarium.js" },
    external: ["./planarium/planarium.js"],
  };
  const planner = joinModules(join(page, "planner", "main.js"), "", beside);
  joinModules(join(page, "planner", "worker", "worker.js"), "", beside);
  const rooms = assembleRooms(inParts);
  const others = assembleOthers(out);
  if (!isDraft || drawn === null)
    drawn = { figures: await assembleGallery(join(out, GALLERY)), ...(await assembleFront(out, PAGES)) };
  const { figures, ...front } = drawn;
  const made = { ...front, slides: slides() };
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
  addPageNotices(join(dist, "package", NOTICES), join(out, NOTICES), [planner, rooms, ...others].flatMap(includedIn));
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

/** The files of which something is in the output. @param {import("esbuild").Metafile} metafile @returns {string[]} */
function includedIn({ outputs }) {
  return Object.values(outputs).flatMap(({ inputs }) =>
    Object.entries(inputs)
      .filter(([, { bytesInOutput }]) => bytesInOutput > 0)
      .map(([file]) => file),
  );
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

/** The names of the files of ready experiments, and the titles of their documents. */
function readyExperiments() {
  const folder = join(root, "www", "experiments", "documents");
  return readdirSync(folder)
    .sort()
    .map((name) => ({
      id: basename(name, ".json"),
      title: JSON.parse(readFileSync(join(folder, name), "utf8")).title,
    }));
}

/**
 * The HTML of a page: the shell with the page's contents in its slots. A single file has no links to other pages.
 * @param {string} name
 * @param {string[] | null} scripts   that its script imports: they are fetched at once; null for a single file
 * @param {Record<string, string>} [made]  contents of slots that the build has made
 */
function documentOf(name, scripts, made = {}) {
  const links = PAGES.map(
    (other) => `<a href="${other.name}.html"${other.name === name ? ' aria-current="page"' : ""}>${other.link}</a>`,
  );
  links.push('<a href="docs/">Docs</a>');
  const isStart = name === START;
  const isRoom = ROOMS.includes(name);
  // A page lists its slots: the name of each in a comment at the start of a line, then its content.
  const own = readFileSync(join(root, "www", `${name}.html`), "utf8")
    .split(/^<!-- (\w+) -->/m)
    .slice(1);
  /** @type {Record<string, string>} */
  const slots = {
    folder: isStart ? "start/" : isRoom || name === SLIDES ? `${name}/` : "",
    core: isRoom ? "full" : "planarium",
    product:
      scripts === null
        ? '<p class="product">Planarium</p>'
        : `<p class="product"><a href="./"${isStart ? ' aria-current="page"' : ""}>Planarium</a></p>`,
    imports: (scripts ?? []).map((file) => `<link rel="modulepreload" href="${file}">`).join("\n  "),
    pages: scripts === null ? "" : `<nav class="rooms" aria-label="Pages">${links.join(" ")}</nav>`,
    ...made,
  };
  for (let i = 0; i < own.length; i += 2) slots[own[i]] ??= own[i + 1].trim();
  let shell = readFileSync(join(root, "www", "app", "shell.html"), "utf8");
  if (isStart || name === SLIDES || name === GALLERY)
    shell = shell.replace(/ *<(link rel="\w*preload" href="planarium|noscript>).*\n/g, "");
  if (slots.body) shell = shell.replace(/(?<=<body>)[^]*(?=<\/body>)/, () => `\n${slots.body}\n`);
  if (isStart)
    shell = shell
      .replace(/<main[^]*<\/main>/, () => slots.main)
      .replace(/ *<(p id="where"|span id="tools").*\n/g, "")
      // Before anything is drawn.
      .replace(/( *)<meta name="description"/, '$1<script src="start/forward.js"></script>\n$&');
  return shell.replace(/<!-- (\w+) -->/g, (_, slot) => slots[slot] ?? "");
}

/**
 * The page as one single HTML file, `dist/planarium.html`, that runs from `file://` and in a sandboxed frame: the
 * script, the worker and the WebAssembly (gzip in base64), the scenes and the style are elements of it. Its policy
 * names its style, and the script that unpacks the others, by their hashes.
 */
export function assembleOneFile() {
  const page = join(root, "www");
  const out = join(dist, "planarium.html");
  const text = (/** @type {string} */ path) => readFileSync(path, "utf8");
  const made = join(dist, "one-file");
  rmSync(made, { recursive: true, force: true });
  const inside = { sourcemap: false, alias: { ...DRAW, planarium: join(dist, "package", "planarium.js") } };
  const main = joinModules(join(page, "planner", "main.js"), join(made, "main.js"), inside);
  // The worker receives the compiled module, so the package needs no address.
  joinModules(join(page, "planner", "worker", "worker.js"), join(made, "worker.js"), {
    ...inside,
    format: "iife",
    logOverride: { "empty-import-meta": "silent" },
  });
  joinModules(join(page, "style", "style.css"), join(made, "style.css"), { sourcemap: false });
  const style = text(join(made, "style.css"));
  const policy = `default-src 'none'; script-src ${hashOf(UNPACK)} 'wasm-unsafe-eval' blob:; worker-src blob:; style-src ${hashOf(style)}; img-src data: blob:; base-uri 'none'; form-action 'none'`;
  const icon = `data:image/svg+xml;base64,${readFileSync(join(page, "icon.svg")).toString("base64")}`;
  const packed = (/** @type {string} */ path) => gzipSync(readFileSync(path), { level: 9 }).toString("base64");
  const scenes = readdirSync(join(page, "scenes")).filter((name) => name.endsWith(".json"));
  const parts = [
    ["core", packed(join(dist, "package", "planarium_bg.wasm"))],
    ["main", packed(join(made, "main.js"))],
    ["worker", packed(join(made, "worker.js"))],
    ["notices", packageNotices(includedIn(main))],
    ...scenes.map((name) => [
      `scene-${basename(name, ".json")}`,
      JSON.stringify(JSON.parse(text(join(page, "scenes", name)))),
    ]),
  ];
  const html = documentOf("plan", null)
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
  writeFileSync(out, html);
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

/**
 * Bundles an entry and all its imports into one file.
 * @param {string} entry
 * @param {string} out
 * @param {import("esbuild").BuildOptions} [more]
 * @returns {import("esbuild").Metafile}
 */
function joinModules(entry, out, more = {}) {
  /** @type {typeof import("esbuild")} */
  const { buildSync } = createRequire(import.meta.url)("esbuild");
  const { metafile } = buildSync({
    entryPoints: [entry],
    outfile: out,
    bundle: true,
    minify: true,
    sourcemap: true,
    format: "esm",
    target: "es2022",
    logLevel: "warning",
    metafile: true,
    absWorkingDir: root,
    ...more,
  });
  return /** @type {import("esbuild").Metafile} */ (metafile);
}
