/** An index of curved edges: points along them, close enough for a pointer. */
import { NEAR, VertexIndex } from "./vertex-index.js";

/** Points within the reach of a pointer. */
const CLOSE = 3;

export class Passages extends VertexIndex {
  /** Rows of traces in the index. */
  rows = 0;
  /**
   * For each point the row after it, and its fraction of the way from the row before.
   * @type {{ row: number, part: number }[]}
   */
  places = [];

  /** @override */
  follow() {
    const { rows, places, pane } = this;
    const { traces, dimension } = this.run;
    if (rows === traces.count) return;
    const { data, width, count } = traces;
    const fresh = pane.pixels(traces.slice(rows, count).filter((_, i) => i % width >= width - dimension));
    // Edges arrive whole: if the row before is of the same edge, it is new too.
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

  /**
   * The nearest edge within reach, of the first `edges`, and the configuration there; null: none.
   * @param {number} x
   * @param {number} y
   * @param {number} edges
   * @param {(edge: number) => boolean} counts
   */
  find(x, y, edges, counts) {
    const { places } = this;
    const { traces, scenario } = this.run;
    const { data, width } = traces;
    const edgeOf = (/** @type {number} */ point) => data[places[point].row * width];
    const point = this.nearest(x, y, Infinity, (one) => edgeOf(one) < edges && counts(edgeOf(one)));
    if (point < 0) return null;
    const { row, part } = places[point];
    const pose = data.slice(row * width + 1, (row + 1) * width);
    return {
      edge: edgeOf(point),
      pose: part === 1 ? pose : scenario.interpolate(data.slice((row - 1) * width + 1, row * width), pose, part),
    };
  }
}
