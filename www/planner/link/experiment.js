/**
 * What is on the stage as an experiment that a link can hold, and back. What a link names and the page does not have, or would
 * refuse, is left out, with a sentence for each.
 */
import { reasonAgainst, withSeed } from "../../widgets/field.js";
import { axesOf } from "../../domain/names.js";
import { isProjected } from "../../app/projector.js";

/** @import { Page } from "../page.js" */
/** @import { Experiment } from "./codec.js" */
/** @import { GeneratorInfo, OptionInfo, ParameterInfo, Plan, SceneEntry, Settings, Source } from "../../domain/types.js" */
/** @typedef {{ source: Source | null, entry: SceneEntry | undefined, plans: Plan[] | undefined }} Found   no source: the entry's own */

/** Poses along a path, unless others are wanted. */
export const POSES = 8;

/** Begins the name of a scenario that was made from a generator of the core, and is none of the page's scenes. */
const MADE = "make-";

/**
 * Exactly what is on the stage now. Settings that are the planner's defaults are left out, and options that are the scene's.
 * @param {Page} page   with a scenario on its stage
 * @returns {Experiment}
 */
export function experimentOf({ entry, source, facts, state, asked, panel, race }) {
  if (!source || !facts || !state) throw new Error("No scene is open.");
  const query = panel.query.value;
  const { axes, refused, strobe, poses, raw, slice } = state.view;
  /** @type {Experiment} */
  const experiment = {
    version: 1,
    query: query && query !== facts.queries[0] ? query : undefined,
    lanes: asked.map(({ algorithm, settings }) => {
      const usual = new Map(panel.parametersOf(algorithm).map(({ name, default: value }) => [name, value]));
      return { algorithm, settings: others(settings, (name) => usual.get(name)) };
    }),
    iteration: state.clock.now,
    view: {
      axes: String(axes) === String(axesOf(facts.robot)) ? undefined : axes, refused, strobe, poses: poses === POSES ? undefined : poses, raw, slice,
      projector: isProjected(), lens: asked.length > 1 ? race?.picture : undefined,
    },
  };
  const made = "generate" in source ? source.generate : null;
  if (entry) experiment.scene = entry.id;
  else if (made) experiment.scene = MADE + made.kind;
  else experiment.document = { ...facts.document };
  if (made) experiment.options = others(made.options, (name) => entry?.generate?.options[name]);
  return experiment;
}

/** The settings that are not as usual, by name in order: one experiment, one link. @param {Settings} settings @param {(name: string) => unknown} usual @returns {Settings} */
function others(settings, usual) {
  return Object.fromEntries(Object.entries(settings).filter(([name, value]) => value !== usual(name)).sort());
}

/**
 * What an experiment asks for, as far as the page has it.
 * @param {Experiment} experiment
 * @param {{ scenes: SceneEntry[], generators: GeneratorInfo[], page: Page }} house
 * @param {string[]} faults   sentences are added to it
 * @returns {Found}
 */
export function find({ scene = "", document, lanes, options = {} }, { scenes, generators, page: { panel } }, faults) {
  /** @param {GeneratorInfo["id"]} kind @param {Settings} [base] @returns {Source} */
  const generated = (kind, base) => {
    const table = withSeed(generators.find(({ id }) => id === kind)?.options ?? [], "scene");
    return { generate: { kind, options: { ...base, ...sift(options, table, faults) } } };
  };
  const plans = lanes.filter(({ algorithm }) => {
    const known = panel.infos.some(({ id }) => id === algorithm);
    if (!known) faults.push(`There is no planner "${algorithm}".`);
    return known;
  }).map(({ algorithm, settings }) => ({ algorithm, settings: sift(settings, panel.parametersOf(algorithm), faults) }));
  const found = { plans: plans.length > 0 ? plans : undefined };
  if (document) return { ...found, source: { document }, entry: undefined };
  const made = generators.find(({ id }) => MADE + id === scene);
  if (made) return { ...found, source: generated(made.id), entry: undefined };
  const entry = scenes.find(({ id }) => id === scene);
  if (!entry) faults.push(`There is no scene "${scene}"; the first scene is shown instead.`);
  return { ...found, source: entry?.generate ? generated(entry.generate.kind, entry.generate.options) : null, entry: entry ?? scenes[0] };
}

/** Settings that a table takes; for the others a sentence each. @param {Settings} settings @param {(ParameterInfo | OptionInfo)[]} table @param {string[]} faults @returns {Settings} */
function sift(settings, table, faults) {
  return Object.fromEntries(Object.entries(settings).filter(([name, value]) => {
    const info = table.find((one) => one.name === name);
    const reason = info ? reasonAgainst(info, value) : "There is no such option.";
    if (reason) faults.push(`${info?.title || name}: ${reason}`);
    return reason === "";
  }));
}
