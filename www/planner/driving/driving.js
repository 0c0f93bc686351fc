/**
 * The keyboard car: a drive of the core, in the core's own time steps. A key counts from the moment it was pressed, so
 * the same keys lead to the same configuration at any frame rate. Moments are milliseconds since the epoch.
 */
import { counted } from "../../app/dom.js";
import { obstacleName } from "../../domain/names.js";
import { drawDrive, drawTrace } from "../stage/driven.js";

/** @import { Drive, DriveKey, DriveState, KeyPress, Obstructed, Rollout } from "planarium" */
/** @import { Beside, Driven, Shown } from "../stage/lane.js" */
/**
 * @typedef {object} Session   what a drive takes of the page's session
 * @property {Shown | null} shown
 * @property {Driving | null} driving
 * @property {{ pause: () => void }} timeline
 * @property {{ release: () => void, game: { touches: number, arrived: boolean } }} byHand
 * @property {() => void} wake
 */

/** The format of recordings. */
export const FORMAT = "planarium-drive-1";
/** Milliseconds by which the drive lags behind the clock: a key event that is late by less counts from its moment. */
const BEHIND = 30;
/** Milliseconds between two frames that count, at most. */
const LONGEST = 250;
/** Seconds that a key advances the time, where only keys do. */
const STRIDE = 0.25;

export class Driving {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
    /** @type {Drive | null} */
    this.drive = null;
    /** Whether time advances with each key only. */
    this.byKeys = false;
    this.paused = false;
    /** The moment of step `base`, and the moment of the last frame. */
    this.since = 0;
    this.base = 0;
    this.seen = 0;
    /**
     * The rest of the recording that is replayed, up to a step.
     * @type {{ record: KeyPress[], steps: number } | null}
     */
    this.tape = null;
    /** The preview of one control. @type {Rollout | null} */
    this.rollout = null;
    /** That control: v, phi and the seconds asked for. @type {[number, number, number]} */
    this.rolled = [0, 0, 0];
    /** The step of Euler's method whose path is drawn beside the arc, in seconds; 0: none is. */
    this.dt = 0;
    /** @type {Beside | null} */
    this.beside = null;
    this.announcement = "";
  }

  get on() {
    return this.drive !== null;
  }

  get state() {
    return this.drive?.state ?? null;
  }

  /** The car's trajectory, rows of x, y, theta. */
  get trace() {
    return this.drive?.traceSince(0) ?? new Float64Array(0);
  }

  /** Whether time runs by itself. */
  get runs() {
    return !this.paused && !this.byKeys;
  }

  /** Whether the car moves by itself. */
  get moves() {
    const { state } = this;
    return state !== null && this.runs && (state.v !== 0 || this.tape !== null);
  }

  /**
   * Begins at rest: at a configuration, or where none is given at the start of the query if it is free.
   * @param {boolean} byKeys
   * @param {number} now
   * @param {number[]} [from]
   * @throws {Error} `start-in-collision`, with a pointer
   */
  start(byKeys, now, from) {
    const { session } = this;
    const { shown } = session;
    if (!shown) return;
    session.timeline.pause();
    session.byHand.release();
    session.byHand.game = { touches: 0, arrived: false };
    const { start, scenario } = shown;
    const isFree = start && scenario.check(start).free;
    const drive = scenario.drive(from ?? (isFree ? start : undefined));
    this.drive?.free();
    this.drive = drive;
    this.byKeys = byKeys;
    this.restart(now);
  }

  /** Returns to the start. @param {number} now */
  restart(now) {
    this.begin([], 0, now);
    this.announcement = "At the start, at rest.";
  }

  /** @param {KeyPress[]} record @param {number} steps @param {number} now */
  begin(record, steps, now) {
    this.drive?.replay(record, steps);
    this.tape = this.rollout = null;
    this.paused = false;
    this.resume(now);
    this.show();
  }

  /** Lets time run from a moment on. @param {number} now */
  resume(now) {
    this.since = this.seen = now;
    this.base = this.state?.steps ?? 0;
  }

  /** Handles a key. @param {DriveKey} key @param {number} at */
  press(key, at) {
    const { drive, state } = this;
    if (!drive || !state) return;
    this.tape = null;
    if (key === "keep" && this.paused) this.pause(at);
    if (this.runs) this.advance(at);
    const wasStill = drive.state.v === 0;
    drive.press(key);
    if (this.byKeys) drive.tick(Math.round(STRIDE / drive.stepSeconds));
    else if (wasStill) this.resume(at);
    this.rollout = null;
    this.show();
    this.describe(state);
  }

  /** Pauses or resumes. @param {number} now */
  pause(now) {
    if (this.runs) this.advance(now - BEHIND);
    this.paused = !this.paused;
    if (!this.paused) this.resume(now);
    this.announcement = this.paused ? "Paused; press C to resume." : "Resumed.";
    this.show();
  }

  /** @param {boolean} byKeys @param {number} now */
  setByKeys(byKeys, now) {
    if (this.runs) this.advance(now - BEHIND);
    this.byKeys = byKeys;
    this.resume(now);
    this.show();
  }

  /** Advances to a frame. @param {number} now */
  pass(now) {
    const { state } = this;
    if (!state || !this.moves) return;
    const gap = now - this.seen;
    if (gap > LONGEST) this.since += gap - LONGEST;
    this.seen = now;
    this.advance(now - BEHIND);
    this.describe(state);
    this.show();
  }

  /**
   * Takes all steps that are due. While the car rests no time passes, unless a recording is replayed.
   * @param {number} at
   */
  advance(at) {
    const { drive, tape } = this;
    if (!drive) return;
    const due = this.base + Math.floor((at - this.since) / (1000 * drive.stepSeconds) + 1e-6);
    const { steps, v } = drive.state;
    if (tape) {
      this.wind(drive, tape.record, Math.min(due, tape.steps));
      if (due < tape.steps) return;
      this.tape = null;
      this.paused = true;
      this.announcement = "End of the recording; press C to drive on.";
    } else if (v !== 0 && due > steps) drive.tick(Math.min(due - steps, 1e6));
  }

  /** Replays a recording up to a step. @param {Drive} drive @param {KeyPress[]} record @param {number} until */
  wind(drive, record, until) {
    while (record.length > 0 && record[0].step <= until) {
      const [{ step, key }] = record.splice(0, 1);
      drive.tick(Math.max(0, step - drive.state.steps));
      drive.press(key);
    }
    drive.tick(Math.max(0, until - drive.state.steps));
  }

  /**
   * Replays the drive so far, or a recording from a file. Where time advances with keys only, the end is shown at once.
   * @param {number} now
   * @param {{ record: KeyPress[], steps: number }} [recording]
   */
  replay(now, recording = this.record() ?? undefined) {
    if (!recording) return;
    const { record, steps } = recording;
    this.begin(record, steps, now);
    if (!this.byKeys) {
      this.begin([], 0, now);
      this.tape = { record: [...record], steps };
    }
    this.announcement = this.byKeys ? "The recording was replayed." : "Replaying the recording.";
  }

  /** The recording, as a document. */
  record() {
    const { drive, trace } = this;
    const { shown } = this.session;
    if (!drive || !shown) return null;
    const { steps, pose } = drive.state;
    return {
      format: FORMAT,
      scenario: shown.scenario.name,
      start: [...trace.slice(0, 3)],
      steps,
      record: drive.record(),
      pose,
    };
  }

  /** The drive so far once more: a drive of its own that can be put at any part of it. */
  again() {
    const recording = this.record();
    const { shown } = this.session;
    if (!recording || !shown) return null;
    const { start, record, steps } = recording;
    const drive = shown.scenario.drive(start);
    let rest = [...record];
    return {
      seconds: steps * drive.stepSeconds,
      /** Where the car is. @param {number} part  0 to 1 */
      at: (part) => {
        const step = Math.round(part * steps);
        if (step < drive.state.steps) {
          drive.replay([], 0);
          rest = [...record];
        }
        this.wind(drive, rest, step);
        const { pose, phi, blocked } = drive.state;
        /** @type {Driven} */
        const driven = {
          steering: phi,
          trace: drive.traceSince(0),
          blocked,
          rollout: null,
          beside: null,
          drawUnder: drawTrace,
          drawOver: drawDrive,
        };
        return { pose: Float64Array.from(pose), driven };
      },
      free: () => drive.free(),
    };
  }

  /**
   * Previews one control.
   * @param {number} v
   * @param {number} phi
   * @param {number} duration
   * @throws {Error} with `code` and `pointer`
   */
  roll(v, phi, duration) {
    const { state } = this;
    const { shown } = this.session;
    if (!state || !shown) return;
    this.rollout = null;
    this.show();
    this.rollout = shown.scenario.rollout(state.pose, v, phi, duration);
    this.rolled = [v, phi, duration];
    this.show();
    this.tell(this.rollout);
  }

  /** Describes the preview. @param {Rollout} rollout */
  tell({ seconds, blocked }) {
    const time = `${seconds.toFixed(2)} s`;
    const free = blocked === null ? `Free for all ${time}.` : `Free for ${time}; then ${reasonOf(blocked)}.`;
    const { beside } = this;
    this.announcement = beside ? `${free} Euler\u2019s path ${endOf(beside)}.` : free;
  }

  /** Draws Euler's path beside the arc, or no longer. @param {number} dt  its step in seconds; 0: not drawn */
  setEuler(dt) {
    this.dt = dt;
    this.show();
    if (this.rollout) this.tell(this.rollout);
  }

  /**
   * Euler's steps beside the exact arc of one control: of the preview if there is one, else of the control held since
   * the last key that changed it. Both last equally long.
   * @param {Float64Array} trace  of the drive
   * @returns {Beside | null}  null if it is not to be drawn, or nothing moves
   */
  compare(trace) {
    const { drive, dt, rollout, rolled } = this;
    const { shown } = this.session;
    if (dt === 0 || !drive || !shown) return null;
    const { steps, v, phi } = drive.state;
    const held = v === 0 ? 0 : steps - (drive.record().findLast(({ key }) => key !== "keep")?.step ?? 0);
    const exact = rollout ? rollout.poses : trace.subarray(-3 * (held + 1));
    const seconds = rollout ? rollout.seconds : held * drive.stepSeconds;
    if (seconds === 0) return null;
    const [speed, steering] = rollout ? rolled : [v, phi];
    const from = [...exact.subarray(0, 3)];
    const { poses, blocked } = shown.scenario.rollout(from, speed, steering, seconds, { integration: "euler", dt });
    const [[x, y], [toX, toY]] = [exact, poses].map((rows) => rows.subarray(-3));
    return { poses, dt, apart: blocked === null ? Math.hypot(toX - x, toY - y) : null };
  }

  /** Describes an event since an earlier state. @param {DriveState} before */
  describe(before) {
    const { state } = this;
    if (!state) return;
    if (state.blocked !== null && before.v !== 0 && state.v === 0)
      this.announcement = `Stopped: ${reasonOf(state.blocked)}.`;
    else if (state.blocked === null && before.blocked !== null) this.announcement = "Free again.";
    else if (this.announcement.startsWith("At the start") && state.v !== 0) this.announcement = "";
  }

  /** Whether the car is at the goal, at rest. */
  get arrived() {
    const { state } = this;
    const { shown } = this.session;
    return Boolean(state && state.v === 0 && shown?.goal && shown.placed?.isNear(state.pose, shown.goal, shown));
  }

  show() {
    const { session, state, trace, rollout } = this;
    const { shown } = session;
    if (!state || !shown) return;
    const beside = (this.beside = this.compare(trace));
    shown.hand = Float64Array.from(state.pose);
    shown.check = { free: true, touching: [] };
    shown.driven = {
      steering: state.phi,
      trace,
      blocked: state.blocked,
      rollout,
      beside,
      drawUnder: drawTrace,
      drawOver: drawDrive,
    };
    session.wake();
  }

  stop() {
    const { shown } = this.session;
    this.drive?.free();
    this.drive = this.tape = this.rollout = this.beside = null;
    if (shown?.driven) shown.driven = shown.hand = shown.check = null;
  }

  /** The sentence above the stage. */
  get sentence() {
    const { state } = this;
    if (!state) return "";
    if (this.arrived)
      return `You reached the goal after ${state.seconds.toFixed(1)} s and ${counted(state.keyCount, "key")}.`;
    if (state.blocked !== null) return `Stopped: ${reasonOf(state.blocked)}. Reverse, or steer another way.`;
    return "You are driving. Up: accelerate. Down: brake, then reverse. Left and right: steer.";
  }
}

/** How Euler's path ends, in words. @param {Beside} beside */
function endOf({ apart }) {
  return apart === null ? "touches something before that" : `ends ${apart.toFixed(3)} m from the end of the arc`;
}

/** The obstruction, in words. @param {Obstructed} blocked */
function reasonOf(blocked) {
  if (blocked === "bounds") return "the bounds are in the way";
  return blocked === "near"
    ? "the next motion would come too close to an obstacle"
    : `${obstacleName(blocked)} is in the way`;
}
