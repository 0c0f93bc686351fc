/** The workspace: the world, the arm in it, how its tip can move, and whatever the stage is for just now. */
import { drawBase, drawBounds, drawReach, drawScale } from "../draw/ground.js";
import { disc } from "../draw/marks.js";
import { drawGhost, drawGoal, drawHit, drawObstacles, drawRobot, drawStart } from "../draw/shapes.js";
import { drawTouching } from "../draw/touching.js";
import { View } from "../draw/view.js";

/** @import { Brush, Painting } from "../room/sheet.js" */
/** @import { Bench } from "./bench.js" */
/** @typedef {CanvasRenderingContext2D} Context */

const MARGIN = { left: 14, right: 14, top: 14, bottom: 14 };
/** A radian a second of the joints is drawn as this part of the way that the tip goes in it: as large as it is, it would hide the arm. */
const ELLIPSE = 0.3;

/** @implements {Painting} */
export class Workspace {
  /** @param {Bench} bench */
  constructor(bench) {
    this.bench = bench;
    /** @type {View | null} */
    this.view = null;
    /** Draws beneath and above the arm what belongs to a mode of its own. @type {{ under: (brush: Brush, view: View) => void, over: (brush: Brush, view: View) => void } | null} */
    this.overlay = null;
  }

  /** @param {Brush} brush */
  ground({ context, palette, width, height }) {
    const { arm } = this.bench;
    const view = new View(arm.scenario.extent(), width, height, MARGIN, false);
    this.view = view;
    const { world } = arm.document;
    drawScale(context, view, palette);
    if (world.bounds) drawBounds(context, view, world.bounds, palette);
    else drawReach(context, view, arm.robot, palette);
    drawObstacles(context, view, world.obstacles, palette);
    drawBase(context, view, arm.base, palette);
  }

  /** @param {Brush} brush */
  top(brush) {
    const { context, palette, hatch } = brush;
    const { bench, view } = this;
    if (!view) return;
    const { arm, mode } = bench;
    if (mode === "between") this.drawWay(brush, view);
    if (mode === "solve") this.overlay?.under(brush, view);
    this.drawEllipse(brush, view);
    const shown = { scenario: arm.scenario, world: arm.document.world, parts: arm.parts, touching: arm.check.touching };
    drawTouching({ context, view, palette, onPart: hatch(palette.stage), onObstacle: hatch(palette.collision) }, shown, () => drawRobot(context, view, arm.parts, palette));
    this.drawPull(brush, view);
    this.drawTip(brush, view);
    if (mode === "solve") this.overlay?.over(brush, view);
  }

  /** How the tip can move: long where it is quick, flat where it is nearly stuck. @param {Brush} brush @param {View} view */
  drawEllipse({ context, palette }, view) {
    const { arm } = this.bench;
    const { major, minor, angle } = arm.ellipse;
    const [x, y] = arm.tip;
    context.save();
    context.strokeStyle = context.fillStyle = palette.newest;
    context.lineWidth = 1.6;
    context.beginPath();
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    for (let i = 0; i < 64; i++) {
      const [u, v] = [ELLIPSE * major * Math.cos((i * Math.PI) / 32), ELLIPSE * minor * Math.sin((i * Math.PI) / 32)];
      context.lineTo(view.x(x + c * u - s * v), view.y(y + s * u + c * v));
    }
    context.closePath();
    context.globalAlpha = 0.14;
    context.fill();
    context.globalAlpha = 0.9;
    context.setLineDash([5, 3]);
    context.stroke();
    context.restore();
  }

  /** The tip as a handle, and the direction that it keeps. @param {Brush} brush @param {View} view */
  drawTip({ context, palette }, view) {
    const { arm, lock } = this.bench;
    const [x, y] = [view.x(arm.tip[0]), view.y(arm.tip[1])];
    context.save();
    context.lineCap = "round";
    if (lock !== null) {
      for (const [width, colour] of /** @type {[number, string][]} */ ([[5, palette.stage], [2, palette.path]])) {
        context.lineWidth = width;
        context.strokeStyle = colour;
        const [dx, dy] = [Math.cos(lock), -Math.sin(lock)];
        context.beginPath();
        context.moveTo(x + 12 * dx, y + 12 * dy);
        context.lineTo(x + 38 * dx, y + 38 * dy);
        context.moveTo(x + 30 * dx - 5 * dy, y + 30 * dy + 5 * dx);
        context.lineTo(x + 38 * dx, y + 38 * dy);
        context.lineTo(x + 30 * dx + 5 * dy, y + 30 * dy - 5 * dx);
        context.stroke();
      }
    }
    context.fillStyle = palette.stage;
    disc(context, x, y, 8);
    context.strokeStyle = arm.check.free ? palette.robot : palette.collision;
    context.lineWidth = 2.4;
    context.beginPath();
    context.arc(x, y, 7, 0, 2 * Math.PI);
    context.stroke();
    context.fillStyle = context.strokeStyle;
    disc(context, x, y, 2.6);
    context.restore();
  }

  /** Where the tip is wanted and cannot be. @param {Brush} brush @param {View} view */
  drawPull({ context, palette }, view) {
    const { pull } = this.bench;
    if (!pull || pull.reached) return;
    const [x0, y0] = [view.x(pull.point[0]), view.y(pull.point[1])];
    const [x1, y1] = [view.x(pull.wanted[0]), view.y(pull.wanted[1])];
    context.save();
    context.strokeStyle = palette.quiet;
    context.lineWidth = 1.4;
    context.setLineDash([4, 4]);
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    context.stroke();
    context.setLineDash([]);
    drawCross(context, x1, y1, palette.quiet, palette.stage, 7);
    context.restore();
  }

  /** A and B, the tip's curve between them, and where it touches. @param {Brush} brush @param {View} view */
  drawWay({ context, palette }, view) {
    const { arm, a, b, way, along } = this.bench;
    for (const [pose, colour, dash] of /** @type {[Float64Array, string, number[]][]} */ ([[b, palette.goal, [5, 4]], [a, palette.start, []]])) {
      drawGhost(context, view, arm.scenario.footprint(pose), { colour, fill: 0.14, stroke: 0.95, dash, width: 1.5 });
    }
    const { curve, touches } = way;
    const last = touches.length - 1;
    const passed = Math.floor(along * last + 1e-9);
    context.save();
    context.lineCap = "round";
    context.lineJoin = "round";
    // What lies ahead is thin, what has been gone strong; where it touches, red and broken.
    for (const [from, to, width] of [[passed, last, 1.4], [0, passed, 3.4]]) {
      for (const isTouching of [false, true]) {
        context.strokeStyle = isTouching ? palette.collision : palette.path;
        context.lineWidth = width;
        context.setLineDash(isTouching ? [2, 5] : []);
        context.beginPath();
        let pen = -1;
        for (let i = from; i < to; i++) {
          if ((touches[i] || touches[i + 1]) !== isTouching) {
            pen = -1;
            continue;
          }
          if (pen !== i) context.moveTo(view.x(curve[2 * i]), view.y(curve[2 * i + 1]));
          pen = i + 1;
          context.lineTo(view.x(curve[2 * i + 2]), view.y(curve[2 * i + 3]));
        }
        context.stroke();
      }
    }
    context.restore();
    const [ax, ay] = arm.scenario.endEffector(a);
    const [bx, by] = arm.scenario.endEffector(b);
    drawStart(context, view.x(ax), view.y(ay), palette);
    drawGoal(context, view.x(bx), view.y(by), palette);
    if (way.hit !== null) {
      const [x, y] = arm.scenario.endEffector(arm.fitted(way.at(way.hit)));
      drawHit(context, view.x(x), view.y(y), palette);
    }
  }
}

/** A ringed cross of a colour, with a halo. @param {Context} context @param {number} x @param {number} y @param {string} colour @param {string} halo @param {number} size */
export function drawCross(context, x, y, colour, halo, size) {
  context.save();
  context.lineCap = "round";
  for (const [width, stroke] of /** @type {[number, string][]} */ ([[5.5, halo], [2.2, colour]])) {
    context.lineWidth = width;
    context.strokeStyle = stroke;
    context.beginPath();
    context.moveTo(x - size, y);
    context.lineTo(x + size, y);
    context.moveTo(x, y - size);
    context.lineTo(x, y + size);
    context.stroke();
  }
  context.restore();
}
