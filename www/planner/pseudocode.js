/**
 * The planner in pseudo-code, as the core tells it: lit are the lines that the iteration shown went through, and while it
 * plays those that the last iterations went through.
 */
import { byId, make } from "../app/dom.js";

/** @import { Page } from "./page.js" */

/** Milliseconds between two changes while it plays: as fast as it can be followed. */
const READABLE = 200;

/** @param {Page} page */
export function showPseudocode(page) {
  const list = make("ol", {});
  const details = make("details", { open: matchMedia("(min-width: 64rem)").matches }, make("summary", {}, "Pseudocode"), list);
  byId("pseudocode", HTMLElement).append(details);
  let shown = "";
  let written = -Infinity;
  /** Since the lines were lit last. @type {Set<string>} */
  const marks = new Set();
  /** @type {{ row: HTMLElement, marks: readonly string[] }[]} */
  let lines = [];

  page.onState(({ lanes: [lane], playing, growing }) => {
    if (lane.algorithm !== shown) {
      shown = lane.algorithm;
      marks.clear();
      lines = (page.panel.infos.find(({ id }) => id === shown)?.pseudocode ?? []).map(({ text, indent, lit_by }) => {
        const row = make("li", {}, text);
        row.dataset.indent = String(indent);
        return { row, marks: lit_by };
      });
      list.replaceChildren(...lines.map(({ row }) => row));
    }
    const moving = playing && growing;
    if (!moving) marks.clear();
    for (const mark of lane.marks) marks.add(mark);
    if (moving && performance.now() - written < READABLE) return;
    written = performance.now();
    for (const line of lines) {
      if (line.marks.some((mark) => marks.has(mark))) line.row.setAttribute("aria-current", "step");
      else line.row.removeAttribute("aria-current");
    }
    marks.clear();
  });
}
