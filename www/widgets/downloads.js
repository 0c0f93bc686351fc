/** The export panel: a row for each file that can be saved. */
import { save } from "../app/files.js";
import { byId, make } from "../app/dom.js";
import { pngOf, svgOf } from "../draw/export.js";
import { button } from "./elements.js";

/** @import { App } from "../app/app.js" */
/** @import { Figure } from "../draw/figure.js" */

/**
 * @typedef {object} Download
 * @property {string} id
 * @property {string} title
 * @property {string} format     also ends the name of the file
 * @property {string} meaning
 * @property {() => Blob | Promise<Blob>} content
 * @property {() => string} [name]   of the file, without its end; that of the page where absent
 */

/** Image pixels a CSS pixel. */
const SCALE = 2;

/** The figures as PNG and SVG, and whatever else a page exports. @param {App} app @param {Figure[]} figures @param {{ name: () => string, title: () => string }} names @param {Download[]} others */
export function showDownloads(app, figures, names, others) {
  showFiles(app, names.name, [
    { id: "png", title: "Image", format: "PNG", meaning: "The figures as shown.", content: () => pngOf(figures, SCALE) },
    { id: "svg", title: "Vector graphic", format: "SVG", meaning: "The figures as shown, sharp at any size.", content: () => svgOf(figures, names.title()) },
    ...others,
  ]);
}

/** @param {App} app @param {() => string} usual  name of a file @param {Download[]} all */
export function showFiles(app, usual, all) {
  byId("export", HTMLElement).append(...all.map((download) => {
    const { title, format, content, name = usual } = download;
    const saveFile = async () => save(await content(), `${name()}.${format.toLowerCase()}`);
    return downloadRow(download, () => void app.track(saveFile(), failureOf(title))).element;
  }));
}

/** The title of the error when a download fails. @param {string} title */
export function failureOf(title) { return `The ${title.toLowerCase()} could not be created.`; }

/** A row of the panel; one choice stands beside the button, several below it. @param {Omit<Download, "content">} download @param {() => void} onSave @param {...HTMLElement} choices */
export function downloadRow({ id, title, format, meaning }, onSave, ...choices) {
  const hint = make("span", { className: "hint", id: `export-${id}-hint` }, meaning);
  const saveButton = button(`export-${id}`, format, onSave, { ariaLabel: `${title}, ${format}` });
  saveButton.setAttribute("aria-describedby", hint.id);
  const [beside, below] = choices.length === 1 ? [choices, []] : [[], choices];
  const row = make("div", { className: "row" }, make("span", { className: "name" }, title, hint), ...beside, saveButton);
  const element = make("div", { className: "offer" }, row, below.length > 0 ? make("div", { className: "parts" }, ...below) : "");
  return { element, hint, button: saveButton };
}
