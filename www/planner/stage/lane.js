/** A lane of the session: a planner with its plan, its run and the playback of its path. A race has several. */
import { playbackOf, playbackOfResult } from "./path-playback.js";
import { PAST } from "../run-log/columns.js";
import { RunLog } from "../run-log/run-log.js";

/** @import { Catalogue } from "../run-log/run-log.js" */
/** @import { Marked } from "./marked.js" */
/** @import { Pane } from "./pane.js" */
/** @import { Placed } from "./placed.js" */
/** @import { PathPlayback } from "./path-playback.js" */
/** @import { OpenedWorld } from "../../worlds/door.js" */
/** @import { CellPicture } from "../../worlds/picture.js" */
/** @import { Answer } from "../worker/stepper.js" */
/** @import { Box, Check, Configuration, Plan, Scenario } from "../../domain/types.js" */
/** @import { ScenarioDocument, Target, ViewOptions } from "../../domain/types.js" */

/**
 * @typedef {object} Shown   the state that all lanes share: panes read it, and only the session changes it
 * @property {Scenario} scenario
 * @property {ScenarioDocument} document
 * @property {string | undefined} query     its name
 * @property {Configuration | null} start   of that query
 * @property {Configuration | null} goal    null where there is a target
 * @property {Target | null} target         of the end effector
 * @property {Configuration[]} goals        the goal, or configurations that reach the target
 * @property {Float64Array | null} hand     the configuration posed by hand
 * @property {Check | null} check           of the configuration posed by hand
 * @property {Hover | null} hover           under the pointer
 * @property {ViewOptions} view
 * @property {Marked | null} marked         configurations from a file
 * @property {boolean} rough                during a gesture: images may be coarse
 * @property {Drawn | null} overlay         the editor, drawn on the panes
 * @property {Drawn | null} certifying      while it is decided whether a path exists
 * @property {Placed | null} placed         for a body or a car
 * @property {Driven | null} driven         while the car is driven
 * @property {{ drawUnder: Draw, drawOver: Draw } | null} judged   a path of another program
 * @property {{ drawUnder: Draw, drawOver: Draw } | null} room   how much room there is
 * @property {OpenWorld} [world]            what was opened in place of something else
 * @property {Box} [window]                 the part of the plane that is shown, where it is not all of it
 */

/**
 * What was opened in place of something else. It stays with the scene while that is edited.
 * @typedef {object} OpenWorld
 * @property {OpenedWorld | null} opened   the file of another program; null: a scene that is open again
 * @property {CellPicture | undefined} map   the cells that its obstacles were made of
 * @property {{ name: string, patch: object, opened: OpenedWorld | null, map: CellPicture | undefined }} before   what was
 *   open; its state is a patch of the page's
 */

/** @typedef {(pane: Pane, context: CanvasRenderingContext2D, lane: Lane) => void} Draw */
/** @typedef {{ draw: Draw }} Drawn   something that draws on the panes */

/**
 * @typedef {object} Driven   a car driven by keys
 * @property {number} steering              of its front wheels, radians
 * @property {Float64Array} trace           its trajectory, rows of x, y, theta
 * @property {import("planarium").Obstructed | null} blocked   the obstruction that stopped it
 * @property {import("planarium").Rollout | null} rollout      the preview of a control
 * @property {Beside | null} beside         Euler's steps of that control, or of the one held
 * @property {Draw} drawUnder
 * @property {Draw} drawOver
 */

/**
 * @typedef {object} Beside   Euler's steps beside an exact arc
 * @property {Float64Array} poses           rows of x, y, theta
 * @property {number} dt                    the step, in seconds
 * @property {number | null} apart          metres between both ends; null if Euler's path touches something before its
 *   end
 */

/**
 * @typedef {object} Hover   a vertex or a mere configuration under the pointer
 * @property {Lane} lane
 * @property {number} vertex   -1: a configuration
 * @property {Float64Array} pose
 * @property {Check} check
 * @property {number} [edge]   under the pointer, or to the vertex
 * @property {Float64Array} [motions]   along that edge: rows of speed, steering angle and duration
 */

/**
 * @typedef {Answer & { query: string, isProven: boolean, playback: PathPlayback | null }} Asked   `query`: its name,
 *   empty if it is none of the scenario's
 */

/** @typedef {NonNullable<import("planarium").OptimumOptions["metric"]>} Metric */
/**
 * @typedef {{ length: number, rows: Float64Array, isExact: boolean }} Optimum   `rows` of configurations; not exact: a
 *   reference, which a run may surpass
 */

/**
 * Whether the shortest path of such a robot is known, or a reference.
 * @param {{ robot: string, dimension: number }} scenario
 */
export function hasOptimum({ robot, dimension }) {
  return robot === "disc" || (robot === "arm" && dimension === 2);
}

export class Lane {
  /** @param {Shown} shown @param {Plan} plan */
  constructor(shown, plan) {
    this.shown = shown;
    this.plan = plan;
    /** @type {RunLog | null} */
    this.run = null;
    /** The playback of the path, once the run has ended. @type {PathPlayback | null} */
    this.end = null;
    /** A further query of the roadmap that stands. @type {Asked | null} */
    this.asked = null;
    /** The shortest path of the query, if it is shown and known. @type {Optimum | null} */
    this.optimum = null;
    /** Whether the run is paused before its end. */
    this.still = false;
  }

  get scenario() {
    return this.shown.scenario;
  }

  /**
   * The playback of a run that is shown at its end, or of a further query of its roadmap.
   * @returns {PathPlayback | null}
   */
  get playback() {
    if (!this.run || this.run.status === "running") return null;
    return this.asked ? this.asked.playback : this.end;
  }

  /** Shows a further query of the roadmap. @param {Answer} answer @param {string} query   its name, or empty */
  answer(answer, query) {
    const isProven = Boolean(this.run?.isProven);
    this.asked = {
      ...answer,
      query,
      isProven,
      playback: playbackOfResult(this.scenario, isProven, answer.result, this.shown.placed),
    };
  }

  /** The plan with the query. @returns {Plan} */
  get task() {
    const { algorithm, settings } = this.plan;
    const { query } = this.shown;
    return { algorithm, settings: query === undefined ? settings : { ...settings, query } };
  }

  /** Begins a run. @param {Catalogue} catalogue @throws {Error} the core refuses the plan */
  start(catalogue) {
    this.free();
    const { algorithm, settings } = this.task;
    this.run = new RunLog(this.scenario, algorithm, settings, catalogue);
  }

  /** Whether its paths keep away from obstacles: its costs are no lengths. */
  get keepsAway() {
    return this.scenario.robot === "disc" && Number(this.plan.settings.clearance_weight ?? 0) > 0;
  }

  /** The metric of its costs. @returns {Metric} */
  get metric() {
    return this.scenario.robot === "arm"
      ? (/** @type {Metric | undefined} */ (this.plan.settings.metric) ?? "sum")
      : "euclidean";
  }

  /** Its standing in a race. */
  get standing() {
    const { run } = this;
    const at = run ? run.foundBy() : -1;
    return {
      isOver: run?.status !== "running",
      found: run && at >= 0 ? run.history.row(at)[PAST.clearanceEvaluations] : null,
      cost: run ? run.past[PAST.length] : Infinity,
      metric: this.keepsAway
        ? [this.metric, this.plan.settings.clearance_weight, this.plan.settings.clearance_within].join(" ")
        : this.metric,
      isCost: this.keepsAway,
      collides: Boolean(this.playback?.flaw),
    };
  }

  /** The configuration at which the robot is drawn. @returns {Float64Array | null} */
  get pose() {
    if (this.shown.hand) return this.shown.hand;
    const { playback } = this;
    return playback && playback.drawn >= 1 ? playback.pose : null;
  }

  /** The steering angle of a car. */
  get steering() {
    return this.shown.driven?.steering ?? (this.shown.hand ? 0 : (this.playback?.steering ?? 0));
  }

  /** Makes the playback of a run that has ended. @returns {boolean} whether it is new */
  arrive() {
    const { run } = this;
    if (!run?.ended || this.end || !run.isNewest) return false;
    this.end = playbackOf(this.scenario, run, this.shown.placed);
    return this.end !== null;
  }

  /** Keeps the run that stands in an edited scenario, until its roadmap is repaired. @param {Shown} shown */
  move(shown) {
    if (this.run?.scenario !== this.scenario) this.scenario.free();
    this.shown = shown;
    this.asked = null;
  }

  free() {
    // While a roadmap is repaired, its run has a scenario of its own.
    if (this.run && this.run.scenario !== this.scenario) this.run.scenario.free();
    this.run?.free();
    this.run = null;
    this.end = this.asked = null;
  }
}
