/** The marks along the sides of a square of coordinates, and what the coordinates are called. */

/** @import { Coordinate } from "../domain/types.js" */
/** @import { View } from "./view.js" */

/** The room that marks and names need around the square, CSS pixels. */
export const MARGIN = { left: 34, right: 12, top: 12, bottom: 32 };

/** @param {CanvasRenderingContext2D} context @param {number} x0 @param {number} y0 @param {number} x1 @param {number} y1 */
export function tick(context, x0, y0, x1, y1) {
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
  context.stroke();
}

/** @param {Coordinate} coordinate */
export function titleOf({ name, unit }) { return unit === "m" ? `${name} (m)` : name; }

/** Draws the marks and names of both coordinates. @param {CanvasRenderingContext2D} context @param {View} view @param {{ x: number, y: number, width: number, height: number }} square  CSS pixels @param {Coordinate[]} coordinates  across and up @param {number} [scale]  of the words */
export function drawAxes(context, view, { x, y, height }, [across, up], scale = 1) {
  const bottom = y + height;
  context.lineWidth = 1;
  context.font = `${12 * scale}px system-ui, sans-serif`;
  context.textBaseline = "top";
  context.textAlign = "center";
  for (const { value, text } of ticks(across)) {
    const at = view.x(value);
    tick(context, at, bottom, at, bottom + 4);
    context.fillText(text, at, bottom + 7);
  }
  context.fillText(titleOf(across), view.x(roomiest(across)), bottom + 7);
  context.save();
  context.translate(x - 22 * scale, view.y(roomiest(up)));
  context.rotate(-Math.PI / 2);
  context.fillText(titleOf(up), 0, 0);
  context.restore();
  context.textBaseline = "middle";
  context.textAlign = "right";
  for (const { value, text } of ticks(up)) {
    const at = view.y(value);
    tick(context, x - 4, at, x, at);
    context.fillText(text, x - 8, at);
  }
}

/** The middle of the widest gap between marks, where the name of the coordinate is written. @param {Coordinate} coordinate */
function roomiest(coordinate) {
  const stops = [coordinate.low, ...ticks(coordinate).map(({ value }) => value), coordinate.high];
  const gaps = stops.slice(1).map((stop, i) => stop - stops[i]);
  const at = gaps.findIndex((gap) => gap > Math.max(...gaps) - 1e-9);
  return (stops[at] + stops[at + 1]) / 2;
}

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
