/**
 * The tables behind the charts: statistics of groups of trials, by the core. A measure is that of trials with a path;
 * others count as missing, and in the empirical distribution function as failures.
 */
import { ecdf, quartiles, share } from "planarium/full";
import { groupsOf, labelOf } from "./factors.js";
import { SOLVED, isShare, scaleOf } from "./measures.js";

/** @import { Factor } from "./factors.js" */
/** @import { Cell, Rows } from "./rows.js" */

/**
 * The rows, their factors, and which trials count: all that have ended, or some.
 * @typedef {{ rows: Rows, factors: Factor[], which: Uint8Array | null }} Selection
 */

/**
 * A record of a table. `x`: the value of the factor across; `series`: the others in words; `low` and `high`: the
 * quartiles, or the ends of Wilson's interval.
 * @typedef {{ x: Cell, y?: Cell, series: string, n: number, missing: number, middle: number | null, low: number | null,
 *   high: number | null, least?: number | null, most?: number | null }} Summary
 * @typedef {{ series: string, n: number, missing: number, values: number[], shares: number[] }} Distribution   shares
 *   in percent
 * @typedef {{ trial: number, x: Cell, series: string, work: number, value: number }} Point   a trial with a path
 * @typedef {{ series: string, n: number, work: number, middle: number, low: number, high: number }} Bin
 */

/** Trials drawn as dots, about. */
const DOTS = 2000;
/** Trials of a bin at least, and bins of a series at most. */
const LEAST = 5;
const BINS = 12;

/**
 * The values of a measure: NaN without a path.
 * @param {Rows} rows
 * @param {ArrayLike<number>} trials
 * @param {string} measure
 */
export function sampleOf(rows, trials, measure) {
  const solved = (rows.values.get("status") ?? []).indexOf("solved");
  const status = rows.codes.get("status") ?? new Uint32Array();
  if (measure === SOLVED) return Float64Array.from(trials, (trial) => Number(status[trial] === solved));
  if (isShare(measure))
    return Float64Array.from(trials, (trial) => (status[trial] === solved ? Number(rows.cell(trial, measure)) : NaN));
  const [numbers, scale] = [rows.of(measure), scaleOf(measure)];
  return Float64Array.from(trials, (trial) => (status[trial] === solved ? scale * numbers[trial] : NaN));
}

/**
 * The groups by the value of some factors across and the words for the others.
 * @param {Selection} selection
 * @param {(Factor | undefined)[]} across
 */
function grouped({ rows, factors, which }, across) {
  const others = factors.filter((factor) => !across.includes(factor));
  return groupsOf(rows, factors, which).map(({ values, trials }) => ({
    trials,
    series: labelOf(
      others,
      others.map((factor) => values[factors.indexOf(factor)]),
    ),
    place: across.map((factor) => (factor ? values[factors.indexOf(factor)] : null)),
  }));
}

/**
 * Statistics of a measure for each value across and each series.
 * @param {Selection} selection
 * @param {Factor | undefined} axis
 * @param {string} measure
 * @returns {Summary[]}
 */
export function summaries(selection, axis, measure) {
  return grouped(selection, [axis]).map(({ trials, series, place: [x] }) => ({
    x,
    series,
    ...summary(selection.rows, trials, measure),
  }));
}

/** A number without the rounding of its last digits: 63.75 for 63.74999999999999. @param {number} value */
export const clean = (value) => Number(value.toPrecision(12));

/** @param {Rows} rows @param {number[]} trials @param {string} measure */
function summary(rows, trials, measure) {
  const sample = sampleOf(rows, trials, measure);
  if (isShare(measure)) {
    const { n, missing, share: middle, low, high } = share(sample);
    const percent = (/** @type {number | null} */ value) => (value === null ? null : clean(100 * value));
    return { n, missing, middle: percent(middle), low: percent(low), high: percent(high) };
  }
  const { n, missing, values } = quartiles(sample);
  const [least, low, middle, high, most] = values ?? [null, null, null, null, null];
  return { n, missing, middle, low, high, least, most };
}

/**
 * A statistic for each pair of values; trials that differ in others are together.
 * @param {Selection} selection
 * @param {Factor} across
 * @param {Factor} up
 * @param {string} measure
 * @returns {Summary[]}
 */
export function cells(selection, across, up, measure) {
  const { rows } = selection;
  return grouped({ ...selection, factors: [across, up] }, [across, up]).map(({ trials, place: [x, y] }) => ({
    x,
    y,
    series: "",
    ...summary(rows, trials, measure),
  }));
}

/**
 * The share of all trials of a series that have a path, by work.
 * @param {Selection} selection
 * @param {string} work
 * @returns {Distribution[]}
 */
export function distributions(selection, work) {
  return grouped(selection, []).map(({ trials, series }) => {
    const { n, missing, values, shares } = ecdf(sampleOf(selection.rows, trials, work));
    return { series, n, missing, values, shares: shares.map((one) => clean(100 * one)) };
  });
}

/** Of how many trials one is drawn as a dot. @param {Rows} rows */
export const perDot = (rows) => Math.max(1, Math.ceil(rows.done / DOTS));

/**
 * Some of the trials with a path, evenly.
 * @param {Selection} selection
 * @param {Factor | undefined} axis
 * @param {string} measure
 * @param {string} work
 * @returns {Point[]}
 */
export function points(selection, axis, measure, work) {
  const { rows } = selection;
  const each = perDot(rows);
  return grouped(selection, [axis]).flatMap(({ trials, series, place: [x] }) => {
    const some = trials.filter((_, i) => i % each === 0);
    const [values, works] = [sampleOf(rows, some, measure), sampleOf(rows, some, work)];
    return some.flatMap((trial, i) =>
      Number.isNaN(values[i]) ? [] : [{ trial, x, series, work: works[i], value: values[i] }],
    );
  });
}

/**
 * The quartiles of trials with a path and about the same work, by series: those with one value of the axis, or else
 * equally many.
 * @param {Selection} selection
 * @param {Factor | undefined} axis
 * @param {string} measure
 * @param {string} work
 * @returns {Bin[]}  by rising work
 */
export function bins(selection, axis, measure, work) {
  const { rows } = selection;
  return grouped(selection, [axis])
    .flatMap(({ trials, series, place: [x] }) => {
      const values = sampleOf(rows, trials, measure);
      const solved = trials.filter((_, i) => !Number.isNaN(values[i]));
      const works = sampleOf(rows, solved, work);
      const parts = x !== null ? [solved] : equal(solved.map((trial, i) => ({ trial, work: works[i] })));
      return parts
        .filter(({ length }) => length > 0)
        .map((part) => {
          const [at, of] = [work, measure].map((column) => quartiles(sampleOf(rows, part, column)).values ?? []);
          return {
            series,
            n: part.length,
            work: Number(at[2]),
            low: Number(of[1]),
            middle: Number(of[2]),
            high: Number(of[3]),
          };
        });
    })
    .sort((a, b) => a.work - b.work);
}

/** Equally many trials with about the same work. @param {{ trial: number, work: number }[]} all */
function equal(all) {
  const sorted = all.sort((a, b) => a.work - b.work).map(({ trial }) => trial);
  const count = Math.min(BINS, Math.floor(sorted.length / LEAST));
  return Array.from({ length: count }, (_, i) =>
    sorted.slice(Math.floor((i * sorted.length) / count), Math.floor(((i + 1) * sorted.length) / count)),
  );
}
