/**
 * Converts the state of the page to an experiment and back. Names in a link that the page does not know, and values
 * that it would refuse, are left out, with a sentence for each.
 */
import { reasonAgainst, withSeed } from "../../widgets/field.js";
import { keyText } from "../../domain/key-text.js";
import { axesOf } from "../../domain/names.js";
import { isProjected } from "../../app/projector.js";

/** @import { Page } from "../page.js" */
/** @import { Session } from "../session.js" */
/** @import { Experiment } from "./codec.js" */
/** @import { GeneratorInfo, ParameterInfo, Plan, SceneEntry, Settings, Source } from "../../domain/types.js" */
/**
 * @typedef {{ source: Source | null, entry: SceneEntry | undefined, plans: Plan[] | undefined }} Found   no source: the
 *   entry's own
 */

/** Configurations drawn along a path, by default. */
export const POSES = 8;

/** Begins the name of a generated scenario that is not a built-in scene. */
const MADE = "make-";

/**
 * The current state. Settings equal to the planner's defaults are left out, and options equal to the scene's.
 * @param {Page} page   with an open scenario
 * @returns {Experiment}
 */
export function experimentOf({ entry, source, facts, state, current, panel, race, session }) {
  if (!source || !facts || !state) throw new Error("No scene is open.");
  const query = panel.query.value;
  const { axes, refused, strobe, poses, raw, slice, optimum, regions } = state.view;
  /** @type {Experiment} */
  const experiment = {
    version: 1,
    query: query && query !== facts.queries[0] ? query : undefined,
    lanes: current.map(({ algorithm, settings }) => {
      const usual = new Map(panel.parametersOf(algorithm).map(({ name, default: value }) => [name, value]));
      return { algorithm, settings: changed(settings, (name) => usual.get(name)) };
    }),
    iteration: state.clock.now,
    view: {
      axes: String(axes) === String(axesOf(facts.robot)) ? undefined : axes,
      refused,
      strobe,
      poses: poses === POSES ? undefined : poses,
      raw,
      slice,
      optimum,
      regions,
      projector: isProjected(),
      lens: current.length > 1 ? race?.picture : undefined,
    },
  };
  const made = "generate" in source ? source.generate : null;
  if (entry) experiment.scene = entry.id;
  else if (made) experiment.scene = MADE + made.kind;
  else experiment.document = { ...facts.document };
  if (made) experiment.options = changed(made.options, (name) => entry?.generate?.options[name]);
  return { ...experiment, ...inHand(session) };
}

/**
 * The configuration in hand, or the drive by keys with the control that is shown.
 * @param {Session} session
 * @returns {Pick<Experiment, "pose" | "drive" | "roll" | "euler">}
 */
function inHand({ shown, driving }) {
  const recording = driving?.record();
  if (!shown?.hand) return {};
  if (!driving || !recording) return { pose: [...shown.hand] };
  const { start, record, steps } = recording;
  const { tape, rollout, rolled, dt } = driving;
  return {
    drive: {
      start: String(start) === String(shown.start) ? undefined : start,
      // Of a recording that is being replayed, all of it.
      keys: keyText([...record, ...(tape?.record ?? [])]),
      steps: tape?.steps ?? steps,
    },
    roll: rollout ? rolled : undefined,
    euler: dt || undefined,
  };
}

/**
 * The settings that differ from the usual ones, sorted by name so that equal experiments have equal links.
 * @param {Settings} settings
 * @param {(name: string) => unknown} usual
 * @returns {Settings}
 */
function changed(settings, usual) {
  return Object.fromEntries(
    Object.entries(settings)
      .filter(([name, value]) => value !== usual(name))
      .sort(),
  );
}

/**
 * Finds the scene and the planners of an experiment.
 * @param {Experiment} experiment
 * @param {{ scenes: SceneEntry[], generators: GeneratorInfo[], page: Page }} catalogue
 * @param {string[]} faults   sentences are added to it
 * @returns {Found}
 */
export function find({ scene = "", document, lanes, options = {} }, { scenes, generators, page: { panel } }, faults) {
  /** @param {GeneratorInfo["id"]} kind @param {Settings} [base] @returns {Source} */
  const generated = (kind, base) => {
    const table = withSeed(generators.find(({ id }) => id === kind)?.options ?? [], "scene");
    return { generate: { kind, options: { ...base, ...sift(options, table, faults) } } };
  };
  const plans = lanes
    .filter(({ algorithm }) => {
      const known = panel.infos.some(({ id }) => id === algorithm);
      if (!known) faults.push(`There is no planner "${algorithm}".`);
      return known;
    })
    .map(({ algorithm, settings }) => ({ algorithm, settings: sift(settings, panel.parametersOf(algorithm), faults) }));
  const found = { plans: plans.length > 0 ? plans : undefined };
  if (document) return { ...found, source: { document }, entry: undefined };
  const made = generators.find(({ id }) => MADE + id === scene);
  if (made) return { ...found, source: generated(made.id), entry: undefined };
  const entry = scenes.find(({ id }) => id === scene);
  if (!entry) faults.push(`There is no scene "${scene}"; the first scene is shown instead.`);
  return {
    ...found,
    source: entry?.generate ? generated(entry.generate.kind, entry.generate.options) : null,
    entry: entry ?? scenes[0],
  };
}

/**
 * The settings that a table accepts; each other one adds a sentence to the faults.
 * @param {Settings} settings
 * @param {ParameterInfo[]} table
 * @param {string[]} faults
 * @returns {Settings}
 */
function sift(settings, table, faults) {
  return Object.fromEntries(
    Object.entries(settings).filter(([name, value]) => {
      const info = table.find((one) => one.name === name);
      const reason = info ? reasonAgainst(info, value) : "There is no such option.";
      if (reason) faults.push(`${info?.title || name}: ${reason}`);
      return reason === "";
    }),
  );
}
