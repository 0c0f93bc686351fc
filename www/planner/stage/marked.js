/** Configurations from a file, on the ground: discs where they are free, crosses in collision. */
import { cross, disc } from "../../draw/marks.js";

/** @import { Lane } from "./lane.js" */
/** @import { Pane } from "./pane.js" */
/** @import { Palette } from "../../app/palette.js" */

/** @typedef {{ rows: Float64Array, free: Uint8Array }} Marked   rows of configurations; 1 for each that is free */

/** Radius of a disc and half the width of a cross on a pane of medium size, CSS pixels. */
const RADIUS = 2.4;

/** @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
export function drawMarked(pane, context, { shown: { marked } }) {
  if (!marked) return;
  const palette = /** @type {Palette} */ (pane.palette);
  const points = pane.pixels(marked.rows);
  const size = RADIUS * pane.fineness;
  context.save();
  pane.clip(context);
  context.fillStyle = palette.ink;
  context.strokeStyle = palette.collision;
  context.lineWidth = 1.4;
  marked.free.forEach((free, i) => (free ? disc : cross)(context, points[2 * i], points[2 * i + 1], size));
  context.restore();
}
