/**
 * The charts: one object a kind in a table. A chart of the rows without its drawing is its data: what is across and up,
 * its series, the table behind it, and all of it in words.
 */
import { box } from "./charts/box.js";
import { cost } from "./charts/cost.js";
import { ecdf } from "./charts/ecdf.js";
import { heat } from "./charts/heat.js";
import { line } from "./charts/line.js";
import { success } from "./charts/success.js";
import { counted, grouped } from "../app/dom.js";
import { commonTrials } from "./common.js";
import { OF_PATHS, SOLVED, allMeasures, isShare, measureInfo, titled } from "./measures.js";
import { perDot } from "./tables.js";

/** @import { Markish, PlotOptions } from "@observablehq/plot" */
/** @import { Palette } from "../app/palette.js" */
/** @import { Common } from "./common.js" */
/** @import { Factor, Words } from "./factors.js" */
/** @import { View } from "./link.js" */
/** @import { Cell, Rows } from "./rows.js" */
/** @import { Bin, Distribution, Point, Summary } from "./tables.js" */

/** @typedef {typeof import("@observablehq/plot")} Plot   which is loaded with the first drawing */

/**
 * @typedef {object} Chart   a kind of chart
 * @property {string} id   in links
 * @property {string} title   of its button
 * @property {(measure: string) => boolean} fits   whether it shows a measure
 * @property {("measure" | "work" | "axis" | "second" | "log")[]} controls   that choose what it shows; a chart with
 *   `second` needs two factors
 * @property {"bar" | "line" | "none"} swatch   of its series in the legend; series of bars are named by the axis where
 *   nothing else is across
 * @property {(axis: Factor | undefined) => Factor | undefined} [groupedBy]   the factor that is no part of the series;
 *   the one across, unless it says another
 * @property {boolean} [isOfAll]   whether it needs the trials without a path, too
 * @property {(query: Query) => Partial<ChartData>} data
 * @property {(plot: Plot, chart: ChartData, look: Look) => { marks: Markish[], options: PlotOptions, above?: number,
 *   legend?: SVGElement }} marks   `above`: pixels that it needs above the frame
 * @property {(chart: ChartData) => string} remark   what its marks mean
 *
 * @typedef {object} Query   what a chart is asked for
 * @property {Rows} rows
 * @property {Factor[]} factors
 * @property {Uint8Array | null} which   trials that count; null: all that have ended
 * @property {Factor | undefined} axis   across
 * @property {Factor | undefined} second   up, of a heat map
 * @property {Factor | undefined} by   the factor that is no part of the series
 * @property {string} measure
 * @property {string} work
 * @property {(factor: Factor | undefined) => Scale} discrete
 * @property {(measure: string, canBeLog: boolean) => Scale} continuous
 *
 * @typedef {object} Look
 * @property {number} width
 * @property {Palette} palette
 * @property {(series: string) => Style} styleOf
 * @property {(domain: [number, number], range: [string, string]) => (value: number) => string} scale   of colours
 *
 * @typedef {{ colour: string, dash: string, symbol: import("@observablehq/plot").SymbolType }} Style   of a series
 *
 * @typedef {object} Scale   of an axis
 * @property {string} title
 * @property {boolean} isNumeric
 * @property {Cell[]} values   in order, unless it is continuous
 * @property {Words} [words]   of values
 * @property {boolean} [isLog]
 *
 * @typedef {object} ChartData
 * @property {Chart} kind
 * @property {string} title
 * @property {string} measure
 * @property {Scale} across
 * @property {Scale} up
 * @property {string[]} series   in words; one empty string where there is one only
 * @property {boolean} isOrdered   whether the series are many values of one number
 * @property {Summary[]} summaries
 * @property {Distribution[]} distributions
 * @property {Point[]} points
 * @property {number} each   of how many trials one is a point
 * @property {Bin[]} bins
 * @property {number[]} counted   the numbers of trials behind its marks
 * @property {{ least: number, most: number }} counts   their range
 * @property {Common | null} common   the trials that it is restricted to
 * @property {number | null} ceiling   per cent that can be solved, where this is less than all and the same everywhere
 * @property {NonNullable<View["reported"]>} reported
 * @property {string[]} columns   of the table behind it
 * @property {() => Cell[][]} rows   of the table
 * @property {string} words
 */

/** All charts, in the order of their buttons. */
export const CHARTS = [success, box, ecdf, cost, line, heat];

/**
 * What is shown where a view leaves it out, or has what is not there.
 * @param {View} view
 * @param {Factor[]} factors
 * @param {string[]} asked  measures of the document
 * @param {string[]} all  measures
 */
export function completed(view, factors, asked, all) {
  const one = (/** @type {string | undefined} */ id) => (id !== undefined && all.includes(id) ? id : undefined);
  const numeric = factors.filter(({ isNumeric }) => isNumeric);
  const known = (/** @type {string | undefined} */ column) => factors.find((factor) => factor.column === column);
  const axis = known(view.axis) ?? numeric[0] ?? factors[0];
  // What is across is not up, too.
  const second = [known(view.second), ...numeric, ...factors].find((factor) => factor !== undefined && factor !== axis);
  const usual = numeric.length > 1 ? heat : (numeric[0]?.values.length ?? 0) > 3 ? line : success;
  const chosen = CHARTS.find(({ id }) => id === view.chart) ?? usual;
  const kind = chosen.controls.includes("second") && !second ? success : chosen;
  // Some charts are of shares, others of values.
  const first = [one(view.measure), kind.fits(SOLVED) ? SOLVED : asked.find((id) => one(id)), "length"];
  const measure = first.find((id) => id !== undefined && kind.fits(id)) ?? SOLVED;
  const work =
    one(isShare(view.work ?? "") ? undefined : view.work) ??
    asked.find((id) => one(id) && ![SOLVED, ...OF_PATHS].includes(id)) ??
    "clearance_evaluations";
  const canBeCommon = !isShare(measure) && !kind.isOfAll && factors.some(({ column }) => column.startsWith("planner"));
  return {
    kind,
    axis,
    second,
    measure,
    work,
    // What the chart is about.
    subject: kind.controls.includes("measure") ? measure : work,
    isLog: view.isLog ?? false,
    canBeCommon,
    isCommon: canBeCommon && (view.isCommon ?? false),
  };
}

/**
 * @param {Rows} rows
 * @param {Factor[]} factors
 * @param {View} view
 * @param {string[]} asked
 * @param {string} lengthUnit
 * @param {{ most: number } | null} [ceiling]  per cent of trials that can be solved
 * @param {string[]} [measures]  that are offered
 * @returns {ChartData}
 */
export function chartOf(rows, factors, view, asked, lengthUnit, ceiling = null, measures = allMeasures(rows.columns)) {
  const { isLog, isCommon, ...what } = completed(view, factors, asked, measures);
  const { kind, axis, measure } = what;
  const title = (/** @type {string} */ id) => titled(measureInfo(id, lengthUnit));
  const by = kind.groupedBy ? kind.groupedBy(axis) : axis;
  const others = factors.filter((factor) => factor !== by);
  const common = isCommon ? commonTrials(rows, factors) : null;
  /** @type {Query} */
  const query = {
    ...what,
    rows,
    factors,
    by,
    which: common?.which ?? null,
    discrete: (factor) => ({
      title: factor ? titled(factor) : "",
      isNumeric: factor?.isNumeric ?? false,
      values: factor?.values ?? [null],
      words: factor?.words,
    }),
    continuous: (id, canBeLog) => ({
      title: title(id),
      isNumeric: true,
      values: [],
      isLog: canBeLog && isLog && !isShare(id),
    }),
  };
  /** @type {ChartData} */
  const chart = {
    kind,
    title: title(measure),
    measure,
    across: query.discrete(axis),
    up: query.continuous(measure, true),
    series: [],
    isOrdered: false,
    summaries: [],
    distributions: [],
    points: [],
    each: perDot(rows),
    bins: [],
    counted: [],
    counts: { least: 0, most: 0 },
    common,
    ceiling: null,
    reported: view.reported ?? [],
    columns: [],
    rows: () => [],
    words: "",
    ...kind.data(query),
  };
  const { summaries, distributions, points, counted } = chart;
  chart.series = [...new Set([...summaries, ...distributions, ...points].map(({ series }) => series))];
  chart.isOrdered = chart.series.length > 4 && others.length === 1 && others[0].isNumeric;
  if (counted.length > 0) {
    const sorted = counted.toSorted((a, b) => a - b);
    chart.counts = { least: sorted[0], most: sorted[sorted.length - 1] };
  }
  const isOfPaths = kind.isOfAll || (measure === SOLVED && !kind.controls.includes("second"));
  const isSame = !factors.some(({ column }) => /^(?:world|query)/.test(column));
  if (ceiling && ceiling.most < 100 && isOfPaths && isSame) chart.ceiling = ceiling.most;
  return withReported(chart);
}

/** The numbers of trials behind the marks. @param {ChartData} chart */
export function countsOf({ counts: { least, most } }) {
  return least === most ? `n = ${grouped(most)} each` : `n = ${grouped(least)} to ${grouped(most)}`;
}

/** Whether a logarithmic axis has no place for some values. @param {ChartData} chart */
function hasZero({ kind, across, up, summaries, distributions, points }) {
  const isUp = () =>
    points.some(({ value }) => value === 0) ||
    summaries.some(({ least, low, middle }) => low === 0 || middle === 0 || (kind === box && least === 0));
  const isAcross = () =>
    points.some(({ work }) => work === 0) || distributions.some(({ values }) => values.includes(0));
  return (up.isLog && isUp()) || (across.isLog && isAcross());
}

/** What a chart shows, in sentences. @param {ChartData} chart */
export function remarkOf(chart) {
  const { kind, common, counted: all } = chart;
  const sentences = [kind.remark(chart)];
  if (all.length > 0) sentences.push(`${countsOf(chart)}.`);
  if (hasZero(chart)) sentences.push("Values of 0 lie on the edge of the logarithmic axis.");
  if (chart.ceiling !== null) sentences.push("Dotted line: what can be solved at most.");
  if (common) {
    const { pairs, settings, left } = common;
    const names = left.length > 3 ? counted(left.length, "setting") : left.join("; ");
    const less = left.length > 0 ? ` Left out, as they solve less than half of their trials: ${names}.` : "";
    sentences.push(
      `Only the ${counted(pairs, "world and seed", "worlds and seeds")} that all ${settings} settings solved.${less}`,
    );
  }
  return sentences.join(" ");
}

/** The table also has the numbers to compare with. @param {ChartData} chart @returns {ChartData} */
function withReported(chart) {
  const { columns, rows, reported } = chart;
  const more = reported.map(({ x, value, label }) =>
    columns.map((column, i) => {
      if (column === "series") return `reported: ${label}`;
      return ["median", "percent", "share_percent"].includes(column)
        ? value
        : i === 0 || !columns.includes("series")
          ? x
          : null;
    }),
  );
  return { ...chart, rows: () => [...rows(), ...more] };
}
