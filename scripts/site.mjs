/**
 * `npm run site`: builds the documentation into `dist/site`, beside the pages in `dist/page`, and checks it. The
 * package and the pages must be built. The reference of the crate is a part of it if `cargo doc` has been run.
 */
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync } from "node:fs";
import { dirname, join } from "node:path";
import { unlessMade } from "./kept.mjs";
import { Problem, isMain, root, run, script } from "./run.mjs";
import { targetFolder } from "./setup.mjs";

const dist = join(root, "dist");
const site = join(dist, "site");
const tools = join(root, "docs", ".vitepress");

/** The address of the site on its server; the pages are in the folder above. */
export const BASE = process.env.PLANARIUM_SITE_BASE ?? "/docs/";

/** The anchor of a heading, as GitHub forms it. @param {string} heading */
export function anchorOf(heading) {
  return heading
    .toLowerCase()
    .replace(/[^\p{L}\p{N}_\- ]/gu, "")
    .replaceAll(" ", "-");
}

/** The first page of the crate's reference, which exists if `cargo doc` has been run. */
export function rustReference() {
  return join(targetFolder(), "doc", "planarium", "index.html");
}

/** Builds the site, unless it is already made of all that it shows, and fails if a link of it is dead. */
export const buildSite = () =>
  unlessMade(
    "site",
    [join("dist", "site"), join("dist", "site-public")],
    [BASE, existsSync(rustReference())],
    makeSite,
  );

async function makeSite() {
  // The package may have been built a moment ago, so what draws with it is loaded only now.
  const { makeStages, publicFolder } = await import("../docs/.vitepress/planners.mjs");
  for (const folder of [publicFolder, join(root, "docs", "api")]) rmSync(folder, { recursive: true, force: true });
  mkdirSync(publicFolder, { recursive: true });
  cpSync(join(root, "www", "icon.svg"), join(publicFolder, "icon.svg"));
  await Promise.all([
    run(process.execPath, [
      join(tools, "node_modules", "typedoc", "bin", "typedoc"),
      "--tsconfig",
      join(tools, "tsconfig.json"),
    ]),
    makeStages(),
  ]);
  await run(process.execPath, [join(root, "node_modules", "vitepress", "bin", "vitepress.js"), "build", "docs"]);
  if (existsSync(rustReference())) cpSync(dirname(dirname(rustReference())), join(site, "rust"), { recursive: true });
  const dead = deadLinks();
  if (dead.length > 0) throw new Problem(`The site has dead links:\n${dead.join("\n")}`);
}

/**
 * The links of the site that lead to no file of the site or of the pages, or to no heading of their page.
 * @returns {string[]}
 */
export function deadLinks() {
  const folders = readdirSync(site).filter((name) => name !== "rust" && statSync(join(site, name)).isDirectory());
  const own = folders.flatMap((folder) =>
    readdirSync(join(site, folder), { recursive: true, encoding: "utf8" }).map((name) => `${folder}/${name}`),
  );
  const pages = [...readdirSync(site), ...own].filter((name) => name.endsWith(".html") && !name.startsWith("files/"));
  /** @type {Map<string, { links: string[], anchors: Set<string> }>} */
  const known = new Map();
  const read = (/** @type {string} */ file) => {
    const entry = known.get(file) ?? linksOf(readFileSync(file, "utf8"));
    known.set(file, entry);
    return entry;
  };
  return pages.flatMap((page) =>
    read(join(site, page))
      .links.filter((link) => {
        const { origin, pathname, hash } = new URL(link, `http://site${BASE}${page}`);
        if (origin !== "http://site") return false;
        const path = decodeURIComponent(pathname);
        const place = path.startsWith(BASE)
          ? join(site, path.slice(BASE.length))
          : join(dist, "page", path.slice(new URL("..", `http://site${BASE}`).pathname.length));
        const file = [place, `${place}.html`, join(place, "index.html")].find(
          (one) => existsSync(one) && statSync(one).isFile(),
        );
        const isInside = file?.startsWith(site) && file.endsWith(".html") && !file.startsWith(join(site, "files"));
        return !file || (isInside && hash !== "" && !read(file).anchors.has(decodeURIComponent(hash.slice(1))));
      })
      .map((link) => `${page}: ${link}`),
  );
}

/** @param {string} html */
function linksOf(html) {
  const plain = (/** @type {RegExp} */ pattern) =>
    Array.from(html.matchAll(pattern), ([, value]) => value.replaceAll("&amp;", "&"));
  return { links: plain(/ (?:href|src)="([^"]+)"/g), anchors: new Set(plain(/ id="([^"]+)"/g)) };
}

if (isMain(import.meta.url)) await script(buildSite);
