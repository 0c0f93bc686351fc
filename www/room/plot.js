/**
 * A chart of lines and dots, as SVG: values against whatever they depend on, each axis linear or logarithmic. Lines differ by
 * their dashes and by a word at their ends; what it shows is also said in words.
 */
import { make } from "../app/dom.js";
import { svg, ticks, told, words } from "../widgets/chart.js";

/** @typedef {{ label: string, points: [number, number][], dots?: boolean, className?: string }} Curve   x rising; `dots`: marks instead of a line */
/** @typedef {{ title: string, isLog?: boolean, low?: number, high?: number }} Axis   `low`, `high`: reach at least so far */

const ROOM = { left: 56, right: 22, top: 10, bottom: 38 };
/** How near two words at the ends may come. */
const APART = 13;
/** Decades drawn at most. */
const DECADES = 16;

export class Plot {
  /** @param {string} id   a class of the picture @param {string} title @param {number} [height]  CSS pixels */
  constructor(id, title, height = 190) {
    this.height = height;
    this.title = make("figcaption", {}, title);
    this.picture = svg("svg", { role: "img", class: `chart plot ${id}`, "aria-label": title });
    this.element = make("figure", {}, this.title, this.picture);
    /** What is drawn, to be drawn again at another width. @type {[Curve[], Axis, Axis, string] | null} */
    this.last = null;
    new ResizeObserver(() => { if (this.last) this.draw(...this.last); }).observe(this.element);
  }

  /** @param {Curve[]} curves @param {Axis} across @param {Axis} up @param {string} summary  all of it in words */
  draw(curves, across, up, summary) {
    this.last = [curves, across, up, summary];
    const width = Math.max(200, this.element.clientWidth);
    const { picture, height } = this;
    picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
    picture.setAttribute("aria-label", summary);
    picture.replaceChildren();
    const right = width - ROOM.right;
    const bottom = height - ROOM.bottom;
    const x = scaleOf(curves.flatMap(({ points }) => points.map(([value]) => value)), across, ROOM.left, right, width / 90);
    const y = scaleOf(curves.flatMap(({ points }) => points.map(([, value]) => value)), up, bottom, ROOM.top, height / 45);
    for (const value of y.marks) {
      picture.append(svg("line", { class: "grid", x1: ROOM.left, x2: right, y1: y.at(value), y2: y.at(value) }));
      picture.append(words(y.told(value), { x: ROOM.left - 8, y: y.at(value) + 4, "text-anchor": "end", "data-up": value }));
    }
    for (const value of x.marks) {
      picture.append(svg("line", { class: "tick", x1: x.at(value), x2: x.at(value), y1: bottom, y2: bottom + 4 }));
      picture.append(words(x.told(value), { x: x.at(value), y: bottom + 17, "text-anchor": "middle", "data-across": value }));
    }
    picture.append(svg("line", { class: "axis", x1: ROOM.left, x2: right, y1: bottom, y2: bottom }));
    picture.append(words(across.title, { x: (ROOM.left + right) / 2, y: height - 3, "text-anchor": "middle" }));
    /** @type {{ label: string, x: number, y: number }[]} */
    const ends = [];
    curves.forEach(({ label, points, dots, className = "" }, i) => {
      const placed = points.filter(([a, b]) => x.holds(a) && y.holds(b)).map(([a, b]) => [round(x.at(a)), round(y.at(b))]);
      if (placed.length === 0) return;
      const [lastX, lastY] = placed[placed.length - 1];
      if (dots) picture.append(...placed.map(([cx, cy]) => svg("circle", { class: `dot ${className}`, cx, cy, r: 2.2, "data-label": label })));
      else {
        picture.append(svg("path", { d: `M${placed.map((point) => point.join(" ")).join("L")}`, class: `line dash-${i % 4} ${className}`, "data-label": label }));
        picture.append(svg("circle", { class: `dot ${className}`, cx: lastX, cy: lastY, r: 3, "data-label": label }));
      }
      ends.push({ label, x: lastX, y: lastY });
    });
    // Words that would lie on each other step aside.
    ends.filter(({ label }) => label).sort((a, b) => a.y - b.y).forEach((one, i, all) => {
      const above = all.slice(0, i).findLast((other) => Math.abs(other.x - one.x) < 4 * APART);
      if (above) one.y = Math.max(one.y, above.y + APART);
      const isRight = one.x + 6 + 7 * one.label.length > width;
      picture.append(words(one.label, { class: "end", x: one.x + (isRight ? -6 : 6), y: one.y + (isRight ? -6 : 4), "text-anchor": isRight ? "end" : "start" }));
    });
  }
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
    return { marks, told, holds: Number.isFinite, at: (/** @type {number} */ value) => from + ((value - first) / (last - first)) * (to - from) };
  }
  const top = Math.ceil(Math.log10(most) - 1e-9);
  const end = Math.min(top - 1, Math.max(top - DECADES, Math.floor(Math.log10(least) + 1e-9)));
  const each = Math.ceil((top - end) / Math.max(1, count));
  const marks = Array.from({ length: Math.floor((top - end) / each) + 1 }, (_, i) => 10 ** (top - i * each));
  return {
    marks, told: power, holds: (/** @type {number} */ value) => value > 0 && value < Infinity,
    at: (/** @type {number} */ value) => from + ((Math.max(end, Math.log10(value)) - end) / (top - end)) * (to - from),
  };
}

/** A power of ten: as it is where it is short. @param {number} value */
function power(value) {
  const exponent = Math.round(Math.log10(value));
  if (exponent >= -2 && exponent <= 4) return told(value);
  return `10${[...String(exponent)].map((c) => (c === "-" ? "\u207b" : "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[Number(c)])).join("")}`;
}

/** @param {number} value */
const round = (value) => Math.round(10 * value) / 10;
