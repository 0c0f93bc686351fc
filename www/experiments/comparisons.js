/** Every setting against a baseline in words, in pairs with the same world, query and seed. */
import { paired } from "planarium/full";
import { groupsOf, labelOf } from "./factors.js";
import { SOLVED, isShare, measureInfo } from "./measures.js";
import { sampleOf } from "./tables.js";

/** @import { Factor, Group } from "./factors.js" */
/** @import { Rows } from "./rows.js" */

/**
 * The baseline is the one that is named; without that name the first setting with a path in at least half of its
 * trials, or else the one with the most.
 * @param {Rows} rows
 * @param {Factor[]} factors
 * @param {string} measure
 * @param {string} [wanted]  the name of the baseline
 * @returns {{ about: string, sentences: string[], names: string[], baseline: string }}  what the baseline is; a
 *   sentence for each other setting, and one for those without pairs; the names of all settings, and that of the
 *   baseline
 */
export function comparisons(rows, factors, measure, wanted) {
  const settings = factors.filter(({ column }) => column.startsWith("planner"));
  const groups = settings.length > 0 ? groupsOf(rows, settings) : [];
  if (groups.length < 2)
    return { about: "There are no two settings to compare.", sentences: [], names: [], baseline: "" };
  const shares = groups.map(
    ({ trials }) => sampleOf(rows, trials, SOLVED).reduce((sum, one) => sum + one, 0) / trials.length,
  );
  const half = shares.findIndex((share) => share >= 0.5);
  const name = (/** @type {Group} */ { values }) => labelOf(settings, values);
  const chosen = groups.find((group) => name(group) === wanted);
  const base = chosen ?? groups[half < 0 ? shares.indexOf(Math.max(...shares)) : half];
  const columns = rows.columns.filter(
    (column) => column.startsWith("world") || column === "query" || column === "seed",
  );
  const keyOf = (/** @type {number} */ trial) => columns.map((column) => rows.cell(trial, column)).join("\n");
  const partner = new Map(base.trials.map((trial) => [keyOf(trial), trial]));
  const all = groups
    .filter((group) => group !== base)
    .map((group) => {
      const pairs = group.trials.flatMap((trial) => {
        const other = partner.get(keyOf(trial));
        return other === undefined ? [] : [[trial, other]];
      });
      const [a, b] = [0, 1].map((side) =>
        sampleOf(
          rows,
          pairs.map((pair) => pair[side]),
          measure,
        ),
      );
      return { name: name(group), a, b, hasPairs: a.some((value, i) => !Number.isNaN(value - b[i])) };
    });
  const compared = all.filter(({ hasPairs }) => hasPairs);
  const without = all.filter(({ hasPairs }) => !hasPairs).map((one) => one.name);
  const sentences = compared.map(({ name: other, a, b }) =>
    sentenceOf(
      paired(a, b, other, name(base), measureInfo(measure, "").title, compared.length),
      other,
      name(base),
      measure,
    ),
  );
  if (without.length > 0)
    sentences.push(
      `No pair has a value of both the baseline and ${without.length > 1 ? "any of " : ""}${without.join("; ")}.`,
    );
  const reason = chosen
    ? "as chosen"
    : half < 0
      ? "which solves the most of its trials"
      : "the first setting that solves at least half of its trials";
  return {
    about: `The baseline is ${name(base)}, ${reason}. Trials of a pair have the same world and seed.`,
    sentences,
    names: groups.map(name),
    baseline: name(base),
  };
}

/**
 * Of shares, what finds a path more often.
 * @param {ReturnType<typeof paired>} result
 * @param {string} a
 * @param {string} b
 * @param {string} measure
 */
function sentenceOf({ n, smaller, larger, words }, a, b, measure) {
  if (!isShare(measure)) return words;
  const path = measure === SOLVED ? "a path" : "a valid path";
  const verdict = /(?:A|The) difference is (?:not shown|significant) at 5 %.*$/.exec(words)?.[0];
  if (larger === smaller)
    return `${a} and ${b} find ${path} equally often: each alone in ${larger} of ${n} pairs. ${verdict}`;
  const [more, less] = larger > smaller ? [a, b] : [b, a];
  return `${more} finds ${path} more often than ${less}: alone in ${Math.max(larger, smaller)} of ${n} pairs, and ${less} alone in ${Math.min(larger, smaller)}. ${verdict}`;
}
