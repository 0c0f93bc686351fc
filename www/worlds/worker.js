/** The worker that reads worlds: it has the module of formats, and the core, which knows what is free. */
import { Scenario } from "planarium";
import { readWorld } from "planarium/import";
import { serve } from "../app/worker-server.js";
import { fitting, optionsOf } from "./choices.js";
import { faultOf } from "./fault.js";
import { decoded } from "./photo.js";
import { placesIn, spreadIn } from "./places.js";

/** @import { Content } from "../app/read-files.js" */
/** @import { Choices } from "./choices.js" */
/** @import { Fault, Reading } from "./types.js" */

/** The files, as `readWorld` reads them. @type {Promise<Content[]>} */
let files = Promise.resolve([]);
/** The world that was read last. @type {Scenario | null} */
let scenario = null;

const commands = {
  /** The files of the world, in place of those before. @param {Content[]} contents */
  hold(contents) {
    files = Promise.all(contents.map(decoded));
    // Whoever reads them next gets the error.
    files.catch(() => {});
  },
  /**
   * Reads the world.
   * @param {Choices} choices
   * @param {boolean} suggests   whether a robot is chosen that fits, if the files have none
   * @returns {Promise<Reading | { fault: Fault }>}
   */
  async read(choices, suggests) {
    try {
      const { scenario: document, ...read } = await readWorld(await files, optionsOf(choices));
      const suggested = suggests ? fitting(document, read.report) : null;
      // The robot changes nothing else.
      const robot = suggested ? /** @type {const} */ ({ type: "disc", radius: suggested.radius }) : document.robot;
      const margin = choices.margin > 0 ? { margin: choices.margin } : {};
      const world = { ...read, scenario: { ...document, robot: { ...robot, ...margin } } };
      scenario?.free();
      scenario = null;
      scenario = Scenario.parse(world.scenario);
      return { world, suggested, places: world.scenario.queries.length > 0 ? null : placesIn(scenario) };
    } catch (error) {
      return { fault: faultOf(error) };
    }
  },
  /** Connected places that are far apart, in the world that was read last. @param {number} count */
  spread: (count) => (scenario ? spreadIn(scenario, count) : []),
  /** Whether configurations are free in the world that was read last. @param {number[][]} poses */
  check: (poses) => poses.map((pose) => scenario?.check(pose).free ?? false),
};

/** @typedef {import("../app/worker-client.js").Remote<typeof commands>} WorldWorker */

serve({
  worlds: {
    commands,
    reset: () => {
      scenario = null;
    },
  },
});
