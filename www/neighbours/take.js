/** What can be taken away: the stage as a picture or a drawing, the neighbours and the timings as tables. */
import { byId, make } from "../app/dom.js";
import { toCsv } from "../formats/csv.js";
import { drawingOf, pictureOf } from "../room/take.js";
import { save } from "../planner/export/files.js";

/** @import { Sheet } from "../room/sheet.js" */
/** @import { Desk } from "./desk.js" */
/** @import { Timing } from "./timing.js" */

/** Pixels a CSS pixel of a picture. */
const SCALE = 2;

/** @param {Desk} desk @param {Timing} timing @param {Sheet[]} sheets */
export function showTake(desk, timing, sheets) {
  const name = () => `neighbours-${desk.entry.id}-${desk.count}-k${desk.k}`;
  byId("take", HTMLElement).append(
    offer("png", "Picture", "PNG", "The stage as it is now.", async () => save(await pictureOf(sheets, SCALE), `${name()}.png`)),
    offer("svg", "Drawing", "SVG", "Lines that stay sharp at any size.", async () => save(await drawingOf(sheets, desk.entry.title), `${name()}.svg`)),
    offer("csv", "Neighbours", "CSV", "Rank, number, distance and configuration.", async () => save(new Blob([neighboursCsv(desk)], { type: "text/csv" }), `${name()}.csv`)),
    offer("timings", "Timings", "CSV", "What was measured.", async () => save(new Blob([timingsCsv(timing)], { type: "text/csv" }), `timings-${desk.entry.id}.csv`)),
  );

  /** @param {string} id @param {string} title @param {string} format @param {string} meaning @param {() => Promise<void>} give */
  function offer(id, title, format, meaning, give) {
    const button = make("button", { type: "button", id: `take-${id}` }, format);
    const hint = make("span", { className: "hint", id: `take-${id}-hint` }, meaning);
    button.setAttribute("aria-label", `${title}, ${format}`);
    button.setAttribute("aria-describedby", hint.id);
    button.addEventListener("click", () => void desk.room.await(give()));
    return make("div", { className: "offer" }, make("div", { className: "row" }, make("span", { className: "name" }, title, hint), button));
  }
}

/** @param {Desk} desk */
function neighboursCsv({ found: { indices, distances }, coordinates, list, dimension }) {
  return toCsv(["rank", "number", "distance", ...coordinates.map(({ name }) => name)],
    Array.from(indices, (i, rank) => [rank + 1, i, distances[rank], ...list.rows.subarray(i * dimension, (i + 1) * dimension)]));
}

/** @param {Timing} timing */
function timingsCsv({ measured }) {
  return toCsv(["n", "index", "build_seconds", "query_seconds", "visited", "recall"], measured.map(({ n, index, build, query, visited, recall }) => [n, index, build, query, visited, recall]));
}
