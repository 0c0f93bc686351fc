/**
 * The configuration space of an arm of two joints as a square; where a joint is a circle, a strip of the picture goes on beyond the
 * border, faint, so that one sees it come round. Obstacles are the core's own picture.
 */
import { tick, ticks, titleOf } from "../draw/angles.js";
import { paint, soften } from "../draw/mask.js";
import { disc } from "../draw/marks.js";
import { drawGoal, drawHit, drawStart } from "../draw/shapes.js";
import { folded, unrolled } from "../draw/trace.js";
import { View } from "../draw/view.js";

/** @import { Brush, Painting } from "../room/sheet.js" */
/** @import { Bench } from "./bench.js" */

const MARGIN = { left: 34, right: 12, top: 12, bottom: 32 };
/** How much of the picture is shown again beyond each border of a circle, radians. */
const BEYOND = 0.55;
/** Pixels of the picture a cell, at most. */
const PIXELS = 2;
const TURN = 2 * Math.PI;

/** @implements {Painting} */
export class Square {
  /** @param {Bench} bench */
  constructor(bench) {
    this.bench = bench;
    /** @type {View | null} */
    this.view = null;
    /** Rows of 1 for collision, from the lowest angles. @type {{ side: number, mask: Float32Array } | null} */
    this.cells = null;
    /** The picture of them, as long as it is the same. @type {{ key: string, cells: object, canvas: OffscreenCanvas } | null} */
    this.picture = null;
    /** Draws what belongs to a mode of its own. @type {((brush: Brush, square: Square) => void) | null} */
    this.overlay = null;
  }

  /** The obstacles, as the core drew them. @param {Uint8Array} bytes @param {number} side */
  take(bytes, side) { this.cells = { side, mask: soften(bytes, side) }; }

  /** @param {number} width @param {number} height */
  viewOf(width, height) {
    const [x, y] = this.bench.arm.joints;
    const over = (/** @type {{ isCircle: boolean }} */ joint) => (joint.isCircle ? BEYOND : 0);
    return new View({ min: [x.low - over(x), y.low - over(y)], max: [x.high + over(x), y.high + over(y)] }, width, height, MARGIN, true);
  }

  /** @param {Brush} brush */
  ground({ context, palette, width, height, ratio }) {
    const view = this.viewOf(width, height);
    const [x, y] = this.bench.arm.joints;
    this.view = view;
    const inner = { x: view.x(x.low), y: view.y(y.high), width: (x.high - x.low) * view.scaleX, height: (y.high - y.low) * view.scaleY };
    context.save();
    this.clip(context);
    if (this.cells) {
      const picture = this.paint(inner.width * ratio, inner.height * ratio, palette);
      for (const i of x.isCircle ? [-1, 0, 1] : [0]) {
        for (const j of y.isCircle ? [-1, 0, 1] : [0]) context.drawImage(picture, inner.x + i * inner.width, inner.y + j * inner.height, inner.width, inner.height);
      }
    }
    // What is shown twice is faint where it is the second time.
    context.globalAlpha = 0.62;
    context.fillStyle = palette.stage;
    const { min, max } = view.box;
    const [left, right, top, bottom] = [view.x(min[0]), view.x(max[0]), view.y(max[1]), view.y(min[1])];
    context.fillRect(left, top, inner.x - left, bottom - top);
    context.fillRect(inner.x + inner.width, top, right - inner.x - inner.width, bottom - top);
    context.fillRect(inner.x, top, inner.width, inner.y - top);
    context.fillRect(inner.x, inner.y + inner.height, inner.width, bottom - inner.y - inner.height);
    context.restore();
    context.strokeStyle = palette["obstacle-edge"];
    // A border that can be crossed is broken, one that cannot is drawn through.
    for (const [isCircle, lines] of /** @type {[boolean, number[][]][]} */ ([
      [x.isCircle, [[inner.x, top, inner.x, bottom], [inner.x + inner.width, top, inner.x + inner.width, bottom]]],
      [y.isCircle, [[left, inner.y, right, inner.y], [left, inner.y + inner.height, right, inner.y + inner.height]]],
    ])) {
      context.lineWidth = isCircle ? 1 : 2;
      context.setLineDash(isCircle ? [3, 3] : []);
      for (const [x0, y0, x1, y1] of lines) tick(context, x0, y0, x1, y1);
    }
    context.setLineDash([]);
    this.drawTicks(context, palette, { left, top, right, bottom });
  }

  /** The obstacles as an image, no finer than its cells are worth. @param {number} width  device pixels @param {number} height @param {Brush["palette"]} palette */
  paint(width, height, palette) {
    const cells = /** @type {NonNullable<Square["cells"]>} */ (this.cells);
    const scale = Math.min(1, (PIXELS * cells.side) / Math.max(width, height));
    const [w, h] = [Math.round(width * scale), Math.round(height * scale)];
    const key = [w, h, palette.obstacle, palette["obstacle-edge"]].join();
    if (this.picture?.key !== key || this.picture.cells !== cells) this.picture = { key, cells, canvas: paint(cells.mask, cells.side, w, h, palette) };
    return this.picture.canvas;
  }

  /** @param {CanvasRenderingContext2D} context @param {Brush["palette"]} palette @param {{ left: number, top: number, right: number, bottom: number }} frame */
  drawTicks(context, palette, { left, top, right, bottom }) {
    const view = /** @type {View} */ (this.view);
    const [across, up] = this.bench.arm.joints;
    context.fillStyle = palette.quiet;
    context.lineWidth = 1;
    context.strokeStyle = palette["obstacle-edge"];
    context.font = "12px system-ui, sans-serif";
    context.textBaseline = "top";
    context.textAlign = "center";
    for (const { value, text } of ticks(across)) {
      tick(context, view.x(value), bottom, view.x(value), bottom + 4);
      context.fillText(text, view.x(value), bottom + 7);
    }
    context.fillText(titleOf(across), left + (right - left) * 0.34, bottom + 7);
    context.textBaseline = "middle";
    context.textAlign = "right";
    for (const { value, text } of ticks(up)) {
      tick(context, left - 4, view.y(value), left, view.y(value));
      context.fillText(text, left - 8, view.y(value));
    }
    context.save();
    context.translate(left - 22, top + (bottom - top) * 0.34);
    context.rotate(-Math.PI / 2);
    context.textBaseline = "top";
    context.textAlign = "center";
    context.fillText(titleOf(up), 0, 0);
    context.restore();
  }

  /** @param {CanvasRenderingContext2D} context */
  clip(context) {
    const view = /** @type {View} */ (this.view);
    const { min, max } = view.box;
    context.beginPath();
    context.rect(view.x(min[0]), view.y(max[1]), (max[0] - min[0]) * view.scaleX, (max[1] - min[1]) * view.scaleY);
    context.clip();
  }

  /** Where a configuration is. @param {ArrayLike<number>} q @returns {[number, number]} */
  place(q) {
    const view = /** @type {View} */ (this.view);
    const { circles } = this.bench.arm;
    return [view.x(circles[0] ? folded(q[0]) : q[0]), view.y(circles[1] ? folded(q[1]) : q[1])];
  }

  /** The same places again beyond the borders, as far as they are shown. @param {ArrayLike<number>} q @param {(x: number, y: number, isTwin: boolean) => void} then */
  eachPlace(q, then) {
    const view = /** @type {View} */ (this.view);
    const { joints, circles } = this.bench.arm;
    const at = [0, 1].map((i) => (circles[i] ? folded(q[i]) : q[i]));
    const shifts = (/** @type {number} */ i) => (circles[i] ? [-TURN, 0, TURN] : [0]).filter((shift) => at[i] + shift > joints[i].low - BEYOND && at[i] + shift < joints[i].high + BEYOND);
    for (const i of shifts(0)) for (const j of shifts(1)) then(view.x(at[0] + i), view.y(at[1] + j), i !== 0 || j !== 0);
  }

  /** @param {Brush} brush */
  top(brush) {
    const { context, palette } = brush;
    const { bench, view } = this;
    if (!view || bench.arm.dimension !== 2) return;
    const { arm, mode } = bench;
    context.save();
    this.clip(context);
    if (mode === "between") this.drawWay(brush);
    if (mode === "solve") this.overlay?.(brush, this);
    const colour = arm.check.free ? palette.robot : palette.collision;
    this.eachPlace(arm.q, (x, y, isTwin) => {
      context.globalAlpha = isTwin ? 0.35 : 1;
      context.fillStyle = colour;
      disc(context, x, y, 6.5);
      context.strokeStyle = palette.stage;
      context.lineWidth = 2;
      context.stroke();
      if (arm.check.free) return;
      context.beginPath();
      context.moveTo(x - 2.6, y - 2.6);
      context.lineTo(x + 2.6, y + 2.6);
      context.moveTo(x - 2.6, y + 2.6);
      context.lineTo(x + 2.6, y - 2.6);
      context.stroke();
    });
    context.globalAlpha = 1;
    context.restore();
  }

  /** The straight way from A to B: across a border it goes on from the other side. @param {Brush} brush */
  drawWay({ context, palette }) {
    const view = /** @type {View} */ (this.view);
    const { arm, a, b, way } = this.bench;
    const ends = [a[0], a[1], a[0] + way.turns[0], a[1] + way.turns[1]];
    context.strokeStyle = palette.path;
    context.lineWidth = 3;
    context.beginPath();
    unrolled(ends, 0, arm.circles, [false, false], (x0, y0, x1, y1) => {
      context.moveTo(view.x(x0), view.y(y0));
      context.lineTo(view.x(x1), view.y(y1));
    });
    context.stroke();
    this.eachPlace(a, (x, y) => drawStart(context, x, y, palette));
    this.eachPlace(b, (x, y) => drawGoal(context, x, y, palette));
    if (way.hit !== null) this.eachPlace(way.at(way.hit), (x, y) => drawHit(context, x, y, palette));
  }

  /** A pose for a point of the sheet. @param {number} px @param {number} py */
  poseAt(px, py) { return this.view?.toPlane(px, py) ?? null; }
}
