/** The legend names what can be seen just now, and no more. */
import { byId } from "./dom.js";

/** @import { LaneState } from "../types.js" */

/** @param {LaneState} lane */
export function showLegend(lane) {
  byId("legend-growth", HTMLElement).textContent = lane.kind;
  byId("legend-guard", HTMLElement).hidden = !lane.hasGuards;
  const path = byId("legend-path", HTMLElement);
  path.dataset.proven = String(lane.isProven);
  path.dataset.miss = String(lane.isMiss);
  const words = path.querySelector("span");
  if (words) words.textContent = `${lane.isMiss ? "nearest miss" : "path"}${lane.isProven ? "" : ", not proven"}`;
}
