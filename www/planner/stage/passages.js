/** Where edges pass that are no straight lines: points along them, as close as a pointer needs them. */
import { NEAR, VertexIndex } from "./vertex-index.js";

/** Points a pointer's reach. */
const CLOSE = 3;

export class Passages extends VertexIndex {
  /** Rows of traces that are taken in. */
  rows = 0;
  /** Of each point the row that it lies before, and how far on the way to it from the one before. @type {{ row: number, part: number }[]} */
  places = [];

  /** @override */
  follow() {
    const { run: { traces, dimension }, rows, places, pane } = this;
    if (rows === traces.count) return;
    const { data, width, count } = traces;
    const fresh = pane.pixels(traces.slice(rows, count).filter((_, i) => i % width >= width - dimension));
    // Edges come whole: the row before a new one, if it is of the same edge, is new too.
    for (let row = rows; row < count; row++) {
      const at = 2 * (row - rows);
      const [x, y] = [fresh[at], fresh[at + 1]];
      const goesOn = row > rows && data[(row - 1) * width] === data[row * width];
      const [px, py] = goesOn ? [fresh[at - 2], fresh[at - 1]] : [x, y];
      const steps = goesOn ? Math.min(400, Math.ceil((CLOSE * Math.hypot(x - px, y - py)) / NEAR)) : 1;
      for (let step = 1; step <= steps; step++) {
        const part = step / steps;
        this.put(px + (x - px) * part, py + (y - py) * part);
        places.push({ row, part });
      }
    }
    this.rows = count;
  }

  /** The edge nearest to a point, of the first ones, and the configuration there; null where none is near. @param {number} x @param {number} y @param {number} edges @param {(edge: number) => boolean} counts */
  find(x, y, edges, counts) {
    const { run: { traces, scenario }, places } = this;
    const { data, width } = traces;
    const edgeOf = (/** @type {number} */ point) => data[places[point].row * width];
    const point = this.nearest(x, y, Infinity, (one) => edgeOf(one) < edges && counts(edgeOf(one)));
    if (point < 0) return null;
    const { row, part } = places[point];
    const pose = data.slice(row * width + 1, (row + 1) * width);
    return { edge: edgeOf(point), pose: part === 1 ? pose : scenario.interpolate(data.slice((row - 1) * width + 1, row * width), pose, part) };
  }
}
