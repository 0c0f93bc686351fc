/** The ground of the workspace: a grid, the bounds, the reach of an arm, its base. */
import { disc, ring } from "./marks.js";

/** @import { Box } from "../domain/types.js" */
/** @import { Palette } from "../app/palette.js" */
/** @import { View } from "./view.js" */
/** @typedef {CanvasRenderingContext2D} Context */

/** A grid of faint dots. @param {Context} context @param {View} view @param {Palette} palette */
export function drawScale(context, view, palette) {
  const step = view.grid;
  const [left, bottom] = view.toPlane(0, view.height);
  const [right, top] = view.toPlane(view.width, 0);
  context.fillStyle = palette.line;
  for (let x = Math.ceil(left / step) * step; x <= right; x += step) {
    for (let y = Math.ceil(bottom / step) * step; y <= top; y += step) {
      context.fillRect(view.x(x) - 0.75, view.y(y) - 0.75, 1.5, 1.5);
    }
  }
}

/** @param {Context} context @param {View} view @param {Box} bounds @param {Palette} palette */
export function drawBounds(context, view, { min, max }, palette) {
  context.strokeStyle = palette["obstacle-edge"];
  context.lineWidth = 1.5;
  context.strokeRect(view.x(min[0]), view.y(max[1]), (max[0] - min[0]) * view.scaleX, (max[1] - min[1]) * view.scaleY);
}

/** The circle that contains an arm in every configuration. @param {Context} context @param {View} view @param {{ base: ArrayLike<number>, links: number[], radius?: number }} arm @param {Palette} palette */
export function drawReach(context, view, { base, links, radius = 0 }, palette) {
  const reach = links.reduce((sum, link) => sum + link, radius);
  context.strokeStyle = palette.line;
  context.setLineDash([2, 5]);
  ring(context, ...view.place(base), reach * view.scaleX);
  context.setLineDash([]);
}

/** The base of an arm. @param {Context} context @param {View} view @param {ArrayLike<number>} base @param {Palette} palette */
export function drawBase(context, view, base, palette) {
  context.fillStyle = context.strokeStyle = palette.ink;
  context.lineWidth = 1;
  disc(context, ...view.place(base), 4.5);
  ring(context, ...view.place(base), 8.5);
}
