/**
 * The workers that plan: in a race one for each planner, as far as there are processors. What a planner grows depends
 * neither on its worker nor on the other planners; a planner that is faster than another gets ahead, and what is ahead
 * is not shown.
 */
import { Crew, isLost } from "../../app/pool.js";

/** @import { Advance, PlannerWorker } from "./worker.js" */
/** @import { Growth } from "./stepper.js" */
/** @import { ScenarioDocument } from "../../domain/types.js" */

/** @extends {Crew<PlannerWorker>} */
export class Team extends Crew {
  /** How many workers have planners; planner i belongs to worker i modulo this number. */
  busy = 1;
  /** The latest request for new planners. @type {Advance | null} */
  latest = null;

  /** Plans one block of each planner. @param {Advance} advance @returns {Promise<Growth[]>} */
  async advance(advance) {
    const { fresh } = advance;
    if (fresh) {
      this.latest = advance;
      this.grow(fresh.plans.length);
      this.busy = Math.min(fresh.plans.length || 1, this.most);
    }
    // A worker that gets no new planners frees those that it had.
    const asked = fresh ? this.workers : this.workers.slice(0, this.busy);
    const parts = asked.map((worker, i) =>
      worker.advance({
        ...advance,
        fresh: fresh && { ...fresh, plans: fresh.plans.filter((_, lane) => lane % this.busy === i) },
      }),
    );
    try {
      return interleaved(await Promise.all(parts), this.busy);
    } catch (error) {
      if (advance !== this.latest || this.workers.length === 1 || !isLost(error)) throw error;
      // A further worker could not be loaded: the first one plans alone.
      for (const worker of this.workers.slice(1)) this.drop(worker);
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
