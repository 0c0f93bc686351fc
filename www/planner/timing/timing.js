/**
 * The timing of the paths on the stage: made in a worker whenever a path, a roadmap's answer or a limit differs, and
 * given to the playback of its path, which then moves the robot as it is timed. A timing never outlives its path.
 */
import { errorInfo } from "../../app/error-info.js";
import { isAbort, latest } from "../../app/work.js";
import { forgetScene, workerWith } from "../../paths/remote.js";
import { limitsOf, usedLimits } from "./limits.js";
import { Timed } from "./timed.js";

/** @import { App } from "../../app/app.js" */
/** @import { TrajectoryDocument } from "planarium/full" */
/** @import { PathForm } from "planarium/import" */
/** @import { Experiment } from "../link/codec.js" */
/** @import { Lane, Shown } from "../stage/lane.js" */
/** @import { PathPlayback } from "../stage/path-playback.js" */
/** @import { Given, Limit } from "./limits.js" */
/**
 * @typedef {object} Session   what is taken of the page's session
 * @property {Shown | null} shown
 * @property {Lane[]} lanes
 * @property {() => void} markDirty
 */
/**
 * @typedef {object} Host   what is taken of the page
 * @property {App} app
 * @property {Session} session
 * @property {Experiment} record
 * @property {string | undefined} query
 */
/** @typedef {{ playback: PathPlayback, lane: number, timed: Timed }} Path   that is timed */
/** @typedef {{ code: string, message: string }} Fault */

export class Timing {
  /** @param {Host} page @param {() => void} onChange */
  constructor(page, onChange) {
    this.page = page;
    this.onChange = onChange;
    this.isOn = false;
    /** The paths that are timed, in the order of their lanes. @type {Path[]} */
    this.paths = [];
    /** Why the paths are not timed. @type {Fault | null} */
    this.fault = null;
    this.isBusy = false;
    /** What was asked for last: playbacks and limits. @type {unknown[]} */
    this.asked = [];
    this.make = latest(
      async (signal, /** @type {{ playback: PathPlayback, lane: number }[]} */ found, /** @type {any} */ limits) => {
        const { lanes, shown } = this.page.session;
        const results = found.map(({ lane }) => resultOf(lanes[lane]));
        const worker = workerWith(/** @type {Shown} */ (shown).document);
        return worker.time(results, limits, signal);
      },
    );
  }

  /** The limits of the robot. @returns {Limit[]} */
  get limits() {
    const { shown } = this.page.session;
    return shown ? limitsOf(shown, this.isDifferential) : [];
  }

  /** Whether the robot is a disc. */
  get isDisc() {
    return this.page.session.shown?.document.robot.type === "disc";
  }

  /** Whether it turns on the spot and drives along its heading. */
  get isDifferential() {
    return this.isDisc && this.page.record.timing?.differential === true;
  }

  /** Those that were given. @returns {Given} */
  get given() {
    const { pace: _, ...given } = this.page.record.timing ?? {};
    return given;
  }

  /** Those that are used, as the package takes them. */
  get used() {
    return usedLimits(this.limits, this.given, this.isDifferential);
  }

  get pace() {
    return this.page.record.timing?.pace ?? 1;
  }

  /** The longest duration, seconds; 0 where nothing is timed. */
  get period() {
    return Math.max(0, ...this.paths.map(({ timed }) => timed.duration));
  }

  /** Times what is shown, where it differs from what was timed last. */
  update() {
    const found = this.isOn ? pathsOf(this.page.session.lanes) : [];
    const { pace } = this;
    for (const { timed } of this.paths) timed.pace = pace;
    const asked = [JSON.stringify(this.used), ...found.map(({ playback }) => playback)];
    if (found.length === this.asked.length - 1 && asked.every((one, i) => one === this.asked[i])) return;
    this.asked = asked;
    const playbacks = new Set(found.map(({ playback }) => playback));
    // Another limit keeps the timing until the new one is there; another path does not.
    if (!this.paths.every(({ playback }) => playbacks.has(playback)) || found.length !== this.paths.length)
      this.clear();
    this.make.cancel();
    this.fault = null;
    this.isBusy = found.length > 0;
    this.onChange();
    if (this.isBusy) void this.page.app.track(this.time(found));
  }

  /** @param {{ playback: PathPlayback, lane: number }[]} found */
  async time(found) {
    const { shown } = this.page.session;
    try {
      const timings = await this.make(found, this.used);
      this.clear();
      const { scenario, document } = /** @type {Shown} */ (shown);
      const wheelbase = document.robot.type === "car" ? document.robot.wheelbase : 0;
      this.paths = found.map((path, i) => ({ ...path, timed: new Timed(scenario, timings[i], wheelbase) }));
      const { period, pace } = this;
      for (const { playback, timed } of this.paths) {
        Object.assign(timed, { period, pace });
        playback.timed = period > 0 ? timed : null;
      }
    } catch (error) {
      if (isAbort(error)) throw error;
      forgetScene();
      this.clear();
      this.fault = errorInfo(error);
    }
    this.isBusy = false;
    this.onChange();
    this.page.session.markDirty();
  }

  /** Robots move along their paths at constant speed again. */
  clear() {
    for (const { playback } of this.paths) playback.timed = null;
    this.paths = [];
  }

  /** The trajectory of a lane as a document. @param {number} lane @returns {Promise<TrajectoryDocument>} */
  document(lane) {
    return this.worker.trajectory(this.indexOf(lane));
  }

  /**
   * The trajectory of a lane in a form that other programs read.
   * @param {number} lane @param {PathForm} form @returns {Promise<Uint8Array>}
   */
  write(lane, form) {
    return this.worker.write(this.indexOf(lane), form, this.page.query);
  }

  get worker() {
    return workerWith(/** @type {Shown} */ (this.page.session.shown).document);
  }

  /** @param {number} lane @returns {number} of its path; -1: none */
  indexOf(lane) {
    return this.paths.findIndex((path) => path.lane === lane);
  }
}

/** The paths on the stage whose results are known. @param {Lane[]} lanes */
function pathsOf(lanes) {
  return lanes.flatMap((one, lane) => {
    const { playback, run } = one;
    const isKnown = one.asked ? one.asked.result.status === "solved" : run?.status === "solved" && run.hasResult;
    return playback && isKnown && !playback.isMiss ? [{ playback, lane }] : [];
  });
}

/** @param {Lane} lane */
function resultOf({ asked, run }) {
  return asked ? asked.result : /** @type {import("../run-log/run-log.js").RunLog} */ (run).result;
}
