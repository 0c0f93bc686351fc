/**
 * Where the vertices of a run are on a pane, in CSS pixels, or the places on its edges that are no straight lines, and which of them is nearest to a point: a grid of cells as wide
 * as the reach of a pointer, so that nine cells are looked through. Made when it is first asked for, then only added to; a
 * new layout or a new run makes it anew.
 */

/** @import { Pane } from "./pane.js" */
/** @import { Run } from "../worker/run.js" */

/** How near to a vertex a pointer must be, CSS pixels. */
export const NEAR = 12;

export class Places {
  /** @param {Pane} pane @param {Run} run @param {"vertices" | "traces"} [kind] */
  constructor(pane, run, kind = "vertices") {
    this.pane = pane;
    this.run = run;
    this.rows = run[kind];
    /** Pixels, x and y in turn. @type {number[]} */
    this.points = [];
    /** Vertices by cell. @type {Map<number, number[]>} */
    this.cells = new Map();
  }

  /** Takes in the vertices that are new. */
  follow() {
    const { points, rows, run } = this;
    const first = points.length / 2;
    if (first === rows.count) return;
    // What stands before the configuration of a row is left out.
    const head = rows.width - run.dimension;
    const slice = rows.slice(first, rows.count);
    const fresh = this.pane.pixels(head > 0 ? slice.filter((_, i) => i % rows.width >= head) : slice);
    for (let i = 0; i < fresh.length; i += 2) {
      const key = keyOf(fresh[i], fresh[i + 1]);
      const cell = this.cells.get(key);
      if (cell) cell.push(first + i / 2);
      else this.cells.set(key, [first + i / 2]);
      points.push(fresh[i], fresh[i + 1]);
    }
  }

  /** The vertex nearest to a point of the pane, of the first `count`; the older one of two at the same place; -1 where none is near. @param {number} x @param {number} y @param {number} count @param {(row: number) => boolean} [counts]  those that count */
  nearest(x, y, count, counts = () => true) {
    this.follow();
    let best = -1;
    let least = NEAR;
    for (let dx = -NEAR; dx <= NEAR; dx += NEAR) {
      for (let dy = -NEAR; dy <= NEAR; dy += NEAR) {
        for (const vertex of this.cells.get(keyOf(x + dx, y + dy)) ?? []) {
          const distance = Math.hypot(this.points[2 * vertex] - x, this.points[2 * vertex + 1] - y);
          if (vertex >= count || distance > least || (distance === least && vertex > best) || !counts(vertex)) continue;
          best = vertex;
          least = distance;
        }
      }
    }
    return best;
  }
}

/** @param {number} x @param {number} y */
function keyOf(x, y) { return Math.floor(x / NEAR) * 65536 + Math.floor(y / NEAR); }
