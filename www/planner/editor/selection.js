/** Draws the editor's overlay: the selection and its handles, a polygon being drawn, and refused or colliding objects. */
import { obstaclePath } from "planarium/draw";
import { handlesOf } from "./handles.js";
import { touchingSentence } from "../../domain/names.js";
import { isTip, tipOf } from "./end-effector.js";
import { obstacleOf, poseOf, targetOf } from "./objects.js";
import { drawGhost, drawHit, drawLabel, drawTouchingParts } from "../../draw/shapes.js";
import { Workspace } from "../stage/workspace-pane.js";

/** @import { Lane } from "../lane.js" */
/** @import { Pane } from "../stage/pane.js" */
/** @import { Palette } from "../../app/palette.js" */
/** @import { View } from "planarium/draw" */
/** @import { Overlay } from "./editor.js" */
/** @import { Scenario } from "../../domain/types.js" */

/** @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
export function drawOverlay(pane, context, lane) {
  if (pane instanceof Workspace) drawSelection(pane, context, lane);
  else drawSelectedPoint(pane, context, lane);
}

/** On the workspace. @param {Workspace} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
function drawSelection(pane, context, lane) {
  const { shown } = lane;
  const { overlay, document, scenario } = shown;
  const palette = /** @type {Palette} */ (pane.palette);
  const view = /** @type {View} */ (pane.view);
  if (!overlay) return;
  const { selected, part, draft, refused, touching } = overlay;
  for (const { pose, check } of touching) {
    for (const { obstacle } of check.touching) pane.drawTouched(context, document, obstacle);
    const hit = new Set(check.touching.map((pair) => pair.part));
    drawTouchingParts(context, view, scenario.footprint(pose).filter((_, i) => hit.has(i)), palette, pane.hatchOnPart);
  }
  if (touching.length > 0) pane.drawEnds(context, lane, palette);
  const pose = poseOf(document, selected);
  if (selected && pose) {
    const colour = palette[selected.kind === "start" ? "start" : "goal"];
    const parts = scenario.footprint(pose);
    drawGhost(context, view, parts, { colour, fill: 0.25, stroke: 1, dash: [], width: 3 });
    if (part !== null && parts[part] && !shown.placed) drawGhost(context, view, [parts[part]], { colour: palette.ink, fill: 0, stroke: 1, dash: [], width: 1.5 });
  }
  for (const end of /** @type {const} */ (["goal", "start"])) {
    const at = shown[end];
    const isActive = selected?.kind === end && part === 0;
    if (at) shown.placed?.drawHandle(context, view, at, palette[end], isActive ? palette.ink : palette.stage);
  }
  const target = targetOf(document, selected);
  if (pose && selected && isTip(scenario, selected, part)) drawSelected(context, ...pixelsOf(view, tipOf(scenario, pose)), palette);
  if (target) drawSelected(context, ...pixelsOf(view, target.point), palette);
  context.save();
  context.lineJoin = "round";
  const obstacle = obstacleOf(document, selected);
  context.strokeStyle = palette.ink;
  if (obstacle) {
    obstaclePath(context, view, obstacle);
    context.lineWidth = 2;
    context.stroke();
    context.lineWidth = 1.5;
    for (const { kind, part: index, at: [x, y] } of handlesOf(obstacle, view)) {
      const isActive = kind === "vertex" && index === part;
      drawHandle(context, view.x(x), view.y(y), kind === "vertex" ? 4.5 : kind === "radius" ? 5 : 3, kind === "vertex", isActive ? palette.ink : palette.stage);
    }
  }
  if (draft.length > 0) {
    context.setLineDash([4, 4]);
    context.lineWidth = 2;
    obstaclePath(context, view, { type: "polygon", vertices: draft });
    context.stroke();
    context.setLineDash([]);
    draft.forEach(([x, y], i) => drawHandle(context, view.x(x), view.y(y), i === 0 ? 6 : 3.5, i > 0, palette.stage));
  }
  if (refused) {
    obstaclePath(context, view, refused);
    context.fillStyle = pane.hatchOnObstacle ?? palette.collision;
    context.globalAlpha = 0.5;
    context.fill("evenodd");
    context.globalAlpha = 1;
    context.strokeStyle = palette.collision;
    context.setLineDash([5, 4]);
    context.lineWidth = 2;
    context.stroke();
    context.setLineDash([]);
  }
  context.restore();
  nameTouching(pane, context, overlay, scenario);
}

/** On the configuration space, where start and goal are points. @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane */
function drawSelectedPoint(pane, context, { shown }) {
  const { overlay, scenario, document } = shown;
  const palette = /** @type {Palette} */ (pane.palette);
  if (!overlay) return;
  const pose = poseOf(document, overlay.selected);
  if (pose) {
    const [x, y] = pane.pixels(Float64Array.from(pose));
    drawSelected(context, x, y, palette);
  }
  for (const { pose: at } of overlay.touching) {
    const [x, y] = pane.pixels(Float64Array.from(at));
    drawHit(context, x, y, palette);
  }
  nameTouching(pane, context, overlay, scenario);
}

/** A ring around the selection. @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {Palette} palette */
function drawSelected(context, x, y, palette) {
  context.strokeStyle = palette.ink;
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(x, y, 13, 0, 2 * Math.PI);
  context.stroke();
}

/** @param {View} view @param {ArrayLike<number>} point @returns {[number, number]} */
function pixelsOf(view, point) { return [view.x(point[0]), view.y(point[1])]; }

/** Names the collision beside each start or goal in collision, within the pane. @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Overlay} overlay @param {Scenario} scenario */
function nameTouching(pane, context, { touching }, scenario) {
  const palette = /** @type {Palette} */ (pane.palette);
  for (const { end, pose, check } of touching) {
    const [x, y] = pane.pixels(Float64Array.from(pose));
    const [first, ...more] = check.touching;
    const text = `${end}: ${touchingSentence(scenario, { free: false, touching: [first] })}${more.length > 0 ? ` and ${more.length} more` : ""}`;
    context.font = "600 13px system-ui, sans-serif";
    const half = context.measureText(text).width / 2 + 6;
    const inside = Math.min(Math.max(x, half), Math.max(half, pane.width - half));
    drawLabel(context, text, inside, y < 40 ? y + 26 : y - 24, palette.collision, palette);
  }
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} radius @param {boolean} isSquare @param {string} fill */
function drawHandle(context, x, y, radius, isSquare, fill) {
  context.beginPath();
  if (isSquare) context.rect(x - radius, y - radius, 2 * radius, 2 * radius);
  else context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
  context.stroke();
}
