/**
 * The parts of a planner's page that come from the catalogue and from the core: pseudo-code, guarantee, options, and
 * the live stage.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { root } from "../../scripts/run.mjs";

/** @typedef {import("../../scripts/declarations.mjs").Row & { robots: string[], title: string }} Option */
/**
 * @typedef {{ id: string, title: string, summary: string, guarantee: string, robots: string[], parameters: Option[],
 *   presets: { id: string, title: string }[], pseudocode: { text: string, indent: number }[] }} PlannerEntry
 */
/** @typedef {{ address: string, title: string, width: number, height: number }} Stage */

/** @type {PlannerEntry[]} */
export const planners = JSON.parse(readFileSync(join(root, "schema", "catalogue.json"), "utf8")).planners;

/** What was drawn for the site before it is built; it is copied into the site. */
export const publicFolder = join(root, "dist", "site-public");

const IMPROVES = { improve_iterations: 1500, seed: 2 };
const AMONG_DISCS = "a disc among other discs, a world that several of these pages share";

/**
 * The scene and the settings in which each planner shows its nature, and the robot and world in words.
 * @type {Record<string, { scene: string, of: string, settings: Record<string, string | number | boolean>, view?: {
 *   optimum?: boolean } }>}
 */
const STAGES = {
  prm: {
    scene: "stones",
    of: "an arm of two links, and its configuration space",
    settings: { samples: 260, k: 9, seed: 0 },
  },
  "prm-star": { scene: "pebbles", of: AMONG_DISCS, settings: { samples: 300, seed: 2 }, view: { optimum: true } },
  "lazy-prm": {
    scene: "pebbles",
    of: AMONG_DISCS,
    settings: { samples: 300, k: 10, seed: 2 },
    view: { optimum: true },
  },
  "lazy-prm-star": { scene: "pebbles", of: AMONG_DISCS, settings: IMPROVES, view: { optimum: true } },
  "visibility-prm": {
    scene: "museum",
    of: "a disc in the rooms of a museum",
    settings: { failures: 150, shortcut: 60, seed: 2 },
  },
  rrt: { scene: "trap", of: "a disc in a trap whose mouth is turned inwards", settings: { step: 0.1, seed: 5 } },
  "rrt-connect": { scene: "maze", of: "a disc in a maze", settings: { step: 0.1, seed: 4 } },
  "rrt-star": { scene: "pebbles", of: AMONG_DISCS, settings: { step: 0.1, ...IMPROVES }, view: { optimum: true } },
  "informed-rrt-star": {
    scene: "pebbles",
    of: AMONG_DISCS,
    settings: { step: 0.1, ...IMPROVES },
    view: { optimum: true },
  },
  "fmt-star": { scene: "pebbles", of: AMONG_DISCS, settings: { samples: 300, seed: 2 }, view: { optimum: true } },
  "bit-star": { scene: "pebbles", of: AMONG_DISCS, settings: { batch_size: 60, ...IMPROVES }, view: { optimum: true } },
  aorrtc: { scene: "pebbles", of: AMONG_DISCS, settings: IMPROVES, view: { optimum: true } },
  "rrt-control": {
    scene: "blossom",
    of: "a car whose edges are controls",
    settings: { blossom: 3, duration_steps: 250, goal_bias: 0.05, goal_test: "ends", max_iterations: 10000, seed: 1 },
  },
  sst: { scene: "witness", of: "a car whose edges are controls", settings: { seed: 2 } },
};

/** The planner that a page is about, by the page's address; undefined for other pages. @param {string} page */
export function plannerOf(page) {
  return /^planners\/(.+)\.md$/.exec(page)?.[1];
}

/** Draws each planner's stage and makes its link; the package must be built. */
export async function makeStages() {
  const [{ openPlanner }, { sheetOf }, { encodeLink }, { coloursOf, documents }] = await Promise.all([
    import("../../www/gallery/build/planner.js"),
    import("../../www/gallery/build/sheet.js"),
    import("../../www/planner/link/codec.js"),
    import("../../scripts/gallery.mjs"),
  ]);
  const style = coloursOf();
  mkdirSync(join(publicFolder, "stages"), { recursive: true });
  /** @type {Record<string, Stage>} */
  const stages = {};
  for (const { id, title } of planners) {
    const stage = STAGES[id];
    if (!stage) throw new Error(`The page of ${id} has no stage: see STAGES.`);
    const { scene, of, settings, view = {} } = stage;
    const state = { scene, view, lanes: [{ algorithm: id, settings }] };
    const { panes, pane } = await openPlanner(/** @type {any} */ ({ state }), documents);
    const picture = sheetOf(panes, { title, style }, pane);
    writeFileSync(join(publicFolder, "stages", `${id}.svg`), picture);
    const [, width = 0, height = 0] = /<svg [^>]*width="(\d+)" height="(\d+)"/.exec(picture)?.map(Number) ?? [];
    stages[id] = {
      address: `#${await encodeLink(/** @type {any} */ ({ version: 1, iteration: 0, ...state }))}`,
      title: `${title}: ${of}`,
      width,
      height,
    };
  }
  writeFileSync(join(publicFolder, "stages", "stages.json"), JSON.stringify(stages));
}

/** @returns {Record<string, Stage>} */
function readStages() {
  const file = join(publicFolder, "stages", "stages.json");
  if (!existsSync(file)) throw new Error("The stages are not drawn: run `npm run site`.");
  return JSON.parse(readFileSync(file, "utf8"));
}

/**
 * The source of a planner's page with its generated parts, each in place of a comment with its name.
 * @param {string} text
 * @param {string} id
 */
export function completePlannerPage(text, id) {
  const planner = planners.find((one) => one.id === id);
  if (!planner) throw new Error(`docs/planners/${id}.md is not about a planner.`);
  const { address, title, width, height } = readStages()[id];
  /** @type {Record<string, string>} */
  const parts = {
    stage: `<LiveStage picture="/stages/${id}.svg" address="${address}" title="${title}" :width="${width}" :height="${height}" />`,
    pseudocode: `## Pseudo-code\n\n\`\`\`text\n${planner.pseudocode.map((line) => "    ".repeat(line.indent) + line.text).join("\n")}\n\`\`\``,
    guarantee: planner.guarantee,
    options: optionsOf(planner),
  };
  for (const name of Object.keys(parts))
    if (!text.includes(`<!-- ${name} -->`)) throw new Error(`docs/planners/${id}.md has no <!-- ${name} -->.`);
  return text.replace(/^<!-- (\w+) -->$/gm, (comment, name) => parts[name] ?? comment);
}

/** @param {PlannerEntry} planner */
function optionsOf({ id, robots, parameters, presets }) {
  const rows = parameters.map((option) => {
    const only =
      option.robots.length < robots.length
        ? ` (${option.robots.map((robot) => robot.replace("_", " ")).join(", ")})`
        : "";
    const range = option.choices
      ? option.choices.map((choice) => `\`${choice}\``).join(", ")
      : option.kind === "boolean"
        ? ""
        : [option.min, option.max].map((end) => end ?? "").join(" to ");
    const preset = option.default === null ? (option.default_meaning ?? "") : `\`${option.default}\``;
    return `| \`${option.option}\` | ${cell(option.meaning)}${only} | ${cell(range)}${option.unit ? ` ${option.unit}` : ""} | ${cell(preset)} |`;
  });
  const names = presets.map((preset) => `\`${preset.id}\` (${cell(preset.title)})`).join(", ");
  return `## Options

Robots: ${robots.map((robot) => robot.replace("_", " ")).join(", ")}. With \`algorithm: "${id}"\` in JavaScript, where names are in camelCase, or \`--planner ${id} --set name=value\`.

| option | meaning | range | default |
|---|---|---|---|
${rows.join("\n")}
${names ? `\nPresets: ${names}.\n` : ""}`;
}

/** @param {string} text */
function cell(text) {
  return text.replaceAll("|", "\\|").replaceAll("<", "&lt;");
}
