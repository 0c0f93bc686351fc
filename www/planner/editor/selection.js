/**
 * Draws the editor's overlay: the selection and its handles, a polygon being drawn, and refused or colliding objects.
 */
import { obstaclePath } from "planarium/draw";
import { handlesOf } from "./handles.js";
import { touchingSentence } from "../../domain/names.js";
import { isTip } from "../stage/grip.js";
import { obstacleOf, poseOf, targetOf } from "./objects.js";
import { ring } from "../../draw/marks.js";
import { drawGhost, drawHit, drawLabel, drawTouchingParts } from "../../draw/shapes.js";
import { Workspace } from "../stage/workspace-pane.js";

/** @import { Lane } from "../stage/lane.js" */
/** @import { Pane } from "../stage/pane.js" */
/** @import { Palette } from "../../app/palette.js" */
/** @import { View } from "planarium/draw" */
/** @import { Editor } from "./editor.js" */
/** @import { Scenario } from "../../domain/types.js" */

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
function drawObjects(
  pane,
  context,
  lane,
  { selected, part, hand: { draft, loose }, refused, collisions },
  view,
  palette,
) {
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
  context.strokeStyle = palette.ink;
  if (obstacle) {
    obstaclePath(context, view, obstacle);
    context.lineWidth = 2;
    context.stroke();
    context.lineWidth = 1.5;
    for (const {
      kind,
      part: index,
      at: [x, y],
    } of handlesOf(obstacle, view)) {
      const isActive = kind === "vertex" && index === part;
      drawHandle(
        context,
        view.x(x),
        view.y(y),
        kind === "vertex" ? 4.5 : kind === "radius" ? 5 : 3,
        kind === "vertex",
        isActive ? palette.ink : palette.stage,
      );
    }
  }
  if (draft.length > 0) {
    context.setLineDash([4, 4]);
    context.lineWidth = 2;
    const vertices = loose ? [...draft, loose] : draft;
    obstaclePath(context, view, { type: "polygon", vertices });
    context.stroke();
    context.setLineDash([]);
    vertices.forEach(([x, y], i) => drawHandle(context, view.x(x), view.y(y), i === 0 ? 6 : 3.5, i > 0, palette.stage));
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
function nameTouching(pane, context, { collisions }, scenario, palette) {
  for (const { end, pose, check } of collisions) {
    const [x, y] = pane.pixels(Float64Array.from(pose));
    if (!(pane instanceof Workspace)) drawHit(context, x, y, palette);
    const [first, ...more] = check.touching;
    const text = `${end}: ${touchingSentence(scenario, { free: false, touching: [first] })}${more.length > 0 ? ` and ${more.length} more` : ""}`;
    context.font = "600 13px system-ui, sans-serif";
    const half = context.measureText(text).width / 2 + 6;
    const inside = Math.min(Math.max(x, half), Math.max(half, pane.width - half));
    drawLabel(context, text, inside, y < 40 ? y + 26 : y - 24, palette.collision, palette);
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {number} radius
 * @param {boolean} isSquare
 * @param {string} fill
 */
function drawHandle(context, x, y, radius, isSquare, fill) {
  context.beginPath();
  if (isSquare) context.rect(x - radius, y - radius, 2 * radius, 2 * radius);
  else context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
  context.stroke();
}
