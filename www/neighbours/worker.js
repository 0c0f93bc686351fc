/**
 * What takes longer than a frame: lists of configurations, the indexes on them, and how long questions take. Only the newest
 * list is kept, and an index until there is another list.
 */
import { Scenario } from "planarium";
import { handed, serve } from "../room/serve.js";
import { rowsOf } from "./files.js";
import { Course } from "./course.js";

/** @import { Neighbours, NeighboursOptions } from "planarium" */
/** @import { Draw, List, Measured, Question, Reply, ScenarioDocument, Settings } from "./types.js" */

/** @type {Scenario | null} */
let scenario = null;
let version = 0;
/** @type {Float64Array} */
let rows = new Float64Array();
/** Indexes on these rows, by what they were asked to be. @type {Map<string, Neighbours>} */
const indexes = new Map();
/** The measurement under way. @type {Course | null} */
let course = null;

/** The robot; there is one once a list was asked for. @returns {Scenario} */
function robot() {
  if (!scenario) throw new Error("There is no robot yet.");
  return scenario;
}

function forget() {
  for (const index of indexes.values()) index.free();
  indexes.clear();
}

/** @param {ScenarioDocument} document */
function open(document) {
  const next = Scenario.parse(document);
  scenario?.free();
  scenario = next;
}

/** A new list. @param {Float64Array} given @returns {List} */
function take(given) {
  forget();
  rows = given;
  version += 1;
  const tips = robot().endEffectors(rows);
  const copy = rows.slice();
  return handed({ version, rows: copy, tips }, [copy.buffer, tips.buffer]);
}

/** The index that is wanted, on all rows. @param {Settings} options */
function indexOf(options) {
  const key = JSON.stringify(options);
  const known = indexes.get(key);
  if (known) return known;
  const made = robot().neighbours(/** @type {NeighboursOptions} */ (options));
  made.add(rows);
  indexes.set(key, made);
  return made;
}

const commands = {
  /** Configurations drawn by seed. @param {ScenarioDocument} document @param {Draw} draw @returns {List} */
  draw(document, { n, seed, free }) {
    open(document);
    return take(robot().sampleConfigurations(n, { seed, free }));
  },

  /** Those of a file: JSON or an array of NumPy's. @param {ScenarioDocument} document @param {string} name @param {Uint8Array} bytes @returns {List} */
  read(document, name, bytes) {
    const given = Scenario.parse(document);
    try {
      const read = rowsOf(name, bytes, given.dimension);
      // The core refuses what is no configuration of the robot; until then the list of before is kept.
      const judge = given.neighbours({ index: "linear" });
      try {
        judge.add(read);
      } finally {
        judge.free();
      }
      open(document);
      return take(read);
    } finally {
      given.free();
    }
  },

  /** @param {Question} question @returns {Reply | null}  null: there is another list by now */
  ask({ version: asked, q, k, index, given }) {
    if (asked !== version) return null;
    const { metric } = given;
    const found = indexOf({ index, ...given }).nearest(q, k);
    /** @type {Settings} */
    const meant = metric === undefined || metric === "naive" ? {} : { metric };
    return { found, exact: indexOf({ index: "kd-tree", ...meant }).nearest(q, k) };
  },

  /** Begins to measure. @param {ScenarioDocument} document @param {number} k @param {Settings} given  metric, and what a forest takes */
  begin(document, k, given) {
    course?.free();
    course = new Course(document, k, given);
  },

  /** Measures with so many configurations; what there is no time for is left out. @param {number} n @param {number} milliseconds @returns {Measured[]} */
  measure(n, milliseconds) {
    return course?.measure(n, milliseconds) ?? [];
  },

  /** Gives back what was measured on. */
  end() {
    course?.free();
    course = null;
  },
};

/** @typedef {typeof commands} Commands */

serve(commands, () => {
  scenario = null;
  course = null;
  indexes.clear();
  version += 1;
});
