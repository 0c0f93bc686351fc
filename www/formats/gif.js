/**
 * Animations as GIF89a, looped forever. Each frame stores only the rectangle that changed, in which pixels that did not
 * change are transparent.
 */
import { nearestIn, paletteOf } from "./colours.js";
import { packCodes } from "./lzw.js";

export { paletteOf };

/** The lower byte first. @param {...number} values */
const shorts = (...values) => values.flatMap((value) => [value & 255, value >> 8]);

/** @param {string} text  ASCII */
const ascii = (text) => new TextEncoder().encode(text);

export class GifWriter {
  #width;
  #height;
  #nearest;
  /** The index of transparency: that after the last colour. */
  #clear;
  /** Bits of the index of a colour. */
  #bits = 2;
  /** @type {Uint8Array[]} */
  #parts = [];
  /** The last frame, four bytes a pixel. @type {Uint32Array | undefined} */
  #pixels;
  /** The last frame, by indices of colours. */
  #shown;
  /** Hundredths of a second that the frames so far should have lasted longer. */
  #owed = 0;

  /**
   * @param {number} width   pixels, 1 to 65535
   * @param {number} height
   * @param {Uint8Array} palette  red, green, blue in turn, 1 to 256 colours (255 leave one for transparency)
   */
  constructor(width, height, palette) {
    if (!(width > 0 && height > 0 && (width | height) < 65536))
      throw new RangeError(`A GIF cannot be ${width} x ${height} pixels.`);
    this.#width = width;
    this.#height = height;
    this.#nearest = nearestIn(palette);
    this.#clear = palette.length / 3;
    this.#shown = new Uint8Array(width * height);
    while (1 << this.#bits < Math.min(256, this.#clear + 1)) this.#bits++;
    const colours = new Uint8Array(3 << this.#bits);
    colours.set(palette);
    this.#write(
      ascii("GIF89a"),
      shorts(width, height),
      [0xef + this.#bits, 0, 0],
      colours,
      [0x21, 0xff, 11],
      ascii("NETSCAPE2.0"),
      [3, 1, 0, 0, 0],
    );
  }

  /**
   * Adds a frame, even if nothing changed.
   * @param {Uint8ClampedArray} rgba  width * height * 4, from the top left; opaque, alpha is ignored
   * @param {number} delayMs  how long it is shown; up to 655 s; rounded to 10 ms and at least 20, so that the sum stays
   *   right
   */
  add(rgba, delayMs) {
    const width = this.#width;
    const height = this.#height;
    const shown = this.#shown;
    const before = this.#pixels;
    if (rgba.length !== 4 * shown.length)
      throw new RangeError(`${width} x ${height} pixels cannot be ${rgba.length} bytes.`);
    const clear = this.#clear;
    const hides = before && clear < 256;
    const pixels = (this.#pixels = new Uint32Array(rgba.slice().buffer));
    const frame = new Uint8Array(shown.length);
    let left = before ? width : 0;
    let top = before ? height : 0;
    let right = width - left;
    let bottom = height - top;
    for (let i = 0, y = 0; y < height; y++) {
      for (let x = 0; x < width; x++, i++) {
        const number = before && before[i] === pixels[i] ? shown[i] : this.#nearest(pixels[i], rgba, 4 * i);
        frame[i] = hides && number === shown[i] ? clear : number;
        if (number === shown[i]) continue;
        shown[i] = number;
        left = Math.min(left, x);
        top = Math.min(top, y);
        right = Math.max(right, x + 1);
        bottom = Math.max(bottom, y + 1);
      }
    }
    // A frame has at least one pixel.
    if (!right) {
      left = top = 0;
      right = bottom = 1;
    }
    this.#owed += delayMs / 10;
    const delay = Math.max(2, Math.round(this.#owed));
    this.#owed -= delay;
    const part = new Uint8Array((right - left) * (bottom - top));
    for (let y = top; y < bottom; y++)
      part.set(frame.subarray(y * width + left, y * width + right), (y - top) * (right - left));
    this.#write(
      [0x21, 0xf9, 4, hides ? 5 : 4],
      shorts(delay),
      [hides ? clear : 0, 0],
      [0x2c],
      shorts(left, top, right - left, bottom - top),
      [0],
      packCodes(part, this.#bits),
    );
  }

  /** @returns {Uint8Array<ArrayBuffer>}  the file; nothing can be added after */
  finish() {
    if (!this.#pixels) throw new RangeError("A GIF needs a frame.");
    this.#write([0x3b]);
    const file = new Uint8Array(this.#parts.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of this.#parts) {
      file.set(part, at);
      at += part.length;
    }
    return file;
  }

  /** @param {...ArrayLike<number>} parts */
  #write(...parts) {
    for (const part of parts) this.#parts.push(Uint8Array.from(part));
  }
}
