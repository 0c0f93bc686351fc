/** Opens entries without a browser: each page's own code reads the state, makes the link and draws the picture. */
import { openExperiment } from "./experiments.js";
import { openFleet } from "./fleet.js";
import { openNeighbours } from "./neighbours.js";
import { openPlanner } from "./planner.js";
import { openLearned } from "./prm-rl.js";
import { openReach } from "./reach.js";
import { openTrajectories } from "./trajectories.js";

/** @import { RobotKind } from "../../prm-rl/session.js" */
/** @import { PolicyDocument } from "planarium/full" */
/** @import { LinkedDocument, ScenarioDocument } from "../../domain/types.js" */
/** @import { Entry } from "../format.js" */
/** @import { Pane } from "./sheet.js" */

/**
 * The documents that entries name; scenes are the built-in ones of the planner's page.
 * @typedef {{ world: (name: string) => ScenarioDocument, scene: (name: string) => string, experiment: (name: string) =>
 *   LinkedDocument, policies: () => Record<RobotKind, PolicyDocument> }} Documents
 */
/**
 * The link of an entry, relative to the gallery, and its picture; `pane`: the size of a pane, pixels, unless it is a
 * usual one.
 * @typedef {{ address: string, panes: Pane[], pane?: { width: number, height: number } }} Opened
 */

/**
 * @param {Entry} entry
 * @param {Documents} documents
 * @returns {Promise<Opened>}
 * @throws {Error} the page would refuse the state
 */
export async function openEntry(entry, documents) {
  switch (entry.page) {
    case "planner":
      return openPlanner(entry, documents);
    case "reach":
      return openReach(entry, documents);
    case "neighbours":
      return openNeighbours(entry, documents);
    case "trajectories":
      return openTrajectories(entry);
    case "fleet":
      return openFleet(entry);
    case "prm-rl":
      return openLearned(entry, documents);
    case "experiments":
      return openExperiment(entry, documents);
  }
}
