/** The result in at most four sentences: the extremes, two settings in pairs, and all against the first of the two. */
import { paired, quartiles } from "planarium/full";
import { TASK, pairsOf, settingsOf } from "./common.js";
import { groupsOf, labelOf } from "./factors.js";
import { SOLVED, isShare, measureInfo, nounOf } from "./measures.js";
import { sampleOf } from "./tables.js";

/** @import { Factor } from "./factors.js" */
/** @import { Rows } from "./rows.js" */

/** @typedef {ReturnType<typeof settingsOf>[number]} Setting */

/** The level of a test, before it is divided by their number. */
const LEVEL = 0.05;
/** Settings that a sentence names, at most. */
const NAMES = 3;

/**
 * Without a name the first of the two is the first setting with a path in at least half of its trials, or else the one
 * with the most; the second is the best of the others, or else the worst.
 * @param {Rows} rows
 * @param {Factor[]} factors
 * @param {string} measure
 * @param {{ baseline?: string, other?: string, which?: Uint8Array | null }} [view]  names, and the trials that count
 * @returns {{ sentences: string[], names: string[], baseline: string, other: string }}  the names of all settings, and
 *   of the two
 */
export function comparisons(rows, factors, measure, { baseline, other, which = null } = {}) {
  const all = settingsOf(rows, factors).map((one) =>
    which ? { ...one, trials: one.trials.filter((trial) => which[trial]) } : one,
  );
  if (all.length < 2) {
    const groups = groupsOf(rows, factors, which).map(({ values, trials }) => ({
      name: labelOf(factors, values),
      trials,
    }));
    const sentences =
      groups.length > 1
        ? [
            extremes(rankedBy(rows, groups, measure), measure),
            "Trials in different worlds cannot be paired, so nothing is tested.",
          ]
        : ["A comparison needs trials of two settings."];
    return { sentences, names: [], baseline: "", other: "" };
  }
  const half = all.findIndex(({ share }) => share >= 0.5);
  const most = all.reduce((best, one) => (one.share > best.share ? one : best));
  const base = all.find(({ name }) => name === baseline) ?? all[half] ?? most;
  const ranked = rankedBy(rows, all, measure);
  const chosen = all.find(({ name }) => name === other && name !== base.name);
  const [best, worst] = [ranked[0] ?? most, ranked[ranked.length - 1] ?? most];
  const second = chosen ?? [best, worst, ...all].find((one) => one.name !== base.name) ?? base;
  const others = all.filter((one) => one !== base);
  const tests = others.length;
  const results = new Map(others.map((one) => [one.name, compared(rows, one, base, measure)]));
  const result = /** @type {ReturnType<typeof compared>} */ (results.get(second.name));
  const sentences = [extremes(ranked, measure), pairSentence(result, second.name, base.name, measure, tests)];
  if (tests > 1) sentences.push(othersSentence(results, base.name, measure));
  return {
    sentences: sentences.filter(Boolean),
    names: all.map(({ name }) => name),
    baseline: base.name,
    other: second.name,
  };
}

/**
 * Settings with their share or their median, best first: more paths, or less of anything else.
 * @param {Rows} rows
 * @param {{ name: string, trials: number[] }[]} all
 * @param {string} measure
 */
function rankedBy(rows, all, measure) {
  return all
    .map((one) => {
      const sample = sampleOf(rows, one.trials, measure).filter((value) => !Number.isNaN(value));
      const mean = sample.reduce((sum, value) => sum + value, 0) / sample.length;
      const value = isShare(measure) ? 100 * mean : Number(quartiles(sample).values?.[2]);
      return { name: one.name, n: sample.length, value };
    })
    .filter(({ n }) => n > 0)
    .sort((a, b) => (isShare(measure) ? b.value - a.value : a.value - b.value));
}

/** @param {ReturnType<typeof rankedBy>} ranked @param {string} measure */
function extremes(ranked, measure) {
  const [best, worst] = [ranked[0], ranked[ranked.length - 1]];
  if (!best) return "No setting found a path.";
  const text = (/** @type {typeof best} */ { value, n }) =>
    isShare(measure) ? `${Number(value.toFixed(1))} % of ${n}` : `${Number(value.toPrecision(3))} (n = ${n})`;
  const { title } = measureInfo(measure, "");
  if (isShare(measure)) {
    return best.value === worst.value
      ? `All have the same share of ${title}, ${text(best)}.`
      : `The share of ${title} is largest for ${best.name}, ${text(best)}, and smallest for ${worst.name}, ${text(worst)}.`;
  }
  return best.value === worst.value
    ? `All have the same median of ${title}, ${text(best)}.`
    : `The median of ${title} is smallest for ${best.name}, ${text(best)}, and largest for ${worst.name}, ${text(worst)}${best.n === worst.n ? "" : "; these are not the same trials"}.`;
}

/**
 * Two settings in pairs with the same world, query and seed. The sign test of a yes or no is McNemar's exact test.
 * @param {Rows} rows
 * @param {Setting} a
 * @param {Setting} b
 * @param {string} measure
 */
function compared(rows, a, b, measure) {
  const own = new Set(a.trials);
  const pairs = [...pairsOf(rows, [...a.trials, ...b.trials]).values()].filter(({ length }) => length === 2);
  const sample = (/** @type {boolean} */ isFirst) =>
    sampleOf(
      rows,
      /** @type {number[]} */ (pairs.map((pair) => pair.find((trial) => own.has(trial) === isFirst))),
      measure,
    );
  const { n, smaller, larger, sign_p, wilcoxon_p } = paired(sample(true), sample(false), a.name, b.name, measure);
  const tasks = pairsOf(
    rows,
    pairs.map(([trial]) => trial),
    TASK,
  ).size;
  return { n, smaller, larger, tasks, p: isShare(measure) ? sign_p : wilcoxon_p };
}

/**
 * @param {ReturnType<typeof compared>} result
 * @param {string} a
 * @param {string} b
 * @param {string} measure
 * @param {number} tests
 */
function pairSentence({ n, smaller, larger, tasks, p }, a, b, measure, tests) {
  if (n === 0) return `No pair has a value of both ${a} and ${b}.`;
  const over = tests > 1 ? `, corrected for ${tests} tests` : "";
  const verdict = p <= LEVEL / tests ? `significant at 5 %${over}` : `no difference is shown at 5 %${over}`;
  const rounded = Math.round(p * 1e4) / 1e4;
  const worlds = tasks > 1 && tasks < n ? `; it takes the pairs, of ${tasks} worlds, as independent` : "";
  const value = `${rounded > 0 ? `p = ${rounded}` : "p < 0.0001"}${worlds}`;
  if (!isShare(measure))
    return `The ${nounOf(measure)} of ${a} is smaller than that of ${b} in ${smaller} of ${n} pairs that both solved, larger in ${larger}${smaller + larger < n ? `, equal in ${n - smaller - larger}` : ""}: ${verdict} (Wilcoxon\u2019s signed-rank test, ${value}).`;
  const path = measure === SOLVED ? "a path" : "a valid path";
  const test = `${verdict} (McNemar\u2019s exact test, ${value})`;
  if (larger === smaller)
    return `${a} and ${b} find ${path} equally often, each alone in ${larger} of ${n} pairs: ${test}.`;
  const [more, less] = larger > smaller ? [a, b] : [b, a];
  return `${more} finds ${path} more often than ${less}, alone in ${Math.max(larger, smaller)} of ${n} pairs, and ${less} alone in ${Math.min(larger, smaller)}: ${test}.`;
}

/**
 * All settings against one, in a sentence.
 * @param {Map<string, ReturnType<typeof compared>>} results
 * @param {string} base
 * @param {string} measure
 */
function othersSentence(results, base, measure) {
  const shown = [...results].filter(([, { n, p }]) => n > 0 && p <= LEVEL / results.size);
  const [more, less] = isShare(measure) ? ["more often", "less often"] : ["larger", "smaller"];
  const parts = [
    { word: more, some: shown.filter(([, one]) => one.larger > one.smaller) },
    { word: less, some: shown.filter(([, one]) => one.larger < one.smaller) },
  ]
    .filter(({ some }) => some.length > 0)
    .map(({ word, some }) => `${word}: ${some.length > NAMES ? some.length : some.map(([name]) => name).join(", ")}`);
  const others = `${results.size} other settings`;
  return parts.length === 0
    ? `None of the ${others} differs significantly from ${base}.`
    : `Of the ${others}, these differ significantly from ${base}: ${parts.join("; ")}.`;
}
