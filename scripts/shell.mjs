/** The HTML of the pages: one shell, whose slots each page fills. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { root } from "./run.mjs";

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
/** The pages that bring their own body, and no core: the start page, which loads it later, and the class's slides. */
export const START = "index";
export const SLIDES = "class";
/** The page that computes nothing: it needs neither the core nor a script to be read. */
export const GALLERY = "gallery";

export const ROOMS = PAGES.slice(1).map(({ name }) => name);

/**
 * The HTML of a page: the shell with the page's contents in its slots. A single file has no links to other pages.
 * @param {string} name
 * @param {string[] | null} scripts   that its script imports: they are fetched at once; null for a single file
 * @param {Record<string, string>} [made]  contents of slots that the build has made
 */
export function documentOf(name, scripts, made = {}) {
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
