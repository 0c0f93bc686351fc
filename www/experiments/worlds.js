/** Worlds of a document: built-in scenes by name become what the core reads, and the robots of all of them. */
import { Scenario } from "planarium/full";
import { withOptions } from "../domain/option-names.js";
import { unitOf } from "../domain/names.js";
import { SCENES } from "../planner/scenes/scenes.js";
import { loadScene, loadText } from "../app/resources.js";
import { nameOf, valuesOf } from "./factors.js";

/** @import { ExperimentDocument, ExperimentWorld } from "planarium/full" */
/** @import { LinkedDocument, LinkedWorld, Settings } from "../domain/types.js" */
/** @import { Rows } from "./rows.js" */
/** @typedef {Scenario["robot"]} Robot */
/**
 * The world of a trial.
 * @typedef {{ scenario: import("planarium/full").ScenarioDocument } | { generate:
 *   import("planarium/full").GeneratorId, options: Settings }} TrialWorld
 */

/**
 * A document that the core reads.
 * @param {LinkedDocument} document
 * @returns {Promise<ExperimentDocument>}
 * @throws {Error} a scene is unknown
 */
export async function resolved(document) {
  // The core says what is wrong with anything else.
  if (!Array.isArray(document?.worlds)) return /** @type {any} */ (document);
  return { ...document, worlds: await Promise.all(document.worlds.map(worldOf)) };
}

/** @param {LinkedWorld} world @param {number} i @returns {Promise<ExperimentWorld>} */
async function worldOf(world, i) {
  if (typeof world !== "object" || world === null) return /** @type {any} */ (world);
  if ("scenario" in world && typeof world.scenario === "string")
    return { ...world, scenario: await fetched(world.scenario, i) };
  if (!("scene" in world)) return /** @type {ExperimentWorld} */ (world);
  const { scene, ...rest } = world;
  const entry = SCENES.find(({ id }) => id === scene);
  if (entry?.generate) {
    const { seed = 0, ...set } = entry.generate.options;
    return { name: scene, ...rest, generate: entry.generate.kind, set, seeds: [Number(seed)] };
  }
  if (!entry)
    throw Object.assign(new Error(`There is no scene "${scene}".`), {
      code: "unknown-scene",
      pointer: `/worlds/${i}/scene`,
    });
  return { name: scene, ...rest, scenario: JSON.parse(await loadScene(scene)) };
}

/**
 * The scenario in a file of this site, relative to the ready experiments, as on the command line.
 * @param {string} path
 * @param {number} i
 */
async function fetched(path, i) {
  const wrong = (/** @type {string} */ reason) =>
    Object.assign(new Error(`The file "${path}" ${reason}.`), { code: "file", pointer: `/worlds/${i}/scenario` });
  if (!/^[\w-.]+(\/[\w-.]+)*\.json$/.test(path)) throw wrong("is not a file of this site");
  const { pathname } = new URL(path, "site:/experiments/documents/");
  try {
    return JSON.parse(await loadText(pathname.slice(1)));
  } catch {
    throw wrong("cannot be read");
  }
}

/**
 * @param {ExperimentDocument} document
 * @param {Rows} rows
 * @param {number} trial  that has ended
 * @returns {TrialWorld}
 */
export function worldOfTrial(document, rows, trial) {
  const world = document.worlds.find((entry) => nameOf(entry) === rows.cell(trial, "world"));
  if (!world) throw new Error(`Trial ${trial} is of another experiment.`);
  if ("scenario" in world) return { scenario: world.scenario };
  return {
    generate: world.generate,
    options: /** @type {Settings} */ ({
      ...world.set,
      ...variedOf(rows, trial, "world", world.vary),
      seed: rows.cell(trial, "world_seed"),
    }),
  };
}

/**
 * The parameters of a trial that vary.
 * @param {Rows} rows
 * @param {number} trial
 * @param {"world" | "planner"} prefix
 * @param {object | undefined} axes
 */
export function variedOf(rows, trial, prefix, axes) {
  return Object.fromEntries(Object.keys(axes ?? {}).map((name) => [name, rows.cell(trial, `${prefix}.${name}`)]));
}

/** The title of a world. @param {LinkedWorld} world */
export function titleOf(world) {
  if ("scene" in world) return world.name ?? SCENES.find(({ id }) => id === world.scene)?.title ?? world.scene;
  if (world.name) return world.name;
  if ("generate" in world) return world.generate;
  const { scenario } = world;
  return typeof scenario === "string"
    ? scenario.replace(/^.*\/|\.json$/g, "")
    : scenario?.title || scenario?.name || "world";
}

/**
 * The types of robots of all worlds.
 * @param {ExperimentDocument} document
 * @returns {Robot[]}  empty: a world has a fault, which the core names
 */
export function robotsOf(document) {
  return [...new Set(ofWorlds(document, ({ robot }) => robot))];
}

/**
 * The units of path lengths by the names of worlds; empty where metres and radians are added.
 * @param {ExperimentDocument} document
 * @returns {Map<string, string>}
 */
export function lengthUnits(document) {
  const units = ofWorlds(document, (scenario) => unitOf(scenario.document().robot));
  return new Map(units.map((unit, i) => [nameOf(document.worlds[i]), unit]));
}

/**
 * What there is in each world; nothing if a world has a fault.
 * @template T
 * @param {ExperimentDocument} document
 * @param {(scenario: Scenario) => T} read
 * @returns {T[]}
 */
function ofWorlds({ worlds }, read) {
  try {
    return worlds.map((world) => {
      const scenario = "scenario" in world ? Scenario.parse(world.scenario) : generated(world);
      const found = read(scenario);
      scenario.free();
      return found;
    });
  } catch {
    return [];
  }
}

/** The first world of a generator. @param {Extract<ExperimentWorld, { generate: string }>} world */
function generated({ generate, set, vary, seeds = [0] }) {
  const first = Object.fromEntries(Object.entries(vary ?? {}).map(([name, axis]) => [name, valuesOf(axis)[0]]));
  const seed = Array.isArray(seeds) ? seeds[0] : seeds.from;
  return withOptions({ ...set, ...first, seed }, (options) => Scenario.generate(generate, options));
}
