/** A run as a stream of what it adds. */
import { budgetOf, fieldsOf } from "./plain.js";
/** @import { Growth, GrowthOptions, Planner } from "./core.js" */

/**
 * See `Planner.growth` in the declarations. Its argument has been copied.
 * @this {Planner}
 * @param {GrowthOptions | Error} [options]
 * @returns {AsyncGenerator<Growth, void, undefined>}
 */
export function growth(options) {
  const { budget = 8 } = fieldsOf(options, "options", "budget");
  void this.status;
  return slices(this, budgetOf(budget));
}

/**
 * The cursors advance by what was yielded: the body of a loop may step the planner, too.
 * @param {Planner} planner
 * @param {number} budget
 * @returns {AsyncGenerator<Growth, void, undefined>}
 */
async function* slices(planner, budget) {
  let [vertices, edges, events] = [0, 0, 0];
  const pause = new Pause();
  try {
    for (let { status } = planner; ; status = planner.stepFor(budget)) {
      const grown = {
        status,
        iterations: planner.iterations,
        vertices: planner.verticesSince(vertices),
        edges: planner.edgesSince(edges),
        events: planner.eventsSince(events),
      };
      vertices += grown.vertices.length / planner.dimension;
      edges += grown.edges.length / 2;
      events += grown.events.length / planner.eventWidth;
      yield grown;
      if (status !== "running") return;
      await pause.next();
    }
  } finally {
    pause.end();
  }
}

/**
 * Lets other tasks and frames run, without the delays of timers: by a message, in Node (where messages go first) by an
 * immediate.
 */
export class Pause {
  #channel = typeof setImmediate === "function" ? null : new MessageChannel();

  /** @returns {Promise<unknown>} */
  next() {
    const channel = this.#channel;
    if (channel === null) return new Promise((resolve) => setImmediate(resolve));
    return new Promise((resolve) => {
      channel.port1.onmessage = resolve;
      channel.port2.postMessage(0);
    });
  }

  end() {
    this.#channel?.port1.close();
  }
}
