/**
 * The commands of this page, which its worker runs: the fleet, its conflicts, and the newest planner, which is stepped.
 */
import { Fleet } from "planarium/full";
import { withOptions } from "../domain/option-names.js";

/** @import { FleetPlanner, FleetPlannerId, GenerateFleetOptions } from "planarium/full" */
/** @import { Settings } from "../domain/types.js" */
/** @import { Generated } from "./scenes.js" */
/** @typedef {Generated | { document: object | string }} From   where a fleet is from */

/** Milliseconds of a call, at most, and iterations between two looks at the clock. */
const LONGEST = 24;
const AT_ONCE = 20;

/** @type {Fleet | null} */
let fleet = null;
/** @type {FleetPlanner | null} */
let planner = null;
/**
 * How much of the planner the page has.
 * @type {{ order: string, planned: number, roadmaps: { vertices: number, edges: number }[] }}
 */
let sent = { order: "", planned: 0, roadmaps: [] };

export const commands = {
  /**
   * Whether a plan can begin for a fleet; nothing changes.
   * @param {From} source @param {FleetPlannerId} algorithm @param {Settings} settings @param {number[] | null} order
   * @throws {Error} the fleet or the plan is refused
   */
  check(source, algorithm, settings, order) {
    const opened = fleetOf(source);
    try {
      plannerOf(opened, algorithm, settings, order).free();
    } finally {
      opened.free();
    }
  },

  /** @param {From} source @throws {Error} it is refused, and nothing changes */
  open(source) {
    const opened = fleetOf(source);
    fleet?.free();
    fleet = opened;
    return { document: opened.toJSON(), title: opened.title, conflicts: opened.straightConflicts() };
  },

  /**
   * Begins to plan.
   * @param {FleetPlannerId} algorithm
   * @param {Settings} settings
   * @param {number[] | null} order  all robots
   * @throws {Error} it is refused, and nothing changes
   */
  begin(algorithm, settings, order) {
    if (!fleet) throw new Error("No fleet has been opened.");
    const begun = plannerOf(fleet, algorithm, settings, order);
    planner?.free();
    planner = begun;
    sent = { order: "", planned: 0, roadmaps: [] };
  },

  /** Makes at most this number of iterations, fewer where they take long (`isLate`). @param {number} count */
  advance(count) {
    if (!planner) throw new Error("No plan has begun.");
    const end = performance.now() + LONGEST;
    for (let made = 0; made < count && planner.status === "running" && performance.now() < end; made += AT_ONCE)
      planner.step(Math.min(AT_ONCE, count - made));
    return {
      ...growthOf(planner),
      isLate: performance.now() >= end,
      result: planner.status === "running" ? null : planner.result(),
    };
  },

  /** Verifies the solved plan. */
  verify() {
    return (planner && fleet?.verify(planner.result())) ?? null;
  },
};

/** @typedef {typeof commands} Commands */
/** @typedef {ReturnType<Commands["open"]>} Opened */
/** @typedef {ReturnType<Commands["advance"]>} Progress */

export function reset() {
  fleet = planner = null;
}

/** @param {From} source */
function fleetOf(source) {
  return "kind" in source
    ? withOptions(source.options, (/** @type {GenerateFleetOptions} */ options) => Fleet.generate(source.kind, options))
    : Fleet.parse(/** @type {string} */ (source.document));
}

/**
 * @param {Fleet} opened
 * @param {FleetPlannerId} algorithm
 * @param {Settings} settings
 * @param {number[] | null} order  all robots, if `prioritized` plans in it
 */
function plannerOf(opened, algorithm, settings, order) {
  const { robots } = opened.toJSON();
  const names = order?.map((robot) => robots[robot]?.name ?? String(robot));
  return withOptions(settings, (options) =>
    opened.planner({ ...options, algorithm, ...(names && algorithm === "prioritized" && { order: names }) }),
  );
}

/** What has grown since the last time. With another order, all trajectories are new. @param {FleetPlanner} run */
function growthOf(run) {
  const { status, iterations, planned, roadmapCount } = run;
  const order = run.order();
  const isAnew = order.join() !== sent.order || planned < sent.planned;
  const since = isAnew ? 0 : sent.planned;
  const trajectories = [...order.slice(since, planned)].map((robot) => ({ robot, rows: run.trajectory(robot) }));
  const roadmaps = Array.from({ length: roadmapCount }, (_, i) => {
    const { vertices, edges } = sent.roadmaps[i] ?? { vertices: 0, edges: 0 };
    return { vertices: run.verticesSince(i, vertices), edges: run.edgesSince(i, edges) };
  });
  sent = {
    order: order.join(),
    planned,
    roadmaps: roadmaps.map(({ vertices, edges }, i) => ({
      vertices: (sent.roadmaps[i]?.vertices ?? 0) + vertices.length / 3,
      edges: (sent.roadmaps[i]?.edges ?? 0) + edges.length / 2,
    })),
  };
  return {
    status,
    iterations,
    planned,
    order: [...order],
    blocked: [...run.blocked()],
    isAnew,
    trajectories,
    roadmaps,
  };
}
