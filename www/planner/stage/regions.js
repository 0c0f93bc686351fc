/**
 * The Voronoi regions of a tree in a plane of configurations: each cell of a grid has the colour of the vertex that is
 * nearest to it, in the metric of the run. RRT extends the vertex whose region a sample falls into, so large regions
 * pull the tree into the open (LaValle and Kuffner 2001, "Randomized kinodynamic planning").
 */
import { wrap } from "planarium/draw";

/** @import { Lane } from "./lane.js" */
/** @import { RunLog } from "../run-log/run-log.js" */
/** @typedef {{ min: ArrayLike<number>, max: ArrayLike<number> }} Box */
/**
 * Of each cell the nearest vertex, and its distance or the square of it.
 * @typedef {{ nearest: Uint32Array, distances: Float64Array }} Cells
 */

/** Cells a side, and vertices at most: a vertex is compared with every cell once. */
export const SIDE = 96;
const MOST = 2000;
/** Between the hues of one vertex and the next, degrees: the golden angle keeps neighbours in time apart. */
const GOLDEN = 137.508;

/**
 * Gives a vertex the cells that are nearer to it than to any before.
 * @param {Cells} cells
 * @param {ArrayLike<number>} q
 * @param {number} vertex
 * @param {Lane["metric"]} metric
 * @param {Box} box
 * @param {boolean[]} circles  which coordinates wrap
 */
export function addVertex({ nearest, distances }, q, vertex, metric, { min, max }, circles) {
  const isSum = metric === "sum";
  // The distance along each coordinate, of all columns and of all rows.
  const [across, up] = [0, 1].map((i) =>
    Float64Array.from({ length: SIDE }, (_, cell) => {
      const gap = min[i] + ((cell + 0.5) / SIDE) * (max[i] - min[i]) - q[i];
      const along = Math.abs(circles[i] && metric !== "naive" ? wrap(gap) : gap);
      return isSum ? along : along * along;
    }),
  );
  for (let y = 0, at = 0; y < SIDE; y++) {
    for (let x = 0; x < SIDE; x++, at++) {
      const distance = across[x] + up[y];
      if (distance < distances[at]) {
        distances[at] = distance;
        nearest[at] = vertex;
      }
    }
  }
}

/** Cells that belong to no vertex yet; rows from the lowest. @returns {Cells} */
export function emptyCells() {
  return { nearest: new Uint32Array(SIDE * SIDE), distances: new Float64Array(SIDE * SIDE).fill(Infinity) };
}

export class Regions {
  constructor() {
    /** What the cells are of. @type {{ run: RunLog, key: string } | null} */
    this.of = null;
    /** Vertices compared so far. */
    this.count = 0;
    this.cells = emptyCells();
    this.canvas = new OffscreenCanvas(SIDE, SIDE);
  }

  /**
   * The regions of a tree as it is now, one pixel a cell; null if it is no tree.
   * @param {Lane} lane
   * @param {Box} box  of both coordinates
   * @param {boolean[]} circles  which of them wrap
   */
  image({ run, metric }, box, circles) {
    if (!run?.isTree || run.vertices.count === 0) return null;
    const key = `${metric} ${[...Array.from(box.min), ...Array.from(box.max)].join()}`;
    const count = Math.min(MOST, run.past[0]);
    if (this.of?.run !== run || this.of.key !== key || count < this.count) {
      this.of = { run, key };
      this.count = 0;
      this.cells = emptyCells();
    }
    if (this.count === count) return this.canvas;
    for (; this.count < count; this.count++) {
      // A goal is no vertex of the tree until it is reached: it is compared again then.
      const isGoal = run.kind === "tree" && this.count > 0 && this.count < run.roots;
      if (!isGoal) addVertex(this.cells, run.vertices.row(this.count), this.count, metric, box, circles);
    }
    this.paint();
    return this.canvas;
  }

  paint() {
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (this.canvas.getContext("2d"));
    const image = context.createImageData(SIDE, SIDE);
    for (let at = 0; at < SIDE * SIDE; at++) {
      const pixel = 4 * ((SIDE - 1 - Math.floor(at / SIDE)) * SIDE + (at % SIDE));
      const hue = (this.cells.nearest[at] * GOLDEN) % 360;
      for (let i = 0; i < 3; i++) {
        // From red, green and blue at full saturation and half lightness.
        const part = Math.abs(((((hue / 60 + 4 * i) % 6) + 6) % 6) - 3) - 1;
        image.data[pixel + i] = 255 * Math.min(1, Math.max(0, part));
      }
      image.data[pixel + 3] = 56;
    }
    context.putImageData(image, 0, 0);
  }
}
