/**
 * The configurations of an arm of two joints as dots on its torus, unrolled to a square, and straight lines from the target to
 * its neighbours: where a line leaves the square it comes back on the other side. The naive metric cuts both circles at 0, so its
 * lines never cross that cut, which is drawn.
 */
import { tick, ticks, titleOf } from "../stage/angles.js";
import { paint, soften } from "../stage/mask.js";
import { disc } from "../stage/marks.js";
import { folded, unrolled } from "../stage/trace.js";
import { View } from "../stage/view.js";
import { cloudOf } from "./cloud.js";

/** @import { Brush, Painting } from "../room/sheet.js" */
/** @import { Desk } from "./desk.js" */
/** @import { Point } from "./types.js" */

const MARGIN = { left: 34, right: 12, top: 12, bottom: 32 };
const TURN = 2 * Math.PI;
/** Cells a side of the obstacles' picture. */
const CELLS = 96;

/** @implements {Painting} */
export class Square {
  /** @param {Desk} desk */
  constructor(desk) {
    this.desk = desk;
    /** @type {View | null} */
    this.view = null;
    /** @type {{ entry: object, mask: Float32Array } | null} */
    this.cells = null;
  }

  /** The obstacles of the robot on the desk. */
  get mask() {
    const { desk } = this;
    if (this.cells?.entry !== desk.entry) this.cells = { entry: desk.entry, mask: soften(desk.scenario.cspace({ width: CELLS, height: CELLS }), CELLS) };
    return this.cells.mask;
  }

  /** @param {Brush} brush */
  ground({ context, palette, width, height, ratio }) {
    const { desk } = this;
    if (desk.dimension !== 2 || !desk.isArm) return;
    const view = new View({ min: [-Math.PI, -Math.PI], max: [Math.PI, Math.PI] }, width, height, MARGIN, true);
    this.view = view;
    const { left, top, side, high } = this.frame();
    context.drawImage(paint(this.mask, CELLS, Math.round(side * ratio), Math.round(high * ratio), palette), left, top, side, high);
    const { rows } = desk.list;
    const places = new Float64Array(rows.length);
    for (let i = 0; i < rows.length; i += 2) {
      places[i] = view.x(folded(rows[i])) - left;
      places[i + 1] = view.y(folded(rows[i + 1])) - top;
    }
    if (places.length > 0) context.drawImage(cloudOf(places, { width: side, height: high, ratio, colour: palette.growth, size: 2.4 }), left, top, side, high);
    context.strokeStyle = palette["obstacle-edge"];
    context.lineWidth = 1;
    context.setLineDash([3, 3]);
    context.strokeRect(left, top, side, high);
    context.setLineDash([]);
    this.drawTicks(context, palette);
  }

  /** The square, CSS pixels. */
  frame() {
    const view = /** @type {View} */ (this.view);
    return { left: view.x(-Math.PI), top: view.y(Math.PI), side: TURN * view.scaleX, high: TURN * view.scaleY };
  }

  /** @param {CanvasRenderingContext2D} context @param {Brush["palette"]} palette */
  drawTicks(context, palette) {
    const view = /** @type {View} */ (this.view);
    const { left, top, side, high } = this.frame();
    const [across, up] = this.desk.coordinates;
    context.fillStyle = palette.quiet;
    context.font = "12px system-ui, sans-serif";
    context.textBaseline = "top";
    context.textAlign = "center";
    for (const { value, text } of ticks(across)) {
      tick(context, view.x(value), top + high, view.x(value), top + high + 4);
      context.fillText(text, view.x(value), top + high + 7);
    }
    context.fillText(titleOf(across), left + side * 0.32, top + high + 7);
    context.textBaseline = "middle";
    context.textAlign = "right";
    for (const { value, text } of ticks(up)) {
      tick(context, left - 4, view.y(value), left, view.y(value));
      context.fillText(text, left - 8, view.y(value));
    }
    context.save();
    context.translate(left - 22, top + high * 0.32);
    context.rotate(-Math.PI / 2);
    context.textBaseline = "top";
    context.textAlign = "center";
    context.fillText(titleOf(up), 0, 0);
    context.restore();
  }

  /** @param {Brush} brush */
  top({ context, palette }) {
    const { desk, view } = this;
    if (!view || desk.dimension !== 2 || !desk.isArm) return;
    const { left, top, side, high } = this.frame();
    context.save();
    context.beginPath();
    context.rect(left, top, side, high);
    context.clip();
    if (desk.isNaive) {
      context.strokeStyle = palette.rejected;
      context.lineWidth = 1.4;
      context.setLineDash([7, 5]);
      tick(context, view.x(0), top, view.x(0), top + high);
      tick(context, left, view.y(0), left + side, view.y(0));
      context.setLineDash([]);
    }
    const { indices } = desk.found;
    const right = new Set(desk.exact.indices);
    for (const i of desk.missed) this.drawWay(context, i, palette.rejected, [3, 4], 1.2, false);
    for (let rank = indices.length - 1; rank >= 0; rank--) {
      const near = 1 - rank / Math.max(1, indices.length - 1);
      this.drawWay(context, indices[rank], right.has(indices[rank]) ? palette.start : palette.rejected, [], 1 + near, desk.isNaive);
    }
    for (const i of desk.missed) {
      context.strokeStyle = palette.rejected;
      context.lineWidth = 1.6;
      const [x, y] = this.place(desk.row(i));
      context.beginPath();
      context.arc(x, y, 4.6, 0, TURN);
      context.stroke();
    }
    for (const i of indices) {
      context.fillStyle = right.has(i) ? palette.start : palette.rejected;
      disc(context, ...this.place(desk.row(i)), 3.6);
    }
    const [x, y] = this.place(desk.q);
    context.fillStyle = palette.robot;
    disc(context, x, y, 6.5);
    context.strokeStyle = palette.stage;
    context.lineWidth = 2;
    context.stroke();
    context.restore();
  }

  /** The straight way from the target to a configuration. @param {CanvasRenderingContext2D} context @param {number} i @param {string} colour @param {number[]} dash @param {number} width @param {boolean} isNaive */
  drawWay(context, i, colour, dash, width, isNaive) {
    const view = /** @type {View} */ (this.view);
    const ends = [...this.desk.q, ...this.desk.row(i)].map((angle) => (isNaive ? unwound(angle) : angle));
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.setLineDash(dash);
    context.beginPath();
    unrolled(ends, 0, [true, true], isNaive ? [false, false] : [true, true], (x0, y0, x1, y1) => {
      context.moveTo(view.x(x0), view.y(y0));
      context.lineTo(view.x(x1), view.y(y1));
    });
    context.stroke();
    context.setLineDash([]);
  }

  /** @param {ArrayLike<number>} q @returns {Point} */
  place(q) {
    const view = /** @type {View} */ (this.view);
    return [view.x(folded(q[0])), view.y(folded(q[1]))];
  }
}

/** An angle from 0 to a whole turn, as the naive metric reads it. @param {number} angle */
function unwound(angle) {
  const rest = angle % TURN;
  return rest < 0 ? rest + TURN : rest;
}
