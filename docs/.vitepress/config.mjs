/**
 * The documentation site: VitePress over docs/, where TypeDoc has written docs/api/, README and CHANGELOG. `npm run site`
 * builds it. `docs/index.md` is its first page.
 */
import { Graphviz } from "@hpcc-js/wasm-graphviz";
import { cpSync, existsSync, readFileSync, readdirSync, statSync } from "node:fs";
import { join, posix, relative } from "node:path";
import { defineConfig } from "vitepress";
import { completePlannerPage, plannerOf, planners } from "./planners.mjs";
import { root } from "../../scripts/run.mjs";
import { BASE, anchorOf, rustReference } from "../../scripts/site.mjs";

/**
 * Pages of the site by the file that each is made from. The site has the address of a file in docs/ without that
 * folder.
 */
const REWRITES = {
  "README.md": "readme.md",
  "CHANGELOG.md": "changelog.md",
  "SECURITY.md": "security.md",
  "docs/:page*": ":page*",
};

/**
 * The sidebar; a page that does not exist is left out, and a page of docs/ that no group names follows in the last one.
 */
const GROUPS = [
  ["Begin", ["docs/index.md", "docs/start.md", "docs/teaching.md", "docs/worksheet.md"]],
  ["How it works", ["docs/proof.md", "docs/experiments.md", "docs/benchmarks.md"]],
  [
    "Reference",
    [
      "docs/scenarios.md",
      "docs/worlds.md",
      "docs/shortest.md",
      "docs/timing.md",
      "docs/fleet.md",
      "docs/prm-rl.md",
      "docs/javascript.md",
      "docs/in-rust.md",
      "docs/command-line.md",
      "docs/toolchains.md",
    ],
  ],
  [
    "Project",
    [
      "docs/architecture.md",
      "docs/adding-a-planner.md",
      ...markdownIn("docs/decisions"),
      "README.md",
      "SECURITY.md",
      "CHANGELOG.md",
    ],
  ],
];

/** What the site calls a page, where that is not its heading. @type {Record<string, string>} */
const TITLES = {
  "README.md": "README",
  "docs/index.md": "Overview",
  "docs/javascript.md": "JavaScript",
  "docs/in-rust.md": "Rust",
  "docs/teaching.md": "Teaching",
  "docs/worksheet.md": "Worksheet",
  "docs/worlds.md": "Maps and pictures",
  "docs/planners.md": "Overview",
};

/** Families of planners, in the order of the sidebar. */
const FAMILIES = [
  ["Roadmaps", ["prm", "prm-star", "lazy-prm", "lazy-prm-star", "visibility-prm"]],
  ["Trees", ["rrt", "rrt-connect"]],
  ["Paths that get shorter", ["rrt-star", "informed-rrt-star", "fmt-star", "bit-star", "aorrtc"]],
  ["Cars by controls", ["rrt-control", "sst"]],
];

/** @param {string} folder */
function markdownIn(folder) {
  return readdirSync(join(root, folder))
    .filter((name) => name.endsWith(".md"))
    .sort()
    .map((name) => `${folder}/${name}`);
}

/** The address in the site of a Markdown file of the project. @param {string} file */
function addressOf(file) {
  return `/${file
    .replace(/^docs\//, "")
    .replace(/^index\.md$/, "")
    .replace(/^(README|CHANGELOG|SECURITY)\.md$/, (name) => name.toLowerCase())}`;
}

/** @param {string} file */
function titleOf(file) {
  const planner = planners.find(({ id }) => file === `docs/planners/${id}.md`);
  return (
    planner?.title ??
    TITLES[file] ??
    (/^# (.+)$/m.exec(readFileSync(join(root, file), "utf8"))?.[1] ?? file).replaceAll("`", "")
  );
}

/** @param {string} file */
const itemOf = (file) => ({ text: titleOf(file), link: addressOf(file).replace(/\.md$/, "") });

function sidebar() {
  const named = new Set(["docs/planners.md", ...GROUPS.flatMap(([, files]) => files)]);
  const others = markdownIn("docs").filter((file) => !named.has(file));
  const groups = GROUPS.map(([text, files], i) => ({
    text,
    items: [...files, ...(i === GROUPS.length - 1 ? others : [])]
      .filter((file) => existsSync(join(root, file)))
      .map(itemOf),
  }));
  groups[2].items.push({ text: "npm: every function", link: "/api/" });
  // `scripts/site.mjs` copies the reference of the crate once `cargo doc` has written it; it is no page of VitePress.
  if (existsSync(rustReference()))
    groups[2].items.push({ text: "Rust: every item", link: "/rust/planarium/index.html", target: "_self" });
  const families = FAMILIES.map(([text, ids]) => ({
    text,
    collapsed: false,
    items: ids.map((id) => itemOf(`docs/planners/${id}.md`)),
  }));
  const grouped = FAMILIES.flatMap(([, ids]) => ids);
  const missing = planners.filter(({ id }) => !grouped.includes(id));
  if (missing.length > 0)
    throw new Error(`The sidebar has no ${missing.map(({ id }) => id).join(", ")}: see FAMILIES.`);
  return [groups[0], { text: "Planners", items: [itemOf("docs/planners.md"), ...families] }, ...groups.slice(1)];
}

/**
 * Files of the project that pages link to and that are no pages, and their places in the site.
 * @type {Map<string, string>}
 */
const linkedFiles = new Map();

/**
 * A relative link of a file of the project, as the site has it; null if it leads to a folder, which the site does not
 * have.
 * @param {string} link @param {string} file  that has the link, from the root on
 */
function linkInSite(link, file) {
  if (/^(\w+:|#|\/)/.test(link)) return link;
  const [, path, rest] = /** @type {RegExpExecArray} */ (/^([^?#]*)(.*)$/.exec(link));
  const target = posix.normalize(posix.join(posix.dirname(file), path));
  if (/^www\/[\w-]+\.html$/.test(target)) return `/../${target.slice("www/".length)}${rest}`;
  if (target.endsWith(".md")) return `${addressOf(target)}${rest}`;
  if (statSync(join(root, target)).isDirectory()) return null;
  linkedFiles.set(target, `files/${/\.(html|json|txt)$/.test(target) ? target : `${target}.txt`}`);
  return `/${linkedFiles.get(target)}`;
}

/** A page of `www`, which lies in the folder above the site. @param {string} address */
const isPage = (address) => address.startsWith("/../");

/** Gives the links of a page their addresses in the site. @param {import("markdown-it/index.js").StateCore} state */
function rewriteLinks({ tokens, env }) {
  const file = relative(root, env.realPath ?? env.path ?? "");
  for (const { children } of tokens) {
    let isDropped = false;
    for (const token of children ?? []) {
      const href = token.type === "link_open" ? token.attrGet("href") : null;
      const address = href && linkInSite(href, file);
      if (address) token.attrSet("href", address);
      // The site's own script follows links between its pages only.
      if (address && isPage(address)) token.attrSet("target", "_self");
      if (token.type === "link_open") isDropped = !address;
      if (isDropped && token.type.startsWith("link_")) token.type = "text";
    }
  }
}

/**
 * The drawing of a Mermaid graph that has only arrows: `a --> b & c`, and `a["title"]`.
 * @param {string} text
 * @param {Graphviz} graphviz
 */
function drawGraph(text, graphviz) {
  const titles = new Map();
  const lines = text
    .trim()
    .split("\n")
    .slice(1)
    .map((line) =>
      line
        .trim()
        .replace(/(\w+)\["([^"]+)"\]/g, (_, id, title) => (titles.set(id, title), id))
        .replace("-->", "->")
        .replace(/-> (.+)/, (_, to) => `-> {${to.replaceAll("&", " ")}}`),
    );
  const labels = [...titles].map(([id, title]) => `${id} [label="${title}"]`);
  const dot = `digraph { bgcolor=none; nodesep=0.25; ranksep=0.35; node [shape=box, style=rounded, fontname="sans-serif", fontsize=12, height=0.3, margin="0.12,0.04"]; edge [arrowsize=0.6]; ${[...labels, ...lines].join("; ")} }`;
  return graphviz
    .dot(dot)
    .replace(/^[^]*?(?=<svg)/, "")
    .replaceAll(/<title>[^<]*<\/title>/g, "")
    .replaceAll(/(stroke|fill)="black"/g, '$1="currentColor"');
}
const graphviz = await Graphviz.load();

/** Patterns of the folders that have no pages. */
function otherFolders() {
  return readdirSync(root, { withFileTypes: true })
    .filter((entry) => entry.isDirectory() && entry.name !== "docs")
    .map(({ name }) => `${name}/**`);
}

export default defineConfig({
  srcDir: "..",
  srcExclude: [...otherFolders(), "docs/.vitepress/**"],
  outDir: "../dist/site",
  cacheDir: "../dist/site-cache",
  rewrites: REWRITES,
  base: BASE,
  lang: "en-GB",
  title: "Planarium",
  description: "Motion planning in the plane that you can watch",
  head: [["link", { rel: "icon", href: `${BASE}icon.svg`, type: "image/svg+xml" }]],
  vite: { publicDir: join(root, "dist", "site-public"), build: { chunkSizeWarningLimit: 2000 } },
  markdown: {
    theme: { light: "github-light", dark: "github-dark" },
    anchor: { slugify: anchorOf },
    config(md) {
      md.core.ruler.before("normalize", "planner-page", (state) => {
        const id = plannerOf(state.env.relativePath ?? "");
        if (id) state.src = completePlannerPage(state.src, id);
      });
      md.core.ruler.push("links-in-site", rewriteLinks);
      const fence = md.renderer.rules.fence;
      md.renderer.rules.fence = (tokens, i, options, env, self) =>
        tokens[i].info.trim() === "mermaid"
          ? `<figure class="graph">${drawGraph(tokens[i].content, graphviz)}</figure>`
          : (fence?.(tokens, i, options, env, self) ?? "");
    },
  },
  // `scripts/site.mjs` checks the links to these.
  ignoreDeadLinks: [/^\/files\//, /^\/\.\.\//],
  buildEnd({ outDir }) {
    for (const [file, place] of linkedFiles) cpSync(join(root, file), join(outDir, place));
  },
  transformPageData(page) {
    const id = plannerOf(page.relativePath);
    const planner = planners.find((one) => one.id === id);
    return planner ? { description: planner.summary } : undefined;
  },
  themeConfig: {
    logo: "/icon.svg",
    outline: [2, 3],
    search: { provider: "local", options: { detailedView: true } },
    logoLink: { link: `${BASE}../`, target: "_self" },
    nav: [
      { text: "Pages", link: "/../plan.html", target: "_self" },
      { text: "Start", link: "/start" },
      { text: "Teaching", link: "/teaching" },
      { text: "Planners", link: "/planners" },
      { text: "Proof", link: "/proof" },
      {
        text: "Reference",
        items: [
          { text: "Scenarios", link: "/scenarios" },
          { text: "Maps and pictures", link: "/worlds" },
          { text: "Shortest paths of web maps", link: "/shortest" },
          { text: "Several robots", link: "/fleet" },
          { text: "Learned edges", link: "/prm-rl" },
          { text: "JavaScript", link: "/javascript" },
          { text: "npm: every function", link: "/api/" },
          { text: "Rust", link: "/in-rust" },
          { text: "Command line", link: "/command-line" },
        ],
      },
    ],
    sidebar: sidebar(),
    docFooter: { prev: "Before", next: "Next" },
  },
});
