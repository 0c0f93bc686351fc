/**
 * A layer of a sheet that writes SVG in place of pixels. It takes the place of a canvas and is its own context;
 * coordinates are CSS pixels at any pixel ratio, which only its images have.
 */
import { SvgContext } from "../formats/svg.js";
import { bytesOf } from "./mask.js";

/** @import { Stripes } from "../formats/svg.js" */

/** Pixels of an image within an SVG, per CSS pixel. */
export const IMAGES = 2;

/** The address of an image until its bytes are known. */
const LATER = "image:";

export class SvgLayer extends SvgContext {
  /** @param {number} width @param {number} height  CSS pixels */
  constructor(width, height) {
    super(width, height);
    this.width = width;
    this.height = height;
    /** @type {(OffscreenCanvas | ImageBitmap)[]} */
    this.images = [];
  }

  // It is its own canvas. There are no device pixels, it is fitted while it is empty, and stripes take the place of a
  // pattern.
  getContext() {
    return this;
  }
  setTransform() {}
  reset() {}
  /** @param {string} colour @returns {Stripes} */
  stripes(colour) {
    return { colour };
  }

  /**
   * @param {OffscreenCanvas | ImageBitmap | { toDataURL(): string }} image
   * @param {number} x
   * @param {number} y
   * @param {number} width
   * @param {number} height @override
   */
  drawImage(image, x, y, width, height) {
    this.images.push(/** @type {OffscreenCanvas | ImageBitmap} */ (image));
    super.drawImage({ toDataURL: () => `${LATER}${this.images.length - 1};` }, x, y, width, height);
  }

  /**
   * The figure as an element of another one.
   * @param {string} name  begins its ids
   * @param {number} x
   * @param {number} y
   * @returns {Promise<string>}
   */
  async element(name, x, y) {
    const urls = await Promise.all(this.images.map(dataUrl));
    return this.toString()
      .replaceAll(/(\bid="|url\(#)/g, `$1${name}-`)
      .replaceAll(new RegExp(`${LATER}(\\d+);`, "g"), (_, index) => urls[Number(index)])
      .replaceAll(/color-mix\([^"]*\)/g, (colour) => `rgb(${bytesOf(colour).join(", ")})`)
      .replace("<svg ", `<svg x="${x}" y="${y}" `);
  }
}

/**
 * A drawing with further elements on top, as a file.
 * @param {SvgContext} drawing
 * @param {string[]} elements
 * @param {{ background: string, title: string }} style
 */
export function svgFile(drawing, elements, style) {
  return new Blob([drawing.toString(style).replace("</svg>", () => `${elements.join("")}</svg>`)], {
    type: "image/svg+xml",
  });
}

/** @param {OffscreenCanvas | ImageBitmap} image @returns {Promise<string>} */
async function dataUrl(image) {
  const canvas = image instanceof OffscreenCanvas ? image : new OffscreenCanvas(image.width, image.height);
  if (canvas !== image) canvas.getContext("2d")?.drawImage(image, 0, 0);
  const bytes = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
  let text = "";
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return `data:image/png;base64,${btoa(text)}`;
}
