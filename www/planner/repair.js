/**
 * A lazy roadmap that stands is repaired when the scenario is edited: the worker reopens it among the obstacles as they
 * are now. There is one repair at a time; the newest scenario waits for it.
 */
import { errorInfo } from "../app/error-info.js";
import { Lane } from "./stage/lane.js";

/** @import { ScenarioDocument } from "../domain/types.js" */
/** @import { Session } from "./session.js" */
/** @import { Growth } from "./worker/stepper.js" */

export class Repair {
  /** @param {Session} session */
  constructor(session) {
    this.session = session;
    /** The scenario to repair the roadmap in next. @type {ScenarioDocument | null} */
    this.waiting = null;
    this.isBusy = false;
    /** Number of the planning whose roadmap the worker still has, while its start or goal is in collision. */
    this.held = -1;
  }

  /** Whether there is a single run, with a lazy roadmap that stands. */
  get isPossible() {
    const {
      lanes: [{ run } = { run: null }, ...others],
      plannings,
    } = this.session;
    return others.length === 0 && Boolean(this.held === plannings || (run?.ended && run.isLazy));
  }

  /** Repairs the roadmap in a scenario. @param {ScenarioDocument} document */
  request(document) {
    this.waiting = document;
    if (!this.isBusy) void this.session.app.track(this.work());
  }

  async work() {
    const { session } = this;
    this.isBusy = true;
    try {
      while (this.waiting) {
        const { plannings } = session;
        const document = this.waiting;
        this.waiting = null;
        try {
          const growth = await session.team.repair(document);
          if (plannings === session.plannings && this.fits(document)) this.show(growth);
        } catch (error) {
          if (plannings === session.plannings) this.refuse(error);
        }
      }
    } finally {
      this.isBusy = false;
    }
  }

  /**
   * Whether the roadmap of a scenario has the start and the goals of the one shown: obstacles may be a frame ahead.
   * @param {ScenarioDocument} document
   */
  fits(document) {
    const { shown } = this.session;
    return (
      shown !== null && (shown.document === document || (shown.document.queries === document.queries && !shown.target))
    );
  }

  /**
   * Shows the repaired roadmap at its end, and the world as it is now.
   * @param {Growth} growth
   * @throws {Error} start or goal are in collision by now
   */
  show(growth) {
    const { session } = this;
    const { shown, clock } = session;
    const [former] = session.lanes;
    if (!shown) return;
    const lane = new Lane(shown, former.plan);
    lane.start(session.catalogue);
    lane.run?.take(growth);
    this.held = -1;
    session.refusal = null;
    this.replace(lane);
    session.timeline.show(Infinity);
    clock.halt();
    if (lane.end) lane.end.drawn = 1;
    session.setEnds(shown);
  }

  /** Shows why there is no roadmap: start or goal are in collision. @param {unknown} error */
  refuse(error) {
    const { session } = this;
    const { code } = errorInfo(error);
    if (code === "" || code === "internal" || !session.shown) throw error;
    session.refusal = { error, lane: 0 };
    this.replace(new Lane(session.shown, session.lanes[0].plan));
    this.held = session.plannings;
  }

  /**
   * Replaces the lane, as another planning that the worker has: the panes draw a new one together with its world.
   * @param {Lane} lane
   */
  replace(lane) {
    const { session } = this;
    session.timeline.sent = ++session.plannings;
    session.lanes[0].free();
    session.lanes[0] = lane;
    session.clock.reset();
    session.markDirty();
  }
}
