/** The drawing of the start page's run: the world, the tree, the path, the ends. The build draws its picture by it. */
import { View, drawEdges, drawPath } from "planarium/draw";
import { rowsOf } from "../domain/coordinates.js";
import { withOptions } from "../domain/option-names.js";
import { drawGround } from "../draw/ground.js";
import { drawGoal, drawStart } from "../draw/shapes.js";
import { RUN } from "./run.js";

/** @import * as Library from "planarium" */
/** @import { Palette } from "../app/palette.js" */
/** @typedef {{ scenario: Library.Scenario, planner: Library.Planner }} Run */

/** The run at iteration 0. @param {Pick<typeof Library, "Scenario">} library @returns {Run} */
export function beginRun({ Scenario }) {
  const scenario = withOptions(RUN.options, (options) => Scenario.generate(RUN.kind, options));
  const settings = { ...RUN.settings, algorithm: RUN.algorithm };
  return { scenario, planner: withOptions(settings, (options) => scenario.planner(options)) };
}

/**
 * Draws the run as far as it has grown.
 * @param {CanvasRenderingContext2D} context
 * @param {Run} run
 * @param {Palette} palette
 * @param {number} width
 * @param {number} height
 */
export function drawRun(context, { scenario, planner }, palette, width, height) {
  const view = new View(scenario.extent(), width, height);
  const document = scenario.document();
  const [{ start, goal = start }] = document.queries;
  drawGround(context, view, document, palette);
  context.globalAlpha = 0.6;
  drawEdges(context, view, scenario, planner, 0, palette);
  context.globalAlpha = 1;
  const path = rowsOf(planner.path(), planner.dimension).map((row) => [...row]);
  if (path.length > 0) drawPath(context, view, scenario, { path }, palette);
  drawStart(context, ...view.place(start), palette);
  drawGoal(context, ...view.place(goal), palette);
}
