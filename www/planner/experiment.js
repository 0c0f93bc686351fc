/**
 * The state of the page is one plain record, the experiment that a link stores: scene or document, options, query,
 * lanes (each a planner with the settings given to it), view. All that the page shows is derived from it. A change is a
 * patch: entries that are replaced. What a patch may contain is checked here, and what depends on it is made to agree
 * in one order.
 */
import { loadScene } from "../app/resources.js";
import { MADE, axesOf } from "../domain/names.js";
import { VIEW } from "../domain/page-defaults.js";
import { fits, withArticle } from "./settings/planners.js";
import { letter } from "./race/standings.js";
import { SCENES } from "./scenes/scenes.js";

/** @import { Experiment } from "./link/codec.js" */
/** @import { Planners } from "./settings/planners.js" */
/** @import { Generation, Plan, Scenario, SceneEntry, Source, ViewOptions } from "../domain/types.js" */
/** @typedef {Partial<Omit<Experiment, "document"> & { document: object | string }>} Patch */
/** @typedef {{ robot: Scenario["robot"], dimension: number, queries: string[] }} Facts   of a scenario */

/** Before a scene is opened. @type {Experiment} */
export const EMPTY = { version: 1, lanes: [], iteration: 0, view: { strobe: true } };

/** Another scene than the open one, with its first query. @satisfies {Patch} */
export const ELSEWHERE = {
  scene: undefined,
  document: undefined,
  options: undefined,
  pace: undefined,
  query: undefined,
};

/**
 * What is made to agree with the record, in this order, and the entries that it depends on. "opened" stands for a
 * scenario that was read; entries of the moment, such as the iteration, are obeyed whenever a patch has them.
 */
export const ORDER = /** @type {const} */ ([
  ["scenario", ["opened"]],
  ["settings", ["opened", "scene", "lanes"]],
  ["rivals", ["opened", "lanes"]],
  ["view", ["opened", "view"]],
  ["run", ["opened", "query", "lanes"]],
  ["figures", ["opened", "lanes", "view"]],
  ["news", ["opened", "scene", "document"]],
  ["time", ["iteration"]],
  ["hand", ["pose"]],
  ["timing", ["opened", "timing"]],
]);
const MOMENT = new Set(["opened", "iteration", "pose"]);

/** @typedef {typeof ORDER[number][0]} Part */

/**
 * Makes the parts agree that depend on something that differs.
 * @param {Experiment} before
 * @param {Experiment} after
 * @param {Record<string, unknown>} patch   what was asked for, and `opened`
 * @param {Record<Part, () => void>} parts
 */
export function reconcile(before, after, patch, parts) {
  const isDue = (/** @type {string} */ entry) =>
    MOMENT.has(entry)
      ? patch[entry] !== undefined
      : !same(/** @type {any} */ (before)[entry], /** @type {any} */ (after)[entry]);
  for (const [part, entries] of ORDER) if (entries.some(isDue)) parts[part]();
}

/** Whether two values of JSON are the same; an undefined entry is absent. @param {any} a @param {any} b @returns {boolean} */
export function same(a, b) {
  if (a === b || typeof a !== "object" || typeof b !== "object" || !a || !b) return a === b;
  return [...new Set([...Object.keys(a), ...Object.keys(b)])].every((key) => same(a[key], b[key]));
}

/** The built-in scene. @param {Pick<Experiment, "scene">} experiment @returns {SceneEntry | null} */
export const entryOf = ({ scene }) => SCENES.find(({ id }) => id === scene) ?? null;

/** What generates the scene, if something does. @param {Pick<Experiment, "scene" | "options">} experiment */
export function generationOf({ scene = "", options }) {
  const base = entryOf({ scene })?.generate;
  if (!base && !scene.startsWith(MADE)) return null;
  const kind = base?.kind ?? scene.slice(MADE.length);
  return /** @type {Generation} */ ({ kind, options: { ...base?.options, ...options } });
}

/** The origin of the scenario. @param {Patch} experiment @returns {Promise<Source>} */
export async function sourceOf({ scene, document = {}, options }) {
  const generate = generationOf({ scene, options });
  return generate ? { generate } : { document: scene ? await loadScene(scene) : document };
}

/** The planner of a built-in scene itself. @param {SceneEntry} entry @returns {Plan} */
export const laneOf = ({ algorithm, settings }) => ({ algorithm, settings });

/** The view with all its options. @param {Experiment["view"]} view @param {Facts["robot"]} robot @returns {ViewOptions} */
export function viewOf({ projector: _, lens: __, ...view }, robot) {
  const [across, up] = view.axes ?? axesOf(robot);
  return { ...VIEW, ...view, axes: [across, up] };
}

/**
 * An experiment whose parts fit a scenario, and a sentence for each one that was replaced or left out.
 * @param {Experiment} experiment
 * @param {Facts} facts   of its scenario
 * @param {Planners} planners
 * @param {{ was?: Facts["robot"], isAsGiven?: boolean }} [how]   `was`: the robot that the lanes were for, if any;
 *   `isAsGiven`: planners stay, which the core then refuses
 * @returns {{ experiment: Experiment, faults: string[] }}
 */
export function fitted(experiment, facts, planners, { was, isAsGiven = false } = {}) {
  const { robot, dimension, queries } = facts;
  const { query, view, pose, drive, roll, euler, timing } = experiment;
  /** @type {string[]} */
  const faults = [];
  const lanes = isAsGiven ? experiment.lanes : served(experiment, robot, planners, faults);
  for (const { algorithm, settings } of lanes)
    for (const info of planners.parametersOf(algorithm)) {
      const value = settings[info.name];
      const isNew = was === undefined || fits(info, was);
      const isLost = value !== undefined && value !== info.default && !fits(info, robot) && isNew;
      if (isLost) faults.push(`${info.title || info.name} has no effect on ${withArticle(robot)}.`);
    }
  const hasQuery = query === undefined || queries.includes(query);
  if (!hasQuery) faults.push(`This scene has no query "${query}".`);
  const [across, up] = view.axes ?? axesOf(robot);
  const hasAxes = Math.max(across, up) < dimension && across !== up;
  if (view.axes && !hasAxes) faults.push(`This robot has no coordinates ${across} and ${up}.`);
  const isUsual = !hasAxes || String(view.axes) === String(axesOf(robot));
  const isDriven = drive !== undefined || roll !== undefined || euler !== undefined;
  if (isDriven && robot !== "car") faults.push("This robot cannot be driven.");
  const hasPose = pose?.length === dimension;
  if (pose && !hasPose && !isDriven)
    faults.push(`The configuration has ${pose.length} numbers; one of this robot has ${dimension}.`);
  return {
    experiment: {
      ...experiment,
      lanes,
      query: hasQuery && query !== queries[0] ? query : undefined,
      view: isUsual ? { ...view, axes: undefined } : view,
      pose: hasPose && !isDriven ? pose : undefined,
      // Limits of another robot have no meaning.
      timing: timing && was !== undefined && was !== robot ? { pace: timing.pace } : timing,
    },
    faults,
  };
}

/**
 * The lanes whose planners serve a robot: the first one is replaced where it does not, others are removed.
 * @param {Experiment} experiment
 * @param {Facts["robot"]} robot
 * @param {Planners} planners
 * @param {string[]} faults   sentences are added to it
 * @returns {Plan[]}
 */
function served(experiment, robot, planners, faults) {
  const [first, ...rivals] = experiment.lanes;
  const entry = entryOf(experiment);
  const infos = planners.for(robot);
  // By default a planner with two trees.
  const { id: algorithm } = infos.find(({ grows }) => grows === "trees") ?? infos[0];
  const own = entry ? laneOf(entry) : { algorithm, settings: first?.settings ?? {} };
  const isServed = (/** @type {Plan} */ lane) => planners.serves(lane.algorithm, robot);
  if (first && !isServed(first))
    faults.push(
      `${planners.needs(first.algorithm)}; this scene has ${withArticle(robot)}: ${planners.titleOf(own.algorithm)} is used${rivals.length > 0 ? " as A" : ""}.`,
    );
  rivals.forEach((lane, i) => {
    if (!isServed(lane)) faults.push(`${planners.needs(lane.algorithm)}, so rival ${letter(i + 1)} was removed.`);
  });
  return [first && isServed(first) ? first : own, ...rivals.filter(isServed)];
}
