/** A robot in collision: its parts and what they touch, red, hatched and with their names. */
import { obstacleName, partName } from "../domain/names.js";
import { coreOf, encloses, middleOf } from "../domain/obstacles.js";
import { drawLabels } from "./labels.js";
import { setStroke } from "./marks.js";
import { markObstacle } from "./obstacles.js";
import { drawTouchingParts } from "./shapes.js";

/** @import { Check, Obstacle, Part, Scenario, ScenarioDocument } from "../domain/types.js" */
/** @import { Palette } from "../app/palette.js" */
/** @import { View } from "planarium/draw" */
/**
 * @typedef {{ context: CanvasRenderingContext2D, view: View, palette: Palette, bold: number,
 *   onPart: CanvasPattern | null, onObstacle: CanvasPattern | null }} Brush   with hatches for parts and for obstacles
 */
/** @typedef {ScenarioDocument["world"]} World */

/** Parts named one by one, at most. */
const MOST_NAMES = 3;

/**
 * @param {Brush} brush
 * @param {{ scenario: Scenario, world: World, parts: Part[], touching: Check["touching"] }} shown
 * @param {() => void} draw  the robot
 */
export function drawTouching(brush, { scenario, world, parts, touching }, draw) {
  const { context, view, palette, bold, onPart } = brush;
  for (const { obstacle } of touching) drawTouched(brush, world, obstacle);
  draw();
  const hit = new Set(touching.map(({ part }) => part));
  drawTouchingParts(
    context,
    view,
    parts.filter((_, i) => hit.has(i)),
    palette,
    onPart,
  );
  /** @type {[text: string, place: [number, number]][]} */
  const names = [];
  // Of many links only the first and the last are named.
  for (const index of hit.size > MOST_NAMES ? [Math.min(...hit), Math.max(...hit)] : hit)
    names.push([partName(scenario, index), labelPlace(view, parts[index])]);
  const named = new Set();
  for (const { part, obstacle } of touching) {
    if (obstacle === "bounds" || named.has(obstacle)) continue;
    named.add(obstacle);
    names.push([obstacleName(obstacle), obstaclePlace(view, world.obstacles[obstacle], parts[part])]);
  }
  const labels = names.map(([text, [x, y]]) => ({ text, x, y, colour: palette.collision, isHere: true }));
  drawLabels(context, labels, palette, { width: view.width, height: view.height, bold });
}

/** @param {Brush} brush @param {World} world @param {number | "bounds"} obstacle */
export function drawTouched({ context, view, palette, onObstacle }, { bounds, obstacles }, obstacle) {
  context.save();
  if (obstacle === "bounds") {
    if (bounds) {
      setStroke(context, palette.collision, 3, [8, 5]);
      context.strokeRect(
        view.x(bounds.min[0]),
        view.y(bounds.max[1]),
        (bounds.max[0] - bounds.min[0]) * view.scaleX,
        (bounds.max[1] - bounds.min[1]) * view.scaleY,
      );
    }
  } else {
    markObstacle(context, view, obstacles[obstacle], palette, { hatch: onObstacle, colour: palette.collision });
  }
  context.restore();
}

/**
 * The place of an obstacle's name: its middle, or if that is outside, or for a wall, below its corner or the middle of
 * an edge that is nearest to the part.
 * @param {View} view
 * @param {Obstacle} obstacle
 * @param {Part} part
 * @returns {[number, number]}
 */
function obstaclePlace(view, obstacle, part) {
  const [x, y] = middleOf(obstacle);
  if (obstacle.type === "disc" || encloses(obstacle, x, y)) return view.place([x, y]);
  const [px, py] = part.type === "capsule" ? part.b : middleOf(part);
  const distance = (/** @type {[number, number]} */ vertex) => Math.hypot(vertex[0] - px, vertex[1] - py);
  const nearest = coreOf(obstacle)
    .segments.flatMap(([a, b]) => [a, /** @type {[number, number]} */ ([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2])])
    .reduce((best, vertex) => (distance(vertex) < distance(best) ? vertex : best));
  return [view.x(nearest[0]), view.y(nearest[1]) + 26];
}

/**
 * The place of a part's name: beside its middle, CSS pixels.
 * @param {View} view
 * @param {Part} part
 * @returns {[number, number]}
 */
function labelPlace(view, part) {
  if (part.type === "polygon")
    return [view.x(middleOf(part)[0]), view.y(Math.max(...part.vertices.map(([, y]) => y))) - 14];
  const clear = part.radius * view.scaleX + 16;
  if (part.type === "disc") return [view.x(part.center[0]), view.y(part.center[1]) - clear];
  const dx = view.x(part.b[0]) - view.x(part.a[0]);
  const dy = view.y(part.b[1]) - view.y(part.a[1]);
  const length = Math.hypot(dx, dy);
  const side = dx >= 0 ? 1 : -1;
  return [
    view.x(part.a[0]) + dx / 2 + (side * dy * clear * 1.5) / length,
    view.y(part.a[1]) + dy / 2 - (side * dx * clear) / length,
  ];
}
