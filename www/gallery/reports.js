/** The five reports and all entries, with their numbers in the texts, and what the planners of the reports have in common. */
import { MORE } from "./more.js";
import { REPORT_1 } from "./report-1.js";
import { REPORT_2 } from "./report-2.js";
import { REPORT_3 } from "./report-3.js";
import { REPORT_4 } from "./report-4.js";
import { REPORT_5 } from "./report-5.js";

/** @import { Entry, Report, ReportedEntry, Shows } from "./format.js" */

/** The fields of an entry that may name numbers. */
export const TEXTS = /** @type {const} */ (["see", "try", "report", "why", "chosen"]);
/** The planners of the reports but for those by controls, which have no straight motions. */
const INDIRECT = ["prm", "prm-star", "rrt"];
/** The planners of a race. */
const LETTERS = "ABCD";

/** @type {Report[]} */
export const REPORTS = [REPORT_1, REPORT_2, REPORT_3, REPORT_4, REPORT_5].map((report) => ({
  ...report,
  entries: report.entries.map((entry) => withNumbers(asReported(entry))),
}));
/** All entries. @type {Entry[]} */
export const ENTRIES = [...REPORTS.flatMap(({ entries }) => entries), ...MORE.map(withNumbers)];

/**
 * In the reports no tree and no roadmap tries the straight motion from start to goal first.
 * @param {ReportedEntry} entry
 * @returns {ReportedEntry}
 */
function asReported(entry) {
  if (entry.page !== "planner") return entry;
  const lanes = entry.state.lanes.map((plan) =>
    INDIRECT.includes(plan.algorithm ?? "") ? { ...plan, settings: { direct: false, ...plan.settings } } : plan,
  );
  return { ...entry, state: { ...entry.state, lanes } };
}

/** An entry with its numbers in the place of their names. @template {Entry} E @param {E} entry @returns {E} */
function withNumbers(entry) {
  return Object.assign(
    { ...entry },
    ...TEXTS.map((field) =>
      entry[field] === undefined ? {} : { [field]: filled(entry[field], entry.shows ?? {}, entry.id) },
    ),
  );
}

/**
 * A text with `{visited}`, or of a race `{visited B}`, replaced by the number.
 * @param {string} text
 * @param {Shows} shows
 * @param {string} id
 */
function filled(text, shows, id) {
  return text.replace(/\{(\w+)(?: ([A-D]))?\}/g, (whole, name, letter) => {
    const value = shows[/** @type {keyof Shows} */ (name)];
    const number = letter === undefined ? value : Array.isArray(value) ? value[LETTERS.indexOf(letter)] : undefined;
    if (typeof number !== "number") throw new Error(`Entry ${id} shows no number ${whole}.`);
    return String(number);
  });
}
