/** Files that are saved. */
import { documentText } from "../formats/document.js";

/** Saves a file. @param {Blob} blob @param {string} name  characters that file names cannot have become hyphens */
export function save(blob, name) {
  const href = URL.createObjectURL(blob);
  Object.assign(document.createElement("a"), { href, download: name.replace(/[^\w.-]+/g, "-") }).click();
  setTimeout(() => URL.revokeObjectURL(href), 60_000);
}

/** Plain data as a JSON file. @param {object} value */
export function json(value) {
  return new Blob([documentText(JSON.parse(JSON.stringify(value)))], { type: "application/json" });
}
