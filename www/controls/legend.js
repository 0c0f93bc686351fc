/** The legend names what can be seen just now, and no more. */
import { byId } from "./dom.js";

/** @import { LaneState } from "../types.js" */

/** @param {LaneState[]} lanes */
export function showLegend(lanes) {
  byId("legend-growth", HTMLElement).textContent = [...new Set(lanes.map(({ kind }) => kind))].join(", ");
  byId("legend-guard", HTMLElement).hidden = !lanes.some(({ hasGuards }) => hasGuards);
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
