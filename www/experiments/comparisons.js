/** Every setting against the first one in words, in pairs with the same world, query and seed. */
import { paired } from "planarium";
import { groupsOf, labelOf } from "./factors.js";
import { SOLVED, measureInfo } from "./measures.js";
import { sampleOf } from "./tables.js";

/** @import { Factor } from "./factors.js" */
/** @import { Rows } from "./rows.js" */

/** @param {Rows} rows @param {Factor[]} factors @param {string} measure @returns {string[]}  a sentence for each setting but the first */
export function comparisons(rows, factors, measure) {
  const settings = factors.filter(({ column }) => column.startsWith("planner"));
  if (settings.length === 0) return [];
  const [first, ...others] = groupsOf(rows, settings);
  if (!first) return [];
  const columns = rows.columns.filter((column) => column.startsWith("world") || column === "query" || column === "seed");
  const keyOf = (/** @type {number} */ trial) => columns.map((column) => rows.cell(trial, column)).join("\n");
  const partner = new Map(first.trials.map((trial) => [keyOf(trial), trial]));
  const name = (/** @type {typeof first} */ { values }) => labelOf(settings, values);
  return others.map((group) => {
    const pairs = group.trials.flatMap((trial) => {
      const other = partner.get(keyOf(trial));
      return other === undefined ? [] : [[trial, other]];
    });
    const [a, b] = [0, 1].map((side) => sampleOf(rows, pairs.map((pair) => pair[side]), measure));
    return paired(a, b, name(group), name(first), measure === SOLVED ? "success" : measureInfo(measure, "").title, others.length).words;
  });
}
