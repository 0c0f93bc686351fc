/**
 * A figure: a caption and two canvases in the resolution of the screen. The ground is drawn when the scene changes, the
 * top when something moves, each at most once a frame. The same drawing can be exported as PNG or SVG.
 */
import { View } from "planarium/draw";
import { make } from "../app/dom.js";
import { hatch } from "./hatch.js";
import { Layer } from "./layer.js";

/** @import { App } from "../app/app.js" */
/** @import { Stripes } from "../formats/svg.js" */
/** @import { Palette } from "../app/palette.js" */

/**
 * What a figure is drawn with; lengths are CSS pixels.
 * @typedef {object} Brush
 * @property {CanvasRenderingContext2D} context
 * @property {Palette} palette
 * @property {number} width
 * @property {number} height
 * @property {number} ratio   device pixels a CSS pixel
 * @property {(colour: string) => CanvasPattern | null} hatch   diagonal lines
 */

/** The contents of a figure. @typedef {{ ground: (brush: Brush) => void, top?: (brush: Brush) => void }} Drawing */

/** The view of a figure that is not drawn yet. */
export const NO_VIEW = new View({ min: [0, 0], max: [1, 1] }, 1, 1);

const LAYERS = /** @type {const} */ (["ground", "top"]);

/** @template {Drawing} [D=Drawing] */
export class Figure {
  /**
   * @param {App} app
   * @param {HTMLElement} host   the figure is appended
   * @param {{ id: string, kind: string, caption: string, note?: string }} names   `kind`: a class of the figure, such
   *   as "workspace"
   * @param {D} drawing
   */
  constructor(app, host, { id, kind, caption, note = "" }, drawing) {
    this.app = app;
    this.drawing = drawing;
    this.caption = make("span", {}, caption);
    this.note = make("small", {}, note);
    const ground = make("canvas", { ariaHidden: "true", dataset: { layer: "ground" } });
    const top = make("canvas", { role: "img", ariaLabel: caption, dataset: { layer: "top" } });
    this.box = make("div", { className: "sheet" }, ground, top);
    this.element = make(
      "figure",
      { className: `pane ${kind}`, id },
      make("figcaption", {}, this.caption, " ", this.note),
      this.box,
    );
    this.layers = { ground: new Layer(ground), top: new Layer(top) };
    /** Receives pointer events. */
    this.canvas = top;
    this.width = 0;
    this.height = 0;
    this.palette = app.look.palette;
    /** Layers to be redrawn. @type {Set<"ground" | "top">} */
    this.dirty = new Set();
    host.append(this.element);
    new ResizeObserver(() => this.measure()).observe(this.box);
    app.onTheme(() => this.fit());
    app.onDraw(() => this.draw());
  }

  /** Redraws layers in the next frame. @param {readonly ("ground" | "top")[]} [names] */
  redraw(names = LAYERS) {
    for (const name of names) this.dirty.add(name);
    this.app.requestFrame();
  }

  /** Sets the description for screen readers. @param {string} text */
  describe(text) {
    if (this.canvas.ariaLabel !== text) this.canvas.ariaLabel = text;
  }

  /** Measures the canvases, in whole pixels: a canvas stretched by a fraction of one is blurred. */
  measure() {
    const box = this.box.getBoundingClientRect();
    const [width, height] = [box.width, box.height].map(
      (side) => Math.round(side * devicePixelRatio) / devicePixelRatio,
    );
    if (width < 1 || height < 1 || (width === this.width && height === this.height)) return;
    Object.assign(this, { width, height });
    for (const canvas of this.box.querySelectorAll("canvas"))
      Object.assign(canvas.style, { width: `${width}px`, height: `${height}px` });
    this.fit();
    this.app.requestFrame();
  }

  /** Applies the colours, the pixel ratio and the size. */
  fit() {
    const { palette, ratio } = this.app.look;
    this.palette = palette;
    for (const name of LAYERS) {
      this.layers[name].fit(this.width, this.height, ratio);
      this.dirty.add(name);
    }
  }

  /** Draws the layers that are dirty. */
  draw() {
    if (this.width === 0 || this.element.hidden) return;
    for (const name of LAYERS) {
      if (!this.dirty.delete(name)) continue;
      const { context, ratio } = this.layers[name];
      this.layers[name].clear();
      this.drawWith(context, ratio, (colour) => hatch(context, colour, ratio), [name]);
    }
  }

  /**
   * Draws layers with a context, which may be that of an SVG.
   * @param {CanvasRenderingContext2D} context
   * @param {number} ratio
   * @param {(colour: string) => CanvasPattern | Stripes | null} hatchOf
   * @param {readonly ("ground" | "top")[]} [layers]
   */
  drawWith(context, ratio, hatchOf, layers = LAYERS) {
    const { palette, width, height } = this;
    for (const name of layers) {
      context.save();
      this.drawing[name]?.({ context, palette, width, height, ratio, hatch: /** @type {Brush["hatch"]} */ (hatchOf) });
      context.restore();
    }
  }
}
