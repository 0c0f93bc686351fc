/**
 * A figure: a caption and a sheet of canvases in the resolution of the screen. It is drawn at most once a frame. The
 * same drawing can be exported as PNG, SVG or film.
 */
import { View } from "planarium/draw";
import { make } from "../app/dom.js";
import { Sheet } from "./sheet.js";

/** @import { App } from "../app/app.js" */
/** @import { Drawing } from "./sheet.js" */
/** @typedef {import("./sheet.js").Brush} Brush */

/** The view of a figure that is not drawn yet. */
export const NO_VIEW = new View({ min: [0, 0], max: [1, 1] }, 1, 1);

/** The figure of each box of canvases. @type {WeakMap<Element, Figure<any>>} */
const figures = new WeakMap();
/** Made with the first figure. @type {ResizeObserver | undefined} */
let observer;

/** @template {Drawing} [D=Drawing] */
export class Figure {
  /**
   * @param {App} app
   * @param {HTMLElement} host   the figure is appended
   * @param {{ id: string, kind?: string, caption: string, note?: string }} names   `kind`: a class of the figure, by
   *   default the id
   * @param {D} drawing
   * @param {(() => void) | null} [onSize]   after it has another size; where absent, the figure draws itself in each
   *   frame of the app
   */
  constructor(app, host, { id, kind = id, caption, note = "" }, drawing, onSize = null) {
    this.app = app;
    this.drawing = drawing;
    this.caption = make("span", {}, caption);
    this.note = make("small", {}, note);
    const canvases = Object.fromEntries(
      Object.keys(drawing.layers).map((layer) => [layer, make("canvas", { ariaHidden: "true", dataset: { layer } })]),
    );
    const top = /** @type {HTMLCanvasElement} */ (Object.values(canvases).at(-1));
    Object.assign(top, { ariaHidden: null, role: "img", ariaLabel: caption });
    this.box = make("div", { className: "sheet" }, ...Object.values(canvases));
    this.element = make(
      "figure",
      { className: `pane ${kind}`, id },
      make("figcaption", {}, this.caption, " ", this.note),
      this.box,
    );
    this.sheet = new Sheet(drawing, (name) => canvases[name]);
    /** Receives pointer events. */
    this.canvas = top;
    this.width = 0;
    this.height = 0;
    this.onSize = onSize ?? (() => this.fit());
    host.append(this.element);
    figures.set(this.box, this);
    observer ??= new ResizeObserver((entries) => measure(entries.flatMap(({ target }) => figures.get(target) ?? [])));
    observer.observe(this.box);
    if (onSize) return;
    app.onTheme(() => this.fit());
    app.onDraw(() => {
      if (this.width > 0 && !this.element.hidden) this.sheet.draw();
    });
  }

  remove() {
    observer?.unobserve(this.box);
    this.element.remove();
  }

  /** Redraws layers without a key in the next frame. */
  redraw() {
    this.sheet.redraw();
    this.app.requestFrame();
  }

  /** Sets the description for screen readers. @param {string} text */
  describe(text) {
    if (this.canvas.ariaLabel !== text) this.canvas.ariaLabel = text;
  }

  /** Applies the colours, the pixel ratio and the size. */
  fit() {
    this.sheet.fit(this, this.app.look);
    this.app.requestFrame();
  }
}

/**
 * Measures figures, in whole pixels of the screen: a canvas stretched by a fraction of one is blurred. All boxes are
 * read before a style is written, so that the document is laid out once.
 * @param {Iterable<Figure<any>>} all
 */
export function measure(all) {
  for (const { figure, box } of Array.from(all, (figure) => ({ figure, box: figure.box.getBoundingClientRect() }))) {
    const [width, height] = [box.width, box.height].map(
      (side) => Math.round(side * devicePixelRatio) / devicePixelRatio,
    );
    if (width < 1 || height < 1 || (width === figure.width && height === figure.height)) continue;
    Object.assign(figure, { width, height });
    for (const canvas of figure.box.children)
      if (canvas instanceof HTMLElement) Object.assign(canvas.style, { width: `${width}px`, height: `${height}px` });
    figure.onSize();
  }
}
