/** Words beside their marks, apart from each other, from the marks and from the border. */
import { drawLine, setStroke } from "./marks.js";
import { drawLabel } from "./shapes.js";

/** @import { Palette } from "../app/palette.js" */
/**
 * @typedef {{ text: string, x: number, y: number, colour: string, isHere?: boolean }} Label   beside the mark at a
 *   place, CSS pixels; or at the place itself
 */
/** @typedef {{ x: number, y: number, across: number, up: number }} Box   half of its sides */

/** Half the size of a letter and of a line, CSS pixels, where the scale of words is 1. */
const LETTER = 4.5;
const LINE = 8;
/** Distances from the mark; a label farther away than the first has a line to it. */
const DISTANCES = [12, 22, 34, 48, 64, 82];
/** Distances from the place of the label itself. */
const SHIFTS = [0, 2 * LINE, 3 * LINE, 4 * LINE, 6 * LINE];
/** Directions, from above on. */
const TURNS = [0, 1, -1, 2, -2, 3, -3, 4].map((eighth) => (eighth * Math.PI) / 4);

/**
 * Draws labels, the first ones nearest to their marks.
 * @param {CanvasRenderingContext2D} context
 * @param {Label[]} labels
 * @param {Palette} palette
 * @param {{ width: number, height: number, bold: number }} area  CSS pixels, and the scale of words
 * @param {[x: number, y: number, radius: number][]} [marks]  to be kept free
 */
export function drawLabels(context, labels, palette, { width, height, bold }, marks = []) {
  /** @type {Box[]} */
  const taken = marks.map(([x, y, radius]) => ({ x, y, across: radius, up: radius }));
  const placed = labels.map((label) => {
    const size = { across: bold * LETTER * label.text.length + 1, up: bold * LINE };
    /** @type {(Box & { isFar: boolean })[]} */
    const offers = (label.isHere ? SHIFTS : DISTANCES).flatMap((distance, i) => {
      const far = bold * distance;
      return TURNS.map((turn) => ({
        ...size,
        x: label.x + (far + size.across - bold * LETTER) * Math.sin(turn),
        y: label.y - far * Math.cos(turn),
        isFar: i > 0 && !label.isHere,
      }));
    });
    const isInside = (/** @type {Box} */ { x, y, across, up }) =>
      x >= across && x <= width - across && y >= up && y <= height - up;
    const box = offers.find((one) => isInside(one) && !taken.some((other) => overlaps(one, other))) ?? offers[0];
    taken.push(box);
    return { ...label, box };
  });
  for (const { x, y, colour, box } of placed) {
    if (!box.isFar) continue;
    setStroke(context, colour, 1);
    drawLine(context, x, y, box.x, box.y);
  }
  for (const { text, colour, box } of placed) drawLabel(context, text, box.x, box.y, colour, palette, bold);
}

/** @param {Box} one @param {Box} other */
function overlaps(one, other) {
  return Math.abs(one.x - other.x) < one.across + other.across && Math.abs(one.y - other.y) < one.up + other.up;
}
