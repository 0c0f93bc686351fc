/** The row of the export panel that makes films: what is filmed, how wide, and a button for each format. */
import { make, write } from "../app/dom.js";
import { even, makeFilm, whyNoWebm } from "../draw/film.js";
import { downloadRow, failureOf } from "./download-row.js";
import { button, select } from "./elements.js";

/** @import { App } from "../app/app.js" */
/** @import { Film, FilmFormat } from "../draw/film.js" */
/** @import { Progress } from "./progress.js" */

/**
 * @typedef {object} Subject   what can be filmed
 * @property {string} id
 * @property {string} title
 * @property {string} meaning
 * @property {() => string} lack   why there is no film, or empty
 * @property {(width: number, frames: number) => Film} open   `width`: pixels
 * @property {boolean} [isCounted]   is its number of frames chosen?
 * @property {() => boolean} [isOffered]   is there such a thing in the open scene? true where absent
 */

/**
 * @param {App} app
 * @param {Progress} progress
 * @param {{ subjects: Subject[], name: () => string }} films   `name`: begins that of the file
 */
export function filmRow(app, progress, { subjects, name }) {
  const subject = select("export-film", "What is filmed", []);
  const frames = select(
    "export-frames",
    "Frames",
    [
      ["24", "24 frames"],
      ["48", "48 frames"],
      ["96", "96 frames"],
    ],
    "48",
  );
  const width = select(
    "export-width",
    "Width",
    [
      ["480", "480 px"],
      ["800", "800 px"],
    ],
    "800",
  );
  const noWebm = whyNoWebm();
  const row = downloadRow(
    { id: "gif", title: "Film", format: "GIF", meaning: "" },
    () => start("gif"),
    subject,
    frames,
    width,
  );
  const webm = button("export-webm", "WebM", () => start("webm"), { ariaLabel: "Film, WebM", hidden: noWebm !== "" });
  webm.setAttribute("aria-describedby", row.hint.id);
  row.button.after(webm);
  row.element.append(progress.row, progress.result);
  subject.addEventListener("change", reflect);
  reflect();
  return { element: row.element, reflect };

  function offered() {
    return subjects.filter(({ isOffered = () => true }) => isOffered());
  }

  /** The chosen subject. @returns {Subject | undefined} */
  function chosen() {
    const all = offered();
    return all.find(({ id }) => id === subject.value) ?? all[0];
  }

  /** Shows what can be filmed now. */
  function reflect() {
    const all = offered();
    const ids = all.map(({ id }) => id).join();
    if (subject.dataset.ids !== ids) {
      const { value } = subject;
      subject.dataset.ids = ids;
      subject.replaceChildren(...all.map(({ id, title }) => make("option", { value: id }, title)));
      if (all.some(({ id }) => id === value)) subject.value = value;
      subject.hidden = all.length < 2;
    }
    const one = chosen();
    row.element.hidden = !one;
    if (!one) return;
    frames.hidden = !one.isCounted;
    const reason = one.lack();
    row.button.disabled = webm.disabled = reason !== "" || progress.isBusy;
    write(row.hint, [reason || one.meaning, noWebm].filter(Boolean).join(" "));
  }

  /** @param {FilmFormat} format */
  function start(format) {
    const one = chosen();
    if (!one) return;
    const make = (/** @type {(part: number) => boolean} */ onProgress) =>
      makeFilm(format, one.open(even(Number(width.value)), Number(frames.value)), onProgress);
    void app.track(progress.save(`${name()}-${one.id}.${format}`, make), failureOf("Film"));
  }
}
