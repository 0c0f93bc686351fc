/** The drawing of a `Chart`, by Observable Plot. */
import { dot, lineY, plot } from "@observablehq/plot";
import { makeSvg } from "../app/dom.js";
import { numberText, superscript } from "./format.js";

/** @import { Axis, Line } from "./chart.js" */

/** Space around the plot for numbers and labels, CSS pixels. */
const ROOM = { top: 10, right: 28, bottom: 38, left: 56 };
/** Least distance between labels. */
const APART = 13;
/** Width of a bold letter on average, at most, in parts of the page's letters. */
const LETTER = 0.54;
/** Decades of a logarithmic axis, at most. */
const DECADES = 16;
/** Points of a line, about. */
const POINTS = 1000;

/**
 * The parts of a picture: axes, lines with their dots, and labels at the ends of lines; the scale across, and the
 * bounds of the plot: top, right, bottom.
 * @param {Line[]} lines
 * @param {Axis} across
 * @param {Axis} up
 * @param {{ width: number, height: number, isTimeline: boolean, isSmooth: boolean }} size
 */
export function drawLines(lines, across, up, { width, height, isTimeline, isSmooth }) {
  const values = (/** @type {0 | 1} */ i) => lines.flatMap(({ points }) => points.map((point) => point[i]));
  const [x, y] = [optionsOf(values(0), across, width / 90), optionsOf(values(1), up, height / 45)];
  const holds = (/** @type {Axis} */ { isLog }, /** @type {number} */ value) =>
    Number.isFinite(value) && (!isLog || value > 0);
  const placed = lines.map(({ points }) => thinned(points).filter(([a, b]) => holds(across, a) && holds(up, b)));
  const marks = lines.flatMap(({ isDots, isLevel, className = "" }, i) => {
    const points = placed[i];
    const dots = (/** @type {[number, number][]} */ some, /** @type {number} */ r) =>
      dot(some, { x: "0", y: "1", r, fill: "currentColor", className: `shape dot ${className}` });
    if (points.length === 0) return [];
    if (isDots) return [dots(points, 2.2)];
    // On a timeline a dot marks the first value of what begins late.
    const end = isTimeline ? dots(points.slice(0, 1), up.low === undefined ? 3.5 : 0) : dots(points.slice(-1), 3);
    const line = lineY(points, {
      x: "0",
      y: "1",
      curve: isTimeline && !isSmooth ? "step-after" : "linear",
      strokeWidth: 2,
      className: `shape line dash-${i % 4} ${className}`,
    });
    return isLevel ? [line] : [line, end];
  });
  const made = /** @type {import("@observablehq/plot").Plot & SVGSVGElement} */ (
    plot({
      width,
      height,
      marginTop: ROOM.top,
      marginRight: ROOM.right,
      marginBottom: ROOM.bottom,
      marginLeft: ROOM.left,
      className: "plot",
      marks,
      x: { ...x, label: across.title, labelAnchor: "center", labelArrow: "none", line: true, tickSize: 4 },
      y: { ...y, label: null, tickSize: 0, grid: values(1).length > 0, ...(values(1).length > 0 ? {} : { ticks: [] }) },
    })
  );
  const [toX, toY] = ["x", "y"].map(
    (name) => /** @type {(value: number) => number} */ (made.scale(/** @type {"x"} */ (name))?.apply),
  );
  const parts = [...made.children].filter(({ tagName }) => tagName !== "style");
  for (const part of parts) {
    // The picture has one name, and its parts have none.
    part.classList.add((part.getAttribute("aria-label") ?? "part").replaceAll(" ", "-"));
    part.removeAttribute("aria-label");
  }
  const shapes = parts.filter((part) => part.classList.contains("shape"));
  const labels = labelsOf(
    lines.flatMap(({ label }, i) => {
      const [a, b] = placed[i].at(-1) ?? [];
      return label && a !== undefined && b !== undefined ? [{ label, x: toX(a), y: toY(b) }] : [];
    }),
    width,
  );
  return {
    axes: parts.filter((part) => !shapes.includes(part)),
    shapes,
    labels,
    scale: toX,
    bounds: [ROOM.top, width - ROOM.right, height - ROOM.bottom],
  };
}

/**
 * Labels at the ends of lines; those that would overlap step aside.
 * @param {{ label: string, x: number, y: number }[]} ends
 * @param {number} width
 */
function labelsOf(ends, width) {
  const letter = LETTER * parseFloat(getComputedStyle(document.documentElement).fontSize);
  return ends
    .sort((a, b) => a.y - b.y)
    .map((end, i) => {
      const above = ends.slice(0, i).findLast((other) => Math.abs(other.x - end.x) < 4 * APART);
      if (above) end.y = Math.max(end.y, above.y + APART);
      const isInside = end.x + 6 + letter * end.label.length > width;
      const [dx, dy, anchor] = isInside ? [-6, -6, "end"] : [6, 4, "start"];
      return makeSvg("text", { class: "end", x: end.x + dx, y: end.y + dy, "text-anchor": anchor }, end.label);
    });
}

/** Some of many points, the last among them. @param {[number, number][]} points */
function thinned(points) {
  const each = Math.ceil(points.length / POINTS);
  return points.filter((_, i) => i % each === 0 || i === points.length - 1);
}

/**
 * The options of a scale.
 * @param {number[]} values
 * @param {Axis} axis
 * @param {number} count  about how many steps
 * @returns {import("@observablehq/plot").ScaleOptions}
 */
function optionsOf(values, { isLog = false, low = Infinity, high = -Infinity, isExact = false }, count) {
  const good = values.filter((value) => Number.isFinite(value) && (!isLog || value > 0));
  let least = good.reduce((a, b) => Math.min(a, b), low);
  let most = good.reduce((a, b) => Math.max(a, b), high);
  if (!(least <= most)) [least, most] = isLog ? [0.1, 1] : [0, 1];
  // What does not vary is given room.
  if (!isLog)
    return {
      domain: [least, most - least > 0.005 * Math.abs(most) ? most : least + Math.max(0.02 * Math.abs(most), 1e-9)],
      nice: isExact ? undefined : count,
      ticks: count,
    };
  const top = Math.ceil(Math.log10(most) - 1e-9);
  const end = Math.min(top - 1, Math.max(top - DECADES, Math.floor(Math.log10(least) + 1e-9)));
  const each = Math.ceil((top - end) / Math.max(1, count));
  const marks = Array.from({ length: Math.floor((top - end) / each) + 1 }, (_, i) => 10 ** (top - i * each));
  return {
    type: "log",
    domain: [10 ** end, 10 ** top],
    clamp: true,
    ticks: /** @type {any} */ (marks),
    tickFormat: /** @type {any} */ (powerText),
  };
}

/** A power of ten. @param {number} value */
function powerText(value) {
  const exponent = Math.round(Math.log10(value));
  return exponent >= -2 && exponent <= 4 ? numberText(value) : `10${superscript(exponent)}`;
}
