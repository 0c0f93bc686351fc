/**
 * A canvas of a pane: its backing store has device pixels, its coordinates are CSS pixels. A pane has five: the ground, drawn once per
 * layout; edges, vertices and marks, append-only in the order of the log, so that the picture does not depend on how drawing was divided
 * into frames; the top, redrawn each frame.
 */

/** From the lowest to the highest. */
export const LAYERS = /** @type {const} */ (["ground", "edges", "vertices", "marks", "top"]);

/** @typedef {typeof LAYERS[number]} LayerName */

export class Layer {
  /** @param {OffscreenCanvas | HTMLCanvasElement} canvas  an element is drawn on through an offscreen canvas from then on */
  constructor(canvas) {
    // A browser that rasterizes in software copies every canvas element in each frame, but offscreen canvases only when they changed.
    this.canvas = "transferControlToOffscreen" in canvas ? canvas.transferControlToOffscreen() : canvas;
    const context = this.canvas.getContext("2d");
    if (!context) throw new Error("This browser gives no 2d canvas.");
    // The page draws with what both kinds of context can do, and names one of them.
    this.context = /** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (context));
    this.width = 0;
    this.height = 0;
    this.ratio = 1;
    /** What keeps the drawing inside of the picture, if anything. @type {((context: CanvasRenderingContext2D) => void) | null} */
    this.clip = null;
  }

  /** Fits the backing store; empties the layer. @param {number} width @param {number} height @param {number} ratio  device pixels a CSS pixel */
  fit(width, height, ratio) {
    this.width = width;
    this.height = height;
    this.ratio = ratio;
    const size = { width: Math.max(1, Math.round(width * ratio)), height: Math.max(1, Math.round(height * ratio)) };
    // A canvas of the same size keeps its memory.
    if (this.canvas.width === size.width && this.canvas.height === size.height) this.context.reset();
    else Object.assign(this.canvas, size);
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.clip = null;
  }

  /** From now on nothing is drawn outside of a border. @param {(context: CanvasRenderingContext2D) => void} clip */
  enclose(clip) {
    this.clip = clip;
    this.context.save();
    clip(this.context);
  }

  /** Puts a copy of this layer in place of what it holds, pixel by pixel, or nothing. @param {OffscreenCanvas | null} copy */
  paste(copy) {
    const { context, clip, canvas } = this;
    if (clip) context.restore();
    context.save();
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    if (copy) context.drawImage(copy, 0, 0);
    context.restore();
    if (clip) this.enclose(clip);
  }

  clear() {
    this.context.clearRect(0, 0, this.width, this.height);
  }
}
