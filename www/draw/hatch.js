/**
 * Diagonal lines to fill a shape with, so that a collision does not differ by its colour alone. An SVG has its own.
 * @param {CanvasRenderingContext2D} context @param {string} colour @param {number} ratio  device pixels a CSS pixel
 */
export function hatch(context, colour, ratio) {
  const { stripes } = /** @type {{ stripes?: (colour: string) => CanvasPattern }} */ (/** @type {unknown} */ (context));
  if (stripes) return stripes(colour);
  const size = Math.max(4, Math.round(7 * ratio));
  const tile = new OffscreenCanvas(size, size);
  const ink = tile.getContext("2d");
  if (!ink) return null;
  ink.strokeStyle = colour;
  ink.lineWidth = 1.5 * ratio;
  ink.beginPath();
  for (const shift of [-size, 0, size]) {
    ink.moveTo(shift - size / 2, 1.5 * size);
    ink.lineTo(shift + 1.5 * size, -size / 2);
  }
  ink.stroke();
  const pattern = context.createPattern(tile, "repeat");
  pattern?.setTransform(new DOMMatrix().scale(1 / ratio));
  return pattern;
}
