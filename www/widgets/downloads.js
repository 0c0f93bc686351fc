/** The export panel: a row for each file that can be saved. */
import { save } from "../app/files.js";
import { byId } from "../app/dom.js";
import { imageOf, rowOf } from "../draw/export.js";
import { downloadRow, failureOf } from "./download-row.js";
import { filmRow } from "./films.js";
import { ImageWords } from "./image-words.js";
import { Progress } from "./progress.js";

/** @import { App } from "../app/app.js" */
/** @import { ImageKind } from "../draw/export.js" */
/** @import { Figure } from "../draw/figure.js" */
/** @import { Subject } from "./films.js" */

/**
 * @typedef {object} Download
 * @property {string} id
 * @property {string} title
 * @property {string} format     also ends the name of the file
 * @property {string} meaning
 * @property {() => Blob | Promise<Blob | null>} content   null where there is none
 * @property {() => string} [name]   of the file, without its end; that of the page where absent
 */

/** Image pixels a CSS pixel. */
const SCALE = 2;

/**
 * The figures as PNG and SVG, films of them, and whatever else a page exports.
 * @param {App} app
 * @param {Figure[]} figures
 * @param {{ name: () => string, title: () => string }} names
 * @param {Download[]} others
 * @param {Subject[]} [subjects]  of films
 */
export function showDownloads(app, figures, names, others, subjects = []) {
  const words = new ImageWords();
  const draw = (/** @type {ImageKind} */ kind) =>
    imageOf(kind, words.addTo(rowOf(figures), names.title()), {
      title: names.title(),
      ratio: SCALE,
      advice: "make the window smaller",
    });
  showFiles(app, names.name, [
    {
      id: "png",
      title: "Image",
      format: "PNG",
      meaning: "The figures as shown.",
      content: () => draw("png"),
    },
    {
      id: "svg",
      title: "Vector graphic",
      format: "SVG",
      meaning: "The figures as shown, sharp at any size.",
      content: () => draw("svg"),
    },
  ]);
  byId("export", HTMLElement).append(words.element);
  if (subjects.length > 0) {
    const progress = new Progress(() => reflect());
    const { element, reflect } = filmRow(app, progress, { subjects, name: names.name });
    byId("export", HTMLElement).append(element);
    app.onDraw(reflect);
  }
  showFiles(app, names.name, others);
}

/** @param {App} app @param {() => string} usual  name of a file @param {Download[]} all */
export function showFiles(app, usual, all) {
  byId("export", HTMLElement).append(
    ...all.map((download) => {
      const { title, format, content, name = usual } = download;
      const saveFile = async () => {
        const blob = await content();
        if (blob) save(blob, `${name()}.${format.toLowerCase()}`);
      };
      return downloadRow(download, () => void app.track(saveFile(), failureOf(title))).element;
    }),
  );
}
