/** What the pictures share: a sheet of panes that is written as SVG, and grounds without pixels. */
import { PROPERTIES } from "../../app/palette.js";
import { hatch } from "../../draw/hatch.js";
import { SvgLayer } from "../../draw/svg-layer.js";
import { slim } from "./slim.js";

/** @import { App } from "../../app/app.js" */
/** @import { Brush } from "../../draw/figure.js" */

/** Side of a pane, pixels. */
export const SIDE = 300;
/** Cells a side of obstacles in configuration space. */
export const CELLS = 72;

/** The application, as far as a session needs one to compute. */
export const NO_APP = /** @type {App} */ (
  /** @type {unknown} */ ({ track: (/** @type {unknown} */ promise) => promise, changed() {} })
);

/** A drawing of a pane. @typedef {(brush: Brush) => void} Pane */

/**
 * Panes beside each other, four in two rows.
 * @param {Pane[]} panes @param {{ title: string, style: string }} file  `style`: the values of the colours
 * @param {{ width: number, height: number }} [pane]  its size, pixels
 * @returns {string}  an SVG file
 */
export function sheetOf(panes, { title, style }, { width, height } = { width: SIDE, height: SIDE }) {
  const columns = panes.length > 3 ? 2 : panes.length;
  const layer = new SvgLayer(columns * width, Math.ceil(panes.length / columns) * height);
  const context = /** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (layer));
  panes.forEach((draw, i) => {
    context.save();
    context.translate((i % columns) * width, Math.floor(i / columns) * height);
    draw({
      context,
      palette: PROPERTIES,
      width,
      height,
      ratio: 1,
      bold: 1,
      hatch: (colour) => hatch(context, colour, 1),
    });
    context.restore();
  });
  const file = layer.toString({ background: PROPERTIES.stage, title });
  return slim(file.replace(/(<svg[^>]*>)/, (root) => `${root}<style>${style}</style>`));
}

/**
 * Many dots as one path.
 * @param {CanvasRenderingContext2D} context
 * @param {Iterable<[x: number, y: number]>} places
 * @param {string} colour
 * @param {number} size  pixels
 * @param {number} alpha
 */
export function drawDots(context, places, colour, size, alpha) {
  context.save();
  context.globalAlpha = alpha;
  context.strokeStyle = colour;
  context.lineWidth = size;
  context.lineCap = "round";
  context.setLineDash([]);
  context.beginPath();
  for (const [x, y] of places) {
    context.moveTo(x, y);
    context.lineTo(x, y);
  }
  context.stroke();
  context.restore();
}

/** Items at equal distances in a list. @template T @param {T[]} list @param {number} most @returns {T[]} */
export function thinned(list, most) {
  return list.length <= most
    ? list
    : Array.from({ length: most }, (_, i) => list[Math.floor((i * list.length) / most)]);
}
