/**
 * The workspace: the world, the arm with its manipulability ellipse or the body, the motion from A to B, and a run of
 * inverse kinematics.
 */
import { drawRobot, isThin } from "planarium/draw";
import { slidesOf } from "../domain/coordinates.js";
import { NO_VIEW } from "../draw/figure.js";
import { drawWorkspace } from "../draw/ground.js";
import { addLine, disc, drawCross, drawHandle, drawLine, setStroke, strokeWithHalo } from "../draw/marks.js";
import { placedHandles } from "../draw/placed-handles.js";
import { drawEndsHere, drawGhost, drawGoal, drawHit, drawLabel, drawStart, fillWith } from "../draw/shapes.js";
import { drawTouching } from "../draw/touching.js";

/** @import { Point } from "../domain/types.js" */
/** @import { Brush } from "../draw/figure.js" */
/** @import { IkRun } from "./ik-run.js" */
/** @import { ReachSession } from "./session.js" */

/** Scale of the ellipse: at full size it would hide the arm. */
const ELLIPSE = 0.3;
/** Stretches of a body's motion, between which its outline is drawn. */
const GHOSTS = 8;
/** Iterates drawn, at most. */
const FAINT = 40;

export class Workspace {
  /** @param {ReachSession} session */
  constructor(session) {
    this.session = session;
    this.view = NO_VIEW;
  }

  get layers() {
    return {
      ground: { key: this.session.robot, draw: (/** @type {Brush} */ brush) => this.drawGround(brush) },
      top: { draw: (/** @type {Brush} */ brush) => this.drawTop(brush) },
    };
  }

  /** @param {Brush} brush */
  drawGround(brush) {
    const { robot } = this.session;
    this.view = drawWorkspace(brush, robot.scenario, robot.document);
  }

  /** @param {Brush} brush */
  drawTop(brush) {
    const { context, palette, hatch } = brush;
    const { view } = this;
    const { robot, mode, tipGoal, run } = this.session;
    if (mode === "between") this.drawMotion(brush);
    if (run) this.drawRun(brush, run);
    if (robot.slides) this.drawSlides(brush);
    if (robot.isArm) this.drawEllipse(brush);
    const shown = {
      scenario: robot.scenario,
      world: robot.document.world,
      parts: robot.parts,
      touching: robot.check.touching,
    };
    drawTouching(
      { context, view, palette, bold: brush.bold, onPart: hatch(palette.stage), onObstacle: hatch(palette.collision) },
      shown,
      () => drawRobot(context, view, robot.parts, palette),
    );
    context.save();
    if (tipGoal && !tipGoal.reached) {
      const wanted = this.view.place(tipGoal.wanted);
      setStroke(context, palette.quiet, 1.4, [4, 4]);
      drawLine(context, ...this.view.place(tipGoal.point), ...wanted);
      drawCross(context, ...wanted, palette.quiet, palette, 7);
    }
    this.drawTip(brush);
    context.restore();
    if (mode === "solve") this.drawTarget(brush);
  }

  /** @param {Brush} brush */
  drawEllipse({ context, palette }) {
    const { major, minor, angle } = this.session.robot.ellipse;
    const [x, y] = this.session.robot.tip;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    context.save();
    setStroke(context, palette.newest, 1.6, [5, 3]);
    context.beginPath();
    for (let i = 0; i < 64; i++) {
      const [u, v] = [ELLIPSE * major * Math.cos((i * Math.PI) / 32), ELLIPSE * minor * Math.sin((i * Math.PI) / 32)];
      context.lineTo(...this.view.place([x + c * u - s * v, y + s * u + c * v]));
    }
    context.closePath();
    fillWith(context, palette.newest, 0.14);
    context.globalAlpha = 0.9;
    context.stroke();
    context.restore();
  }

  /**
   * How far each link that slides can do so: a line from where it ends at the least to where it ends at the most.
   * @param {Brush} brush
   */
  drawSlides({ context, palette }) {
    const { joints, parts, q, arm } = this.session.robot;
    const directions = slidesOf(arm, q);
    setStroke(context, palette.quiet, 1.4, [1, 4]);
    for (const [i, joint] of joints.entries()) {
      const [part, angle] = [parts[i], directions[i]];
      if (joint.type !== "prismatic" || part.type !== "capsule" || angle === null) continue;
      const end = (/** @type {number} */ at) =>
        this.view.place([
          part.a[0] + (arm.links[i] + at) * Math.cos(angle),
          part.a[1] + (arm.links[i] + at) * Math.sin(angle),
        ]);
      const [low, high] = joint.range.map(end);
      drawLine(context, ...low, ...high);
      for (const [x, y] of [low, high])
        drawLine(
          context,
          x - 6 * Math.sin(angle),
          y - 6 * Math.cos(angle),
          x + 6 * Math.sin(angle),
          y + 6 * Math.cos(angle),
        );
    }
    context.setLineDash([]);
  }

  /**
   * The tip as a handle, with an arrow if its orientation is fixed; of a body the reference point, and a handle to turn
   * it.
   * @param {Brush} brush
   */
  drawTip({ context, palette }) {
    const { robot, orientation } = this.session;
    const [x, y] = this.view.place(robot.tip);
    if (orientation !== null) {
      const [dx, dy] = [Math.cos(orientation), -Math.sin(orientation)];
      const at = (/** @type {number} */ along, /** @type {number} */ aside) =>
        /** @type {Point} */ ([x + along * dx - aside * dy, y + along * dy + aside * dx]);
      strokeWithHalo(context, [5, 2], palette.path, palette, () => {
        addLine(context, ...at(12, 0), ...at(38, 0));
        addLine(context, ...at(30, 5), ...at(38, 0));
        context.lineTo(...at(30, -5));
      });
    }
    const colour = robot.check.free ? palette.robot : palette.collision;
    if (!robot.isArm) {
      const [, front] = placedHandles(this.view, robot.parts, robot.q);
      setStroke(context, colour, 1.4, [2, 3]);
      drawLine(context, x, y, ...front);
      context.setLineDash([]);
      drawHandle(context, ...front, colour, palette);
    }
    drawHandle(context, x, y, colour, palette);
  }

  /** A and B, the curve of the tip between them, and where it collides. @param {Brush} brush */
  drawMotion(brush) {
    const { context, palette } = brush;
    const { view } = this;
    const { robot, a, b, motion, progress } = this.session;
    const { curve, collides, hit, missed } = motion;
    const isMiss = missed.length > 0;
    const done = Math.floor(progress * (collides.length - 1) + 1e-9);
    if (!robot.isArm)
      for (let i = 1; i < GHOSTS; i++)
        this.drawAlong(brush, i / GHOSTS, { colour: palette.path, fill: 0, stroke: 0.35, dash: [], width: 1 });
    if (isMiss)
      this.drawAlong(brush, 1, { colour: palette.rejected, fill: 0.1, stroke: 0.95, dash: [3, 4], width: 1.6 });
    drawGhost(context, view, robot.scenario.footprint(b), {
      colour: palette.goal,
      fill: 0.14,
      stroke: 0.95,
      dash: [5, 4],
      width: 1.5,
    });
    drawGhost(context, view, robot.scenario.footprint(a), {
      colour: palette.start,
      fill: 0.14,
      stroke: 0.95,
      dash: [],
      width: 1.5,
    });
    context.save();
    context.lineCap = "round";
    // What is done is bold; what collides is red and dashed.
    for (const isDone of [false, true]) {
      for (const isCollision of [false, true]) {
        setStroke(
          context,
          isCollision ? palette.collision : isMiss ? palette.rejected : palette.path,
          isDone ? 3.4 : 1.4,
          isCollision ? [2, 5] : [],
        );
        context.beginPath();
        collides.forEach((end, i) => {
          const isPart = i > 0 && i <= done === isDone && (collides[i - 1] || end) === isCollision;
          context[isPart ? "lineTo" : "moveTo"](view.x(curve[2 * i]), view.y(curve[2 * i + 1]));
        });
        context.stroke();
      }
    }
    context.restore();
    const tipAt = (/** @type {Float64Array} */ q) => this.view.place(robot.scenario.endEffector(robot.fitted(q)));
    drawStart(context, ...tipAt(a), palette);
    drawGoal(context, ...tipAt(b), palette);
    if (isMiss) drawEndsHere(context, ...tipAt(motion.at(1)), palette, brush.bold);
    if (hit !== null) drawHit(context, ...tipAt(motion.at(hit)), palette);
  }

  /**
   * The robot at a part of the motion.
   * @param {Brush} brush
   * @param {number} t
   * @param {Parameters<typeof drawGhost>[3]} style
   */
  drawAlong({ context }, t, style) {
    const { robot, motion } = this.session;
    drawGhost(context, this.view, robot.scenario.footprint(robot.fitted(motion.at(t))), style);
  }

  /**
   * Inverse kinematics: iterates that fade with age, and solutions as outlines.
   * @param {Brush} brush
   * @param {IkRun} run
   */
  drawRun({ context, palette }, run) {
    const { view } = this;
    const { chosen } = this.session;
    const { nearest } = run;
    const { scenario, base } = run.robot;
    if (nearest)
      drawGhost(context, view, scenario.footprint(nearest.configuration), {
        colour: palette.quiet,
        fill: 0.08,
        stroke: 0.8,
        dash: [3, 4],
        width: 1.2,
      });
    context.save();
    context.fillStyle = palette.growth;
    setStroke(context, palette.growth, 1.2);
    context.lineJoin = "round";
    for (const { q, strength } of run.recent(FAINT)) {
      context.globalAlpha = 0.12 + 0.5 * strength ** 2;
      const joints = [base, ...scenario.footprint(q).flatMap((part) => (part.type === "capsule" ? [part.b] : []))].map(
        (point) => this.view.place(point),
      );
      context.beginPath();
      for (const joint of joints) context.lineTo(...joint);
      context.stroke();
      disc(context, ...joints[joints.length - 1], 2);
    }
    context.restore();
    run.shown.forEach(({ q, isFree }, i) => {
      if (i === chosen) return;
      const parts = scenario.footprint(q);
      const style = isFree
        ? { colour: palette.path, fill: 0.16, stroke: 0.85, dash: [] }
        : { colour: palette.collision, fill: 0.05, stroke: 0.6, dash: [2, 4] };
      drawGhost(context, view, parts, { ...style, width: isThin(view, parts[0]) ? 2 : 1.5 });
    });
  }

  /** The target of inverse kinematics, and the nearest point if it is out of reach. @param {Brush} brush */
  drawTarget({ context, palette, bold }) {
    const { target, orientation, run } = this.session;
    const [x, y] = this.view.place(target);
    context.save();
    drawCross(context, x, y, palette.goal, palette, 13);
    if (orientation !== null) {
      context.setLineDash([4, 3]);
      drawLine(context, x - 46 * Math.cos(orientation), y + 46 * Math.sin(orientation), x, y);
    }
    context.restore();
    if (!run?.nearest) return;
    const [nearX, nearY] = this.view.place(run.nearest.point);
    drawLabel(context, "nearest", nearX, nearY - 5 - 13 * bold, palette.quiet, palette, bold);
  }
}
