/** Files that the page hands over. */
import { documentText } from "../formats/document.js";

/** Saves a file. @param {Blob} blob @param {string} name */
export function save(blob, name) {
  const href = URL.createObjectURL(blob);
  Object.assign(document.createElement("a"), { href, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(href), 60_000);
}

/** Plain data as a JSON file. @param {object} value */
export function json(value) { return new Blob([documentText(JSON.parse(JSON.stringify(value)))], { type: "application/json" }); }
