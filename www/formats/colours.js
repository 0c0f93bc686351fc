/**
 * A palette for images of many colours: the most frequent ones exactly, the others by splitting groups where they
 * differ most.
 */

/** Different colours counted, at most; line drawings have far fewer. */
const COUNTED = 1 << 18;

/** @typedef {[red: number, green: number, blue: number, pixels: number]} Colour */

/** A group of colours, replaced by its mean. @param {Colour[]} colours  one or more */
function groupOf(colours) {
  const sum = (/** @type {(colour: Colour) => number} */ value) =>
    colours.reduce((total, colour) => total + value(colour) * colour[3], 0);
  const mean = [0, 1, 2].map((axis) => sum((colour) => colour[axis]) / sum(() => 1));
  const errors = mean.map((middle, axis) => sum((colour) => (colour[axis] - middle) ** 2));
  const error = Math.max(...errors);
  return { colours, mean, error, axis: errors.indexOf(error) };
}

/**
 * @param {readonly Uint8ClampedArray[]} frames  rows of red, green, blue, alpha; alpha is ignored
 * @param {number} [most]  colours, 2 to 256
 * @returns {Uint8Array}   red, green and blue in turn; exact where the frames have no more than `most` colours
 */
export function paletteOf(frames, most = 255) {
  /** @type {Map<number, Colour>} */
  const counts = new Map();
  for (const rgba of frames) {
    for (let i = 0; i < rgba.length; i += 4) {
      const key = (rgba[i] << 16) | (rgba[i + 1] << 8) | rgba[i + 2];
      const colour = counts.get(key);
      if (colour) colour[3]++;
      else if (counts.size < COUNTED) counts.set(key, [rgba[i], rgba[i + 1], rgba[i + 2], 1]);
    }
  }
  const others = [...counts.values()].sort((a, b) => b[3] - a[3]);
  const groups = others.splice(0, most >> 1).map((colour) => groupOf([colour]));
  if (others.length > 0) groups.push(groupOf(others));
  while (groups.length < most) {
    const [{ colours, mean, error, axis }] = groups.sort((a, b) => b.error - a.error);
    if (error === 0) break;
    groups.splice(
      0,
      1,
      ...[true, false].map((isLow) => groupOf(colours.filter((colour) => colour[axis] <= mean[axis] === isLow))),
    );
  }
  return Uint8Array.from(groups.flatMap(({ mean }) => mean.map(Math.round)));
}

/**
 * @param {Uint8Array} palette
 * @returns {(pixel: number, rgba: Uint8ClampedArray, at: number) => number}  the index of the colour nearest to the one
 *   at a place; `pixel` is its four bytes
 */
export function nearestIn(palette) {
  /** @type {Map<number, number>} */
  const known = new Map();
  return (pixel, rgba, at) => {
    let best = known.get(pixel);
    if (best !== undefined) return best;
    best = 0;
    let least = Infinity;
    for (let i = 0; i < palette.length; i += 3) {
      const distance =
        (rgba[at] - palette[i]) ** 2 + (rgba[at + 1] - palette[i + 1]) ** 2 + (rgba[at + 2] - palette[i + 2]) ** 2;
      if (distance < least) {
        least = distance;
        best = i / 3;
      }
    }
    known.set(pixel, best);
    return best;
  };
}
