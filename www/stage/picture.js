/**
 * What the stage shows: the one value that every pane reads and only the page's wiring writes.
 *
 * @typedef {object} Picture
 * @property {import("../types.js").Scenario} scenario
 * @property {import("../types.js").ScenarioDocument} document
 * @property {ArrayLike<number> | null} start   of the query asked
 * @property {ArrayLike<number> | null} goal
 * @property {import("../run.js").Run | null} run
 * @property {import("../animate.js").Journey | null} journey   once solved
 * @property {Float64Array | null} hand         the pose held by hand, if any
 * @property {import("../types.js").Check | null} check  of the pose held by hand
 */

/** Where the robot is to be drawn, if anywhere. @param {Picture} picture @returns {Float64Array | null} */
export function shownPose(picture) {
  if (picture.hand) return picture.hand;
  if (picture.journey && picture.journey.drawn >= 1) return picture.journey.configuration(picture.journey.at);
  return null;
}
