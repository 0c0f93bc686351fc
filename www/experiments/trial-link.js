/** The run of a trial as a link of the planner's page. */
import { plannerAddress } from "../app/resources.js";
import { encodeLink } from "../planner/link/codec.js";
import { nameOf } from "./factors.js";
import { variedOf, worldOfTrial } from "./worlds.js";

/** @import { ExperimentDocument } from "planarium/full" */
/** @import { LinkedDocument, Settings } from "../domain/types.js" */
/** @import { Rows } from "./rows.js" */

/**
 * @param {LinkedDocument} document
 * @param {ExperimentDocument} resolved  the same as the core reads it
 * @param {Rows} rows
 * @param {number} trial  that has ended @returns {Promise<string>}  an address
 */
export async function trialLink(document, resolved, rows, trial) {
  const cell = (/** @type {string} */ column) => rows.cell(trial, column);
  const planner = resolved.planners.find((entry) => nameOf(entry) === cell("planner"));
  const world = worldOfTrial(resolved, rows, trial);
  const linked = document.worlds[resolved.worlds.findIndex((entry) => nameOf(entry) === cell("world"))];
  if (!planner) throw new Error(`Trial ${trial} is of another experiment.`);
  const { budget } = resolved;
  const limit = budget && "iterations" in budget ? { max_iterations: budget.iterations } : {};
  const settings = /** @type {Settings} */ ({
    ...planner.set,
    ...variedOf(rows, trial, "planner", planner.vary),
    ...limit,
    seed: cell("seed"),
  });
  /** @type {import("../planner/link/codec.js").Experiment} */
  const experiment = {
    version: 1,
    query: String(cell("query")),
    lanes: [{ algorithm: planner.algorithm, settings }],
    iteration: Number(cell("iterations")),
    view: {},
  };
  if ("scene" in linked) experiment.scene = linked.scene;
  else if ("generate" in world) {
    experiment.scene = `make-${world.generate}`;
    experiment.options = world.options;
  } else experiment.document = { ...world.scenario };
  return `${plannerAddress()}#${await encodeLink(experiment)}`;
}
