/**
 * The clock of the session. Time is the number of iterations, or in a race of clearance evaluations: a measure of work
 * that is the same on every machine.
 */
import { PAST } from "../run-log/columns.js";

/** Clearance evaluations in a step of a race: about as many as an iteration takes. */
const PER_STEP = 10;

export class Clock {
  constructor() {
    this.isRace = false;
    this.pace = 60;
    /** The time shown. */
    this.now = 0;
    /** The latest time shown, up to which the run can be replayed. */
    this.head = 0;
    /** The time to reach by planning or replay. */
    this.wanted = 0;
    this.playing = false;
    /** Whether it runs at full speed. */
    this.rushing = false;
  }

  reset() {
    this.now = this.head = 0;
    this.halt();
  }

  /** The column of the history with this time; -1 counts iterations. */
  get column() {
    return this.isRace ? PAST.clearanceEvaluations : -1;
  }

  /** The time in a step. */
  get unit() {
    return this.isRace ? PER_STEP : 1;
  }

  get speed() {
    return this.rushing ? Infinity : this.pace * this.unit;
  }

  /** Lets time pass while it plays; a delay adds up to a quarter of a second at most. @param {number} seconds */
  pass(seconds) {
    if (!this.playing) return;
    const { speed } = this;
    if (speed === Infinity) this.wanted = Infinity;
    else
      this.wanted = Math.min(
        (this.wanted === Infinity ? this.now : this.wanted) + speed * seconds,
        this.now + speed / 4 + this.unit,
      );
  }

  /** Whether the wanted time is not reached. */
  get owes() {
    return this.wanted >= this.now + 1;
  }

  halt() {
    this.playing = false;
    this.rest();
  }

  /** Takes the time shown as the wanted time. */
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
