/**
 * A world of another program on the planner's page: it is opened with a planner that suits it, its cells lie under the
 * obstacles, and a line below the stage says what it is, changes how it was read, and undoes its opening.
 */
import { byId, counted, grouped, make } from "../app/dom.js";
import { once } from "../app/once.js";
import { namesOf } from "../app/read-files.js";
import { button } from "../widgets/elements.js";
import { Door } from "../worlds/door.js";
import { loadStyle } from "../app/site.js";
import { CellPicture } from "../worlds/picture.js";
import { formatName } from "../worlds/words.js";

/** @import { OpenedWorld } from "../worlds/door.js" */
/** @import { Patch } from "./experiment.js" */
/** @import { OpenWorld } from "./stage/lane.js" */
/** @import { Page } from "./page.js" */
/** @import { Grid } from "../worlds/types.js" */

/** Iterations a second. */
const PACE = 400;
/** As the package and the command line plan where no planner is named: raw paths of trees are long. */
const PLANNER = { algorithm: "rrt-connect", settings: { reduce: true, shortcut: 200 } };

/** @type {Door | undefined} */
let door;
/** @type {(() => Promise<Door>) | undefined} */
let loading;
/** @type {HTMLElement} */
let line;

/** The door of the page, which is made once. @param {Page} page */
export const doorOf = (page) => (loading ??= once(() => makeDoor(page)))();

/** @param {Page} page */
async function makeDoor(page) {
  await loadStyle();
  line = make("p", { id: "world-line", className: "marked", hidden: true });
  byId("stage", HTMLElement).after(line);
  page.onOpen(() => {
    // By the panel, or by another file that was dropped on it.
    if (door?.panel.dialog.open) door.close();
    show(page);
  });
  door = new Door(page.app, (world) => use(page, world));
  return door;
}

/** What is open now, to return to it. @param {Page} page @returns {OpenWorld["before"]} */
function now({ record, state, session, title }) {
  const { scene, options, query, lanes, view } = record;
  const isOwn = !state?.isEdited && scene !== undefined;
  const source = isOwn ? { scene, options } : { document: session.shown?.document, pace: session.clock.pace };
  // One step is undone: what was before that is forgotten.
  const { opened = null, map } = session.shown?.world ?? {};
  return { name: title, patch: { ...source, query, lanes, view }, opened, map };
}

/**
 * Opens a world or a scene in place of what is open, which can be undone.
 * @param {Page} page
 * @param {Patch} patch
 * @param {OpenedWorld | null} opened
 * @param {Grid | undefined} grid   the cells that its obstacles were made of
 */
async function open(page, patch, opened, grid) {
  const before = now(page);
  if (!(await page.open(patch))) return;
  const { shown, stage } = page.session;
  if (!shown) return;
  const map = grid && new CellPicture(grid, shown.document.world.obstacles);
  shown.world = { opened, before, map };
  shown.window = map?.window;
  stage.invalidate();
  page.session.markDirty();
  show(page);
}

/** @param {Page} page @param {OpenedWorld} opened */
async function use(page, opened) {
  const { document, query, grid } = opened;
  const { record, session } = page;
  // A world that is read in another way keeps its planner.
  const isAgain = Boolean(session.shown?.world?.opened);
  const [lanes, pace] = isAgain ? [record.lanes, session.clock.pace] : [[PLANNER], PACE];
  await open(page, { document, query, lanes, pace }, opened, grid);
}

/** Shows the line. @param {Page} page */
function show(page) {
  const { world } = page.session.shown ?? {};
  line.hidden = !world;
  if (!world) return;
  const { opened, before } = world;
  const { name, patch, opened: earlier, map } = before;
  const undo = () => void page.app.track(open(page, /** @type {Patch} */ (patch), earlier, map?.grid));
  line.replaceChildren(
    make("span", {}, opened ? wordsOf(opened) : `${name} was closed.`),
    make(
      "span",
      { className: "buttons" },
      ...(opened ? [button("world-change", "Change\u2026", () => void door?.reopen(opened))] : []),
      button("world-undo", opened ? "Undo opening" : `Open ${name} again`, undo),
    ),
  );
}

/** @param {OpenedWorld} opened */
function wordsOf({ report, files }) {
  const { polygons, discs, walls } = report.obstacles;
  const size = report.grid ? `${grouped(report.grid.width)} \u00d7 ${grouped(report.grid.height)} cells, ` : "";
  return `${formatName(report)} ${namesOf(files)}: ${size}${counted(polygons + discs + walls, "obstacle")}.`;
}
