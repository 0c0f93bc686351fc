/** A comparison of the methods, as the page shows it: it grows while it runs, and can be paused. */

import { coalesced, latest } from "../app/work.js";

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
    this.count = 0;
    this.iterations = 0;
    /** Executions at which it pauses. */
    this.until = Infinity;
    /** Whether it was forgotten. */
    this.signal = new AbortController().signal;
    /** @type {NavigationQueryDocument[]} */
    this.queries = [];
    /** @type {ComparedExecution[]} */
    this.executions = [];
    /** @type {MethodSummary[]} */
    this.summary = [];
  }

  /** Forgets the comparison: its floor, its policy or its options are others now. */
  clear() {
    this.begin.cancel();
    Object.assign(this, { status: "none", count: 0, iterations: 0, queries: [], executions: [], summary: [] });
    this.session.app.changed();
  }

  begin = latest(async (signal) => {
    const { session, given } = this;
    const begun = await session.worker.beginComparison(session.robotDocument, session.policy, given, signal);
    Object.assign(this, begun, { status: "paused", signal });
  });

  /** Begins, or goes on. @param {number} [until]  executions @throws {Error} the options are refused */
  async run(until = Infinity) {
    if (this.status === "none") await this.begin();
    if (this.status !== "paused") return;
    Object.assign(this, { status: "running", until });
    this.session.app.changed();
    await this.advance();
  }

  advance = coalesced(async () => {
    const { session, signal } = this;
    try {
      while (this.status === "running" && this.executions.length < this.until) {
        const progress = await session.worker.advanceComparison(signal);
        this.executions.push(...progress.executions);
        Object.assign(this, { iterations: progress.iterations, summary: progress.summary });
        if (progress.status !== "running") this.status = "over";
        session.app.changed();
      }
      this.pause();
    } catch (error) {
      // The worker has lost the comparison.
      if (!signal.aborted) this.clear();
      throw error;
    }
  });

  pause() {
    if (this.status === "running") this.status = "paused";
    this.session.app.changed();
  }
}
