/**
 * The configurations of an arm of two joints as dots on its torus, unrolled to a square, and straight lines from the target to
 * its neighbours: where a line leaves the square it comes back on the other side, and a strip beyond each border shows how. The naive metric cuts both circles at 0, so its
 * lines never cross that cut, which is drawn.
 */
import { tick, ticks, titleOf } from "../draw/angles.js";
import { paint, soften } from "../draw/mask.js";
import { disc, ring } from "../draw/marks.js";
import { folded, way } from "../draw/trace.js";
import { View } from "../draw/view.js";
import { cloudOf } from "./cloud.js";

/** @import { Brush, Painting } from "../room/sheet.js" */
/** @import { Desk } from "./desk.js" */
/** @import { Point } from "./types.js" */

const MARGIN = { left: 34, right: 12, top: 12, bottom: 32 };
const TURN = 2 * Math.PI;
/** Cells a side of the obstacles' picture. */
const CELLS = 96;
/** How much of the picture is shown again beyond each border, radians. */
const BEYOND = 0.5;

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
    const reach = Math.PI + BEYOND;
    const view = new View({ min: [-reach, -reach], max: [reach, reach] }, width, height, MARGIN, true);
    this.view = view;
    const { left, top, side, high, outer } = this.frame();
    const { rows } = desk.list;
    const places = new Float64Array(rows.length);
    for (let i = 0; i < rows.length; i += 2) {
      places[i] = view.x(folded(rows[i])) - left;
      places[i + 1] = view.y(folded(rows[i + 1])) - top;
    }
    const obstacles = paint(this.mask, CELLS, Math.round(side * ratio), Math.round(high * ratio), palette);
    const dots = places.length > 0 ? cloudOf(places, { width: side, height: high, ratio, colour: palette.growth, size: 2.4 }) : null;
    this.eachTurn(context, () => {
      context.drawImage(obstacles, left, top, side, high);
      if (dots) context.drawImage(dots, left, top, side, high);
    });
    // What is shown twice is faint where it is the second time.
    context.save();
    context.globalAlpha = 0.6;
    context.fillStyle = palette.stage;
    const [x, y, right, bottom] = outer;
    context.fillRect(x, y, left - x, bottom - y);
    context.fillRect(left + side, y, right - left - side, bottom - y);
    context.fillRect(left, y, side, top - y);
    context.fillRect(left, top + high, side, bottom - top - high);
    context.restore();
    context.strokeStyle = palette["obstacle-edge"];
    context.lineWidth = 1;
    context.setLineDash([3, 3]);
    context.strokeRect(left, top, side, high);
    context.setLineDash([]);
    this.drawTicks(context, palette);
  }

  /** Draws the same again a turn further, on every side, as far as it is shown. @param {CanvasRenderingContext2D} context @param {() => void} draw */
  eachTurn(context, draw) {
    const { side, high, outer: [x, y, right, bottom] } = this.frame();
    context.save();
    context.beginPath();
    context.rect(x, y, right - x, bottom - y);
    context.clip();
    for (const i of [-1, 0, 1]) {
      for (const j of [-1, 0, 1]) {
        context.save();
        context.translate(i * side, j * high);
        draw();
        context.restore();
      }
    }
    context.restore();
  }

  /** The square, and the frame about what is shown of it again: left, top, right, bottom; CSS pixels. */
  frame() {
    const view = /** @type {View} */ (this.view);
    const { min, max } = view.box;
    return { left: view.x(-Math.PI), top: view.y(Math.PI), side: TURN * view.scaleX, high: TURN * view.scaleY, outer: [view.x(min[0]), view.y(max[1]), view.x(max[0]), view.y(min[1])] };
  }

  /** @param {CanvasRenderingContext2D} context @param {Brush["palette"]} palette */
  drawTicks(context, palette) {
    const view = /** @type {View} */ (this.view);
    const { left, top, side, high, outer: [x, , , bottom] } = this.frame();
    const [across, up] = this.desk.coordinates;
    context.fillStyle = palette.quiet;
    context.font = "12px system-ui, sans-serif";
    context.textBaseline = "top";
    context.textAlign = "center";
    for (const { value, text } of ticks(across)) {
      tick(context, view.x(value), bottom, view.x(value), bottom + 4);
      context.fillText(text, view.x(value), bottom + 7);
    }
    context.fillText(titleOf(across), left + side * 0.32, bottom + 7);
    context.textBaseline = "middle";
    context.textAlign = "right";
    for (const { value, text } of ticks(up)) {
      tick(context, x - 4, view.y(value), x, view.y(value));
      context.fillText(text, x - 8, view.y(value));
    }
    context.save();
    context.translate(x - 22, top + high * 0.32);
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
    const { indices } = desk.found;
    const right = new Set(desk.exact.indices);
    const { missed } = desk;
    this.eachTurn(context, () => {
      if (desk.isNaive) {
        context.strokeStyle = palette.rejected;
        context.lineWidth = 1.4;
        context.setLineDash([7, 5]);
        tick(context, view.x(0), top, view.x(0), top + high);
        tick(context, left, view.y(0), left + side, view.y(0));
      }
      for (const i of missed) this.drawWay(context, i, palette.rejected, [3, 4], 1.2, false);
      for (let rank = indices.length - 1; rank >= 0; rank--) {
        const near = 1 - rank / Math.max(1, indices.length - 1);
        this.drawWay(context, indices[rank], right.has(indices[rank]) ? palette.start : palette.rejected, [], 1 + near, desk.isNaive);
      }
      for (const i of missed) {
        context.strokeStyle = palette.rejected;
        context.lineWidth = 1.6;
        ring(context, ...this.place(desk.row(i)), 4.6);
      }
      for (const i of indices) {
        context.fillStyle = right.has(i) ? palette.start : palette.rejected;
        disc(context, ...this.place(desk.row(i)), 3.6);
      }
      context.fillStyle = palette.robot;
      context.strokeStyle = palette.stage;
      context.lineWidth = 2;
      disc(context, ...this.place(desk.q), 6.5);
      context.stroke();
    });
  }

  /** The straight way from the target to a configuration. @param {CanvasRenderingContext2D} context @param {number} i @param {string} colour @param {number[]} dash @param {number} width @param {boolean} isNaive */
  drawWay(context, i, colour, dash, width, isNaive) {
    const view = /** @type {View} */ (this.view);
    const ends = [...this.desk.q, ...this.desk.row(i)].map((angle) => (isNaive ? unwound(angle) : angle));
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.setLineDash(dash);
    context.beginPath();
    const [x, y] = [0, 1].map((axis) => folded(ends[axis]));
    context.moveTo(view.x(x), view.y(y));
    context.lineTo(view.x(x + way(ends[0], ends[2], !isNaive)), view.y(y + way(ends[1], ends[3], !isNaive)));
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
