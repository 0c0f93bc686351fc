/**
 * The picture of a subdivision on a pane: cells are painted as they come, each over the one that it is a quarter of.
 */
import { CSpace } from "../stage/cspace-pane.js";

/** @import { Pane } from "../stage/pane.js" */
/** @import { View } from "planarium/draw" */

/** Numbers in a row: centre, half of each side, kind. */
export const WIDTH = 5;
const FREE = 1;
const BLOCKED = 2;
/** How much of a cell's colour is seen. */
const ALPHA = { blocked: 0.42, free: 0.2, marked: 0.75 };
/** Borders are drawn around cells of this number of pixels. */
const LARGE = 5;

export class CellPicture {
  /** @param {Pane} pane */
  constructor(pane) {
    this.pane = pane;
    /** The view that it is painted for. @type {View | null} */
    this.view = null;
    /** @type {CanvasRenderingContext2D | null} */
    this.context = null;
    this.painted = 0;
  }

  /**
   * Paints what is new and draws the picture.
   * @param {CanvasRenderingContext2D} context
   * @param {Float64Array[]} blocks
   * @param {Float64Array} marked   rows that separate start and goal, or connect them
   * @param {boolean} isWall
   */
  draw(context, blocks, marked, isWall) {
    const { pane } = this;
    const { view, palette, width, height } = pane;
    if (!view || !palette) return;
    if (this.view !== view) this.begin(view);
    if (!this.context) return;
    for (; this.painted < blocks.length; this.painted++) this.paint(this.context, blocks[this.painted]);
    context.drawImage(this.context.canvas, 0, 0, width, height);
    context.save();
    context.globalAlpha = ALPHA.marked;
    context.fillStyle = isWall ? palette.collision : palette.path;
    for (let at = 0; at < marked.length; at += WIDTH) {
      const [x, y, w, h] = this.place(marked, at);
      // A thin wall is still seen.
      context.fillRect(x - 0.5, y - 0.5, w + 1, h + 1);
    }
    context.restore();
  }

  /** @param {View} view */
  begin(view) {
    const { width, height, ratio } = this.pane;
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [width * ratio, height * ratio];
    [this.view, this.painted, this.context] = [view, 0, canvas.getContext("2d")];
    this.context?.scale(ratio, ratio);
  }

  /** @param {CanvasRenderingContext2D} context @param {Float64Array} rows */
  paint(context, rows) {
    const { palette } = this.pane;
    if (!palette) return;
    context.lineWidth = 0.5;
    context.strokeStyle = palette.obstacleEdge;
    for (let at = 0; at < rows.length; at += WIDTH) {
      const [x, y, w, h] = this.place(rows, at);
      const kind = rows[at + 4];
      context.clearRect(x, y, w, h);
      if (kind === FREE || kind === BLOCKED) {
        context.globalAlpha = kind === FREE ? ALPHA.free : ALPHA.blocked;
        context.fillStyle = kind === FREE ? palette.path : palette.collision;
        context.fillRect(x, y, w, h);
        context.globalAlpha = 1;
      }
      if (w >= LARGE && h >= LARGE) context.strokeRect(x + 0.25, y + 0.25, w - 0.5, h - 0.5);
    }
  }

  /** A cell in pixels: left, top, width, height. @param {Float64Array} rows @param {number} at */
  place(rows, at) {
    const view = /** @type {View} */ (this.view);
    const [across, up] = this.pane instanceof CSpace ? this.pane.axes : [0, 1];
    const [x, y, w, h] = [rows[at + across], rows[at + up], rows[at + 2 + across], rows[at + 2 + up]];
    const [left, top] = [view.x(x - w), view.y(y + h)];
    return [left, top, view.x(x + w) - left, view.y(y - h) - top];
  }
}
