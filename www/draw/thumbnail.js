/** A small picture of a scenario: its obstacles, start and goal. */
import { View, drawObstacles } from "planarium/draw";
import { drawGhost, drawTarget } from "./shapes.js";

/** @import { Look } from "../app/app.js" */
/** @import { Scenario } from "../domain/types.js" */

const MARGIN = { left: 5, right: 5, top: 5, bottom: 5 };

/** @param {Scenario} scenario @param {number} side  CSS pixels @param {Look} look @returns {ImageBitmap} */
export function drawThumbnail(scenario, side, { palette, ratio }) {
  const pixels = Math.round(side * ratio);
  const canvas = new OffscreenCanvas(pixels, pixels);
  const context = /** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (canvas.getContext("2d")));
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const view = new View(scenario.extent(), side, side, MARGIN);
  const { world, queries } = scenario.document();
  drawObstacles(context, view, world.obstacles, { ...palette, obstacleEdge: palette.obstacle });
  const target = queries[0]?.target;
  if (target) drawTarget(context, ...view.place(target.point), target.orientation, palette);
  for (const end of /** @type {const} */ (["goal", "start"])) {
    const pose = queries[0]?.[end];
    if (pose)
      drawGhost(context, view, scenario.footprint(pose), {
        colour: palette[end],
        fill: 0.9,
        stroke: 1,
        dash: [],
        width: 1.6,
      });
  }
  return canvas.transferToImageBitmap();
}
