/** A mask of cells, 1 for collision, as an image with round edges: the obstacles in the configuration space. */

/** @import { Palette } from "../app/palette.js" */

/**
 * Smooths a mask of cells: each becomes the weighted mean of its neighbourhood.
 * @param {Uint8Array} bytes
 * @param {number} side
 */
export function soften(bytes, side) {
  // Each pass averages along the rows and transposes; two make a square neighbourhood.
  const pass = (/** @type {ArrayLike<number>} */ cells) => {
    const means = new Float32Array(side * side);
    for (let i = 0; i < means.length; i++) {
      const at = Math.floor(i / side);
      const row = side * (i % side);
      means[i] = (cells[row + Math.max(0, at - 1)] + 2 * cells[row + at] + cells[row + Math.min(side - 1, at + 1)]) / 4;
    }
    return means;
  };
  return pass(pass(bytes));
}

/**
 * The mask as an image in device pixels: filled where more than half is collision, with a fine edge.
 * @param {Float32Array} mask  rows from the lowest angles
 * @param {number} side @param {number} width @param {number} height  device pixels
 * @param {Palette} palette
 */
export function paint(mask, side, width, height, palette) {
  const canvas = new OffscreenCanvas(Math.max(1, width), Math.max(1, height));
  const context = canvas.getContext("2d");
  if (!context) return canvas;
  const image = context.createImageData(canvas.width, canvas.height);
  const inner = bytesOf(palette.obstacle);
  const edge = bytesOf(palette.obstacleEdge);
  // Also in a small image the inside of an obstacle has its colour.
  const cell = Math.max(1.4, Math.min(width, height) / side);
  const pixels = image.data;
  for (let py = 0; py < canvas.height; py++) {
    const gy = Math.min(side - 1, Math.max(0, (1 - (py + 0.5) / canvas.height) * side - 0.5));
    const r0 = Math.floor(gy);
    const r1 = Math.min(side - 1, r0 + 1);
    const fy = gy - r0;
    for (let px = 0; px < canvas.width; px++) {
      const gx = Math.min(side - 1, Math.max(0, ((px + 0.5) / canvas.width) * side - 0.5));
      const c0 = Math.floor(gx);
      const c1 = Math.min(side - 1, c0 + 1);
      const fx = gx - c0;
      const low = mask[r0 * side + c0] * (1 - fx) + mask[r0 * side + c1] * fx;
      const high = mask[r1 * side + c0] * (1 - fx) + mask[r1 * side + c1] * fx;
      const depth = (low * (1 - fy) + high * fy - 0.42) * cell * 2.4 + 0.5;
      if (depth <= 0) continue;
      const rim = Math.min(1, Math.max(0, (depth - 1.2) / 1.2));
      const at = 4 * (py * canvas.width + px);
      for (let k = 0; k < 3; k++) pixels[at + k] = edge[k] * (1 - rim) + inner[k] * rim;
      pixels[at + 3] = 255 * Math.min(1, depth);
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}

/** Red, green and blue of a resolved CSS colour. @param {string} colour @returns {[number, number, number]} */
export function bytesOf(colour) {
  const canvas = new OffscreenCanvas(1, 1);
  const context = canvas.getContext("2d");
  if (!context) return [0, 0, 0];
  context.fillStyle = colour;
  context.fillRect(0, 0, 1, 1);
  const [r, g, b] = context.getImageData(0, 0, 1, 1).data;
  return [r, g, b];
}
