/**
 * The workers of a page that share jobs: one fewer than the processors, at least one. What a job gives must not depend
 * on who does it, or when.
 */
import { errorInfo } from "./error-info.js";
import { isAbort } from "./work.js";

/** Whether the error of a command means that its worker is lost, and not that the core refused something. */
export function isLost(/** @type {unknown} */ error) {
  return errorInfo(error).code === "" && !isAbort(error);
}

/**
 * Jobs that are not done. A pause keeps them: a worker goes on with the job that it has begun.
 * @template W
 * @template J
 */
export class Jobs {
  /** @param {Iterable<J>} jobs */
  constructor(jobs) {
    this.left = [...jobs];
    /** @type {Map<W, J>} */
    this.begun = new Map();
  }

  get count() {
    return this.left.length + this.begun.size;
  }

  /** The job of a worker; none if no job is left. @param {W} worker @returns {J | undefined} */
  take(worker) {
    const job = this.begun.get(worker) ?? this.left.shift();
    if (job !== undefined) this.begun.set(worker, job);
    return job;
  }

  /** The job of a worker is done. @param {W} worker */
  end(worker) {
    this.begun.delete(worker);
  }

  /** The job of a worker is begun again, by any worker. @param {W} worker */
  takeBack(worker) {
    const job = this.begun.get(worker);
    if (job !== undefined) this.left.unshift(job);
    this.begun.delete(worker);
  }
}

/** Workers of a page. @template W   a worker */
export class Crew {
  /** @param {W} first @param {() => W} hire  starts a further worker */
  constructor(first, hire) {
    this.workers = [first];
    this.hire = hire;
    /** Workers at most; when the site is built, Node may have no navigator. */
    this.most = Math.max(1, (globalThis.navigator?.hardwareConcurrency || 1) - 1);
  }

  /** Hires workers, as many as there is work for. @param {number} count */
  grow(count) {
    while (this.workers.length < Math.min(this.most, count)) this.workers.push(this.hire());
  }

  /** Drops a worker that was lost; none is hired in its place. @param {W} worker */
  drop(worker) {
    this.workers = this.workers.filter((other) => other !== worker);
    this.most = this.workers.length;
  }
}

/**
 * Workers that share jobs.
 * @template W
 * @template [H=undefined]   what a worker holds between jobs
 * @extends {Crew<W>}
 */
export class Pool extends Crew {
  /** What a worker holds; after an error that is unknown. @type {Map<W, H>} */
  held = new Map();

  /**
   * Gives each job to a worker that is free, until none is left or the signal is aborted; then jobs stay. The job of a
   * worker that is lost goes to another one.
   * @template J
   * @param {Jobs<W, J>} jobs
   * @param {AbortSignal} signal
   * @param {(worker: W, job: J) => Promise<unknown>} act   resolves to false if the worker has to go on with the job
   * @throws {Error} of `act`, other than a lost worker; the last worker is lost
   */
  async run(jobs, signal, act) {
    let isFailed = false;
    const drive = async (/** @type {W} */ worker) => {
      try {
        while (!signal.aborted && !isFailed) {
          const job = jobs.take(worker);
          if (job === undefined) return;
          if ((await act(worker, job)) !== false) jobs.end(worker);
        }
      } catch (error) {
        jobs.takeBack(worker);
        this.held.delete(worker);
        if (!isLost(error) || this.workers.length === 1) {
          isFailed = true;
          throw error;
        }
        this.drop(worker);
      }
    };
    this.grow(jobs.count);
    // Of workers that were lost with other jobs.
    for (const worker of jobs.begun.keys()) if (!this.workers.includes(worker)) jobs.takeBack(worker);
    // Again where a worker was lost and the others had nothing left.
    while (!signal.aborted && jobs.count > 0) {
      // All workers stop before a failure is thrown, so that none acts for a later run.
      const ended = await Promise.allSettled(this.workers.map(drive));
      for (const end of ended) if (end.status === "rejected") throw end.reason;
    }
  }
}
