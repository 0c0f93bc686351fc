/** The robot in its world: all configurations faint, the neighbours in fine ink by their rank, the target strong. */
import { drawBase, drawBounds, drawReach, drawScale } from "../draw/ground.js";
import { disc } from "../draw/marks.js";
import { drawGhost, drawLabel, drawObstacles, drawRobot } from "../draw/shapes.js";
import { View } from "../draw/view.js";
import { cloudOf } from "./cloud.js";

/** @import { Brush, Painting } from "../room/sheet.js" */
/** @import { Part } from "../domain/types.js" */
/** @import { Desk } from "./desk.js" */
/** @import { Point } from "./types.js" */

const MARGIN = { left: 14, right: 14, top: 14, bottom: 14 };
/** Ranks written beside the neighbours, where they are few. */
const RANKED = 12;
/** Neighbours drawn as robots; more are dots. */
const MOST = 60;

/** @implements {Painting} */
export class Workspace {
  /** @param {Desk} desk */
  constructor(desk) {
    this.desk = desk;
    /** @type {View | null} */
    this.view = null;
  }

  /** Where a hand takes hold of the target: the joints' far ends of an arm, else the middle, and of a body its front. @returns {Point[]} */
  get handles() {
    const { desk } = this;
    const parts = desk.scenario.footprint(desk.q);
    if (desk.isArm) return parts.map((part) => /** @type {Point} */ (part.type === "capsule" ? part.b : [0, 0]));
    const [x, y, theta] = desk.q;
    const reach = parts[0].type === "polygon" ? Math.max(...parts[0].vertices.map(([a, b]) => Math.hypot(a - x, b - y))) : 0;
    return desk.dimension === 3 ? [[x, y], [x + 1.5 * reach * Math.cos(theta), y + 1.5 * reach * Math.sin(theta)]] : [[x, y]];
  }

  /** @param {Brush} brush */
  ground({ context, palette, width, height, ratio }) {
    const { desk } = this;
    const { document, scenario } = desk;
    const view = new View(scenario.extent(), width, height, MARGIN, false);
    this.view = view;
    drawScale(context, view, palette);
    if (document.world.bounds) drawBounds(context, view, document.world.bounds, palette);
    if (document.robot.type === "arm") drawReach(context, view, document.robot, palette);
    drawObstacles(context, view, document.world.obstacles, palette);
    context.save();
    context.strokeStyle = palette.growth;
    context.lineWidth = 1;
    context.lineJoin = "round";
    context.globalAlpha = desk.poses.length > 100 ? 0.12 : 0.25;
    for (const parts of desk.poses) {
      context.beginPath();
      for (const part of parts) axis(context, view, part);
      context.stroke();
    }
    context.restore();
    const { tips } = desk.list;
    const places = new Float64Array(tips.length);
    for (let i = 0; i < tips.length; i += 2) {
      places[i] = view.x(tips[i]);
      places[i + 1] = view.y(tips[i + 1]);
    }
    if (places.length > 0) context.drawImage(cloudOf(places, { width, height, ratio, colour: palette.growth, size: 2.2 }), 0, 0, width, height);
    if (document.robot.type === "arm") drawBase(context, view, document.robot.base, palette);
  }

  /** @param {Brush} brush */
  top({ context, palette }) {
    const { desk, view } = this;
    if (!view || desk.dimension === 0) return;
    const { indices } = desk.found;
    const missed = new Set(desk.missed);
    const wrong = new Set([...indices].filter((i) => !desk.exact.indices.includes(i)));
    const isDot = desk.document.robot.type === "disc";
    const last = Math.max(1, indices.length - 1);
    // The nearest last, so that it lies on top.
    for (const i of missed) {
      if (missed.size > MOST || isDot) this.dot(context, i, palette.rejected, true);
      else drawGhost(context, view, desk.scenario.footprint(desk.row(i)), { colour: palette.rejected, fill: 0, stroke: 0.9, dash: [4, 4], width: 1.4 });
    }
    for (let rank = indices.length - 1; rank >= 0; rank--) {
      const i = indices[rank];
      const near = 1 - rank / last;
      const colour = wrong.has(i) ? palette.rejected : palette.start;
      if (rank >= MOST || isDot) this.dot(context, i, colour, false);
      else drawGhost(context, view, desk.scenario.footprint(desk.row(i)), { colour, fill: 0.05 + 0.08 * near, stroke: 0.55 + 0.4 * near, dash: [], width: 1 + 1.2 * near });
    }
    drawRobot(context, view, desk.scenario.footprint(desk.q), palette);
    if (indices.length <= RANKED) {
      for (let rank = indices.length - 1; rank >= 0; rank--) {
        const [x, y] = this.tip(indices[rank]);
        drawLabel(context, String(rank + 1), x, y - 11, wrong.has(indices[rank]) ? palette.rejected : palette.start, palette);
      }
    }
    for (const [x, y] of this.handles) {
      context.fillStyle = palette.stage;
      disc(context, view.x(x), view.y(y), 6.5);
      context.strokeStyle = palette.robot;
      context.lineWidth = 2.2;
      context.beginPath();
      context.arc(view.x(x), view.y(y), 5.6, 0, 2 * Math.PI);
      context.stroke();
    }
  }

  /** The tip of a configuration of the list, CSS pixels. @param {number} i @returns {Point} */
  tip(i) {
    const view = /** @type {View} */ (this.view);
    const { tips } = this.desk.list;
    return [view.x(tips[2 * i]), view.y(tips[2 * i + 1])];
  }

  /** @param {CanvasRenderingContext2D} context @param {number} i @param {string} colour @param {boolean} isHollow */
  dot(context, i, colour, isHollow) {
    const [x, y] = this.tip(i);
    context.fillStyle = context.strokeStyle = colour;
    context.lineWidth = 1.6;
    if (!isHollow) disc(context, x, y, 3.6);
    else {
      context.beginPath();
      context.arc(x, y, 4.4, 0, 2 * Math.PI);
      context.stroke();
    }
  }
}

/** A part as a thin line. @param {CanvasRenderingContext2D} context @param {View} view @param {Part} part */
function axis(context, view, part) {
  if (part.type === "disc") return;
  const points = part.type === "capsule" ? [part.a, part.b] : [...part.vertices, part.vertices[0]];
  points.forEach(([x, y], i) => (i === 0 ? context.moveTo(view.x(x), view.y(y)) : context.lineTo(view.x(x), view.y(y))));
}
