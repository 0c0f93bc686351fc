/** A heat map: medians, or shares, over two factors. */
import { labelOf, wordOf } from "../factors.js";
import { cells } from "../tables.js";
import { makeSvg as element } from "../../app/dom.js";
import { LETTER, ticksOf } from "./parts.js";
import { inWords, numbers, rounded, statistics } from "./summaries.js";

/** @import { ChartData } from "../charts.js" */
/** @import { Cell } from "../rows.js" */

/** Colours of the legend. */
const STEPS = 6;

/** @type {import("../charts.js").Chart} */
export const heat = {
  id: "heat",
  title: "Heat map",
  fits: () => true,
  controls: ["measure", "axis", "second"],
  swatch: "none",
  data(query) {
    const { axis, second, measure, discrete } = query;
    if (!axis || !second) return {};
    const all = cells(query, axis, second, measure).filter(({ x, y }) => x !== null && y !== null);
    return {
      summaries: all,
      counted: all.map(({ n }) => n),
      up: discrete(second),
      columns: [axis.column, second.column, "trials", "missing", ...statistics(measure)],
      rows: () => all.map((one) => [one.x, one.y ?? null, one.n, one.missing, ...numbers(one, measure)]),
      words: inWords(all, (one) => `${labelOf([axis, second], [one.x, one.y ?? null])}: ${rounded(one.middle)}`),
    };
  },
  marks(plot, chart, { width, palette, scale }) {
    const { across, up, summaries, counts } = chart;
    const [least, most] = rangeOf(chart);
    const isDark = (/** @type {{ middle: number | null }} */ { middle }) =>
      middle !== null && middle - least > 0.5 * (most - least);
    const some = summaries.filter(({ middle }) => middle !== null);
    const hasText = across.values.length * 42 < width - 80;
    const text = (/** @type {(one: typeof some[number]) => string} */ words, /** @type {object} */ more) =>
      plot.text(some, {
        x: "x",
        y: "y",
        text: words,
        fill: (/** @type {typeof some[number]} */ one) => (isDark(one) ? palette.stage : palette.ink),
        fontSize: 11,
        ...more,
      });
    const isUneven = counts.least < counts.most;
    const longest = Math.max(...up.values.map((value) => wordOf(value, up.words).length));
    return {
      marks: [
        plot.cell(some, { x: "x", y: "y", fill: "middle", inset: 0.5 }),
        ...(hasText
          ? [
              text((one) => rounded(one.middle), isUneven ? { dy: -6 } : {}),
              ...(isUneven ? [text(({ n }) => `n ${n}`, { dy: 7, fontSize: 9.5 })] : []),
            ]
          : []),
      ],
      legend: rampElement(chart, palette, width, scale),
      options: {
        marginLeft: Math.min(width / 3, Math.max(62, LETTER * longest + 20)),
        x: {
          label: across.title,
          labelArrow: "none",
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
  },
  remark: () => "Medians of trials with a path, or shares. Trials that differ in anything else are together.",
};

/** The least and the most; shares have the whole range. @param {ChartData} chart @returns {[number, number]} */
function rangeOf({ title, summaries }) {
  const values = summaries.flatMap(({ middle }) => (middle === null ? [] : [middle]));
  return title.endsWith("%") ? [0, 100] : [Math.min(...values), Math.max(...values)];
}

/** The colours, from the least to the most. @param {import("../../app/palette.js").Palette} palette @returns {[string, string]} */
function rampOf({ obstacle, start }) {
  return [obstacle, start];
}

/**
 * What the colours mean.
 * @param {ChartData} chart
 * @param {import("../../app/palette.js").Palette} palette
 * @param {number} width
 * @param {import("../charts.js").Look["scale"]} scale
 */
function rampElement(chart, palette, width, scale) {
  const range = rangeOf(chart);
  const [least, most] = range.map((value) => rounded(value));
  const ramp = scale([0, STEPS - 1], rampOf(palette));
  const left = width - 20 - LETTER * most.length - 8 - 14 * STEPS;
  return element(
    "g",
    { "aria-hidden": "true", fill: palette.ink },
    ...(!Number.isFinite(range[0])
      ? []
      : [
          element("text", { x: left - 8, y: 16, "text-anchor": "end" }, `${chart.title}: ${least}`),
          ...Array.from({ length: STEPS }, (_, i) =>
            element("rect", { x: left + 14 * i, y: 6, width: 14, height: 12, fill: ramp(i) }),
          ),
          element("text", { x: width - 20, y: 16, "text-anchor": "end" }, most),
        ]),
  );
}
