/**
 * The pseudocode of the planner. The lines of the iteration shown are marked, or while it plays those of the last few
 * iterations.
 */
import { byId, make } from "../app/dom.js";
import { pacer } from "../app/paced.js";

/** @import { Page } from "./page.js" */

/** Milliseconds between two changes while it plays. */
const PAUSE = 200;

/** @param {Page} page */
export function showPseudocode(page) {
  const list = make("ol", {});
  const details = make(
    "details",
    { open: matchMedia("(min-width: 64rem)").matches },
    make("summary", {}, "Pseudocode"),
    list,
  );
  byId("pseudocode", HTMLElement).append(details);
  let shown = "";
  const isDue = pacer(PAUSE);
  /** The marks since the last change. @type {Set<string>} */
  const marks = new Set();
  /** @type {{ row: HTMLElement, marks: readonly string[] }[]} */
  let lines = [];

  page.onState(({ lanes: [lane], playing, growing }) => {
    if (lane.algorithm !== shown) {
      shown = lane.algorithm;
      marks.clear();
      lines = (page.planners.find(shown)?.pseudocode ?? []).map(({ text, indent, lit_by }) => {
        const row = make("li", {}, text);
        row.dataset.indent = String(indent);
        return { row, marks: lit_by };
      });
      list.replaceChildren(...lines.map(({ row }) => row));
    }
    const isMoving = playing && growing;
    if (!isMoving) marks.clear();
    for (const mark of lane.marks) marks.add(mark);
    if (!isDue(!isMoving)) return;
    for (const line of lines) line.row.ariaCurrent = line.marks.some((mark) => marks.has(mark)) ? "step" : null;
    marks.clear();
  });
}
