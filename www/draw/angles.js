/** The marks along the sides of a square of coordinates, and the names of the coordinates. */
import { drawLine } from "./marks.js";

/** @import { Coordinate } from "../domain/types.js" */
/** @import { View } from "planarium/draw" */

/** The room that marks and names need around the square, CSS pixels. @param {number} scale  of the words */
export const marginOf = (scale) => ({ left: 34 * scale, right: 12 * scale, top: 12 * scale, bottom: 32 * scale });

/** @param {Coordinate} coordinate */
function titleOf({ name, unit }) {
  return unit === "m" ? `${name} (m)` : name;
}

/**
 * Draws the marks and names of both coordinates.
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {{ x: number, y: number, width: number, height: number }} square  CSS pixels
 * @param {Coordinate[]} coordinates  across and up
 * @param {number} scale  of the words
 */
export function drawAxes(context, view, { x, y, height }, [across, up], scale) {
  const bottom = y + height;
  context.lineWidth = 1;
  context.font = `${12 * scale}px system-ui, sans-serif`;
  context.textBaseline = "top";
  context.textAlign = "center";
  for (const { value, text } of ticks(across)) {
    const at = view.x(value);
    drawLine(context, at, bottom, at, bottom + 4);
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
    drawLine(context, x - 4, at, x, at);
    context.fillText(text, x - 8, at);
  }
}

/**
 * The middle of the widest gap between marks, where the name of the coordinate is written.
 * @param {Coordinate} coordinate
 */
function roomiest(coordinate) {
  const stops = [coordinate.low, ...ticks(coordinate).map(({ value }) => value), coordinate.high];
  const gaps = stops.slice(1).map((stop, i) => stop - stops[i]);
  const at = gaps.findIndex((gap) => gap > Math.max(...gaps) - 1e-9);
  return (stops[at] + stops[at + 1]) / 2;
}

/** The least part of an axis between two marks. */
const APART = 0.12;

/**
 * Marks of a coordinate. Angles: multiples of a half turn, of a turn where there are many, and the limits of a joint
 * that are not near one of them. Lengths: both ends and the middle.
 * @param {Coordinate} coordinate
 */
export function ticks({ low, high, unit: measure }) {
  const number = (/** @type {number} */ value) => ({
    value,
    text: Number(value.toPrecision(3)).toString().replace("-", "\u2212"),
  });
  if (measure === "m") return [low, (low + high) / 2, high].map(number);
  const unit = high - low > 4 * Math.PI + 0.01 ? 2 * Math.PI : Math.PI;
  const first = Math.ceil(low / unit - 1e-9);
  const turns = Array.from({ length: Math.floor(high / unit + 1e-9) - first + 1 }, (_, i) => {
    const value = (first + i) * unit;
    const count = value / Math.PI;
    return {
      value,
      text: count === 0 ? "0" : `${count < 0 ? "\u2212" : ""}${Math.abs(count) === 1 ? "" : Math.abs(count)}\u03c0`,
    };
  });
  const isFree = (/** @type {number} */ end) =>
    turns.every(({ value }) => Math.abs(value - end) > APART * (high - low));
  return [...(isFree(low) ? [number(low)] : []), ...turns, ...(isFree(high) ? [number(high)] : [])];
}
