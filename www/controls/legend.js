/** The legend names what can be seen just now, and no more. */
import { byId } from "./dom.js";

/** @import { Page } from "../page.js" */
/** @import { State } from "../types.js" */

/** @param {Page} page @param {State} state */
export function showLegend({ view, calm }, { lanes: [lane], growing, lanes }) {
  byId("legend-growth", HTMLElement).textContent = lane.kind;
  // What is refused stays where it is wanted to, and else flashes while it grows.
  const refuses = view.refused || (growing && !calm);
  const isSolved = lanes.some(({ status }) => status === "solved");
  const seen = {
    guard: lane.hasGuards, waiting: lane.waiting > 0, rejected: refuses && lane.hasRejected, refused: refuses && lane.hasRefused,
    raw: view.raw && lane.raw !== null, poses: view.strobe && (isSolved || lane.isMiss),
  };
  for (const [name, isSeen] of Object.entries(seen)) byId(`legend-${name}`, HTMLElement).hidden = !isSeen;
  const path = byId("legend-path", HTMLElement);
  path.dataset.proven = String(lane.isProven);
  path.dataset.miss = String(lane.isMiss);
  const words = path.querySelector("span");
  if (words) words.textContent = `${lane.isMiss ? "nearest miss" : "path"}${lane.isProven ? "" : ", not proven"}`;
}
