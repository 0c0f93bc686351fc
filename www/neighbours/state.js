/** The state that a link stores: also a scenario, and a list from a file if it is short. */
import { Scenario } from "planarium";
import {
  flag,
  json,
  list,
  name,
  number,
  oneOf,
  record,
  settings,
  text,
  whole,
  withDefaults,
} from "../formats/rules.js";
import { sceneDocument } from "../planner/scenes/document.js";
import { ROBOTS, entryOf } from "./robots.js";
import { weighted } from "./session.js";

/** @import { IndexId, NeighboursOptions } from "planarium" */
/** @import { ScenarioDocument } from "../domain/types.js" */
/** @import { Rule } from "../formats/rules.js" */
/** @import { NeighbourSession, OwnList, Weights } from "./session.js" */

/** @type {readonly IndexId[]} */
const INDEXES = ["linear", "kd-tree", "kd-tree-unwrapped", "forest"];

export const stateRule = withDefaults(
  {
    // A scenario, the name of a scene of the planner's page, or a robot of this page; the first of them that there is.
    document: /** @type {Rule<ScenarioDocument>} */ (record({}, json(16))),
    scene: name,
    robot: oneOf(ROBOTS.map(({ id }) => id)),
    // The weights of a metre and a radian, where they are not the scenario's.
    weights: /** @type {Rule<Weights>} */ (list(number, 2, 2)),
    draw: record({ n: whole(100_000, 1), seed: whole(999), free: flag }),
    // A list from a file, in place of the sampled one.
    list: /** @type {Rule<OwnList>} */ (record({ name: text, rows: list(list(number, 1, 8), 1, 4000) })),
    q: list(number, 1, 8),
    k: whole(500, 1),
    index: oneOf(INDEXES),
    given: settings,
    // Whether the target and its neighbours are shown.
    ask: flag,
  },
  { robot: ROBOTS[0].id, draw: {}, index: "kd-tree", given: {}, ask: true },
);

/** @typedef {import("../formats/rules.js").Allowed<typeof stateRule>} State */

/** @param {NeighbourSession} session @returns {State} */
export function stateOf({ entry, ownWeights, sampling, q, k, index, given, isAsking, ownList }) {
  const world = ROBOTS.includes(entry)
    ? { robot: entry.id }
    : entry.id === "file"
      ? { document: entry.document }
      : { scene: entry.id };
  return {
    robot: ROBOTS[0].id,
    ...world,
    weights: ownWeights ?? undefined,
    draw: sampling,
    ...(ownList ? { list: ownList } : {}),
    q: Array.from(q, (value) => Number(value.toFixed(6))),
    k,
    index,
    given,
    ask: isAsking,
  };
}

/**
 * @param {NeighbourSession} session
 * @param {State} state
 * @param {AbortSignal} [signal]   something else is opened meanwhile
 * @throws {Error} the core refuses it, or there is no such scene
 */
export async function openState(
  session,
  { document, scene, robot, weights, draw, list: own, q, k, index, given, ask },
  signal,
) {
  const entry = document
    ? entryOf(document, "file")
    : scene
      ? entryOf(await sceneDocument(scene), scene)
      : (ROBOTS.find(({ id }) => id === robot) ?? ROBOTS[0]);
  signal?.throwIfAborted();
  // The core checks the weights and the options before anything changes.
  const scenario = Scenario.parse(weights ? weighted(entry.document, weights) : entry.document);
  try {
    scenario.neighbours(/** @type {NeighboursOptions} */ ({ ...given, index: "forest" })).free();
  } finally {
    scenario.free();
  }
  Object.assign(session, { sampling: { ...session.sampling, ...draw }, index, given, isAsking: ask });
  await session.open(entry, { q, k, weights, list: own });
}
