/** Figures as one PNG or SVG, side by side, each under its caption. */
import { SvgContext } from "../formats/svg.js";
import { hatch } from "./hatch.js";
import { IMAGES, SvgLayer, stripes, svgFile } from "./svg-layer.js";

/** @import { Figure } from "./figure.js" */
/** @typedef {CanvasRenderingContext2D} Context */

/** Space around and between the figures, and for a caption, CSS pixels. */
const GAP = 16;
const CAPTION = 22;
/** Pixels of an image at most: browsers limit the size of canvases. */
const MOST_PIXELS = 48e6;

/** @param {number} width @param {number} height @param {number} ratio @param {string} advice @throws {Error} `too-large` */
export function requireSize(width, height, ratio, advice) {
  if (width * height * ratio * ratio <= MOST_PIXELS) return;
  const message = `An image of ${Math.round(width * ratio)} x ${Math.round(height * ratio)} pixels is too large; ${advice}.`;
  throw Object.assign(new Error(message), { code: "too-large" });
}

/** The places of the figures that are shown. @param {Figure[]} figures */
function layoutOf(figures) {
  const shown = figures.filter(({ element }) => !element.hidden);
  let width = GAP;
  const places = shown.map((figure) => {
    const x = width;
    width += figure.width + GAP;
    return { figure, x, y: GAP + CAPTION };
  });
  const height = Math.max(...shown.map((figure) => figure.height)) + 2 * GAP + CAPTION;
  return { places, width: Math.ceil(width), height: Math.ceil(height), ground: shown[0].palette.stage };
}

/** @param {Context} context @param {ReturnType<typeof layoutOf>["places"][number]} place */
function writeCaption(context, { figure, x, y }) {
  context.font = "13px system-ui, sans-serif";
  context.textBaseline = "alphabetic";
  context.textAlign = "left";
  context.fillStyle = figure.palette.ink;
  context.fillText(figure.caption.textContent ?? "", x, y - 8);
}

/** @param {Figure[]} figures @param {number} ratio  pixels a CSS pixel @returns {Promise<Blob>} @throws {Error} it would be too large */
export async function pngOf(figures, ratio) {
  const { places, width, height, ground } = layoutOf(figures);
  requireSize(width, height, ratio, "make the window smaller");
  const canvas = new OffscreenCanvas(Math.round(width * ratio), Math.round(height * ratio));
  const context = /** @type {Context | null} */ (/** @type {unknown} */ (canvas.getContext("2d")));
  if (!context) throw new Error("This browser has no 2d canvas.");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.fillStyle = ground;
  context.fillRect(0, 0, width, height);
  for (const place of places) {
    writeCaption(context, place);
    context.save();
    context.setTransform(ratio, 0, 0, ratio, place.x * ratio, place.y * ratio);
    place.figure.drawWith(context, ratio, (colour) => hatch(context, colour, ratio));
    context.restore();
  }
  return canvas.convertToBlob({ type: "image/png" });
}

/** @param {Figure[]} figures @param {string} title @returns {Promise<Blob>} */
export async function svgOf(figures, title) {
  const { places, width, height, ground } = layoutOf(figures);
  const whole = new SvgContext(width, height);
  for (const place of places) writeCaption(/** @type {Context} */ (/** @type {unknown} */ (whole)), place);
  const elements = await Promise.all(places.map(({ figure, x, y }, i) => {
    const layer = new SvgLayer(Math.ceil(figure.width), Math.ceil(figure.height));
    figure.drawWith(/** @type {Context} */ (/** @type {unknown} */ (layer)), IMAGES, stripes);
    return layer.element(`s${i}`, Math.round(x), Math.round(y));
  }));
  return svgFile(whole, elements, { background: ground, title });
}
