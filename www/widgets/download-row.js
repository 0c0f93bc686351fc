/** A row of the export panel. */
import { make } from "../app/dom.js";
import { button } from "./elements.js";

/** @typedef {{ id: string, title: string, format: string, meaning: string }} Names */

/** The title of the error when a download fails. @param {string} title */
export function failureOf(title) {
  return `The ${title.toLowerCase()} could not be created.`;
}

/**
 * A row of the panel; one choice stands beside the button, several below it.
 * @param {Names} download
 * @param {() => void} onSave
 * @param {...HTMLElement} choices
 */
export function downloadRow({ id, title, format, meaning }, onSave, ...choices) {
  const hint = make("span", { className: "hint", id: `export-${id}-hint` }, meaning);
  const saveButton = button(`export-${id}`, format, onSave, { ariaLabel: `${title}, ${format}` });
  saveButton.setAttribute("aria-describedby", hint.id);
  const [beside, below] = choices.length === 1 ? [choices, []] : [[], choices];
  const row = make(
    "div",
    { className: "row" },
    make("span", { className: "name" }, title, hint),
    ...beside,
    saveButton,
  );
  const element = make(
    "div",
    { className: "offer" },
    row,
    below.length > 0 ? make("div", { className: "parts" }, ...below) : "",
  );
  return { element, hint, button: saveButton };
}
