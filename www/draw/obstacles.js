/** One obstacle that stands out from the others: hatched, outlined, or both. */
import { obstaclePath } from "planarium/draw";
import { setStroke } from "./marks.js";
import { fillWith } from "./shapes.js";

/** @import { View } from "planarium/draw" */
/** @import { Obstacle } from "../domain/types.js" */
/** @import { Palette } from "../app/palette.js" */

/**
 * Marks an obstacle.
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {Obstacle} obstacle
 * @param {Palette} palette
 * @param {object} style
 * @param {CanvasPattern | string | null} [style.hatch]  it is filled with, half transparent
 * @param {string} style.colour  of its outline
 * @param {number} [style.width]  of the outline, CSS pixels
 * @param {number[]} [style.dash]
 */
export function markObstacle(context, view, obstacle, palette, { hatch = null, colour, width = 2, dash = [] }) {
  context.save();
  context.lineJoin = "round";
  obstaclePath(context, view, obstacle);
  if (obstacle.type === "wall") {
    // Its segments overlap: what is inside of their outlines is covered.
    setStroke(context, colour, 2 * width);
    context.stroke();
    fillWith(context, palette.obstacle);
  }
  fillWith(context, hatch, 0.55);
  if (obstacle.type !== "wall") {
    setStroke(context, colour, width, dash);
    context.stroke();
  }
  context.restore();
}
