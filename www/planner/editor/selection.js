/**
 * Draws the editor's overlay: the selection and its handles, a polygon being drawn, and refused or colliding objects.
 */
import { handlesFor, partOf } from "./handles.js";
import { touchingSentence } from "../../domain/names.js";
import { isTip } from "../stage/grip.js";
import { boundsOf, obstacleOf, poseOf, targetOf } from "./objects.js";
import { collisionsOf } from "./offers.js";
import { ring, setStroke } from "../../draw/marks.js";
import { markObstacle } from "../../draw/obstacles.js";
import { drawGhost, drawHit, drawLabel, drawTouchingParts } from "../../draw/shapes.js";
import { Workspace } from "../stage/workspace-pane.js";

/** @import { Lane } from "../stage/lane.js" */
/** @import { Pane } from "../stage/pane.js" */
/** @import { Palette } from "../../app/palette.js" */
/** @import { View } from "planarium/draw" */
/** @import { Editor } from "./editor.js" */
/** @import { Scenario } from "../../domain/types.js" */

/** Half the width of a handle, CSS pixels. */
const SIZE = { vertex: 4.5, edges: 4.5, radius: 5, middle: 3 };

/** @param {Pane} pane @param {CanvasRenderingContext2D} context @param {Lane} lane @param {Editor} editor */
export function drawOverlay(pane, context, lane, editor) {
  const { document, scenario } = lane.shown;
  const palette = /** @type {Palette} */ (pane.palette);
  const view = /** @type {View} */ (pane.view);
  const { selected, part } = editor;
  const isSquare = !(pane instanceof Workspace);
  if (!isSquare) drawObjects(pane, context, lane, editor, view, palette);
  const pose = poseOf(document, selected);
  const target = targetOf(document, selected);
  const isPoint = isSquare || isTip(scenario, part);
  const point =
    pose && isPoint ? pane.pixels(Float64Array.from(pose)) : target && !isSquare ? view.place(target.point) : null;
  if (point) {
    context.strokeStyle = palette.ink;
    context.lineWidth = 1.5;
    ring(context, point[0], point[1], 13);
  }
  nameTouching(pane, context, editor, scenario, palette);
}

/**
 * The objects of the workspace.
 * @param {Workspace} pane
 * @param {CanvasRenderingContext2D} context
 * @param {Lane} lane
 * @param {Editor} editor
 * @param {View} view
 * @param {Palette} palette
 */
function drawObjects(pane, context, lane, editor, view, palette) {
  const { selected, part, tool, refused } = editor;
  const { draft, loose } = editor.hand;
  const collisions = collisionsOf(editor);
  const { shown } = lane;
  const { document, scenario } = shown;
  for (const { pose, check } of collisions) {
    for (const { obstacle } of check.touching) pane.drawTouched(context, document, obstacle);
    const hit = new Set(check.touching.map((pair) => pair.part));
    drawTouchingParts(
      context,
      view,
      scenario.footprint(pose).filter((_, i) => hit.has(i)),
      palette,
      pane.hatchOnPart,
    );
  }
  if (collisions.length > 0) pane.drawEnds(context, lane, palette);
  const pose = poseOf(document, selected);
  if (selected && pose) {
    const colour = palette[selected.kind === "start" ? "start" : "goal"];
    const parts = scenario.footprint(pose);
    drawGhost(context, view, parts, { colour, fill: 0.25, stroke: 1, dash: [], width: 3 });
    if (part !== null && parts[part] && !shown.placed)
      drawGhost(context, view, [parts[part]], { colour: palette.ink, fill: 0, stroke: 1, dash: [], width: 1.5 });
  }
  for (const end of /** @type {const} */ (["goal", "start"])) {
    const at = shown[end];
    const isActive = selected?.kind === end && part === 0;
    if (at) shown.placed?.drawHandle(context, view, at, palette[end], isActive ? palette.ink : palette.stage);
  }
  context.save();
  context.lineJoin = "round";
  const obstacle = obstacleOf(document, selected);
  const bounds = boundsOf(document, selected);
  setStroke(context, palette.ink, 2);
  if (obstacle) markObstacle(context, view, obstacle, palette, { colour: palette.ink });
  if (bounds) {
    const [[left, bottom], [right, top]] = [view.place(bounds.min), view.place(bounds.max)];
    context.strokeRect(left, top, right - left, bottom - top);
  }
  context.lineWidth = 1.5;
  for (const handle of handlesFor(document, selected, view)) {
    const { kind, at } = handle;
    const isActive = part !== null && partOf(handle) === part;
    const isSquare = kind === "vertex" || kind === "edges";
    drawHandle(context, view.place(at), SIZE[kind], isSquare, isActive ? palette.ink : palette.stage);
  }
  if (draft.length > 0) {
    setStroke(context, palette.ink, 2, [4, 4]);
    const points = loose ? [...draft, loose] : draft;
    context.beginPath();
    for (const point of points) context.lineTo(...view.place(point));
    if (tool === "polygon") context.closePath();
    context.stroke();
    setStroke(context, palette.ink, 2);
    points.forEach((at, i) => drawHandle(context, view.place(at), i === 0 ? 6 : 3.5, i > 0, palette.stage));
  }
  if (refused) {
    const hatch = pane.hatchOnObstacle ?? palette.collision;
    markObstacle(context, view, refused, palette, { hatch, colour: palette.collision, dash: [5, 4] });
  }
  context.restore();
}

/**
 * Names the collision beside each start or goal in collision, within the pane.
 * @param {Pane} pane
 * @param {CanvasRenderingContext2D} context
 * @param {Editor} editor
 * @param {Scenario} scenario
 * @param {Palette} palette
 */
function nameTouching(pane, context, editor, scenario, palette) {
  for (const { end, pose, check } of collisionsOf(editor)) {
    const [x, y] = pane.pixels(Float64Array.from(pose));
    if (!(pane instanceof Workspace)) drawHit(context, x, y, palette);
    const [first, ...more] = check.touching;
    const text = `${end}: ${touchingSentence(scenario, { free: false, touching: [first] })}${more.length > 0 ? ` and ${more.length} more` : ""}`;
    context.font = `600 ${13 * pane.bold}px system-ui, sans-serif`;
    const half = context.measureText(text).width / 2 + 6;
    const inside = Math.min(Math.max(x, half), Math.max(half, pane.width - half));
    drawLabel(
      context,
      text,
      inside,
      y < 40 ? y + 13 + 13 * pane.bold : y - 11 - 13 * pane.bold,
      palette.collision,
      palette,
      pane.bold,
    );
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {[number, number]} place
 * @param {number} radius
 * @param {boolean} isSquare
 * @param {string} fill
 */
function drawHandle(context, [x, y], radius, isSquare, fill) {
  context.beginPath();
  if (isSquare) context.rect(x - radius, y - radius, 2 * radius, 2 * radius);
  else context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
  context.stroke();
}
