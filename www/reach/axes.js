/**
 * The pose of an arm of any number of joints in parallel coordinates (Inselberg 1985): an upright axis for each joint, a line
 * through their values. Red stretches of an axis are where that joint, turned alone, would touch something.
 */
import { ticks } from "../draw/angles.js";
import { disc } from "../draw/marks.js";
import { folded } from "../draw/trace.js";

/** @import { Brush, Painting } from "../room/sheet.js" */
/** @import { Bench } from "./bench.js" */

const MARGIN = { left: 34, right: 24, top: 26, bottom: 44 };
/** Poses tested along each axis. */
const TESTS = 72;
/** Half the width of an axis' stretch that touches. */
const HALF = 4;

/** @implements {Painting} */
export class Axes {
  /** @param {Bench} bench */
  constructor(bench) {
    this.bench = bench;
    this.width = 0;
    this.height = 0;
    /** Draws what belongs to a mode of its own. @type {((brush: Brush, axes: Axes) => void) | null} */
    this.overlay = null;
  }

  /** Of the axis of a joint. @param {number} joint */
  x(joint) {
    const { dimension } = this.bench.arm;
    const inner = this.width - MARGIN.left - MARGIN.right;
    return dimension === 1 ? MARGIN.left + inner / 2 : MARGIN.left + (inner * joint) / (dimension - 1);
  }

  /** Of a joint's value. @param {number} joint @param {number} value */
  y(joint, value) {
    const { low, high, isCircle } = this.bench.arm.joints[joint];
    const at = isCircle ? folded(value) : value;
    return this.height - MARGIN.bottom - ((at - low) / (high - low)) * (this.height - MARGIN.top - MARGIN.bottom);
  }

  /** The value of a joint at a height. @param {number} joint @param {number} y */
  valueAt(joint, y) {
    const { low, high } = this.bench.arm.joints[joint];
    const part = (this.height - MARGIN.bottom - y) / (this.height - MARGIN.top - MARGIN.bottom);
    return Math.min(high, Math.max(low, low + part * (high - low)));
  }

  /** The joint whose axis is near, or -1. @param {number} x @param {number} reach  CSS pixels */
  jointAt(x, reach) {
    const { dimension } = this.bench.arm;
    const nearest = Array.from({ length: dimension }, (_, i) => i).reduce((best, i) => (Math.abs(this.x(i) - x) < Math.abs(this.x(best) - x) ? i : best), 0);
    return Math.abs(this.x(nearest) - x) <= reach ? nearest : -1;
  }

  /** @param {Brush} brush */
  ground({ context, palette, width, height }) {
    Object.assign(this, { width, height });
    const { joints } = this.bench.arm;
    const isTight = width / joints.length < 64;
    context.font = "12px system-ui, sans-serif";
    joints.forEach((joint, i) => {
      const x = this.x(i);
      const [top, bottom] = [this.y(i, joint.high), this.y(i, joint.low)];
      context.strokeStyle = palette["obstacle-edge"];
      context.fillStyle = palette.quiet;
      context.lineWidth = 1.4;
      context.setLineDash([]);
      context.beginPath();
      context.moveTo(x, top);
      context.lineTo(x, bottom);
      // A stop is a bar; where the axis comes round, it ends in a small hook.
      for (const [y, way] of [[top, 1], [bottom, -1]]) {
        if (!joint.isCircle) {
          context.moveTo(x - 7, y);
          context.lineTo(x + 7, y);
        } else {
          context.moveTo(x - 5, y + 5 * way);
          context.lineTo(x, y);
          context.lineTo(x + 5, y + 5 * way);
        }
      }
      context.stroke();
      context.textAlign = "center";
      context.textBaseline = "alphabetic";
      context.fillText(isTight ? String(i) : joint.name, x, this.height - 10);
      if (!joint.isCircle) {
        context.textBaseline = "alphabetic";
        context.fillText(joint.high.toFixed(1).replace("-", "\u2212"), x, top - 5);
        context.textBaseline = "top";
        context.fillText(joint.low.toFixed(1).replace("-", "\u2212"), x, bottom + 2);
      } else if (i === 0) {
        context.textAlign = "right";
        context.textBaseline = "middle";
        for (const { value, text } of ticks(joint)) context.fillText(text, x - 9, this.y(i, value === joint.low ? joint.low + 1e-9 : value));
      }
    });
  }

  /** @param {Brush} brush */
  top(brush) {
    const { context, palette } = brush;
    const { bench } = this;
    const { arm, mode } = bench;
    if (this.width === 0) return;
    this.drawTouching(brush);
    if (mode === "between") {
      this.line(context, bench.b, palette.goal, 2, [6, 4]);
      this.line(context, bench.a, palette.start, 2, []);
    }
    if (mode === "solve") this.overlay?.(brush, this);
    const colour = arm.check.free ? palette.robot : palette.collision;
    this.line(context, arm.q, palette.stage, 5, []);
    this.line(context, arm.q, colour, 2.6, []);
    context.fillStyle = colour;
    context.strokeStyle = palette.stage;
    context.lineWidth = 2;
    arm.q.forEach((value, i) => {
      disc(context, this.x(i), this.y(i, value), 6.5);
      context.stroke();
    });
  }

  /** Where a joint, turned alone, would touch something. @param {Brush} brush */
  drawTouching({ context, palette, hatch }) {
    const { arm } = this.bench;
    context.save();
    for (let joint = 0; joint < arm.dimension; joint++) {
      const { low, high } = arm.joints[joint];
      const pose = Float64Array.from(arm.q);
      let from = -1;
      for (let k = 0; k <= TESTS; k++) {
        pose[joint] = low + ((high - low) * (k + 0.5)) / TESTS;
        const touches = k < TESTS && !arm.isFree(pose);
        if (touches && from < 0) from = k;
        if (touches || from < 0) continue;
        const [a, b] = [from, k].map((cell) => this.y(joint, low + ((high - low) * cell) / TESTS * (1 - 1e-12)));
        context.beginPath();
        context.rect(this.x(joint) - HALF, b, 2 * HALF, a - b);
        context.globalAlpha = 0.35;
        context.fillStyle = palette.collision;
        context.fill();
        context.globalAlpha = 1;
        const pattern = hatch(palette.collision);
        if (pattern) {
          context.fillStyle = pattern;
          context.fill();
        }
        from = -1;
      }
    }
    context.restore();
  }

  /** A pose. @param {CanvasRenderingContext2D} context @param {ArrayLike<number>} q @param {string} colour @param {number} width @param {number[]} dash */
  line(context, q, colour, width, dash) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.lineJoin = "round";
    context.setLineDash(dash);
    context.beginPath();
    for (let i = 0; i < q.length; i++) context.lineTo(this.x(i), this.y(i, q[i]));
    context.stroke();
    context.setLineDash([]);
  }
}
