/** A run of inverse kinematics in the workspace: iterates that fade with age, solutions as outlines, the target. */
import { disc } from "../draw/marks.js";
import { drawGhost, drawLabel, isThin } from "../draw/shapes.js";
import { drawCross } from "../draw/workspace.js";

/** @import { Brush } from "../draw/figure.js" */
/** @import { View } from "../draw/view.js" */
/** @import { IkPanel } from "./ik-panel.js" */

/** Iterates drawn, at most. */
const FAINT = 40;

/** Draws what lies below the arm. @param {Brush} brush @param {View} view @param {IkPanel} ik */
export function drawRun({ context, palette }, view, { run, nearest, chosen }) {
  if (!run) return;
  const { arm } = run;
  if (nearest) {
    const parts = arm.scenario.footprint(Float64Array.from(nearest.configuration));
    drawGhost(context, view, parts, { colour: palette.quiet, fill: 0.08, stroke: 0.8, dash: [3, 4], width: 1.2 });
  }
  context.save();
  context.strokeStyle = context.fillStyle = palette.growth;
  context.lineWidth = 1.2;
  context.lineJoin = "round";
  for (const { q, strength } of run.recent(FAINT)) {
    context.globalAlpha = 0.12 + 0.5 * strength ** 2;
    context.beginPath();
    let [x, y] = [view.x(arm.base[0]), view.y(arm.base[1])];
    context.moveTo(x, y);
    for (const part of arm.scenario.footprint(q)) {
      if (part.type === "capsule") [x, y] = [view.x(part.b[0]), view.y(part.b[1])];
      context.lineTo(x, y);
    }
    context.stroke();
    disc(context, x, y, 2);
  }
  context.restore();
  run.shown.forEach(({ q, isFree }, i) => {
    if (i === chosen) return;
    const parts = arm.scenario.footprint(q);
    const style = isFree ? { colour: palette.path, fill: 0.16, stroke: 0.85, dash: [] } : { colour: palette.collision, fill: 0.05, stroke: 0.6, dash: [2, 4] };
    drawGhost(context, view, parts, { ...style, width: isThin(view, parts[0]) ? 2 : 1.5 });
  });
}

/** Draws what lies above the arm. @param {Brush} brush @param {View} view @param {IkPanel} ik */
export function drawIkTarget({ context, palette }, view, { nearest, session: { target, orientation } }) {
  const [x, y] = [view.x(target[0]), view.y(target[1])];
  context.save();
  drawCross(context, x, y, palette.goal, palette, 13);
  if (orientation !== null) {
    context.setLineDash([4, 3]);
    context.beginPath();
    context.moveTo(x - 46 * Math.cos(orientation), y + 46 * Math.sin(orientation));
    context.lineTo(x, y);
    context.stroke();
  }
  context.restore();
  if (nearest) drawLabel(context, "nearest", view.x(nearest.point[0]), view.y(nearest.point[1]) - 18, palette.quiet, palette);
}
