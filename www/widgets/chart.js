/**
 * A chart of lines or dots against linear or logarithmic axes. Lines differ by their dashes and by a label at their
 * ends. On a timeline values hold until the next one, unless they are smooth, and values after the time shown are faint, unless all
 * are even. What draws is loaded with the first drawing.
 */
import { make, makeSvg } from "../app/dom.js";
import { once } from "../app/once.js";

/**
 * @typedef {{ label: string, points: [number, number][], isDots?: boolean, isLevel?: boolean, className?: string }}
 *   Line   x rising; a level has no dot
 */
/**
 * @typedef {{ title: string, isLog?: boolean, low?: number, high?: number, isExact?: boolean }} Axis   it reaches at
 *   least from `low` to `high`, and as far as the next round numbers unless it is exact
 */

const drawing = once(() => import("./plot.js"));

export class Chart {
  /**
   * @param {string} id   also a class of the picture
   * @param {string} title
   * @param {{ height?: number, isTimeline?: boolean, isSmooth?: boolean, isEven?: boolean }} [options]
   */
  constructor(id, title, { height = 190, isTimeline = false, isSmooth = false, isEven = false } = {}) {
    this.id = id;
    this.height = height;
    this.isTimeline = isTimeline;
    this.isSmooth = isSmooth;
    this.isEven = isEven;
    this.title = make("figcaption", {}, title);
    this.picture = makeSvg("svg", {
      role: "img",
      class: `chart ${id}`,
      "aria-label": title,
      "text-anchor": "middle",
      fill: "currentColor",
    });
    this.element = make("figure", {}, this.title, this.picture);
    /** The arguments of the last drawing. @type {[Line[], Axis, Axis, string] | null} */
    this.drawn = null;
    /** The area before the time shown, and its edge. */
    this.past = makeSvg("rect", { x: 0, y: 0, height });
    this.cursor = makeSvg("line", { class: "cursor", y1: 0, y2: 0 });
    this.now = 0;
    /** Values in pixels across. @type {(value: number) => number} */
    this.scale = () => 0;
    /** @type {typeof import("./plot.js") | null} */
    this.plot = null;
    new ResizeObserver(() => this.redraw()).observe(this.element);
  }

  /** @param {Line[]} lines @param {Axis} across @param {Axis} up @param {string} summary  all of it in words */
  draw(lines, across, up, summary) {
    this.drawn = [lines, across, up, summary];
    this.picture.setAttribute("aria-label", summary);
    if (this.plot) this.redraw();
    else {
      void drawing().then((plot) => {
        this.plot = plot;
        this.redraw();
      });
    }
  }

  redraw() {
    const { plot, drawn, picture, height, isTimeline, isSmooth, isEven, past, cursor } = this;
    if (!plot || !drawn) return;
    const [lines, across, up] = drawn;
    const width = Math.max(200, this.element.clientWidth);
    const {
      axes,
      shapes,
      labels,
      scale,
      bounds: [top, right, bottom],
    } = plot.drawLines(lines, across, up, { width, height, isTimeline, isSmooth });
    picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
    if (!isTimeline) return picture.replaceChildren(...axes, ...shapes, ...labels);
    const id = `${this.id}-past`;
    const strong = shapes.map((shape) => shape.cloneNode(true));
    cursor.setAttribute("y1", String(top));
    cursor.setAttribute("y2", String(bottom));
    const parts = [
      makeSvg("clipPath", { id }, past),
      makeSvg("g", { class: "future" }, ...shapes),
      makeSvg("g", { "clip-path": `url(#${id})` }, ...strong),
    ];
    picture.replaceChildren(...axes, ...(isEven ? strong : parts), cursor, ...labels);
    this.scale = (value) => Math.min(scale(value), right);
    this.show(this.now);
  }

  /**
   * The value of a timeline at a pointer: from 0 to the end; null before the chart is drawn.
   * @param {PointerEvent} event @param {number} end
   */
  pointed({ clientX }, end) {
    const [left, right] = [this.scale(0), this.scale(end)];
    const x = clientX - this.picture.getBoundingClientRect().left;
    return right > left ? end * Math.min(1, Math.max(0, (x - left) / (right - left))) : null;
  }

  /** Shows a time of a timeline. @param {number} now */
  show(now) {
    this.now = now;
    const x = this.scale(now);
    this.past.setAttribute("width", String(x + 2));
    this.cursor.setAttribute("x1", String(x));
    this.cursor.setAttribute("x2", String(x));
  }
}
