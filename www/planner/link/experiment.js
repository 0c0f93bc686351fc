/**
 * The state of the page as an experiment for a link, and back: other names than the page knows, and values that it would
 * refuse, are left out.
 */
import { reasonAgainst, withSeed } from "../../widgets/field.js";
import { keyText } from "../../domain/key-text.js";
import { MADE } from "../../domain/names.js";
import { VIEW } from "../../domain/page-defaults.js";
import { changed } from "../../domain/option-names.js";
import { isProjected } from "../../app/projector.js";

/** @import { KeyPress, Rollout } from "planarium" */
/** @import { Experiment } from "./codec.js" */
/** @import { Configuration, Generation, GeneratorInfo, ParameterInfo } from "../../domain/types.js" */
/** @import { Plan, SceneEntry, Settings } from "../../domain/types.js" */
/** @typedef {{ find: (algorithm: string) => unknown, parametersOf: (algorithm: string) => ParameterInfo[] }} Planners */
/** @typedef {{ record: KeyPress[], steps: number }} Recording */
/**
 * @typedef {object} Drive   of a car, by keys
 * @property {boolean} on
 * @property {() => (Recording & { start: number[] }) | null} record
 * @property {Recording | null} tape   what is still to be replayed
 * @property {Rollout | null} rollout
 * @property {[number, number, number]} rolled
 * @property {number} dt
 */
/**
 * @typedef {object} Moment   what a link takes of the page's session
 * @property {{ now: number, isRace: boolean }} clock
 * @property {{ start: Configuration | null, hand: Float64Array | null } | null} shown
 * @property {Drive | null} driving
 */
/**
 * @typedef {object} Open   what a link takes of the page
 * @property {Experiment} record
 * @property {{ clock: { now: number } } | null} state
 * @property {Plan[]} plans
 * @property {{ shortened: (plan: Plan) => Plan }} planners
 * @property {{ picture: "workspace" | "cspace" } | null} race
 * @property {Moment} session
 * @property {SceneEntry | null} entry
 * @property {Generation | null} generation
 */

/**
 * The state with the moment that is shown. Settings equal to the planner's defaults are left out, and options equal to
 * the scene's.
 * @param {Open} page   with an open scenario
 * @returns {Experiment}
 */
export function experimentOf({ record, state, plans, planners, race, session, entry, generation }) {
  if (!state) throw new Error("No scene is open.");
  const { query, view, scene, document, pace, timing } = record;
  return {
    version: 1,
    query,
    lanes: plans.map((plan) => planners.shortened(plan)),
    iteration: state.clock.now,
    view: {
      ...view,
      poses: view.poses === VIEW.poses ? undefined : view.poses,
      projector: isProjected(),
      lens: plans.length > 1 ? race?.picture : undefined,
    },
    scene,
    document,
    pace,
    timing,
    options: generation ? changed(generation.options, (name) => entry?.generate?.options[name]) : undefined,
    ...inHand(session),
  };
}

/**
 * The configuration in hand, or the drive by keys with the control that is shown.
 * @param {Moment} session
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
 * @param {Experiment} experiment
 * @param {{ scenes: SceneEntry[], generators: GeneratorInfo[], planners: Planners }} catalogue
 * @param {string[]} faults   a sentence is added to it for each part that is left out
 * @returns {Experiment}
 */
export function known(experiment, { scenes, generators, planners }, faults) {
  const { scene = "", document, options = {}, view } = experiment;
  const lanes = experiment.lanes
    .filter(({ algorithm }) => {
      if (!planners.find(algorithm)) faults.push(`There is no planner "${algorithm}".`);
      return planners.find(algorithm);
    })
    .map(({ algorithm, settings }) => ({
      algorithm,
      settings: sift(settings, planners.parametersOf(algorithm), faults),
    }));
  const entry = scenes.find(({ id }) => id === scene);
  const made = entry ? entry.generate?.kind : scene.slice(MADE.length);
  const generator = generators.find(({ id }) => id === made && (entry || scene.startsWith(MADE)));
  const isKnown = document || entry || generator;
  if (!isKnown) faults.push(`There is no scene "${scene}"; the first scene is shown instead.`);
  const own = isKnown ? entry : scenes[0];
  const [first = own && { algorithm: own.algorithm, settings: own.settings }, ...rivals] = lanes;
  return {
    ...experiment,
    scene: document ? undefined : (own?.id ?? scene),
    options: generator && sift(options, withSeed(generator.options, "scene"), faults),
    lanes: first ? [first, ...rivals.map((lane) => withoutSeed(lane, first))] : [],
    view: rivals.length > 0 ? { ...view, lens: view.lens ?? "workspace" } : view,
  };
}

/** A rival without the seed, where it has that of A. @param {Plan} lane @param {Plan} first @returns {Plan} */
function withoutSeed({ algorithm, settings: { seed = 0, ...settings } }, first) {
  return { algorithm, settings: seed === (first.settings.seed ?? 0) ? settings : { ...settings, seed } };
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
