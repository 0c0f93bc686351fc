/**
 * Conducts the time of a theatre: what was asked of the transport becomes time that is wanted, and a frame at a time it goes on:
 * what the log has is replayed, what it has not is planned by the worker, which plans the next block while one is drawn.
 */

/** @import { Growth } from "./stepper.js" */
/** @import { Theatre } from "./theatre.js" */

/** A time before all others: nothing more is planned. */
export const NONE = -1;

export class Conductor {
  /** @param {Theatre} theatre */
  constructor(theatre) {
    this.theatre = theatre;
    /** Which runs the worker is planning for, by the number of the planning; -1: none. */
    this.asking = -1;
    /** Which runs the worker has. */
    this.known = -1;
  }

  get clock() { return this.theatre.clock; }

  toggle() {
    if (this.clock.playing) this.pause();
    else this.play();
  }

  play() {
    const { theatre, clock } = this;
    if (!theatre.growing && !theatre.travelling) {
      // At its end, and nothing drives: it is watched again from the beginning.
      if (clock.head === 0) return;
      this.show(0);
      clock.halt();
    }
    theatre.turn.release();
    clock.playing = true;
    if (theatre.growing) theatre.stir();
    theatre.wake();
  }

  pause() {
    this.clock.halt();
    this.theatre.wake();
  }

  /** @param {number} steps  below 0: back */
  step(steps) {
    const { clock } = this;
    const from = clock.playing || clock.wanted === Infinity ? clock.now : clock.wanted;
    this.seek(from + steps * clock.unit);
  }

  /** Shows a time: what the log has at once, what it has not after planning. @param {number} time */
  seek(time) {
    const { theatre, clock } = this;
    if (!theatre.shown) return;
    theatre.turn.release();
    clock.seek(time);
    if (clock.wanted < clock.now) this.show(clock.wanted);
    theatre.stir();
    theatre.wake();
  }

  /** Runs on as fast as it goes. */
  finish() {
    const { theatre, clock } = this;
    if (!theatre.growing) return;
    theatre.turn.release();
    clock.rushing = true;
    clock.playing = true;
    theatre.stir();
    theatre.wake();
  }

  /** Puts the robot somewhere along its way. @param {number} part  0 to 1 */
  along(part) {
    const { theatre } = this;
    if (!theatre.travelling) return;
    theatre.turn.release();
    this.clock.playing = false;
    for (const journey of theatre.journeys) journey.seek(part);
    theatre.wake();
  }

  /** Lets time go on. @param {number} elapsed  seconds @returns {boolean} whether anything changed */
  pass(elapsed) {
    const { theatre, clock } = this;
    if (theatre.growing) clock.pass(elapsed);
    else if (clock.playing) this.travel(elapsed);
    if (!clock.owes) return false;
    // What is not inked yet is inked first.
    if (!theatre.stage.caughtUp) return false;
    if (!theatre.growing) {
      clock.rest();
      return false;
    }
    const before = clock.now;
    const wanted = Math.floor(clock.wanted);
    this.show(Math.min(wanted, this.reached()));
    if (!theatre.growing) clock.rest();
    else this.plan(wanted);
    return clock.now !== before;
  }

  /** Is the worker planning what is on the stage? */
  get isAsking() { return this.asking === this.theatre.plannings; }

  /** Has the worker plan up to a time, unless it is at it, or all is there. @param {number} wanted  may be Infinity */
  plan(wanted) {
    if (!this.isAsking && this.reached() < wanted) void this.ask(wanted, !this.clock.playing);
  }

  /** Asks for the results of the runs as they are now, where they are not known. */
  conclude() {
    if (!this.isAsking && this.theatre.lanes.some(({ run }) => run?.isNewest && !run.hasResult)) void this.ask(NONE, true);
  }

  /**
   * Asks the worker for a block, and takes it in.
   * @param {number} wanted  the time to come to @param {boolean} isResult  with the results, once it has come there
   */
  async ask(wanted, isResult) {
    const { theatre, clock: { column } } = this;
    const { plannings, lanes, shown } = theatre;
    if (!shown) return;
    const fresh = this.known === plannings ? null : { document: shown.document, plans: lanes.map((lane) => lane.order(theatre.query)) };
    this.known = this.asking = plannings;
    try {
      const growths = await theatre.planners.ask("advance", [{ fresh, column, wanted, isResult }]);
      if (theatre.plannings === plannings) this.take(growths);
    } catch (error) {
      if (this.isAsking) this.asking = -1;
      if (theatre.plannings === plannings) theatre.fail(error);
    } finally {
      theatre.wake();
    }
  }

  /** The worker has planned a block. @param {Growth[]} growths */
  take(growths) {
    const { theatre: { lanes }, clock } = this;
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
    return Math.min(...this.theatre.lanes.map(({ run }) => run?.reached(this.clock.column) ?? Infinity));
  }

  /** The latest time at which it is known how all stand. */
  get limit() {
    const reached = this.reached();
    return reached < Infinity ? reached : Math.max(0, ...this.theatre.lanes.map(({ run }) => run?.clock(this.clock.column) ?? 0));
  }

  /** The robots drive on, all at the same part of their ways. @param {number} elapsed  seconds */
  travel(elapsed) {
    const [lead, ...others] = this.theatre.journeys;
    lead?.advance(elapsed);
    for (const journey of others) Object.assign(journey, { drawn: lead.drawn, at: lead.at });
  }

  /** Shows a time that the log knows of. @param {number} time */
  show(time) {
    const { theatre, clock } = this;
    const { lanes } = theatre;
    const isCalm = theatre.stage.look?.calm;
    clock.now = Math.min(time, this.limit);
    clock.head = Math.max(clock.head, clock.now);
    for (const lane of lanes) {
      if (!lane.run) continue;
      lane.run.shown = lane.run.iterationAt(clock.column, clock.now);
      // A path draws itself only before someone who watches it grow, and wants to see it move.
      if (lane.arrive() && lane.end && (isCalm || !clock.playing || lanes.length > 1)) lane.end.drawn = 1;
    }
    if (!theatre.growing && (isCalm || !theatre.travelling)) clock.playing = false;
  }
}
