/** Many dots as one image: however many there are, it is drawn in a few milliseconds. */
import { bytesOf } from "../draw/mask.js";

/** How dark one dot is, of 255, and how much darker one on another. */
const ONE = 150;
const MORE = 45;
/** From so many dots on each is fainter. */
const MANY = 4000;

/**
 * @param {Float64Array} places  x and y in CSS pixels, in turn
 * @param {{ width: number, height: number, ratio: number, colour: string, size: number }} how  CSS pixels; `size`: of a dot
 * @returns {OffscreenCanvas}
 */
export function cloudOf(places, { width, height, ratio, colour, size }) {
  const canvas = new OffscreenCanvas(Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio)));
  const context = canvas.getContext("2d");
  if (!context) return canvas;
  const image = context.createImageData(canvas.width, canvas.height);
  const [red, green, blue] = bytesOf(colour);
  const count = places.length / 2;
  const share = Math.sqrt(Math.min(1, MANY / Math.max(1, count)));
  const [one, more] = [ONE * share, Math.max(4, MORE * share)];
  const side = Math.max(1, Math.round(size * ratio * (count > MANY ? 0.6 : 1)));
  const { data } = image;
  for (let i = 0; i < count; i++) {
    const left = Math.round(places[2 * i] * ratio - side / 2);
    const top = Math.round(places[2 * i + 1] * ratio - side / 2);
    for (let y = Math.max(0, top); y < Math.min(canvas.height, top + side); y++) {
      for (let x = Math.max(0, left); x < Math.min(canvas.width, left + side); x++) {
        const at = 4 * (y * canvas.width + x);
        data[at] = red;
        data[at + 1] = green;
        data[at + 2] = blue;
        data[at + 3] = data[at + 3] === 0 ? one : Math.min(255, data[at + 3] + more);
      }
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}
