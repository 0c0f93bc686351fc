/** A canvas of a sheet: its backing store has device pixels, its coordinates are CSS pixels. */

/** @typedef {OffscreenCanvas | HTMLCanvasElement} Canvas */

export class Layer {
  #context;

  /** @param {Canvas} canvas  an element is drawn on through an offscreen canvas from then on */
  constructor(canvas) {
    // A browser that rasterizes in software copies every canvas element in each frame, but offscreen canvases only when
    // they changed.
    this.canvas = "transferControlToOffscreen" in canvas ? canvas.transferControlToOffscreen() : canvas;
    const context = this.canvas.getContext("2d");
    if (!context) throw new Error("This browser gives no 2d canvas.");
    // The page draws with what both kinds of context can do, and names one of them.
    this.#context = /** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (context));
    this.width = 0;
    this.height = 0;
    this.ratio = 1;
    /** The clip of everything drawn, if any. @type {((context: CanvasRenderingContext2D) => void) | null} */
    this.clip = null;
    /** Whether the canvas has a size, and memory: the first picture need not wait for layers that are empty in it. */
    this.isReady = false;
  }

  /** The context to draw with. */
  get context() {
    this.prepare();
    return this.#context;
  }

  /**
   * Sets the size and empties the layer.
   * @param {number} width
   * @param {number} height
   * @param {number} ratio  device pixels per CSS pixel
   */
  fit(width, height, ratio) {
    Object.assign(this, { width, height, ratio, clip: null });
    if (this.isReady) this.resize();
  }

  /** Sizes the canvas, unless that is done. */
  prepare() {
    if (!this.isReady) this.resize();
  }

  /** Sizes the canvas. */
  resize() {
    const { canvas, ratio } = this;
    const size = {
      width: Math.max(1, Math.round(this.width * ratio)),
      height: Math.max(1, Math.round(this.height * ratio)),
    };
    // A canvas of the same size keeps its memory.
    if (canvas.width === size.width && canvas.height === size.height) this.#context.reset();
    else Object.assign(canvas, size);
    this.#context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.isReady = true;
    if (this.clip) this.enclose(this.clip);
  }

  /** Clips everything drawn from now on. @param {(context: CanvasRenderingContext2D) => void} clip */
  enclose(clip) {
    this.clip = clip;
    if (!this.isReady) return;
    this.#context.save();
    clip(this.#context);
  }

  /**
   * Replaces the content by a copy of this layer, pixel by pixel, or by nothing.
   * @param {OffscreenCanvas | null} copy
   */
  paste(copy) {
    if (!copy && !this.isReady) return;
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
    if (this.isReady) this.#context.clearRect(0, 0, this.width, this.height);
  }
}
