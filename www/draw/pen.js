/** Lines of many segments on a canvas. */

/** @param {CanvasRenderingContext2D} context @param {Float64Array} points @param {number} first @param {number} end */
export function strokeLine(context, points, first, end) {
  context.beginPath();
  tracePen(context, points, first, end);
  context.stroke();
}

/**
 * Adds the points to the path. The line breaks at NaN, unless it continues, but for rounding, where it stopped; dashes
 * then run on.
 * @param {CanvasRenderingContext2D} context
 * @param {Float64Array} points
 * @param {number} first
 * @param {number} end
 */
export function tracePen(context, points, first, end) {
  let penX = NaN;
  let penY = NaN;
  let down = false;
  for (let i = first; i < end; i++) {
    const x = points[2 * i];
    const y = points[2 * i + 1];
    if (Number.isNaN(x)) {
      down = false;
      continue;
    }
    if (!down && !(Math.abs(x - penX) < 1e-6 && Math.abs(y - penY) < 1e-6)) context.moveTo(x, y);
    else if (down) context.lineTo(x, y);
    penX = x;
    penY = y;
    down = true;
  }
}
