/** The world of a scenario, and handles to drag. */
import { View } from "planarium/draw";
import { drawBase, drawGround } from "./ground.js";
import { addLine, disc, ring, strokeWithHalo } from "./marks.js";

/** @import { Scenario, ScenarioDocument } from "../domain/types.js" */
/** @import { Palette } from "../app/palette.js" */
/** @import { Brush } from "./figure.js" */

/** The ground of a workspace, and the base of an arm. @param {Brush} brush @param {Scenario} scenario @param {ScenarioDocument} document @returns {View} */
export function drawWorkspace({ context, palette, width, height }, scenario, document) {
  const view = new View(scenario.extent(), width, height);
  drawGround(context, view, document, palette);
  if (document.robot.type === "arm") drawBase(context, view, document.robot.base, palette);
  return view;
}

/** A ring to drag. @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {string} colour @param {Palette} palette */
export function drawHandle(context, x, y, colour, palette) {
  context.fillStyle = palette.stage;
  disc(context, x, y, 8);
  context.strokeStyle = context.fillStyle = colour;
  context.lineWidth = 2.4;
  ring(context, x, y, 6.6);
  disc(context, x, y, 2.4);
}

/** An upright cross with a halo. @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {string} colour @param {Palette} palette @param {number} size */
export function drawCross(context, x, y, colour, palette, size) {
  strokeWithHalo(context, [5.5, 2.2], colour, palette, () => {
    addLine(context, x - size, y, x + size, y);
    addLine(context, x, y - size, x, y + size);
  });
}
