/**
 * What time it is in the session, and how it goes on. Time is counted in iterations, and in clearance evaluations where
 * several planners race: a count of work that is the same on every machine.
 */
import { PAST } from "../run-log/run-log.js";

/** Evaluations in a step of a race, and those that pass where a single run makes one iteration: it makes about as many. */
const PER_STEP = 10;

export class Clock {
  constructor() {
    this.isRace = false;
    this.pace = 60;
    /** The time that is shown. */
    this.now = 0;
    /** The latest time that was shown: up to there it can be replayed. */
    this.head = 0;
    /** The time to be reached: where it is ahead, planning or replay goes on. */
    this.wanted = 0;
    this.playing = false;
    /** As fast as it goes, whatever the pace. */
    this.rushing = false;
  }

  reset() {
    this.now = this.head = 0;
    this.halt();
  }

  /** The column of a run's history that tells this time; -1 counts iterations. */
  get column() { return this.isRace ? PAST.evaluations : -1; }

  /** One step of the transport, in units of time. */
  get unit() { return this.isRace ? PER_STEP : 1; }

  get speed() { return this.rushing ? Infinity : this.pace * this.unit; }

  /** Lets seconds pass while it plays. Being behind does not pile up beyond a quarter of a second. @param {number} seconds */
  pass(seconds) {
    if (!this.playing) return;
    const { speed } = this;
    if (speed === Infinity) this.wanted = Infinity;
    else this.wanted = Math.min((this.wanted === Infinity ? this.now : this.wanted) + speed * seconds, this.now + speed / 4 + this.unit);
  }

  /** Is there time to be caught up with? */
  get owes() { return this.wanted >= this.now + 1; }

  halt() {
    this.playing = false;
    this.rest();
  }

  /** There is nothing more to catch up with. */
  rest() {
    this.wanted = this.now;
    this.rushing = false;
  }

  /** @param {number} time */
  seek(time) {
    this.halt();
    this.wanted = Math.max(0, Math.floor(time));
  }
}
