/**
 * The configuration space of two coordinates as a square. A circle is cut open at its ends; a faint strip of the same
 * picture continues beyond each cut and shows how the angles wrap.
 */
import { View } from "planarium/draw";
import { drawAxes, marginOf } from "./angles.js";
import { contoursOf, fillContours } from "./contours.js";
import { drawLine, setStroke } from "./marks.js";
import { NO_VIEW } from "./figure.js";
import { folded } from "./trace.js";

/** @import { Coordinate } from "../domain/types.js" */
/** @import { Contours } from "./contours.js" */
/** @import { Brush } from "./figure.js" */

/** Width of the strips, radians. */
const STRIP = 0.5;

export class AngleSquare {
  constructor() {
    /** @type {Coordinate[]} */
    this.coordinates = [];
    this.view = NO_VIEW;
    /** The square, and the square with its strips. */
    this.inner = this.outer = { x: 0, y: 0, width: 0, height: 0 };
    /** The outlines of the obstacles. @type {Contours} */
    this.obstacles = [];
  }

  get layers() {
    return {
      ground: { key: this.key, draw: (/** @type {Brush} */ brush) => this.drawGround(brush) },
      top: { draw: (/** @type {Brush} */ brush) => this.drawTop(brush) },
    };
  }

  /** What the ground depends on. @returns {unknown[]} */
  get key() {
    return [this.obstacles];
  }

  /** @param {Brush} _brush */
  drawGround(_brush) {}

  /** @param {Brush} _brush */
  drawTop(_brush) {}

  /** Stores the obstacles as the core gives them. @param {Uint8Array} bytes @param {number} side  cells */
  setCells(bytes, side) {
    this.obstacles = contoursOf(bytes, side);
  }

  /**
   * Draws obstacles, borders and axes.
   * @param {Brush} brush
   * @param {Coordinate[]} coordinates
   * @param {() => OffscreenCanvas | null} [imageOf]  fills the square on top of the obstacles
   */
  drawSquare({ context, palette, width, height, bold }, coordinates, imageOf = () => null) {
    this.coordinates = coordinates;
    const [low, high] = /** @type {const} */ (["low", "high"]).map((end) => coordinates.map((one) => one[end]));
    const strips = coordinates.map(({ isCircle }) => (isCircle ? STRIP : 0));
    const view = (this.view = new View(
      { min: [low[0] - strips[0], low[1] - strips[1]], max: [high[0] + strips[0], high[1] + strips[1]] },
      width,
      height,
      marginOf(bold),
      true,
    ));
    const box = (/** @type {number[]} */ [x0, y0], /** @type {number[]} */ [x1, y1]) => ({
      x: view.x(x0),
      y: view.y(y1),
      width: (x1 - x0) * view.scaleX,
      height: (y1 - y0) * view.scaleY,
    });
    const inner = (this.inner = box(low, high));
    const outer = (this.outer = box(view.box.min, view.box.max));
    const image = imageOf();
    this.repeat(context, (isCopy) => {
      context.globalAlpha = isCopy ? 0.4 : 1;
      fillContours(context, this.obstacles, inner, palette);
      if (image) context.drawImage(image, inner.x, inner.y, inner.width, inner.height);
    });
    // Borders that can be crossed are dashed, joint limits solid.
    for (const [i, { low: from, high: to, isCircle }] of coordinates.entries()) {
      setStroke(context, palette.obstacleEdge, isCircle ? 1 : 2, isCircle ? [3, 3] : []);
      for (const value of [from, to]) {
        if (i === 0) drawLine(context, view.x(value), outer.y, view.x(value), outer.y + outer.height);
        else drawLine(context, outer.x, view.y(value), outer.x + outer.width, view.y(value));
      }
    }
    context.setLineDash([]);
    context.fillStyle = palette.quiet;
    drawAxes(context, view, outer, coordinates, bold);
  }

  /**
   * Draws the same in the square and, a turn further, in the strips.
   * @param {CanvasRenderingContext2D} context
   * @param {(isCopy: boolean) => void} draw
   */
  repeat(context, draw) {
    const { inner, outer } = this;
    const [across, up] = this.coordinates.map(({ isCircle }) => (isCircle ? [-1, 0, 1] : [0]));
    context.save();
    context.beginPath();
    context.rect(outer.x, outer.y, outer.width, outer.height);
    context.clip();
    for (const i of across) {
      for (const j of up) {
        context.save();
        context.translate(i * inner.width, j * inner.height);
        draw(i !== 0 || j !== 0);
        context.restore();
      }
    }
    context.restore();
  }

  /** A configuration in the square, CSS pixels. @param {ArrayLike<number>} q @returns {[number, number]} */
  place(q) {
    return this.view.place(this.coordinates.map(({ isCircle }, i) => (isCircle ? folded(q[i]) : q[i])));
  }

  /**
   * A straight motion from a configuration, by the difference of each coordinate.
   * @param {CanvasRenderingContext2D} context
   * @param {ArrayLike<number>} from
   * @param {ArrayLike<number>} difference
   */
  strokeMotion(context, from, difference) {
    const [x, y] = this.place(from);
    drawLine(context, x, y, x + this.view.scaleX * difference[0], y - this.view.scaleY * difference[1]);
  }
}
