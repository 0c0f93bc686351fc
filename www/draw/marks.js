/**
 * Small marks on a canvas, at a point in CSS pixels: each has its own shape, so that it does not differ by its colour
 * alone.
 */

/** @import { Palette } from "../app/palette.js" */

const TURN = 2 * Math.PI;

/**
 * Sets how lines are drawn.
 * @param {CanvasRenderingContext2D} context
 * @param {string} colour
 * @param {number} width
 * @param {number[]} [dash]
 */
export function setStroke(context, colour, width, dash = []) {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dash);
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} radius */
export function disc(context, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius, 0, TURN);
  context.fill();
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} radius */
export function ring(context, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius, 0, TURN);
  context.stroke();
}

/**
 * Adds a line to the path.
 * @param {CanvasRenderingContext2D} context
 * @param {number} x0
 * @param {number} y0
 * @param {number} x1
 * @param {number} y1
 */
export function addLine(context, x0, y0, x1, y1) {
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} x0
 * @param {number} y0
 * @param {number} x1
 * @param {number} y1
 */
export function drawLine(context, x0, y0, x1, y1) {
  context.beginPath();
  addLine(context, x0, y0, x1, y1);
  context.stroke();
}

/**
 * Adds a diagonal cross to the path.
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {number} arm  half of its width
 */
export function addCross(context, x, y, arm) {
  addLine(context, x - arm, y - arm, x + arm, y + arm);
  addLine(context, x - arm, y + arm, x + arm, y - arm);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {number} arm  half of its width
 */
export function cross(context, x, y, arm) {
  context.beginPath();
  addCross(context, x, y, arm);
  context.stroke();
}

/**
 * A configuration as a disc with a rim.
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {string} colour
 * @param {Palette} palette
 */
export function drawDot(context, x, y, colour, palette) {
  context.fillStyle = colour;
  setStroke(context, palette.stage, 2);
  disc(context, x, y, 6.5);
  context.stroke();
}

/**
 * A reference point: a small dot with a rim.
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {Palette} palette
 */
export function drawReference(context, x, y, palette) {
  context.fillStyle = palette.stage;
  disc(context, x, y, 4.4);
  context.fillStyle = palette.growth;
  disc(context, x, y, 3);
}

/**
 * A ring to drag.
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {string} colour
 * @param {Palette} palette
 */
export function drawHandle(context, x, y, colour, palette) {
  context.fillStyle = palette.stage;
  disc(context, x, y, 8);
  context.fillStyle = colour;
  setStroke(context, colour, 2.4);
  ring(context, x, y, 6.6);
  disc(context, x, y, 2.4);
}

/**
 * An upright cross with a halo.
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {string} colour
 * @param {Palette} palette
 * @param {number} size
 */
export function drawCross(context, x, y, colour, palette, size) {
  strokeWithHalo(context, [5.5, 2.2], colour, palette, () => {
    addLine(context, x - size, y, x + size, y);
    addLine(context, x, y - size, x, y + size);
  });
}

/**
 * Strokes a path twice, wide in the colour of the stage and then narrow, so that it can be seen on anything.
 * @param {CanvasRenderingContext2D} context
 * @param {[wide: number, narrow: number]} widths
 * @param {string} colour
 * @param {Palette} palette
 * @param {() => void} trace  adds to the path
 */
export function strokeWithHalo(context, [wide, narrow], colour, palette, trace) {
  context.lineCap = "round";
  for (const [width, style] of /** @type {[number, string][]} */ ([
    [wide, palette.stage],
    [narrow, colour],
  ])) {
    setStroke(context, style, width);
    context.beginPath();
    trace();
    context.stroke();
  }
}
