/**
 * The commands of this page, which its worker runs: the newest list of configurations, indexes on it, and their times.
 */
import { Scenario } from "planarium";
import { Measurement } from "./measurement.js";
import { readList } from "./read-list.js";

/** @import { IndexId, Neighbours, NeighboursOptions } from "planarium" */
/** @import { ScenarioDocument, Settings } from "../domain/types.js" */

/** @type {Scenario | null} */
let scenario = null;
/** @type {Float64Array} */
let rows = new Float64Array();
/** Indexes on the rows, by their options. @type {Map<string, Neighbours>} */
const indexes = new Map();
/** @type {Measurement | null} */
let measurement = null;

/**
 * Replaces the list. Its tips are end effectors, or the middles of bodies, x and y in turn.
 * @param {Scenario} opened @param {Float64Array} list
 */
function store(opened, list) {
  scenario?.free();
  scenario = opened;
  for (const index of indexes.values()) index.free();
  indexes.clear();
  rows = list;
  return { rows: rows.slice(), tips: opened.endEffectors(rows) };
}

/** @param {Scenario} robot @param {Settings} options */
function indexOf(robot, options) {
  const key = JSON.stringify(options);
  const known = indexes.get(key);
  if (known) return known;
  const index = robot.neighbours(/** @type {NeighboursOptions} */ (options));
  index.add(rows);
  indexes.set(key, index);
  return index;
}

export const commands = {
  /** @param {ScenarioDocument} document @param {{ n: number, seed: number, free: boolean }} sampling */
  sample(document, { n, seed, free }) {
    const opened = Scenario.parse(document);
    return store(opened, opened.sampleConfigurations(n, { seed, free }));
  },

  /** Opens the same list for the same robot with another metric. @param {ScenarioDocument} document */
  reopen(document) {
    return store(Scenario.parse(document), rows);
  },

  /**
   * Reads JSON or a NumPy array; if it is refused, the list before stays.
   * @param {ScenarioDocument} document
   * @param {string} name
   * @param {Uint8Array} bytes
   */
  read(document, name, bytes) {
    const opened = Scenario.parse(document);
    // An index refuses what is not a configuration.
    const index = opened.neighbours({ index: "linear" });
    try {
      const list = readList(name, bytes, opened.dimension);
      index.add(list);
      return store(opened, list);
    } catch (error) {
      opened.free();
      throw error;
    } finally {
      index.free();
    }
  },

  /**
   * The neighbours, and those by exact search with angles that wrap; null without a list.
   * @param {{ q: Float64Array, k: number, index: IndexId, given: Settings }} query  `given`: options of the index
   */
  search({ q, k, index, given }) {
    if (!scenario) return null;
    const { metric } = given;
    const exact = indexOf(scenario, {
      index: "kd-tree",
      ...(metric === undefined || metric === "naive" ? {} : { metric }),
    });
    return { found: indexOf(scenario, { index, ...given }).nearest(q, k), exact: exact.nearest(q, k) };
  },

  /**
   * Begins to measure.
   * @param {ScenarioDocument} document
   * @param {number} k
   * @param {Settings} given  options of the indexes
   */
  beginMeasurement(document, k, given) {
    measurement?.free();
    measurement = new Measurement(document, k, given);
  },

  /**
   * Measures on n configurations; what there is no time for is left out.
   * @param {number} n
   * @param {number} milliseconds
   */
  measure(n, milliseconds) {
    return measurement?.measure(n, milliseconds) ?? [];
  },

  endMeasurement() {
    measurement?.free();
    measurement = null;
  },
};

/** @typedef {typeof commands} Commands */
/** @typedef {ReturnType<typeof store>} List */

export function reset() {
  scenario = measurement = null;
  indexes.clear();
}
