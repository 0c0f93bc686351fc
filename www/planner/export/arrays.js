/**
 * Opens NumPy arrays. By their shape, arrays are polygons, which become obstacles, or configurations, which are marked
 * on the stage; where there is a choice, the reader makes it.
 */
import { byId, counted, grouped, make } from "../../app/dom.js";
import { button } from "../../widgets/elements.js";
import { NpyError } from "../../formats/dtype.js";
import { readNpy, readNpyPolygons } from "../../formats/npy.js";

/** @import { Obstacle, ScenarioDocument } from "../../domain/types.js" */
/** @typedef {{ mark: (rows: Float64Array | null) => number }} Marker   marks configurations on the stage */
/**
 * @typedef {object} Page   what is taken of the page
 * @property {{ track: (promise: Promise<unknown>, title: string) => Promise<unknown> }} app
 * @property {{ ask: (text: string, choices: [string, string][]) => Promise<string> }} notice
 * @property {{ dimension: number, document: ScenarioDocument } | null} facts
 * @property {string | undefined} query
 * @property {(patch: { document: ScenarioDocument, query?: string }) => Promise<unknown>} open
 * @property {(action: (session: Marker) => number) => number} run
 * @property {(action: (session: Marker) => void) => void} act
 * @property {(listener: () => void) => void} onOpen
 */

/** Configurations shown at most. */
const MOST = 20_000;

/** The line with the counts of the marks, made once. @type {HTMLElement | undefined} */
let line;

/**
 * What an array holds: a grid of cells, if it has two dimensions, but neither two columns, for points, nor as many as
 * configurations have numbers; with one column more and other numbers than cells it is a path with times.
 * @param {{ dimension: number }} facts
 * @param {Uint8Array} bytes
 * @returns {"cells" | "path" | "points"}
 */
export function arrayKind({ dimension }, bytes) {
  const { shape, data } = numbersOf(bytes) ?? { shape: [], data: [] };
  const [count, width] = shape;
  if (shape.length !== 2 || count === 0 || width <= 2 || width === dimension) return "points";
  return width === dimension + 1 && data.some((number) => ![-1, 0, 1].includes(number)) ? "path" : "cells";
}

/**
 * @param {Page} page  with a scene on its stage
 * @param {string} name  of the file @param {Uint8Array} bytes
 * @param {(() => Promise<unknown>) | null} [judge]   judges configurations as a path, where the page can
 * @throws {Error} with a code: the file is damaged, too large, or of another shape
 */
export async function openArray(page, name, bytes, judge = null) {
  const { facts } = page;
  if (!facts) throw Object.assign(new Error("No scene is open."), { code: "no-scene" });
  const { dimension } = facts;
  const shape = numbersOf(bytes)?.shape;
  const isRows = shape?.length === 2 && shape[1] === dimension && shape[0] > 0;
  const isPolygons = !shape || ((shape.length === 2 || shape.length === 3) && shape.at(-1) === 2);
  if (!isRows && !isPolygons) {
    throw new NpyError(
      `Its shape is (${shape.join(", ")}); it must be (n, m, 2) or (m, 2) for polygons, or (n, ${dimension}) for configurations of this robot.`,
    );
  }
  /** @type {[string, string][]} */
  const choices = [];
  let what = "";
  /** What an array cannot hold. @type {string[]} */
  const lost = [];
  let polygons = /** @type {number[][][]} */ ([]);
  if (isPolygons) polygons = isRows ? maybePolygons(bytes) : readNpyPolygons(bytes);
  if (polygons.length > 0) {
    const vertices = polygons.reduce((sum, polygon) => sum + polygon.length, 0);
    what = `${name} holds ${counted(polygons.length, "polygon")} with ${grouped(vertices)} vertices`;
    if (polygons.length > 1) lost.push("Each polygon is filled: an array has no holes.");
    const { holes, walls } = lostIn(facts.document.world.obstacles);
    if (holes + walls > 0)
      lost.push(`To replace the obstacles removes ${counted(walls, "wall")} and ${counted(holes, "hole")} too.`);
    choices.push(["add", "Add to the scene"], ["replace", "Replace its obstacles"]);
  }
  if (isRows) {
    const also = counted(shape[0], "configuration");
    what = what ? `${what}, or ${also}` : also;
    choices.unshift(["mark", "Show as configurations"]);
  }
  const choice = choices.length === 1 ? choices[0][0] : await page.notice.ask([`${what}.`, ...lost].join(" "), choices);
  if (choice === "mark") await mark(page, name, bytes, judge);
  else if (choice) await build(page, polygons, choice === "replace");
}

/** The numbers of holes and walls, which no array of polygons has. @param {Obstacle[]} obstacles */
function lostIn(obstacles) {
  const holes = obstacles.reduce(
    (sum, obstacle) => sum + (obstacle.type === "polygon" ? (obstacle.holes?.length ?? 0) : 0),
    0,
  );
  return { holes, walls: obstacles.filter(({ type }) => type === "wall").length };
}

/** The polygons of an array that may also be configurations. @param {Uint8Array} bytes */
function maybePolygons(bytes) {
  try {
    return readNpyPolygons(bytes);
  } catch (error) {
    if (error instanceof NpyError) return [];
    throw error;
  }
}

/**
 * An array of numbers, or null for objects.
 * @param {Uint8Array} bytes
 * @throws {NpyError}
 */
function numbersOf(bytes) {
  const isObjects = /["']descr["']\s*:\s*["']\|O/.test(new TextDecoder("latin1").decode(bytes.subarray(0, 512)));
  return isObjects ? null : readNpy(bytes);
}

/**
 * Opens the scene with these obstacles, with the same planners.
 * @param {Page} page
 * @param {number[][][]} polygons
 * @param {boolean} alone
 * @throws {Error} the core refuses one of them
 */
async function build(page, polygons, alone) {
  const { facts, query } = page;
  if (!facts) return;
  const { world } = facts.document;
  const fresh = polygons.map((vertices) => /** @type {Obstacle} */ ({ type: "polygon", vertices }));
  const document = {
    ...facts.document,
    world: { ...world, obstacles: alone ? fresh : [...world.obstacles, ...fresh] },
  };
  await page.open({ document, query });
}

/**
 * Marks configurations, with a line that counts them and a button that removes them.
 * @param {Page} page
 * @param {string} name
 * @param {Uint8Array} bytes
 * @param {(() => Promise<unknown>) | null} judge
 */
async function mark(page, name, bytes, judge) {
  const {
    shape: [all, n],
    data,
  } = readNpy(bytes);
  if (all > MOST) throw new NpyError(`There are ${grouped(all)} configurations; at most ${grouped(MOST)} are shown.`);
  const wrong = data.findIndex((value) => !Number.isFinite(value));
  if (wrong >= 0) throw new NpyError(`Number ${wrong % n} of configuration ${Math.floor(wrong / n)} is not finite.`);
  const free = page.run((session) => session.mark(data));
  const shown = line ?? makeLine(page);
  shown.dataset.free = String(free);
  shown.dataset.count = String(all);
  const drop = () => {
    page.act((session) => session.mark(null));
    shown.hidden = true;
    byId("stage", HTMLElement).focus();
  };
  const clear = button("clear-marks", "Clear", drop);
  const buttons = judge && [
    button("judge-marks", "Judge as a path", () => {
      drop();
      void page.app.track(judge(), `${name} could not be judged.`);
    }),
  ];
  shown.replaceChildren(
    make(
      "span",
      {},
      `${counted(all, "configuration")} of ${name}: `,
      sign("disc"),
      ` ${grouped(free)} free, `,
      sign("cross"),
      ` ${grouped(all - free)} in collision.`,
    ),
    make("span", { className: "buttons" }, ...(buttons ?? []), clear),
  );
  shown.hidden = false;
}

/** Makes the line; it is hidden once another scene is opened. @param {Page} page */
function makeLine(page) {
  const made = make("p", { id: "marked", className: "marked", role: "status", hidden: true });
  byId("stage", HTMLElement).after(made);
  page.onOpen(() => {
    made.hidden = true;
  });
  line = made;
  return made;
}

/** A mark in the text. @param {"disc" | "cross"} kind */
function sign(kind) {
  return make("i", { className: kind, ariaHidden: "true" });
}
