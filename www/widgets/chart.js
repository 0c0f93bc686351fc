/**
 * A chart of steps: values that hold until the next one, against time. What lies after the time that is shown is faint. Lines
 * differ by their dashes and by a letter at their ends; the colour is the one that the thing has on the stage.
 */
import { make } from "../app/dom.js";

/** @typedef {{ label: string, points: [number, number][] }} Line   time and value, times rising */

const SPACE = "http://www.w3.org/2000/svg";
/** Height, and room around the plot for numbers and letters, CSS pixels. */
const HEIGHT = 190;
const ROOM = { left: 52, right: 22, top: 10, bottom: 38 };
/** How near two letters may come. */
const APART = 13;

export class Chart {
  /** @param {string} id   also names its colour in the style sheet @param {string} title */
  constructor(id, title) {
    this.id = id;
    this.title = make("figcaption", {}, title);
    this.picture = svg("svg", { role: "img", class: `chart ${id}`, "aria-label": title });
    this.element = make("figure", {}, this.title, this.picture);
    /** What is before the time that is shown, and that time. */
    this.past = svg("rect", { x: 0, y: 0, height: HEIGHT });
    this.cursor = svg("line", { class: "cursor", y1: ROOM.top, y2: HEIGHT - ROOM.bottom });
    /** A time in pixels. @type {(time: number) => number} */
    this.scale = () => 0;
    this.end = 0;
  }

  /**
   * @param {Line[]} lines
   * @param {{ end: number, time: string, isFromZero: boolean, summary: string }} how   the latest time, what it counts, do values begin at 0, all of it in words
   */
  draw(lines, { end, time, isFromZero, summary }) {
    const width = Math.max(200, this.element.clientWidth);
    const { picture } = this;
    picture.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
    picture.setAttribute("aria-label", summary);
    picture.replaceChildren();
    const values = lines.flatMap(({ points }) => points.map(([, value]) => value));
    const across = ticks(0, Math.max(1, end), width / 90);
    const up = values.length > 0 ? ticks(isFromZero ? 0 : Math.min(...values), Math.max(...values), 4) : [0, 1];
    const [low, high] = [up[0], up[up.length - 1]];
    const right = width - ROOM.right;
    const bottom = HEIGHT - ROOM.bottom;
    this.end = across[across.length - 1];
    this.scale = (x) => ROOM.left + (x / this.end) * (right - ROOM.left);
    const y = (/** @type {number} */ value) => bottom - ((value - low) / (high - low)) * (bottom - ROOM.top);
    for (const value of values.length > 0 ? up : []) {
      picture.append(svg("line", { class: "grid", x1: ROOM.left, x2: right, y1: y(value), y2: y(value) }));
      picture.append(words(told(value), { x: ROOM.left - 8, y: y(value) + 4, "text-anchor": "end", "data-up": value }));
    }
    for (const value of across) {
      picture.append(svg("line", { class: "tick", x1: this.scale(value), x2: this.scale(value), y1: bottom, y2: bottom + 4 }));
      picture.append(words(told(value), { x: this.scale(value), y: bottom + 17, "text-anchor": "middle", "data-across": value }));
    }
    picture.append(svg("line", { class: "axis", x1: ROOM.left, x2: right, y1: bottom, y2: bottom }));
    picture.append(words(time, { x: (ROOM.left + right) / 2, y: HEIGHT - 3, "text-anchor": "middle" }));
    const clip = svg("clipPath", { id: `${this.id}-past` });
    clip.append(this.past);
    picture.append(clip);
    const future = svg("g", { class: "future" });
    const past = svg("g", { "clip-path": `url(#${this.id}-past)` });
    picture.append(future, past, this.cursor);
    /** @type {{ label: string, x: number, y: number }[]} */
    const ends = [];
    lines.forEach(({ label, points }, i) => {
      if (points.length === 0) return;
      const placed = points.map(([x, value]) => [round(this.scale(x)), round(y(value))]);
      const [[x0, y0], ...rest] = placed;
      const d = `M${x0} ${y0}${rest.map(([x, at]) => `H${x}V${at}`).join("")}`;
      for (const group of [future, past]) {
        group.append(svg("path", { d, class: `line dash-${i}`, "data-label": label }), svg("circle", { class: "dot", cx: x0, cy: y0, r: isFromZero ? 0 : 3.5, "data-label": label }));
      }
      const [lastX, lastY] = placed[placed.length - 1];
      ends.push({ label, x: lastX, y: lastY });
    });
    // Letters that would lie on each other step aside.
    ends.sort((a, b) => a.y - b.y).forEach((one, i) => {
      const above = ends.slice(0, i).findLast((other) => Math.abs(other.x - one.x) < APART);
      if (above) one.y = Math.max(one.y, above.y + APART);
      picture.append(words(one.label, { class: "end", x: one.x + 6, y: one.y + 4 }));
    });
  }

  /** The time that is shown. @param {number} now */
  show(now) {
    const x = this.scale(Math.min(now, this.end));
    this.past.setAttribute("width", String(x + 2));
    this.cursor.setAttribute("x1", String(x));
    this.cursor.setAttribute("x2", String(x));
  }
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
export const told = (value) => value.toLocaleString("en", { maximumSignificantDigits: 6 });

/** @template {keyof SVGElementTagNameMap} T @param {T} tag @param {Record<string, string | number>} attributes @returns {SVGElementTagNameMap[T]} */
export function svg(tag, attributes) {
  const element = document.createElementNS(SPACE, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}

/** @param {string} text @param {Record<string, string | number>} attributes */
export function words(text, attributes) {
  const element = svg("text", attributes);
  element.textContent = text;
  return element;
}
