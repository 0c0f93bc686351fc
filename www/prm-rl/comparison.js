/** A comparison of the ways to drive, as the page shows it: it grows while it runs, and can be paused. */

/** @import { ComparedExecution, MethodSummary, NavigationQueryDocument } from "planarium/full" */
/** @import { Settings } from "../domain/types.js" */
/** @import { NavigationSession } from "./session.js" */

export class ComparisonRun {
  /** @param {NavigationSession} session */
  constructor(session) {
    this.session = session;
    /** The options that differ from the defaults. @type {Settings} */
    this.given = {};
    /** "over": all is driven. @type {"none" | "running" | "paused" | "over"} */
    this.status = "none";
    this.id = 0;
    this.count = 0;
    this.iterations = 0;
    /** Comparisons begun or forgotten. */
    this.begun = 0;
    /** @type {NavigationQueryDocument[]} */
    this.queries = [];
    /** @type {ComparedExecution[]} */
    this.executions = [];
    /** @type {MethodSummary[]} */
    this.summary = [];
  }

  /** Forgets the comparison: its floor, its policy or its options are others now. */
  clear() {
    this.begun++;
    Object.assign(this, { status: "none", id: 0, count: 0, iterations: 0, queries: [], executions: [], summary: [] });
  }

  /** Begins, or goes on. @param {number} [until]  executions @throws {Error} the options are refused */
  async run(until = Infinity) {
    const { session, given } = this;
    if (this.status === "none") {
      const turn = ++this.begun;
      const begun = await session.worker.beginComparison(session.robotDocument, session.policy, given);
      // Its floor, robot or policy may be others by now.
      if (turn !== this.begun) return;
      this.clear();
      Object.assign(this, begun, { status: "paused" });
    }
    if (this.status !== "paused") return;
    const { id } = this;
    this.status = "running";
    session.update("comparison");
    while (this.status === "running" && this.executions.length < until) {
      const progress = await session.worker.advanceComparison(id).catch((error) => {
        // The worker has lost the comparison.
        if (id === this.id) this.clear();
        session.update("comparison");
        throw error;
      });
      if (!progress || id !== this.id) return;
      this.executions.push(...progress.executions);
      Object.assign(this, { iterations: progress.iterations, summary: progress.summary });
      if (progress.status !== "running") this.status = "over";
      session.update("comparison");
    }
    if (id === this.id && this.status === "running") this.status = "paused";
    session.update("comparison");
  }

  pause() {
    if (this.status === "running") this.status = "paused";
  }
}
