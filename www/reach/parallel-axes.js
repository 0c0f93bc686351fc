/**
 * A configuration in parallel coordinates (Inselberg 1985): an upright axis for each coordinate, and a line through
 * their values. An axis is red at the values of its coordinate that would be in collision, the others unchanged.
 */
import { View } from "planarium/draw";
import { ticks } from "../draw/angles.js";
import { NO_VIEW } from "../draw/figure.js";
import { drawDot, drawLine, setStroke } from "../draw/marks.js";
import { fillWith } from "../draw/shapes.js";
import { folded } from "../draw/trace.js";
import { num } from "../widgets/format.js";

/** @import { Brush } from "../draw/figure.js" */
/** @import { IkRun } from "./ik-run.js" */
/** @import { ReachSession } from "./session.js" */

/** The room that names and limits need, CSS pixels. @param {number} scale  of the words */
const marginOf = (scale) => ({ left: 34 * scale, right: 24 * scale, top: 26 * scale, bottom: 44 * scale });
/** Configurations tested along each axis. */
const TESTS = 72;
/** Half the width of a stretch in collision, CSS pixels. */
const HALF = 4;

export class ParallelAxes {
  /** @param {ReachSession} session */
  constructor(session) {
    this.session = session;
    /** Across the number of the joint, up the part of its range. */
    this.view = NO_VIEW;
  }

  /** @param {number} joint @param {number} value */
  y(joint, value) {
    const { low, high, isCircle } = this.session.robot.coordinates[joint];
    return this.view.y(((isCircle ? folded(value) : value) - low) / (high - low));
  }

  /** The value of a joint at a height. @param {number} joint @param {number} y */
  valueAt(joint, y) {
    const { low, high } = this.session.robot.coordinates[joint];
    return Math.min(high, Math.max(low, low + this.view.toPlane(0, y)[1] * (high - low)));
  }

  /** The joint whose axis is near, or -1. @param {number} x @param {number} near  CSS pixels */
  jointAt(x, near) {
    const { view, session } = this;
    return session.robot.coordinates.findIndex((_, i) => Math.abs(view.x(i) - x) <= Math.min(near, view.scaleX / 2));
  }

  get layers() {
    return {
      ground: { key: this.session.robot, draw: (/** @type {Brush} */ brush) => this.drawGround(brush) },
      top: { draw: (/** @type {Brush} */ brush) => this.drawTop(brush) },
    };
  }

  /** @param {Brush} brush */
  drawGround({ context, palette, width, height, bold }) {
    const { coordinates } = this.session.robot;
    this.view = new View({ min: [0, 0], max: [coordinates.length - 1, 1] }, width, height, marginOf(bold), true);
    const isNarrow = width / coordinates.length < 64 * bold;
    context.font = `${12 * bold}px system-ui, sans-serif`;
    context.fillStyle = palette.quiet;
    setStroke(context, palette.obstacleEdge, 1.4);
    const first = coordinates.findIndex(({ isCircle }) => isCircle);
    coordinates.forEach((joint, i) => {
      const x = this.view.x(i);
      const [top, bottom] = [this.y(i, joint.high), this.y(i, joint.low)];
      drawLine(context, x, top, x, bottom);
      // A limit is a bar; an axis that wraps ends in arrowheads.
      for (const [y, away] of [
        [top, 5],
        [bottom, -5],
      ]) {
        if (!joint.isCircle) drawLine(context, x - 7, y, x + 7, y);
        else for (const side of [-5, 5]) drawLine(context, x + side, y + away, x, y);
      }
      context.textAlign = "center";
      context.textBaseline = "alphabetic";
      context.fillText(isNarrow ? String(i + 1) : joint.name, x, height - 10);
      if (!joint.isCircle) {
        context.fillText(num(joint.high, 1), x, top - 5);
        context.textBaseline = "top";
        context.fillText(num(joint.low, 1), x, bottom + 2);
      } else if (i === first) {
        context.textAlign = "right";
        context.textBaseline = "middle";
        for (const { value, text } of ticks(joint)) context.fillText(text, x - 9, this.y(i, value));
      }
    });
  }

  /** @param {Brush} brush */
  drawTop(brush) {
    const { context, palette } = brush;
    const { robot, mode, a, b, motion, run } = this.session;
    const colour = robot.check.free ? palette.robot : palette.collision;
    this.drawCollisions(brush);
    if (mode === "between") {
      if (motion.missed.length > 0) this.drawPose(context, motion.at(1), palette.rejected, 2, [2, 4]);
      this.drawPose(context, b, palette.goal, 2, [6, 4]);
      this.drawPose(context, a, palette.start, 2);
    }
    if (run) this.drawRun(brush, run);
    this.drawPose(context, robot.q, palette.stage, 5);
    this.drawPose(context, robot.q, colour, 2.6);
    robot.q.forEach((value, i) => drawDot(context, this.view.x(i), this.y(i, value), colour, palette));
  }

  /** @param {Brush} brush */
  drawCollisions({ context, palette, hatch }) {
    const { robot } = this.session;
    const pattern = hatch(palette.collision);
    robot.coordinates.forEach(({ low, high }, joint) => {
      const valueAt = (/** @type {number} */ test) => low + ((high - low) * test) / TESTS;
      let from = -1;
      for (let i = 0; i <= TESTS; i++) {
        const collides = i < TESTS && !robot.isFree(robot.q.with(joint, valueAt(i + 0.5)));
        if (collides && from < 0) from = i;
        if (collides || from < 0) continue;
        const [bottom, top] = [this.y(joint, valueAt(from)), this.y(joint, valueAt(i))];
        context.beginPath();
        context.rect(this.view.x(joint) - HALF, top, 2 * HALF, bottom - top);
        fillWith(context, palette.collision, 0.35);
        fillWith(context, pattern);
        from = -1;
      }
    });
  }

  /** Iterates and solutions of inverse kinematics. @param {Brush} brush @param {IkRun} run */
  drawRun({ context, palette }, run) {
    for (const { q, strength } of run.recent(40)) {
      context.globalAlpha = 0.1 + 0.4 * strength ** 2;
      this.drawPose(context, q, palette.growth, 1);
    }
    context.globalAlpha = 0.9;
    for (const { q, isFree } of run.shown)
      this.drawPose(context, q, isFree ? palette.path : palette.collision, 1.8, isFree ? [] : [2, 4]);
    context.globalAlpha = 1;
  }

  /**
   * A configuration as a line.
   * @param {CanvasRenderingContext2D} context
   * @param {ArrayLike<number>} q
   * @param {string} colour
   * @param {number} width
   * @param {number[]} [dash]
   */
  drawPose(context, q, colour, width, dash = []) {
    setStroke(context, colour, width, dash);
    context.lineJoin = "round";
    context.beginPath();
    for (let i = 0; i < q.length; i++) context.lineTo(this.view.x(i), this.y(i, q[i]));
    context.stroke();
  }
}
