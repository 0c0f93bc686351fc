/** The legend names what can be seen just now, and no more. */
import { byId } from "./dom.js";

/** @import { Page } from "../page.js" */
/** @import { LaneState, State } from "../types.js" */

/** @param {Page} page @param {State} state */
export function showLegend({ view, calm }, { growing, lanes }) {
  byId("legend-growth", HTMLElement).textContent = [...new Set(lanes.map(({ kind }) => kind))].join(", ");
  const some = (/** @type {(lane: LaneState) => boolean} */ is) => lanes.some(is);
  // What is refused stays where it is wanted to, and else flashes while it grows.
  const refuses = view.refused || (growing && !calm);
  const seen = {
    guard: some(({ hasGuards }) => hasGuards), waiting: some(({ waiting }) => waiting > 0),
    rejected: refuses && some(({ hasRejected }) => hasRejected), refused: refuses && some(({ hasRefused }) => hasRefused),
    raw: view.raw && some(({ raw }) => raw !== null), poses: view.strobe && some(({ status, isMiss }) => status === "solved" || isMiss),
  };
  for (const [name, isSeen] of Object.entries(seen)) byId(`legend-${name}`, HTMLElement).hidden = !isSeen;
  const path = byId("legend-path", HTMLElement);
  const isProven = lanes.some((lane) => lane.isProven);
  const isMiss = lanes.every((lane) => lane.isMiss);
  path.dataset.proven = String(isProven);
  path.dataset.miss = String(isMiss);
  const also = [
    !isMiss && lanes.some((lane) => lane.isMiss) ? "broken: nearest miss" : "",
    lanes.every((lane) => lane.isProven) ? "" : isProven ? "hollow: not proven" : "not proven",
  ];
  const words = path.querySelector("span");
  if (words) words.textContent = [isMiss ? "nearest miss" : "path", ...also].filter(Boolean).join(", ");
}
