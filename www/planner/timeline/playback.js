/**
 * Moves the time of a session. Each frame approaches the wanted time: the log is replayed, and beyond its end the
 * worker plans the next block while one is drawn.
 */

/** @import { App } from "../../app/app.js" */
/** @import { Lane, Shown } from "../stage/lane.js" */
/** @import { PathPlayback } from "../stage/path-playback.js" */
/** @import { Growth } from "../worker/stepper.js" */
/** @import { Team } from "../worker/team.js" */
/** @import { Clock } from "./clock.js" */
/**
 * @typedef {object} Session   what is taken of the page's session
 * @property {App} app
 * @property {Team} team
 * @property {Clock} clock
 * @property {Shown | null} shown
 * @property {Lane[]} lanes
 * @property {PathPlayback[]} playbacks
 * @property {number} plannings
 * @property {boolean} growing
 * @property {boolean} travelling
 * @property {{ caughtUp: boolean }} stage
 * @property {{ release: () => void }} byHand
 * @property {() => void} takeOver
 * @property {() => void} forget
 * @property {() => void} markDirty
 * @property {() => void} wake
 * @property {(error: unknown) => void} fail
 */

/** A time before all others: nothing more is planned. */
export const NONE = -1;

export class Timeline {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
    /** Number of the planning that a pending request belongs to; -1: none. */
    this.pending = -1;
    /** Number of the planning that the worker has. */
    this.sent = -1;
  }

  get clock() {
    return this.session.clock;
  }

  toggle() {
    if (this.clock.playing) this.pause();
    else this.play();
  }

  play() {
    const { session, clock } = this;
    if (!session.growing && !session.travelling) {
      // At the end, without a path to follow: the run is replayed from the beginning.
      if (clock.head === 0) return;
      this.show(0);
      clock.halt();
    }
    session.takeOver();
    clock.playing = true;
    if (session.growing) session.markDirty();
    session.wake();
  }

  pause() {
    this.clock.halt();
    this.session.wake();
  }

  /** @param {number} steps  below 0: back */
  step(steps) {
    const { clock } = this;
    const from = clock.playing || clock.wanted === Infinity ? clock.now : clock.wanted;
    this.seek(from + steps * clock.unit);
  }

  /** Shows a time, after planning where the log does not reach it. @param {number} time */
  seek(time) {
    const { session, clock } = this;
    if (!session.shown) return;
    session.takeOver();
    clock.seek(time);
    if (clock.wanted < clock.now) this.show(clock.wanted);
    session.markDirty();
  }

  /** Runs to the end at full speed. */
  finish() {
    const { session, clock } = this;
    if (!session.growing) return;
    session.takeOver();
    clock.rushing = true;
    clock.playing = true;
    session.markDirty();
  }

  /** Places the robot along its path. @param {number} part  0 to 1 */
  along(part) {
    const { session } = this;
    if (!session.travelling) return;
    session.byHand.release();
    this.clock.playing = false;
    for (const playback of session.playbacks) playback.seek(part);
    session.wake();
  }

  /** Lets time pass. @param {number} elapsed  seconds @returns {boolean} whether anything changed */
  pass(elapsed) {
    const { session, clock } = this;
    if (session.growing) clock.pass(elapsed);
    else if (clock.playing) this.travel(elapsed);
    // Rows that are not drawn yet come first, except on the way to the end: the answer does not wait for the drawing.
    if (!clock.owes || !(session.stage.caughtUp || clock.rushing)) return false;
    if (!session.growing) {
      clock.rest();
      return false;
    }
    const before = clock.now;
    const wanted = Math.floor(clock.wanted);
    this.show(Math.min(wanted, this.reached()));
    if (!session.growing) clock.rest();
    else this.plan(wanted);
    return clock.now !== before;
  }

  /** Whether the worker plans for the current runs. */
  get isAsking() {
    return this.pending === this.session.plannings;
  }

  /** Has the worker begin the current runs, with the first step of those that play. */
  begin() {
    const { session, clock } = this;
    void session.app.track(this.request(clock.playing ? clock.unit : NONE, !clock.playing));
  }

  /**
   * Has the worker plan up to a time, unless it is busy or the log reaches it.
   * @param {number} wanted  may be Infinity
   */
  plan(wanted) {
    if (!this.isAsking && this.reached() < wanted)
      void this.session.app.track(this.request(wanted, !this.clock.playing));
  }

  /** Requests the results of the runs as they are now, where they are unknown. */
  conclude() {
    if (!this.isAsking && this.session.lanes.some(({ run }) => run?.isNewest && !run.hasResult))
      void this.session.app.track(this.request(NONE, true));
  }

  /**
   * Has the worker plan a block, and adds it to the logs.
   * @param {number} wanted  the time to reach @param {boolean} isResult  with the results once it is reached
   */
  async request(wanted, isResult) {
    const { session } = this;
    const { column } = this.clock;
    const { plannings, lanes, shown } = session;
    if (!shown) return;
    const fresh = this.sent === plannings ? null : { document: shown.document, plans: lanes.map((lane) => lane.task) };
    this.sent = this.pending = plannings;
    try {
      const growths = await session.team.advance({ fresh, column, wanted, isResult });
      if (session.plannings === plannings) this.take(growths);
    } catch (error) {
      if (this.isAsking) this.pending = -1;
      if (session.plannings === plannings) session.fail(error);
    } finally {
      session.wake();
    }
  }

  /** Adds a block to the logs. @param {Growth[]} growths */
  take(growths) {
    const { clock } = this;
    const { lanes } = this.session;
    const isShown = lanes.every(({ run }) => run?.isNewest);
    const isLatest = clock.now === clock.head;
    growths.forEach((growth, i) => lanes[i].run?.take(growth));
    this.pending = -1;
    if (clock.playing || clock.owes) {
      // The next block is planned while this one is drawn.
      if (isShown) this.plan(Math.floor(clock.wanted));
      return;
    }
    // Paused meanwhile: the block belongs to the log all the same.
    clock.head = Math.max(clock.head, this.limit);
    if (!isLatest) return;
    this.show(clock.head);
    clock.rest();
  }

  /** The time that all planners have reached; those that have ended do not count. */
  reached() {
    return Math.min(...this.session.lanes.map(({ run }) => run?.reached(this.clock.column) ?? Infinity));
  }

  /** The latest time at which all runs are known. */
  get limit() {
    const reached = this.reached();
    return reached < Infinity
      ? reached
      : Math.max(0, ...this.session.lanes.map(({ run }) => run?.clock(this.clock.column) ?? 0));
  }

  /** Moves the robots along their paths, all at the same part. @param {number} elapsed  seconds */
  travel(elapsed) {
    const [lead, ...others] = this.session.playbacks;
    lead?.advance(elapsed);
    for (const playback of others) Object.assign(playback, { drawn: lead.drawn, at: lead.at });
  }

  /** Shows a time within the log. @param {number} time */
  show(time) {
    const { session, clock } = this;
    const { lanes } = session;
    const isCalm = session.app.reducedMotion;
    clock.now = Math.min(time, this.limit);
    clock.head = Math.max(clock.head, clock.now);
    if (clock.now < clock.head) session.forget();
    for (const lane of lanes) {
      if (!lane.run) continue;
      lane.run.shown = lane.run.iterationAt(clock.column, clock.now);
      // A path is drawn gradually only while a single run plays, and without reduced motion.
      if (lane.arrive() && lane.end && (isCalm || !clock.playing || lanes.length > 1)) lane.end.drawn = 1;
    }
    if (!session.growing && (isCalm || !session.travelling)) clock.playing = false;
  }
}
