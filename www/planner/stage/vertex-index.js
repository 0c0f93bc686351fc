/**
 * The vertices of a run in CSS pixels of a pane, and the nearest of them to a point: a grid with cells as wide as the
 * reach of a pointer, so that a query visits nine cells. Vertices are only added; a new layout or run makes a new
 * index.
 */

/** @import { Pane } from "./pane.js" */
/** @import { RunLog } from "../run-log/run-log.js" */

/** Reach of a pointer, CSS pixels. */
export const NEAR = 12;

export class VertexIndex {
  /** @param {Pane} pane @param {RunLog} run */
  constructor(pane, run) {
    this.pane = pane;
    this.run = run;
    /** Pixels, x and y in turn. @type {number[]} */
    this.points = [];
    /** Vertices by cell. @type {Map<number, number[]>} */
    this.cells = new Map();
  }

  /** Adds new vertices. */
  follow() {
    const { points, run } = this;
    const first = points.length / 2;
    if (first === run.vertices.count) return;
    const fresh = this.pane.pixels(run.vertices.slice(first, run.vertices.count));
    for (let i = 0; i < fresh.length; i += 2) this.put(fresh[i], fresh[i + 1]);
  }

  /** Adds a point. @param {number} x @param {number} y */
  put(x, y) {
    const { points, cells } = this;
    const key = keyOf(x, y);
    const cell = cells.get(key);
    if (cell) cell.push(points.length / 2);
    else cells.set(key, [points.length / 2]);
    points.push(x, y);
  }

  /**
   * The nearest of the first `count` points within reach, the older of two at the same distance; -1: none.
   * @param {number} x
   * @param {number} y
   * @param {number} count
   * @param {(point: number) => boolean} [counts]  filter
   */
  nearest(x, y, count, counts = () => true) {
    this.follow();
    let best = -1;
    let least = NEAR;
    for (let dx = -NEAR; dx <= NEAR; dx += NEAR) {
      for (let dy = -NEAR; dy <= NEAR; dy += NEAR) {
        for (const point of this.cells.get(keyOf(x + dx, y + dy)) ?? []) {
          const distance = Math.hypot(this.points[2 * point] - x, this.points[2 * point + 1] - y);
          if (point >= count || distance > least || (distance === least && point > best) || !counts(point)) continue;
          best = point;
          least = distance;
        }
      }
    }
    return best;
  }
}

/** @param {number} x @param {number} y */
function keyOf(x, y) {
  return Math.floor(x / NEAR) * 65536 + Math.floor(y / NEAR);
}
