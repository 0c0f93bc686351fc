/** An SVG element of the page as a file of its own, SVG or PNG. */
import { makeSvg } from "../app/dom.js";

/**
 * A copy that stands alone.
 * @param {SVGSVGElement} picture
 * @param {string} ground  the colour behind it
 * @param {string} title
 */
function copyOf(picture, ground, title) {
  const copy = /** @type {SVGSVGElement} */ (picture.cloneNode(true));
  const [width, height] = ["width", "height"].map((name) => Number(picture.getAttribute(name)));
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.style.fontFamily = "system-ui, sans-serif";
  copy.setAttribute("color", getComputedStyle(picture).color);
  copy.prepend(makeSvg("title", {}, title), makeSvg("rect", { width, height, fill: ground }));
  return { text: new XMLSerializer().serializeToString(copy), width, height };
}

/** An image to be drawn at any size. @param {string} svg */
export async function decoded(svg) {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
  await image.decode();
  return image;
}

/** @param {SVGSVGElement} picture @param {string} ground @param {string} title */
export function svgPicture(picture, ground, title) {
  return new Blob([copyOf(picture, ground, title).text], { type: "image/svg+xml" });
}

/**
 * @param {SVGSVGElement} picture
 * @param {string} ground
 * @param {string} title
 * @param {number} ratio  pixels a CSS pixel
 * @returns {Promise<Blob>}
 */
export async function pngPicture(picture, ground, title, ratio) {
  const { text, width, height } = copyOf(picture, ground, title);
  const image = await decoded(text);
  const canvas = new OffscreenCanvas(Math.round(width * ratio), Math.round(height * ratio));
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  return canvas.convertToBlob({ type: "image/png" });
}
