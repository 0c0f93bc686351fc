/**
 * The workers that run trials: as many as there are processors beside the page's. Trials are handed out in runs of
 * neighbours, which share a world. What a trial gives depends on nothing but its number, so neither does its row depend
 * on who runs it, or when.
 */
import { errorInfo } from "../app/error-info.js";
import { Rows } from "./rows.js";

/** @import { ExperimentDocument } from "planarium/full" */
/** @import { Remote } from "../app/worker-client.js" */
/** @import { Commands, Info } from "./commands.js" */

/** @typedef {Remote<Commands>} ExperimentWorker */
/** Trials that a worker still has to run. @typedef {{ from: number, to: number, isNew: boolean }} Job */

/** Milliseconds of a call, about: a pause takes no longer. */
const SLICE = 80;
/** Trials of a job at most. */
const LARGEST = 512;

export class Pool {
  /** @param {ExperimentWorker} first @param {() => ExperimentWorker} hire  starts a further worker */
  constructor(first, hire) {
    this.workers = [first];
    this.hire = hire;
    this.most = Math.max(1, (navigator.hardwareConcurrency || 1) - 1);
    /** Another number for each experiment: replies of an earlier one are dropped. */
    this.epoch = 0;
    this.isRunning = false;
    /** The document that a worker has opened. @type {Map<ExperimentWorker, number>} */
    this.opened = new Map();
    /** @type {Map<ExperimentWorker, Job>} */
    this.jobs = new Map();
    /** Jobs of workers that were lost. @type {Job[]} */
    this.left = [];
    /** The first trial that was not handed out. */
    this.next = 0;
    this.rows = new Rows([], 0);
    /** @type {ExperimentDocument | null} */
    this.document = null;
  }

  /**
   * Replaces the experiment; whatever ran is stopped.
   * @param {ExperimentDocument} document
   * @returns {Promise<Info | null>}  null: another one came since
   * @throws {Error} it is refused
   */
  async open(document) {
    const epoch = ++this.epoch;
    this.isRunning = false;
    this.document = document;
    const info = await this.workers[0].open(document);
    if (epoch !== this.epoch) return null;
    this.opened.set(this.workers[0], epoch);
    this.clear();
    return info;
  }

  /** Forgets jobs. */
  clear() {
    this.jobs.clear();
    this.left = [];
    this.next = 0;
  }

  /** Stops, and forgets what was run. */
  async cancel() {
    this.isRunning = false;
    // Replies that are on their way belong to an epoch before.
    const epoch = ++this.epoch;
    this.clear();
    const known = this.workers.filter((worker) => this.opened.get(worker) === epoch - 1);
    for (const worker of known) this.opened.set(worker, epoch);
    // A worker that was lost has nothing to stop.
    await Promise.allSettled(known.map((worker) => worker.stop()));
  }

  /**
   * Runs trials until all have ended or `isRunning` is false.
   * @param {Rows} rows  that get them @param {() => void} onRows  called after some have
   * @throws {Error} a trial could not be started
   */
  async run(rows, onRows) {
    this.rows = rows;
    this.isRunning = true;
    const { epoch } = this;
    const count = Math.max(1, Math.min(this.most, rows.count - rows.done));
    while (this.workers.length < count) this.workers.push(this.hire());
    try {
      // Again where a worker was lost and the others had nothing left.
      do await Promise.all(this.workers.slice(0, count).map((worker) => this.drive(worker, epoch, onRows)));
      while (this.isRunning && epoch === this.epoch && this.left.length > 0);
    } finally {
      if (epoch === this.epoch) this.isRunning = false;
    }
  }

  /** @param {ExperimentWorker} worker @param {number} epoch @param {() => void} onRows */
  async drive(worker, epoch, onRows) {
    try {
      if (this.opened.get(worker) !== epoch) {
        if (this.document) await worker.open(this.document);
        this.opened.set(worker, epoch);
      }
      while (this.isRunning && epoch === this.epoch) {
        const job = this.jobs.get(worker) ?? this.nextJob();
        if (!job) return;
        this.jobs.set(worker, job);
        const { first, rows, seconds, isDone } = await worker.advance(job.isNew ? [job.from, job.to] : null, SLICE);
        if (epoch !== this.epoch) return;
        job.isNew = false;
        job.from = first + rows.length;
        if (isDone) this.jobs.delete(worker);
        rows.forEach((cells, i) => this.rows.set(first + i, cells, seconds.subarray(2 * i, 2 * i + 2)));
        if (rows.length > 0) onRows();
      }
    } catch (error) {
      if (epoch !== this.epoch) return;
      // Its trials are run again, by any worker.
      const job = this.jobs.get(worker);
      if (job) this.left.push({ ...job, isNew: true });
      this.jobs.delete(worker);
      this.opened.delete(worker);
      const isLost = errorInfo(error).code === "" && this.workers.length > 1;
      if (!isLost) {
        this.isRunning = false;
        throw error;
      }
      this.workers = this.workers.filter((other) => other !== worker);
      this.most = this.workers.length;
    }
  }

  /** @returns {Job | undefined} */
  nextJob() {
    const {
      rows: { count },
      next,
      left,
    } = this;
    if (left.length > 0 || next >= count) return left.pop();
    // Jobs become smaller towards the end, so that all workers end together.
    const size = Math.max(1, Math.min(LARGEST, Math.ceil((count - next) / (4 * this.most))));
    this.next = Math.min(count, next + size);
    return { from: next, to: this.next, isNew: true };
  }
}
