/**
 * The state of the page: a floor with its robot, a start and a goal, a policy, what is planned and driven, a training
 * and a comparison. The worker plans and drives.
 */
import { Navigation } from "planarium/full";
import { latest } from "../app/work.js";
import { withOptions } from "../domain/option-names.js";
import { ComparisonRun } from "./comparison.js";
import { withDefaults } from "./options.js";
import { TrainingRun } from "./training.js";

/**
 * @import { EdgeRollouts, Execution, GenerateNavigationOptions, NavigationDocument, NavigationGeneratorId,
 *   PolicyDocument, ResultDocument, Status } from "planarium/full"
 */
/** @import { App } from "../app/app.js" */
/** @import { Remote } from "../app/worker-client.js" */
/** @import { Settings } from "../domain/types.js" */
/** @import { Commands, PlannedWay, Way } from "./commands.js" */
/** @import { TrainingWorker } from "./pool.js" */

/** @typedef {"train" | "plan" | "compare"} Part */
/**
 * Where a floor is from: a generator, or a document.
 * @typedef {{ kind: NavigationGeneratorId, options: Settings } | { document: NavigationDocument | string }} Source
 */
/** The kinds of robot, each with a policy of its own. @typedef {NavigationDocument["robot"]["type"]} RobotKind */
/** Where the policy is from. @typedef {"shipped" | "trained" | "file"} Origin */

/**
 * A plan of one way to drive: its roadmap, its path, and drives along it.
 * @typedef {object} Run
 * @property {Status | "none"} status
 * @property {number} iterations
 * @property {number[]} vertices   x and y in turn
 * @property {number[]} edges      two vertices each
 * @property {number[]} refused    edges that were refused, in the same form
 * @property {ResultDocument | null} result
 * @property {number[][]} path
 * @property {EdgeRollouts[] | null} rollouts   along the steps of the path
 * @property {Execution[]} drives
 */

/** The floor at first. */
export const FIRST = /** @type {const} */ ({ kind: "rooms", options: { seed: 2 } });

/** The methods that can be planned and driven one by one. @type {Way[]} */
export const WAYS = ["policy", "straight", "straight-policy", "prm-rl"];

/** @returns {Run} */
const nothing = () => ({
  status: "none",
  iterations: 0,
  vertices: [],
  edges: [],
  refused: [],
  result: null,
  path: [],
  rollouts: null,
  drives: [],
});

/** @returns {Record<Way, Run>} */
const noRuns = () => ({ policy: nothing(), straight: nothing(), "straight-policy": nothing(), "prm-rl": nothing() });

/** @returns {Record<PlannedWay, Settings>} */
export const noSettings = () => ({ straight: {}, "straight-policy": {}, "prm-rl": {} });

export class NavigationSession {
  /**
   * @param {App} app
   * @param {Remote<Commands>} worker
   * @param {Record<RobotKind, PolicyDocument>} policies  those that come with the page
   */
  constructor(app, worker, policies) {
    this.app = app;
    this.worker = worker;
    this.policies = policies;
    this.policy = policies.differential_drive;
    /** @type {Origin} */
    this.origin = "shipped";
    /** @type {Part} */
    this.part = "plan";
    /** @type {Source} */
    this.source = FIRST;
    /** @type {NavigationDocument | null} */
    this.document = null;
    /**
     * The core's task, for rays and outlines; its query is an earlier one where the present one is refused.
     * @type {Navigation | null}
     */
    this.task = null;
    /** @type {number[]} */
    this.start = [0, 0, 0];
    /** @type {number[]} */
    this.goal = [0, 0];
    /** Why start or goal are refused, if they are. @type {{ message: string, end: "start" | "goal" } | null} */
    this.refusal = null;
    /** Which of the two arrow keys move. @type {"start" | "goal"} */
    this.moved = "goal";
    /** @type {Way} */
    this.way = "prm-rl";
    /** Options that differ from the defaults, of each way that plans. @type {Record<PlannedWay, Settings>} */
    this.given = noSettings();
    this.trials = 20;
    this.runs = noRuns();
    /** Seconds, of the drives. */
    this.time = 0;
    /** The drive with the rays, and the step of the path that is marked. */
    this.selected = 0;
    /** @type {number | null} */
    this.edge = null;
    const hire = () => /** @type {TrainingWorker} */ (app.hire());
    this.training = new TrainingRun(this, worker, hire);
    this.comparison = new ComparisonRun(this);
  }

  /** The policy that comes with the page for the robot. */
  get shipped() {
    return this.policies[this.document?.robot.type ?? "differential_drive"];
  }

  /** Whether the robot carries a load. */
  get hasLoad() {
    return this.document?.robot.type === "cargo";
  }

  /** The plan of the way that is shown. */
  get run() {
    return this.runs[this.way];
  }

  /** When the last drive ends. */
  get end() {
    return this.run.drives.reduce((end, { time }) => Math.max(end, time), 0);
  }

  /** The floor with the query from start to goal. @returns {NavigationDocument} */
  get asked() {
    const [x, y, theta] = this.start;
    const [gx, gy] = this.goal;
    return { ...this.floor, queries: [{ name: "query", start: [x, y, theta], goal: [gx, gy] }] };
  }

  /** The floor without queries, where start and goal may be anywhere. */
  get robotDocument() {
    return { ...this.floor, queries: [] };
  }

  /** @returns {NavigationDocument} */
  get floor() {
    if (!this.document) throw new Error("No floor has been opened.");
    return this.document;
  }

  /** @param {Part} part */
  setPart(part) {
    this.part = part;
    this.app.changed();
  }

  /**
   * Opens a floor.
   * @param {Source} source
   * @param {{ start?: number[], goal?: number[] }} [ends]  those of its first query by default
   * @throws {Error} it is refused, and nothing changes
   */
  open(source, ends = {}) {
    const task =
      "kind" in source
        ? withOptions(source.options, (/** @type {GenerateNavigationOptions} */ options) =>
            Navigation.generate(source.kind, options),
          )
        : Navigation.parse(source.document);
    const document = task.toJSON();
    const { min, max } = document.world.bounds ?? { min: [0, 0], max: [0, 0] };
    const middle = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
    const query = document.queries[0] ?? { start: [...middle, 0], goal: middle };
    this.task?.free();
    Object.assign(this, { source, document, task });
    if ((this.policy.robot ?? "differential_drive") !== document.robot.type) {
      // It drives another robot.
      Object.assign(this, { policy: this.shipped, origin: "shipped" });
      this.training.clear();
    }
    this.comparison.clear();
    this.setEnds({ start: ends.start ?? query.start, goal: ends.goal ?? query.goal });
  }

  /** Moves start or goal: what was planned is gone. @param {{ start?: number[], goal?: number[] }} ends */
  setEnds({ start = this.start, goal = this.goal }) {
    Object.assign(this, { start, goal, refusal: null });
    this.clear();
    try {
      const task = Navigation.parse(this.asked);
      this.task?.free();
      this.task = task;
    } catch (error) {
      const { code, message } = /** @type {{ code?: string, message: string }} */ (error);
      if (code !== "start-in-collision" && code !== "goal-in-collision") throw error;
      this.refusal = { message, end: code === "start-in-collision" ? "start" : "goal" };
    }
    this.app.changed();
  }

  /** Forgets the floor, and all settings: they were refused. */
  forget() {
    Object.assign(this, { document: null, given: noSettings() });
    for (const run of [this.training, this.comparison]) {
      run.given = {};
      run.clear();
    }
    this.clear();
  }

  /** Forgets all plans and drives. */
  clear() {
    this.planning.cancel();
    this.driving.cancel();
    Object.assign(this, { runs: noRuns(), time: 0, selected: 0, edge: null });
  }

  /** @param {PolicyDocument} policy @param {Origin} origin @throws {Error} the core refuses it, and nothing changes */
  usePolicy(policy, origin) {
    // The path has one position and so no edge, but the core reads the policy and compares its sensor with the robot's.
    this.task?.edgeRollouts(policy, this.goal, {});
    Object.assign(this, { policy, origin });
    this.clear();
    this.comparison.clear();
    this.app.changed();
  }

  /** @param {Way} way */
  setWay(way) {
    Object.assign(this, { way, time: 0, edge: null, selected: 0 });
    this.app.changed();
  }

  /** The options of the way, complete with the seed. */
  get seed() {
    return this.way === "policy" ? 0 : Number(this.given[this.way].seed ?? 0);
  }

  /**
   * Plans for the way that is shown, and gives up drives.
   * @param {boolean} [isQuick]  without showing how it grows
   * @returns {Promise<boolean>} whether there is something to plan
   * @throws {Error} the options are refused
   */
  plan(isQuick = false) {
    this.driving.cancel();
    return this.planning(isQuick);
  }

  planning = latest(async (signal, /** @type {boolean} */ isQuick) => {
    const { way, worker, policy, app } = this;
    if (this.refusal) return false;
    if (way === "policy") {
      this.runs.policy = { ...nothing(), status: "solved", path: [this.start.slice(0, 2), this.goal] };
      app.changed();
      return true;
    }
    await worker.beginPlan(this.asked, policy, way, withDefaults(way, this.given[way]), signal);
    const run = (this.runs[way] = { ...nothing(), status: "running" });
    Object.assign(this, { time: 0, edge: null, selected: 0 });
    app.changed();
    try {
      await this.grow(run, isQuick || app.reducedMotion, signal);
      return true;
    } catch (error) {
      // It was given up, or the worker has lost it.
      if (this.runs[way] === run) this.runs[way] = nothing();
      app.changed();
      throw error;
    }
  });

  /** Lets a roadmap grow to its end. @param {Run} run @param {boolean} isQuick @param {AbortSignal} signal */
  async grow(run, isQuick, signal) {
    const { worker, app } = this;
    while (run.status === "running") {
      const progress = await worker.advancePlan(isQuick, signal);
      for (const value of progress.vertices) run.vertices.push(value);
      for (const vertex of progress.edges) run.edges.push(vertex);
      run.refused.push(...progress.refused);
      Object.assign(run, {
        status: progress.status,
        iterations: progress.iterations,
        result: progress.result,
        path: progress.result?.path ?? [],
      });
      app.changed();
    }
    run.rollouts = await worker.rollouts(run.path, signal);
    app.changed();
  }

  /**
   * Drives along the path of the way that is shown, which is planned for first.
   * @param {boolean} [isQuick]
   * @returns {Promise<boolean>} whether it has driven
   */
  async drive(isQuick = false) {
    return this.run.status !== "running" && this.driving(isQuick);
  }

  driving = latest(async (signal, /** @type {boolean} */ isQuick) => {
    if (this.run.status === "none" && !(await this.planning(isQuick))) return false;
    const { run, way, policy, seed, trials } = this;
    if (run.path.length < 2) return false;
    const own = way === "straight" ? null : policy;
    run.drives = await this.worker.drive(this.asked, own, run.path, seed, trials, signal);
    Object.assign(this, { time: 0, selected: 0 });
    this.app.changed();
    return true;
  });

  /** @param {number} time */
  setTime(time) {
    this.time = Math.min(Math.max(0, time), this.end);
    this.app.changed();
  }

  /** Marks a step of the path, or a drive. @param {{ edge?: number | null, selected?: number }} changes */
  select(changes) {
    Object.assign(this, changes);
    this.app.changed();
  }
}

/** How many drives ended in each way. @param {Execution[]} drives */
export function countsOf(drives) {
  const of = (/** @type {Execution["outcome"]} */ outcome) =>
    drives.filter((drive) => drive.outcome === outcome).length;
  return { reached: of("reached"), collision: of("collision"), swing: of("swing"), timeout: of("timeout") };
}

/**
 * The configuration of a drive at a time.
 * @param {Execution} drive
 * @param {number} time
 * @param {number} timeStep
 * @returns {[x: number, y: number, theta: number]}
 */
export function poseAt({ trace, swing }, time, timeStep) {
  const [x, y, theta] = rowAt(trace, 3, time / timeStep);
  // The sensor of a carrier jumps to the next goal.
  return [x, y, swing.length > 0 ? trace[3 * Math.min(trace.length / 3 - 1, Math.ceil(time / timeStep)) + 2] : theta];
}

/**
 * The displacement of the load of a drive at a time; at rest without one.
 * @param {Execution} drive
 * @param {number} time
 * @param {number} timeStep
 * @returns {[x: number, y: number]}
 */
export function swingAt({ swing }, time, timeStep) {
  const [x = 0, y = 0] = swing.length > 0 ? rowAt(swing, 2, time / timeStep) : [];
  return [x, y];
}

/**
 * A row of a table between two others.
 * @param {ArrayLike<number>} table
 * @param {number} width
 * @param {number} at  rows
 */
function rowAt(table, width, at) {
  const last = table.length / width - 1;
  const row = Math.min(Math.floor(at), Math.max(0, last - 1));
  const part = last > 0 ? Math.min(last, at) - row : 0;
  return Array.from({ length: width }, (_, i) => {
    const from = table[width * row + i];
    return from + part * ((table[width * (row + 1) + i] ?? from) - from);
  });
}
