/**
 * The picture of a map's cells, drawn once to a bitmap: cells that are obstacles, unknown ones apart as stripes, those
 * that are obstacles by simplification alone, and those that only the file has as obstacles.
 */
import { comparer } from "../app/once.js";
import { bytesOf } from "../draw/mask.js";
import { drawWorld } from "planarium/draw";

/** @import { View } from "planarium/draw" */
/** @import { Palette } from "../app/palette.js" */
/** @import { Box, Obstacle, ScenarioDocument } from "../domain/types.js" */
/** @import { Grid } from "./types.js" */
/** @typedef {CanvasRenderingContext2D} Context */
/** @typedef {ScenarioDocument["world"]} World */

/** Pixels of the bitmap at most; a larger map has several cells a pixel. */
const MOST = 1 << 23;
/** Stripes of unknown cells along the longer side. */
const STRIPES = 90;
/** How far a corner may be from one of a cell, in cells. */
const NEAR = 1e-3;
/** Opacity of the stripes of unknown cells. */
const STRIPE = 0.55;
/** A map is shown as far as it is known if that is at most this part of it, and as much around it. */
const KNOWN = { most: 0.5, around: 0.06 };
/** Opacity of cells that no obstacle covers any more. */
const FAINT = 0.35;

/** @typedef {[number, number, number, number]} Cells   columns and rows: from, and up to */

export class CellPicture {
  /** @param {Grid} grid @param {readonly Obstacle[]} obstacles   of its scenario */
  constructor(grid, obstacles) {
    this.grid = grid;
    /** Cells a pixel, along a side. */
    this.step = Math.ceil(Math.sqrt((grid.width * grid.height) / MOST));
    /** The cells of each obstacle that is a rectangle of them. @type {Map<Obstacle, Cells>} */
    this.cells = new Map();
    for (const obstacle of obstacles) {
      const cells = this.cellsOf(obstacle);
      if (cells) this.cells.set(obstacle, cells);
    }
    this.hasUnknown = grid.cells.includes(2);
    /** Those that are no rectangles of cells. @type {Obstacle[]} */
    this.others = [];
    this.differs = comparer();
    this.bitmap = new OffscreenCanvas(Math.ceil(grid.width / this.step), Math.ceil(grid.height / this.step));
  }

  /** @param {Obstacle} obstacle @returns {Cells | null} */
  cellsOf(obstacle) {
    if (obstacle.type !== "polygon" || "holes" in obstacle || obstacle.vertices.length !== 4) return null;
    const { origin, yaw, resolution } = this.grid;
    const [cosine, sine] = [Math.cos(yaw) / resolution, Math.sin(yaw) / resolution];
    const corners = obstacle.vertices.map(([x, y]) => {
      const [dx, dy] = [x - origin[0], y - origin[1]];
      return [dx * cosine + dy * sine, dy * cosine - dx * sine];
    });
    if (corners.flat().some((value) => Math.abs(value - Math.round(value)) > NEAR)) return null;
    const [columns, rows] = [0, 1].map((i) => new Set(corners.map((corner) => Math.round(corner[i]))));
    if (columns.size !== 2 || rows.size !== 2) return null;
    return [Math.min(...columns), Math.max(...columns), Math.min(...rows), Math.max(...rows)];
  }

  /** Whether a cell is one of an obstacle. @param {number} at */
  isCovered(at) {
    const [row, column] = [Math.floor(at / this.grid.width), at % this.grid.width];
    return [...this.cells.values()].some(
      ([left, right, bottom, top]) => column >= left && column < right && row >= bottom && row < top,
    );
  }

  /**
   * Where the known cells are, if most of the map is unknown and an obstacle; else undefined.
   * @returns {Box | undefined}
   */
  get window() {
    const { width, height, resolution, origin, yaw, cells } = this.grid;
    if (!this.isCovered(cells.indexOf(2))) return undefined;
    let [left, right, bottom, top] = [width, 0, height, 0];
    for (let row = 0, at = 0; row < height; row++)
      for (let column = 0; column < width; column++, at++) {
        if (cells[at] === 2) continue;
        left = Math.min(left, column);
        right = Math.max(right, column + 1);
        bottom = Math.min(bottom, row);
        top = row + 1;
      }
    if (yaw !== 0 || left >= right || (right - left) * (top - bottom) > KNOWN.most * width * height) return undefined;
    const more = KNOWN.around * Math.max(right - left, top - bottom);
    return {
      min: [origin[0] + (left - more) * resolution, origin[1] + (bottom - more) * resolution],
      max: [origin[0] + (right + more) * resolution, origin[1] + (top + more) * resolution],
    };
  }

  /**
   * Draws a world: the cells, the bounds, and the obstacles that are not rectangles of cells.
   * @param {Context} context
   * @param {View} view
   * @param {World} world
   * @param {Palette} palette
   */
  draw(context, view, { bounds, obstacles }, palette) {
    this.paint(obstacles, palette);
    const { grid, bitmap, step } = this;
    const cell = grid.resolution * view.scaleX;
    context.save();
    context.translate(view.x(grid.origin[0]), view.y(grid.origin[1]));
    context.rotate(-grid.yaw);
    // Cells of two pixels and more keep their edges.
    context.imageSmoothingEnabled = cell * step < 2;
    context.imageSmoothingQuality = "medium";
    context.drawImage(bitmap, 0, -grid.height * cell, bitmap.width * step * cell, bitmap.height * step * cell);
    context.restore();
    drawWorld(context, view, { world: { bounds, obstacles: this.others } }, palette);
  }

  /** Paints the bitmap, unless it is as it should be. @param {readonly Obstacle[]} obstacles @param {Palette} palette */
  paint(obstacles, palette) {
    if (!this.differs("bitmap", obstacles, palette.obstacle, palette.obstacleEdge)) return;
    this.others = obstacles.filter((obstacle) => !this.cells.has(obstacle));
    const { grid, bitmap, step } = this;
    const { width, height } = grid;
    const covered = new Uint8Array(width * height);
    for (const obstacle of obstacles) {
      const [left, right, bottom, top] = this.cells.get(obstacle) ?? [0, 0, 0, 0];
      for (let row = bottom; row < top; row++) covered.fill(1, row * width + left, row * width + right);
    }
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (bitmap.getContext("2d"));
    const colours = [palette.obstacle, palette.obstacleEdge];
    const [soft, strong] = colours.map((colour) => pixelOf(colour, 1));
    const stripe = pixelOf(palette.obstacleEdge, STRIPE);
    const [softFaint, faint] = colours.map((colour) => pixelOf(colour, FAINT));
    const image = context.createImageData(bitmap.width, bitmap.height);
    const pixels = new Uint32Array(image.data.buffer);
    const period = Math.max(4, Math.round(Math.max(width, height) / STRIPES));
    for (let row = 0; row < height; row++) {
      const line = Math.floor((height - 1 - row) / step) * bitmap.width;
      for (let column = 0, at = row * width; column < width; column++, at++) {
        const cell = grid.cells[at];
        if (cell === 0 && covered[at] === 0) continue;
        const isStripe = cell === 2 && (column + row) % period < period / 3;
        const isStrong = cell === 1 || isStripe;
        const pixel = line + Math.floor(column / step);
        // Of several cells in a pixel the strongest shows: a thin wall does not vanish.
        if (step > 1 && pixels[pixel] !== 0 && !(isStrong && covered[at])) continue;
        pixels[pixel] = !covered[at] ? (isStrong ? faint : softFaint) : isStripe ? stripe : isStrong ? strong : soft;
      }
    }
    context.putImageData(image, 0, 0);
  }
}

/** A colour as the bytes of a pixel. @param {string} colour @param {number} alpha */
function pixelOf(colour, alpha) {
  return new Uint32Array(Uint8Array.of(...bytesOf(colour), Math.round(255 * alpha)).buffer)[0];
}
