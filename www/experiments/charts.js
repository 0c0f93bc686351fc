/**
 * A chart of the rows without its drawing: what is across and up, its series, its data, the table behind it, and all of it in words.
 */
import { labelOf } from "./factors.js";
import { OF_PATHS, SOLVED, measureInfo, titled } from "./measures.js";
import { bins, cells, distributions, points, summaries } from "./tables.js";

/** @import { View } from "./link.js" */
/** @import { Factor } from "./factors.js" */
/** @import { Cell, Rows } from "./rows.js" */
/** @import { Bin, Point, Step, Summary } from "./tables.js" */

/**
 * @typedef {object} Scale   of an axis
 * @property {string} title
 * @property {boolean} isNumeric
 * @property {Cell[]} values   in order, unless it is continuous
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
 * @property {{ series: string, steps: Step[] }[]} steps
 * @property {Point[]} points
 * @property {Bin[]} bins
 * @property {NonNullable<View["reported"]>} reported
 * @property {{ columns: string[], rows: Cell[][] }} table
 * @property {string} words
 */

/** The kinds of charts, with their names. @type {Record<NonNullable<View["chart"]>, string>} */
export const KINDS = { success: "Success", box: "Boxes", line: "Line", ecdf: "Distribution", cost: "Cost and work", heat: "Heat map" };

/** What is shown where a view leaves it out. @param {View} view @param {Factor[]} factors @param {string[]} measures  of the document */
export function completed(view, factors, measures) {
  const numeric = factors.filter(({ isNumeric }) => isNumeric);
  const known = (/** @type {string | undefined} */ column) => factors.find((factor) => factor.column === column);
  const axis = known(view.axis) ?? numeric[0] ?? factors[0];
  const second = known(view.second) ?? numeric.find((factor) => factor !== axis) ?? factors.find((factor) => factor !== axis);
  const usual = numeric.length > 1 ? "heat" : (numeric[0]?.values.length ?? 0) > 3 ? "line" : "success";
  const kind = view.chart === "heat" && !second ? "success" : view.chart ?? usual;
  const measure = view.measure ?? (kind === "line" || kind === "heat" ? SOLVED : measures.find((id) => id !== SOLVED) ?? "length");
  const work = view.work ?? measures.find((id) => ![SOLVED, ...OF_PATHS].includes(id)) ?? "clearance_evaluations";
  // A chart of values has no share.
  const isValue = kind === "box" || kind === "cost";
  return { kind, axis, second: second === axis ? undefined : second, measure: isValue && measure === SOLVED ? "length" : measure, work, isLog: view.isLog ?? false };
}

/** @param {Rows} rows @param {Factor[]} factors @param {View} view @param {string[]} measures @param {string} lengthUnit @returns {ChartData} */
export function chartOf(rows, factors, view, measures, lengthUnit) {
  const { kind, axis, second, measure, work, isLog } = completed(view, factors, measures);
  const shown = kind === "success" ? SOLVED : measure;
  const title = (/** @type {string} */ id) => titled(measureInfo(id, lengthUnit));
  /** @param {Factor | undefined} factor @returns {Scale} */
  const scaleOf = (factor) => ({ title: factor ? titled(factor) : "", isNumeric: factor?.isNumeric ?? false, values: factor?.values ?? [null] });
  /** @param {string} id @returns {Scale} */
  const continuous = (id) => ({ title: title(id), isNumeric: true, values: [], isLog: isLog && id !== SOLVED });
  /** @type {ChartData} */
  const chart = {
    kind, title: "", across: scaleOf(axis), up: continuous(shown), series: [], isOrdered: false, summaries: [], steps: [], points: [], bins: [],
    reported: view.reported ?? [], table: { columns: [], rows: [] }, words: "",
  };
  const named = axis ? [axis.column] : [];
  if (kind === "ecdf") {
    const all = distributions(rows, factors, work);
    Object.assign(chart, { across: continuous(work), up: { ...continuous(SOLVED), title: `share of trials solved, %` }, steps: all, title: `Share of trials solved after so many ${title(work)}` });
    chart.series = all.map(({ series }) => series);
    chart.table = { columns: ["series", work, "share_percent"], rows: all.flatMap(({ steps }) => steps.map(({ series, value, share }) => [series, value, share])) };
    chart.words = all.map(({ series, n, missing }) => `${series || "all trials"}: ${n} of ${n + missing} solved`).join("; ");
  } else if (kind === "cost") {
    const by = axis?.isNumeric ? axis : undefined;
    const all = points(rows, factors, by, measure, work);
    Object.assign(chart, { across: continuous(work), up: { ...continuous(measure), isLog: false }, points: all, bins: bins(all, by !== undefined), title: `${title(measure)} against ${title(work)}` });
    chart.series = [...new Set(all.map(({ series }) => series))];
    chart.table = { columns: ["series", "trials", work, "lower_quartile", "median", "upper_quartile"], rows: chart.bins.map(({ series, n, work: at, low, middle, high }) => [series, n, at, low, middle, high]) };
    chart.words = `${all.length} trials with a path`;
  } else if (kind === "heat" && axis && second) {
    const all = cells(rows, axis, second, measure).filter(({ x, y }) => x !== null && y !== null);
    Object.assign(chart, { up: scaleOf(second), summaries: all, series: [""], title: title(measure) });
    chart.table = { columns: [axis.column, second.column, "trials", "missing", ...statistics(shown)], rows: all.map((one) => [one.x, one.y ?? null, one.n, one.missing, ...numbers(one, shown)]) };
    chart.words = describe(all, (one) => `${labelOf([axis, second], [one.x, one.y ?? null])}: ${rounded(one.middle)}`);
  } else {
    const all = summaries(rows, factors, axis, shown);
    chart.summaries = kind === "line" && axis?.isNumeric ? all.filter(({ x }) => x !== null) : all;
    // What does not have the parameter is a level line.
    chart.series = [...new Set(all.map(({ series }) => series))];
    if (kind === "box") chart.points = points(rows, factors, axis, shown, "iterations");
    chart.title = title(shown);
    chart.table = { columns: [...named, "series", "trials", "missing", ...statistics(shown)], rows: all.map((one) => [...named.map(() => one.x), one.series, one.n, one.missing, ...numbers(one, shown)]) };
    chart.words = describe(all, (one) => `${[axis ? labelOf([axis], [one.x]) : "", one.series].filter(Boolean).join(", ") || "all trials"}: ${rounded(one.middle)}`);
    if (kind === "line" && axis?.isNumeric) chart.summaries.push(...levels(all, axis));
  }
  const others = factors.filter((factor) => kind === "ecdf" || (kind === "cost" && !axis?.isNumeric) || factor !== axis);
  chart.isOrdered = chart.series.length > 4 && others.length === 1 && others[0].isNumeric;
  const more = chart.reported.map(({ x, value, label }) => chart.table.columns.map((column, i) => (i === 0 ? x : column === "series" ? `reported: ${label}` : ["median", "percent", "share_percent"].includes(column) ? value : null)));
  chart.table.rows.push(...more);
  return chart;
}

/** Settings without the parameter across, at both ends of the axis: a level line. @param {Summary[]} all @param {Factor} axis */
function levels(all, { values }) {
  const numeric = values.filter((value) => value !== null);
  return all.filter(({ x }) => x === null).flatMap((one) => [numeric[0], numeric[numeric.length - 1]].map((x) => ({ ...one, x })));
}

/** @param {string} measure */
function statistics(measure) {
  return measure === SOLVED ? ["percent", "low", "high"] : ["least", "lower_quartile", "median", "upper_quartile", "most"];
}

/** @param {Summary} one @param {string} measure @returns {Cell[]} */
function numbers({ least = null, low, middle, high, most = null }, measure) {
  return measure === SOLVED ? [middle, low, high] : [least, low, middle, high, most];
}

/** Some of many in words. @template T @param {T[]} all @param {(one: T) => string} sentence */
function describe(all, sentence) {
  const some = all.slice(0, 12).map(sentence).join("; ");
  return all.length > 12 ? `${some}; and ${all.length - 12} more in the table` : some;
}

/** @param {number | null} value */
export function rounded(value) { return value === null ? "no value" : String(Number(value.toPrecision(3))); }
