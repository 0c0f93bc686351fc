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

/** The kind of the event that a path was found: its third number is the vertex. */
const SOLVED = 3;

/**
 * The best path so far, which the planner has only at its end: from the vertex of the newest solution up to the root.
 * @param {Library.Planner} planner
 * @returns {number[][]}
 */
export function bestPath(planner) {
  const events = rowsOf(planner.eventsSince(0), planner.eventWidth);
  const found = events.findLast(([kind]) => kind === SOLVED);
  if (!found) return [];
  const edges = planner.edgesSince(0);
  /** The parent of each vertex: the last edge counts. @type {Map<number, number>} */
  const parents = new Map();
  for (let i = 0; i < edges.length; i += 2) parents.set(edges[i + 1], edges[i]);
  const vertices = rowsOf(planner.verticesSince(0), planner.dimension);
  const path = [];
  for (let at = /** @type {number | undefined} */ (found[2]); at !== undefined; at = parents.get(at))
    path.unshift([...vertices[at]]);
  return path;
}

/**
 * Draws the run as far as it has grown, and returns its path.
 * @param {CanvasRenderingContext2D} context
 * @param {Run} run
 * @param {Palette} palette
 * @param {number} width
 * @param {number} height
 * @returns {number[][]}
 */
export function drawRun(context, { scenario, planner }, palette, width, height) {
  const view = new View(scenario.extent(), width, height);
  const document = scenario.document();
  const [{ start, goal = start }] = document.queries;
  drawGround(context, view, document, palette);
  context.globalAlpha = 0.6;
  drawEdges(context, view, scenario, planner, 0, palette);
  context.globalAlpha = 1;
  const path = bestPath(planner);
  if (path.length > 0) drawPath(context, view, scenario, { path }, palette);
  drawStart(context, ...view.place(start), palette);
  drawGoal(context, ...view.place(goal), palette);
  return path;
}
