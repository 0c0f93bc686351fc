/** The state that a link stores: the fleet, the planner and its options, the order of priorities, and what is shown. */
import { flag, json, list, name, number, oneOf, record, settings, whole, withDefaults } from "../formats/rules.js";

/** @import { FleetDocument, FleetGeneratorId, FleetPlannerId } from "planarium/full" */
/** @import { Rule } from "../formats/rules.js" */
/** @import { FleetSession, Source } from "./session.js" */

/** @type {FleetPlannerId[]} */
const PLANNERS = ["pbs", "prioritized", "composite"];

export const stateRule = withDefaults(
  {
    // A document, or a generator and its options.
    document: /** @type {Rule<FleetDocument>} */ (record({}, json(16))),
    kind: /** @type {Rule<FleetGeneratorId>} */ (name),
    options: settings,
    planner: oneOf(PLANNERS),
    given: settings,
    // The robots by their indices; empty if no order was asked for.
    order: list(whole(999), 0, 1000),
    time: number,
    straight: flag,
  },
  { kind: "ring", options: {}, planner: "prioritized", given: {}, order: [], time: 0, straight: false },
);

/** @typedef {import("../formats/rules.js").Allowed<typeof stateRule>} State */

/** @param {FleetSession} session @returns {State} */
export function stateOf({ source, document, algorithm, given, order, time, isStraight }) {
  const { defaults } = stateRule;
  const from = "kind" in source ? { kind: source.kind, options: source.options } : { document: document ?? undefined };
  return {
    .../** @type {any} */ (defaults),
    ...from,
    planner: algorithm,
    given: given[algorithm],
    order: order ?? [],
    time: Number(time.toFixed(3)),
    straight: isStraight,
  };
}

/**
 * @param {FleetSession} session @param {State} state
 * @param {AbortSignal} [signal]   something else is opened meanwhile
 * @throws {Error} the core refuses it, and nothing changes
 */
export async function openState(session, { document, kind, options, planner, given, order, time, straight }, signal) {
  /** @type {Source} */
  const source = document
    ? { name: document.name, document }
    : { kind: /** @type {FleetGeneratorId} */ (kind), options };
  const wanted = order.length > 0 ? order : null;
  await session.check(source, planner, given, wanted);
  signal?.throwIfAborted();
  Object.assign(session, { algorithm: planner, given: { ...session.given, [planner]: given } });
  await session.load(source, { order: wanted, isQuick: true });
  if (straight) session.setStraight(true);
  session.setTime(time);
}
