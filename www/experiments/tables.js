/**
 * The tables behind the charts: statistics of groups of trials, by the core. A measure is that of trials with a path; others count as
 * missing, and in the empirical distribution function as failures.
 */
import { ecdf, quartiles, share } from "planarium";
import { groupsOf, labelOf } from "./factors.js";
import { SOLVED, scaleOf } from "./measures.js";

/** @import { Factor } from "./factors.js" */
/** @import { Cell, Rows } from "./rows.js" */

/**
 * A record of a table. `x`: the value of the factor across; `series`: the others in words; `low` and `high`: the quartiles, or the ends
 * of Wilson's interval.
 * @typedef {{ x: Cell, y?: Cell, series: string, n: number, missing: number, middle: number | null, low: number | null, high: number | null,
 *   least?: number | null, most?: number | null }} Summary
 * @typedef {{ series: string, value: number, share: number }} Step   of a distribution function
 * @typedef {{ trial: number, x: Cell, series: string, work: number, value: number }} Point   a trial with a path
 * @typedef {{ series: string, n: number, work: number, middle: number, low: number, high: number }} Bin
 */

/** Trials of a bin at least, and bins of a series at most. */
const LEAST = 5;
const BINS = 12;

/** The values of a measure: NaN without a path. @param {Rows} rows @param {ArrayLike<number>} trials @param {string} measure */
export function sampleOf(rows, trials, measure) {
  const solved = (rows.values.get("status") ?? []).indexOf("solved");
  const status = rows.codes.get("status") ?? new Uint32Array();
  if (measure === SOLVED) return Float64Array.from(trials, (trial) => Number(status[trial] === solved));
  const [numbers, scale] = [rows.of(measure), scaleOf(measure)];
  return Float64Array.from(trials, (trial) => (status[trial] === solved ? scale * numbers[trial] : NaN));
}

/** The groups by the value of some factors across and the words for the others. @param {Rows} rows @param {Factor[]} factors @param {(Factor | undefined)[]} across */
function grouped(rows, factors, across) {
  const others = factors.filter((factor) => !across.includes(factor));
  return groupsOf(rows, factors).map(({ values, trials }) => ({
    trials, series: labelOf(others, others.map((factor) => values[factors.indexOf(factor)])),
    place: across.map((factor) => (factor ? values[factors.indexOf(factor)] : null)),
  }));
}

/** Statistics of a measure for each value across and each series. @param {Rows} rows @param {Factor[]} factors @param {Factor | undefined} axis @param {string} measure @returns {Summary[]} */
export function summaries(rows, factors, axis, measure) {
  return grouped(rows, factors, [axis]).map(({ trials, series, place: [x] }) => ({ x, series, ...summary(rows, trials, measure) }));
}

/** @param {Rows} rows @param {number[]} trials @param {string} measure */
function summary(rows, trials, measure) {
  const sample = sampleOf(rows, trials, measure);
  if (measure === SOLVED) {
    const { n, missing, share: middle, low, high } = share(sample);
    const percent = (/** @type {number | null} */ value) => (value === null ? null : 100 * value);
    return { n, missing, middle: percent(middle), low: percent(low), high: percent(high) };
  }
  const { n, missing, values } = quartiles(sample);
  const [least, low, middle, high, most] = values ?? [null, null, null, null, null];
  return { n, missing, middle, low, high, least, most };
}

/** A statistic for each pair of values; trials that differ in others are together. @param {Rows} rows @param {Factor} across @param {Factor} up @param {string} measure @returns {Summary[]} */
export function cells(rows, across, up, measure) {
  return grouped(rows, [across, up], [across, up]).map(({ trials, place: [x, y] }) => ({ x, y, series: "", ...summary(rows, trials, measure) }));
}

/** The share of all trials of a series that have a path after so much work. @param {Rows} rows @param {Factor[]} factors @param {string} work @returns {{ series: string, n: number, missing: number, steps: Step[] }[]} */
export function distributions(rows, factors, work) {
  return grouped(rows, factors, []).map(({ trials, series }) => {
    const { n, missing, values, shares } = ecdf(sampleOf(rows, trials, work));
    return { series, n, missing, steps: Array.from(values, (value, i) => ({ series, value, share: 100 * shares[i] })) };
  });
}

/** The trials with a path. @param {Rows} rows @param {Factor[]} factors @param {Factor | undefined} axis @param {string} measure @param {string} work @returns {Point[]} */
export function points(rows, factors, axis, measure, work) {
  return grouped(rows, factors, [axis]).flatMap(({ trials, series, place: [x] }) => {
    const [values, works] = [sampleOf(rows, trials, measure), sampleOf(rows, trials, work)];
    return trials.flatMap((trial, i) => (Number.isNaN(values[i]) ? [] : [{ trial, x, series, work: works[i], value: values[i] }]));
  });
}

/**
 * The quartiles of trials with about the same work, by series: those with one value across, or else bins of equally many trials.
 * @param {Point[]} all @param {boolean} isByValue @returns {Bin[]}  by rising work
 */
export function bins(all, isByValue) {
  return parts(all, ({ series }) => series).flatMap(([series, some]) => {
    const each = isByValue ? parts(some, ({ x }) => x).map(([, part]) => part) : equal(some);
    return each.map((part) => {
      const [works, values] = [part.map(({ work }) => work), part.map(({ value }) => value)].map((numbers) => quartiles(Float64Array.from(numbers)).values ?? []);
      return { series, n: part.length, work: Number(works[2]), low: Number(values[1]), middle: Number(values[2]), high: Number(values[3]) };
    }).sort((a, b) => a.work - b.work);
  });
}

/** Equally many points with about the same work. @param {Point[]} some */
function equal(some) {
  const sorted = some.toSorted((a, b) => a.work - b.work);
  const count = Math.min(BINS, Math.floor(sorted.length / LEAST));
  return Array.from({ length: count }, (_, i) => sorted.slice(Math.floor((i * sorted.length) / count), Math.floor(((i + 1) * sorted.length) / count)));
}

/** Items by a key, in their order. @template T, K @param {T[]} all @param {(one: T) => K} key @returns {[K, T[]][]} */
function parts(all, key) {
  /** @type {Map<K, T[]>} */
  const found = new Map();
  for (const one of all) {
    const part = found.get(key(one));
    if (part) part.push(one);
    else found.set(key(one), [one]);
  }
  return [...found];
}
