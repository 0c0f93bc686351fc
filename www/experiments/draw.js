/** The drawing of a chart, by Observable Plot. This module is loaded when the first chart is drawn. */
import { areaY, barY, cell, dot, lineY, plot, ruleX, scale, text, tickY } from "@observablehq/plot";
import { makeSvg as element } from "../app/dom.js";
import { SERIES } from "../app/palette.js";
import { wordOf } from "./factors.js";

/** @import { Markish, PlotOptions } from "@observablehq/plot" */
/** @import { Palette } from "../app/palette.js" */
/** @import { ChartData, Scale } from "./charts.js" */
/** @import { Cell } from "./rows.js" */

/** Steps of a line drawn, about. */
const MOST_STEPS = 400;
/** Pixels of a letter, about, and of a line of the legend. */
const LETTER = 6.6;
const LINE = 20;

/** Colours of the legend of a heat map. */
const STEPS = 6;
const DASHES = ["", "7 4", "2 3", "9 3 2 3"];
const SYMBOLS = /** @type {const} */ (["circle", "square", "triangle", "diamond", "cross", "star", "wye"]);

/** @typedef {{ colour: string, dash: string, symbol: typeof SYMBOLS[number] }} Style   of a series */

/**
 * A picture of a chart.
 * @param {ChartData} chart @param {{ width: number, height: number, palette: Palette, bold: number }} look
 * @returns {SVGSVGElement}  its dots with the class `trial` have the number of a trial as `data-trial`
 */
export function drawChart(chart, look) {
  const { palette, width, bold } = look;
  const colours = SERIES.map((name) => palette[name]);
  const ramp = chart.isOrdered
    ? scale({
        color: {
          type: "linear",
          domain: [0, chart.series.length - 1],
          range: [palette.start, palette.path],
          interpolate: "rgb",
        },
      })
    : null;
  const styleOf = (/** @type {string} */ series) => {
    const i = Math.max(0, chart.series.indexOf(series));
    if (ramp) return { colour: ramp.apply(i), dash: "", symbol: SYMBOLS[0] };
    return {
      colour: colours[i % colours.length],
      dash: DASHES[Math.floor(i / colours.length) % DASHES.length],
      symbol: SYMBOLS[i % SYMBOLS.length],
    };
  };
  const legend = legendOf(chart, styleOf, width);
  const marginTop = 32 + LINE * legend.lines;
  const { marks, options } = partsOf(chart, look, styleOf);
  const picture = /** @type {SVGSVGElement} */ (
    plot({
      width,
      height: look.height + LINE * legend.lines,
      marginTop,
      marginBottom: 46,
      marginLeft: 62,
      marginRight: 20,
      className: "plot",
      // Of its own: the page's policy allows no style element.
      style: { fontSize: `${12 * bold}px`, fontFamily: "inherit", overflow: "visible" },
      ...options,
      marks: [...marks, ...reported(chart, palette)],
    })
  );
  picture.querySelector("style")?.remove();
  picture.removeAttribute("font-family");
  // The picture has one name, and its parts have none.
  for (const part of picture.querySelectorAll("[aria-label]")) part.removeAttribute("aria-label");
  picture.setAttribute("role", "img");
  picture.setAttribute("aria-label", `${chart.title}. ${chart.words}.`);
  if (chart.kind === "heat") picture.append(rampElement(chart, palette, width));
  picture.append(
    legendElement(legend, palette, chart),
    element("text", { x: 8, y: LINE * legend.lines + 16, fill: palette.ink, "text-anchor": "start" }, chart.up.title),
  );
  markTrials(picture, chart);
  return picture;
}

/**
 * @param {ChartData} chart
 * @param {{ width: number, palette: Palette }} look
 * @param {(series: string) => Style} styleOf
 * @returns {{ marks: Markish[], options: PlotOptions }}
 */
function partsOf(chart, { width, palette }, styleOf) {
  const { kind, across, up, series, summaries, points, bins, distributions } = chart;
  const fill = (/** @type {{ series: string }} */ one) => styleOf(one.series).colour;
  const y = {
    label: null,
    grid: true,
    type: up.isLog ? /** @type {const} */ ("log") : undefined,
    zero: !up.isLog,
    nice: !up.isLog,
  };
  const x = {
    label: across.title,
    labelAnchor: /** @type {const} */ ("center"),
    labelArrow: /** @type {const} */ ("none"),
    type: across.isLog ? /** @type {const} */ ("log") : undefined,
  };
  const percent = up.title.endsWith("%") ? { domain: [0, 100], nice: false } : {};
  const color = { type: /** @type {const} */ ("identity") };
  if (kind === "heat") return heatParts(chart, width, palette);
  if (kind === "ecdf" || kind === "cost") {
    const lines =
      kind === "ecdf"
        ? distributions.map((one) =>
            lineY(stairs(one, lastOf(chart)), {
              x: "value",
              y: "share",
              curve: "step-after",
              ...strokeOf(styleOf(one.series)),
            }),
          )
        : series.flatMap((name) => {
            const some = bins.filter((bin) => bin.series === name);
            const style = styleOf(name);
            return [
              areaY(some, { x: "work", y1: "low", y2: "high", fill: style.colour, fillOpacity: 0.22 }),
              lineY(some, { x: "work", y: "middle", ...strokeOf(style) }),
            ];
          });
    const dots = dot(points, { x: "work", y: "value", r: 2.6, fill, fillOpacity: 0.5, className: "trials" });
    return {
      marks: kind === "cost" ? [dots, ...lines] : lines,
      options: {
        x: { ...x, nice: true, zero: kind === "ecdf" && !across.isLog },
        y: { ...y, zero: kind === "ecdf" && !up.isLog, ...percent },
        color,
      },
    };
  }
  if (kind === "line") {
    const few =
      across.values.length <= 12 ? { ticks: /** @type {any} */ (across.values.filter((value) => value !== null)) } : {};
    const place = across.isNumeric
      ? { ...few, tickFormat: /** @type {any} */ (String) }
      : { type: /** @type {const} */ ("point"), domain: across.values, padding: 0.5, ...ticksOf(across, width) };
    const marks = series.flatMap((name, i) => {
      const some = summaries.filter((one) => one.series === name);
      const style = styleOf(name);
      // No line joins categories; dots of one are side by side.
      const beside = { dx: 9 * (i - (series.length - 1) / 2) };
      if (!across.isNumeric)
        return [
          ruleX(some, { x: "x", y1: "low", y2: "high", stroke: style.colour, strokeWidth: 2, ...beside }),
          dot(some, { x: "x", y: "middle", symbol: style.symbol, fill: style.colour, r: 4.4, ...beside }),
        ];
      return [
        areaY(some, { x: "x", y1: "low", y2: "high", fill: style.colour, fillOpacity: 0.16 }),
        lineY(some, { x: "x", y: "middle", ...strokeOf(style) }),
        dot(some, { x: "x", y: "middle", symbol: style.symbol, fill: style.colour, r: 3.4 }),
      ];
    });
    return {
      marks,
      options: { x: { ...x, ...place }, y: { ...y, ...percent, zero: percent.domain !== undefined }, color },
    };
  }
  // Bars and boxes: the factor across, and within it the series.
  const isFaceted = series.length > 1 && across.title !== "";
  const bands = {
    ...x,
    type: /** @type {const} */ ("band"),
    domain: across.title ? across.values : series,
    ...ticksOf(across.title ? across : { ...across, values: series }, width),
  };
  const at = isFaceted ? { fx: "x", x: "series" } : { x: across.title ? "x" : "series" };
  const options = isFaceted
    ? {
        fx: { ...bands, axis: /** @type {const} */ ("bottom"), type: undefined, padding: 0.15 },
        x: { axis: null, domain: series, padding: 0.1 },
        y: { ...y, ...percent },
        color,
      }
    : { x: { ...bands, padding: 0.25 }, y: { ...y, ...percent }, color };
  if (kind === "success") {
    const bars = barY(summaries, { ...at, y: "middle", fill, fillOpacity: 0.75 });
    const intervals = ruleX(summaries, { ...at, y1: "low", y2: "high", stroke: palette.ink, strokeWidth: 1.5 });
    return { marks: [bars, intervals], options };
  }
  return {
    marks: [
      ruleX(summaries, { ...at, y1: "least", y2: "most", stroke: fill, strokeWidth: 1.5 }),
      barY(summaries, { ...at, y1: "low", y2: "high", fill, fillOpacity: 0.3, stroke: fill, strokeWidth: 1.5 }),
      tickY(summaries, { ...at, y: "middle", stroke: fill, strokeWidth: 3 }),
      dot(points, { ...at, y: "value", r: 2.4, fill, fillOpacity: 0.55, className: "trials" }),
    ],
    options: { ...options, y: { ...y, zero: false } },
  };
}

/**
 * @param {ChartData} chart
 * @param {number} width
 * @param {Palette} palette
 * @returns {{ marks: Markish[], options: PlotOptions }}
 */
function heatParts(chart, width, palette) {
  const { across, up, summaries } = chart;
  const [least, most] = rangeOf(chart);
  const isDark = (/** @type {{ middle: number | null }} */ { middle }) =>
    middle !== null && middle - least > 0.5 * (most - least);
  const some = summaries.filter(({ middle }) => middle !== null);
  const marks = [cell(some, { x: "x", y: "y", fill: "middle", inset: 0.5 })];
  const isWide = across.values.length * 42 < width - 80;
  if (isWide)
    marks.push(
      text(some, {
        x: "x",
        y: "y",
        text: (one) => String(Number(one.middle.toPrecision(3))),
        fill: (one) => (isDark(one) ? palette.stage : palette.ink),
        fontSize: 11,
      }),
    );
  const label = { labelArrow: /** @type {const} */ ("none") };
  const longest = Math.max(...up.values.map((value) => wordOf(value, up.words).length));
  return {
    marks,
    options: {
      marginLeft: Math.min(width / 3, Math.max(62, LETTER * longest + 20)),
      x: {
        label: across.title,
        ...label,
        labelAnchor: "center",
        type: "band",
        domain: across.values.filter((value) => value !== null),
        ...ticksOf(across, width),
      },
      y: {
        label: null,
        type: "band",
        domain: up.values.filter((value) => value !== null).toReversed(),
        tickFormat: /** @type {any} */ ((/** @type {Cell} */ value) => wordOf(value, up.words)),
      },
      color: {
        type: "linear",
        domain: least < most ? [least, most] : [least - 1, least],
        range: rampOf(palette),
        interpolate: "rgb",
      },
    },
  };
}

/**
 * The least and the most of a heat map; shares have the whole range.
 * @param {ChartData} chart
 * @returns {[number, number]}
 */
function rangeOf({ title, summaries }) {
  const values = summaries.flatMap(({ middle }) => (middle === null ? [] : [middle]));
  return title.endsWith("%") ? [0, 100] : [Math.min(...values), Math.max(...values)];
}

/** The colours of a heat map, from the least to the most. @param {Palette} palette @returns {[string, string]} */
function rampOf({ obstacle, start }) {
  return [obstacle, start];
}

/** What the colours of a heat map mean. @param {ChartData} chart @param {Palette} palette @param {number} width */
function rampElement(chart, palette, width) {
  const range = rangeOf(chart);
  const [least, most] = range.map((value) => String(Number(value.toPrecision(3))));
  const ramp = scale({ color: { type: "linear", domain: [0, STEPS - 1], range: rampOf(palette), interpolate: "rgb" } });
  const left = width - 20 - LETTER * most.length - 8 - 14 * STEPS;
  return element(
    "g",
    { "aria-hidden": "true", fill: palette.ink },
    ...(!Number.isFinite(range[0])
      ? []
      : [
          element("text", { x: left - 8, y: 16, "text-anchor": "end" }, `${chart.title}: ${least}`),
          ...Array.from({ length: STEPS }, (_, i) =>
            element("rect", { x: left + 14 * i, y: 6, width: 14, height: 12, fill: ramp.apply(i) }),
          ),
          element("text", { x: width - 20, y: 16, "text-anchor": "end" }, most),
        ]),
  );
}

/** Numbers to compare with. @param {ChartData} chart @param {Palette} palette @returns {Markish[]} */
function reported({ kind, reported: all, series, across }, palette) {
  if (all.length === 0 || kind === "heat") return [];
  const isFaceted = ["success", "box"].includes(kind) && series.length > 1 && across.title !== "";
  const at = !isFaceted
    ? { x: "x" }
    : { fx: "x", x: (/** @type {{ label: string }} */ { label }) => (series.includes(label) ? label : series[0]) };
  return [
    dot(all, {
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
 * Ticks at words and values, not more than there is room for; long words are cut.
 * @param {Scale} scale
 * @param {number} width
 */
function ticksOf({ values, words }, width) {
  const shown = values.filter((value) => value !== null);
  const room = (width - 90) / Math.max(1, shown.length);
  const longest = Math.max(1, ...shown.map((value) => wordOf(value, words).length));
  const isWords = shown.some((value) => typeof value === "string");
  const each = isWords ? 1 : Math.max(1, Math.ceil((Math.min(longest, 6) * LETTER + 8) / room));
  const letters = Math.max(3, Math.floor(room / LETTER));
  const cut = (/** @type {Cell} */ value) => {
    const whole = wordOf(value, words);
    return isWords && whole.length > letters ? `${whole.slice(0, letters - 1)}\u2026` : whole;
  };
  return { ticks: /** @type {any} */ (shown.filter((_, i) => i % each === 0)), tickFormat: /** @type {any} */ (cut) };
}

/** @param {Style} style */
function strokeOf({ colour, dash }) {
  return { stroke: colour, strokeWidth: 2, ...(dash ? { strokeDasharray: dash } : {}) };
}

/** The largest value across of all series. @param {ChartData} chart */
function lastOf({ distributions }) {
  return Math.max(...distributions.map(({ values }) => values[values.length - 1] ?? -Infinity));
}

/**
 * A distribution function as a line: it begins at 0, and holds to the end.
 * @param {ChartData["distributions"][number]} distribution
 * @param {number} end
 */
function stairs({ values, shares }, end) {
  if (values.length === 0) return [];
  const each = Math.ceil(values.length / MOST_STEPS);
  const some = values.flatMap((value, i) =>
    i % each === 0 || i === values.length - 1 ? [{ value, share: shares[i] }] : [],
  );
  return [{ value: values[0], share: 0 }, ...some, { value: end, share: shares[shares.length - 1] }];
}

/**
 * Writes the numbers of trials to their dots; dots of one box are apart.
 * @param {SVGSVGElement} picture
 * @param {ChartData} chart
 */
function markTrials(picture, { kind, points, across, series }) {
  // Boxes are about so wide.
  const room =
    (0.7 * (Number(picture.getAttribute("width")) - 82)) /
    (Math.max(1, across.values.length) * Math.max(1, series.length));
  for (const circle of picture.querySelectorAll("g.trials circle, g.trials path")) {
    const datum = /** @type {{ __data__?: number }} */ (/** @type {unknown} */ (circle)).__data__;
    const point = points[datum ?? -1];
    if (!point) continue;
    circle.setAttribute("class", "trial");
    circle.setAttribute("data-trial", String(point.trial));
    if (kind === "box")
      circle.setAttribute(
        "cx",
        String(Number(circle.getAttribute("cx")) + Math.min(36, 0.8 * room) * (((point.trial * 0.618034) % 1) - 0.5)),
      );
  }
}

/** @typedef {{ label: string, x: number, y: number, style: Style | null }} Entry */

/**
 * The places of the entries of the legend; of a ramp some.
 * @param {ChartData} chart
 * @param {(series: string) => Style} styleOf
 * @param {number} width
 * @returns {{ entries: Entry[], lines: number }}
 */
function legendOf({ kind, series, reported: all, across, isOrdered }, styleOf, width) {
  const isAxis = ["success", "box"].includes(kind) && across.title === "";
  const each = isOrdered ? Math.ceil((series.length - 1) / 6) : 1;
  const labels =
    series.length > 1 && !isAxis
      ? series
          .filter((_, i) => i % each === 0 || i === series.length - 1)
          .map((name) => ({ label: name || "all", style: styleOf(name) }))
      : [];
  const others = all.length > 0 && kind !== "heat" ? [{ label: "reported", style: null }] : [];
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
  const isFilled = kind === "success" || kind === "box";
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
