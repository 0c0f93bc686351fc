/**
 * A chart of the rows without its drawing: what is across and up, its series, its data, the table behind it, and all of
 * it in words.
 */
import { grouped } from "../app/dom.js";
import { labelOf } from "./factors.js";
import { OF_PATHS, SOLVED, allMeasures, isShare, measureInfo, titled } from "./measures.js";
import { bins, cells, distributions, points, summaries } from "./tables.js";

/** @import { View } from "./link.js" */
/** @import { Factor, Words } from "./factors.js" */
/** @import { Cell, Rows } from "./rows.js" */
/** @import { Bin, Distribution, Point, Summary } from "./tables.js" */

/**
 * @typedef {object} Scale   of an axis
 * @property {string} title
 * @property {boolean} isNumeric
 * @property {Cell[]} values   in order, unless it is continuous
 * @property {Words} [words]   of values
 * @property {boolean} [isLog]
 *
 * @typedef {object} ChartData
 * @property {NonNullable<View["chart"]>} kind
 * @property {string} title
 * @property {Scale} across
 * @property {Scale} up
 * @property {string[]} series   in words; one empty string where there is one only
 * @property {boolean} isOrdered   whether the series are many values of one number
 * @property {Summary[]} summaries
 * @property {Distribution[]} distributions
 * @property {Point[]} points
 * @property {Bin[]} bins
 * @property {NonNullable<View["reported"]>} reported
 * @property {string[]} columns   of the table behind it
 * @property {() => Cell[][]} rows   of the table
 * @property {string} words
 */

/** Trials drawn as dots, about. */
const DOTS = 2000;

/** The kinds of charts, with their names. @type {Record<NonNullable<View["chart"]>, string>} */
export const KINDS = {
  success: "Success",
  box: "Boxes",
  line: "Line",
  ecdf: "Distribution",
  cost: "Cost and work",
  heat: "Heat map",
};

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
  const usualKind = numeric.length > 1 ? "heat" : (numeric[0]?.values.length ?? 0) > 3 ? "line" : "success";
  const kind = view.chart === "heat" && !second ? "success" : (view.chart ?? usualKind);
  const measure =
    one(view.measure) ?? (kind === "success" || kind === "line" || kind === "heat" ? SOLVED : (asked[0] ?? "length"));
  const work =
    one(isShare(view.work ?? "") ? undefined : view.work) ??
    asked.find((id) => ![SOLVED, ...OF_PATHS].includes(id)) ??
    "clearance_evaluations";
  // Some charts are of shares, others of values.
  const [fits, usual] =
    kind === "success"
      ? [isShare(measure), SOLVED]
      : [kind === "line" || kind === "heat" || !isShare(measure), "length"];
  return { kind, axis, second, measure: fits ? measure : usual, work, isLog: view.isLog ?? false };
}

/**
 * @param {Rows} rows
 * @param {Factor[]} factors
 * @param {View} view
 * @param {string[]} asked
 * @param {string} lengthUnit
 * @returns {ChartData}
 */
export function chartOf(rows, factors, view, asked, lengthUnit) {
  const { kind, axis, second, measure, work, isLog } = completed(view, factors, asked, allMeasures(rows.columns));
  const title = (/** @type {string} */ id) => titled(measureInfo(id, lengthUnit));
  /** @param {Factor | undefined} factor @returns {Scale} */
  const discrete = (factor) => ({
    title: factor ? titled(factor) : "",
    isNumeric: factor?.isNumeric ?? false,
    values: factor?.values ?? [null],
    words: factor?.words,
  });
  /** @param {string} id @param {boolean} canBeLog @returns {Scale} */
  const continuous = (id, canBeLog) => ({
    title: title(id),
    isNumeric: true,
    values: [],
    isLog: canBeLog && isLog && !isShare(id),
  });
  const by = kind === "ecdf" || (kind === "cost" && !axis?.isNumeric) ? undefined : axis;
  const others = factors.filter((factor) => factor !== by);
  /** @type {ChartData} */
  const chart = {
    kind,
    title: title(measure),
    across: discrete(axis),
    up: continuous(measure, true),
    series: [],
    isOrdered: false,
    summaries: [],
    distributions: [],
    points: [],
    bins: [],
    reported: view.reported ?? [],
    columns: [],
    rows: () => [],
    words: "",
  };
  if (kind === "ecdf") {
    const all = (chart.distributions = distributions(rows, factors, work));
    chart.title = `Share of trials solved, by ${title(work)}`;
    [chart.across, chart.up] = [
      continuous(work, true),
      { ...continuous(SOLVED, false), title: "share of trials solved, %" },
    ];
    chart.columns = ["series", work, "share_percent"];
    chart.rows = () =>
      all.flatMap(({ series, values, shares }) => values.map((value, i) => [series, value, shares[i]]));
    chart.words = describe(
      all,
      ({ series, n, missing }) => `${series || "all trials"}: ${grouped(n)} of ${grouped(n + missing)} solved`,
    );
  } else if (kind === "cost") {
    chart.title = `${title(measure)} against ${title(work)}`;
    [chart.across, chart.up] = [continuous(work, true), continuous(measure, false)];
    chart.points = points(rows, factors, by, measure, work, DOTS);
    chart.bins = bins(rows, factors, by, measure, work);
    chart.columns = ["series", "trials", work, "lower_quartile", "median", "upper_quartile"];
    chart.rows = () =>
      chart.bins.map(({ series, n, work: at, low, middle, high }) => [series, n, at, low, middle, high]);
    chart.words = `${grouped(rows.done)} trials`;
  } else if (kind === "heat" && axis && second) {
    const all = (chart.summaries = cells(rows, axis, second, measure).filter(({ x, y }) => x !== null && y !== null));
    chart.up = discrete(second);
    chart.columns = [axis.column, second.column, "trials", "missing", ...statistics(measure)];
    chart.rows = () => all.map((one) => [one.x, one.y ?? null, one.n, one.missing, ...numbers(one, measure)]);
    chart.words = describe(all, (one) => `${labelOf([axis, second], [one.x, one.y ?? null])}: ${rounded(one.middle)}`);
  } else {
    const all = summaries(rows, factors, axis, measure);
    const isLevel = kind === "line" && axis?.isNumeric;
    chart.summaries = isLevel ? [...all.filter(({ x }) => x !== null), ...levels(all, axis)] : all;
    if (kind === "box") chart.points = points(rows, factors, axis, measure, "iterations", DOTS);
    chart.columns = [...(axis ? [axis.column] : []), "series", "trials", "missing", ...statistics(measure)];
    chart.rows = () =>
      all.map((one) => [...(axis ? [one.x] : []), one.series, one.n, one.missing, ...numbers(one, measure)]);
    chart.words = describe(
      all,
      (one) =>
        `${[axis ? labelOf([axis], [one.x]) : "", one.series].filter(Boolean).join(", ") || "all trials"}: ${rounded(one.middle)}`,
    );
  }
  chart.series = [
    ...new Set([...chart.summaries, ...chart.distributions, ...chart.points].map(({ series }) => series)),
  ];
  chart.isOrdered = chart.series.length > 4 && others.length === 1 && others[0].isNumeric;
  return withReported(chart);
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

/**
 * Settings without the parameter across, at both ends of the axis: a level line.
 * @param {Summary[]} all
 * @param {Factor} axis
 */
function levels(all, { values }) {
  const numeric = values.filter((value) => value !== null);
  return all
    .filter(({ x }) => x === null)
    .flatMap((one) => [numeric[0], numeric[numeric.length - 1]].map((x) => ({ ...one, x })));
}

/** @param {string} measure */
function statistics(measure) {
  return isShare(measure)
    ? ["percent", "low", "high"]
    : ["least", "lower_quartile", "median", "upper_quartile", "most"];
}

/** @param {Summary} one @param {string} measure @returns {Cell[]} */
function numbers({ least = null, low, middle, high, most = null }, measure) {
  return isShare(measure) ? [middle, low, high] : [least, low, middle, high, most];
}

/** Some of many in words. @template T @param {T[]} all @param {(one: T) => string} sentence */
function describe(all, sentence) {
  const some = all.slice(0, 12).map(sentence).join("; ");
  return all.length > 12 ? `${some}; and ${grouped(all.length - 12)} more in the table` : some;
}

/** @param {number | null} value */
export function rounded(value) {
  return value === null ? "no value" : String(Number(value.toPrecision(3)));
}
