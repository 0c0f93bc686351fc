/**
 * A planner in a worker, and what has been sent of it. It holds no core: planners of both have the same methods. The
 * worker of a page has it, too.
 */

/** @import { Planner } from "./core.js" */
/** @import { WorkerGrowth } from "./worker.js" */

/** Most iterations between two looks at the clock. */
const LONGEST = 64;

export class PlannerHost {
  /** Rows that were sent. */
  sent = { vertices: 0, edges: 0, events: 0, history: 0 };

  /** @param {Planner} planner  which is freed with the host */
  constructor(planner) {
    this.planner = planner;
  }

  /**
   * Steps in slices, which are short at first and grow while they are cheap, so that none is long.
   * @param {() => number} left  iterations that are still wanted, asked before each slice; 0: none
   * @param {number} until  on the clock of `performance.now()`
   * @returns {boolean}  whether it has come before that time to the end, of the run or of what is wanted
   */
  stepUntil(left, until) {
    const { planner } = this;
    let longest = 1;
    for (let wanted = left(); wanted > 0 && planner.status === "running"; wanted = left()) {
      const began = performance.now();
      if (began >= until) return false;
      const { iterations } = planner;
      planner.step(Math.min(longest, Math.ceil(wanted)));
      const ended = performance.now();
      const cost = Math.max((ended - began) / Math.max(1, planner.iterations - iterations), 1e-4);
      longest = Math.max(1, Math.min(2 * longest, LONGEST, Math.floor((until - ended) / (2 * cost))));
    }
    return true;
  }

  /** What is new since the last call. @returns {WorkerGrowth} */
  grown() {
    const { planner, sent } = this;
    const { status, iterations } = planner;
    this.sent = countsOf(planner);
    return {
      status,
      iterations,
      ...grownSince(planner, sent),
      result: status === "running" ? null : planner.result(),
    };
  }

  free() {
    this.planner.free();
  }
}

/** The numbers of rows of a planner. @param {Planner} planner */
export function countsOf({ vertexCount, edgeCount, eventCount, historyCount }) {
  return { vertices: vertexCount, edges: edgeCount, events: eventCount, history: historyCount };
}

/** The rows of a planner after some. @param {Planner} planner @param {ReturnType<typeof countsOf>} counts */
export function grownSince(planner, { vertices, edges, events, history }) {
  return {
    vertices: planner.verticesSince(vertices),
    edges: planner.edgesSince(edges),
    events: planner.eventsSince(events),
    traces: planner.tracesSince(edges),
    motions: planner.motionsSince(edges),
    history: planner.historySince(history),
  };
}
