/** A room's sheets as a picture, or as a drawing in lines: side by side as they stand, each under its caption. */
import { SvgContext } from "../formats/svg.js";
import { hatch } from "../draw/hatch.js";
import { Figure, stripes } from "../planner/export/svg-layer.js";

/** @import { Sheet } from "./sheet.js" */
/** @typedef {CanvasRenderingContext2D} Context */

/** Room about and between the sheets, and for a caption, CSS pixels. */
const GAP = 16;
const CAPTION = 22;
/** Pixels of a picture at most: some browsers give no more. */
const MOST_PIXELS = 48e6;
/** Pixels of an image within lines, a CSS pixel. */
const IMAGES = 2;

/** Those that are shown, with their places. @param {Sheet[]} sheets */
function layoutOf(sheets) {
  let width = GAP;
  let height = 0;
  const places = sheets.filter(({ figure, palette }) => !figure.hidden && palette).map((sheet) => {
    const place = { sheet, x: width, y: GAP + CAPTION };
    width += sheet.width + GAP;
    height = Math.max(height, sheet.height);
    return place;
  });
  return { places, width: Math.ceil(width), height: Math.ceil(height + 2 * GAP + CAPTION) };
}

/** @param {Context} context @param {ReturnType<typeof layoutOf>["places"][number]} place */
function writeCaption(context, { sheet, x, y }) {
  context.font = "13px system-ui, sans-serif";
  context.textBaseline = "alphabetic";
  context.textAlign = "left";
  context.fillStyle = sheet.palette?.ink ?? "";
  context.fillText(sheet.caption.textContent ?? "", x, y - 8);
}

/** @param {Sheet[]} sheets @param {number} ratio  pixels a CSS pixel @returns {Promise<Blob>} @throws {Error} it would be too large */
export async function pictureOf(sheets, ratio) {
  const { places, width, height } = layoutOf(sheets);
  if (width * height * ratio * ratio > MOST_PIXELS) {
    throw Object.assign(new Error(`A picture of ${Math.round(width * ratio)} x ${Math.round(height * ratio)} pixels is too large; choose a smaller one.`), { code: "too-large" });
  }
  const canvas = new OffscreenCanvas(Math.round(width * ratio), Math.round(height * ratio));
  const context = /** @type {Context | null} */ (/** @type {unknown} */ (canvas.getContext("2d")));
  if (!context) throw new Error("This browser gives no 2d canvas.");
  context.fillStyle = places[0]?.sheet.palette?.stage ?? "";
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.fillRect(0, 0, width, height);
  for (const place of places) {
    writeCaption(context, place);
    context.save();
    context.setTransform(ratio, 0, 0, ratio, place.x * ratio, place.y * ratio);
    place.sheet.drawWith(context, ratio, (colour) => hatch(context, colour, ratio));
    context.restore();
  }
  return canvas.convertToBlob({ type: "image/png" });
}

/** @param {Sheet[]} sheets @param {string} title @returns {Promise<Blob>} */
export async function drawingOf(sheets, title) {
  const { places, width, height } = layoutOf(sheets);
  const whole = new SvgContext(width, height);
  for (const place of places) writeCaption(/** @type {Context} */ (/** @type {unknown} */ (whole)), place);
  const elements = await Promise.all(places.map(({ sheet, x, y }, i) => {
    const figure = new Figure(Math.ceil(sheet.width), Math.ceil(sheet.height));
    sheet.drawWith(/** @type {Context} */ (/** @type {unknown} */ (figure)), IMAGES, stripes);
    return figure.element(`s${i}`, Math.round(x), Math.round(y));
  }));
  const text = whole.toString({ background: places[0]?.sheet.palette?.stage ?? "", title });
  return new Blob([text.replace("</svg>", () => `${elements.join("")}</svg>`)], { type: "image/svg+xml" });
}
