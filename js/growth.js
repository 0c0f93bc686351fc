/** A run as a stream of what it adds. */
import { PlanariumError } from "./error.js";
/** @import { Growth, GrowthOptions, Planner, Status } from "./core.js" */

/**
 * See `Planner.growth` in the declarations. Its argument has been copied.
 * @this {Planner}
 * @param {GrowthOptions | Error} [options]
 * @returns {AsyncGenerator<Growth, void, undefined>}
 */
export function growth(options) {
  if (typeof (options ?? {}) !== "object" || options instanceof Error) throw new PlanariumError("wrong-type", "options must be an object with the field budget");
  const { budget = 8, ...rest } = options ?? {};
  const [unknown] = Object.keys(rest);
  if (unknown !== undefined) throw new PlanariumError("unknown-field", `unknown option ${JSON.stringify(unknown)}; known options are budget`, `/${unknown}`);
  return slices(this, this.status, budget);
}

/** @param {Planner} planner @param {Status} status @param {number} budget @returns {AsyncGenerator<Growth, void, undefined>} */
async function* slices(planner, status, budget) {
  let [vertices, edges, events] = [0, 0, 0];
  const pause = new Pause();
  try {
    for (; ; status = planner.stepFor(budget)) {
      yield {
        status, iterations: planner.iterations,
        vertices: planner.verticesSince(vertices), edges: planner.edgesSince(edges), events: planner.eventsSince(events),
      };
      if (status !== "running") return;
      [vertices, edges, events] = [planner.vertexCount, planner.edgeCount, planner.eventCount];
      await pause.next();
    }
  } finally {
    pause.end();
  }
}

/** Lets other tasks and frames run, without the delays of timers: by a message, in Node (where messages go first) by an immediate. */
class Pause {
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
