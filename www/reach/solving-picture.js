/** What a run of inverse kinematics leaves on the stage: iterates, the fainter the older, solutions as ghosts, the target. */
import { disc } from "../draw/marks.js";
import { drawGhost, drawLabel, isThin } from "../draw/shapes.js";
import { drawCross } from "./workspace.js";

/** @import { Brush } from "../room/sheet.js" */
/** @import { View } from "../draw/view.js" */
/** @import { Axes } from "./axes.js" */
/** @import { Solving } from "./solving.js" */
/** @import { Square } from "./square.js" */

/** Faint arms at most, and solutions shown. */
const FAINT = 40;
export const MOST = 24;

export class SolvingPicture {
  /** @param {Solving} solving */
  constructor(solving) { this.solving = solving; }

  /** Beneath the arm: iterates, fainter the older, and the solutions. @param {Brush} brush @param {View} view */
  under({ context, palette }, view) {
    const { solving: { search, bench, nearest, chosen } } = this;
    const { arm } = bench;
    if (!search) return;
    if (nearest) {
      const parts = arm.scenario.footprint(Float64Array.from(nearest.configuration));
      drawGhost(context, view, parts, { colour: palette.quiet, fill: 0.08, stroke: 0.8, dash: [3, 4], width: 1.2 });
    }
    const recent = search.recent(FAINT);
    context.save();
    context.strokeStyle = context.fillStyle = palette.growth;
    context.lineWidth = 1.2;
    context.lineJoin = "round";
    recent.forEach(({ q }, i) => {
      context.globalAlpha = 0.12 + 0.5 * ((i + 1) / recent.length) ** 2;
      const parts = arm.scenario.footprint(q);
      context.beginPath();
      context.moveTo(view.x(arm.base[0]), view.y(arm.base[1]));
      for (const part of parts) if (part.type === "capsule") context.lineTo(view.x(part.b[0]), view.y(part.b[1]));
      context.stroke();
      const end = parts[parts.length - 1];
      if (end?.type === "capsule") disc(context, view.x(end.b[0]), view.y(end.b[1]), 2);
    });
    context.restore();
    search.solutions.slice(0, MOST).forEach(({ q, isFree }, i) => {
      if (i === chosen) return;
      const parts = arm.scenario.footprint(q);
      const thin = isThin(view, parts[0]);
      drawGhost(context, view, parts, isFree
        ? { colour: palette.path, fill: 0.16, stroke: 0.85, dash: [], width: thin ? 2 : 1.5 }
        : { colour: palette.collision, fill: 0.05, stroke: 0.6, dash: [2, 4], width: thin ? 2 : 1.5 });
    });
  }

  /** Above it: the target, and how many reach it. @param {Brush} brush @param {View} view */
  over({ context, palette }, view) {
    const { nearest, bench: { target, lock } } = this.solving;
    const [x, y] = [view.x(target[0]), view.y(target[1])];
    drawCross(context, x, y, palette.goal, palette.stage, 13);
    if (lock !== null) {
      context.save();
      context.strokeStyle = palette.goal;
      context.lineWidth = 2;
      context.setLineDash([4, 3]);
      context.beginPath();
      context.moveTo(x - 46 * Math.cos(lock), y + 46 * Math.sin(lock));
      context.lineTo(x, y);
      context.stroke();
      context.restore();
    }
    if (nearest) drawLabel(context, "nearest", view.x(nearest.point[0]), view.y(nearest.point[1]) - 18, palette.quiet, palette);
  }

  /** On the configuration square: iterates as dots, solutions as rings. @param {Brush} brush @param {Square} square */
  onSquare({ context, palette }, square) {
    const { search } = this.solving;
    if (!search) return;
    context.fillStyle = palette.growth;
    const recent = search.recent(4 * FAINT);
    recent.forEach(({ q }, i) => {
      context.globalAlpha = 0.2 + 0.7 * ((i + 1) / recent.length);
      const [x, y] = square.place(q);
      disc(context, x, y, 2.2);
    });
    context.globalAlpha = 1;
    search.solutions.slice(0, MOST).forEach(({ q, isFree }) => square.eachPlace(q, (x, y) => {
      context.lineWidth = 2.4;
      context.strokeStyle = isFree ? palette.path : palette.collision;
      context.setLineDash(isFree ? [] : [2, 3]);
      context.beginPath();
      context.arc(x, y, 8.5, 0, 2 * Math.PI);
      context.stroke();
      context.setLineDash([]);
    }));
  }

  /** On the axes: a line for each. @param {Brush} brush @param {Axes} axes */
  onAxes({ context, palette }, axes) {
    const { search } = this.solving;
    if (!search) return;
    const recent = search.recent(FAINT);
    recent.forEach(({ q }, i) => {
      context.globalAlpha = 0.1 + 0.4 * ((i + 1) / recent.length) ** 2;
      axes.line(context, q, palette.growth, 1, []);
    });
    search.solutions.slice(0, MOST).forEach(({ q, isFree }) => {
      context.globalAlpha = 0.9;
      axes.line(context, q, isFree ? palette.path : palette.collision, 1.8, isFree ? [] : [2, 4]);
    });
    context.globalAlpha = 1;
  }
}
