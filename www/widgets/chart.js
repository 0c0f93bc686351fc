/**
 * A chart as SVG: lines or dots against linear or logarithmic axes. Lines differ by their dashes and by a label at their ends. On a
 * timeline values hold until the next one, and values after the time shown are faint.
 */
import { make } from "../app/dom.js";

/** @typedef {{ label: string, points: [number, number][], isDots?: boolean, className?: string }} Line   x rising */
/** @typedef {{ title: string, isLog?: boolean, low?: number, high?: number }} Axis   it reaches at least from `low` to `high` */

const SPACE = "http://www.w3.org/2000/svg";
/** Space around the plot for numbers and labels, CSS pixels. */
const ROOM = { left: 56, right: 22, top: 10, bottom: 38 };
/** Least distance between labels. */
const APART = 13;
/** Decades of a logarithmic axis, at most. */
const DECADES = 16;
/** Points of a line, about. */
const POINTS = 1000;

export class Chart {
  /** @param {string} id   also a class of the picture @param {string} title @param {{ height?: number, isTimeline?: boolean }} [options] */
  constructor(id, title, { height = 190, isTimeline = false } = {}) {
    this.id = id;
    this.height = height;
    this.isTimeline = isTimeline;
    this.title = make("figcaption", {}, title);
    this.picture = svg("svg", { role: "img", class: `chart ${id}`, "aria-label": title });
    this.element = make("figure", {}, this.title, this.picture);
    /** The arguments of the last drawing. @type {[Line[], Axis, Axis, string] | null} */
    this.drawn = null;
    /** The area before the time shown, and its edge. */
    this.past = svg("rect", { x: 0, y: 0, height });
    this.cursor = svg("line", { class: "cursor", y1: ROOM.top, y2: height - ROOM.bottom });
    this.now = 0;
    /** Values in pixels across. @type {(value: number) => number} */
    this.scale = () => 0;
    new ResizeObserver(() => { if (this.drawn) this.draw(...this.drawn); }).observe(this.element);
  }

  /** @param {Line[]} lines @param {Axis} across @param {Axis} up @param {string} summary  all of it in words */
  draw(lines, across, up, summary) {
    this.drawn = [lines, across, up, summary];
    const { picture, height, isTimeline, past, cursor } = this;
    const width = Math.max(200, this.element.clientWidth);
    const [right, bottom] = [width - ROOM.right, height - ROOM.bottom];
    const values = (/** @type {0 | 1} */ i) => lines.flatMap(({ points }) => points.map((point) => point[i]));
    const x = scaleOf(values(0), across, ROOM.left, right, width / 90);
    const y = scaleOf(values(1), up, bottom, ROOM.top, height / 45);
    picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
    picture.setAttribute("aria-label", summary);
    picture.replaceChildren();
    for (const value of values(1).length > 0 ? y.marks : []) {
      picture.append(svg("line", { class: "grid", x1: ROOM.left, x2: right, y1: y.at(value), y2: y.at(value) }));
      picture.append(svg("text", { x: ROOM.left - 8, y: y.at(value) + 4, "text-anchor": "end", "data-up": value }, y.text(value)));
    }
    for (const value of x.marks) {
      picture.append(svg("line", { class: "tick", x1: x.at(value), x2: x.at(value), y1: bottom, y2: bottom + 4 }));
      picture.append(svg("text", { x: x.at(value), y: bottom + 17, "text-anchor": "middle", "data-across": value }, x.text(value)));
    }
    picture.append(svg("line", { class: "axis", x1: ROOM.left, x2: right, y1: bottom, y2: bottom }));
    picture.append(svg("text", { x: (ROOM.left + right) / 2, y: height - 3, "text-anchor": "middle" }, across.title));
    const placed = lines.map(({ points }) => thinned(points).filter(([a, b]) => x.holds(a) && y.holds(b)).map(([a, b]) => [round(x.at(a)), round(y.at(b))]));
    const shapes = () => lines.flatMap((line, i) => (placed[i].length > 0 ? shapesOf(line, i, placed[i], isTimeline, up.low === undefined) : []));
    if (!isTimeline) picture.append(...shapes());
    else {
      const id = `${this.id}-past`;
      const [faint, strong] = [svg("g", { class: "future" }, ...shapes()), svg("g", { "clip-path": `url(#${id})` }, ...shapes())];
      picture.append(svg("clipPath", { id }, past), faint, strong, cursor);
      this.scale = (value) => Math.min(x.at(value), right);
      this.show(this.now);
    }
    this.label(lines, placed, width);
  }

  /** Writes labels at the ends of lines; labels that would overlap step aside. @param {Line[]} lines @param {number[][][]} placed @param {number} width */
  label(lines, placed, width) {
    const ends = lines.flatMap(({ label }, i) => {
      const [x, y] = placed[i][placed[i].length - 1] ?? [];
      return label && x !== undefined ? [{ label, x, y }] : [];
    });
    ends.sort((a, b) => a.y - b.y).forEach((end, i) => {
      const above = ends.slice(0, i).findLast((other) => Math.abs(other.x - end.x) < 4 * APART);
      if (above) end.y = Math.max(end.y, above.y + APART);
      const isInside = end.x + 6 + 7 * end.label.length > width;
      const [dx, dy, anchor] = isInside ? [-6, -6, "end"] : [6, 4, "start"];
      this.picture.append(svg("text", { class: "end", x: end.x + dx, y: end.y + dy, "text-anchor": anchor }, end.label));
    });
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

/** @param {Line} line @param {number} index @param {number[][]} placed  pixels @param {boolean} isStepped @param {boolean} hasFirst  does a dot mark the first point of a stepped line? */
function shapesOf({ label, isDots, className = "" }, index, placed, isStepped, hasFirst) {
  const dot = (/** @type {number[]} */ [cx, cy], /** @type {number} */ r) => svg("circle", { class: `dot ${className}`, cx, cy, r, "data-label": label });
  if (isDots) return placed.map((point) => dot(point, 2.2));
  const [[x0, y0], ...rest] = placed;
  const d = `M${x0} ${y0}${rest.map(([x, y]) => (isStepped ? `H${x}V${y}` : `L${x} ${y}`)).join("")}`;
  const path = svg("path", { d, class: `line dash-${index % 4} ${className}`, "data-label": label });
  if (isStepped) return [path, dot(placed[0], hasFirst ? 3.5 : 0)];
  return [path, dot(placed[placed.length - 1], 3)];
}

/** Some of many points, the last among them. @param {[number, number][]} points */
function thinned(points) {
  const each = Math.ceil(points.length / POINTS);
  return points.filter((_, i) => i % each === 0 || i === points.length - 1);
}

/**
 * A scale with its marks.
 * @param {number[]} values @param {Axis} axis @param {number} from  pixels @param {number} to @param {number} count  about how many steps
 */
function scaleOf(values, { isLog = false, low = Infinity, high = -Infinity }, from, to, count) {
  const good = values.filter((value) => Number.isFinite(value) && (!isLog || value > 0));
  let least = good.reduce((a, b) => Math.min(a, b), low);
  let most = good.reduce((a, b) => Math.max(a, b), high);
  if (!(least <= most)) [least, most] = isLog ? [0.1, 1] : [0, 1];
  if (!isLog) {
    const marks = ticks(least, most, count);
    const [first, last] = [marks[0], marks[marks.length - 1]];
    return { marks, text: numberText, holds: Number.isFinite, at: (/** @type {number} */ value) => from + ((value - first) / (last - first)) * (to - from) };
  }
  const top = Math.ceil(Math.log10(most) - 1e-9);
  const end = Math.min(top - 1, Math.max(top - DECADES, Math.floor(Math.log10(least) + 1e-9)));
  const each = Math.ceil((top - end) / Math.max(1, count));
  const marks = Array.from({ length: Math.floor((top - end) / each) + 1 }, (_, i) => 10 ** (top - i * each));
  return {
    marks, text: powerText, holds: (/** @type {number} */ value) => value > 0 && value < Infinity,
    at: (/** @type {number} */ value) => from + ((Math.max(end, Math.log10(value)) - end) / (top - end)) * (to - from),
  };
}

/** A power of ten. @param {number} value */
function powerText(value) {
  const exponent = Math.round(Math.log10(value));
  return exponent >= -2 && exponent <= 4 ? numberText(value) : `10${superscript(exponent)}`;
}

/** The digits of an exponent. @param {number} exponent */
export function superscript(exponent) {
  return [...String(exponent)].map((c) => (c === "-" ? "\u207b" : "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[Number(c)])).join("");
}

/** Round numbers, evenly spaced, that reach from at most `low` to at least `high`; two of them at least. @param {number} low @param {number} high @param {number} count  about how many steps @returns {number[]} */
export function ticks(low, high, count) {
  const rough = Math.max((high - low) / Math.max(1, count), Math.abs(high) * 0.005, 1e-9);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5].find((factor) => factor * power >= rough * (1 - 1e-9)) ?? 10);
  const first = Math.floor(low / step + 1e-9);
  const last = Math.max(first + 1, Math.ceil(high / step - 1e-9));
  return Array.from({ length: last - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** @param {number} value */
const round = (value) => Math.round(10 * value) / 10;

/** @param {number} value */
export const numberText = (value) => value.toLocaleString("en", { maximumSignificantDigits: 6 });

/**
 * A new SVG element.
 * @template {keyof SVGElementTagNameMap} T
 * @param {T} tag @param {Record<string, string | number>} attributes @param {...(Node | string)} children
 */
export function svg(tag, attributes, ...children) {
  const element = document.createElementNS(SPACE, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}
