/** The workspace: the world, the arm, its manipulability ellipse, and what the mode adds. */
import { drawCross, drawHandle, drawWorld } from "../draw/workspace.js";
import { drawGhost, drawGoal, drawHit, drawRobot, drawStart } from "../draw/shapes.js";
import { drawTouching } from "../draw/touching.js";
import { drawIkTarget, drawRun } from "./ik-drawing.js";

/** @import { Brush } from "../draw/figure.js" */
/** @import { View } from "../draw/view.js" */
/** @import { IkPanel } from "./ik-panel.js" */
/** @import { ArmSession } from "./session.js" */
/** @import { Point } from "./types.js" */

/** Scale of the ellipse: at full size it would hide the arm. */
const ELLIPSE = 0.3;

export class Workspace {
  /** @param {ArmSession} session @param {IkPanel} ik */
  constructor(session, ik) {
    this.session = session;
    this.ik = ik;
    /** @type {View | null} */
    this.view = null;
  }

  /** @param {Brush} brush */
  ground(brush) {
    const { arm } = this.session;
    this.view = drawWorld(brush, arm.scenario, arm.document);
  }

  /** @param {Brush} brush */
  top(brush) {
    const { context, palette, hatch } = brush;
    const { session: { arm, mode, tipGoal }, ik, view } = this;
    if (!view) return;
    if (mode === "between") this.drawMotion(brush, view);
    if (mode === "solve") drawRun(brush, view, ik);
    this.drawEllipse(brush, view);
    const shown = { scenario: arm.scenario, world: arm.document.world, parts: arm.parts, touching: arm.check.touching };
    drawTouching({ context, view, palette, onPart: hatch(palette.stage), onObstacle: hatch(palette.collision) }, shown, () => drawRobot(context, view, arm.parts, palette));
    context.save();
    if (tipGoal && !tipGoal.reached) {
      const [from, to] = [tipGoal.point, tipGoal.wanted].map(([x, y]) => /** @type {Point} */ ([view.x(x), view.y(y)]));
      context.strokeStyle = palette.quiet;
      context.lineWidth = 1.4;
      context.setLineDash([4, 4]);
      context.beginPath();
      context.moveTo(...from);
      context.lineTo(...to);
      context.stroke();
      context.setLineDash([]);
      drawCross(context, ...to, palette.quiet, palette, 7);
    }
    this.drawTip(brush, view);
    context.restore();
    if (mode === "solve") drawIkTarget(brush, view, ik);
  }

  /** @param {Brush} brush @param {View} view */
  drawEllipse({ context, palette }, view) {
    const { ellipse: { major, minor, angle }, tip: [x, y] } = this.session.arm;
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

  /** The tip as a handle, with an arrow if its orientation is fixed. @param {Brush} brush @param {View} view */
  drawTip({ context, palette }, view) {
    const { arm, orientation } = this.session;
    const [x, y] = [view.x(arm.tip[0]), view.y(arm.tip[1])];
    if (orientation !== null) {
      const [dx, dy] = [Math.cos(orientation), -Math.sin(orientation)];
      const at = (/** @type {number} */ along, /** @type {number} */ aside) => /** @type {Point} */ ([x + along * dx - aside * dy, y + along * dy + aside * dx]);
      context.lineCap = "round";
      for (const [width, colour] of /** @type {[number, string][]} */ ([[5, palette.stage], [2, palette.path]])) {
        context.lineWidth = width;
        context.strokeStyle = colour;
        context.beginPath();
        context.moveTo(...at(12, 0));
        context.lineTo(...at(38, 0));
        context.moveTo(...at(30, 5));
        context.lineTo(...at(38, 0));
        context.lineTo(...at(30, -5));
        context.stroke();
      }
    }
    drawHandle(context, x, y, arm.check.free ? palette.robot : palette.collision, palette);
  }

  /** A and B, the curve of the tip between them, and where it collides. @param {Brush} brush @param {View} view */
  drawMotion({ context, palette }, view) {
    const { arm, a, b, motion, progress } = this.session;
    drawGhost(context, view, arm.scenario.footprint(b), { colour: palette.goal, fill: 0.14, stroke: 0.95, dash: [5, 4], width: 1.5 });
    drawGhost(context, view, arm.scenario.footprint(a), { colour: palette.start, fill: 0.14, stroke: 0.95, dash: [], width: 1.5 });
    const { curve, collides } = motion;
    const done = Math.floor(progress * (collides.length - 1) + 1e-9);
    context.save();
    context.lineCap = "round";
    // What is done is bold; what collides is red and dashed.
    for (const isDone of [false, true]) {
      for (const isCollision of [false, true]) {
        context.strokeStyle = isCollision ? palette.collision : palette.path;
        context.lineWidth = isDone ? 3.4 : 1.4;
        context.setLineDash(isCollision ? [2, 5] : []);
        context.beginPath();
        context.moveTo(view.x(curve[0]), view.y(curve[1]));
        collides.slice(1).forEach((end, i) => {
          const isPart = (i < done) === isDone && (collides[i] || end) === isCollision;
          context[isPart ? "lineTo" : "moveTo"](view.x(curve[2 * i + 2]), view.y(curve[2 * i + 3]));
        });
        context.stroke();
      }
    }
    context.restore();
    const tipAt = (/** @type {Float64Array} */ q) => {
      const [x, y] = arm.scenario.endEffector(arm.fitted(q));
      return /** @type {Point} */ ([view.x(x), view.y(y)]);
    };
    drawStart(context, ...tipAt(a), palette);
    drawGoal(context, ...tipAt(b), palette);
    if (motion.hit !== null) drawHit(context, ...tipAt(motion.at(motion.hit)), palette);
  }
}
