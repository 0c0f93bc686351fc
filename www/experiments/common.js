/**
 * Trials with the same world, query and seed are a pair, whatever their setting. Lengths are compared fairly over the
 * pairs that every setting solved: otherwise a setting that solves only easy worlds has short paths.
 */
import { groupsOf, labelOf } from "./factors.js";
import { SOLVED } from "./measures.js";
import { sampleOf } from "./tables.js";

/** @import { Factor } from "./factors.js" */
/** @import { Rows } from "./rows.js" */

/**
 * @typedef {object} Common
 * @property {Uint8Array} which   the trials, by number
 * @property {number} pairs   worlds with their seeds that all these settings solved
 * @property {number} settings
 * @property {string[]} left   the names of settings that solve less than half of their trials: they are left out
 */

/** The settings of planners, each with its trials. @param {Rows} rows @param {Factor[]} factors */
export function settingsOf(rows, factors) {
  const settings = factors.filter(({ column }) => column.startsWith("planner"));
  const groups = settings.length > 0 ? groupsOf(rows, settings) : [];
  return groups.map(({ values, trials }) => ({
    name: labelOf(settings, values),
    trials,
    share: sampleOf(rows, trials, SOLVED).reduce((sum, one) => sum + one, 0) / trials.length,
  }));
}

/** What makes trials a pair, and what makes them tasks of one world and query: columns. */
const PAIR = /^(?:world|query$|seed$)/;
export const TASK = /^(?:world|query$)/;

/** The numbers of what trials have in common, until further trials end. @type {WeakMap<Rows, Map<RegExp, Ids>>} */
const known = new WeakMap();
/** @typedef {{ done: number, ids: Uint32Array }} Ids   `ids`: by trial */

/** @param {Rows} rows @param {RegExp} which @returns {Uint32Array} */
function idsOf(rows, which) {
  const own = known.get(rows) ?? new Map();
  known.set(rows, own);
  const before = own.get(which);
  if (before?.done === rows.done) return before.ids;
  const columns = rows.columns.filter((column) => which.test(column));
  const ids = new Uint32Array(rows.count);
  /** @type {Map<string, number>} */
  const places = new Map();
  for (const trial of rows.ended()) {
    const key = columns.map((column) => rows.cell(trial, column)).join("\n");
    const place = places.get(key) ?? places.size;
    places.set(key, place);
    ids[trial] = place;
  }
  own.set(which, { done: rows.done, ids });
  return ids;
}

/**
 * Trials by what they have in common.
 * @param {Rows} rows
 * @param {number[]} trials
 * @param {RegExp} [which]  the columns
 * @returns {Map<number, number[]>}
 */
export function pairsOf(rows, trials, which = PAIR) {
  const ids = idsOf(rows, which);
  /** @type {Map<number, number[]>} */
  const pairs = new Map();
  for (const trial of trials) {
    const pair = pairs.get(ids[trial]);
    if (pair) pair.push(trial);
    else pairs.set(ids[trial], [trial]);
  }
  return pairs;
}

/** @param {Rows} rows @param {Factor[]} factors @returns {Common} */
export function commonTrials(rows, factors) {
  const all = settingsOf(rows, factors);
  const half = all.filter(({ share }) => share >= 0.5);
  const kept = half.length > 0 ? half : all;
  const solved = kept.flatMap(({ trials }) => {
    const sample = sampleOf(rows, trials, SOLVED);
    return trials.filter((_, i) => sample[i] === 1);
  });
  const pairs = [...pairsOf(rows, solved).values()].filter(({ length }) => length === kept.length);
  const which = new Uint8Array(rows.count);
  for (const trial of pairs.flat()) which[trial] = 1;
  return {
    which,
    pairs: pairs.length,
    settings: kept.length,
    left: all.filter((one) => !kept.includes(one)).map(({ name }) => name),
  };
}
