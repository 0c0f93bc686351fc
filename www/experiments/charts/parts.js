/** What the marks of several charts share: axes with words or numbers, lines of a style, and the number of trials. */
import { isShare } from "../measures.js";
import { wordOf } from "../factors.js";
import { numberText } from "../../widgets/format.js";

/** @import { ChartData, Plot, Scale, Style } from "../charts.js" */
/** @import { Cell } from "../rows.js" */

/** Pixels of a letter, about, and of a digit of the numbers of trials. */
export const LETTER = 6.6;
export const DIGIT = 5.8;
/** Pixels beside the frame. */
export const SIDES = 82;

/** @param {Scale} across */
export function acrossOptions({ title, isLog }) {
  return {
    label: title,
    labelAnchor: /** @type {const} */ ("center"),
    labelArrow: /** @type {const} */ ("none"),
    ...(isLog ? LOG : {}),
  };
}

/** What a logarithmic axis is: values of 0 lie on its edge, and numbers are written out. */
export const LOG = {
  type: /** @type {const} */ ("log"),
  clamp: true,
  tickFormat: /** @type {any} */ ((/** @type {number} */ value) => numberText(value)),
};

/** @param {Scale} up @param {boolean} [isFromZero] */
export function upOptions({ isLog, title }, isFromZero = !isLog) {
  const percent = title.endsWith("%") ? { domain: [0, 100], nice: false, zero: true } : {};
  return {
    label: null,
    grid: true,
    ...(isLog ? LOG : {}),
    zero: isFromZero && !isLog,
    nice: !isLog,
    ...percent,
  };
}

/** Colours are given. */
export const IDENTITY = { type: /** @type {const} */ ("identity") };

/**
 * Ticks at words and values, not more than there is room for; long words are cut.
 * @param {Scale} scale
 * @param {number} width
 */
export function ticksOf({ values, words }, width) {
  const shown = values.filter((value) => value !== null);
  const room = (width - 90) / Math.max(1, shown.length);
  const longest = Math.max(1, ...shown.map((value) => wordOf(value, words).length));
  const isWords = shown.some((value) => typeof value === "string");
  const each = isWords ? 1 : Math.max(1, Math.ceil((Math.min(longest, 6) * LETTER + 8) / room));
  const letters = Math.max(3, Math.floor(room / LETTER));
  const cut = (/** @type {Cell} */ value) => {
    const whole = wordOf(value, words);
    return isWords && whole.length > letters ? `${whole.slice(0, letters - 1)}\u2026` : whole;
  };
  return { ticks: /** @type {any} */ (shown.filter((_, i) => i % each === 0)), tickFormat: /** @type {any} */ (cut) };
}

/** @param {Style} style */
export function strokeOf({ colour, dash }) {
  return { stroke: colour, strokeWidth: 2, ...(dash ? { strokeDasharray: dash } : {}) };
}

/**
 * The number of trials as text, for charts in which it differs; elsewhere the picture says it once.
 * @param {Plot} plot
 * @param {ChartData} chart
 * @param {{ n: number }[]} some
 * @param {object} place  channels and options of the mark
 */
export function countMarks({ text }, { counts }, some, place) {
  return counts.least === counts.most
    ? []
    : [text(some, { text: (/** @type {{ n: number }} */ { n }) => String(n), fontSize: 10, ...place })];
}

/** What an interval of a measure is, in words. @param {string} measure */
export function intervalOf(measure) {
  return isShare(measure) ? "Wilson\u2019s 95 % interval" : "quartiles of trials with a path";
}

/** What a share is, in words. @param {string} measure */
export function shareOf(measure) {
  return measure === "valid" ? "share of paths that the verifier accepts" : "share of trials with a path";
}

export const WHOLE_RUN =
  "Work is the work of the whole run, including the iterations in which a planner such as RRT* or SST improves its path.";

/** A dot is a trial, of which not all are drawn where there are many. @param {ChartData} chart */
export function dotsOf({ points, each }) {
  if (points.length === 0) return "";
  return each > 1 ? ` Each dot is a trial; one in ${each} is drawn.` : " Each dot is a trial.";
}
