/**
 * The worker that times paths, judges those of other programs and measures how much room there is: it has all of the core, and
 * the module of formats.
 */
import { Scenario } from "planarium/full";
import { serve } from "../app/worker-server.js";
import { judge, keep, read } from "./judging.js";
import { clearances } from "./clearance.js";
import { documentOf, dropTrajectories, forgetTrajectories, timed, written } from "./timing.js";

/** @import { TimingLimits } from "planarium/full" */
/** @import { PathForm } from "planarium/import" */
/** @import { ResultDocument, ScenarioDocument } from "../domain/types.js" */

/** What the paths are paths of. @type {{ scenario: Scenario, document: ScenarioDocument } | null} */
let held = null;
/** Why the scene that was given last is none. @type {unknown} */
let refusal = null;

function scene() {
  if (!held) throw refusal ?? Object.assign(new Error("No scene is open."), { code: "no-scene" });
  return held;
}

const commands = {
  /** Another scene, in place of the one before. @param {ScenarioDocument} document */
  hold(document) {
    held?.scenario.free();
    held = null;
    refusal = null;
    try {
      held = { scenario: Scenario.parse(document), document };
    } catch (error) {
      refusal = error;
      throw error;
    }
  },
  /** The trajectories of results. @param {ResultDocument[]} results @param {TimingLimits} limits */
  time: (results, limits) => timed(scene(), results, limits),
  read,
  keep,
  /** Judges a path that was read. @param {number} id @param {boolean} arcs   are motions along arcs? */
  judge: (id, arcs) => judge(scene().scenario, id, arcs),
  /** @param {string | undefined} query */
  widest: (query) => scene().scenario.widest(query),
  /** @param {string | undefined} query */
  safest: (query) => scene().scenario.safest(query),
  /** @param {number} detour */
  routes: (detour) => scene().scenario.routeGraph({ detour }),
  /** The clearance along a path. @param {Float64Array} rows   of configurations */
  clearances: (rows) => clearances(scene().scenario, rows),
  /** Frees the trajectories. */
  drop: dropTrajectories,
  /** @param {number} index   of a trajectory that was made last */
  trajectory: (index) => documentOf(index),
  /** @param {number} index @param {PathForm} form @param {string | undefined} query */
  write: (index, form, query) => written(index, form, query),
};

/** @typedef {import("../app/worker-client.js").Remote<typeof commands>} PathWorker */

serve({
  paths: {
    commands,
    reset: () => {
      held = null;
      forgetTrajectories();
    },
  },
});
