/** The columns and the words of a run's log, as the core numbers them. */
import { eventKinds, historyColumns } from "../../../dist/package/tables.js";

/** The numbers of the kinds of event. */
export const EVENT = numbersOf(eventKinds);

/** The columns of a row of history. */
export const PAST = numbersOf(historyColumns);

/** The root of a vertex: none in a roadmap, or that of the start or the goal. */
export const SIDE = { none: 0, start: 1, goal: 2 };

/**
 * The number of each word of a list.
 * @template {string} W
 * @param {readonly W[]} words
 * @returns {Record<W, number>}
 */
function numbersOf(words) {
  return /** @type {Record<W, number>} */ (Object.fromEntries(words.map((word, i) => [word, i])));
}
