/** What can be taken away: the picture, the drawing, and a row for each trajectory. */
import { byId, make } from "../app/dom.js";
import { toCsv } from "../formats/csv.js";
import { drawingOf, pictureOf } from "../room/take.js";
import { save } from "../planner/export/files.js";
import { movingAverage } from "./growth.js";

/** @import { Room } from "../room/room.js" */
/** @import { Sheet } from "../room/sheet.js" */
/** @import { Growth } from "./growth.js" */

/** Pixels a CSS pixel of a picture. */
const SCALE = 2;

const COLUMNS = ["x", "y", "theta", "v", "w", "duration", "tries", "milliseconds", "average"];

/** @param {Room} room @param {Growth} growth @param {Sheet} sheet @param {number} window  of the moving average */
export function showTake(room, growth, sheet, window) {
  const name = () => `trajectories-seed${growth.options.seed ?? 0}-${growth.lines.length}`;
  byId("take", HTMLElement).append(
    offer("png", "Picture", "PNG", "The stage as it is now.", async () => save(await pictureOf([sheet], SCALE), `${name()}.png`)),
    offer("svg", "Drawing", "SVG", "Lines that stay sharp at any size.", async () => save(await drawingOf([sheet], "Trajectories that do not cross"), `${name()}.svg`)),
    offer("csv", "Table", "CSV", `A row for each: its numbers, how many were tried for it, how long that took, and the mean of that over ${window}.`, async () => save(tableOf(growth, window), `${name()}.csv`)),
  );

  /** @param {string} id @param {string} title @param {string} format @param {string} meaning @param {() => Promise<void>} give */
  function offer(id, title, format, meaning, give) {
    const button = make("button", { type: "button", id: `take-${id}` }, format);
    const hint = make("span", { className: "hint", id: `take-${id}-hint` }, meaning);
    button.setAttribute("aria-label", `${title}, ${format}`);
    button.setAttribute("aria-describedby", hint.id);
    button.addEventListener("click", () => void room.await(give()));
    return make("div", { className: "offer" }, make("div", { className: "row" }, make("span", { className: "name" }, title, hint), button));
  }
}

/** @param {Growth} growth @param {number} window */
function tableOf({ rows, tries, milliseconds }, window) {
  const average = new Map(movingAverage(milliseconds, window));
  const cells = tries.map((count, i) => [...rows.slice(6 * i, 6 * i + 6), count, milliseconds[i], average.get(i + 1) ?? null]);
  return new Blob([toCsv(COLUMNS, cells)], { type: "text/csv" });
}
