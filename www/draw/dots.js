/** Many dots as one image, which takes a few milliseconds however many there are. */
import { bytesOf } from "./mask.js";

/** Opacity of a dot, of 255, and of another on top of it. */
const ONE = 150;
const MORE = 45;
/** The number of dots above which each is fainter and smaller. */
const MANY = 4000;

/**
 * @param {Float64Array} places  x and y in turn, CSS pixels
 * @param {{ width: number, height: number, ratio: number, colour: string, size: number }} style  CSS pixels; `size`: of
 *   a dot
 */
export function dotsImage(places, { width, height, ratio, colour, size }) {
  const canvas = new OffscreenCanvas(Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio)));
  const context = canvas.getContext("2d");
  if (!context) return canvas;
  const image = context.createImageData(canvas.width, canvas.height);
  const { data } = image;
  const colours = bytesOf(colour);
  const count = places.length / 2;
  const strength = Math.sqrt(Math.min(1, MANY / Math.max(1, count)));
  const [one, more] = [ONE * strength, Math.max(4, MORE * strength)];
  const side = Math.max(1, Math.round(size * ratio * (count > MANY ? 0.6 : 1)));
  for (let i = 0; i < count; i++) {
    const left = Math.round(places[2 * i] * ratio - side / 2);
    const top = Math.round(places[2 * i + 1] * ratio - side / 2);
    for (let y = Math.max(0, top); y < Math.min(canvas.height, top + side); y++) {
      for (let x = Math.max(0, left); x < Math.min(canvas.width, left + side); x++) {
        const at = 4 * (y * canvas.width + x);
        for (let k = 0; k < 3; k++) data[at + k] = colours[k];
        data[at + 3] = data[at + 3] === 0 ? one : Math.min(255, data[at + 3] + more);
      }
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}
