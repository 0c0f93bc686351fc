/** What the page knows of an experiment in a link: other names, and values that it would refuse, are left out. */
import { MADE } from "../../domain/names.js";
import { reasonAgainst, withSeed } from "../../widgets/field.js";

/** @import { Experiment } from "./codec.js" */
/** @import { GeneratorInfo, ParameterInfo, Plan, SceneEntry, Settings } from "../../domain/types.js" */
/** @typedef {{ find: (algorithm: string) => unknown, parametersOf: (algorithm: string) => ParameterInfo[] }} Planners */

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
