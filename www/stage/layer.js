/**
 * One canvas of a sheet, as sharp as the screen: its backing store has the screen's pixels, its coordinates are CSS pixels.
 * A sheet has three: the ground (drawn once a layout), the growth (only ever added to) and the top (light, redrawn each frame).
 */
export class Layer {
  /** @param {HTMLElement} parent @param {string} name */
  constructor(parent, name) {
    this.canvas = document.createElement("canvas");
    this.canvas.dataset.layer = name;
    this.canvas.setAttribute("aria-hidden", "true");
    parent.append(this.canvas);
    const context = this.canvas.getContext("2d");
    if (!context) throw new Error("This browser gives no 2d canvas.");
    this.context = context;
    this.width = 0;
    this.height = 0;
    this.ratio = 1;
  }

  /** Fits the backing store; empties the layer. @param {number} width @param {number} height @param {number} ratio  device pixels a CSS pixel */
  fit(width, height, ratio) {
    this.width = width;
    this.height = height;
    this.ratio = ratio;
    this.canvas.width = Math.max(1, Math.round(width * ratio));
    this.canvas.height = Math.max(1, Math.round(height * ratio));
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  clear() {
    this.context.clearRect(0, 0, this.width, this.height);
  }
}
