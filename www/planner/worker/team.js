/**
 * The workers that plan: in a race one for each planner, as far as there are processors. What a planner grows depends
 * neither on its worker nor on the other planners; a planner that is faster than another gets ahead, and what is ahead
 * is not shown.
 */
import { errorInfo } from "../../app/error-info.js";

/** @import { Advance, PlannerWorker } from "./worker.js" */
/** @import { Growth } from "./stepper.js" */
/** @import { ScenarioDocument } from "../../domain/types.js" */

export class Team {
  /** @param {PlannerWorker} first @param {() => PlannerWorker} hire   starts a further worker */
  constructor(first, hire) {
    this.workers = [first];
    this.hire = hire;
    /** Workers at most: a processor is left to the page. */
    this.most = Math.max(1, (navigator.hardwareConcurrency || 1) - 1);
    /** How many of them have planners; planner i belongs to worker i modulo this number. */
    this.busy = 1;
    /** The latest request for new planners. @type {Advance | null} */
    this.latest = null;
  }

  /** Plans one block of each planner. @param {Advance} advance @returns {Promise<Growth[]>} */
  async advance(advance) {
    const { workers } = this;
    const { fresh } = advance;
    if (fresh) {
      this.latest = advance;
      this.busy = Math.max(1, Math.min(fresh.plans.length, this.most));
      while (workers.length < this.busy) workers.push(this.hire());
    }
    // A worker that gets no new planners frees those that it had.
    const asked = fresh ? workers : workers.slice(0, this.busy);
    const parts = asked.map((worker, i) =>
      worker.advance({
        ...advance,
        fresh: fresh && { ...fresh, plans: fresh.plans.filter((_, lane) => lane % this.busy === i) },
      }),
    );
    try {
      return interleaved(await Promise.all(parts), this.busy);
    } catch (error) {
      if (advance !== this.latest || workers.length === 1 || errorInfo(error).code !== "") throw error;
      // A further worker could not be loaded: the first one plans alone.
      this.most = workers.length = 1;
      return this.advance(advance);
    }
  }

  /** Queries the roadmap of the first planner. @param {number[]} start @param {number[]} goal */
  ask(start, goal) {
    return this.workers[0].ask(start, goal);
  }

  /** Repairs the roadmap of the first planner in an edited scenario. @param {ScenarioDocument} document */
  repair(document) {
    return this.workers[0].repair(document);
  }
}

/**
 * The planners' blocks in the order of the planners.
 * @param {Growth[][]} parts   of each worker
 * @param {number} busy
 * @returns {Growth[]}
 */
function interleaved(parts, busy) {
  return Array.from({ length: parts.flat().length }, (_, lane) => parts[lane % busy][Math.floor(lane / busy)]);
}
