/** One planner's place in the session: what it was asked, its run and its way, and the panes that show it. */
import { playbackOf } from "../domain/path-playback.js";
import { PAST, Run } from "./run-log/run-log.js";

/** @import { Standing } from "./race/standings.js" */
/** @import { Marked } from "./stage/marked.js" */
/** @import { Overlay } from "./editor/editor.js" */
/** @import { Pane } from "./stage/pane.js" */
/** @import { Placed } from "./stage/placed.js" */
/** @import { PathPlayback } from "../domain/path-playback.js" */
/** @import { Check, Configuration, Plan, Scenario, ScenarioDocument, Target, ViewOptions } from "../domain/types.js" */

/**
 * @typedef {object} Shown   what all lanes show alike: the one value that panes read and only the session writes
 * @property {Scenario} scenario
 * @property {ScenarioDocument} document
 * @property {string | undefined} query     that is asked
 * @property {Configuration | null} start   of that query
 * @property {Configuration | null} goal    null where any will do that reaches the target
 * @property {Target | null} target         of the end effector
 * @property {Configuration[]} goals        the goal, or what was found to reach the target
 * @property {Float64Array | null} hand     the pose held by hand, if any
 * @property {Check | null} check           of the pose held by hand
 * @property {Hover | null} hover           what is pointed at, if anything
 * @property {ViewOptions} view
 * @property {Marked | null} marked         configurations of the reader's own
 * @property {boolean} rough                it is being changed by hand: pictures may be coarse
 * @property {Overlay | null} overlay       what the editor draws
 * @property {Placed | null} placed         of a body or a car
 * @property {Driven | null} driven         while a reader drives the car
 */

/**
 * @typedef {object} Driven   a car under a reader's keys
 * @property {number} steering              of its front wheels, radians
 * @property {Float64Array} trace           where it has been, rows of x, y, theta
 * @property {import("planarium").Obstructed | null} blocked   what stopped it
 * @property {import("planarium").Rollout | null} rollout      where a control would lead
 * @property {(pane: Pane, context: CanvasRenderingContext2D, lane: Lane) => void} drawUnder
 * @property {(pane: Pane, context: CanvasRenderingContext2D, lane: Lane) => void} drawOver
 */

/**
 * @typedef {object} Hover   a vertex that is pointed at, or a mere pose
 * @property {Lane} lane
 * @property {number} vertex   -1: a pose
 * @property {Float64Array} pose
 * @property {Check} check
 * @property {number} [edge]   the edge that is pointed at, or that leads to the vertex
 * @property {Float64Array} [motions]   what a car does along it: rows of speed, steering angle and duration
 */

export class Lane {
  /** @param {Shown} shown @param {Plan} plan */
  constructor(shown, plan) {
    this.shown = shown;
    this.plan = plan;
    /** @type {Run | null} */
    this.run = null;
    /** The way of the run's end, once it was reached. @type {PathPlayback | null} */
    this.end = null;
    /** Does the run wait at an iteration in its midst? */
    this.still = false;
  }

  get scenario() { return this.shown.scenario; }

  /** The way to show: of a run at its end. @returns {PathPlayback | null} */
  get playback() { return this.run && this.run.status !== "running" ? this.end : null; }

  /** What the planner is asked, with the query. @param {string | undefined} query @returns {Plan} */
  planOf(query) {
    const { algorithm, settings } = this.plan;
    return { algorithm, settings: query === undefined ? settings : { ...settings, query } };
  }

  /** A new run. @param {string | undefined} query @param {Pick<typeof import("planarium"), "phases" | "planners">} library @throws {Error} the core would not plan this */
  start(query, library) {
    this.free();
    const { algorithm, settings } = this.planOf(query);
    this.run = new Run(this.scenario, algorithm, settings, library);
  }

  /** How it stands beside others. @returns {Standing} */
  get standing() {
    const { run, plan, scenario } = this;
    const at = run ? run.foundBy() : -1;
    return {
      isOver: run?.status !== "running",
      found: run && at >= 0 ? run.history.row(at)[PAST.evaluations] : null,
      cost: run ? run.past[PAST.cost] : Infinity,
      metric: scenario.robot === "arm" ? String(plan.settings.metric ?? "sum") : "euclidean",
    };
  }

  /** Where the robot is to be drawn, if anywhere. @returns {Float64Array | null} */
  get pose() {
    if (this.shown.hand) return this.shown.hand;
    const { playback } = this;
    return playback && playback.drawn >= 1 ? playback.configuration(playback.at) : null;
  }

  /** The angle of a car's front wheels. */
  get steering() { return this.shown.driven?.steering ?? (this.shown.hand ? 0 : this.playback?.steering ?? 0); }

  /** The way of a run that has ended. @returns {boolean} whether it has just become known */
  arrive() {
    const { run } = this;
    if (!run?.ended || this.end || !run.isNewest) return false;
    this.end = playbackOf(this.scenario, run, this.shown.placed);
    return this.end !== null;
  }

  free() {
    this.run?.free();
    this.run = null;
    this.end = null;
  }
}
