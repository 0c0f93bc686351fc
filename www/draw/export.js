/** Figures as one PNG, SVG or film, side by side, each under its caption. */
import { SvgContext } from "../formats/svg.js";
import { contextOf, even } from "./film.js";
import { hatch } from "./hatch.js";
import { IMAGES, SvgLayer, stripes, svgFile } from "./svg-layer.js";

/** @import { Figure } from "./figure.js" */
/** @import { Film } from "./film.js" */
/** @typedef {CanvasRenderingContext2D} Context */

/** Space around and between the figures, and for a caption, CSS pixels. */
const GAP = 16;
const CAPTION = 22;
/** Pixels of an image at most: browsers limit the size of canvases. */
const MOST_PIXELS = 48e6;

/**
 * @param {number} width
 * @param {number} height
 * @param {number} ratio
 * @param {string} advice
 * @throws {Error} `too-large`
 */
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

/**
 * Draws the figures side by side.
 * @param {Context} context  of the whole image
 * @param {ReturnType<typeof layoutOf>} layout
 * @param {number} ratio  pixels a CSS pixel
 */
function compose(context, { places, ground }, ratio) {
  const {
    canvas: { width, height },
  } = context;
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.fillStyle = ground;
  context.fillRect(0, 0, width, height);
  for (const place of places) {
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    writeCaption(context, place);
    context.save();
    context.setTransform(ratio, 0, 0, ratio, place.x * ratio, place.y * ratio);
    place.figure.drawWith(context, ratio, (colour) => hatch(context, colour, ratio));
    context.restore();
  }
}

/**
 * @param {Figure[]} figures
 * @param {number} ratio  pixels a CSS pixel
 * @returns {Promise<Blob>}
 * @throws {Error} it would be too large
 */
export async function pngOf(figures, ratio) {
  const layout = layoutOf(figures);
  const { width, height } = layout;
  requireSize(width, height, ratio, "make the window smaller");
  const context = contextOf(Math.round(width * ratio), Math.round(height * ratio));
  compose(/** @type {Context} */ (/** @type {unknown} */ (context)), layout, ratio);
  return context.canvas.convertToBlob({ type: "image/png" });
}

/**
 * A film of figures, in the colours and sizes that they have now.
 * @param {Figure[]} figures @param {number} width  pixels @param {number} seconds
 * @param {(drawings: any[], part: number) => void} place   changes copies of the drawings, in the order of the figures,
 *   so that they show a part, 0 to 1
 * @returns {Film}
 */
export function filmOf(figures, width, seconds, place) {
  const drawings = figures.map(({ drawing }) => Object.create(drawing));
  const copies = figures.map((figure, i) =>
    Object.create(figure, {
      drawing: { value: drawings[i] },
      palette: { value: figure.palette },
      width: { value: figure.width },
      height: { value: figure.height },
    }),
  );
  const layout = layoutOf(copies);
  const ratio = width / layout.width;
  return {
    width,
    height: even(layout.height * ratio),
    seconds,
    draw(context, part) {
      place(drawings, part);
      compose(/** @type {Context} */ (/** @type {unknown} */ (context)), layout, ratio);
    },
  };
}

/** @param {Figure[]} figures @param {string} title @returns {Promise<Blob>} */
export async function svgOf(figures, title) {
  const { places, width, height, ground } = layoutOf(figures);
  const whole = new SvgContext(width, height);
  for (const place of places) writeCaption(/** @type {Context} */ (/** @type {unknown} */ (whole)), place);
  const elements = await Promise.all(
    places.map(({ figure, x, y }, i) => {
      const layer = new SvgLayer(Math.ceil(figure.width), Math.ceil(figure.height));
      figure.drawWith(/** @type {Context} */ (/** @type {unknown} */ (layer)), IMAGES, stripes);
      return layer.element(`s${i}`, Math.round(x), Math.round(y));
    }),
  );
  return svgFile(whole, elements, { background: ground, title });
}
