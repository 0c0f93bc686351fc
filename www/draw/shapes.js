/** Ghosts, parts in collision, start, goal and other marks, in CSS pixels. */
import { isThin, partPath } from "planarium/draw";
import { addCross, addLine, setStroke, strokeWithHalo } from "./marks.js";

/** @import { View } from "planarium/draw" */
/** @import { Part } from "../domain/types.js" */
/** @import { Palette } from "../app/palette.js" */
/** @typedef {CanvasRenderingContext2D} Context */

/**
 * A configuration as an outline.
 * @param {Context} context
 * @param {View} view
 * @param {Part[]} parts
 * @param {{ colour: string, fill: number, stroke: number, dash: number[], width: number }} style
 */
export function drawGhost(context, view, parts, { colour, fill, stroke, dash, width }) {
  context.save();
  context.lineCap = "round";
  setStroke(context, colour, width, dash);
  for (const part of parts) {
    partPath(context, view, part);
    if (!isThin(view, part) || part.type === "disc") fillWith(context, colour, fill);
    context.globalAlpha = stroke;
    context.stroke();
  }
  context.restore();
}

/**
 * The margin of a robot around its parts, as a faint band.
 * @param {Context} context
 * @param {View} view
 * @param {Part[]} parts
 * @param {number | undefined} margin  metres
 * @param {string} colour
 */
export function drawMargin(context, view, parts, margin, colour) {
  if (!margin) return;
  context.save();
  context.lineCap = context.lineJoin = "round";
  context.globalAlpha = 0.16;
  setStroke(context, colour, 2 * margin * view.scaleX);
  for (const part of parts) {
    partPath(context, view, part);
    context.stroke();
  }
  context.restore();
}

/**
 * Parts in collision, red and hatched.
 * @param {Context} context
 * @param {View} view
 * @param {Part[]} parts
 * @param {Palette} palette
 * @param {CanvasPattern | null} hatch
 */
export function drawTouchingParts(context, view, parts, palette, hatch) {
  context.save();
  context.lineCap = "round";
  for (const part of parts) {
    const isLine = part.type === "capsule" && isThin(view, part);
    partPath(context, view, part);
    if (!isLine) for (const style of [palette.collision, hatch]) fillWith(context, style);
    setStroke(context, palette.collision, isLine ? 5 : 1.6);
    context.stroke();
    if (!isLine) continue;
    setStroke(context, palette.stage, 2, [1, 6]);
    context.stroke();
  }
  context.restore();
}

/**
 * Fills the path with a colour, or with a pattern where the browser has made one.
 * @param {Context} context
 * @param {string | CanvasPattern | null} style
 * @param {number} [alpha]
 */
export function fillWith(context, style, alpha = 1) {
  if (!style) return;
  context.globalAlpha = alpha;
  context.fillStyle = style;
  context.fill();
  context.globalAlpha = 1;
}

/** The start, a ring. @param {Context} context @param {number} x @param {number} y @param {Palette} palette */
export function drawStart(context, x, y, palette) {
  drawEnd(context, palette.start, palette, (isInner) => {
    context.beginPath();
    context.arc(x, y, isInner ? 2.3 : 6.5, 0, 2 * Math.PI);
  });
}

/**
 * The end of a motion that ends elsewhere than at its goal.
 * @param {Context} context
 * @param {number} x
 * @param {number} y
 * @param {Palette} palette
 * @param {number} scale  of the words
 */
export function drawEndsHere(context, x, y, palette, scale) {
  strokeWithHalo(context, [5.5, 2.4], palette.rejected, palette, () => addCross(context, x, y, 6));
  drawLabel(context, "ends here", x, y + 6 + 13 * scale, palette.rejected, palette, scale);
}

/** @param {Context} context @param {number} x @param {number} y @param {number} radius */
export function addDiamond(context, x, y, radius) {
  context.beginPath();
  context.moveTo(x, y - radius);
  context.lineTo(x + radius, y);
  context.lineTo(x, y + radius);
  context.lineTo(x - radius, y);
  context.closePath();
}

/** The goal, a diamond. @param {Context} context @param {number} x @param {number} y @param {Palette} palette */
export function drawGoal(context, x, y, palette) {
  drawEnd(context, palette.goal, palette, (isInner) => {
    addDiamond(context, x, y, isInner ? 3 : 8.2);
  });
}

/**
 * An outline with a dot of the same shape in it.
 * @param {Context} context
 * @param {string} colour
 * @param {Palette} palette
 * @param {(isInner: boolean) => void} trace
 */
function drawEnd(context, colour, palette, trace) {
  context.save();
  context.lineJoin = "round";
  context.fillStyle = palette.stage;
  setStroke(context, colour, 2.4);
  trace(false);
  context.fill();
  context.stroke();
  context.fillStyle = colour;
  trace(true);
  context.fill();
  context.restore();
}

/**
 * The first collision of a motion, a cross in a ring.
 * @param {Context} context
 * @param {number} x
 * @param {number} y
 * @param {Palette} palette
 */
export function drawHit(context, x, y, palette) {
  context.save();
  strokeWithHalo(context, [6, 2.4], palette.collision, palette, () => {
    context.arc(x, y, 9, 0, 2 * Math.PI);
    addCross(context, x, y, 4);
  });
  context.restore();
}

/**
 * The target of an end effector, a ring with four strokes and a line in the direction of the last link.
 * @param {Context} context
 * @param {number} x
 * @param {number} y
 * @param {number | undefined} orientation
 * @param {Palette} palette
 */
export function drawTarget(context, x, y, orientation, palette) {
  context.save();
  strokeWithHalo(context, [5, 2], palette.goal, palette, () => {
    context.arc(x, y, 12, 0, 2 * Math.PI);
    for (const [dx, dy] of [
      [1, 0],
      [0, 1],
      [-1, 0],
      [0, -1],
    ])
      addLine(context, x + 9 * dx, y + 9 * dy, x + 17 * dx, y + 17 * dy);
    if (orientation !== undefined)
      addLine(context, x, y, x + 32 * Math.cos(orientation), y - 32 * Math.sin(orientation));
  });
  context.restore();
}

/**
 * A word with a halo.
 * @param {Context} context
 * @param {string} text
 * @param {number} x
 * @param {number} y
 * @param {string} colour
 * @param {Palette} palette
 * @param {number} scale  of the words
 */
export function drawLabel(context, text, x, y, colour, palette, scale) {
  context.save();
  context.font = `600 ${13 * scale}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  setStroke(context, palette.stage, 4);
  context.strokeText(text, x, y);
  context.fillStyle = colour;
  context.fillText(text, x, y);
  context.restore();
}
