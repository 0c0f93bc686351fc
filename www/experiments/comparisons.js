/** The result in a few sentences: the extremes, two settings in pairs, all against the first of the two, and each world. */
import { paired, quartiles } from "planarium/full";
import { counted, grouped, listed } from "../app/dom.js";
import { TASK, pairsOf, settingsOf } from "./common.js";
import { groupsOf, labelOf, wordOf } from "./factors.js";
import { SOLVED, commonUnit, inUnit, isShare, measureInfo, nounOf } from "./measures.js";
import { clean, sampleOf } from "./tables.js";

/** @import { Factor } from "./factors.js" */
/** @import { Rows } from "./rows.js" */

/** @typedef {ReturnType<typeof settingsOf>[number]} Setting */

/** The level of a test, before it is divided by their number. */
const LEVEL = 0.05;
/** Settings that a sentence names, at most, and worlds. */
const NAMES = 3;
const WORLDS = 5;
/** Values that differ by at most this share are equal: only rounding makes them differ. */
const EQUAL = 1e-9;

/**
 * Without a name the first of the two is the first setting with a path in at least half of its trials, or else the one
 * with the most; the second is the best of the others, or else the worst.
 * @param {Rows} rows
 * @param {Factor[]} factors
 * @param {string} measure
 * @param {{ baseline?: string, other?: string, which?: Uint8Array | null, units?: Map<string, string> }} [view]   names,
 *   the trials that count, and the unit of lengths in each world
 * @returns {{ sentences: string[], names: string[], baseline: string, other: string }}  the names of all settings, and
 *   of the two
 */
export function comparisons(rows, factors, measure, { baseline, other, which = null, units = new Map() } = {}) {
  const common = commonUnit(units);
  const { title, unit } = measureInfo(measure, common ?? "");
  const what = { measure, title, unit, isCut: which !== null };
  const isPooled = common !== null || !inUnit(measure);
  const all = settingsOf(rows, factors).map((one) =>
    which ? { ...one, trials: one.trials.filter((trial) => which[trial]) } : one,
  );
  if (all.length < 2) {
    const groups = groupsOf(rows, factors, which).map(({ values, trials }) => ({
      name: labelOf(factors, values),
      trials,
    }));
    const ranked = rankedBy(rows, groups, measure);
    const sentences =
      groups.length > 1
        ? [
            ranked.length === 0 ? noneOf(rows, title, which) : isPooled ? extremes(ranked, groups, what) : UNITS,
            "Trials in different worlds cannot be paired, so nothing is tested.",
          ]
        : [`A comparison needs trials of two settings${rows.done < rows.count ? " that have ended" : ""}.`];
    return { sentences, names: [], baseline: "", other: "" };
  }
  const half = all.findIndex(({ share }) => share >= 0.5);
  const most = all.reduce((best, one) => (one.share > best.share ? one : best));
  const base = all.find(({ name }) => name === baseline) ?? all[half] ?? most;
  const ranked = rankedBy(rows, all, measure);
  const worlds = ranked.length > 0 ? byWorld(rows, factors, all, what, units) : "";
  const chosen = all.find(({ name }) => name === other && name !== base.name);
  const [best, worst] = [ranked[0] ?? most, ranked[ranked.length - 1] ?? most];
  const second = chosen ?? [best, worst, ...all].find((one) => one.name !== base.name) ?? base;
  const others = all.filter((one) => one !== base);
  const tests = others.length;
  const results = new Map(others.map((one) => [one.name, compared(rows, one, base, measure)]));
  const result = /** @type {ReturnType<typeof compared>} */ (results.get(second.name));
  const sentences = [];
  if (ranked.length === 0) sentences.push(noneOf(rows, title, which));
  else if (!isPooled) sentences.push(UNITS);
  else {
    sentences.push(extremes(ranked, all, what), pairSentence(result, second.name, base.name, measure, tests));
    if (tests > 1) sentences.push(othersSentence(results, base.name, measure));
  }
  sentences.push(worlds);
  return {
    sentences: sentences.filter(Boolean),
    // What is not put together cannot be chosen.
    names: isPooled ? all.map(({ name }) => name) : [],
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
      const value = isShare(measure) ? clean(100 * mean) : Number(quartiles(sample).values?.[2]);
      return { name: one.name, n: sample.length, value };
    })
    .filter(({ n }) => n > 0)
    .sort((a, b) => (isEqual(a.value, b.value) ? 0 : isShare(measure) ? b.value - a.value : a.value - b.value));
}

/** @typedef {ReturnType<typeof rankedBy>} Ranked */
/**
 * @typedef {{ measure: string, title: string, unit: string, isCut: boolean }} What   is measured; `isCut`: only where all
 *   settings solved, those apart that solve too little
 */

/** Why lengths of several kinds of robots are not put together. */
const UNITS = "The paths of different robots have lengths in different units, so they are not put together.";

/** Why there is no value at all. @param {Rows} rows @param {string} title @param {Uint8Array | null} which */
function noneOf(rows, title, which) {
  const solved = sampleOf(rows, Array.from(rows.ended()), SOLVED).some((one) => one === 1);
  if (!solved) return "No setting found a path.";
  return which ? "No world and seed was solved by all settings." : `No trial has a value of ${title}.`;
}

/** @param {number} a @param {number} b */
const isEqual = (a, b) => Math.abs(a - b) <= EQUAL * Math.max(Math.abs(a), Math.abs(b));

/**
 * Values in words, with as many digits as it takes to tell them apart.
 * @param {number[]} values @param {What} what
 */
function textsOf(values, { measure, unit }) {
  const text = (/** @type {number} */ value, /** @type {number} */ digits) => {
    if (isShare(measure)) return String(Number(clean(value).toFixed(digits - 2)));
    return Math.abs(value) >= 10 ** digits ? grouped(Math.round(value)) : String(Number(value.toPrecision(digits)));
  };
  const isApart = (/** @type {number} */ digits) =>
    values.every((one, i) =>
      values.every((two, j) => j <= i || isEqual(one, two) || text(one, digits) !== text(two, digits)),
    );
  const digits = [3, 4, 5, 6, 7, 8, 9].find(isApart) ?? 10;
  return values.map((value) => `${text(value, digits)}${unit && ` ${unit}`}`);
}

/**
 * @param {Ranked} ranked  those of all that have a value: at least one
 * @param {{ name: string }[]} all
 * @param {What} what
 */
function extremes(ranked, all, what) {
  const [best, worst] = [ranked[0], ranked[ranked.length - 1]];
  const texts = textsOf([best.value, worst.value], what);
  /** All that share an end: their names, value and numbers of trials. @param {Ranked[number]} end @param {string} text */
  const sign = (end, text) => {
    const some = ranked.filter(({ value }) => isEqual(value, end.value));
    const sizes = some.map(({ n }) => n);
    const [least, most] = [Math.min(...sizes), Math.max(...sizes)].map(grouped);
    const n = least === most ? most : `${least} to ${most}`;
    const names = some.map(({ name }) => name);
    const more = names.length > NAMES ? [...names.slice(0, NAMES - 1), `${names.length - NAMES + 1} others`] : names;
    return { names: listed(more), value: isShare(what.measure) ? `${text} of ${n}` : `${text} (n = ${n})` };
  };
  const [first, last] = [sign(best, texts[0]), sign(worst, texts[1])];
  const statistic = `${isShare(what.measure) ? "share" : "median"} of ${what.title}`;
  if (isEqual(best.value, worst.value))
    return ranked.length < all.length
      ? `The ${statistic} is ${first.value}, for ${first.names}; the others ${what.isCut ? "are left out" : "have none"}.`
      : `All have the same ${statistic}, ${first.value}.`;
  const [most, least] = isShare(what.measure) ? ["largest", "smallest"] : ["smallest", "largest"];
  const other = isShare(what.measure) || best.n === worst.n ? "" : "; these are not the same trials";
  const missing = all.length - ranked.length;
  const without = what.isCut
    ? counted(missing, "other is left out", "others are left out")
    : `${counted(missing, "other has", "others have")} none`;
  const none = missing > 0 ? `; ${without}` : "";
  return `The ${statistic} is ${most} for ${first.names}, ${first.value}, and ${least} for ${last.names}, ${last.value}${other}${none}.`;
}

/**
 * The order of the settings in each of a few worlds, or kinds of worlds, which may be another one in each.
 * @param {Rows} rows @param {Factor[]} factors @param {Setting[]} all @param {What} what
 * @param {Map<string, string>} units  of lengths, by the names of worlds
 */
function byWorld(rows, factors, all, what, units) {
  const world = factors.find(({ column }) => column === "world");
  if (!world || world.values.length > WORLDS) return "";
  const parts = world.values.map((value) => {
    const inWorld = all.map(({ name, trials }) => ({
      name,
      trials: trials.filter((trial) => rows.cell(trial, "world") === value),
    }));
    const ranked = rankedBy(rows, inWorld, what.measure);
    const isShort = ranked.length > NAMES;
    const shown = isShort ? [ranked[0], ranked[ranked.length - 1]] : ranked;
    const unit = inUnit(what.measure) ? (units.get(String(value)) ?? "") : what.unit;
    const texts = textsOf(
      shown.map((one) => one.value),
      { ...what, unit },
    );
    const hasCounts = !isShare(what.measure) && ranked.some(({ n }) => n !== ranked[0].n);
    const words = shown.map(({ name, n }, i) => `${name} ${texts[i]}${hasCounts ? ` (n = ${grouped(n)})` : ""}`);
    const without = inWorld.filter(({ name, trials }) => trials.length > 0 && !ranked.some((one) => one.name === name));
    const none = without.length > NAMES ? [`${without.length} none`] : without.map(({ name }) => `${name} none`);
    const known = [words.join(isShort ? " to " : ", "), ...none].filter(Boolean);
    return known.length > 0 ? `${wordOf(value, world.words)}: ${known.join(", ")}` : "";
  });
  const [statistic, order] = isShare(what.measure) ? ["Share", "largest"] : ["Median", "smallest"];
  const trials = Array.from(rows.ended());
  const each = pairsOf(rows, trials, TASK).size > world.values.length ? "each kind of world" : "each world";
  return `${statistic} of ${what.title} in ${each}, ${order} first: ${parts.filter(Boolean).join("; ")}.`;
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
  const [ofA, ofB] = [true, false].map((isFirst) =>
    sampleOf(
      rows,
      /** @type {number[]} */ (pairs.map((pair) => pair.find((trial) => own.has(trial) === isFirst))),
      measure,
    ),
  );
  const { n, smaller, larger, sign_p, wilcoxon_p } = paired(ofA, ofB, a.name, b.name, measure);
  const leaning = isShare(measure) ? larger - smaller : rankSum(ofA, ofB);
  const whole = pairs.filter((_, i) => !Number.isNaN(ofA[i]) && !Number.isNaN(ofB[i]));
  const tasks = pairsOf(
    rows,
    whole.map(([trial]) => trial),
    TASK,
  ).size;
  return { n, smaller, larger, leaning, tasks, p: isShare(measure) ? sign_p : wilcoxon_p };
}

/**
 * The ranks of the pairs in which the first value is larger, by the size of the difference, less those in which it is
 * smaller: the direction of what Wilcoxon's test shows, which is not always that of most pairs.
 * @param {Float64Array} a
 * @param {Float64Array} b
 */
function rankSum(a, b) {
  const differences = Array.from(a, (one, i) => (isEqual(one, b[i]) ? 0 : one - b[i])).filter(Boolean);
  const sizes = differences.map(Math.abs).sort((one, other) => one - other);
  // Equal sizes have their mean rank.
  const ranks = new Map();
  for (const [i, size] of sizes.entries()) {
    const [sum = 0, count = 0] = ranks.get(size) ?? [];
    ranks.set(size, [sum + i + 1, count + 1]);
  }
  return differences.reduce((total, one) => {
    const [sum, count] = ranks.get(Math.abs(one));
    return total + (Math.sign(one) * sum) / count;
  }, 0);
}

/**
 * @param {ReturnType<typeof compared>} result
 * @param {string} a
 * @param {string} b
 * @param {string} measure
 * @param {number} tests
 */
function pairSentence({ n, smaller, larger, leaning, tasks, p }, a, b, measure, tests) {
  if (n === 0) return `No pair has a value of both ${a} and ${b}.`;
  const over = tests > 1 ? `, corrected for ${tests} tests` : "";
  const isShown = p <= LEVEL / tests;
  const rounded = Math.round(p * 1e4) / 1e4;
  const worlds = tasks > 1 && tasks < n ? `; it takes the pairs, of ${tasks} worlds, as independent` : "";
  const value = `${rounded > 0 ? `p = ${rounded}` : "p < 0.0001"}${worlds}`;
  const none = `no difference is shown at 5 %${over}`;
  if (!isShare(measure)) {
    const byRanks = leaning * (larger - smaller) > 0 ? "" : ", by the sizes of the differences,";
    const verdict = isShown ? `significantly ${leaning < 0 ? "smaller" : "larger"}${byRanks} at 5 %${over}` : none;
    const equal = n - smaller - larger;
    const counts = [
      `smaller than that of ${b} in ${grouped(smaller)} of ${grouped(n)} pairs that both solved`,
      `larger in ${grouped(larger)}`,
      ...(equal > 0 ? [`equal in ${grouped(equal)}`] : []),
    ].join(", ");
    return `The ${nounOf(measure)} of ${a} is ${counts}: ${verdict} (Wilcoxon\u2019s signed-rank test, ${value}).`;
  }
  const path = measure === SOLVED ? "a path" : "a valid path";
  const test = `${isShown ? `significant at 5 %${over}` : none} (McNemar\u2019s exact test, ${value})`;
  if (larger === smaller)
    return `${a} and ${b} find ${path} equally often, each alone in ${grouped(larger)} of ${grouped(n)} pairs: ${test}.`;
  const [more, less] = larger > smaller ? [a, b] : [b, a];
  const [most, least] = [Math.max(larger, smaller), Math.min(larger, smaller)].map(grouped);
  return isShown
    ? `${more} finds ${path} more often than ${less}, alone in ${most} of ${grouped(n)} pairs, and ${less} alone in ${least}: ${test}.`
    : `${more} alone finds ${path} in ${most} of ${grouped(n)} pairs, ${less} alone in ${least}: ${test}.`;
}

/**
 * All settings against one, in a sentence.
 * @param {Map<string, ReturnType<typeof compared>>} results
 * @param {string} base
 * @param {string} measure
 */
function othersSentence(results, base, measure) {
  const known = [...results].filter(([, { n }]) => n > 0);
  const shown = known.filter(([, { p }]) => p <= LEVEL / results.size);
  const [more, less] = isShare(measure) ? ["more often", "less often"] : ["larger", "smaller"];
  const parts = [
    { word: more, some: shown.filter(([, { leaning }]) => leaning > 0) },
    { word: less, some: shown.filter(([, { leaning }]) => leaning < 0) },
  ]
    .filter(({ some }) => some.length > 0)
    .map(
      ({ word, some }) =>
        `${word}: ${some.length > NAMES ? `${some.length} of them` : some.map(([name]) => name).join(", ")}`,
    );
  if (known.length < 2) return "";
  const others = `${known.length} other settings${known.length < results.size ? " that have pairs" : ""}`;
  return parts.length === 0
    ? `None of the ${others} differs significantly from ${base}.`
    : `Of the ${others}, these differ significantly from ${base}: ${parts.join("; ")}.`;
}
