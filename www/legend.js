/** The legend names what can be seen just now, and no more. */
import { byId } from "./dom.js";

/** @import { Journey } from "./animate.js" */
/** @import { Run } from "./run.js" */

/** @param {Run} run @param {Journey | null} journey */
export function showLegend(run, journey) {
  byId("legend-growth", HTMLElement).textContent = run.kind;
  byId("legend-guard", HTMLElement).hidden = run.guards.count === 0;
  const path = byId("legend-path", HTMLElement);
  const isMiss = journey?.isMiss ?? false;
  path.dataset.proven = String(run.isProven);
  path.dataset.miss = String(isMiss);
  const words = path.querySelector("span");
  if (words) words.textContent = `${isMiss ? "nearest miss" : "path"}${run.isProven ? "" : ", not proven"}`;
}
