/** A picture of the obstacles of a configuration space, made in the worker. */
import { paint, soften } from "../../draw/mask.js";

/** @import { Box, Scenario, ScenarioDocument } from "../../domain/types.js" */
/** @import { Palette } from "../../app/palette.js" */

/**
 * @typedef {object} Painting
 * @property {ScenarioDocument} document
 * @property {number} side      cells a side
 * @property {{ pose: number[], axes: [number, number], box: Box } | null} slice   with more than two coordinates: the
 *   others are those of the pose
 * @property {number} width     device pixels
 * @property {number} height
 * @property {Palette} palette
 */

/** @param {Scenario} scenario @param {Painting} painting @returns {ImageBitmap} */
export function paintObstacles(scenario, { side, slice, width, height, palette }) {
  const cells = slice ? sliceOf(scenario, side, slice) : scenario.cspace({ width: side, height: side });
  return paint(soften(cells, side), side, width, height, palette).transferToImageBitmap();
}

/**
 * Cells of a slice, rows from the lowest coordinates, 1 is collision.
 * @param {Scenario} scenario
 * @param {number} side
 * @param {NonNullable<Painting["slice"]>} slice
 */
function sliceOf(scenario, side, { pose, axes: [across, up], box: { min, max } }) {
  const q = Float64Array.from(pose);
  const cells = new Uint8Array(side * side);
  for (let i = 0; i < cells.length; i++) {
    q[across] = min[0] + ((max[0] - min[0]) * ((i % side) + 0.5)) / side;
    q[up] = min[1] + ((max[1] - min[1]) * (Math.floor(i / side) + 0.5)) / side;
    cells[i] = scenario.check(q).free ? 0 : 1;
  }
  return cells;
}
