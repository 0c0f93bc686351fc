/**
 * A training as the page shows it: its settings, the pool that runs it, its curves, and drives of the policy so far.
 */
import { Navigation } from "planarium/full";
import { latest } from "../app/work.js";
import { TrainingPool } from "./pool.js";

/** @import { Demonstration, NavigationDocument, PolicyDocument } from "planarium/full" */
/** @import { Settings } from "../domain/types.js" */
/** @import { TrainingWorker } from "./pool.js" */
/** @import { NavigationSession } from "./session.js" */

/** A generation. @typedef {{ mean: number, best: number, reached: number }} Row */

export class TrainingRun {
  /** @param {NavigationSession} session @param {TrainingWorker} worker @param {() => TrainingWorker} hire */
  constructor(session, worker, hire) {
    this.session = session;
    this.pool = new TrainingPool(worker, hire);
    /** The options that differ from the defaults. @type {Settings} */
    this.given = {};
    this.generation = 0;
    this.generations = 0;
    this.fingerprint = "";
    /** @type {Row[]} */
    this.history = [];
    /** @type {Demonstration[]} */
    this.demonstrations = [];
    /** Their floors: to draw, and to sense. @type {NavigationDocument[]} */
    this.floors = [];
    /** @type {Navigation[]} */
    this.tasks = [];
    /** The policy so far. @type {PolicyDocument | null} */
    this.policy = null;
    /**
     * "beginning": the worker generates its tasks; "refused": the settings are not valid.
     * @type {"none" | "beginning" | "ready" | "running" | "over" | "refused"}
     */
    this.status = "none";
    /** The drive whose rays are drawn. */
    this.selected = 0;
  }

  /** Begins again, unless the settings are refused. */
  begin = latest(async (signal) => {
    const { session, pool, given } = this;
    this.status = "beginning";
    session.app.changed();
    try {
      const { generations, demonstrations, floors, policy } = await pool.begin(session.robotDocument, given, signal);
      for (const task of this.tasks) task.free();
      Object.assign(this, {
        generations,
        demonstrations,
        policy,
        floors,
        tasks: floors.map((floor) => Navigation.parse(floor)),
        history: [],
        generation: 0,
        fingerprint: "",
        status: "ready",
        selected: 0,
      });
    } catch (error) {
      if (!signal.aborted) this.status = "refused";
      throw error;
    } finally {
      session.app.changed();
    }
  });

  /** Trains until it is paused, or up to a generation. @param {number} [until] */
  async run(until = Infinity) {
    if (this.status !== "ready" || this.generation >= Math.min(until, this.generations)) return;
    const { pool, session } = this;
    const { signal } = pool;
    this.status = "running";
    session.app.changed();
    try {
      await pool.train(({ generation, fingerprint, history, demonstrations, policy }) => {
        for (let at = 0; at < history.length; at += 3)
          this.history.push({ mean: history[at], best: history[at + 1], reached: history[at + 2] });
        Object.assign(this, { generation, fingerprint, demonstrations, policy });
        session.app.changed();
        return generation < Math.min(until, this.generations);
      });
    } finally {
      if (!signal.aborted) this.status = this.generation < this.generations ? "ready" : "over";
      session.app.changed();
    }
  }

  /** Forgets the training: the next one begins from scratch. */
  clear() {
    this.begin.cancel();
    this.pool.pause();
    Object.assign(this, { status: "none", generation: 0, fingerprint: "", history: [] });
    this.session.app.changed();
  }

  pause() {
    this.pool.pause();
  }
}
