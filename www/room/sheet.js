/**
 * A figure that the page draws itself: a caption, and canvases as sharp as the screen. The ground is drawn when the picture is
 * another, the top whenever something moves; both in the room's frame, once. The same drawing can be had as PNG or SVG.
 */
import { make } from "../app/dom.js";
import { hatch } from "../draw/hatch.js";
import { Layer } from "../draw/layer.js";

/** @import { Stripes } from "../formats/svg.js" */
/** @import { Palette } from "../draw/palette.js" */
/** @import { Room } from "./room.js" */

/**
 * With what a sheet is drawn; lengths are CSS pixels.
 * @typedef {object} Brush
 * @property {CanvasRenderingContext2D} context
 * @property {Palette} palette
 * @property {number} width
 * @property {number} height
 * @property {number} ratio   device pixels a CSS pixel
 * @property {(colour: string) => CanvasPattern | null} hatch   diagonal lines
 */

/**
 * @typedef {object} Painting   what is drawn on a sheet
 * @property {(brush: Brush) => void} ground
 * @property {(brush: Brush) => void} top
 */

export const SHEET_LAYERS = /** @type {const} */ (["ground", "top"]);

export class Sheet {
  /**
   * @param {Room} room
   * @param {HTMLElement} host   the figure is put at its end
   * @param {{ id: string, kind: string, caption: string, note?: string }} names   `kind`: a class of the figure, such as "workspace"
   * @param {Painting} painting
   */
  constructor(room, host, { id, kind, caption, note = "" }, painting) {
    this.room = room;
    this.painting = painting;
    this.caption = make("span", {}, caption);
    this.note = make("small", {}, note);
    this.box = make("div", { className: "sheet" });
    this.figure = make("figure", { className: `pane ${kind}`, id }, make("figcaption", {}, this.caption, " ", this.note), this.box);
    const canvases = SHEET_LAYERS.map((name) => {
      const canvas = make("canvas", {});
      canvas.dataset.layer = name;
      canvas.setAttribute("aria-hidden", "true");
      this.box.append(canvas);
      return canvas;
    });
    this.layers = { ground: new Layer(canvases[0]), top: new Layer(canvases[1]) };
    /** Where pointers are heard. */
    this.canvas = canvases[1];
    this.canvas.removeAttribute("aria-hidden");
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", caption);
    this.width = 0;
    this.height = 0;
    /** @type {Palette | null} */
    this.palette = null;
    /** What is to be drawn anew. @type {Set<"ground" | "top">} */
    this.stale = new Set();
    host.append(this.figure);
    new ResizeObserver(() => this.measure()).observe(this.box);
    room.onDress(() => this.dress());
    room.onPaint(() => this.paint());
  }

  /** The ground is another, and with it the top. */
  redraw() {
    this.stale.add("ground");
    this.refresh();
  }

  /** Something on top has moved. */
  refresh() {
    this.stale.add("top");
    this.room.wake();
  }

  /** What someone who cannot see it should know. @param {string} text */
  describe(text) {
    if (this.canvas.getAttribute("aria-label") !== text) this.canvas.setAttribute("aria-label", text);
  }

  /** Shows or hides the figure. @param {boolean} isShown */
  show(isShown) { this.figure.hidden = !isShown; }

  /** Fits the canvases to their place. */
  measure() {
    const box = this.box.getBoundingClientRect();
    // Whole pixels: a canvas that is stretched by a fraction of one is blurred.
    const [width, height] = [box.width, box.height].map((side) => Math.round(side * devicePixelRatio) / devicePixelRatio);
    if (width < 1 || height < 1 || (width === this.width && height === this.height)) return;
    Object.assign(this, { width, height });
    for (const canvas of this.box.children) if (canvas instanceof HTMLElement) Object.assign(canvas.style, { width: `${width}px`, height: `${height}px` });
    this.dress();
    this.room.wake();
  }

  /** Colours, pixels or the size are others. */
  dress() {
    if (this.width < 1) return;
    const { palette, ratio } = this.room.look;
    this.palette = palette;
    for (const name of SHEET_LAYERS) {
      this.layers[name].fit(this.width, this.height, ratio);
      this.stale.add(name);
    }
  }

  /** Draws what is stale. */
  paint() {
    const { palette, stale, width, height } = this;
    if (!palette || stale.size === 0 || this.figure.hidden) return;
    for (const name of SHEET_LAYERS) {
      if (!stale.delete(name)) continue;
      const { context, ratio } = this.layers[name];
      this.layers[name].clear();
      context.save();
      this.painting[name]({ context, palette, width, height, ratio, hatch: (colour) => hatch(context, colour, ratio) });
      context.restore();
    }
  }

  /**
   * Draws all of it with another context, such as that of a drawing in lines.
   * @param {CanvasRenderingContext2D} context @param {number} ratio @param {(colour: string) => CanvasPattern | Stripes | null} hatchOf
   */
  drawWith(context, ratio, hatchOf) {
    const { palette, width, height } = this;
    if (!palette) return;
    for (const name of SHEET_LAYERS) {
      context.save();
      this.painting[name]({ context, palette, width, height, ratio, hatch: /** @type {Brush["hatch"]} */ (hatchOf) });
      context.restore();
    }
  }
}
