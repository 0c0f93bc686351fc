/**
 * The workers that run trials. Trials are handed out in runs of neighbours, which share a world. What a trial gives
 * depends on nothing but its number, so neither does its row depend on who runs it, or when.
 */
import { Jobs, Pool } from "../app/pool.js";

/** @import { ExperimentDocument } from "planarium/full" */
/** @import { Remote } from "../app/worker-client.js" */
/** @import { Commands, Info } from "./commands.js" */
/** @import { Rows } from "./rows.js" */

/** @typedef {Remote<Commands>} ExperimentWorker */
/** Trials that have not ended. @typedef {{ from: number, to: number }} Job */

/** Milliseconds of a call, about: a pause takes no longer. */
const SLICE = 80;
/** Trials of a job at most. */
const LARGEST = 512;

/** The trials of an experiment that have not ended. @extends {Jobs<ExperimentWorker, Job>} */
export class Queue extends Jobs {
  /**
   * @param {ExperimentDocument | null} document
   * @param {Rows} rows  which the trials fill
   * @param {number} workers  that share the trials
   */
  constructor(document, rows, workers) {
    super(cut(rows.count, workers));
    this.document = document;
    this.rows = rows;
  }
}

/**
 * Jobs become smaller towards the end, so that all workers end together.
 * @param {number} count @param {number} workers
 * @returns {Generator<Job>}
 */
function* cut(count, workers) {
  for (let from = 0, to; from < count; from = to) {
    to = from + Math.min(LARGEST, Math.ceil((count - from) / (4 * workers)));
    yield { from, to };
  }
}

/** A worker holds a document and the job that it has begun. @typedef {{ document: ExperimentDocument, job: Job | null }} Held */

/** @extends {Pool<ExperimentWorker, Held>} */
export class TrialPool extends Pool {
  /**
   * Lets the core check a document.
   * @param {ExperimentDocument} document
   * @param {ExperimentWorker} [worker]
   * @returns {Promise<Info>}
   * @throws {Error} it is refused
   */
  async open(document, worker = this.workers[0]) {
    this.held.delete(worker);
    const info = await worker.open(document);
    this.held.set(worker, { document, job: null });
    return info;
  }

  /**
   * Runs trials until all have ended, or until the signal.
   * @param {Queue} queue
   * @param {AbortSignal} signal
   * @param {() => void} onRows  called after some have ended
   * @throws {Error} a trial could not be started
   */
  runTrials(queue, signal, onRows) {
    const { document, rows } = queue;
    return this.run(queue, signal, async (worker, job) => {
      if (document && this.held.get(worker)?.document !== document) {
        await this.open(document, worker);
        if (signal.aborted) return false;
      }
      const held = /** @type {Held} */ (this.held.get(worker));
      const isNew = held.job !== job;
      held.job = job;
      const { first, rows: ended, seconds, isDone } = await worker.advance(isNew ? [job.from, job.to] : null, SLICE);
      job.from = first + ended.length;
      ended.forEach((cells, i) => rows.set(first + i, cells, seconds.subarray(2 * i, 2 * i + 2)));
      if (ended.length > 0) onRows();
      return isDone;
    });
  }
}
