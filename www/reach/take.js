/** What can be taken away: the stage as a picture or a drawing, the scenario to be opened elsewhere. */
import { byId, make } from "../app/dom.js";
import { drawingOf, pictureOf } from "../room/take.js";
import { json, save } from "../planner/export/files.js";
import { targetQuery } from "./plan-link.js";

/** @import { Room } from "../room/room.js" */
/** @import { Sheet } from "../room/sheet.js" */
/** @import { Bench } from "./bench.js" */

/** Pixels a CSS pixel of a picture. */
const SCALE = 2;

/** @param {Room} room @param {Bench} bench @param {Sheet[]} sheets */
export function showTake(room, bench, sheets) {
  const name = () => `${bench.arm.document.name}-reach`.replace(/[^\w.-]+/g, "-");
  byId("take", HTMLElement).append(
    offer("png", "Picture", "PNG", "The stage as it is now.", async () => save(await pictureOf(sheets, SCALE), `${name()}.png`)),
    offer("svg", "Drawing", "SVG", "Lines that stay sharp at any size.", async () => save(await drawingOf(sheets, bench.arm.document.title ?? name()), `${name()}.svg`)),
    offer("scenario", "Scene", "JSON", "The arm and its world; its queries are A to B, and the target.", async () => {
      const { arm, a, b } = bench;
      save(json({ ...arm.document, queries: [{ name: "a-to-b", start: [...a], goal: [...b] }, targetQuery(bench, arm.q)] }), `${name()}.json`);
    }),
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
