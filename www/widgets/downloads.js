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
  /** @type {Download[]} */
  const all = [
    { id: "png", title: "Image", format: "PNG", meaning: "The figures as shown.", content: () => pngOf(figures, SCALE) },
    { id: "svg", title: "Vector graphic", format: "SVG", meaning: "The figures as shown, sharp at any size.", content: () => svgOf(figures, names.title()) },
    ...others,
  ];
  byId("take", HTMLElement).append(...all.map(({ id, title, format, meaning, content, name = names.name }) => {
    const hint = make("span", { className: "hint", id: `take-${id}-hint` }, meaning);
    const give = async () => save(await content(), `${name().replace(/[^\w.-]+/g, "-")}.${format.toLowerCase()}`);
    const saveButton = button(`take-${id}`, format, () => void app.track(give()));
    saveButton.setAttribute("aria-label", `${title}, ${format}`);
    saveButton.setAttribute("aria-describedby", hint.id);
    return make("div", { className: "offer" }, make("div", { className: "row" }, make("span", { className: "name" }, title, hint), saveButton));
  }));
}
