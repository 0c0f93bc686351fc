/**
 * The keyboard car: a drive of the core under the reader's keys, in time that goes by in the core's own steps. A key counts from
 * the moment it was pressed, whatever frame is drawn by then, so the same keys lead to the same place however fast frames come.
 */
import { drawDrive, drawTrace } from "../stage/driven.js";

/** @import { Drive, DriveKey, DriveState, KeyPress } from "planarium" */
/** @import { DriveOrder, DriveReport } from "../../domain/types.js" */
/** @import { Session } from "../session.js" */

/** A key that is late by less than this still counts from its moment, milliseconds: so far behind the clock time goes by. */
const BEHIND = 30;
/** What no frame has seen for longer than this has not gone by, milliseconds. */
const LONGEST = 250;
/** Where time goes on with the keys alone, this much goes by with each, seconds. */
const STRIDE = 0.25;

/** The driving of a session: made when it is first asked for. @param {Session} session */
export function drivingOf(session) {
  session.driving ??= new Driving(session);
  return session.driving;
}

export class Driving {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
    /** @type {Drive | null} */
    this.drive = null;
    /** How it stands. @type {DriveState | null} */
    this.state = null;
    /** Does time go by with each key alone? */
    this.byKeys = false;
    this.paused = false;
    /** Milliseconds at which time goes on from `base` steps, and when it was looked at last. */
    this.since = 0;
    this.base = 0;
    this.seen = 0;
    /** What is driven again. @type {{ record: KeyPress[], steps: number, next: number } | null} */
    this.tape = null;
    /** Where the car has been, rows of x, y, theta. */
    this.trace = /** @type {Float64Array} */ (new Float64Array(0));
    /** Where a control would lead. @type {import("planarium").Rollout | null} */
    this.rollout = null;
    this.said = "";
  }

  get on() { return this.drive !== null; }

  /** Does the car move by itself? */
  get moves() { return this.state !== null && !this.paused && !this.byKeys && (this.state.v !== 0 || this.tape !== null); }

  /** @param {DriveOrder} order */
  obey([verb, ...args]) { return /** @type {(...args: unknown[]) => unknown} */ (this[verb]).apply(this, args); }

  /** The reader drives, or no longer. @param {boolean} on @param {boolean} byKeys @param {number} now */
  turn(on, byKeys, now) {
    const { session } = this;
    const { shown } = session;
    if (!on || !shown) {
      this.stop();
      session.wake();
      return;
    }
    session.timeline.pause();
    session.byHand.release();
    session.byHand.game = { touches: 0, arrived: false };
    const { start, scenario } = shown;
    const isFree = start && scenario.check(start).free;
    this.drive = scenario.drive(isFree ? start : undefined);
    this.byKeys = byKeys;
    this.rollout = null;
    this.anew(now);
  }

  /** Back to the start. @param {number} now */
  anew(now) {
    this.begin([], 0, now);
    this.said = "At the start, at rest.";
  }

  /** @param {KeyPress[]} record @param {number} steps @param {number} now */
  begin(record, steps, now) {
    const { drive } = this;
    if (!drive) return;
    this.state = drive.replay(record, steps);
    this.tape = null;
    this.paused = false;
    this.rollout = null;
    this.trace = drive.traceSince(0);
    this.goOn(now);
    this.show();
  }

  /** Time goes on from here. @param {number} now */
  goOn(now) {
    this.since = this.seen = now;
    this.base = this.state?.steps ?? 0;
  }

  /** A key. @param {DriveKey} key @param {number} at  milliseconds since the epoch of all clocks */
  press(key, at) {
    const { drive, state } = this;
    if (!drive || !state) return;
    this.tape = null;
    if (key === "keep" && this.paused) this.pause(at);
    if (!this.paused && !this.byKeys) this.advance(at);
    drive.press(key);
    if (this.byKeys) this.state = drive.tick(Math.round(STRIDE / drive.stepSeconds));
    else if (this.state?.v === 0) this.goOn(at);
    this.state = drive.state;
    this.rollout = null;
    this.show();
    this.tell(state);
  }

  /** Time stands still, or goes on. @param {number} now */
  pause(now) {
    if (this.paused) this.goOn(now);
    else if (!this.byKeys) this.advance(now - BEHIND);
    this.paused = !this.paused;
    this.said = this.paused ? "Paused; press C to resume." : "Resumed.";
    this.show();
  }

  /** Does time go by with each key alone? @param {boolean} byKeys @param {number} now */
  setByKeys(byKeys, now) {
    if (!byKeys) this.goOn(now);
    else if (!this.paused) this.advance(now - BEHIND);
    this.byKeys = byKeys;
    this.show();
  }

  /** A frame. @param {number} now */
  pass(now) {
    if (!this.moves) return;
    const gap = now - this.seen;
    if (gap > LONGEST) this.since += gap - LONGEST;
    this.seen = now;
    const before = this.state;
    this.advance(now - BEHIND);
    if (before) this.tell(before);
    this.show();
  }

  /** Lets all steps go by that are due. @param {number} at */
  advance(at) {
    const { drive, state, tape } = this;
    if (!drive || !state) return;
    const due = this.base + Math.floor((at - this.since) / (1000 * drive.stepSeconds) + 1e-6);
    if (tape) {
      this.wind(drive, tape, Math.min(due, tape.steps));
      if (due < tape.steps) return;
      this.tape = null;
      this.paused = true;
      this.said = "End of the recording; press C to drive on.";
    } else if (due > state.steps) this.state = drive.tick(Math.min(due - state.steps, 1e6));
  }

  /** Plays a tape up to a step. @param {Drive} drive @param {{ record: KeyPress[], next: number }} tape @param {number} until */
  wind(drive, tape, until) {
    for (; tape.next < tape.record.length && tape.record[tape.next].step <= until; tape.next++) {
      const { step, key } = tape.record[tape.next];
      drive.tick(Math.max(0, step - drive.state.steps));
      drive.press(key);
    }
    this.state = drive.tick(Math.max(0, until - drive.state.steps));
  }

  /** Drives what was driven, or a record of the reader's own, again from the start; by keys alone it is there at once. @param {KeyPress[] | null} given @param {number} steps @param {number} now */
  replay(given, steps, now) {
    const { drive, state } = this;
    if (!drive || !state) return;
    const record = given ?? drive.record();
    const until = given ? steps : state.steps;
    this.begin(record, this.byKeys ? until : 0, now);
    if (!this.byKeys) this.tape = { record, steps: until, next: 0 };
    this.said = this.byKeys ? "The recording was replayed." : "Replaying the recording.";
    this.show();
  }

  /** The record, to be kept. */
  record() {
    const { drive, state, session: { shown } } = this;
    if (!drive || !state || !shown) return null;
    const [x, y, theta] = drive.traceSince(0);
    return { format: "planarium-drive-1", scenario: shown.scenario.name, start: [x, y, theta], steps: state.steps, record: drive.record(), pose: state.pose };
  }

  /** Where one control would lead from here. @param {number} v @param {number} phi @param {number} duration @throws {Error} with `code` and `pointer` */
  roll(v, phi, duration) {
    const { state, session: { shown } } = this;
    if (!state || !shown) return;
    // What is refused leaves nothing of the one before.
    this.rollout = null;
    this.show();
    this.rollout = shown.scenario.rollout(state.pose, v, phi, duration);
    const { seconds, blocked } = this.rollout;
    this.said = blocked === null ? `Free for all ${seconds.toFixed(2)} s.` : `Free for ${seconds.toFixed(2)} s; then ${this.name(blocked)}.`;
    this.show();
  }

  /** What is in the way. @param {NonNullable<DriveState["blocked"]>} blocked */
  name(blocked) {
    if (blocked === "bounds") return "the bounds are in the way";
    return blocked === "near" ? "the next motion would come too close to an obstacle" : `obstacle ${blocked} is in the way`;
  }

  /** Says what has happened since. @param {DriveState} before */
  tell(before) {
    const { state } = this;
    if (!state) return;
    if (state.blocked !== null && before.v !== 0 && state.v === 0) this.said = `Stopped: ${this.name(state.blocked)}.`;
    else if (state.blocked === null && before.blocked !== null) this.said = "Free again.";
    else if (this.said.startsWith("At the start") && state.v !== 0) this.said = "";
  }

  /** Is the car where it should go, at rest? */
  get arrived() {
    const { state, session: { shown } } = this;
    return Boolean(state && state.v === 0 && shown?.goal && shown.placed?.isNear(state.pose, shown.goal, shown));
  }

  /** What the stage shows is this. */
  show() {
    const { session, drive, state } = this;
    const { shown } = session;
    if (!drive || !state || !shown) return;
    const known = this.trace.length / 3;
    if (state.traceCount > known) {
      const fresh = drive.traceSince(known);
      const longer = new Float64Array(this.trace.length + fresh.length);
      longer.set(this.trace);
      longer.set(fresh, this.trace.length);
      this.trace = longer;
    }
    shown.hand = Float64Array.from(state.pose);
    shown.check = { free: true, touching: [] };
    shown.driven = { steering: state.phi, trace: this.trace, blocked: state.blocked, rollout: this.rollout, drawUnder: drawTrace, drawOver: drawDrive };
    session.wake();
  }

  /** Nobody drives. */
  stop() {
    const { shown } = this.session;
    this.drive?.free();
    this.drive = this.state = this.tape = this.rollout = null;
    if (!shown?.driven) return;
    shown.driven = null;
    shown.hand = shown.check = null;
  }

  /** What there is to say above the stage; empty while nobody drives. */
  get sentence() {
    const { state } = this;
    if (!state) return "";
    if (this.arrived) return `You reached the goal after ${state.seconds.toFixed(1)} s and ${state.keyCount} ${state.keyCount === 1 ? "key" : "keys"}.`;
    if (state.blocked !== null) return `Stopped: ${this.name(state.blocked)}. Reverse, or steer another way.`;
    return "You are driving. Up: accelerate. Down: brake, then reverse. Left and right: steer.";
  }

  /** @returns {DriveReport | null} */
  get report() {
    const { state, paused, byKeys, tape, said, arrived, rollout } = this;
    return state && { ...state, paused, byKeys, replaying: tape !== null, said, arrived, rollout: rollout && { seconds: rollout.seconds, blocked: rollout.blocked } };
  }
}
