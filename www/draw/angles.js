/** The marks along the sides of a square of coordinates, and what the coordinates are called. */

/** @import { Coordinate } from "../domain/types.js" */

/** @param {CanvasRenderingContext2D} context @param {number} x0 @param {number} y0 @param {number} x1 @param {number} y1 */
export function tick(context, x0, y0, x1, y1) {
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
  context.stroke();
}

/** @param {Coordinate} coordinate */
export function titleOf({ name, unit }) { return unit === "m" ? `${name} (m)` : name; }

/** Multiples of a quarter or half turn within a range of angles; of lengths, both ends and the middle where it is round. @param {Coordinate} coordinate */
export function ticks({ low, high, unit: measure }) {
  if (measure === "m") return [low, (low + high) / 2, high].map((value) => ({ value, text: Number(value.toPrecision(3)).toString().replace("-", "\u2212") }));
  const unit = high - low > 4 * Math.PI + 0.01 ? 2 * Math.PI : Math.PI;
  const marks = [];
  for (let i = Math.ceil(low / unit - 1e-9); i * unit <= high + 1e-9; i++) {
    const turns = (i * unit) / Math.PI;
    const text = turns === 0 ? "0" : `${turns < 0 ? "\u2212" : ""}${Math.abs(turns) === 1 ? "" : Math.abs(turns)}\u03c0`;
    marks.push({ value: i * unit, text });
  }
  return marks;
}
