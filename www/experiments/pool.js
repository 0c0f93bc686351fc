/**
 * The workers that run trials: one fewer than the processors, at least one. Trials are handed out in runs of
 * neighbours, which share a world. What a trial gives depends on nothing but its number, so neither does its row depend
 * on who runs it, or when.
 */
import { errorInfo } from "../app/error-info.js";

/** @import { ExperimentDocument } from "planarium/full" */
/** @import { Remote } from "../app/worker-client.js" */
/** @import { Commands, Info } from "./commands.js" */
/** @import { Rows } from "./rows.js" */

/** @typedef {Remote<Commands>} ExperimentWorker */
/** Trials that a worker still has to run. @typedef {{ from: number, to: number, isNew: boolean }} Job */

/** Milliseconds of a call, about: a pause takes no longer. */
const SLICE = 80;
/** Trials of a job at most. */
const LARGEST = 512;

/** The trials of an experiment that have not ended: a pause keeps them. */
export class Queue {
  /** @param {ExperimentDocument | null} document @param {Rows} rows  which the trials fill */
  constructor(document, rows) {
    this.document = document;
    this.rows = rows;
    /** @type {Map<ExperimentWorker, Job>} */
    this.jobs = new Map();
    /** Jobs of workers that were lost. @type {Job[]} */
    this.left = [];
    /** The first trial that was not handed out. */
    this.next = 0;
  }

  /**
   * The job of a worker: the one that it has begun, or a new one.
   * @param {ExperimentWorker} worker
   * @param {number} workers  that share the trials
   * @returns {Job | undefined}  none is left
   */
  jobOf(worker, workers) {
    const job = this.jobs.get(worker) ?? this.left.pop() ?? this.cut(workers);
    if (job) this.jobs.set(worker, job);
    return job;
  }

  /** @param {number} workers @returns {Job | undefined} */
  cut(workers) {
    const { next, rows } = this;
    if (next >= rows.count) return undefined;
    // Jobs become smaller towards the end, so that all workers end together.
    this.next += Math.min(LARGEST, Math.ceil((rows.count - next) / (4 * workers)));
    return { from: next, to: this.next, isNew: true };
  }

  /** The trials of a worker that was lost are run again, by any worker. @param {ExperimentWorker} worker */
  takeBack(worker) {
    const job = this.jobs.get(worker);
    if (job) this.left.push({ ...job, isNew: true });
    this.jobs.delete(worker);
  }
}

export class Pool {
  /** @param {ExperimentWorker} first @param {() => ExperimentWorker} hire  starts a further worker */
  constructor(first, hire) {
    this.workers = [first];
    this.hire = hire;
    this.most = Math.max(1, (navigator.hardwareConcurrency || 1) - 1);
    /** The document that a worker has opened. @type {Map<ExperimentWorker, ExperimentDocument | null>} */
    this.opened = new Map();
  }

  /**
   * Lets the core check a document.
   * @param {ExperimentDocument} document
   * @param {ExperimentWorker} [worker]
   * @returns {Promise<Info>}
   * @throws {Error} it is refused
   */
  async open(document, worker = this.workers[0]) {
    this.opened.delete(worker);
    const info = await worker.open(document);
    this.opened.set(worker, document);
    return info;
  }

  /**
   * Runs trials until all have ended, or until the signal.
   * @param {Queue} queue
   * @param {AbortSignal} signal
   * @param {() => void} onRows  called after some have ended
   * @throws {Error} a trial could not be started
   */
  async run(queue, signal, onRows) {
    const { document, rows } = queue;
    let isFailed = false;
    const drive = async (/** @type {ExperimentWorker} */ worker) => {
      try {
        while (!signal.aborted && !isFailed) {
          const job = queue.jobOf(worker, this.most);
          if (!job) return;
          if (document && this.opened.get(worker) !== document) {
            await this.open(document, worker);
            if (signal.aborted) return;
            // A worker that was opened again does not know how far its trials were.
            job.isNew = true;
          }
          const {
            first,
            rows: ended,
            seconds,
            isDone,
          } = await worker.advance(job.isNew ? [job.from, job.to] : null, SLICE);
          job.isNew = false;
          job.from = first + ended.length;
          if (isDone) queue.jobs.delete(worker);
          ended.forEach((cells, i) => rows.set(first + i, cells, seconds.subarray(2 * i, 2 * i + 2)));
          if (ended.length > 0) onRows();
        }
      } catch (error) {
        queue.takeBack(worker);
        this.opened.delete(worker);
        const isLost = errorInfo(error).code === "" && this.workers.length > 1;
        if (!isLost) {
          isFailed = true;
          throw error;
        }
        this.workers = this.workers.filter((other) => other !== worker);
        this.most = this.workers.length;
      }
    };
    const count = Math.max(1, Math.min(this.most, rows.count - rows.done));
    while (this.workers.length < count) this.workers.push(this.hire());
    // Again where a worker was lost and the others had nothing left.
    do await Promise.all(this.workers.map(drive));
    while (!signal.aborted && queue.left.length > 0);
  }

  /**
   * Gives each item to a worker that is free, until the signal.
   * @template T
   * @param {T[]} items
   * @param {AbortSignal} signal
   * @param {(worker: ExperimentWorker, item: T) => Promise<void>} act
   */
  async share(items, signal, act) {
    const left = items.values();
    await Promise.all(
      this.workers.map(async (worker) => {
        for (const item of left) {
          if (signal.aborted) return;
          await act(worker, item);
        }
      }),
    );
  }
}
