/** The state that a link stores; a list from a file is not in it. */
import { Scenario } from "planarium";
import { flag, list, name, number, record, rule, settings, whole, withDefaults } from "../formats/rules.js";
import { ROBOTS } from "./robots.js";

/** @import { NeighboursOptions } from "planarium" */
/** @import { NeighbourSession } from "./session.js" */
/** @import { IndexId, Sampling, Settings } from "./types.js" */

/** @typedef {{ robot: string, draw: Sampling, q?: number[], k?: number, index: IndexId, given: Settings }} State */

/** A whole number in a range. @param {number} least @param {number} most */
const between = (least, most) => rule((value) => Number.isInteger(value) && Number(value) >= least && Number(value) <= most);

export const stateRule = withDefaults({
  robot: rule((value) => ROBOTS.some(({ id }) => id === value)), draw: record({ n: between(100, 100_000), seed: whole(999), free: flag }),
  q: list(number, 1, 8), k: between(1, 500), index: name, given: settings,
}, { robot: ROBOTS[0].id, draw: {}, index: "kd-tree", given: {} });

/** @param {NeighbourSession} session @returns {State} */
export function stateOf({ entry, sampling, q, k, index, given }) {
  return { robot: entry.id, draw: sampling, q: Array.from(q, (value) => Number(value.toFixed(6))), k, index, given };
}

/** @param {NeighbourSession} session @param {State} state @throws {Error} the core refuses it */
export async function openState(session, { robot, draw, q, k, index, given }) {
  const entry = ROBOTS.find(({ id }) => id === robot) ?? ROBOTS[0];
  // The core checks the options before anything changes.
  const scenario = Scenario.parse(entry.document);
  try {
    scenario.neighbours({ index }).free();
    scenario.neighbours(/** @type {NeighboursOptions} */ ({ ...given, index: "forest" })).free();
  } finally {
    scenario.free();
  }
  Object.assign(session, { sampling: { ...session.sampling, ...draw }, index, given });
  await session.open(entry, { q, k });
}
