/** A row for each value across and each series: the table of bars, boxes and lines. */
import { grouped } from "../../app/dom.js";
import { labelOf } from "../factors.js";
import { isShare } from "../measures.js";
import { summaries } from "../tables.js";

/** @import { ChartData, Query } from "../charts.js" */
/** @import { Factor } from "../factors.js" */
/** @import { Cell } from "../rows.js" */
/** @import { Summary } from "../tables.js" */

/** @param {Query} query @returns {Partial<ChartData>} */
export function bySettings(query) {
  const { axis, measure } = query;
  const all = summaries(query, axis, measure);
  return {
    summaries: all,
    counted: all.map(({ n }) => n),
    columns: [...(axis ? [axis.column] : []), "series", "trials", "missing", ...statistics(measure)],
    rows: () => all.map((one) => [...(axis ? [one.x] : []), one.series, one.n, one.missing, ...numbers(one, measure)]),
    words: inWords(
      all,
      (one) =>
        `${[axis ? labelOf([axis], [one.x]) : "", one.series].filter(Boolean).join(", ") || "all trials"}: ${rounded(one.middle)}`,
    ),
  };
}

/**
 * Settings without the parameter across are at both ends of the axis: a level line.
 * @param {Summary[]} all
 * @param {Factor} axis
 */
export function level(all, { values }) {
  const numeric = values.filter((value) => value !== null);
  return [
    ...all.filter(({ x }) => x !== null),
    ...all
      .filter(({ x }) => x === null)
      .flatMap((one) => [numeric[0], numeric[numeric.length - 1]].map((x) => ({ ...one, x }))),
  ];
}

/** The columns of a summary. @param {string} measure */
export function statistics(measure) {
  return isShare(measure)
    ? ["percent", "low", "high"]
    : ["least", "lower_quartile", "median", "upper_quartile", "most"];
}

/** The cells of a summary. @param {Summary} one @param {string} measure @returns {Cell[]} */
export function numbers({ least = null, low, middle, high, most = null }, measure) {
  return isShare(measure) ? [middle, low, high] : [least, low, middle, high, most];
}

/** Some of many in words. @template T @param {T[]} all @param {(one: T) => string} sentence */
export function inWords(all, sentence) {
  const some = all.slice(0, 12).map(sentence).join("; ");
  return all.length > 12 ? `${some}; and ${grouped(all.length - 12)} more in the table` : some;
}

/** @param {number | null} value */
export function rounded(value) {
  return value === null ? "no value" : String(Number(value.toPrecision(3)));
}
