/** The ground of the workspace: a grid, the world, the reach of an arm, its base. */
import { View, drawWorld } from "planarium/draw";
import { longestOf } from "../domain/coordinates.js";
import { disc, ring, setStroke } from "./marks.js";

/** @import { ArmRobot } from "../domain/coordinates.js" */
/** @import { Scenario, ScenarioDocument } from "../domain/types.js" */
/** @import { Palette } from "../app/palette.js" */
/** @import { Brush } from "./figure.js" */
/** @typedef {CanvasRenderingContext2D} Context */

/**
 * The ground of a figure.
 * @param {Brush} brush
 * @param {Scenario} scenario
 * @param {ScenarioDocument} document
 * @returns {View}
 */
export function drawWorkspace({ context, palette, width, height }, scenario, document) {
  const view = new View(scenario.extent(), width, height);
  drawGround(context, view, document, palette);
  if (document.robot.type === "arm") drawBase(context, view, document.robot.base, palette);
  return view;
}

/**
 * A round spacing for a grid, metres: the least of 1, 2, 5 times a power of ten that is at least 46 pixels.
 * @param {View} view
 */
export function gridOf({ scaleX }) {
  const least = 46 / scaleX;
  const power = 10 ** Math.floor(Math.log10(least));
  return ([1, 2, 5].find((factor) => factor * power >= least) ?? 10) * power;
}

/**
 * Grid, bounds or the reach of an arm, and obstacles.
 * @param {Context} context
 * @param {View} view
 * @param {ScenarioDocument} document
 * @param {Palette} palette
 * @param {{ draw: (context: Context, view: View, world: ScenarioDocument["world"], palette: Palette) => void }} [map]
 *   draws the world in the place of its obstacles
 */
export function drawGround(context, view, document, palette, map) {
  const { world, robot } = document;
  drawGrid(context, view, palette);
  if (!world.bounds && robot.type === "arm") drawReach(context, view, robot, palette);
  if (map) map.draw(context, view, world, palette);
  else drawWorld(context, view, document, palette);
}

/** A grid of faint dots. @param {Context} context @param {View} view @param {Palette} palette */
function drawGrid(context, view, palette) {
  const step = gridOf(view);
  const [left, bottom] = view.toPlane(0, view.height);
  const [right, top] = view.toPlane(view.width, 0);
  context.fillStyle = palette.line;
  for (let x = Math.ceil(left / step) * step; x <= right; x += step) {
    for (let y = Math.ceil(bottom / step) * step; y <= top; y += step) {
      context.fillRect(view.x(x) - 0.75, view.y(y) - 0.75, 1.5, 1.5);
    }
  }
}

/**
 * The circle that contains an arm in every configuration.
 * @param {Context} context
 * @param {View} view
 * @param {ArmRobot} arm
 * @param {Palette} palette
 */
function drawReach(context, view, arm, palette) {
  const reach = longestOf(arm).reduce((sum, link) => sum + link, arm.radius ?? 0);
  setStroke(context, palette.line, 1, [2, 5]);
  ring(context, ...view.place(arm.base), reach * view.scaleX);
  context.setLineDash([]);
}

/**
 * The base of an arm.
 * @param {Context} context
 * @param {View} view
 * @param {ArrayLike<number>} base
 * @param {Palette} palette
 */
export function drawBase(context, view, base, palette) {
  context.fillStyle = palette.ink;
  setStroke(context, palette.ink, 1);
  disc(context, ...view.place(base), 4.5);
  ring(context, ...view.place(base), 8.5);
}
