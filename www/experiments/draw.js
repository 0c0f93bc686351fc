/** The drawing of a chart, by Observable Plot. This module is loaded when the first chart is drawn. */
import * as Plot from "@observablehq/plot";
import { makeSvg as element } from "../app/dom.js";
import { SERIES } from "../app/palette.js";
import { linesOf, rulerOf } from "../draw/foot.js";
import { countsOf } from "./charts.js";
import { LETTER, SIDES } from "./charts/parts.js";

/** @import { Markish } from "@observablehq/plot" */
/** @import { Palette } from "../app/palette.js" */
/** @import { ChartData, Style } from "./charts.js" */

/** Pixels of a line of the legend or the caption, of the title, above it, and beside them; and of their letters. */
const LINE = 20;
const HEAD = 24;
const ABOVE = 12;
const EDGE = 12;
const FONT = 12;
const LARGE = 17;
const DASHES = ["", "7 4", "2 3", "9 3 2 3"];
const SYMBOLS = /** @type {const} */ (["circle", "square", "triangle", "diamond", "cross", "star", "wye"]);

/**
 * A picture of a chart.
 * @param {ChartData} chart
 * @param {{ width: number, height: number, isWhole?: boolean, palette: Palette }} look   `isWhole`: the height includes
 *   the legend
 * @returns {SVGSVGElement}  its dots with the class `trial` have the number of a trial as `data-trial`
 */
export function drawChart(chart, look) {
  const { palette, width } = look;
  const colours = SERIES.map((name) => palette[name]);
  /** @type {import("./charts.js").Look["scale"]} */
  const scale = (domain, range) => Plot.scale({ color: { type: "linear", domain, range, interpolate: "rgb" } }).apply;
  const ramp = chart.isOrdered ? scale([0, chart.series.length - 1], [palette.start, palette.path]) : null;
  const styleOf = (/** @type {string} */ series) => {
    const i = Math.max(0, chart.series.indexOf(series));
    if (ramp) return { colour: ramp(i), dash: "", symbol: SYMBOLS[0] };
    return {
      colour: colours[i % colours.length],
      dash: DASHES[Math.floor(i / colours.length) % DASHES.length],
      symbol: SYMBOLS[i % SYMBOLS.length],
    };
  };
  const legend = legendOf(chart, styleOf, width);
  const { marks, options, above = 0, legend: own } = chart.kind.marks(Plot, chart, { width, palette, styleOf, scale });
  const top = LINE * legend.lines + above;
  const picture = /** @type {SVGSVGElement} */ (
    Plot.plot({
      width,
      height: look.height + (look.isWhole ? 0 : top),
      marginTop: 38 + top,
      marginBottom: 46,
      marginLeft: 62,
      marginRight: 20,
      className: "plot",
      // Of its own: the page's policy allows no style element.
      style: { fontSize: `${FONT}px`, fontFamily: "inherit", overflow: "visible" },
      ...options,
      marks: [
        ...marks,
        ...(chart.ceiling === null
          ? []
          : [Plot.ruleY([chart.ceiling], { stroke: palette.quiet, strokeWidth: 2, strokeDasharray: "2 5" })]),
        ...reported(chart, palette),
      ],
    })
  );
  picture.querySelector("style")?.remove();
  picture.removeAttribute("font-family");
  // The picture has one name, and its parts have none.
  for (const part of picture.querySelectorAll("[aria-label]")) part.removeAttribute("aria-label");
  picture.setAttribute("role", "img");
  picture.setAttribute("aria-label", `${chart.title}. ${chart.words}.`);
  if (own) picture.append(own);
  picture.append(
    legendElement(legend, palette, chart),
    element("text", { x: 8, y: LINE * legend.lines + 16, fill: palette.ink, "text-anchor": "start" }, chart.up.title),
    own || chart.counted.length === 0
      ? ""
      : element(
          "text",
          { x: width - 20, y: LINE * legend.lines + 16, fill: palette.quiet, "text-anchor": "end" },
          countsOf(chart),
        ),
  );
  markTrials(picture, chart);
  return picture;
}

/** Numbers to compare with. @param {ChartData} chart @param {Palette} palette @returns {Markish[]} */
function reported({ kind, reported: all, series, across }, palette) {
  if (all.length === 0 || kind.swatch === "none") return [];
  const isFaceted = kind.swatch === "bar" && series.length > 1 && across.title !== "";
  const at = !isFaceted
    ? { x: "x" }
    : { fx: "x", x: (/** @type {{ label: string }} */ { label }) => (series.includes(label) ? label : series[0]) };
  return [
    Plot.dot(all, {
      ...at,
      y: "value",
      symbol: "diamond2",
      r: 6,
      fill: palette.stage,
      stroke: palette.collision,
      strokeWidth: 2,
      title: "label",
    }),
  ];
}

/**
 * Writes the numbers of trials to their dots; dots of one box are apart.
 * @param {SVGSVGElement} picture
 * @param {ChartData} chart
 */
function markTrials(picture, { kind, points, across, series }) {
  // Boxes are about so wide.
  const room =
    (0.7 * (Number(picture.getAttribute("width")) - SIDES)) /
    (Math.max(1, across.values.length) * Math.max(1, series.length));
  for (const circle of picture.querySelectorAll("g.trials circle, g.trials path")) {
    const datum = /** @type {{ __data__?: number }} */ (/** @type {unknown} */ (circle)).__data__;
    const point = points[datum ?? -1];
    if (!point) continue;
    circle.setAttribute("class", "trial");
    circle.setAttribute("data-trial", String(point.trial));
    if (kind.swatch === "bar")
      circle.setAttribute(
        "cx",
        String(Number(circle.getAttribute("cx")) + Math.min(36, 0.8 * room) * (((point.trial * 0.618034) % 1) - 0.5)),
      );
  }
}

/** @typedef {{ label: string, x: number, y: number, style: Style | null }} Entry */

/**
 * The places of the entries of the legend; of ordered series some.
 * @param {ChartData} chart
 * @param {(series: string) => Style} styleOf
 * @param {number} width
 * @returns {{ entries: Entry[], lines: number }}
 */
function legendOf({ kind, series, reported: all, across, isOrdered }, styleOf, width) {
  const isAxis = kind.swatch === "bar" && across.title === "";
  const each = isOrdered ? Math.ceil((series.length - 1) / 6) : 1;
  const labels =
    series.length > 1 && !isAxis
      ? series
          .filter((_, i) => i % each === 0 || i === series.length - 1)
          .map((name) => ({ label: name || "all", style: styleOf(name) }))
      : [];
  const others = all.length > 0 && kind.swatch !== "none" ? [{ label: "reported", style: null }] : [];
  let [x, lines] = [8, 0];
  const entries = [...labels, ...others].map((entry) => {
    const size = 34 + LETTER * entry.label.length + 14;
    if (lines === 0 || x + size > width - 10) [x, lines] = [8, lines + 1];
    const placed = { ...entry, x, y: LINE * (lines - 1) + 12 };
    x += size;
    return placed;
  });
  return { entries, lines };
}

/** @param {{ entries: Entry[] }} legend @param {Palette} palette @param {ChartData} chart */
function legendElement({ entries }, palette, { kind }) {
  const isFilled = kind.swatch === "bar";
  return element(
    "g",
    { class: "series", "aria-hidden": "true", "text-anchor": "start" },
    ...entries.map(({ label, x, y, style }) => {
      const sample = !style
        ? element("path", { d: "M14 -6l6 6l-6 6l-6 -6z", fill: "none", stroke: palette.collision, "stroke-width": 2 })
        : isFilled
          ? element("rect", { x: 4, y: -6, width: 20, height: 12, fill: style.colour, "fill-opacity": 0.75 })
          : element("path", {
              d: "M0 0H28",
              stroke: style.colour,
              "stroke-width": 2.5,
              "stroke-dasharray": style.dash,
            });
      return element(
        "g",
        { transform: `translate(${x} ${y})` },
        sample,
        element("text", { x: 34, y: 4, fill: palette.ink }, label),
      );
    }),
  );
}

/**
 * The picture with a title above and a caption below, for an export.
 * @param {SVGSVGElement} picture
 * @param {{ title: string, caption: string, palette: Palette }} words
 * @returns {SVGSVGElement}
 */
export function captioned(picture, { title, caption, palette }) {
  const [width, height] = ["width", "height"].map((name) => Number(picture.getAttribute(name)));
  const lines = linesOf(caption, width - 2 * EDGE, rulerOf(FONT));
  const titles = linesOf(title, width - 2 * EDGE, rulerOf(LARGE, 600));
  const head = titles.length > 0 ? ABOVE + HEAD * titles.length : 0;
  const whole = height + head + (lines.length > 0 ? LINE * (lines.length + 1) : 0);
  const chart = /** @type {SVGSVGElement} */ (picture.cloneNode(true));
  chart.setAttribute("y", String(head));
  chart.style.removeProperty("width");
  const text = (/** @type {number} */ y, /** @type {string} */ words, more = {}) =>
    element("text", { x: EDGE, y, fill: palette.ink, ...more }, words);
  const frame = element(
    "svg",
    { width, height: whole, viewBox: `0 0 ${width} ${whole}`, "font-size": FONT },
    ...titles.map((line, i) => text(HEAD * (i + 1), line, { "font-size": LARGE, "font-weight": 600 })),
    chart,
    ...lines.map((line, i) => text(head + height + LINE * (i + 1), line)),
  );
  frame.style.color = palette.ink;
  return frame;
}
