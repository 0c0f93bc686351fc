/**
 * A link stores an experiment: its document, and how its rows are shown. The fragment is that of the other rooms, with
 * `{ document, view }` as its state. A world of the document is as in `planarium-experiment-1`, or a built-in scene by
 * name: `{ "scene": "stones", "name": ..., "queries": ... }`. A `scenario` may also be the name of a file of this site,
 * relative to `experiments/documents/`.
 */
import { decodeState, encodeState } from "../app/link.js";
import { CHARTS } from "./charts.js";
import {
  flag,
  formed,
  json,
  list,
  name,
  number,
  oneOf,
  record,
  rule,
  text,
  whole,
  withDefaults,
} from "../formats/rules.js";

/** @import { Allowed, Rule } from "../formats/rules.js" */
/** @import { LinkedDocument } from "../domain/types.js" */

/** @typedef {Allowed<typeof viewRule>} View */

/** What is shown of the rows; what is absent is chosen by the page. */
const viewRule = record({
  chart: oneOf(CHARTS.map(({ id }) => id)),
  // A measure of the core, or "solved": the share of trials with a path.
  measure: name,
  // The measure across, of the charts over work.
  work: name,
  // The columns across and, on the heat map, up, such as "planner.k" or "world".
  axis: text,
  second: text,
  isLog: flag,
  // Lengths and work over the worlds and seeds that every setting solved.
  isCommon: flag,
  // The names of the settings that are compared: all others with the first, too.
  baseline: text,
  other: text,
  // Before what was run, of each measure.
  captions: list(record({ measure: name, text: formed(/^[^]*$/, 600) }), 0, 100),
  /** Numbers to compare with, as points over the chart: `x` is a place on the axis across. */
  reported: list(
    record({
      x: rule((value) => (typeof value === "string" ? value.length <= 256 : Number.isFinite(value))),
      value: number,
      label: text,
    }),
    0,
    200,
  ),
  // The first row of the table of trials.
  row: whole(1e8),
});

export const stateRule = Object.assign(
  withDefaults(
    {
      document: /** @type {Rule<LinkedDocument>} */ (record({}, json(16))),
      view: viewRule,
      // Whether the trials run without a click, where they are few; absent: unless motion is reduced.
      run: flag,
    },
    { view: /** @type {View} */ ({}) },
  ),
  {
    // Those of the planner's page: a document may contain a scenario of the reader's own.
    limits: { characters: 65_535, bytes: 1 << 20 },
  },
);

/** @typedef {{ document: LinkedDocument, view: View, run?: boolean }} ExperimentState */

/**
 * @param {{ document: LinkedDocument, view?: View, run?: boolean }} experiment
 * @returns {Promise<string>}  the fragment of `experiments.html`, without `#`
 * @throws {Error} in words
 */
export function encodeExperiment(experiment) {
  return encodeState(experiment, stateRule);
}

/**
 * @param {string} fragment
 * @returns {Promise<{ state: ExperimentState, fault: "" } | { state: null, fault: string }>}  never rejects
 */
export function decodeExperiment(fragment) {
  return /** @type {Promise<any>} */ (decodeState(fragment, stateRule));
}
