/**
 * What the stage shows: the one value that every pane reads and only the page's wiring writes.
 *
 * @typedef {object} Picture
 * @property {Scenario} scenario
 * @property {ScenarioDocument} document
 * @property {Configuration | null} start   of the query asked
 * @property {Configuration | null} goal
 * @property {Run | null} run
 * @property {Journey | null} journey   once solved
 * @property {Float64Array | null} hand         the pose held by hand, if any
 * @property {Check | null} check  of the pose held by hand
 */

/** @import { Check, Configuration, Scenario, ScenarioDocument } from "../types.js" */
/** @import { Run } from "../run.js" */
/** @import { Journey } from "../animate.js" */

/** Where the robot is to be drawn, if anywhere. @param {Picture} picture @returns {Float64Array | null} */
export function shownPose(picture) {
  if (picture.hand) return picture.hand;
  if (picture.journey && picture.journey.drawn >= 1) return picture.journey.configuration(picture.journey.at);
  return null;
}
