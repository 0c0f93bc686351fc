/** One planner's place in the theatre: what it was asked, its run and its way, and the panes that show it. */
import { journeyOf } from "./journey.js";
import { Run } from "./run.js";

/** @import { Overlay } from "./editor.js" */
/** @import { Journey } from "./journey.js" */
/** @import { Check, Configuration, Plan, Scenario, ScenarioDocument, ViewOptions } from "../types.js" */

/**
 * @typedef {object} Shown   what all lanes show alike: the one value that panes read and only the theatre writes
 * @property {Scenario} scenario
 * @property {ScenarioDocument} document
 * @property {Configuration | null} start   of the query asked
 * @property {Configuration | null} goal
 * @property {Float64Array | null} hand     the pose held by hand, if any
 * @property {Check | null} check           of the pose held by hand
 * @property {Float64Array | null} hover    the configuration the pointer is at, if any
 * @property {ViewOptions} view
 * @property {boolean} rough                it is being changed by hand: pictures may be coarse
 * @property {Overlay | null} overlay       what the editor draws
 */

export class Lane {
  /** @param {Shown} shown @param {Plan} plan */
  constructor(shown, plan) {
    this.shown = shown;
    this.plan = plan;
    /** @type {Run | null} */
    this.run = null;
    /** The way of the run's end, once it was reached. @type {Journey | null} */
    this.end = null;
  }

  get scenario() { return this.shown.scenario; }

  /** The way to show: of a run at its end. @returns {Journey | null} */
  get journey() { return this.run && this.run.status !== "running" ? this.end : null; }

  /** A new run. @param {string | undefined} query @param {readonly string[]} phases @throws {Error} the core would not plan this */
  start(query, phases) {
    this.free();
    const settings = query === undefined ? this.plan.settings : { ...this.plan.settings, query };
    this.run = new Run(this.scenario, this.plan.algorithm, settings, phases);
  }

  /** Where the robot is to be drawn, if anywhere. @returns {Float64Array | null} */
  get pose() {
    if (this.shown.hand) return this.shown.hand;
    const { journey } = this;
    return journey && journey.drawn >= 1 ? journey.configuration(journey.at) : null;
  }

  /** The way of a run that has ended. @returns {boolean} whether it has just become known */
  arrive() {
    const { run } = this;
    if (!run?.ended || this.end || !run.isNewest) return false;
    this.end = journeyOf(this.scenario, run);
    return this.end !== null;
  }

  free() {
    this.run?.free();
    this.run = null;
    this.end = null;
  }
}
