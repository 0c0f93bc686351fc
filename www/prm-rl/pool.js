/**
 * The workers that train. Each has a training of its own with the same options and evaluates some candidates of a
 * generation; all of them are then given all returns. So the policy does not depend on how many there are.
 */
import { Jobs, Pool } from "../app/pool.js";

/** @import { NavigationDocument } from "planarium/full" */
/** @import { Remote } from "../app/worker-client.js" */
/** @import { Settings } from "../domain/types.js" */
/** @import { Commands, Generation } from "./commands.js" */

/** @typedef {Remote<Commands>} TrainingWorker */
/** Candidates of a generation. @typedef {[first: number, end: number]} Part */

/** Parts of a generation for each worker: a pause takes no longer than one of them. */
const PARTS = 4;

/** A worker holds a training; of it is kept how many generations it knows. @extends {Pool<TrainingWorker, number>} */
export class TrainingPool extends Pool {
  /** Gives the training up. */
  signal = new AbortController().signal;
  pausing = new AbortController();
  /** What a training begins with. @type {[NavigationDocument, Settings] | null} */
  beginning = null;
  /** The returns of the generations that are over. @type {Float64Array[]} */
  ended = [];
  /** How many generations `onGeneration` knows. */
  known = 0;
  /** Those of the present one, and its candidates that are not evaluated. */
  returns = new Float64Array();
  /** @type {Jobs<TrainingWorker, Part>} */
  parts = new Jobs([]);

  /**
   * Replaces the training.
   * @param {NavigationDocument} document
   * @param {Settings} settings
   * @param {AbortSignal} signal  gives it up, then or later
   * @throws {Error} they are refused
   */
  async begin(document, settings, signal) {
    this.pause();
    const [first] = this.workers;
    const info = await first.beginTraining(document, settings, signal);
    this.signal = signal;
    this.beginning = [document, settings];
    this.held = new Map([[first, 0]]);
    this.ended = [];
    this.known = 0;
    this.prepare(info.candidates);
    return { ...info, ...(await first.demonstrate(signal)) };
  }

  /** Divides a generation into parts. @param {number} candidates */
  prepare(candidates) {
    const size = Math.max(1, Math.ceil(candidates / (PARTS * this.most)));
    this.returns = new Float64Array(2 * candidates);
    this.parts = new Jobs(
      Array.from({ length: Math.ceil(candidates / size) }, (_, i) => [i * size, Math.min(candidates, (i + 1) * size)]),
    );
  }

  pause() {
    this.pausing.abort();
  }

  /**
   * Trains until `onGeneration` returns false or it is paused.
   * @param {(generation: Generation) => boolean} onGeneration
   * @throws {Error} no worker is left, or it was given up
   */
  async train(onGeneration) {
    const { signal } = this;
    const { signal: pause } = (this.pausing = new AbortController());
    for (let goesOn = true; goesOn;) {
      await this.run(this.parts, pause, async (worker, part) => {
        const returns = await worker.returnsOf(...part, await this.missedBy(worker), signal);
        this.held.set(worker, this.ended.length);
        this.returns.set(returns, 2 * part[0]);
      });
      if (pause.aborted) return;
      this.ended.push(this.returns);
      this.prepare(this.returns.length / 2);
      await this.run(new Jobs([0]), signal, async (worker) => {
        const generation = await worker.advance(await this.missedBy(worker), this.known, signal);
        this.known = this.ended.length;
        this.held.set(worker, this.known);
        goesOn = onGeneration(generation);
      });
    }
  }

  /** The generations that a worker does not know; it gets the training first, if it has none. @param {TrainingWorker} worker */
  async missedBy(worker) {
    if (!this.held.has(worker) && this.beginning) {
      await worker.beginTraining(...this.beginning, this.signal);
      this.held.set(worker, 0);
    }
    return this.ended.slice(this.held.get(worker));
  }
}
