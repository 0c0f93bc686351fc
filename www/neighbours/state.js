/** The state that a link stores; a list from a file is not in it. */
import { Scenario } from "planarium";
import { flag, list, number, oneOf, record, settings, whole, withDefaults } from "../formats/rules.js";
import { KINDS } from "./measurement.js";
import { ROBOTS } from "./robots.js";

/** @import { NeighboursOptions } from "planarium" */
/** @import { NeighbourSession } from "./session.js" */

export const stateRule = withDefaults({
  robot: oneOf(ROBOTS.map(({ id }) => id)), draw: record({ n: whole(100_000, 100), seed: whole(999), free: flag }),
  q: list(number, 1, 8), k: whole(500, 1), index: oneOf(KINDS), given: settings,
}, { robot: ROBOTS[0].id, draw: {}, index: "kd-tree", given: {} });

/** @typedef {import("../formats/rules.js").Allowed<typeof stateRule>} State */

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
    scenario.neighbours(/** @type {NeighboursOptions} */ ({ ...given, index: "forest" })).free();
  } finally {
    scenario.free();
  }
  Object.assign(session, { sampling: { ...session.sampling, ...draw }, index, given });
  await session.open(entry, { q, k });
}
