/**
 * Trials with the same world, query and seed are pairs, whatever their setting. Lengths are compared fairly over those
 * that every setting solved: otherwise a setting that solves only easy worlds has short paths.
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

/** What two trials of a pair have in common. @param {Rows} rows @returns {(trial: number) => string} */
export function pairOf(rows) {
  const columns = rows.columns.filter((column) => /^(?:world|query$|seed$)/.test(column));
  return (trial) => columns.map((column) => rows.cell(trial, column)).join("\n");
}

/** @param {Rows} rows @param {Factor[]} factors @returns {Common} */
export function commonTrials(rows, factors) {
  const all = settingsOf(rows, factors);
  const half = all.filter(({ share }) => share >= 0.5);
  const kept = half.length > 0 ? half : all;
  const key = pairOf(rows);
  /** How many settings solved a pair. @type {Map<string, number>} */
  const times = new Map();
  const solved = kept.flatMap(({ trials }) => {
    const sample = sampleOf(rows, trials, SOLVED);
    return trials.filter((_, i) => sample[i] === 1);
  });
  const keys = solved.map(key);
  for (const one of keys) times.set(one, (times.get(one) ?? 0) + 1);
  const which = new Uint8Array(rows.count);
  solved.forEach((trial, i) => {
    which[trial] = Number(times.get(keys[i]) === kept.length);
  });
  return {
    which,
    pairs: [...times.values()].filter((count) => count === kept.length).length,
    settings: kept.length,
    left: all.filter((one) => !kept.includes(one)).map(({ name }) => name),
  };
}
