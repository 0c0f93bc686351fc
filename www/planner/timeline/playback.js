/**
 * Conducts the time of a session: what was asked of the transport becomes time that is wanted, and a frame at a time it goes on:
 * what the log has is replayed, what it has not is planned by the worker, which plans the next block while one is drawn.
 */

/** @import { Growth } from "../worker/stepper.js" */
/** @import { Session } from "../session.js" */

/** A time before all others: nothing more is planned. */
export const NONE = -1;

export class Timeline {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
    /** Which runs the worker is planning for, by the number of the planning; -1: none. */
    this.asking = -1;
    /** Which runs the worker has. */
    this.known = -1;
  }

  get clock() { return this.session.clock; }

  toggle() {
    if (this.clock.playing) this.pause();
    else this.play();
  }

  play() {
    const { session, clock } = this;
    if (!session.growing && !session.travelling) {
      // At its end, and nothing drives: it is watched again from the beginning.
      if (clock.head === 0) return;
      this.show(0);
      clock.halt();
    }
    session.byHand.release();
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

  /** Shows a time: what the log has at once, what it has not after planning. @param {number} time */
  seek(time) {
    const { session, clock } = this;
    if (!session.shown) return;
    session.byHand.release();
    clock.seek(time);
    if (clock.wanted < clock.now) this.show(clock.wanted);
    session.markDirty();
  }

  /** Runs on as fast as it goes. */
  finish() {
    const { session, clock } = this;
    if (!session.growing) return;
    session.byHand.release();
    clock.rushing = true;
    clock.playing = true;
    session.markDirty();
  }

  /** Puts the robot somewhere along its way. @param {number} part  0 to 1 */
  along(part) {
    const { session } = this;
    if (!session.travelling) return;
    session.byHand.release();
    this.clock.playing = false;
    for (const playback of session.playbacks) playback.seek(part);
    session.wake();
  }

  /** Lets time go on. @param {number} elapsed  seconds @returns {boolean} whether anything changed */
  pass(elapsed) {
    const { session, clock } = this;
    if (session.growing) clock.pass(elapsed);
    else if (clock.playing) this.travel(elapsed);
    if (!clock.owes) return false;
    // What is not inked yet is inked first.
    if (!session.stage.caughtUp) return false;
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

  /** Is the worker planning what is on the stage? */
  get isAsking() { return this.asking === this.session.plannings; }

  /** Has the worker plan up to a time, unless it is at it, or all is there. @param {number} wanted  may be Infinity */
  plan(wanted) {
    if (!this.isAsking && this.reached() < wanted) void this.ask(wanted, !this.clock.playing);
  }

  /** Asks for the results of the runs as they are now, where they are not known. */
  conclude() {
    if (!this.isAsking && this.session.lanes.some(({ run }) => run?.isNewest && !run.hasResult)) void this.ask(NONE, true);
  }

  /**
   * Asks the worker for a block, and takes it in.
   * @param {number} wanted  the time to come to @param {boolean} isResult  with the results, once it has come there
   */
  async ask(wanted, isResult) {
    const { session, clock: { column } } = this;
    const { plannings, lanes, shown } = session;
    if (!shown) return;
    const fresh = this.known === plannings ? null : { document: shown.document, plans: lanes.map((lane) => lane.order(session.query)) };
    this.known = this.asking = plannings;
    try {
      const growths = await session.planners.advance({ fresh, column, wanted, isResult });
      if (session.plannings === plannings) this.take(growths);
    } catch (error) {
      if (this.isAsking) this.asking = -1;
      if (session.plannings === plannings) session.fail(error);
    } finally {
      session.wake();
    }
  }

  /** The worker has planned a block. @param {Growth[]} growths */
  take(growths) {
    const { session: { lanes }, clock } = this;
    const isShown = lanes.every(({ run }) => run?.isNewest);
    const isLatest = clock.now === clock.head;
    growths.forEach((growth, i) => lanes[i].run?.take(growth));
    this.asking = -1;
    if (clock.owes) {
      // The next block is planned while this one is drawn.
      if (isShown) this.plan(Math.floor(clock.wanted));
      return;
    }
    // Time was stopped meanwhile: what is made belongs to the log.
    clock.head = Math.max(clock.head, this.limit);
    if (!isLatest) return;
    this.show(clock.head);
    clock.rest();
  }

  /** The time that all planners have come to: those that have ended hold nobody up. */
  reached() {
    return Math.min(...this.session.lanes.map(({ run }) => run?.reached(this.clock.column) ?? Infinity));
  }

  /** The latest time at which it is known how all stand. */
  get limit() {
    const reached = this.reached();
    return reached < Infinity ? reached : Math.max(0, ...this.session.lanes.map(({ run }) => run?.clock(this.clock.column) ?? 0));
  }

  /** The robots drive on, all at the same part of their ways. @param {number} elapsed  seconds */
  travel(elapsed) {
    const [lead, ...others] = this.session.playbacks;
    lead?.advance(elapsed);
    for (const playback of others) Object.assign(playback, { drawn: lead.drawn, at: lead.at });
  }

  /** Shows a time that the log knows of. @param {number} time */
  show(time) {
    const { session, clock } = this;
    const { lanes } = session;
    const isCalm = session.stage.look?.calm;
    clock.now = Math.min(time, this.limit);
    clock.head = Math.max(clock.head, clock.now);
    for (const lane of lanes) {
      if (!lane.run) continue;
      lane.run.shown = lane.run.iterationAt(clock.column, clock.now);
      // A path draws itself only before someone who watches it grow, and wants to see it move.
      if (lane.arrive() && lane.end && (isCalm || !clock.playing || lanes.length > 1)) lane.end.drawn = 1;
    }
    if (!session.growing && (isCalm || !session.travelling)) clock.playing = false;
  }
}
