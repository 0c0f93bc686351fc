/**
 * The state of the page: a fleet, how it is planned for, the plan as far as it has grown, and the time that is shown.
 * The worker plans; only the newest plan counts.
 */
import { latest } from "../app/work.js";
import { Trajectory, poseOf, straightOf } from "./trajectory.js";

/**
 * @import { FleetConflict, FleetDocument, FleetPlannerId, FleetResult, FleetVerification,
 *   Status } from "planarium/full"
 */
/** @import { App } from "../app/app.js" */
/** @import { Remote } from "../app/worker-client.js" */
/** @import { Settings } from "../domain/types.js" */
/** @import { Commands, Opened, Progress } from "./commands.js" */
/** @import { Generated } from "./scenes.js" */
/** @import { Pose } from "./trajectory.js" */

/** Where a fleet is from. @typedef {Generated | { name: string, document: object | string }} Source */
/** x, y, theta of each vertex; two vertices of each edge. @typedef {{ vertices: number[], edges: number[] }} Roadmap */

/**
 * @typedef {object} Run
 * @property {Status | "none"} status
 * @property {number} iterations
 * @property {number} planned
 * @property {number[]} order
 * @property {number[]} blocked   the robot that found no way last, then those in its way
 * @property {Roadmap[]} roadmaps
 * @property {boolean} isBuilding  vertices or edges were added last
 * @property {(Trajectory | null)[]} trajectories
 * @property {FleetResult | null} result
 * @property {FleetVerification | null} verification
 */

/** Iterations of the first frame in which a plan grows, and how many more there are in each next one. */
const FIRST = 4;
const MORE = 1.06;
/** The most robots that the composite plans for, and the most coordinates they have together. */
const TOGETHER = [2, 3];
const COORDINATES = 8;

/** The planner at first. @type {FleetPlannerId} */
export const DEFAULT = "pbs";

/** No options of any planner. @returns {Record<FleetPlannerId, Settings>} */
export function noOptions() {
  return { pbs: {}, prioritized: {}, composite: {} };
}

/** @param {number} robots @returns {Run} */
function nothing(robots) {
  return {
    status: "none",
    iterations: 0,
    planned: 0,
    order: Array.from({ length: robots }, (_, i) => i),
    blocked: [],
    roadmaps: [],
    isBuilding: true,
    trajectories: Array.from({ length: robots }, () => null),
    result: null,
    verification: null,
  };
}

/** What the worker needs. @param {Source} source */
function fromOf(source) {
  return "kind" in source ? { kind: source.kind, options: source.options } : { document: source.document };
}

export class FleetSession {
  /** @param {App} app @param {Remote<Commands>} worker */
  constructor(app, worker) {
    this.app = app;
    this.worker = worker;
    /** @type {Source} */
    this.source = { kind: "ring", options: {} };
    this.title = "";
    /** @type {FleetDocument | null} */
    this.document = null;
    /** The conflicts if all drive straight at once, and their trajectories then. @type {FleetConflict[]} */
    this.conflicts = [];
    /** @type {Trajectory[]} */
    this.straight = [];
    /** @type {FleetPlannerId} */
    this.algorithm = DEFAULT;
    /** The options of each planner that differ from the defaults. @type {Record<FleetPlannerId, Settings>} */
    this.given = noOptions();
    /** The order of priorities that was asked for, if any: `prioritized` plans in it. @type {number[] | null} */
    this.order = null;
    this.run = nothing(0);
    /** Plans begun. */
    this.plans = 0;
    /** Seconds. */
    this.time = 0;
    /** Whether all drive straight at once, in place of the plan. */
    this.isStraight = false;
    this.hasRoadmap = true;
    /** @type {number | null} */
    this.selected = null;
  }

  get robots() {
    return this.document?.robots ?? [];
  }

  /** The trajectories that are shown. @returns {(Trajectory | null)[]} */
  get shown() {
    return this.isStraight ? this.straight : this.run.trajectories;
  }

  /** When the last robot arrives, as far as is known. */
  get end() {
    return this.shown.reduce((end, one) => Math.max(end, one?.arrival ?? 0), 0);
  }

  /** Whether the composite can plan for this fleet. */
  get canCompose() {
    const { length } = this.robots;
    return (
      length >= TOGETHER[0] &&
      length <= TOGETHER[1] &&
      this.robots.reduce((sum, { start }) => sum + start.length, 0) <= COORDINATES
    );
  }

  /** Whether robots can be put into order: `prioritized` then plans for them. */
  get isOrdered() {
    return this.algorithm !== "composite";
  }

  /** @param {number} robot @param {number} [time] @returns {Pose} */
  poseAt(robot, time = this.time) {
    return this.shown[robot]?.at(time) ?? poseOf(this.robots[robot].start);
  }

  /** The conflicts at the time shown, if all drive straight. */
  get touching() {
    return this.isStraight
      ? this.conflicts.filter(({ from, to }) => from <= this.time && this.time < (to ?? Infinity))
      : [];
  }

  /**
   * Opens a fleet and plans for it; quickly: without showing how it grows. If the fleet is refused, the one before
   * stays. Resolves to true.
   */
  load = latest(
    async (
      signal,
      /** @type {Source} */ source,
      /** @type {{ order?: number[] | null, isQuick?: boolean }} */ { order = null, isQuick = false } = {},
    ) => {
      this.enter(source, await this.worker.open(fromOf(source), signal), order);
      return this.plan(isQuick);
    },
  );

  /**
   * Whether a fleet is accepted, with a planner, its options and an order.
   * @param {Source} source @param {FleetPlannerId} algorithm @param {Settings} given @param {number[] | null} order
   * @throws {Error} it is refused
   */
  async check(source, algorithm, given, order) {
    await this.worker.check(fromOf(source), algorithm, given, order);
  }

  /** @param {Source} source @param {Opened} opened @param {number[] | null} order */
  enter(source, { document, title, conflicts }, order) {
    Object.assign(this, {
      source,
      document,
      title,
      conflicts,
      order,
      straight: document.robots.map(straightOf),
      run: nothing(document.robots.length),
      time: 0,
      isStraight: false,
      selected: null,
    });
    if (!this.canCompose && this.algorithm === "composite") this.algorithm = DEFAULT;
    this.app.changed();
  }

  /** Plans with the planner, its options and the order as they are. Resolves to true. */
  plan = latest(async (signal, isQuick = true) => {
    this.plans++;
    const { app, worker, algorithm, given, order, robots } = this;
    try {
      await worker.begin(algorithm, given[algorithm], order, signal);
    } catch (error) {
      // The plan that grew until now ends, too.
      if (!signal.aborted && this.run.status === "running") this.run = nothing(robots.length);
      app.changed();
      throw error;
    }
    const isStill = isQuick || app.reducedMotion;
    for (let count = FIRST, isFirst = true; this.run.status === "running" || isFirst; count *= MORE, isFirst = false) {
      const progress = await worker.advance(isStill ? Infinity : Math.ceil(count), signal);
      if (isFirst)
        Object.assign(this, { run: nothing(robots.length), time: isQuick ? this.time : 0, isStraight: false });
      this.grow(progress);
      app.changed();
      // The iterations of a frame, as long as they are fast.
      if (!isStill && !progress.isLate) await new Promise(requestAnimationFrame);
      signal.throwIfAborted();
    }
    this.time = Math.min(this.time, this.end);
    if (this.run.status === "solved") this.run.verification = await worker.verify(signal);
    app.changed();
    return true;
  });

  /** @param {Progress} progress */
  grow({ trajectories, roadmaps, isAnew, isLate, ...progress }) {
    const { run } = this;
    if (isAnew) run.trajectories.fill(null);
    for (const { robot, rows } of trajectories) run.trajectories[robot] = new Trajectory(rows);
    run.isBuilding = roadmaps.some(({ vertices, edges }) => vertices.length + edges.length > 0);
    roadmaps.forEach((grown, i) => {
      const roadmap = (run.roadmaps[i] ??= { vertices: [], edges: [] });
      for (const value of grown.vertices) roadmap.vertices.push(value);
      for (const vertex of grown.edges) roadmap.edges.push(vertex);
    });
    Object.assign(run, progress);
  }

  /** Plans with another planner. @param {FleetPlannerId} algorithm */
  use(algorithm) {
    this.algorithm = algorithm;
    return this.plan(false);
  }

  /** Plans in an order; null: by the planner at first, which decides who gives way. @param {number[] | null} order */
  reorder(order) {
    this.order = order;
    this.algorithm = order ? "prioritized" : DEFAULT;
    return this.plan();
  }

  /** @param {number} time */
  setTime(time) {
    this.time = Math.min(Math.max(0, time), this.end);
    this.app.changed();
  }

  /** Shows how all drive straight at once, or the plan. @param {boolean} isStraight @param {number} [time] */
  setStraight(isStraight, time = 0) {
    Object.assign(this, { isStraight, time });
    this.app.changed();
  }

  /** @param {number | null} robot */
  select(robot) {
    this.selected = robot;
    this.app.changed();
  }
}
