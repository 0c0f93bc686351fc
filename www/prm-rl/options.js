/** The options of the methods that plan: as in the core, with usual values of this page for the roadmap. */
import { comparisonOptions, rolloutOptions } from "planarium/full";
import { withSeed } from "../widgets/field.js";

/** @import { ParameterInfo, Settings } from "../domain/types.js" */
/** @import { PlannedWay } from "./commands.js" */

/** The planners of the roadmap, the usual one of each way first. */
const PLANNERS = { learned: ["lazy-prm", "prm"], straight: ["prm", "lazy-prm"] };
const MEANINGS = {
  learned:
    "lazy-prm rolls out only the edges that the best path so far wants; prm those to all neighbours, which takes far longer.",
  straight: "prm proves the edges to all neighbours; lazy-prm only those that the best path so far wants.",
};
/** Samples and neighbours of a roadmap: enough for one query on a floor of this page. @type {Record<string, number>} */
const ROADMAP = { samples: 400, k: 15 };

/** @param {PlannedWay} way @returns {ParameterInfo[]} */
export function optionsOf(way) {
  const edges = way === "prm-rl" ? "learned" : "straight";
  const choices = PLANNERS[edges];
  /** @type {ParameterInfo} */
  const algorithm = {
    name: "algorithm",
    title: "Planner",
    kind: "choice",
    unit: "",
    min: null,
    max: null,
    default: choices[0],
    choices,
    robots: [],
    meaning: MEANINGS[edges],
  };
  const shared = /** @type {ParameterInfo[]} */ (comparisonOptions());
  const roadmap = shared
    .filter(({ name }) => name in ROADMAP)
    .map((info) => ({ ...info, default: ROADMAP[info.name] }));
  // No margin at first: the difference that it makes is what is compared.
  const margin = shared.filter(({ name }) => name === "margin").map((info) => ({ ...info, default: 0 }));
  const own = edges === "straight" ? margin : /** @type {ParameterInfo[]} */ (rolloutOptions());
  return [algorithm, ...own, ...roadmap, ...withSeed([])];
}

/** All options of a way. @param {PlannedWay} way @param {Settings} given  those that differ @returns {Settings} */
export function withDefaults(way, given) {
  return {
    .../** @type {Settings} */ (
      Object.fromEntries(optionsOf(way).flatMap((info) => (info.default === null ? [] : [[info.name, info.default]])))
    ),
    ...given,
  };
}
