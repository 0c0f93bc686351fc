/**
 * The keys of a drive as a short text: the number of steps since the key before, and its letter on the keyboard, as in
 * "0w50w12a".
 */

/** @import { DriveKey, KeyPress } from "planarium" */

/** @type {Record<DriveKey, string>} */
const LETTERS = { faster: "w", slower: "s", left: "a", right: "d", keep: "c" };

/** What such a text looks like. */
export const KEY_TEXT = /^(\d{1,7}[wsadc])*$/;

/** @param {KeyPress[]} record  in the order of their steps */
export function keyText(record) {
  return record.map(({ step, key }, i) => `${step - (record[i - 1]?.step ?? 0)}${LETTERS[key]}`).join("");
}

/** @param {string} text @returns {KeyPress[]} */
export function keysOf(text) {
  let step = 0;
  return Array.from(text.matchAll(/(\d+)(\D)/g), ([, wait, letter]) => {
    step += Number(wait);
    const [key] = /** @type {[DriveKey, string][]} */ (Object.entries(LETTERS)).find(([, one]) => one === letter) ?? [
      "keep",
    ];
    return { step, key };
  });
}
