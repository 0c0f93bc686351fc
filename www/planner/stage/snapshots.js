/**
 * Copies of a growing layer, taken now and then, so that going to another time inks from the nearest copy and not from
 * nothing. Few are kept, by their bytes; when there are too many every other one goes and they are taken half as often.
 */

/** @import { Layer } from "../../draw/layer.js" */

/** Marks between two copies at first. */
const SPACING = 512;
/** Bytes of one layer's copies, and how many there may be. */
const BYTES = 8e6;
const COPIES = { least: 2, most: 8 };

export class Snapshots {
  /** @param {Layer} layer */
  constructor(layer) {
    this.layer = layer;
    /** @type {{ count: number, canvas: OffscreenCanvas }[]} */
    this.copies = [];
    this.spacing = SPACING;
    /** Canvases of copies that were dropped: new ones of this size would have the browser collect garbage often. @type {OffscreenCanvas[]} */
    this.spare = [];
  }

  /** Forgets all copies. */
  clear() {
    this.spacing = SPACING;
    this.spare.push(...this.copies.map(({ canvas }) => canvas));
    this.copies = [];
  }

  /** Is it time for a copy, when the layer holds so many marks? @param {number} count */
  isDue(count) { return count >= (this.copies.at(-1)?.count ?? 0) + this.spacing; }

  /** Copies the layer, which holds its first `count` marks. @param {number} count */
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

  /** The copy nearest to a time, of those with at most `count` marks. @param {number} count */
  best(count) { return this.copies.findLast((copy) => copy.count <= count); }

  /** Puts that copy back, or nothing. @param {number} count @returns {number} how many marks the layer holds now */
  restore(count) {
    const copy = this.best(count);
    this.layer.paste(copy?.canvas ?? null);
    return copy?.count ?? 0;
  }
}
