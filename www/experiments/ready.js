/** Ready experiments: the documents beside this file, and the views of some of them. */

import { loadText } from "../app/resources.js";
import { plannerTitle } from "./factors.js";
import { resolved } from "./worlds.js";

/** @import { LinkedDocument } from "../domain/types.js" */
/** @import { ExperimentState, View } from "./link.js" */

/**
 * The names of the files and the titles of their documents: the build writes them.
 * @type {{ id: string, title: string }[]}
 */
const DOCUMENTS = /** @type {any} */ (globalThis).EXPERIMENTS;

/** The views, and at the same time the order of the first ones. @type {Record<string, View>} */
const VIEWS = {
  "more-neighbours": { chart: "line", axis: "planner.k", measure: "solved" },
  blossom: { chart: "box", axis: "world", measure: "iterations", isLog: true },
  "arm-edge-checks": { chart: "heat", measure: "valid", axis: "planner.samples", second: "planner.edge_check" },
  "arm-neighbours": { chart: "line", measure: "length", axis: "planner.k" },
  "arm-unchecked": { chart: "success", measure: "valid", axis: "world" },
  "arm-planners": { chart: "box", measure: "length", axis: "world" },
  "body-planners": { chart: "box", measure: "length", axis: "world" },
  "car-blossom": { chart: "box", measure: "chord_length", axis: "planner.blossom" },
  "car-mazes": { chart: "box", measure: "vertices", axis: "world", isLog: true },
  "car-schedule": { chart: "box", measure: "iterations", axis: "world", isLog: true },
  "forest-approximate": { chart: "box", measure: "visited", axis: "planner" },
  "arm-samples": { chart: "line", measure: "solved", axis: "planner.samples" },
  "forest-bidirectional": { chart: "line", measure: "visited", axis: "planner.samples", isLog: true },
  "forest-neighbours": { chart: "line", measure: "length", axis: "planner.k" },
  "forest-build-times": { chart: "box", measure: "build_seconds", axis: "world.links", isLog: true },
  "forest-searches-2r": { chart: "box", measure: "visited", axis: "planner", isLog: true },
  "forest-searches-3r": { chart: "box", measure: "visited", axis: "planner", isLog: true },
  "forest-searches-4r": { chart: "box", measure: "visited", axis: "planner", isLog: true },
  "three-planners": { chart: "ecdf", work: "clearance_evaluations", isLog: true },
};

const order = Object.keys(VIEWS);
/** @param {string} id */
const placeOf = (id) => (order.includes(id) ? order.indexOf(id) : order.length);

/** All ready experiments. */
export const READY = DOCUMENTS.toSorted((a, b) => placeOf(a.id) - placeOf(b.id) || a.title.localeCompare(b.title));

/** @param {string} id @returns {Promise<ExperimentState>} */
export async function loadReady(id) {
  const document = /** @type {LinkedDocument} */ (JSON.parse(await loadText(`experiments/documents/${id}.json`)));
  return { document, view: VIEWS[id] ?? {} };
}

/**
 * The ready experiment with the same document, or empty; its view may differ. An experiment is known, too, where it has
 * only some of the worlds of a ready one.
 * @param {LinkedDocument} document
 * @returns {Promise<{ id: string, isKnown: boolean }>}
 */
export async function readyOf(document) {
  const id = READY.find(({ title }) => title === document.title)?.id;
  if (!id) return { id: "", isKnown: false };
  // A link holds the scenarios that a file names.
  const [one, own] = await Promise.all(
    [document, (await loadReady(id)).document].map((each) => resolved(each).catch(() => null)),
  );
  if (!one || !own || !Array.isArray(one.worlds)) return { id: "", isKnown: false };
  const text = (/** @type {unknown} */ value) => JSON.stringify(value);
  const worlds = own.worlds.map(text);
  const isKnown =
    text({ ...one, worlds: [] }) === text({ ...own, worlds: [] }) &&
    one.worlds.every((world) => worlds.includes(text(world)));
  return { id: isKnown && one.worlds.length === worlds.length ? id : "", isKnown };
}

/**
 * The title of a changed document: that of a ready experiment becomes one of its planners and worlds; a title by the
 * reader stays.
 * @param {LinkedDocument} before
 * @param {LinkedDocument} after
 * @returns {string | undefined}
 */
export function retitled(before, after) {
  const { title } = before;
  const isOurs = !title || title === namesOf(before) || READY.some((ready) => ready.title === title);
  return isOurs ? namesOf(after) : title;
}

/**
 * A document with the shape that the page needs, of anything that was opened; what the core refuses may have another.
 * @template {object} D
 * @param {D} document
 * @returns {D}
 */
export function shaped(document) {
  const { title, worlds, planners } = Object(document);
  const objects = (/** @type {unknown} */ list) =>
    Array.isArray(list) ? list.filter((one) => typeof one === "object" && one !== null) : [];
  const needed = {
    title: typeof title === "string" ? title : undefined,
    worlds: objects(worlds),
    planners: objects(planners),
  };
  const isShaped =
    title === needed.title &&
    [worlds, planners].every((list, i) => list?.length === [needed.worlds, needed.planners][i].length);
  return isShaped ? document : { ...document, ...needed };
}

/**
 * "RRT against RRT*", "RRT in 3 worlds", "PRM by k".
 * @param {LinkedDocument} document
 * @returns {string | undefined}  undefined: it has not the shape of a document
 */
function namesOf({ planners, worlds }) {
  if (!Array.isArray(planners)) return undefined;
  const names = planners.map(plannerTitle);
  if (names.length > 2) return `${names.slice(0, -1).join(", ")} and ${names[names.length - 1]}`;
  if (names.length === 2) return names.join(" against ");
  const varied = Object.keys(planners[0]?.vary ?? {}).map((name) => name.replaceAll("_", " "));
  if (varied.length > 0) return `${names[0]} by ${varied.join(" and ")}`;
  return Array.isArray(worlds) && worlds.length > 1 ? `${names[0]} in ${worlds.length} worlds` : names[0];
}
