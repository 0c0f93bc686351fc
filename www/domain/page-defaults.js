/**
 * What the planner's page and the gallery plan with where nothing is set: a run that is watched comes to an end soon,
 * and a roadmap has a known number of samples.
 */

/** @import { PlannerInfo, Settings } from "./types.js" */

/** What the planner's page shows besides the run where nothing is set, but for its axes. */
export const VIEW = {
  refused: false,
  strobe: false,
  poses: 8,
  raw: false,
  slice: false,
  optimum: false,
  regions: false,
  widest: false,
  safest: false,
  routes: false,
  detour: 1.5,
};

/** @type {Record<string, Record<string, number>>} */
const OWN = {
  prm: { samples: 2000 },
  "prm-star": { samples: 2000 },
  "lazy-prm": { samples: 2000 },
  "fmt-star": { samples: 1000 },
  "visibility-prm": { failures: 400 },
};
const ALL = { max_iterations: 100_000 };

/**
 * The settings of a plan, with the defaults of the page: all that fit the limit of iterations, if that is set.
 * @param {string} algorithm
 * @param {Settings} settings
 * @returns {Settings}
 */
export function planned(algorithm, settings) {
  /** @type {Settings} */
  const all = { ...ALL, ...OWN[algorithm], ...settings };
  if (settings.samples !== undefined || Number(all.max_iterations) > 2 * Number(all.samples ?? 0) + 2) return all;
  const { samples, ...others } = all;
  return others;
}

/** Planners whose parameters have the defaults of the page. @param {PlannerInfo[]} infos @returns {PlannerInfo[]} */
export function withPageDefaults(infos) {
  return infos.map((info) => {
    const own = planned(info.id, {});
    const parameters = info.parameters.map((given) =>
      own[given.name] === undefined ? given : { ...given, default: own[given.name], default_meaning: null },
    );
    return { ...info, parameters };
  });
}
