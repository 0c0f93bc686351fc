/**
 * Copies of a growing layer, so that a jump in time starts from the nearest copy and not from an empty layer. Their
 * number is limited by their bytes: when there are too many, every other one is dropped and they are taken half as
 * often.
 */

/** @import { Layer } from "./layer.js" */

/** Marks between two copies at first. */
const SPACING = 512;
/** Bytes of the copies of one layer, and their number. */
const BYTES = 8e6;
const COPIES = { least: 2, most: 8 };

export class Snapshots {
  /** @param {Layer} layer */
  constructor(layer) {
    this.layer = layer;
    /** @type {{ count: number, canvas: OffscreenCanvas }[]} */
    this.copies = [];
    this.spacing = SPACING;
    /**
     * Canvases of dropped copies, to be used again: garbage of this size makes the browser collect it often.
     * @type {OffscreenCanvas[]}
     */
    this.spare = [];
  }

  /** Drops all copies. */
  clear() {
    this.spacing = SPACING;
    this.spare.push(...this.copies.map(({ canvas }) => canvas));
    this.copies = [];
  }

  /** Whether to copy a layer of this number of marks. @param {number} count */
  isDue(count) {
    return count >= (this.copies.at(-1)?.count ?? 0) + this.spacing;
  }

  /** Copies the layer. @param {number} count   marks that it holds */
  copy(count) {
    const { copies, layer } = this;
    const { width, height } = layer.canvas;
    const canvas = this.spare.pop() ?? new OffscreenCanvas(width, height);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const context = canvas.getContext("2d");
    if (!context) return;
    context.globalCompositeOperation = "copy";
    context.drawImage(layer.canvas, 0, 0);
    copies.push({ count, canvas });
    const most = Math.max(COPIES.least, Math.min(COPIES.most, Math.floor(BYTES / (4 * width * height))));
    if (copies.length <= most) return;
    this.copies = copies.filter((_, i) => i % 2 === 1);
    this.spare.push(...copies.filter((_, i) => i % 2 === 0).map((copy) => copy.canvas));
    this.spacing *= 2;
  }

  /** The latest copy with at most `count` marks. @param {number} count */
  best(count) {
    return this.copies.findLast((copy) => copy.count <= count);
  }

  /** Restores that copy, or an empty layer. @param {number} count @returns {number} marks that the layer holds now */
  restore(count) {
    const copy = this.best(count);
    this.layer.paste(copy?.canvas ?? null);
    return copy?.count ?? 0;
  }
}
