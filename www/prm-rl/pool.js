/**
 * The workers that train: as many as there are processors beside the page's. Each has a training of its own with the
 * same options and evaluates some candidates of a generation; all of them are then given all returns. So the policy
 * does not depend on how many there are.
 */
import { errorInfo } from "../app/error-info.js";

/** @import { NavigationDocument } from "planarium/full" */
/** @import { Remote } from "../app/worker-client.js" */
/** @import { Settings } from "../domain/types.js" */
/** @import { Commands, Generation } from "./commands.js" */

/** @typedef {Remote<Commands>} TrainingWorker */

/** Parts of a generation for each worker: a pause takes no longer than one of them. */
const PARTS = 4;

export class TrainingPool {
  /** @param {TrainingWorker} first @param {() => TrainingWorker} hire  starts a further worker */
  constructor(first, hire) {
    this.workers = [first];
    this.hire = hire;
    this.most = 1;
    /** Whether the training was given up. */
    this.signal = new AbortController().signal;
    this.isRunning = false;
    /** What a training begins with. @type {[NavigationDocument, Settings] | null} */
    this.beginning = null;
    /** How many generations of this training a worker has ended. @type {Map<TrainingWorker, number>} */
    this.known = new Map();
    /** The returns of the generations that are over. @type {Float64Array[]} */
    this.ended = [];
    /** Those of the present one, and its candidates that nobody evaluates yet. */
    this.returns = new Float64Array();
    /** @type {[first: number, end: number][]} */
    this.left = [];
  }

  /**
   * Replaces the training.
   * @param {NavigationDocument} document
   * @param {Settings} settings
   * @param {AbortSignal} signal  gives it up, then or later
   * @throws {Error} they are refused
   */
  async begin(document, settings, signal) {
    this.isRunning = false;
    const [first] = this.workers;
    const info = await first.beginTraining(document, settings, signal);
    this.signal = signal;
    this.beginning = [document, settings];
    this.most = Math.max(1, (navigator.hardwareConcurrency || 1) - 1);
    this.known = new Map([[first, 0]]);
    this.ended = [];
    this.prepare(info.candidates);
    return { ...info, ...(await first.demonstrate(signal)) };
  }

  /** Divides a generation into parts. @param {number} candidates */
  prepare(candidates) {
    const size = Math.max(1, Math.ceil(candidates / (PARTS * this.most)));
    this.returns = new Float64Array(2 * candidates);
    this.left = Array.from({ length: Math.ceil(candidates / size) }, (_, i) => [
      i * size,
      Math.min(candidates, (i + 1) * size),
    ]);
  }

  /**
   * Trains until `onGeneration` returns false or `isRunning` is false.
   * @param {(generation: Generation) => boolean} onGeneration
   * @throws {Error} no worker is left, or it was given up
   */
  async run(onGeneration) {
    const { signal } = this;
    this.isRunning = true;
    while (this.workers.length < this.most) this.workers.push(this.hire());
    try {
      while (this.isRunning) {
        // All of them end before a failure is thrown, so that none counts for a later run.
        const ended = await Promise.allSettled(this.workers.map((worker) => this.evaluate(worker, signal)));
        for (const end of ended) if (end.status === "rejected") throw end.reason;
        if (!this.isRunning) return;
        // Again where a worker was lost and the others had nothing left.
        if (this.left.length > 0) continue;
        const [first] = this.workers;
        this.ended.push(this.returns);
        this.prepare(this.returns.length / 2);
        const generation = await first.advance(this.ended.slice(this.known.get(first)), signal);
        this.known.set(first, this.ended.length);
        if (!onGeneration(generation)) return;
      }
    } finally {
      if (!signal.aborted) this.isRunning = false;
    }
  }

  /** @param {TrainingWorker} worker @param {AbortSignal} signal */
  async evaluate(worker, signal) {
    /** @type {[number, number] | undefined} */
    let part;
    try {
      while (this.isRunning && (part = this.left.shift())) {
        if (!this.known.has(worker) && this.beginning) {
          await worker.beginTraining(...this.beginning, signal);
          this.known.set(worker, 0);
        }
        const returns = await worker.returnsOf(...part, this.ended.slice(this.known.get(worker)), signal);
        this.known.set(worker, this.ended.length);
        this.returns.set(returns, 2 * part[0]);
      }
    } catch (error) {
      signal.throwIfAborted();
      // Its candidates are evaluated again, by any worker; the first one has the policy.
      if (part) this.left.push(part);
      this.known.delete(worker);
      if (errorInfo(error).code !== "" || worker === this.workers[0]) {
        this.isRunning = false;
        throw error;
      }
      this.workers = this.workers.filter((other) => other !== worker);
      this.most = this.workers.length;
    }
  }
}
