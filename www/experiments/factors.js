/**
 * What the trials of an experiment differ in beside their seeds: worlds, queries, planners, and the parameters that
 * vary. Trials that differ in seeds alone are a group.
 */

import { planners as plannerInfos } from "planarium/full";

/** @import { ExperimentAxis, ExperimentDocument } from "planarium/full" */
/** @import { Cell, Rows } from "./rows.js" */

/**
 * A column with its values in order; null where it does not apply.
 * @typedef {{ column: string, title: string, unit: string, values: Cell[], isNumeric: boolean, words?: Words }} Factor
 */
/** What values are called, where that is not their text. @typedef {Map<Cell, string>} Words */
/**
 * Trials that have ended, by number.
 * @typedef {{ values: Cell[], trials: number[] }} Group   `values`: one for each factor
 */
/**
 * The title and the unit of an option, by its column.
 * @typedef {(column: string) => { title: string, unit: string }} Naming
 */

/** The values of an axis. @param {ExperimentAxis} axis @returns {Cell[]} */
export function valuesOf(axis) {
  if (Array.isArray(axis)) return axis;
  const { from, to, step } = axis;
  // Rounded as in the core.
  return Array.from(
    { length: Math.floor((to - from) / step + 1e-9) + 1 },
    (_, i) => Math.round((from + i * step) * 1e9) / 1e9,
  );
}

/** The name of a world or a planner in rows. @param {any} entry */
export function nameOf({ name, scenario, generate, algorithm }) {
  return name ?? scenario?.name ?? generate ?? algorithm;
}

/**
 * The name of a planner in words: its own, or the title of its algorithm.
 * @param {{ name?: string, algorithm: string }} planner
 */
export function plannerTitle({ name, algorithm }) {
  return name ?? plannerInfos().find(({ id }) => id === algorithm)?.title ?? algorithm;
}

/** A value in words. @param {Cell} value @param {Words} [words] */
export function wordOf(value, words) {
  return words?.get(value) ?? String(value ?? "\u2013");
}

/**
 * @param {ExperimentDocument} document  that the core has accepted
 * @param {Naming} naming
 * @param {(string | undefined)[]} [titles]  of its worlds
 * @returns {Factor[]}  those with more than one value
 */
export function factorsOf({ worlds, planners }, naming, titles = []) {
  const queries = worlds.flatMap((world) => world.queries ?? []);
  /** @param {string} column @param {string} title @param {Cell[]} values */
  const plain = (column, title, values) => ({ column, title, unit: "", values, isNumeric: false });
  /** @param {string} prefix @param {{ vary?: Record<string, ExperimentAxis> }[]} entries @returns {Factor[]} */
  const varied = (prefix, entries) => {
    const names = [...new Set(entries.flatMap(({ vary }) => Object.keys(vary ?? {})))].sort();
    return names.map((name) => {
      const lists = entries.map(({ vary }) => (vary?.[name] ? valuesOf(vary[name]) : [null]));
      const values = [...new Set(lists.flat())];
      const isNumeric = values.every((value) => value === null || typeof value === "number");
      if (isNumeric) values.sort((a, b) => Number(a ?? -Infinity) - Number(b ?? -Infinity));
      return { column: `${prefix}.${name}`, ...naming(`${prefix}.${name}`), values, isNumeric };
    });
  };
  return [
    {
      ...plain("planner", "planner", planners.map(nameOf)),
      words: new Map(planners.map((entry) => [nameOf(entry), plannerTitle(entry)])),
    },
    ...varied("planner", planners),
    {
      ...plain("world", "world", worlds.map(nameOf)),
      words: new Map(worlds.map((entry, i) => [nameOf(entry), titles[i] ?? nameOf(entry)])),
    },
    ...varied(
      "world",
      worlds.map((world) => ("generate" in world ? world : {})),
    ),
    plain("query", "query", [...new Set(queries)]),
  ].filter(({ values }) => values.length > 1);
}

/**
 * The groups with a trial that has ended, in the order of the values.
 * @param {Rows} rows
 * @param {Factor[]} factors
 * @param {Uint8Array | null} [which]  the trials that count
 * @returns {Group[]}
 */
export function groupsOf(rows, factors, which = null) {
  /** @type {Map<number, Group>} */
  const groups = new Map();
  // The place of each value of the rows among those of the factor.
  const columns = factors.map((factor) => ({
    factor,
    codes: rows.codes.get(factor.column),
    known: rows.values.get(factor.column) ?? [],
    places: /** @type {number[]} */ ([]),
  }));
  for (const trial of rows.ended()) {
    if (which && !which[trial]) continue;
    let key = 0;
    for (const { factor, codes, known, places } of columns) {
      const code = codes?.[trial] ?? 0;
      places[code] ??= placeOf(factor, known[code]);
      key = key * (factor.values.length + 1) + places[code];
    }
    const group = groups.get(key);
    if (group) group.trials.push(trial);
    else groups.set(key, { values: columns.map(({ codes, known }) => known[codes?.[trial] ?? 0]), trials: [trial] });
  }
  return [...groups].sort(([a], [b]) => a - b).map(([, group]) => group);
}

/** @param {Factor} factor @param {Cell} value */
function placeOf({ values }, value) {
  const place = values.indexOf(value);
  return place < 0 ? values.length : place;
}

/** The parameter in a column. @param {string} column */
export function nameOfColumn(column) {
  return column.replace(/^\w+\./, "").replaceAll("_", " ");
}

/** The values of some factors in words. @param {Factor[]} factors @param {Cell[]} values */
export function labelOf(factors, values) {
  return factors
    .flatMap(({ column, unit, words }, i) => {
      const value = values[i];
      if (value === null) return [];
      return column.includes(".")
        ? [`${nameOfColumn(column)} = ${value}${unit && ` ${unit}`}`]
        : [wordOf(value, words)];
    })
    .join(", ");
}
