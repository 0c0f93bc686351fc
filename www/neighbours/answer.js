/** The neighbours as a table, nearest first, and the answer in a sentence. */
import { grouped, write } from "../planner/counters.js";
import { byId, make } from "../app/dom.js";

/** @import { Desk } from "./desk.js" */

/** Rows of the table at most. */
const MOST = 100;

/** @param {number} value */
export function num(value) { return value.toFixed(3).replace("-", "\u2212"); }

/** @param {ArrayLike<number>} q */
export function configurationText(q) { return `(${Array.from(q, num).join(", ")})`; }

export class AnswerTable {
  /** @param {Desk} desk */
  constructor(desk) {
    this.desk = desk;
    this.caption = make("caption", {});
    this.body = make("tbody", {});
    const head = make("tr", {}, ...["Rank", "Number", "Configuration", "Distance"].map((title) => make("th", { scope: "col" }, title)));
    const scroll = make("div", { className: "scroll", tabIndex: 0 }, make("table", { className: "standings", id: "neighbours" }, this.caption, make("thead", {}, head), this.body));
    scroll.setAttribute("role", "region");
    scroll.setAttribute("aria-label", "The neighbours");
    byId("answer", HTMLElement).append(scroll);
    desk.onChange((change) => { if (change === "answer" || change === "robot") this.show(); });
  }

  show() {
    const { desk } = this;
    const { found: { indices, distances }, exact } = desk;
    const shown = Math.min(MOST, indices.length);
    write(this.caption, shown < indices.length ? `The ${shown} nearest of ${indices.length}` : `The ${shown} nearest`);
    this.body.replaceChildren(...Array.from({ length: shown }, (_, rank) => {
      const i = indices[rank];
      const isRight = exact.indices.includes(i);
      const row = make("tr", {}, make("th", { scope: "row" }, String(rank + 1)),
        ...[grouped(i), configurationText(desk.row(i)), `${num(distances[rank])}${isRight ? "" : " \u2717"}`].map((text) => make("td", {}, text)));
      Object.assign(row.dataset, { index: String(i), distance: String(distances[rank]), right: String(isRight) });
      return row;
    }));
  }
}

/** What the answer comes to, in a sentence. @param {Desk} desk */
export function sentenceOf(desk) {
  const { found, exact, index, isNaive, count, missed, k } = desk;
  if (found.indices.length === 0) return "Configurations are being drawn.";
  const asked = Math.min(k, count);
  const wrong = missed.length;
  const some = (/** @type {number} */ n) => (n === 1 ? "1 is" : `${n} are`);
  if (isNaive) {
    return wrong === 0
      ? "The naive metric reads angles as plain numbers. Here it finds the right neighbours all the same: take the target near the cut at 0."
      : `The naive metric reads angles as plain numbers and cuts each circle at 0: of its ${asked} neighbours ${some(wrong)} wrong, and as many near ones beyond the cut are missed.`;
  }
  if (index === "forest") {
    return wrong === 0
      ? `The forest looked at ${grouped(found.visited)} of ${grouped(count)} and found all ${asked}; with more configurations, or fewer candidates, it misses some.`
      : `The forest looked at ${grouped(found.visited)} of ${grouped(count)} and missed ${wrong} of the ${asked} nearest, drawn broken.`;
  }
  if (index === "linear") return `The scan looked at all ${grouped(count)} configurations to find the ${asked} nearest.`;
  const round = desk.isArm && exact.distances.length > 0 ? " Angles go the short way round, so neighbours may lie beyond the border." : "";
  return `The kd-tree looked at ${grouped(found.visited)} of ${grouped(count)} configurations to find the ${asked} nearest.${round}`;
}
