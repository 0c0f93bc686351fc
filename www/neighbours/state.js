/** What lies on the desk as a link holds it, and back. A list of the reader's own is not in it. */
import { flag, list, name, number, record, rule, settings, whole } from "../formats/rules.js";
import { ROBOTS } from "./robots.js";

/** @import { NeighboursOptions } from "planarium" */
/** @import { Rule } from "../formats/rules.js" */
/** @import { Desk } from "./desk.js" */
/** @import { Draw, IndexId, Settings } from "./types.js" */

/** @typedef {{ robot: string, draw: Draw, q: number[], k: number, index: IndexId, given: Settings }} State */

/** @type {Rule} */
export const stateRule = record({
  robot: rule((value) => ROBOTS.some(({ id }) => id === value)),
  draw: record({ n: rule((value) => Number.isInteger(value) && Number(value) >= 100 && Number(value) <= 100_000), seed: whole(999), free: flag }),
  q: list(number, 1, 8), k: rule((value) => Number.isInteger(value) && Number(value) >= 1 && Number(value) <= 500),
  index: name, given: settings,
});

/** @param {Desk} desk @returns {State} */
export function stateOf({ entry, draw, q, k, index, given }) {
  return { robot: entry.id, draw, q: Array.from(q, (value) => Number(value.toFixed(6))), k, index, given };
}

/** @param {Desk} desk @param {State} state @param {IndexId[]} indexes  those that there are */
export async function putState(desk, { robot, draw, q, k, index, given }, indexes) {
  const entry = ROBOTS.find(({ id }) => id === robot);
  if (!entry || !indexes.includes(index)) throw new Error("It asks for what is not there.");
  // The core judges what the index is to take, before anything is changed.
  const scenario = desk.library.Scenario.parse(entry.document);
  try {
    scenario.neighbours(/** @type {NeighboursOptions} */ ({ index: "forest", ...given })).free();
  } finally {
    scenario.free();
  }
  Object.assign(desk, { draw: { ...desk.draw, ...draw }, index, given: { ...given } });
  await desk.open(entry, { q, k });
}
